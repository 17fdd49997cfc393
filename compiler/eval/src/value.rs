//! Values of the language.

use std::sync::Arc;

use chiaro_solid::Scalar;

/// A value. Cloning one is cheap.
#[derive(Clone, Debug)]
pub enum Value {
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
    /// A list.
    List(Arc<[Value]>),
    /// A range; its numbers are constant.
    Range(Range),
    /// A function literal with what it closes over.
    Function(Arc<dyn std::any::Any + Send + Sync>),
}

/// `[start : step : end]`
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// The first number.
    pub start: f64,
    /// The distance of neighbours.
    pub step: f64,
    /// The number not to be passed.
    pub end: f64,
}
