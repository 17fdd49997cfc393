//! Arguments: which parameter each one goes to, and reading them as numbers, vectors and truth values.
//!
//! OpenSCAD's rules hold: `undef` counts as not given, and what has the wrong type is reported and then too.

use std::sync::Arc;

use chiaro_solid::Scalar;
use chiaro_solid::scalar::Function;
use chiaro_syntax::{Diagnostic, Span};

use super::instance::Instance;
use super::{Argument, Stop, decide};
use crate::value::Value;
use crate::{foreign, suggest};

/// Parameters of OpenSCAD's that mean nothing here or only in old scenes. Dumps are full of them.
const IGNORED: [&str; 9] = ["convexity", "timestamp", "file", "layer", "origin", "id", "dpi", "segments", "slices"];

/// An argument and the parameter it is for.
pub(super) struct Bound {
    parameter: &'static str,
    value: Value,
    span: Span,
}

/// Finds each argument's parameter. Arguments without a name fill the positional parameters that are not named.
pub(super) fn bind(
    module: &str,
    arguments: Vec<Argument>,
    positional: &[&'static str],
    named: &[&'static str],
    diagnostics: &mut Vec<Diagnostic>,
) -> Vec<Bound> {
    let mut bound: Vec<Bound> = Vec::new();
    let mut unfilled = positional.iter().copied();
    for Argument { name, value, span } in arguments {
        let parameter = match name {
            Some(name) => parameter_named(module, &name.node, name.span, positional, named, diagnostics),
            None => {
                let next = unfilled.find(|parameter| !bound.iter().any(|other| other.parameter == *parameter));
                if next.is_none() {
                    let message = format!("`{module}` has no parameter for this argument, which is ignored");
                    diagnostics.push(Diagnostic::warning(span, message));
                }
                next
            }
        };
        let Some(parameter) = parameter else { continue };
        if let Some(first) = bound.iter().position(|other| other.parameter == parameter) {
            let message = format!("`{parameter}` of `{module}` is given twice; the last one counts");
            diagnostics.push(Diagnostic::warning(span, message).with_related(bound[first].span, "given here before"));
            bound.remove(first);
        }
        bound.push(Bound { parameter, value, span });
    }
    bound
}

/// Asks for what some arguments are made of to be known, if live numbers among them may have no finite value: nothing
/// that is drawn may depend on one.
pub(super) fn check_live(arguments: &[Bound]) -> Result<(), Stop> {
    arguments.iter().try_for_each(|bound| check_value(&bound.value, bound.span))
}

fn check_value(value: &Value, span: Span) -> Result<(), Stop> {
    match value {
        Value::Number(number) => decide::finite(number, span),
        Value::List(items) => items.iter().try_for_each(|item| check_value(item, span)),
        _ => Ok(()),
    }
}

fn parameter_named(
    module: &str,
    name: &str,
    span: Span,
    positional: &[&'static str],
    named: &[&'static str],
    diagnostics: &mut Vec<Diagnostic>,
) -> Option<&'static str> {
    let parameters = || positional.iter().chain(named).copied();
    let found = parameters().find(|parameter| *parameter == name);
    if found.is_none() && !name.starts_with('$') && !IGNORED.contains(&name) {
        let message = format!("`{module}` has no parameter `{name}`; the argument is ignored");
        let warning = Diagnostic::warning(span, message);
        let meant = suggest::nearest(name, parameters()).or_else(|| foreign::parameter(name, parameters()));
        diagnostics.push(match meant {
            Some(meant) => suggest::meant(warning, span, &meant),
            None => warning,
        });
    }
    found
}

impl Instance<'_> {
    /// A parameter's value and place, if it is given.
    pub(super) fn value(&self, parameter: &str) -> Option<(Value, Span)> {
        let bound = self.arguments.iter().find(|bound| bound.parameter == parameter)?;
        (!matches!(bound.value, Value::Undef)).then(|| (bound.value.clone(), bound.span))
    }

    /// A parameter's place, or the instance's head.
    pub(super) fn place(&self, parameter: &str) -> Span {
        self.value(parameter).map_or(self.head, |(_, span)| span)
    }

    /// A number.
    pub(super) fn number(&mut self, parameter: &str) -> Option<Scalar> {
        match self.value(parameter)? {
            (Value::Number(number), _) => Some(number),
            (value, span) => self.unfit(parameter, &value, span, "a number"),
        }
    }

    /// A number of an operation that OpenSCAD does not have, or leaves undefined for what is infinite or no number; that is
    /// an error.
    pub(super) fn finite_number(&mut self, parameter: &str) -> Result<Option<Scalar>, Stop> {
        let Some(number) = self.number(parameter) else { return Ok(None) };
        if number.is_finite() || number.constant().is_none() {
            return Ok(Some(number));
        }
        Err(not_finite(parameter, &number, self.place(parameter)))
    }

    /// A truth value as a number: 1 or 0.
    pub(super) fn truth(&mut self, parameter: &str) -> Option<Scalar> {
        match self.value(parameter)? {
            (Value::Bool(truth), _) => Some(Scalar::from(f64::from(truth))),
            (Value::Condition(condition), _) => {
                Some(Scalar::apply(Function::Select, vec![condition, Scalar::ONE, Scalar::ZERO]))
            }
            (value, span) => self.unfit(parameter, &value, span, "`true` or `false`"),
        }
    }

    /// A truth value that has to be known.
    pub(super) fn flag(&mut self, parameter: &str, default: bool) -> Result<bool, Stop> {
        let Some(truth) = self.truth(parameter) else { return Ok(default) };
        Ok(decide::sign(&truth, self.place(parameter), "a truth value that decides the shape")?.is_positive())
    }

    /// A text.
    pub(super) fn text(&mut self, parameter: &str) -> Option<(Arc<str>, Span)> {
        match self.value(parameter)? {
            (Value::String(text), span) => Some((text, span)),
            (value, span) => self.unfit(parameter, &value, span, "a string"),
        }
    }

    /// A vector of as many numbers, or of fewer, down to `least`, with the rest filled in.
    pub(super) fn vector<const N: usize>(&mut self, parameter: &str, least: usize, fill: f64) -> Option<[Scalar; N]> {
        let (value, span) = self.value(parameter)?;
        match padded(&value, least, fill) {
            Some(vector) => Some(vector),
            None => self.unfit(parameter, &value, span, &format!("a list of {N} numbers")),
        }
    }

    /// A number for all components, or a vector, as [`vector`](Self::vector) reads it.
    pub(super) fn number_or_vector<const N: usize>(
        &mut self,
        parameter: &str,
        least: usize,
        fill: f64,
    ) -> Option<[Scalar; N]> {
        let (value, span) = self.value(parameter)?;
        match value {
            Value::Number(number) => Some(std::array::from_fn(|_| number.clone())),
            value => match padded(&value, least, fill) {
                Some(vector) => Some(vector),
                None => self.unfit(parameter, &value, span, &format!("a number or a list of {N} numbers")),
            },
        }
    }

    /// A radius, given as such or as a diameter; the diameter counts if both are given.
    pub(super) fn radius(&mut self, radius: &str, diameter: &str) -> Option<Scalar> {
        let half = self.number(diameter).map(|diameter| diameter / Scalar::from(2.0));
        if half.is_some() && self.value(radius).is_some() {
            let span = self.place(radius);
            self.warn(span, format!("`{radius}` is ignored, because `{diameter}` is given too"));
        }
        half.or_else(|| self.number(radius))
    }

    /// The place of the radius `r` or the diameter `d`.
    pub(super) fn place_of_radius(&self) -> Span {
        let given = self.value("d").or_else(|| self.value("r"));
        given.map_or(self.head, |(_, span)| span)
    }

    /// Reports a value of the wrong type.
    pub(super) fn unfit<T>(&mut self, parameter: &str, value: &Value, span: Span, expected: &str) -> Option<T> {
        let message = format!(
            "`{parameter}` of `{}` has to be {expected}, not {}; the default is used",
            self.name,
            describe(value)
        );
        self.warn(span, message);
        None
    }
}

/// The error that a length is no finite number.
pub(super) fn not_finite(parameter: &str, number: &Scalar, span: Span) -> Stop {
    let is_infinite = number.constant().is_some_and(f64::is_infinite);
    let (is, why) = if is_infinite {
        ("is infinite", "a quotient is infinite where its divisor is 0")
    } else {
        ("is not a number", "0 / 0 is none, nor is a function of what it is not defined for, such as sqrt(-1)")
    };
    let diagnostic = Diagnostic::error(span, format!("`{parameter}` has to be finite"))
        .with_label(format!("this {is}"))
        .with_hint(why);
    Stop::Error(Box::new(diagnostic))
}

/// The numbers of a list of numbers.
pub(super) fn numbers(value: &Value) -> Option<Vec<Scalar>> {
    let Value::List(items) = value else { return None };
    let number = |item: &Value| match item {
        Value::Number(number) => Some(number.clone()),
        _ => None,
    };
    items.iter().map(number).collect()
}

fn padded<const N: usize>(value: &Value, least: usize, fill: f64) -> Option<[Scalar; N]> {
    let numbers = numbers(value)?;
    if numbers.len() < least || numbers.len() > N {
        return None;
    }
    Some(std::array::from_fn(|i| numbers.get(i).cloned().unwrap_or(Scalar::from(fill))))
}

/// What kind of value it is, with its article.
fn describe(value: &Value) -> String {
    match value {
        Value::Undef => "`undef`".into(),
        Value::Bool(truth) => format!("`{truth}`"),
        Value::Condition(_) => "a truth value".into(),
        Value::Number(_) => "a number".into(),
        Value::String(_) => "a string".into(),
        Value::List(items) => match numbers(value) {
            Some(numbers) => format!("a list of {} numbers", numbers.len()),
            None => match items.iter().find(|item| !matches!(item, Value::Number(_))) {
                Some(Value::List(_)) | None => format!("a list of {} values", items.len()),
                Some(odd) => format!("a list with {} in it", describe(odd)),
            },
        },
        Value::Range(_) => "a range".into(),
        Value::Function(_) => "a function".into(),
    }
}
