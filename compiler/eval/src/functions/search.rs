//! `search`: where values occur in a table.

use chiaro_syntax::Diagnostic;

use super::{BuiltIn, Invocation, row};
use crate::evaluator::{Evaluator, Result};
use crate::value::{Value, operators};
use chiaro_syntax::tree::BinaryOperator;

pub(super) const TABLE: &[BuiltIn] = &[row("search", search)];

/// How matches are looked for and answered.
struct Query {
    /// The most matches of one value; 0 for all. With 1 they stand in one list, else each value has a list.
    matches: usize,
    /// The column of the table's rows that counts.
    column: usize,
}

/// `search(what, table, matches = 1, column = 0)`
fn search(evaluator: &mut Evaluator, call: &Invocation) -> Result<Value> {
    if !call.counts(evaluator, 2, 4) {
        return Ok(Value::Undef);
    }
    let mut sizes = [1usize, 0];
    for (size, at) in sizes.iter_mut().zip(2..call.arguments.len()) {
        match evaluator.constant(&call.arguments[at].value, call.span(at), "an argument of `search`")? {
            Some(number) => *size = number as usize,
            None => *size = 0,
        }
    }
    let query = Query { matches: sizes[0], column: sizes[1] };
    let (what, table) = (&call.arguments[0].value, &call.arguments[1].value);
    let found = match (what, table) {
        (Value::Number(_), _) => {
            let mut found = query.rows(evaluator, call, what, rows(table))?;
            if query.matches > 0 {
                found.truncate(query.matches);
            }
            found.into_iter().map(index).collect()
        }
        (Value::String(what), Value::String(text)) => {
            let text: Vec<char> = text.chars().collect();
            let mut answers = Vec::new();
            for wanted in what.chars() {
                evaluator.charge(text.len() as u64 / 4, call.span)?;
                let found = text.iter().enumerate().filter(|(_, c)| **c == wanted).map(|(at, _)| at);
                query.answer(query.limited(found), false, &mut answers);
            }
            answers
        }
        (Value::String(what), _) => {
            let Some(keys) = query.first_characters(evaluator, call, rows(table)) else {
                return Ok(Value::list(Vec::new()));
            };
            let mut answers = Vec::new();
            for wanted in what.chars() {
                evaluator.charge(keys.len() as u64 / 4, call.span)?;
                let found = keys.iter().enumerate().filter(|(_, key)| **key == Some(wanted)).map(|(at, _)| at);
                query.answer(query.limited(found), false, &mut answers);
            }
            answers
        }
        (Value::List(list), _) => {
            let mut answers = Vec::new();
            for wanted in list.iter() {
                let found = query.rows(evaluator, call, wanted, rows(table))?;
                query.answer(query.limited(found.into_iter()), true, &mut answers);
            }
            answers
        }
        _ => return Ok(Value::Undef),
    };
    evaluator.list(found, call.span)
}

fn rows(table: &Value) -> &[Value] {
    match table {
        Value::List(list) => list,
        _ => &[],
    }
}

fn index(at: usize) -> Value {
    Value::number(at as f64)
}

impl Query {
    fn limited(&self, found: impl Iterator<Item = usize>) -> Vec<usize> {
        if self.matches == 0 { found.collect() } else { found.take(self.matches).collect() }
    }

    /// Appends what was found of one value.
    fn answer(&self, found: Vec<usize>, lists_misses: bool, answers: &mut Vec<Value>) {
        if self.matches != 1 {
            answers.push(Value::list(found.into_iter().map(index).collect()));
        } else if found.is_empty() && lists_misses {
            answers.push(Value::list(Vec::new()));
        } else {
            answers.extend(found.into_iter().map(index));
        }
    }

    /// The numbers of the rows that are the value, or have it in the column.
    fn rows(&self, evaluator: &mut Evaluator, call: &Invocation, wanted: &Value, rows: &[Value]) -> Result<Vec<usize>> {
        let mut found = Vec::new();
        for (at, row) in rows.iter().enumerate() {
            evaluator.charge(wanted.weight().min(row.weight()), call.span)?;
            let in_column = match row {
                Value::List(row) => row.get(self.column),
                _ => None,
            };
            let whole = (self.column == 0).then_some(row);
            for candidate in whole.into_iter().chain(in_column) {
                let equal = operators::binary(BinaryOperator::Equal, wanted, candidate);
                match evaluator.or_undef(equal, call.span)? {
                    Value::Condition(live) => return Err(call.demotion(live, 0, "a comparison in `search`")),
                    equal if equal.is_true() => {
                        found.push(at);
                        break;
                    }
                    _ => {}
                }
            }
            if self.matches > 0 && found.len() >= self.matches {
                break;
            }
        }
        Ok(found)
    }

    /// The first character in the column of each row; none, with a warning, if a row is too short.
    fn first_characters(
        &self,
        evaluator: &mut Evaluator,
        call: &Invocation,
        rows: &[Value],
    ) -> Option<Vec<Option<char>>> {
        let mut keys = Vec::with_capacity(rows.len());
        for (at, row) in rows.iter().enumerate() {
            match row {
                Value::List(row) if row.len() > self.column => keys.push(match &row[self.column] {
                    Value::String(text) => text.chars().next(),
                    _ => None,
                }),
                _ => {
                    let message = format!("row {at} of the table has no column {}", self.column);
                    evaluator.warn(Diagnostic::warning(call.span(1), message));
                    return None;
                }
            }
        }
        Some(keys)
    }
}
