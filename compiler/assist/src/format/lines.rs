//! Lines: how deep they are indented, and where the comments behind them stand.

use chiaro_syntax::{Token, TokenKind};

use super::roles::{Role, roles};
use super::spacing::{Word, is_spaced};
use crate::tokens;
use crate::words::{Position, bracket};

mod indentation;

use indentation::{Column, Indentation};

/// How many spaces one level is.
const LEVEL: usize = 4;

/// A line of the formatted text.
struct Line {
    /// Whether a blank line stands above.
    is_apart: bool,
    /// How many spaces stand in front.
    indentation: usize,
    code: String,
    /// How many characters the line has, indentation included but no comment behind. Where there are breaks in its texts
    /// or comments, the last part counts.
    width: usize,
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
    fn push(&mut self, code: &str) {
        self.code.push_str(code);
        self.width = column_behind(self.width, code);
    }
}

/// The column behind a text that begins in a column. A tab counts as the spaces of one level.
fn column_behind(column: usize, text: &str) -> usize {
    text.chars().fold(column, |column, character| match character {
        '\n' | '\r' => 0,
        '\t' => column + LEVEL,
        _ => column + 1,
    })
}

/// The text with its lines indented and its words spaced.
pub(super) fn formatted(text: &str) -> String {
    let tokens = tokens(text);
    let Some(last) = tokens.last() else { return text.to_owned() };
    let end = last.range().end;
    // The text behind its end, if it has one before its last character, stays as it is.
    let rest = text[end..].find('\x03').map(|at| &text[end + at..]);
    let line_break = line_break(text, &tokens);
    let lines = lines(text, &tokens);
    let columns = columns(&lines);
    let mut formatted = String::with_capacity(text.len());
    for (line, column) in lines.iter().zip(columns) {
        if line.is_apart {
            formatted.push_str(line_break);
        }
        formatted.push_str(&" ".repeat(line.indentation));
        formatted.push_str(&line.code);
        if let Some(comment) = &line.comment {
            formatted.push_str(&" ".repeat(column.saturating_sub(line.width)));
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
    let mut before = Before { place: 0, column: 0 };
    let mut lines: Vec<Line> = Vec::new();
    for (at, word) in words.iter().enumerate() {
        let token = word.token;
        let previous = at.checked_sub(1).map(|before| words[before]);
        let gap = &text[previous.map_or(0, |previous| previous.token.range().end)..token.range().start];
        let breaks = breaks(gap).max(usize::from(previous.is_some_and(|previous| ends_line(previous.token.kind))));
        let code = &text[token.range()];
        let column = before.column(text, token.range().start);
        match (lines.last_mut(), previous) {
            (Some(line), Some(_)) if breaks == 0 && token.kind == TokenKind::LineComment => {
                line.comment = Some(Trailing { text: code.to_owned(), column, gap: gap.chars().count().max(1) });
            }
            (Some(line), Some(previous)) if breaks == 0 => {
                if is_spaced(text, previous, *word, !gap.is_empty()) {
                    line.push(" ");
                }
                let to = line.width;
                line.push(code);
                indentation.see(token.kind, position.is_statement(), Column { from: column, to });
            }
            _ => {
                let to = indentation.of_line(token.kind, column, position.is_statement());
                let is_apart = breaks > 1 && previous.is_some_and(|previous| !is_edge(previous, *word));
                let mut line = Line { is_apart, indentation: to, code: String::new(), width: to, comment: None };
                line.push(code);
                lines.push(line);
                indentation.see(token.kind, position.is_statement(), Column { from: column, to });
            }
        }
        if !token.kind.is_comment() {
            position.see(token.kind);
        }
    }
    lines
}

/// Whether two tokens are the beginning or the end of what stands in brackets, where no blank line is.
fn is_edge(previous: Word, word: Word) -> bool {
    let opens = bracket(previous.token.kind).is_some_and(|(_, opens)| opens);
    let closes = bracket(word.token.kind).is_some_and(|(_, opens)| !opens);
    opens || closes
}

/// How many characters stand before a place on its line.
struct Before {
    place: usize,
    column: usize,
}

impl Before {
    /// The column of a place. Asked for ever later places, it walks along the text once.
    fn column(&mut self, text: &str, place: usize) -> usize {
        self.column = column_behind(self.column, &text[self.place..place]);
        self.place = place;
        self.column
    }
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

/// Where the comment of each line is to stand: comments of neighbouring lines that stood in one column stay in one.
fn columns(lines: &[Line]) -> Vec<usize> {
    let stands_with = |a: &Line, b: &Line| match (&a.comment, &b.comment) {
        (Some(a), Some(other)) => !b.is_apart && a.column == other.column,
        _ => false,
    };
    let groups = lines.chunk_by(stands_with);
    let column = |group: &[Line]| {
        let width = group.iter().map(|line| line.width).max().unwrap_or(0);
        let gap = group.iter().filter_map(|line| line.comment.as_ref()).map(|comment| comment.gap).min();
        width + gap.unwrap_or(1)
    };
    groups.flat_map(|group| std::iter::repeat_n(column(group), group.len())).collect()
}
