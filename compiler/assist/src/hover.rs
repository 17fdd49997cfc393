//! What something in the text is, in a few words.

use std::ops::Range;

use chiaro_eval::names;
use chiaro_syntax::{Token, TokenKind};

use crate::calls::call_at;
use crate::describe::{comment_above, signature};
use crate::index::{Index, Namespace, Occurrence, Role, What};
use crate::manual::{self, Default, Entry, Parameter};
use crate::tokens;
use crate::words::token_at;

/// What is to be said about a part of the text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hover {
    /// The part that it is about.
    pub range: Range<usize>,
    /// A line of program: the signature, or what it stands for.
    pub title: String,
    /// The manual, on as many lines as it needs.
    pub body: String,
}

/// What is to be said about what stands at an offset: for names and keywords the manual, for the file's own definitions
/// their signature and the comment above them, for numbers the parameter they are for and its unit.
pub fn hover(text: &str, offset: usize) -> Option<Hover> {
    let tokens = tokens(text);
    let token = token_at(&tokens, offset)?;
    let (title, body) = match token.kind {
        TokenKind::Number => number(text, &tokens, token)?,
        TokenKind::String => color(&text[token.range()])?,
        TokenKind::Use => of_entry(manual::keyword("use")?),
        TokenKind::Include => of_entry(manual::keyword("include")?),
        _ => word(text, &tokens, token)?,
    };
    Some(Hover { range: token.range(), title, body })
}

fn word(text: &str, tokens: &[Token], token: Token) -> Option<(String, String)> {
    let word = &text[token.range()];
    let index = Index::of(text);
    let occurrence = index.at(token.range().start).filter(|occurrence| occurrence.range == token.range());
    match occurrence {
        Some(occurrence) => match occurrence.definition {
            Some(definition) => Some(own(text, tokens, &index, definition)),
            None => built_in(occurrence),
        },
        None => manual::keyword(word).or_else(|| manual::module(word)).map(of_entry),
    }
}

fn own(text: &str, tokens: &[Token], index: &Index, id: usize) -> (String, String) {
    let definition = &index.definitions[id];
    let mut body = comment_above(text, tokens, definition.span.start);
    if definition.what == What::Parameter {
        let owner = index.definitions.iter().find(|owner| owner.parameters.contains(&id));
        body = owner.map_or_else(|| "a parameter".to_owned(), |owner| format!("a parameter of `{}`", owner.name));
    }
    (signature(text, index, definition), body)
}

fn built_in(occurrence: &Occurrence) -> Option<(String, String)> {
    let name = &*occurrence.name;
    match &occurrence.role {
        Role::Of(Namespace::Module) => manual::module(name).map(of_entry),
        Role::Of(Namespace::Function) => manual::function(name).map(of_entry),
        Role::Of(Namespace::Variable) => manual::variable(name).map(of_entry),
        Role::Argument { callee, of } => {
            let entry = if *of == Namespace::Module { manual::module(callee) } else { manual::function(callee) };
            let parameter = entry?.parameter(name)?;
            Some((parameter.signature(), format!("{}; a parameter of `{callee}`", parameter.description())))
        }
    }
}

fn of_entry(entry: &Entry) -> (String, String) {
    let is_called = !entry.parameters.is_empty()
        || manual::function(entry.name).is_some_and(|function| std::ptr::eq(function, entry));
    let is_module = manual::module(entry.name).is_some_and(|module| std::ptr::eq(module, entry));
    let title = if is_called || is_module { entry.signature() } else { entry.name.to_owned() };
    (title, documentation(entry))
}

/// The manual of an entry: what it is, its parameters, an example.
pub(crate) fn documentation(entry: &Entry) -> String {
    let mut body = entry.manual.to_owned();
    if !entry.parameters.is_empty() {
        body += "\n";
    }
    for parameter in &entry.parameters {
        let needed = if parameter.default == Default::Needed { ", needed" } else { "" };
        body += &format!("\n`{}`: {}{needed}", parameter.signature(), parameter.description());
    }
    if !entry.example.is_empty() {
        body += &format!("\n\n{}", entry.example);
    }
    body
}

/// What a number is for.
fn number(text: &str, tokens: &[Token], token: Token) -> Option<(String, String)> {
    let grammar: Vec<Token> = tokens.iter().copied().filter(|token| !token.kind.is_comment()).collect();
    let call = call_at(text, &grammar, token.range().start)?;
    let digits = &text[token.range()];
    let entry = call.entry()?;
    let parameter: &Parameter = call.parameter(entry)?;
    let title = if parameter.unit.is_empty() { digits.to_owned() } else { format!("{digits} {}", parameter.unit) };
    Some((title, format!("`{}` of `{}`: {}", parameter.name, entry.name, parameter.manual)))
}

/// What a text is, if it is a colour's name.
fn color(quoted: &str) -> Option<(String, String)> {
    let name = quoted.trim_matches('"').to_lowercase();
    let (_, code) = names::colors().iter().find(|(other, _)| *other == name)?;
    Some((name, format!("the colour #{code:06x}")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::caret;

    /// The title and the body's first line at `|`.
    fn at(text: &str) -> Option<(String, String)> {
        let (text, offset) = caret(text);
        let hover = hover(&text, offset)?;
        Some((hover.title, hover.body.lines().next().unwrap_or_default().to_owned()))
    }

    fn said(title: &str, body: &str) -> Option<(String, String)> {
        Some((title.to_owned(), body.to_owned()))
    }

    #[test]
    fn the_languages_names_have_their_manual() {
        assert_eq!(
            at("to|rus(5, 1);"),
            said("torus(major = 10, minor = 2)", "The ring with a round profile that lies around z.")
        );
        assert_eq!(at("trans|late([1, 0, 0]) cube(1);"), said("translate(v = [0, 0, 0])", "Moves its children."));
        assert_eq!(at("x = si|n(30);"), said("sin(angle)", "The sine of an angle in degrees."));
        assert_eq!(at("rotate(360 * $t|) cube(1);"), said("$t", "The time, from 0 to 1."));
        assert_eq!(at("for| (i = [1]) cube(i);").map(|said| said.0), Some("for".to_owned()));
        assert_eq!(at("round|(2) cube(1);").map(|said| said.0), Some("round(r)".to_owned()));
        assert_eq!(at("x = round|(2);").map(|said| said.0), Some("round(x)".to_owned()));
    }

    #[test]
    fn the_files_definitions_have_their_signature_and_comment() {
        let text = "// A wall\n// of bricks.\nmodule wall(l, h = 2) cube([l, 1, h]);\n\nwall|(3);";
        assert_eq!(at(text), said("module wall(l, h = 2)", "A wall"));
        assert_eq!(at("module wall(l, h = 2) cube([l, 1, h|]);"), said("h = 2", "a parameter of `wall`"));
        assert_eq!(at("/* How wide */\nw = 2 * 3; cube(w|);"), said("w = 2 * 3", "How wide"));
        assert_eq!(at("a = 1; // of a\nb = 2; c = b|;"), said("b = 2", ""));
    }

    #[test]
    fn parameters_and_numbers_say_their_unit() {
        assert_eq!(at("cylinder(h| = 2);"), said("h = 1", "height (mm); a parameter of `cylinder`"));
        assert_eq!(at("cylinder(12|, 3);"), said("12 mm", "`h` of `cylinder`: height"));
        assert_eq!(at("rotate([0, 45|, 0]) cube(1);").map(|said| said.0), Some("45 °".to_owned()));
        assert_eq!(at("x = 5|;"), None);
    }

    #[test]
    fn colours_are_known_by_name() {
        assert_eq!(at("color(\"tom|ato\") cube(1);"), said("tomato", "the colour #ff6347"));
    }
}
