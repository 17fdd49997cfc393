//! Every function is total: any text and any offset, with answers that lie in the text.

use std::ops::Range;

use proptest::prelude::*;

use crate::testing::{Files, WORDS, scenes};
use crate::*;

/// Asks everything about a text at an offset.
fn ask(text: &str, offset: usize) {
    let lies_inside = |range: Range<usize>, what: &str| {
        assert!(text.get(range.clone()).is_some(), "{what}: {range:?} of {text:?} at {offset}");
    };
    if let Some(pair) = brackets(text, offset) {
        pair.into_iter().for_each(|range| lies_inside(range, "a bracket"));
    }
    let completions = complete(text, offset);
    lies_inside(completions.replaces, "what a completion replaces");
    for item in &completions.items {
        assert!(item.insert.get(item.caret..).is_some(), "the caret in {}", item.insert);
    }
    if let Some(hint) = call_hint(text, offset) {
        assert!(hint.active.is_none_or(|range| hint.signature.get(range).is_some()));
    }
    if let Some(edits) = rename(text, offset, "an_unheard_of_name") {
        let renamed = apply(text, &edits);
        assert_eq!(tokens(&renamed).len(), tokens(text).len(), "renaming at {offset} of {text:?}");
    }
    if let Some(hover) = hover(text, offset) {
        lies_inside(hover.range, "what is hovered over");
        assert!(!hover.title.is_empty());
    }
    if let Some(range) = definition(text, offset) {
        lies_inside(range.clone(), "a definition");
        let references = references(text, offset);
        assert!(references.contains(&range), "a definition is a reference, at {offset} of {text:?}");
        references.into_iter().for_each(|range| lies_inside(range, "a reference"));
    }
    definition_in(&Files::new(&[("a", text)]), "a", text, offset);
    if let Some(arguments) = literals_of_call(text, offset..offset) {
        arguments.into_iter().for_each(|argument| lies_inside(argument.range, "an argument"));
    }
}

/// Asks everything about a text that needs no offset.
fn ask_whole(text: &str) {
    let (_, diagnostics) = chiaro_syntax::parse(chiaro_syntax::FileId(0), text, Dialect::Dump);
    let mut end = 0;
    for highlight in highlight(text) {
        assert!(text.get(highlight.range.clone()).is_some(), "{highlight:?} of {text:?}");
        assert!(highlight.range.start >= end, "highlights are in order, {highlight:?} of {text:?}");
        end = highlight.range.end;
    }
    for number in numbers(text) {
        let literal = &text[number.range.clone()];
        assert_eq!(literal.starts_with('-'), number.negative, "{literal}");
        for steps in [-1.0, 0.0, 0.3, 7.0] {
            let scrubbed = scrub(literal, steps);
            assert_ne!(scrubbed, "-0");
            let changed = apply(text, &[Edit { range: number.range.clone(), text: scrubbed }]);
            // Where words stand that can't, a number may grow together with them.
            let is_broken = !diagnostics.is_empty();
            assert!(is_broken || numbers(&changed).len() == numbers(text).len(), "{literal} by {steps} in {text:?}");
        }
    }
    for parameter in parameters(text).into_iter().flat_map(|group| group.parameters) {
        assert_eq!(text[parameter.range.clone()], parameter.value);
        let edit = set_parameter(text, &parameter.name, &parameter.value).expect("a parameter can be set");
        assert_eq!(apply(text, &[edit]), text);
    }
    for diagnostic in &diagnostics {
        for fix in quick_fixes(diagnostic, chiaro_syntax::FileId(0), text) {
            assert_ne!(apply(text, &fix.edits), text, "{}", fix.title);
        }
    }
}

#[test]
fn scenes_that_break_off_anywhere_are_understood() {
    for (_, text) in scenes().into_iter().filter(|(_, text)| text.len() < 4_000) {
        ask_whole(&text);
        let places = (0..=text.len()).step_by(97).filter(|place| text.is_char_boundary(*place));
        for place in places {
            ask(&text, place);
            ask(&text[..place], place);
        }
    }
}

/// The parser bounds how deep a tree is; what is deeper must not overflow a stack, nor take long.
#[test]
fn what_is_deep_or_unbalanced_is_understood() {
    let repeated = [
        "(",
        "[",
        "{",
        ")",
        "]",
        "}",
        "-",
        "f(",
        "a[",
        "[for (i = 1) ",
        "let (a = 1) ",
        "function (x) ",
        "2^",
        "a?",
        "a?1:",
        "translate([1, 0]) ",
        "if (a) b(); else ",
        "module m() ",
        "m() {",
        "([",
        "{(]",
        "cube(1);\n",
        "\"",
        "/*",
        "// c\n",
    ];
    for word in repeated {
        let text = word.repeat(20_000);
        let middle = words::boundary(&text, text.len() / 2);
        ask(&text, middle);
        highlight(&text);
        format(&text);
    }
}

proptest! {
    #[test]
    fn any_text_is_understood(text in any::<String>(), offset in 0..200_usize) {
        ask_whole(&text);
        ask(&text, offset);
    }

    #[test]
    fn any_words_are_understood(
        words in prop::collection::vec(prop::sample::select(WORDS), 0..40),
        blank: bool,
        offset in 0..300_usize,
    ) {
        let text = words.join(if blank { " " } else { "" });
        ask_whole(&text);
        ask(&text, offset);
    }
}
