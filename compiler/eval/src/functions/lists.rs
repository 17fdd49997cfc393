//! Functions of lists.

use chiaro_syntax::Diagnostic;

use super::{BuiltIn, Invocation, row};
use crate::evaluator::{Evaluator, Result};
use crate::value::{Elements, Value};

pub(super) const TABLE: &[BuiltIn] = &[row("len", length), row("concat", concat), row("lookup", lookup)];

fn length(evaluator: &mut Evaluator, call: &Invocation) -> Result<Value> {
    if !call.counts(evaluator, 1, 1) {
        return Ok(Value::Undef);
    }
    match call.value(0) {
        Some(Value::List(list)) => Ok(Value::number(list.len() as f64)),
        Some(Value::String(text)) => {
            evaluator.charge(text.len() as u64 / 64, call.span)?;
            Ok(Value::number(text.chars().count() as f64))
        }
        _ => {
            call.refuse(evaluator, 0, "a list or a string");
            Ok(Value::Undef)
        }
    }
}

/// All arguments as one list; those that are no lists are elements.
fn concat(evaluator: &mut Evaluator, call: &Invocation) -> Result<Value> {
    let mut values = Elements::with_capacity(call.arguments.len());
    for argument in &call.arguments {
        let elements = match &argument.value {
            Value::List(list) => &list[..],
            other => std::slice::from_ref(other),
        };
        elements.iter().try_for_each(|value| evaluator.push(value.clone(), &mut values, call.span))?;
    }
    evaluator.limited(Value::List(values.into()), call.span)
}

/// The value at a key, linearly between the entries `[key, value]` of a table, which need not be sorted.
fn lookup(evaluator: &mut Evaluator, call: &Invocation) -> Result<Value> {
    if !call.counts(evaluator, 2, 2) {
        return Ok(Value::Undef);
    }
    let Some(key) = call.constant(evaluator, 0, "the key of a table")? else { return Ok(Value::Undef) };
    let Some(table) = call.list(evaluator, 1) else { return Ok(Value::Undef) };
    if !key.is_finite() {
        evaluator.warn(Diagnostic::warning(call.span(0), "`lookup` takes a finite number here"));
        return Ok(Value::Undef);
    }
    evaluator.charge(table.weight(), call.span)?;
    let mut entries = Vec::with_capacity(table.len());
    for entry in table.iter() {
        let Value::List(pair) = entry else { continue };
        let [at, value] = &pair[..] else { continue };
        let at = evaluator.constant(at, call.span(1), "a key of a table")?;
        let value = evaluator.constant(value, call.span(1), "a value of a table")?;
        entries.extend(at.zip(value));
    }
    let below = entries.iter().filter(|(at, _)| *at <= key).max_by(|a, b| a.0.total_cmp(&b.0));
    let above = entries.iter().filter(|(at, _)| *at >= key).min_by(|a, b| a.0.total_cmp(&b.0));
    Ok(match (below, above) {
        (Some((low, a)), Some((high, b))) if high > low => {
            let part = (key - low) / (high - low);
            Value::number(b * part + a * (1.0 - part))
        }
        // At an entry, or beyond the ends of the table.
        (Some((_, value)), _) | (None, Some((_, value))) => Value::number(*value),
        (None, None) => Value::Undef,
    })
}
