//! The operators of expressions.

use chiaro_solid::Scalar;
use chiaro_solid::scalar::Function;
use chiaro_syntax::tree::{BinaryOperator, UnaryOperator};

use super::compare;
use super::{Trouble, Value};

/// A live number longer than this many operations becomes structural.
const LONGEST_FORMULA: u32 = 4_096;

/// The function of these numbers.
pub(crate) fn apply(function: Function, arguments: Vec<Scalar>) -> Result<Scalar, Trouble> {
    checked(Scalar::apply(function, arguments))
}

/// The number, unless its formula is too long to be computed anew whenever a parameter moves.
fn checked(number: Scalar) -> Result<Scalar, Trouble> {
    if number.size() > LONGEST_FORMULA {
        return Err(Trouble::Demote(number, "a formula too long to be computed anew for every picture"));
    }
    Ok(number)
}

/// The operator's value for one operand.
pub(crate) fn unary(operator: UnaryOperator, operand: &Value) -> Result<Value, Trouble> {
    match (operator, operand) {
        (UnaryOperator::Plus, _) => Ok(operand.clone()),
        (UnaryOperator::Negate, Value::Number(number)) => Ok(Value::Number(checked(-number.clone())?)),
        (UnaryOperator::Negate, Value::List(list)) => elementwise(list, |value| unary(operator, value)),
        (UnaryOperator::Not, _) => match operand.truth() {
            Value::Condition(number) => {
                Ok(condition(apply(Function::Select, vec![number, Scalar::ZERO, Scalar::ONE])?))
            }
            truth => Ok(Value::Bool(!truth.is_true())),
        },
        (UnaryOperator::BitNot, Value::Number(_)) => Ok(Value::number(!integer(operand)? as f64)),
        _ => Err(Trouble::Undefined(format!("`{}` is not defined for {}", unary_sign(operator), operand.described()))),
    }
}

/// The operator's value for two operands. `&&` and `||`, which may not look at the second, are not among them.
pub(crate) fn binary(operator: BinaryOperator, a: &Value, b: &Value) -> Result<Value, Trouble> {
    use BinaryOperator as Op;
    match operator {
        Op::Equal => compare::equal(a, b),
        Op::NotEqual => unary(UnaryOperator::Not, &compare::equal(a, b)?),
        Op::Less => compare::less(a, b, operator),
        Op::Greater => compare::less(b, a, operator),
        Op::GreaterEqual => compare::less_equal(b, a, operator),
        Op::LessEqual => compare::less_equal(a, b, operator),
        Op::Add | Op::Subtract => sum(operator, a, b),
        Op::Multiply => product(a, b),
        Op::Divide => quotient(a, b),
        Op::Modulo => numeric(operator, a, b, |a, b| apply(Function::Modulo, vec![a, b])),
        Op::Power => numeric(operator, a, b, |a, b| apply(Function::Power, vec![a, b])),
        Op::BitAnd | Op::BitOr | Op::ShiftLeft | Op::ShiftRight => bits(operator, a, b),
        Op::And | Op::Or => Err(undefined(operator, a, b)),
    }
}

/// How an operator is written.
pub(crate) fn sign(operator: BinaryOperator) -> &'static str {
    use BinaryOperator as Op;
    match operator {
        Op::Or => "||",
        Op::And => "&&",
        Op::Equal => "==",
        Op::NotEqual => "!=",
        Op::Greater => ">",
        Op::GreaterEqual => ">=",
        Op::Less => "<",
        Op::LessEqual => "<=",
        Op::BitOr => "|",
        Op::BitAnd => "&",
        Op::ShiftLeft => "<<",
        Op::ShiftRight => ">>",
        Op::Add => "+",
        Op::Subtract => "-",
        Op::Multiply => "*",
        Op::Divide => "/",
        Op::Modulo => "%",
        Op::Power => "^",
    }
}

/// How an operator is written.
pub(crate) fn unary_sign(operator: UnaryOperator) -> &'static str {
    match operator {
        UnaryOperator::Negate => "-",
        UnaryOperator::Plus => "+",
        UnaryOperator::Not => "!",
        UnaryOperator::BitNot => "~",
    }
}

/// The truth value that is true where `number` is not zero; a constant, if it is so for all values of the parameters.
pub(crate) fn condition(number: Scalar) -> Value {
    let range = number.range();
    if !range.contains(0.0) {
        Value::Bool(true)
    } else if range.is_point() {
        Value::Bool(false)
    } else {
        Value::Condition(number)
    }
}

/// That an operator does not take these operands.
pub(super) fn undefined(operator: BinaryOperator, a: &Value, b: &Value) -> Trouble {
    let (sign, a, b) = (sign(operator), a.described(), b.described());
    Trouble::Undefined(format!("`{sign}` is not defined for {a} and {b}"))
}

fn numeric(
    operator: BinaryOperator,
    a: &Value,
    b: &Value,
    f: impl FnOnce(Scalar, Scalar) -> Result<Scalar, Trouble>,
) -> Result<Value, Trouble> {
    match (a, b) {
        (Value::Number(a), Value::Number(b)) => f(a.clone(), b.clone()).map(Value::Number),
        _ => Err(undefined(operator, a, b)),
    }
}

/// Applies an operation to every element; where it is not defined, the element is undef.
fn elementwise(list: &[Value], f: impl Fn(&Value) -> Result<Value, Trouble>) -> Result<Value, Trouble> {
    list.iter().map(|value| or_undef(f(value))).collect::<Result<Vec<_>, _>>().map(Value::list)
}

fn or_undef(result: Result<Value, Trouble>) -> Result<Value, Trouble> {
    match result {
        Err(Trouble::Undefined(_)) => Ok(Value::Undef),
        other => other,
    }
}

fn sum(operator: BinaryOperator, a: &Value, b: &Value) -> Result<Value, Trouble> {
    match (a, b) {
        (Value::Number(a), Value::Number(b)) => {
            let (a, b) = (a.clone(), b.clone());
            checked(if operator == BinaryOperator::Add { a + b } else { a - b }).map(Value::Number)
        }
        (Value::List(a), Value::List(b)) => {
            let sums = a.iter().zip(b.iter()).map(|(a, b)| or_undef(sum(operator, a, b)));
            sums.collect::<Result<Vec<_>, _>>().map(Value::list)
        }
        _ => Err(undefined(operator, a, b)),
    }
}

fn product(a: &Value, b: &Value) -> Result<Value, Trouble> {
    match (a, b) {
        (Value::Number(a), Value::Number(b)) => checked(a.clone() * b.clone()).map(Value::Number),
        (Value::List(list), Value::Number(_)) => elementwise(list, |value| product(value, b)),
        (Value::Number(_), Value::List(list)) => elementwise(list, |value| product(value, a)),
        (Value::List(a), Value::List(b)) => list_product(a, b),
        _ => Err(undefined(BinaryOperator::Multiply, a, b)),
    }
}

fn quotient(a: &Value, b: &Value) -> Result<Value, Trouble> {
    match (a, b) {
        (Value::Number(a), Value::Number(b)) => checked(a.clone() / b.clone()).map(Value::Number),
        (Value::List(list), Value::Number(_)) => elementwise(list, |value| quotient(value, b)),
        (Value::Number(_), Value::List(list)) => elementwise(list, |value| quotient(a, value)),
        _ => Err(undefined(BinaryOperator::Divide, a, b)),
    }
}

/// Products of vectors and matrices, told apart by the first elements.
fn list_product(a: &[Value], b: &[Value]) -> Result<Value, Trouble> {
    match (a.first(), b.first()) {
        (Some(Value::Number(_)), Some(Value::Number(_))) => {
            same_length(a.len(), b.len(), "the vectors have")?;
            dot(a, b.iter()).map(Value::Number)
        }
        (Some(Value::Number(_)), Some(Value::List(_))) => {
            same_length(a.len(), b.len(), "the vector's length and the matrix's rows are")?;
            row_times_matrix(a, b)
        }
        (Some(Value::List(row)), Some(Value::Number(_))) => {
            same_length(row.len(), b.len(), "the matrix's columns and the vector's length are")?;
            let rows = a.iter().map(|row| match row {
                Value::List(row) if row.len() == b.len() => dot(row, b.iter()).map(Value::Number),
                _ => Err(not_rectangular()),
            });
            rows.collect::<Result<Vec<_>, _>>().map(Value::list)
        }
        (Some(Value::List(row)), Some(Value::List(_))) => {
            same_length(row.len(), b.len(), "the left matrix's columns and the right one's rows are")?;
            let rows = a.iter().map(|row| match row {
                Value::List(row) if row.len() == b.len() => row_times_matrix(row, b),
                _ => Err(not_rectangular()),
            });
            rows.collect::<Result<Vec<_>, _>>().map(Value::list)
        }
        (None, _) | (_, None) => Err(Trouble::Undefined("`*` is not defined for an empty list".into())),
        (Some(a), Some(b)) => {
            let (a, b) = (a.described(), b.described());
            Err(Trouble::Undefined(format!("`*` is not defined for lists that begin with {a} and {b}")))
        }
    }
}

fn same_length(a: usize, b: usize, what: &str) -> Result<(), Trouble> {
    if a == b { Ok(()) } else { Err(Trouble::Undefined(format!("for `*`, {what} of different size: {a} and {b}"))) }
}

fn not_rectangular() -> Trouble {
    Trouble::Undefined("`*` is not defined for a matrix whose rows differ in length".into())
}

fn row_times_matrix(row: &[Value], matrix: &[Value]) -> Result<Value, Trouble> {
    let mut rows = Vec::with_capacity(matrix.len());
    for matrix_row in matrix {
        let Value::List(matrix_row) = matrix_row else { return Err(not_rectangular()) };
        rows.push(matrix_row);
    }
    let columns = rows.first().map_or(0, |row| row.len());
    if rows.iter().any(|row| row.len() != columns) {
        return Err(not_rectangular());
    }
    let entries = (0..columns).map(|column| dot(row, rows.iter().map(|row| &row[column])).map(Value::Number));
    entries.collect::<Result<Vec<_>, _>>().map(Value::list)
}

fn dot<'a>(a: &[Value], b: impl Iterator<Item = &'a Value>) -> Result<Scalar, Trouble> {
    let mut sum = Scalar::ZERO;
    for (a, b) in a.iter().zip(b) {
        match (a, b) {
            (Value::Number(a), Value::Number(b)) => sum = sum + a.clone() * b.clone(),
            _ => return Err(undefined(BinaryOperator::Multiply, a, b)),
        }
    }
    checked(sum)
}

fn bits(operator: BinaryOperator, a: &Value, b: &Value) -> Result<Value, Trouble> {
    let (Value::Number(_), Value::Number(_)) = (a, b) else { return Err(undefined(operator, a, b)) };
    let (a, b) = (integer(a)?, integer(b)?);
    let shift = || match u32::try_from(b) {
        Ok(by) if by < 64 => Ok(by),
        _ => Err(Trouble::Undefined(format!("can't shift by {b}: only by 0 to 63"))),
    };
    let value = match operator {
        BinaryOperator::BitAnd => a & b,
        BinaryOperator::BitOr => a | b,
        BinaryOperator::ShiftLeft => a.wrapping_shl(shift()?),
        _ => a.wrapping_shr(shift()?),
    };
    Ok(Value::number(value as f64))
}

/// The number cut off to a whole one.
fn integer(value: &Value) -> Result<i64, Trouble> {
    match value {
        Value::Number(Scalar::Constant(number)) => Ok(*number as i64),
        Value::Number(live) => Err(Trouble::Demote(live.clone(), "the operand of a bit operation")),
        _ => Ok(0),
    }
}
