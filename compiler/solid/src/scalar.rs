//! Numbers that may be live.
//!
//! A [`Scalar`] is a constant or an expression over live parameters. Arithmetic folds constants at once, so that a
//! scene without live numbers never pays for them. The expressions reach the shader as one uniform each: their
//! values are computed here, on the CPU, whenever a parameter moves ([`Scalar::value`]); and [`Scalar::range`] bounds
//! them for every value the parameters may take, which is what facts that have to hold for all of them need.
//!
//! Not every formula has a finite value for all of them: `asin(a)` has none where `a` is 2. The range of such a number
//! is [`Interval::ALL`], and so is that of whatever is computed from it; [`Scalar::is_finite`] tells. No field may be
//! made of such a number: the evaluator makes its parameters constants instead.

mod function;
mod guard;
mod range;

use std::hash::{Hash, Hasher};
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::sync::Arc;

use chiaro_syntax::Span;
use chiaro_vocabulary::Interval;

pub use function::{Function, degrees};

/// The number of a live parameter within its scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ParameterId(pub u32);

/// A number that moves without a recompilation: a Customizer parameter, or `$t`.
#[derive(Clone, Debug, PartialEq)]
pub struct LiveParameter {
    /// The variable's name.
    pub name: Arc<str>,
    /// Its value until it is moved.
    pub default: f64,
    /// The values it may take; finite.
    pub range: Interval,
    /// The distance of neighbouring values on a slider, if the scene says.
    pub step: Option<f64>,
    /// What the scene says about it.
    pub description: Option<String>,
    /// The group the scene puts it in.
    pub group: Option<String>,
    /// Which component, if the variable is a list of numbers.
    pub component: Option<usize>,
    /// The assignment; `$t` has none.
    pub span: Option<Span>,
}

/// A number: a constant, or an expression over live parameters.
#[derive(Clone, Debug)]
pub enum Scalar {
    /// A constant.
    Constant(f64),
    /// An expression that contains at least one live parameter.
    Live(Arc<Expression>),
}

/// An expression over live parameters.
#[derive(Debug)]
pub struct Expression {
    /// What is computed.
    pub operation: Operation,
    /// Bounds for all values of the parameters: finite, or [`Interval::ALL`] if some values are not.
    range: Interval,
    /// How many operations there are, shared ones counted each time.
    size: u32,
    /// A hash of the operation, so that hashing and comparing need not walk the whole expression.
    hash: u64,
}

/// What an [`Expression`] computes.
#[derive(Clone, Debug, PartialEq)]
pub enum Operation {
    /// The parameter's value.
    Parameter(ParameterId),
    /// A function of some numbers.
    Apply(Function, Vec<Scalar>),
}

impl Scalar {
    /// Zero.
    pub const ZERO: Scalar = Scalar::Constant(0.0);
    /// One.
    pub const ONE: Scalar = Scalar::Constant(1.0);

    /// The live parameter itself.
    pub fn parameter(id: ParameterId, range: Interval) -> Scalar {
        Scalar::live(Operation::Parameter(id), range)
    }

    /// The function of these numbers; a constant, if all of them are.
    pub fn apply(function: Function, arguments: Vec<Scalar>) -> Scalar {
        let constants: Option<Vec<f64>> = arguments.iter().map(Scalar::constant).collect();
        if let Some(constants) = constants {
            return Scalar::Constant(function.value(&constants));
        }
        let ranges: Vec<Interval> = arguments.iter().map(Scalar::range).collect();
        let range = match arguments.as_slice() {
            [condition, yes, no] if function == Function::Select => guard::choice(condition, yes, no),
            arguments => range::of_arguments(function, arguments, &ranges),
        };
        Scalar::live(Operation::Apply(function, arguments), range)
    }

    fn live(operation: Operation, range: Interval) -> Scalar {
        let mut hasher = std::hash::DefaultHasher::new();
        match &operation {
            Operation::Parameter(id) => id.hash(&mut hasher),
            Operation::Apply(function, arguments) => (function, arguments).hash(&mut hasher),
        }
        let size = match &operation {
            Operation::Parameter(_) => 1,
            Operation::Apply(_, arguments) => {
                arguments.iter().fold(1u32, |sum, argument| sum.saturating_add(argument.size()))
            }
        };
        Scalar::Live(Arc::new(Expression { operation, range, size, hash: hasher.finish() }))
    }

    /// How many operations it takes to compute it; none for a constant. What is shared counts each time, so that this
    /// bounds every walk.
    pub fn size(&self) -> u32 {
        match self {
            Scalar::Constant(_) => 0,
            Scalar::Live(expression) => expression.size,
        }
    }

    /// Its value, if it is a constant.
    pub fn constant(&self) -> Option<f64> {
        match self {
            Scalar::Constant(value) => Some(*value),
            Scalar::Live(_) => None,
        }
    }

    /// Whether it is the constant `value`.
    pub fn is(&self, value: f64) -> bool {
        self.constant() == Some(value)
    }

    /// Its value while the parameters, in the order of their ids, have these values. One that is outside of its
    /// parameter's range counts as the nearest within, since nothing is known of what is beyond.
    pub fn value(&self, parameters: &[f64]) -> f64 {
        match self {
            Scalar::Constant(value) => *value,
            Scalar::Live(expression) => match &expression.operation {
                // In this order, no number at all counts as the least.
                Operation::Parameter(id) => {
                    parameters[id.0 as usize].max(expression.range.min).min(expression.range.max)
                }
                Operation::Apply(function, arguments) => {
                    let values: Vec<f64> = arguments.iter().map(|argument| argument.value(parameters)).collect();
                    function.value(&values)
                }
            },
        }
    }

    /// Whether its value is a finite number, whatever values the parameters take within their ranges.
    pub fn is_finite(&self) -> bool {
        match self {
            Scalar::Constant(value) => value.is_finite(),
            Scalar::Live(expression) => expression.range.is_finite(),
        }
    }

    /// Bounds of its value, whatever values the parameters take within their ranges; [`Interval::ALL`], if some of
    /// them may be no finite numbers.
    pub fn range(&self) -> Interval {
        match self {
            Scalar::Constant(value) => Interval::point(*value),
            Scalar::Live(expression) => expression.range,
        }
    }

    /// Calls `visit` with every live parameter in it, some of them more than once.
    pub fn visit_parameters(&self, visit: &mut impl FnMut(ParameterId)) {
        if let Scalar::Live(expression) = self {
            match &expression.operation {
                Operation::Parameter(id) => visit(*id),
                Operation::Apply(_, arguments) => {
                    arguments.iter().for_each(|argument| argument.visit_parameters(visit));
                }
            }
        }
    }

    /// The square root.
    pub fn sqrt(self) -> Scalar {
        Scalar::apply(Function::Sqrt, vec![self])
    }

    /// The absolute value.
    pub fn abs(self) -> Scalar {
        Scalar::apply(Function::Abs, vec![self])
    }

    /// The lesser of both.
    pub fn min(self, other: Scalar) -> Scalar {
        Scalar::apply(Function::Min, vec![self, other])
    }

    /// The greater of both.
    pub fn max(self, other: Scalar) -> Scalar {
        Scalar::apply(Function::Max, vec![self, other])
    }
}

impl From<f64> for Scalar {
    fn from(value: f64) -> Self {
        Scalar::Constant(value)
    }
}

impl PartialEq for Scalar {
    /// Constants are equal if their bits are (so that hash-consing never mixes 0 and −0); expressions, if they
    /// compute the same in the same way.
    fn eq(&self, other: &Scalar) -> bool {
        match (self, other) {
            (Scalar::Constant(a), Scalar::Constant(b)) => a.to_bits() == b.to_bits(),
            (Scalar::Live(a), Scalar::Live(b)) => Arc::ptr_eq(a, b) || (a.hash == b.hash && a.operation == b.operation),
            _ => false,
        }
    }
}

impl Eq for Scalar {}

impl Hash for Scalar {
    fn hash<H: Hasher>(&self, state: &mut H) {
        match self {
            Scalar::Constant(value) => value.to_bits().hash(state),
            Scalar::Live(expression) => expression.hash.hash(state),
        }
    }
}

impl Neg for Scalar {
    type Output = Scalar;
    fn neg(self) -> Scalar {
        match self {
            Scalar::Constant(value) => Scalar::Constant(-value),
            live => Scalar::apply(Function::Negate, vec![live]),
        }
    }
}

impl Add for Scalar {
    type Output = Scalar;
    fn add(self, other: Scalar) -> Scalar {
        match (self, other) {
            (Scalar::Constant(a), Scalar::Constant(b)) => Scalar::Constant(a + b),
            (a, b) if a.is(0.0) => b,
            (a, b) if b.is(0.0) => a,
            (a, b) => Scalar::apply(Function::Add, vec![a, b]),
        }
    }
}

impl Sub for Scalar {
    type Output = Scalar;
    fn sub(self, other: Scalar) -> Scalar {
        match (self, other) {
            (Scalar::Constant(a), Scalar::Constant(b)) => Scalar::Constant(a - b),
            (a, b) if a.is(0.0) => -b,
            (a, b) if b.is(0.0) => a,
            (a, b) => Scalar::apply(Function::Subtract, vec![a, b]),
        }
    }
}

impl Mul for Scalar {
    type Output = Scalar;
    /// Zero times what is always finite is zero.
    fn mul(self, other: Scalar) -> Scalar {
        match (self, other) {
            (Scalar::Constant(a), Scalar::Constant(b)) => Scalar::Constant(a * b),
            (a, b) if (a.is(0.0) && b.is_finite()) || (b.is(0.0) && a.is_finite()) => Scalar::ZERO,
            (a, b) if a.is(1.0) => b,
            (a, b) if b.is(1.0) => a,
            (a, b) => Scalar::apply(Function::Multiply, vec![a, b]),
        }
    }
}

impl Mul for &Scalar {
    type Output = Scalar;
    /// As for owned numbers; constants, which most are, need not be cloned.
    fn mul(self, other: &Scalar) -> Scalar {
        match (self, other) {
            (Scalar::Constant(a), Scalar::Constant(b)) => Scalar::Constant(a * b),
            (a, b) => a.clone() * b.clone(),
        }
    }
}

impl Div for Scalar {
    type Output = Scalar;
    fn div(self, other: Scalar) -> Scalar {
        match (self, other) {
            (Scalar::Constant(a), Scalar::Constant(b)) => Scalar::Constant(a / b),
            (a, b) if b.is(1.0) => a,
            (a, b) => Scalar::apply(Function::Divide, vec![a, b]),
        }
    }
}
