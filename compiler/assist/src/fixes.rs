//! Quick fixes: what a diagnostic suggests, as edits.

use chiaro_syntax::{Diagnostic, FileId, Suggestion};

use crate::edit::Edit;

/// A way to mend something.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fix {
    /// What it does, for a menu.
    pub title: String,
    /// The edits that do it, all of them in the file asked about.
    pub edits: Vec<Edit>,
}

/// The ways that a diagnostic suggests to mend the file `file`, whose text is `text`.
pub fn quick_fixes(diagnostic: &Diagnostic, file: FileId, text: &str) -> Vec<Fix> {
    let here = diagnostic.suggestion.as_deref().filter(|suggestion| suggestion.span.file == file);
    here.and_then(|suggestion| fix(suggestion, text)).into_iter().collect()
}

fn fix(suggestion: &Suggestion, text: &str) -> Option<Fix> {
    let range = suggestion.span.range();
    let before = text.get(range.clone())?;
    let after = suggestion.text.trim();
    let title = match (before.trim(), after) {
        ("", after) => format!("Insert `{after}`"),
        (before, "") => format!("Remove `{before}`"),
        (before, after) => format!("Replace `{before}` by `{after}`"),
    };
    Some(Fix { title, edits: vec![Edit { range, text: suggestion.text.clone() }] })
}

#[cfg(test)]
mod tests {
    use chiaro_eval::{Options, evaluate};
    use chiaro_syntax::{SourceFile, Sources};

    use super::*;
    use crate::edit::apply;
    use crate::testing::Files;

    /// The titles of all fixes, and the text with the first fix of each diagnostic made.
    fn mended(text: &str) -> (Vec<String>, String) {
        let mut sources = Sources::default();
        let file = sources.add(SourceFile::new("test.scad", text));
        let diagnostics = evaluate(&Files::new(&[]), &mut sources, file, &Options::default()).diagnostics;
        let fixes: Vec<_> = diagnostics.iter().flat_map(|diagnostic| quick_fixes(diagnostic, file, text)).collect();
        let edits: Vec<_> = fixes.iter().flat_map(|fix| fix.edits.clone()).collect();
        (fixes.into_iter().map(|fix| fix.title).collect(), apply(text, &edits))
    }

    #[track_caller]
    fn check(text: &str, title: &str, expected: &str) {
        let (titles, mended) = mended(text);
        assert_eq!((titles.as_slice(), &*mended), (&[title.to_owned()][..], expected), "{text}");
    }

    #[test]
    fn mistyped_names_are_replaced() {
        check("spere(2);", "Replace `spere` by `sphere`", "sphere(2);");
        check("width = 2; cube(widht);", "Replace `widht` by `width`", "width = 2; cube(width);");
        check("x = sqr(4); cube(x);", "Replace `sqr` by `sqrt`", "x = sqrt(4); cube(x);");
        check("move([1, 0, 0]) cube(1);", "Replace `move` by `translate`", "translate([1, 0, 0]) cube(1);");
        check("sphere(radius = 2);", "Replace `radius` by `r`", "sphere(r = 2);");
        check("color(\"tomatto\") cube(1);", "Replace `\"tomatto\"` by `\"tomato\"`", "color(\"tomato\") cube(1);");
    }

    #[test]
    fn what_is_missing_is_inserted() {
        check("a = 1\ncube(a);", "Insert `;`", "a = 1;\ncube(a);");
        check("cube(1)\n", "Insert `;`", "cube(1);\n");
        check("cube([1, 2, 3);", "Insert `]`", "cube([1, 2, 3]);");
        check("cube(1;", "Insert `)`", "cube(1);");
        check("union() { cube(1);", "Insert `}`", "union() { cube(1);\n}");
        check("cube([1 2, 3]);", "Insert `,`", "cube([1, 2, 3]);");
    }

    #[test]
    fn signs_from_elsewhere_are_replaced() {
        check("cube(3 − 1);", "Replace `−` by `-`", "cube(3 - 1);");
    }

    #[test]
    fn fixes_of_other_files_are_left_out() {
        let span = chiaro_syntax::Span::new(FileId(1), 0..1);
        let diagnostic = Diagnostic::error(span, "wrong").with_suggestion(span, "x");
        assert_eq!(quick_fixes(&diagnostic, FileId(0), "abc"), []);
    }
}
