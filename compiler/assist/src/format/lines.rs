//! Lines: how deep they are indented, and where the comments behind them stand.

use chiaro_syntax::{Token, TokenKind};

use super::roles::{Role, roles};
use super::spacing::{Word, is_spaced};
use crate::tokens;
use crate::words::{Position, bracket};

mod indentation;

use indentation::Indentation;

/// The spaces of one level.
const INDENT: &str = "    ";
/// The most levels that are shown, which bounds the length of texts that are very deep.
const MOST_LEVELS: usize = 16;

/// A line of the formatted text.
struct Line {
    /// Whether a blank line stands above.
    is_apart: bool,
    indentation: usize,
    code: String,
    comment: Option<Trailing>,
}

/// A comment behind code.
struct Trailing {
    text: String,
    /// In which column it stood, in characters.
    column: usize,
    /// How many characters stood between the code and it.
    gap: usize,
}

impl Line {
    /// How many characters the code takes, the indentation included. Of a line that has breaks in its texts or comments,
    /// the last part counts.
    fn width(&self) -> usize {
        match self.code.rsplit_once('\n') {
            Some((_, last)) => last.chars().count(),
            None => INDENT.len() * self.indentation + self.code.chars().count(),
        }
    }
}

/// The text with its lines indented and its words spaced.
pub(super) fn formatted(text: &str) -> String {
    let tokens = tokens(text);
    let Some(last) = tokens.last() else { return text.to_owned() };
    let end = last.range().end;
    // The text behind its end, if it has one before its last character, stays as it is.
    let rest = text[end..].find('\x03').map(|at| &text[end + at..]);
    let line_break = line_break(text, &tokens);
    let mut lines = lines(text, &tokens);
    let columns = columns(&lines);
    let mut formatted = String::with_capacity(text.len());
    for (line, column) in lines.iter_mut().zip(columns) {
        if line.is_apart {
            formatted.push_str(line_break);
        }
        formatted.push_str(&INDENT.repeat(line.indentation));
        formatted.push_str(&line.code);
        if let Some(comment) = &line.comment {
            formatted.push_str(&" ".repeat(column.saturating_sub(line.width())));
            formatted.push_str(&comment.text);
        }
        formatted.push_str(line_break);
    }
    if last.kind == TokenKind::UnclosedComment {
        // A break behind it would be part of it.
        formatted.truncate(formatted.len() - line_break.len());
    }
    formatted + rest.unwrap_or("")
}

/// The line break that the text's first one is, where it is no part of a token.
fn line_break(text: &str, tokens: &[Token]) -> &'static str {
    let begins = std::iter::once(0).chain(tokens.iter().map(|token| token.range().end));
    let ends = tokens.iter().map(|token| token.range().start).chain([text.len()]);
    let mut breaks = begins.zip(ends).filter_map(|(begin, end)| Some((begin, text[begin..end].find('\n')?)));
    let first = breaks.next().map(|(begin, at)| begin + at);
    if first.is_some_and(|at| text[..at].ends_with('\r')) { "\r\n" } else { "\n" }
}

/// The lines, broken as the text is.
fn lines(text: &str, tokens: &[Token]) -> Vec<Line> {
    let words = words(text, tokens);
    let mut indentation = Indentation::default();
    let mut position = Position::default();
    let mut lines: Vec<Line> = Vec::new();
    for (at, word) in words.iter().enumerate() {
        let token = word.token;
        let previous = at.checked_sub(1).map(|before| words[before]);
        let gap = &text[previous.map_or(0, |previous| previous.token.range().end)..token.range().start];
        let breaks = breaks(gap).max(usize::from(previous.is_some_and(|previous| ends_line(previous.token.kind))));
        let code = &text[token.range()];
        match (lines.last_mut(), previous) {
            (Some(line), Some(previous)) if breaks == 0 => {
                if token.kind == TokenKind::LineComment {
                    let column = column(text, token.range().start);
                    line.comment = Some(Trailing { text: code.to_owned(), column, gap: gap.chars().count().max(1) });
                } else {
                    if is_spaced(text, previous, *word, !gap.is_empty()) {
                        line.code.push(' ');
                    }
                    line.code.push_str(code);
                }
            }
            _ => {
                let opens = previous.and_then(|previous| bracket(previous.token.kind)).is_some_and(|(_, opens)| opens);
                let closes = bracket(token.kind).is_some_and(|(_, opens)| !opens);
                let is_apart = breaks > 1 && previous.is_some() && !opens && !closes;
                let depth = indentation.of_line(token.kind, column(text, token.range().start), position.is_statement());
                let code = code.to_owned();
                lines.push(Line { is_apart, indentation: depth.min(MOST_LEVELS), code, comment: None });
            }
        }
        if !token.kind.is_comment() {
            indentation.see(token.kind, position.is_statement());
            position.see(token.kind);
        }
    }
    lines
}

/// All tokens with their roles.
fn words(text: &str, tokens: &[Token]) -> Vec<Word> {
    let grammar: Vec<Token> = tokens.iter().copied().filter(|token| !token.kind.is_comment()).collect();
    let mut roles = roles(text, &grammar).into_iter();
    let role = |token: &Token| if token.kind.is_comment() { Role::Plain } else { roles.next().unwrap_or(Role::Plain) };
    let roles: Vec<Role> = tokens.iter().map(role).collect();
    tokens.iter().zip(roles).map(|(token, role)| Word { token: *token, role }).collect()
}

/// How many line breaks there are in white space.
fn breaks(gap: &str) -> usize {
    let single = gap.matches('\r').count() - gap.matches("\r\n").count();
    gap.matches('\n').count() + single
}

/// Whether nothing can stand behind a token on its line.
fn ends_line(kind: TokenKind) -> bool {
    matches!(kind, TokenKind::LineComment | TokenKind::UnclosedString | TokenKind::UnclosedPath)
}

/// How many characters stand before a place on its line; a tab counts as those of one level.
fn column(text: &str, place: usize) -> usize {
    let begin = text[..place].rfind(['\n', '\r']).map_or(0, |at| at + 1);
    text[begin..place].chars().map(|character| if character == '\t' { INDENT.len() } else { 1 }).sum()
}

/// Where the comment of each line is to stand: comments of neighbouring lines that stood in one column stay in one.
fn columns(lines: &[Line]) -> Vec<usize> {
    let stands_with = |a: &Line, b: &Line| match (&a.comment, &b.comment) {
        (Some(a), Some(other)) => !b.is_apart && a.column == other.column,
        _ => false,
    };
    let groups = lines.chunk_by(stands_with);
    let column = |group: &[Line]| {
        let width = group.iter().map(Line::width).max().unwrap_or(0);
        let gap = group.iter().filter_map(|line| line.comment.as_ref()).map(|comment| comment.gap).min();
        width + gap.unwrap_or(1)
    };
    groups.flat_map(|group| std::iter::repeat_n(column(group), group.len())).collect()
}
