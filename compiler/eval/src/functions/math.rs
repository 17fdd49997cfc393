//! Functions of numbers and vectors.

use chiaro_solid::Scalar;
use chiaro_solid::scalar::Function;
use chiaro_syntax::Diagnostic;

use super::{BuiltIn, Invocation, row};
use crate::evaluator::{Evaluator, Result};
use crate::value::operators::apply;
use crate::value::{List, Value};

pub(super) const TABLE: &[BuiltIn] = &[
    row("abs", |e, call| unary(e, call, Function::Abs)),
    row("sign", |e, call| unary(e, call, Function::Sign)),
    row("sin", |e, call| unary(e, call, Function::Sin)),
    row("cos", |e, call| unary(e, call, Function::Cos)),
    row("tan", |e, call| unary(e, call, Function::Tan)),
    row("asin", |e, call| unary(e, call, Function::Asin)),
    row("acos", |e, call| unary(e, call, Function::Acos)),
    row("atan", |e, call| unary(e, call, Function::Atan)),
    row("atan2", |e, call| binary(e, call, Function::Atan2)),
    row("floor", |e, call| unary(e, call, Function::Floor)),
    row("ceil", |e, call| unary(e, call, Function::Ceil)),
    row("round", |e, call| unary(e, call, Function::Round)),
    row("sqrt", |e, call| unary(e, call, Function::Sqrt)),
    row("exp", |e, call| unary(e, call, Function::Exp)),
    row("ln", |e, call| unary(e, call, Function::Ln)),
    row("pow", |e, call| binary(e, call, Function::Power)),
    row("log", logarithm),
    row("min", |e, call| extreme(e, call, Function::Min)),
    row("max", |e, call| extreme(e, call, Function::Max)),
    row("norm", norm),
    row("cross", cross),
];

fn unary(evaluator: &mut Evaluator, call: &Invocation, function: Function) -> Result<Value> {
    if !call.counts(evaluator, 1, 1) {
        return Ok(Value::Undef);
    }
    let Some(number) = call.number(evaluator, 0) else { return Ok(Value::Undef) };
    evaluator.or_undef(apply(function, vec![number]).map(Value::Number), call.span)
}

fn binary(evaluator: &mut Evaluator, call: &Invocation, function: Function) -> Result<Value> {
    if !call.counts(evaluator, 2, 2) {
        return Ok(Value::Undef);
    }
    let numbers = (call.number(evaluator, 0), call.number(evaluator, 1));
    let (Some(a), Some(b)) = numbers else { return Ok(Value::Undef) };
    evaluator.or_undef(apply(function, vec![a, b]).map(Value::Number), call.span)
}

/// `log(x)` or `log(base, x)`. It is a quotient of logarithms like OpenSCAD's, to the last bit: log(1000) is a
/// little less than 3.
fn logarithm(evaluator: &mut Evaluator, call: &Invocation) -> Result<Value> {
    if !call.counts(evaluator, 1, 2) {
        return Ok(Value::Undef);
    }
    let last = call.arguments.len() - 1;
    let base = if last == 0 { Some(Scalar::from(10.0)) } else { call.number(evaluator, 0) };
    let (Some(base), Some(x)) = (base, call.number(evaluator, last)) else { return Ok(Value::Undef) };
    let quotient = Scalar::apply(Function::Ln, vec![x]) / Scalar::apply(Function::Ln, vec![base]);
    Ok(Value::Number(quotient))
}

/// The least or greatest of the arguments, or of a list's elements.
fn extreme(evaluator: &mut Evaluator, call: &Invocation, function: Function) -> Result<Value> {
    let values: Vec<Value> = match call.arguments.as_slice() {
        [only] if matches!(only.value, Value::List(_)) => {
            call.list(evaluator, 0).map(|list| list.to_vec()).unwrap_or_default()
        }
        arguments => arguments.iter().map(|argument| argument.value.clone()).collect(),
    };
    evaluator.charge(values.len() as u64, call.span)?;
    let mut best: Option<Scalar> = None;
    for value in values {
        let Value::Number(number) = value else {
            let message = format!("`{}` takes numbers only, not {}", call.name, value.described());
            evaluator.warn(Diagnostic::warning(call.span, message).with_label("this is undef"));
            return Ok(Value::Undef);
        };
        best = Some(match best {
            None => number,
            Some(best) => match (best.constant(), number.constant()) {
                // A NaN is neither less nor greater than anything, so that it only stays where it comes first.
                (Some(a), Some(b)) => {
                    let is_better = if function == Function::Min { b < a } else { a < b };
                    if is_better { number } else { best }
                }
                _ => Scalar::apply(function, vec![best, number]),
            },
        });
    }
    match best {
        Some(best) => evaluator.or_undef(apply(Function::Add, vec![best, Scalar::ZERO]).map(Value::Number), call.span),
        None => {
            let message = format!("`{}` of nothing", call.name);
            evaluator.warn(Diagnostic::warning(call.span, message).with_label("this is undef"));
            Ok(Value::Undef)
        }
    }
}

/// The length of a vector.
fn norm(evaluator: &mut Evaluator, call: &Invocation) -> Result<Value> {
    if !call.counts(evaluator, 1, 1) {
        return Ok(Value::Undef);
    }
    let Some(list) = call.list(evaluator, 0) else { return Ok(Value::Undef) };
    evaluator.charge(list.len() as u64, call.span)?;
    let Some(vector) = vector(&list) else {
        call.refuse(evaluator, 0, "a list of numbers");
        return Ok(Value::Undef);
    };
    let sum = vector.iter().fold(Scalar::ZERO, |sum, x| sum + x.clone() * x.clone());
    evaluator.or_undef(apply(Function::Sqrt, vec![sum]).map(Value::Number), call.span)
}

/// The cross product of two vectors; in the plane, its only component.
fn cross(evaluator: &mut Evaluator, call: &Invocation) -> Result<Value> {
    if !call.counts(evaluator, 2, 2) {
        return Ok(Value::Undef);
    }
    let lists = (call.list(evaluator, 0), call.list(evaluator, 1));
    let (Some(a), Some(b)) = lists else { return Ok(Value::Undef) };
    let is_finite = |number: &Scalar| number.constant().is_none_or(f64::is_finite);
    let finite = |list: &List| vector(list).filter(|vector| vector.len() == 2 || vector.iter().all(is_finite));
    let minor =
        |a: &[Scalar], b: &[Scalar], i: usize, j: usize| a[i].clone() * b[j].clone() - a[j].clone() * b[i].clone();
    match (finite(&a).as_deref(), finite(&b).as_deref()) {
        (Some(a), Some(b)) if a.len() == 2 && b.len() == 2 => Ok(Value::Number(minor(a, b, 0, 1))),
        (Some(a), Some(b)) if a.len() == 3 && b.len() == 3 => {
            let components = [minor(a, b, 1, 2), minor(a, b, 2, 0), minor(a, b, 0, 1)];
            Ok(Value::list(components.map(Value::Number).to_vec()))
        }
        _ => {
            let message = "`cross` takes two vectors of two or three finite numbers each";
            evaluator.warn(Diagnostic::warning(call.span, message).with_label("this is undef"));
            Ok(Value::Undef)
        }
    }
}

/// The numbers of a list of numbers.
fn vector(list: &List) -> Option<Vec<Scalar>> {
    let numbers = list.iter().map(|value| match value {
        Value::Number(number) => Some(number.clone()),
        _ => None,
    });
    numbers.collect()
}
