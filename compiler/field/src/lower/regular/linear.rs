//! Numbers as linear forms of what is live in them, so that differences of equal lengths are zero for all values.

use chiaro_solid::Scalar;
use chiaro_solid::scalar::{Function, Operation};
use chiaro_vocabulary::Interval;

/// A longer expression counts as one live number: what is compared has few terms.
const LONGEST: u32 = 64;

/// A constant plus multiples of live numbers.
#[derive(Clone, Debug, Default)]
pub(super) struct Linear {
    constant: f64,
    terms: Vec<(Scalar, f64)>,
}

impl Linear {
    /// The sum of two forms, the second one multiplied.
    pub(super) fn plus(mut self, other: &Linear, factor: f64) -> Linear {
        if factor == 0.0 {
            return self;
        }
        self.constant += factor * other.constant;
        for (number, weight) in &other.terms {
            self.add_term(number, factor * weight);
        }
        self
    }

    /// A multiple.
    pub(super) fn times(&self, factor: f64) -> Linear {
        Linear::default().plus(self, factor)
    }

    /// Its values, whatever values the live numbers take within their ranges.
    pub(super) fn range(&self) -> Interval {
        let terms = self.terms.iter().map(|(number, weight)| Interval::point(*weight) * number.range());
        terms.fold(Interval::point(self.constant), |sum, term| sum + term)
    }

    /// The number that it is.
    pub(super) fn number(&self) -> Scalar {
        let terms = self.terms.iter().map(|(number, weight)| Scalar::from(*weight) * number.clone());
        terms.fold(Scalar::from(self.constant), |sum, term| sum + term)
    }

    fn add_term(&mut self, number: &Scalar, weight: f64) {
        match self.terms.iter_mut().find(|(known, _)| known == number) {
            Some(term) => term.1 += weight,
            None => self.terms.push((number.clone(), weight)),
        }
        self.terms.retain(|(_, weight)| *weight != 0.0);
    }

    fn add(&mut self, number: &Scalar, factor: f64) {
        let expression = match number {
            Scalar::Constant(value) => {
                self.constant += factor * value;
                return;
            }
            Scalar::Live(expression) => expression,
        };
        let (function, arguments) = match &expression.operation {
            Operation::Apply(function, arguments) if number.size() <= LONGEST => (function, arguments.as_slice()),
            _ => return self.add_term(number, factor),
        };
        match (function, arguments) {
            (Function::Add, [a, b]) => {
                self.add(a, factor);
                self.add(b, factor);
            }
            (Function::Subtract, [a, b]) => {
                self.add(a, factor);
                self.add(b, -factor);
            }
            (Function::Negate, [a]) => self.add(a, -factor),
            (Function::Multiply, [Scalar::Constant(by), a] | [a, Scalar::Constant(by)]) => self.add(a, factor * by),
            (Function::Divide, [a, Scalar::Constant(by)]) if *by != 0.0 => self.add(a, factor / by),
            _ => self.add_term(number, factor),
        }
    }
}

impl From<&Scalar> for Linear {
    fn from(number: &Scalar) -> Self {
        let mut linear = Linear::default();
        linear.add(number, 1.0);
        linear
    }
}

impl From<f64> for Linear {
    fn from(constant: f64) -> Self {
        Linear { constant, terms: Vec::new() }
    }
}

#[cfg(test)]
mod tests {
    use chiaro_solid::scalar::ParameterId;

    use super::*;

    #[test]
    fn equal_lengths_cancel_whatever_their_value() {
        let height = || Scalar::parameter(ParameterId(0), Interval { min: 1.0, max: 20.0 });
        let top = height() / Scalar::from(2.0) + Scalar::from(0.5) * height();
        let gap = Linear::from(&top).plus(&Linear::from(&height()), -1.0);
        assert_eq!(gap.range(), Interval::point(0.0));
        let apart = Linear::from(&(height() * height())).plus(&Linear::from(&height()), -1.0);
        assert_eq!(apart.range(), Interval { min: -19.0, max: 399.0 });
    }
}
