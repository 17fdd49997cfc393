//! Lines of WGSL in colours.

use egui::text::{LayoutJob, TextFormat};
use egui::{Color32, TextStyle, Ui};

const KEYWORDS: [&str; 20] = [
    "fn",
    "let",
    "var",
    "const",
    "struct",
    "return",
    "if",
    "else",
    "for",
    "loop",
    "while",
    "break",
    "continue",
    "switch",
    "case",
    "default",
    "continuing",
    "true",
    "false",
    "select",
];

/// What a word of a line is.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Keyword,
    Type,
    Number,
    Comment,
    Other,
}

/// A line laid out in colours.
pub(super) fn line(ui: &Ui, line: &str) -> LayoutJob {
    let font = TextStyle::Monospace.resolve(ui.style());
    let mut job = LayoutJob::default();
    for (word, kind) in words(line) {
        job.append(word, 0.0, TextFormat::simple(font.clone(), color(kind, ui.visuals().dark_mode)));
    }
    job
}

fn color(kind: Kind, is_dark: bool) -> Color32 {
    let [dark, light] = match kind {
        Kind::Keyword => [[200, 146, 234], [138, 47, 176]],
        Kind::Type => [[111, 203, 214], [11, 104, 118]],
        Kind::Number => [[242, 158, 116], [176, 56, 24]],
        Kind::Comment => [[128, 138, 154], [102, 110, 120]],
        Kind::Other => [[214, 217, 223], [36, 41, 47]],
    };
    let [red, green, blue] = if is_dark { dark } else { light };
    Color32::from_rgb(red, green, blue)
}

/// The words of a line and what is between them.
fn words(line: &str) -> impl Iterator<Item = (&str, Kind)> {
    let mut rest = line;
    std::iter::from_fn(move || {
        let first = rest.chars().next()?;
        let is_of_word = |letter: char| letter.is_alphanumeric() || matches!(letter, '_' | '.');
        let (length, kind) = if rest.starts_with("//") {
            (rest.len(), Kind::Comment)
        } else if is_of_word(first) {
            let length = rest.find(|letter| !is_of_word(letter)).unwrap_or(rest.len());
            (length, kind(&rest[..length]))
        } else {
            let end = |(at, letter): (usize, char)| (is_of_word(letter) || rest[at..].starts_with("//")).then_some(at);
            (rest.char_indices().find_map(end).unwrap_or(rest.len()), Kind::Other)
        };
        let (word, after) = rest.split_at(length);
        rest = after;
        Some((word, kind))
    })
}

fn kind(word: &str) -> Kind {
    let is_type =
        ["f32", "u32", "i32", "bool", "array"].contains(&word) || word.starts_with("vec") || word.starts_with("mat");
    match word {
        _ if KEYWORDS.contains(&word) => Kind::Keyword,
        _ if is_type => Kind::Type,
        _ if word.starts_with(|letter: char| letter.is_ascii_digit()) => Kind::Number,
        _ => Kind::Other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_told_apart() {
        let found: Vec<_> = words("let d = f(2.5, p); // é").filter(|(_, kind)| *kind != Kind::Other).collect();
        assert_eq!(found, [("let", Kind::Keyword), ("2.5", Kind::Number), ("// é", Kind::Comment)]);
        assert_eq!(words("var a: vec3<f32>;").map(|(word, _)| word).collect::<String>(), "var a: vec3<f32>;");
    }
}
