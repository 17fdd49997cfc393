//! Whatever an editor asks about any text at any offset has an answer whose places lie in the text. The last two bytes
//! are the offset.
#![no_main]

use std::ops::Range;

use chiaro_assist as assist;
use chiaro_compiler::syntax::{Dialect, FileId, parse};
use chiaro_tests::MemoryWorld;
use libfuzzer_sys::fuzz_target;

fn lies_in(text: &str, range: &Range<usize>) {
    assert!(text.get(range.clone()).is_some(), "{range:?} is not in the text");
}

fn ask_at(text: &str, offset: usize) {
    for range in assist::brackets(text, offset).into_iter().flatten() {
        lies_in(text, &range);
    }
    let completions = assist::complete(text, offset);
    lies_in(text, &completions.replaces);
    assert!(completions.items.iter().all(|item| item.insert.get(item.caret..).is_some()));
    if let Some(hint) = assist::call_hint(text, offset) {
        assert!(hint.active.is_none_or(|range| hint.signature.get(range).is_some()));
    }
    if let Some(hover) = assist::hover(text, offset) {
        lies_in(text, &hover.range);
    }
    if let Some(range) = assist::definition(text, offset) {
        lies_in(text, &range);
    }
    assist::references(text, offset).iter().for_each(|range| lies_in(text, range));
    if let Some(edits) = assist::rename(text, offset, "an_unheard_of_name") {
        assist::apply(text, &edits);
    }
    assist::definition_in(&MemoryWorld::of("a", text), "a", text, offset);
    for argument in assist::literals_of_call(text, offset..offset).into_iter().flatten() {
        lies_in(text, &argument.range);
    }
}

fn ask_whole(text: &str) {
    assist::highlight(text).iter().for_each(|highlight| lies_in(text, &highlight.range));
    for number in assist::numbers(text) {
        lies_in(text, &number.range);
        assist::scrub(&text[number.range], 3.0);
    }
    for parameter in assist::parameters(text).iter().flat_map(|group| &group.parameters) {
        lies_in(text, &parameter.range);
        let edit = assist::set_parameter(text, &parameter.name, &parameter.value).expect("a parameter can be set");
        assert_eq!(assist::apply(text, &[edit]), text);
    }
    for diagnostic in parse(FileId(0), text, Dialect::Dump).1 {
        for fix in assist::quick_fixes(&diagnostic, FileId(0), text) {
            assist::apply(text, &fix.edits);
        }
    }
}

fuzz_target!(|bytes: &[u8]| {
    let Some((text, offset)) = bytes.split_last_chunk::<2>() else { return };
    let text = String::from_utf8_lossy(text);
    ask_whole(&text);
    ask_at(&text, usize::from(u16::from_le_bytes(*offset)) % (text.len() + 2));
});
