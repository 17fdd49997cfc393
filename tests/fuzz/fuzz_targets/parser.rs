//! Any text has a syntax tree, whose print parses to the same print.
#![no_main]

use chiaro_compiler::syntax::{Dialect, FileId, parse, print};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    for dialect in [Dialect::Program, Dialect::Dump] {
        let (tree, diagnostics) = parse(FileId(0), text, dialect);
        for span in diagnostics.iter().filter_map(|diagnostic| diagnostic.span) {
            assert!(text.get(span.range()).is_some(), "{span:?} is not in the text");
        }
        if diagnostics.is_empty() {
            let printed = print(&tree);
            let (again, _) = parse(FileId(0), &printed, Dialect::Program);
            assert_eq!(printed, print(&again));
        }
    }
});
