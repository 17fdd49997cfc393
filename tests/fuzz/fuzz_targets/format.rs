//! Formatting any text keeps its tokens, and formatting once more changes nothing.
#![no_main]

use chiaro_compiler::syntax::{Dialect, tokens};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    let words = |text: &str| -> Vec<String> {
        tokens(text, Dialect::Dump).iter().map(|token| text[token.range()].to_owned()).collect()
    };
    let formatted = chiaro_assist::format(text);
    assert_eq!(words(text), words(&formatted));
    assert_eq!(chiaro_assist::format(&formatted), formatted, "the second time");
});
