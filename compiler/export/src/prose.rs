//! What a scene says in words, as exported code may repeat it.

use std::fmt;

use serde::Serialize;

/// A text of a scene that no language takes for anything but words, so that a template can put it into a comment or between
/// double quotes as it is. All texts of a scene reach templates as prose, or as names in [`snake_case`](crate::snake_case).
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(transparent)]
pub struct Prose(String);

impl Prose {
    /// A text in one line, without signs that end comments, strings or elements, that begin instructions, or that can't be seen.
    ///
    /// Letters, digits and most signs stay. Quotes become apostrophes, backslashes become slashes, and a space parts signs that
    /// mean something together: `* /`, `< script>`, `$ {`, `# include`, `@ group`.
    pub fn new(text: &str) -> Self {
        let mut prose = String::with_capacity(text.len());
        for c in text.chars().filter(|c| !is_invisible(*c)).map(plain) {
            match c {
                ' ' if prose.is_empty() || prose.ends_with(' ') => {}
                _ => {
                    if means_something_behind(&prose, c) {
                        prose.push(' ');
                    }
                    prose.push(c);
                }
            }
        }
        prose.truncate(prose.trim_end().len());
        Self(prose)
    }

    /// A title, which may be part of a path too: letters, digits, and a few signs that paths don't know.
    pub(crate) fn title(text: &str) -> Self {
        Self(text.chars().map(|c| if c.is_alphanumeric() || " -_.,()+".contains(c) { c } else { '_' }).collect())
    }

    /// The text.
    pub fn as_str(&self) -> &str {
        &self.0
    }
}

impl fmt::Display for Prose {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// What stands for a character. All that some language calls white space, a line's end among it, is a space.
fn plain(c: char) -> char {
    match c {
        '"' | '`' => '\'',
        '\\' => '/',
        _ if c.is_control() || c.is_whitespace() || is_noncharacter(c) => ' ',
        _ => c,
    }
}

/// Whether a character only changes how others are shown: their direction, above all. Joiners, which scripts and emoji need, stay.
fn is_invisible(c: char) -> bool {
    matches!(c, '\u{ad}' | '\u{61c}' | '\u{180e}' | '\u{200b}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}')
        || matches!(c, '\u{2060}'..='\u{206f}' | '\u{feff}' | '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e0fff}')
}

/// Whether Unicode keeps a code point from texts, as XML does.
fn is_noncharacter(c: char) -> bool {
    matches!(c, '\u{fdd0}'..='\u{fdef}') || u32::from(c) & 0xfffe == 0xfffe
}

/// Whether a character would mean something to some language right behind a text.
fn means_something_behind(text: &str, c: char) -> bool {
    let is_sign = |c: char| "/*<>#@${}".contains(c);
    match (text.chars().next_back(), c) {
        (None, _) | (_, ' ') => false,
        // Addresses of pages stay.
        (Some('/'), '/') => !text.ends_with(":/"),
        (Some(before), _) if is_sign(before) && is_sign(c) => true,
        // Less than a number, or as much as it.
        (Some('<'), _) => !(c.is_ascii_digit() || c == '=' || c == '-'),
        (Some('#' | '@'), _) => c.is_alphabetic() || c == '_',
        (Some('-'), '>') => text.ends_with("--"),
        (Some(']'), '>') => text.ends_with("]]"),
        // In C, `??/` is a backslash.
        (Some('?'), '/' | '>') => true,
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn prose(text: &str) -> String {
        Prose::new(text).to_string()
    }

    #[test]
    fn ordinary_texts_stay() {
        let ordinary = [
            "How wide it is, in mm/s (not the wall's thickness): 2*x + 3 <= 5 -> 50 %",
            "See https://example.org/a-b_c?d=1 & e; a #5 screw; $t; {a, b}; [0:5]",
            "Größe der Öffnung, 直径 ≥ 3 mm, 👩‍🔧",
        ];
        for text in ordinary {
            assert_eq!(prose(text), text);
        }
    }

    #[test]
    fn a_text_is_one_line() {
        for c in ['\n', '\r', '\t', '\u{b}', '\u{c}', '\u{0}', '\u{1b}', '\u{85}', '\u{2028}', '\u{2029}', '\u{ffff}'] {
            assert_eq!(prose(&format!(" a{c}{c}b{c}")), "a b", "{c:?}");
        }
        assert_eq!(prose("a\u{202e}b\u{feff}c\u{2066}"), "abc");
    }

    #[test]
    fn signs_that_mean_something_are_parted() {
        let cases = [
            ("a */ b /* c", "a * / b / * c"),
            ("</script><script>", "< /script> < script>"),
            ("<!-- x --> ]]>", "< !-- x -- > ]] >"),
            (r#"say "no" \"#, "say 'no' /"),
            ("`${x}` #{y} {{ z }}", "'$ {x}' # {y} { { z } }"),
            ("@group(0) #include <a>", "@ group(0) # include < a>"),
            ("why??/ // @0", "why?? / / / @0"),
            (r"*\", "* /"),
        ];
        for (text, expected) in cases {
            assert_eq!(prose(text), expected);
        }
    }

    #[test]
    fn prose_is_prose() {
        let signs: Vec<char> = (' '..='~').collect();
        for a in &signs {
            for b in &signs {
                for c in ['/', '>', 'x', '{', '-'] {
                    let once = prose(&format!("{a}{b}{c}"));
                    assert_eq!(prose(&once), once);
                }
            }
        }
    }
}
