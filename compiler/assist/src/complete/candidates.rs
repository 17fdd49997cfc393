//! Everything that can stand at a place.

use crate::describe::{comment_above, signature, valued};
use crate::hover::documentation;
use crate::index::{Definition, Index, What};
use crate::manual::{self, Entry};
use crate::navigate::Linked;
use crate::tokens;

use chiaro_syntax::TokenKind;

use super::rank::Candidate;
use super::{Completion, CompletionKind, Place};

/// Keywords that begin statements.
const STATEMENT_KEYWORDS: [&str; 5] = ["module", "function", "else", "use", "include"];
/// Keywords that stand in values.
const VALUE_KEYWORDS: [&str; 9] = ["true", "false", "undef", "let", "function", "for", "each", "if", "else"];

/// How likely things are.
const PARAMETER: u8 = 0;
const OWN: u8 = 1;
const LINKED: u8 = 2;
const BUILT_IN: u8 = 3;
const KEYWORD: u8 = 4;
const OLD: u8 = 5;

/// Names that only old scenes use.
const OLD_NAMES: [&str; 5] = ["assign", "child", "group", "render", "intersection_for"];

/// The candidates at a place.
pub(super) fn at(place: &Place, text: &str, index: &Index, linked: &[Linked], caret: usize) -> Vec<Candidate> {
    if place.is_definition {
        return Vec::new();
    }
    if place.is_member {
        let member =
            |name: &&str| candidate(name, CompletionKind::Variable, PARAMETER, "part of a vector", String::new());
        return ["x", "y", "z"].iter().map(member).collect();
    }
    let mut candidates = Vec::new();
    if let Some(call) = place.call.as_ref().filter(|call| call.begins_argument) {
        parameters(place, call, text, index, caret, &mut candidates);
    }
    own(place, text, index, caret, &mut candidates);
    for file in linked {
        globals(place, file, &mut candidates);
    }
    built_in(place, &mut candidates);
    candidates
}

/// The parameters of a call that are not given yet.
fn parameters(
    place: &Place,
    call: &crate::calls::CallAt,
    text: &str,
    index: &Index,
    caret: usize,
    candidates: &mut Vec<Candidate>,
) {
    let wanted = if call.is_module { What::Module } else { What::Function };
    let visible = index.visible(caret);
    let own = visible
        .iter()
        .map(|id| &index.definitions[*id])
        .find(|definition| definition.what == wanted && *definition.name == *call.callee);
    let mut add = |name: &str, detail: String, documentation: String| {
        if !call.given.contains(&name) {
            let mut candidate = candidate(name, CompletionKind::Parameter, PARAMETER, &detail, documentation);
            let is_named = place.next == Some(TokenKind::Assign);
            candidate.completion.insert = if is_named { name.to_owned() } else { format!("{name} = ") };
            candidate.completion.caret = candidate.completion.insert.len();
            candidates.push(candidate);
        }
    };
    match (own, call.entry()) {
        (Some(own), _) => {
            for parameter in own.parameters.iter().map(|id| &index.definitions[*id]) {
                add(&parameter.name, valued(text, parameter), String::new());
            }
        }
        (None, Some(entry)) if call.is_module => {
            for parameter in &entry.parameters {
                add(parameter.name, parameter.signature(), parameter.description());
            }
        }
        _ => {}
    }
}

/// What the text defines and can be seen at the caret.
fn own(place: &Place, text: &str, index: &Index, caret: usize, candidates: &mut Vec<Candidate>) {
    let tokens = tokens(text);
    for definition in index.visible(caret).into_iter().map(|id| &index.definitions[id]) {
        if fits(place, definition) && !definition.name_range.contains(&caret) && definition.name_range.end != caret {
            let comment = comment_above(text, &tokens, definition.span.start);
            candidates.push(defined(place, text, index, definition, comment, OWN));
        }
    }
}

/// What another file defines at its top level.
fn globals(place: &Place, file: &Linked, candidates: &mut Vec<Candidate>) {
    let tokens = tokens(&file.text);
    for definition in file.index.definitions.iter().filter(|definition| definition.is_global) {
        let is_handed_on = definition.what != What::Variable || file.with_variables;
        if is_handed_on && fits(place, definition) {
            let comment = comment_above(&file.text, &tokens, definition.span.start);
            candidates.push(defined(place, &file.text, &file.index, definition, comment, LINKED));
        }
    }
}

/// Whether a definition can be meant at a place.
fn fits(place: &Place, definition: &Definition) -> bool {
    match definition.what {
        What::Module => place.is_statement,
        What::Function => !place.is_statement,
        // A statement may give a variable its value.
        What::Variable | What::Parameter => !place.is_child,
    }
}

fn defined(place: &Place, text: &str, index: &Index, definition: &Definition, comment: String, order: u8) -> Candidate {
    let kind = match definition.what {
        What::Module => CompletionKind::Module,
        What::Function => CompletionKind::Function,
        What::Variable | What::Parameter => CompletionKind::Variable,
    };
    let mut candidate = candidate(&definition.name, kind, order, &signature(text, index, definition), comment);
    if kind != CompletionKind::Variable {
        call(&mut candidate.completion, place, !definition.parameters.is_empty());
    }
    candidate
}

/// The names of the language.
fn built_in(place: &Place, candidates: &mut Vec<Candidate>) {
    let mut add = |entry: &Entry, kind: CompletionKind, order: u8| {
        if entry.is_supported {
            let order = if OLD_NAMES.contains(&entry.name) { OLD } else { order };
            let is_called = matches!(kind, CompletionKind::Module | CompletionKind::Function);
            let detail = if is_called { entry.signature() } else { entry.name.to_owned() };
            let mut candidate = candidate(entry.name, kind, order, &detail, documentation(entry));
            if is_called {
                call(&mut candidate.completion, place, entry.parameters.iter().any(|parameter| parameter.positional));
            }
            candidates.push(candidate);
        }
    };
    if place.is_statement {
        manual::modules().for_each(|entry| add(entry, CompletionKind::Module, BUILT_IN));
        let keywords = STATEMENT_KEYWORDS.iter().filter(|_| !place.is_child);
        keywords
            .filter_map(|word| manual::keyword(word))
            .for_each(|entry| add(entry, CompletionKind::Keyword, KEYWORD));
    } else {
        manual::functions().for_each(|entry| add(entry, CompletionKind::Function, BUILT_IN));
        let keywords = VALUE_KEYWORDS.iter().filter_map(|word| manual::keyword(word));
        keywords.for_each(|entry| add(entry, CompletionKind::Keyword, KEYWORD));
    }
    if !place.is_child {
        manual::variables().for_each(|entry| add(entry, CompletionKind::Variable, BUILT_IN));
    }
}

/// Makes a completion write the parentheses too, unless they stand there already. The caret goes between them where
/// arguments are usual.
fn call(completion: &mut Completion, place: &Place, takes_arguments: bool) {
    if place.next == Some(TokenKind::OpenParenthesis) {
        return;
    }
    let takes_bindings = matches!(&*completion.label, "for" | "let" | "intersection_for" | "if" | "assign");
    completion.insert = format!("{}{}()", completion.label, if takes_bindings { " " } else { "" });
    let is_inside = takes_arguments || takes_bindings;
    completion.caret = completion.insert.len() - usize::from(is_inside);
}

fn candidate(name: &str, kind: CompletionKind, order: u8, detail: &str, documentation: String) -> Candidate {
    let (label, insert) = (name.to_owned(), name.to_owned());
    let completion = Completion { label, caret: insert.len(), insert, kind, detail: detail.to_owned(), documentation };
    Candidate { completion, order }
}
