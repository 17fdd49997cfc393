//! Functions that tell types and surroundings.

use chiaro_syntax::Diagnostic;

use super::{BuiltIn, Invocation, row};
use crate::evaluator::{Evaluator, Result};
use crate::value::Value;

/// The version of OpenSCAD whose language this is, as year and month.
const VERSION: [f64; 2] = [2026.0, 7.0];

pub(super) const TABLE: &[BuiltIn] = &[
    test("is_undef", |e, call| is(e, call, |value| matches!(value, Value::Undef))),
    test("is_bool", |e, call| is(e, call, |value| matches!(value, Value::Bool(_) | Value::Condition(_)))),
    test("is_num", |e, call| is(e, call, is_number)),
    test("is_string", |e, call| is(e, call, |value| matches!(value, Value::String(_)))),
    test("is_list", |e, call| is(e, call, |value| matches!(value, Value::List(_)))),
    test("is_function", |e, call| is(e, call, |value| matches!(value, Value::Function(_)))),
    test("is_object", |e, call| is(e, call, |_| false)),
    row("version", |_, _| Ok(version())),
    row("version_num", version_number),
    row("parent_module", parent_module),
];

const fn test(name: &'static str, call: fn(&mut Evaluator, &Invocation) -> Result<Value>) -> BuiltIn {
    BuiltIn { name, takes_unknown_names: true, call }
}

fn is(evaluator: &mut Evaluator, call: &Invocation, test: impl Fn(&Value) -> bool) -> Result<Value> {
    if !call.counts(evaluator, 1, 1) {
        return Ok(Value::Undef);
    }
    Ok(call.value(0).map_or(Value::Undef, |value| Value::Bool(test(value))))
}

/// A NaN is no number.
fn is_number(value: &Value) -> bool {
    matches!(value, Value::Number(_)) && value.constant().is_none_or(|number| !number.is_nan())
}

fn version() -> Value {
    Value::list(VERSION.map(Value::number).to_vec())
}

/// `version_num()` or `version_num([year, month, day])`: one number to compare.
fn version_number(_: &mut Evaluator, call: &Invocation) -> Result<Value> {
    let version = call.value(0).cloned().unwrap_or_else(version);
    let Value::List(parts) = &version else { return Ok(Value::Undef) };
    let parts: Option<Vec<f64>> = parts.iter().map(Value::constant).collect();
    Ok(match parts.as_deref() {
        Some([year, month]) => Value::number(year * 10_000.0 + month * 100.0),
        Some([year, month, day]) => Value::number(year * 10_000.0 + month * 100.0 + day),
        _ => Value::Undef,
    })
}

/// The name of a user module under way: 0 for the one this is in, 1 for the one that it is in …
fn parent_module(evaluator: &mut Evaluator, call: &Invocation) -> Result<Value> {
    if !call.counts(evaluator, 0, 1) {
        return Ok(Value::Undef);
    }
    let number = if call.arguments.is_empty() {
        1.0
    } else {
        match call.constant(evaluator, 0, "the number of a module")? {
            Some(number) => number.trunc(),
            None => return Ok(Value::Undef),
        }
    };
    let count = evaluator.modules.len();
    if number >= 0.0 && number < count as f64 {
        return Ok(Value::String(evaluator.modules[count - 1 - number as usize].clone().into()));
    }
    let message = format!("there is no module {number} around this one: {count} are under way");
    evaluator.warn(Diagnostic::warning(call.span, message).with_label("this is undef"));
    Ok(Value::Undef)
}
