//! Texts that a parameter takes: colours, kinds of joints, algorithms of shadows.

use chiaro_eval::names;
use chiaro_syntax::{Token, TokenKind};

use crate::calls::call_at;

use super::rank::{Candidate, ranked};
use super::{Completion, CompletionKind, Completions};

/// The kinds of joints.
const JOINTS: [&str; 3] = ["fillet", "chamfer", "smooth"];

/// What could be written in a text.
pub(super) fn inside(text: &str, tokens: &[Token], token: Token, caret: usize) -> Completions {
    let begin = token.start as usize + 1;
    let closing = usize::from(token.kind == TokenKind::String);
    // What is never closed takes the rest of its line, of which only the beginning is meant.
    let end = match token.kind {
        TokenKind::String => token.end as usize - closing,
        _ => caret,
    };
    let nothing = Completions { replaces: caret..caret, ..Completions::default() };
    let Some(call) = call_at(text, tokens, token.start as usize) else { return nothing };
    let Some(parameter) = call.entry().and_then(|entry| call.parameter(entry)) else { return nothing };
    let candidates = match parameter.name {
        "c" | "color" | "zenith" | "horizon" | "ground" => colors(),
        "joint" => values(&JOINTS),
        "shadows" => values(names::SHADOWS),
        _ => return nothing,
    };
    let Some(typed) = text.get(begin..caret) else { return nothing };
    Completions { items: ranked(candidates, typed), replaces: begin..end.max(caret), path: None }
}

fn colors() -> Vec<Candidate> {
    let colors = names::colors().iter();
    colors.map(|(name, code)| candidate(name, CompletionKind::Color, format!("#{code:06x}"))).collect()
}

fn values(values: &[&str]) -> Vec<Candidate> {
    values.iter().map(|value| candidate(value, CompletionKind::Value, format!("\"{value}\""))).collect()
}

fn candidate(name: &str, kind: CompletionKind, detail: String) -> Candidate {
    let (label, insert) = (name.to_owned(), name.to_owned());
    let completion = Completion { label, caret: insert.len(), insert, kind, detail, documentation: String::new() };
    Candidate { completion, order: 0 }
}
