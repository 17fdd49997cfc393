//! What the call under way takes, to be shown while its arguments are written.

use std::ops::Range;

use chiaro_syntax::Token;

use crate::calls::{CallAt, call_at};
use crate::describe::{comment_above, valued};
use crate::index::{Definition, Index, What};
use crate::tokens;
use crate::words::boundary;

/// What a call takes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CallHint {
    /// The name and its parameters on one line.
    pub signature: String,
    /// Where in the signature the parameter stands that the argument at the caret is for, if it is known.
    pub active: Option<Range<usize>>,
    /// What that parameter is; or else what is called, if there is something to say.
    pub manual: String,
}

/// What the innermost call around the caret takes, and which of its parameters the caret is at. None outside of calls, and
/// where what is called is not known.
pub fn call_hint(text: &str, caret: usize) -> Option<CallHint> {
    let all = tokens(text);
    let grammar: Vec<Token> = all.iter().copied().filter(|token| !token.kind.is_comment()).collect();
    let caret = boundary(text, caret);
    let call = call_at(text, &grammar, caret)?;
    let index = Index::of(text);
    let wanted = if call.is_module { What::Module } else { What::Function };
    let visible = index.visible(caret);
    let is_called = |definition: &&Definition| definition.what == wanted && *definition.name == *call.callee;
    match visible.iter().map(|id| &index.definitions[*id]).find(is_called) {
        Some(own) => {
            let parameters = own.parameters.iter().map(|id| &index.definitions[*id]);
            let shown: Vec<_> = parameters.map(|one| (one.name.to_string(), valued(text, one))).collect();
            let names: Vec<&str> = shown.iter().map(|(name, _)| &**name).collect();
            let (signature, active) = signature(&call, &shown, active(&call, &names));
            Some(CallHint { signature, active, manual: comment_above(text, &all, own.span.start) })
        }
        None => {
            let entry = call.entry().filter(|entry| !entry.parameters.is_empty())?;
            let shown: Vec<_> = entry.parameters.iter().map(|one| (one.name.to_owned(), one.signature())).collect();
            let parameter = call.parameter(entry);
            let at = parameter.and_then(|parameter| shown.iter().position(|(name, _)| name == parameter.name));
            let (signature, active) = signature(&call, &shown, at);
            let manual = parameter.map_or_else(|| entry.manual.to_owned(), |parameter| parameter.description());
            Some(CallHint { signature, active, manual })
        }
    }
}

/// Which of the parameters the argument at the caret is for.
fn active(call: &CallAt, names: &[&str]) -> Option<usize> {
    match call.name {
        Some(name) => names.iter().position(|other| *other == name),
        None => {
            let unnamed = names.iter().enumerate().filter(|(_, name)| !call.given.contains(name));
            unnamed.map(|(at, _)| at).nth(call.unnamed_before)
        }
    }
}

/// The signature, and where in it the active parameter stands.
fn signature(call: &CallAt, shown: &[(String, String)], active: Option<usize>) -> (String, Option<Range<usize>>) {
    let mut signature = format!("{}(", call.callee);
    let mut place = None;
    for (at, (_, parameter)) in shown.iter().enumerate() {
        signature.push_str(if at > 0 { ", " } else { "" });
        let begin = signature.len();
        signature.push_str(parameter);
        if active == Some(at) {
            place = Some(begin..signature.len());
        }
    }
    (signature + ")", place)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::caret;

    /// The signature, the active parameter, the manual.
    fn at(text: &str) -> Option<(String, String, String)> {
        let (text, offset) = caret(text);
        let hint = call_hint(&text, offset)?;
        let active = hint.active.map_or_else(String::new, |range| hint.signature[range].to_owned());
        Some((hint.signature, active, hint.manual))
    }

    fn hint(signature: &str, active: &str, manual: &str) -> Option<(String, String, String)> {
        Some((signature.to_owned(), active.to_owned(), manual.to_owned()))
    }

    #[test]
    fn the_languages_calls_say_what_they_take() {
        let torus = "torus(major = 10, minor = 2)";
        assert_eq!(at("torus(|"), hint(torus, "major = 10", "radius of the circle that the ring runs around (mm)"));
        assert_eq!(at("torus(5, |);"), hint(torus, "minor = 2", "radius of the ring's own round profile (mm)"));
        assert_eq!(at("torus(minor = 1|);"), hint(torus, "minor = 2", "radius of the ring's own round profile (mm)"));
        assert_eq!(at("torus(1, 2, |);"), hint(torus, "", "The ring with a round profile that lies around z."));
        assert_eq!(at("x = atan2(1, |);"), hint("atan2(y, x)", "x", "a number"));
    }

    #[test]
    fn so_do_the_files_own() {
        let text = "// A wall.\nmodule wall(l, h = 2) cube([l, 1, h]);\nwall(l = 3, |);";
        assert_eq!(at(text), hint("wall(l, h = 2)", "h = 2", "A wall."));
        assert_eq!(at("x = (|1);"), None);
        assert_eq!(at("unknown(|);"), None);
    }
}
