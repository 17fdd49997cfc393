//! Functions of strings.

use super::{BuiltIn, Invocation, row};
use crate::evaluator::{Evaluator, Result};
use crate::value::{Trouble, Value, text};

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
    }
    string(evaluator, call, joined)
}

/// The characters with these code points, given as numbers, lists or ranges.
fn chr(evaluator: &mut Evaluator, call: &Invocation) -> Result<Value> {
    let mut text = String::new();
    for argument in &call.arguments {
        evaluator.charge(argument.value.weight(), argument.span)?;
        if let Value::Range(range) = &argument.value {
            evaluator.check_range(range, argument.span)?;
        }
        if let Err(trouble) = characters(&argument.value, &mut text) {
            return evaluator.or_undef(Err(trouble), argument.span);
        }
    }
    string(evaluator, call, text)
}

fn characters(value: &Value, text: &mut String) -> std::result::Result<(), Trouble> {
    match value {
        Value::Number(number) => {
            let Some(code) = number.constant() else {
                return Err(Trouble::Demote(number.clone(), "a character's code"));
            };
            text.extend(character(code));
        }
        Value::List(list) => list.iter().try_for_each(|value| characters(value, text))?,
        Value::Range(range) => text.extend(range.iter().filter_map(character)),
        _ => {}
    }
    Ok(())
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

fn string(evaluator: &mut Evaluator, call: &Invocation, text: String) -> Result<Value> {
    // Texts count by their bytes, so that a program can't fill the memory with them.
    evaluator.charge(text.len() as u64 / 64, call.span)?;
    evaluator.limited(Value::string(text), call.span)
}
