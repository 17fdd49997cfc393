//! Values of the language.

mod compare;
mod list;
pub(crate) mod operators;
mod print;
pub(crate) mod text;

use std::rc::Rc;
use std::sync::Arc;

use chiaro_solid::Scalar;
use chiaro_syntax::tree::FunctionLiteral;

use crate::scope::Scope;

pub(crate) use list::{Elements, List, held};

/// A value. Cloning one is cheap.
#[derive(Clone, Debug)]
pub(crate) enum Value {
    /// `undef`
    Undef,
    /// A truth value. One that depends on live numbers is [`Value::Condition`].
    Bool(bool),
    /// A number, constant or live.
    Number(Scalar),
    /// A truth value that depends on live numbers: true where the number is not zero.
    Condition(Scalar),
    /// A text.
    String(Arc<str>),
    /// A list. It is read as a slice, and made from a `Vec` by `into()`.
    List(List),
    /// A range; its numbers are constant.
    Range(Range),
    /// A function literal with what it closes over.
    Function(Rc<Closure>),
}

/// A function literal with the scope it was evaluated in.
#[derive(Debug)]
pub(crate) struct Closure {
    /// What was written.
    pub(crate) function: Arc<FunctionLiteral>,
    /// Where its body's names are looked up.
    pub(crate) scope: Rc<Scope>,
}

/// `[start : step : end]`
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Range {
    /// The first number.
    pub(crate) start: f64,
    /// The distance of neighbours.
    pub(crate) step: f64,
    /// The number not to be passed.
    pub(crate) end: f64,
}

/// Why an operation on values has no value.
pub(crate) enum Trouble {
    /// It is not defined for them, and why.
    Undefined(String),
    /// It would have to know a live number, and what for.
    Demote(Scalar, &'static str),
}

impl Value {
    /// The constant number.
    pub(crate) fn number(value: f64) -> Value {
        Value::Number(Scalar::Constant(value))
    }

    /// The text.
    pub(crate) fn string(text: impl Into<Arc<str>>) -> Value {
        Value::String(text.into())
    }

    /// The list of these values.
    pub(crate) fn list(values: Vec<Value>) -> Value {
        Value::List(values.into())
    }

    /// What messages call it: its type with an article.
    pub(crate) fn described(&self) -> &'static str {
        match self {
            Value::Undef => "undef",
            Value::Bool(_) | Value::Condition(_) => "a truth value",
            Value::Number(_) => "a number",
            Value::String(_) => "a string",
            Value::List(_) => "a list",
            Value::Range(_) => "a range",
            Value::Function(_) => "a function",
        }
    }

    /// Whether it counts as true: a [`Value::Bool`], or a [`Value::Condition`] if that depends on live numbers.
    pub(crate) fn truth(&self) -> Value {
        match self {
            Value::Undef => Value::Bool(false),
            Value::Bool(_) | Value::Condition(_) => self.clone(),
            Value::Number(Scalar::Constant(number)) => Value::Bool(*number != 0.0),
            Value::Number(live) => operators::condition(live.clone()),
            Value::String(text) => Value::Bool(!text.is_empty()),
            Value::List(list) => Value::Bool(!list.is_empty()),
            Value::Range(_) | Value::Function(_) => Value::Bool(true),
        }
    }

    /// Whether it is `true` itself.
    pub(crate) fn is_true(&self) -> bool {
        matches!(self, Value::Bool(true))
    }

    /// The constant number it is, if it is one.
    pub(crate) fn constant(&self) -> Option<f64> {
        match self {
            Value::Number(number) => number.constant(),
            _ => None,
        }
    }

    /// How many levels of lists it has.
    pub(crate) fn depth(&self) -> u32 {
        match self {
            Value::List(list) => list.depth(),
            _ => 0,
        }
    }

    /// How many values it holds on all levels, itself included; shared ones count each time.
    pub(crate) fn weight(&self) -> u64 {
        match self {
            Value::List(list) => list.weight(),
            Value::String(text) => 1 + text.len() as u64 / 16,
            _ => 1,
        }
    }
}

impl Range {
    /// One without any numbers.
    pub(crate) const EMPTY: Range = Range { start: 1.0, step: 1.0, end: 0.0 };

    /// How many numbers it has; infinitely many count as `u32::MAX`. A step away from the end gives none, and so does
    /// a step of zero where there is nothing to step to.
    pub(crate) fn len(&self) -> u32 {
        let Range { start, step, end } = *self;
        if start.is_nan() || step.is_nan() || end.is_nan() {
            return 0;
        }
        if (step < 0.0 && start < end) || (step >= 0.0 && start > end) || (step == 0.0 && start == end) {
            return 0;
        }
        if start == end || step.is_infinite() {
            return 1;
        }
        if step == 0.0 || start.is_infinite() || end.is_infinite() {
            return u32::MAX;
        }
        // One unit in the last place more, so that [0 : 0.1 : 1] does not lose its end to rounding.
        let count = ((end - start) / step).next_up().floor();
        if count < f64::from(u32::MAX - 1) { count as u32 + 1 } else { u32::MAX }
    }

    /// Whether there is no last number, though there is a first one.
    pub(crate) fn is_endless(&self) -> bool {
        self.len() == u32::MAX && (self.step == 0.0 || self.start.is_infinite() || self.end.is_infinite())
    }

    /// The numbers in order.
    pub(crate) fn iter(self) -> impl Iterator<Item = f64> {
        (0..self.len()).map(move |i| if i == 0 { self.start } else { self.start + f64::from(i) * self.step })
    }
}
