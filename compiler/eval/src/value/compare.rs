//! Comparisons of values.

use std::cmp::Ordering;
use std::rc::Rc;

use chiaro_solid::Scalar;
use chiaro_solid::scalar::Function;
use chiaro_syntax::tree::BinaryOperator;

use super::operators::{apply, condition, undefined};
use super::{Range, Trouble, Value};

/// Whether both are equal; values of different types never are.
pub(crate) fn equal(a: &Value, b: &Value) -> Result<Value, Trouble> {
    let equal = match (a, b) {
        (Value::Number(Scalar::Constant(a)), Value::Number(Scalar::Constant(b))) => a == b,
        (Value::Number(a), Value::Number(b)) => {
            let below = apply(Function::LessEqual, vec![a.clone(), b.clone()])?;
            let above = apply(Function::LessEqual, vec![b.clone(), a.clone()])?;
            return Ok(condition(apply(Function::Multiply, vec![below, above])?));
        }
        (Value::Condition(live), Value::Bool(_) | Value::Condition(_)) | (Value::Bool(_), Value::Condition(live)) => {
            return Err(Trouble::Demote(live.clone(), "a comparison of truth values"));
        }
        (Value::Undef, Value::Undef) => true,
        (Value::Bool(a), Value::Bool(b)) => a == b,
        (Value::String(a), Value::String(b)) => a == b,
        (Value::Range(a), Value::Range(b)) => a == b || (a.len() == 0 && b.len() == 0),
        (Value::List(a), Value::List(b)) => equal_lists(a, b)?,
        (Value::Function(a), Value::Function(b)) => Rc::ptr_eq(a, b),
        _ => false,
    };
    Ok(Value::Bool(equal))
}

fn equal_lists(a: &[Value], b: &[Value]) -> Result<bool, Trouble> {
    for (a, b) in a.iter().zip(b) {
        if !decided(equal(a, b)?)? {
            return Ok(false);
        }
    }
    Ok(a.len() == b.len())
}

/// The truth value of an element's comparison, on which depends whether the next ones are looked at.
fn decided(truth: Value) -> Result<bool, Trouble> {
    match truth {
        Value::Condition(live) => Err(Trouble::Demote(live, "a comparison of lists")),
        truth => Ok(truth.is_true()),
    }
}

/// Whether `a` is less than `b`. The operator is the one written, for messages.
pub(super) fn less(a: &Value, b: &Value, operator: BinaryOperator) -> Result<Value, Trouble> {
    if let (Value::Number(a), Value::Number(b)) = (a, b) {
        return Ok(match (a.constant(), b.constant()) {
            (Some(a), Some(b)) => Value::Bool(a < b),
            _ => condition(apply(Function::Less, vec![a.clone(), b.clone()])?),
        });
    }
    Ok(Value::Bool(order(a, b, operator)? == Some(Ordering::Less)))
}

/// Whether `a` is at most `b`.
pub(super) fn less_equal(a: &Value, b: &Value, operator: BinaryOperator) -> Result<Value, Trouble> {
    if let (Value::Number(a), Value::Number(b)) = (a, b) {
        return Ok(match (a.constant(), b.constant()) {
            (Some(a), Some(b)) => Value::Bool(a <= b),
            _ => condition(apply(Function::LessEqual, vec![a.clone(), b.clone()])?),
        });
    }
    // Of lists with a NaN in them neither is greater: OpenSCAD takes that for "at most".
    Ok(Value::Bool(order(a, b, operator)? != Some(Ordering::Greater)))
}

/// The order of two values of one type; none, if a NaN leaves it open.
fn order(a: &Value, b: &Value, operator: BinaryOperator) -> Result<Option<Ordering>, Trouble> {
    match (a, b) {
        (Value::Number(Scalar::Constant(a)), Value::Number(Scalar::Constant(b))) => Ok(a.partial_cmp(b)),
        (Value::Number(a), Value::Number(b)) => {
            let live = if a.constant().is_some() { b } else { a };
            Err(Trouble::Demote(live.clone(), "a comparison of lists"))
        }
        (Value::Condition(live), Value::Bool(_) | Value::Condition(_)) | (Value::Bool(_), Value::Condition(live)) => {
            Err(Trouble::Demote(live.clone(), "a comparison of truth values"))
        }
        (Value::Bool(a), Value::Bool(b)) => Ok(Some(a.cmp(b))),
        (Value::String(a), Value::String(b)) => Ok(Some(a.cmp(b))),
        (Value::Range(a), Value::Range(b)) => Ok(order_ranges(a, b)),
        (Value::List(a), Value::List(b)) => {
            for (x, y) in a.iter().zip(b.iter()) {
                // What is neither less nor greater counts as equal, NaNs too.
                match order(x, y, operator)? {
                    None | Some(Ordering::Equal) => {}
                    decided => return Ok(decided),
                }
            }
            Ok(Some(a.len().cmp(&b.len())))
        }
        _ => Err(match operator {
            BinaryOperator::Greater | BinaryOperator::GreaterEqual => undefined(operator, b, a),
            _ => undefined(operator, a, b),
        }),
    }
}

/// Empty ranges come first; others go by start, step and count.
fn order_ranges(a: &Range, b: &Range) -> Option<Ordering> {
    match (a.len(), b.len()) {
        (0, n) => Some(0.cmp(&n)),
        (_, 0) => Some(Ordering::Greater),
        (m, n) => [a.start, a.step].partial_cmp(&[b.start, b.step]).map(|order| order.then(m.cmp(&n))),
    }
}
