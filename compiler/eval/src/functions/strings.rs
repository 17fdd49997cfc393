//! Functions of strings.

use chiaro_syntax::Span;

use super::{BuiltIn, Invocation, row};
use crate::evaluator::{Evaluator, Result};
use crate::value::{Value, text};

pub(super) const TABLE: &[BuiltIn] = &[row("str", str), row("chr", chr), row("ord", ord)];

/// The arguments as one text.
fn str(evaluator: &mut Evaluator, call: &Invocation) -> Result<Value> {
    let limit = evaluator.options.limits.string_bytes;
    let mut joined = String::new();
    for argument in &call.arguments {
        if let Value::List(list) = &argument.value {
            evaluator.charge(list.weight(), argument.span)?;
        }
        match text::plain(&argument.value, limit) {
            Ok(text) => joined.push_str(&text),
            Err(trouble) => return evaluator.or_undef(Err(trouble), argument.span),
        }
        evaluator.check_text(joined.len(), argument.span)?;
    }
    evaluator.text(joined, call.span)
}

/// The characters with these code points, given as numbers, lists or ranges.
fn chr(evaluator: &mut Evaluator, call: &Invocation) -> Result<Value> {
    let mut text = String::new();
    for argument in &call.arguments {
        evaluator.charge(argument.value.weight(), argument.span)?;
        characters(evaluator, &argument.value, argument.span, &mut text)?;
    }
    evaluator.text(text, call.span)
}

/// Appends the characters that a value means.
fn characters(evaluator: &mut Evaluator, value: &Value, span: Span, text: &mut String) -> Result<()> {
    match value {
        Value::Number(_) => {
            let code = evaluator.constant(value, span, "a character's code")?;
            text.extend(code.and_then(character));
            Ok(())
        }
        Value::List(list) => list.iter().try_for_each(|value| characters(evaluator, value, span, text)),
        Value::Range(range) => {
            text.extend(evaluator.listed(range, span)?.filter_map(character));
            evaluator.check_text(text.len(), span)
        }
        _ => Ok(()),
    }
}

/// The character of that code point; there is none of 0.
fn character(code: f64) -> Option<char> {
    if code >= 1.0 { char::from_u32(code as u32) } else { None }
}

/// The code point of a text's first character.
fn ord(evaluator: &mut Evaluator, call: &Invocation) -> Result<Value> {
    if !call.counts(evaluator, 1, 1) {
        return Ok(Value::Undef);
    }
    match call.value(0) {
        Some(Value::String(text)) => {
            Ok(text.chars().next().map_or(Value::Undef, |c| Value::number(f64::from(u32::from(c)))))
        }
        _ => {
            call.refuse(evaluator, 0, "a string");
            Ok(Value::Undef)
        }
    }
}
