//! What could be written at the caret.

use std::ops::Range;

use chiaro_eval::World;
use chiaro_syntax::{Token, TokenKind};

use crate::calls::{CallAt, call_at};
use crate::index::Index;
use crate::navigate::linked;
use crate::tokens;
use crate::words::{Position, boundary, is_word};

mod candidates;
mod rank;
mod texts;

/// What kind of thing a completion is, for its icon.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CompletionKind {
    /// A module.
    Module,
    /// A function.
    Function,
    /// A variable or constant.
    Variable,
    /// A parameter's name in a call.
    Parameter,
    /// A keyword.
    Keyword,
    /// The name of a colour.
    Color,
    /// One of the texts that a parameter takes.
    Value,
}

/// One thing that could be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Completion {
    /// What to show for it.
    pub label: String,
    /// What to write.
    pub insert: String,
    /// Where the caret stands then, as an offset in `insert`.
    pub caret: usize,
    /// What kind of thing it is.
    pub kind: CompletionKind,
    /// A line of program: the signature.
    pub detail: String,
    /// The manual; may be empty.
    pub documentation: String,
}

/// All that could be written at a caret.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Completions {
    /// What is replaced: the word around the caret.
    pub replaces: Range<usize>,
    /// What could stand there, the best first.
    pub items: Vec<Completion>,
    /// Where a file is named, what has been written of its path; to list files is the caller's.
    pub path: Option<String>,
}

/// What could be written at the caret: names in scope, those of the language, parameters of the call around it, the
/// values of parameters that are texts. What begins like the word at the caret comes first, then what holds its letters.
pub fn complete(text: &str, caret: usize) -> Completions {
    completions(text, caret, None)
}

/// Like [`complete`], with the names of the files that this one, called `name`, uses or includes.
pub fn complete_in(world: &dyn World, name: &str, text: &str, caret: usize) -> Completions {
    completions(text, caret, Some((world, name)))
}

fn completions(text: &str, caret: usize, files: Option<(&dyn World, &str)>) -> Completions {
    let caret = boundary(text, caret);
    let tokens = tokens(text);
    let around = tokens.iter().copied().find(|token| {
        let (start, end) = (token.start as usize, token.end as usize);
        start < caret && (caret < end || caret == end && continues(text, *token))
    });
    let grammar: Vec<Token> = tokens.into_iter().filter(|token| !token.kind.is_comment()).collect();
    let nothing = Completions { replaces: caret..caret, ..Completions::default() };
    match around.map(|token| (token, token.kind)) {
        Some((token, TokenKind::String | TokenKind::UnclosedString)) => texts::inside(text, &grammar, token, caret),
        Some((token, TokenKind::Use | TokenKind::Include | TokenKind::UnclosedPath)) => path(text, token, caret),
        Some((token, kind)) if is_word(kind) && kind != TokenKind::Number => {
            names(text, &grammar, token.range(), caret, files)
        }
        Some(_) => nothing,
        None => names(text, &grammar, caret..caret, caret, files),
    }
}

/// Whether what is written right behind a token becomes part of it.
fn continues(text: &str, token: Token) -> bool {
    match token.kind {
        TokenKind::LineComment | TokenKind::UnclosedComment | TokenKind::UnclosedString | TokenKind::UnclosedPath => {
            true
        }
        kind => is_word(kind) && !text[token.range()].ends_with('.'),
    }
}

fn path(text: &str, token: Token, caret: usize) -> Completions {
    let range = token.range();
    let Some(begin) = text[range.clone()].find('<').map(|at| range.start + at + 1).filter(|begin| *begin <= caret)
    else {
        return Completions { replaces: caret..caret, ..Completions::default() };
    };
    let end = text[begin..range.end].find('>').map_or(range.end, |at| begin + at);
    let path = Some(text[begin..caret.min(end)].to_owned());
    Completions { replaces: begin..end, items: Vec::new(), path }
}

fn names(
    text: &str,
    tokens: &[Token],
    word: Range<usize>,
    caret: usize,
    files: Option<(&dyn World, &str)>,
) -> Completions {
    let place = Place::of(text, tokens, &word);
    let index = Index::of(text);
    let linked = files.map_or_else(Vec::new, |(world, name)| linked(world, name, &index));
    let typed = &text[word.start..caret];
    let candidates = candidates::at(&place, text, &index, &linked, caret);
    Completions { items: rank::ranked(candidates, typed), replaces: word, path: None }
}

/// What can stand at a place.
struct Place<'a> {
    /// Whether a statement can begin there.
    is_statement: bool,
    /// Whether it is not the first word of a statement, so that only modules can follow.
    is_child: bool,
    /// Whether something is given its name there.
    is_definition: bool,
    /// Whether the part of a vector is named there.
    is_member: bool,
    call: Option<CallAt<'a>>,
    /// What stands behind the word.
    next: Option<TokenKind>,
}

impl<'a> Place<'a> {
    fn of(text: &'a str, tokens: &[Token], word: &Range<usize>) -> Self {
        let before = tokens.partition_point(|token| (token.end as usize) <= word.start);
        let mut position = Position::default();
        tokens[..before].iter().for_each(|token| position.see(token.kind));
        let previous = before.checked_sub(1).map(|at| tokens[at].kind);
        let behind =
            tokens.iter().find(|token| token.start as usize >= word.end && !word.contains(&token.range().start));
        Place {
            is_statement: position.is_statement(),
            is_child: matches!(previous, Some(TokenKind::CloseParenthesis | TokenKind::Else)),
            is_definition: matches!(previous, Some(TokenKind::Module | TokenKind::Function)),
            is_member: previous == Some(TokenKind::Dot),
            call: call_at(text, tokens, word.start),
            next: behind.map(|token| token.kind),
        }
    }
}

#[cfg(test)]
mod tests;
