//! Which call a place in the text belongs to. It is found by the tokens alone, since what is being written is broken most
//! of the time.

use chiaro_syntax::{Token, TokenKind};

use crate::manual::{self, Entry, Parameter};
use crate::nesting::{BRACES, Nesting};
use crate::words::{Position, bracket, is_keyword};

/// The innermost call around a place.
#[derive(Debug)]
pub(crate) struct CallAt<'a> {
    /// What is called.
    pub(crate) callee: &'a str,
    /// Whether it is a module instead of a function.
    pub(crate) is_module: bool,
    /// The names that arguments are given by.
    pub(crate) given: Vec<&'a str>,
    /// The name of the argument around the place.
    pub(crate) name: Option<&'a str>,
    /// How many arguments without a name stand before the one around the place.
    pub(crate) unnamed_before: usize,
    /// Whether the argument around the place begins there.
    pub(crate) begins_argument: bool,
}

/// A bracket that is open at the place.
#[derive(Default)]
struct Open<'a> {
    /// What stands in front of a parenthesis, and whether that is a module.
    callee: Option<(&'a str, bool)>,
    given: Vec<&'a str>,
    name: Option<&'a str>,
    unnamed: usize,
    begins_argument: bool,
}

/// The innermost call around an offset, at which no token may begin that matters. `tokens` has no comments.
pub(crate) fn call_at<'a>(text: &'a str, tokens: &[Token], offset: usize) -> Option<CallAt<'a>> {
    let before = tokens.partition_point(|token| (token.end as usize) <= offset);
    let mut open = open_at(text, &tokens[..before]).into_open();
    let level = open.iter().rposition(|(_, open)| open.callee.is_some())?;
    // Braces end what is a call.
    if open[level..].iter().any(|(pair, _)| *pair == BRACES) {
        return None;
    }
    let begins_argument = level + 1 == open.len() && open[level].1.begins_argument;
    let (_, mut found) = open.swap_remove(level);
    found.given.extend(names_behind(text, &tokens[before..]));
    let (callee, is_module) = found.callee?;
    Some(CallAt {
        callee,
        is_module,
        given: found.given,
        name: found.name,
        unnamed_before: found.unnamed,
        begins_argument,
    })
}

/// The brackets that are open behind some tokens.
fn open_at<'a>(text: &'a str, tokens: &[Token]) -> Nesting<Open<'a>> {
    let mut position = Position::default();
    let mut open: Nesting<Open> = Nesting::default();
    let mut callee = None;
    for (at, token) in tokens.iter().enumerate() {
        let word = &text[token.range()];
        match bracket(token.kind) {
            Some((pair, true)) => {
                begin_argument(&mut open);
                let callee = callee.take().filter(|_| pair == 0);
                open.open(pair, Open { callee, begins_argument: true, ..Open::default() });
            }
            Some((pair, false)) => {
                open.close(pair);
            }
            None if token.kind == TokenKind::Comma => {
                if let Some(open) = open.innermost_mut() {
                    open.unnamed += usize::from(!open.begins_argument && open.name.is_none());
                    open.name = None;
                    open.begins_argument = true;
                }
            }
            None => {
                let next = tokens.get(at + 1).map(|token| token.kind);
                if let Some(open) = open.innermost_mut().filter(|open| open.begins_argument)
                    && token.kind == TokenKind::Name
                    && next == Some(TokenKind::Assign)
                {
                    open.name = Some(word);
                    open.given.push(word);
                }
                begin_argument(&mut open);
            }
        }
        // The parameters of a definition are no arguments.
        let is_defined = at > 0 && matches!(tokens[at - 1].kind, TokenKind::Module | TokenKind::Function);
        let is_callee = !is_defined && (token.kind == TokenKind::Name || is_keyword(token.kind));
        callee = is_callee.then(|| (word, position.is_statement()));
        position.see(token.kind);
    }
    open
}

fn begin_argument(open: &mut Nesting<Open>) {
    if let Some(open) = open.innermost_mut() {
        open.begins_argument = false;
    }
}

/// The names of arguments from a place in a call up to the call's end.
fn names_behind<'a>(text: &'a str, tokens: &[Token]) -> Vec<&'a str> {
    let mut names = Vec::new();
    let mut depth = 0_usize;
    for pair in tokens.windows(2) {
        match bracket(pair[0].kind) {
            Some((BRACES, _)) => break,
            Some((_, true)) => depth += 1,
            Some((_, false)) if depth == 0 => break,
            Some((_, false)) => depth -= 1,
            None if pair[0].kind == TokenKind::Semicolon => break,
            None => {}
        }
        if depth == 0 && pair[0].kind == TokenKind::Name && pair[1].kind == TokenKind::Assign {
            names.push(&text[pair[0].range()]);
        }
    }
    names
}

impl CallAt<'_> {
    /// The manual of what is called, if it is the language's own.
    pub(crate) fn entry(&self) -> Option<&'static Entry> {
        if self.is_module { manual::module(self.callee) } else { manual::function(self.callee) }
    }

    /// The parameter that the argument around the place is for, of an entry.
    pub(crate) fn parameter<'e>(&self, entry: &'e Entry) -> Option<&'e Parameter> {
        match self.name {
            Some(name) => entry.parameter(name),
            None => {
                let open = entry.parameters.iter().filter(|parameter| parameter.positional);
                open.filter(|parameter| !self.given.contains(&parameter.name)).nth(self.unnamed_before)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::caret;
    use crate::tokens;

    /// The callee and the parameter at `|`.
    fn at(text: &str) -> Option<(String, Option<&'static str>)> {
        let (text, offset) = caret(text);
        let tokens: Vec<_> = tokens(&text).into_iter().filter(|token| !token.kind.is_comment()).collect();
        let call = call_at(&text, &tokens, offset)?;
        let parameter = call.entry().and_then(|entry| call.parameter(entry)).map(|parameter| parameter.name);
        Some((call.callee.to_owned(), parameter))
    }

    #[test]
    fn the_parameter_is_the_one_named_or_that_of_the_position() {
        let found = |callee: &str, parameter: &'static str| Some((callee.to_owned(), Some(parameter)));
        assert_eq!(at("cylinder(|"), found("cylinder", "h"));
        assert_eq!(at("cylinder(10, |"), found("cylinder", "r1"));
        assert_eq!(at("cylinder(r1 = 2, 10, |);"), found("cylinder", "r2"));
        assert_eq!(at("cylinder(d = |2);"), found("cylinder", "d"));
        assert_eq!(at("translate([1, |2]) cube(1);"), found("translate", "v"));
        assert_eq!(at("translate([1, 2]) cube(|1);"), found("cube", "size"));
        assert_eq!(at("x = atan2(1, |2);"), found("atan2", "x"));
    }

    #[test]
    fn braces_definitions_and_plain_parentheses_are_no_calls() {
        assert_eq!(at("union(r = 1) { | }"), None);
        assert_eq!(at("module m(a|) cube(a);"), None);
        assert_eq!(at("x = 2 * (3|);"), None);
    }
}
