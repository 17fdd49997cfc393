//! The vocabulary on the CPU: its WGSL, evaluated over a number type.
//!
//! Each function of the vocabulary is translated once from naga's IR to a [`Program`]: a list of operations on single
//! numbers, with vectors taken apart and calls inlined. There is no second definition of a shape in Rust, so CPU and
//! GPU cannot drift apart. The IR is that of the same text in double precision, so that its constants are.

mod dual;
mod number;
mod translate;

pub use dual::Dual;
pub use number::Number;

use std::sync::OnceLock;

use rustc_hash::FxHashMap;

use crate::library::double_module;
use crate::table::Row;

/// A function of the vocabulary, ready to be evaluated.
///
/// Each operation refers to the arguments and to the results of operations before it by their number, the arguments
/// counted first.
#[derive(Clone, Debug)]
pub struct Program {
    arity: usize,
    operations: Vec<Operation>,
    /// Where the components of the result are.
    results: Vec<Slot>,
}

/// The number of an argument or an operation.
type Slot = u32;

/// One operation on numbers. A truth value is the number 1 or 0.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Operation {
    Constant(f64),
    Negate(Slot),
    Not(Slot),
    Abs(Slot),
    Sign(Slot),
    Floor(Slot),
    Sqrt(Slot),
    Sin(Slot),
    Cos(Slot),
    Exp(Slot),
    Ln(Slot),
    Add(Slot, Slot),
    Subtract(Slot, Slot),
    Multiply(Slot, Slot),
    Divide(Slot, Slot),
    Min(Slot, Slot),
    Max(Slot, Slot),
    Atan2(Slot, Slot),
    Less(Slot, Slot),
    LessEqual(Slot, Slot),
    Equal(Slot, Slot),
    /// The condition, the value if it holds, the value if not.
    Select(Slot, Slot, Slot),
}

/// Memory for the evaluation of programs, to be kept from call to call.
#[derive(Clone, Debug)]
pub struct Scratch<N> {
    slots: Vec<N>,
}

impl<N> Scratch<N> {
    /// Empty memory; it grows with the first calls.
    pub fn new() -> Self {
        Self { slots: Vec::new() }
    }
}

impl<N> Default for Scratch<N> {
    fn default() -> Self {
        Self::new()
    }
}

impl Program {
    /// How many numbers the function takes: its arguments, flattened.
    pub fn arity(&self) -> usize {
        self.arity
    }

    /// How many numbers it answers, at most three.
    pub fn results(&self) -> usize {
        self.results.len()
    }

    /// The function's result for these flattened arguments; what it has less than three components is filled with
    /// zeros.
    ///
    /// # Panics
    ///
    /// If there are not as many arguments as the function takes.
    pub fn call<N: Number>(&self, arguments: &[N], scratch: &mut Scratch<N>) -> [N; 3] {
        assert_eq!(arguments.len(), self.arity, "a function of the vocabulary takes all its arguments");
        let slots = &mut scratch.slots;
        slots.clear();
        slots.reserve(self.arity + self.operations.len());
        slots.extend_from_slice(arguments);
        for operation in &self.operations {
            let result = operation.result(slots);
            slots.push(result);
        }
        let result = |index: usize| self.results.get(index).map_or(N::of(0.0), |slot| slots[*slot as usize]);
        [result(0), result(1), result(2)]
    }
}

impl Operation {
    #[inline]
    fn result<N: Number>(self, slots: &[N]) -> N {
        let at = |slot: Slot| slots[slot as usize];
        match self {
            Operation::Constant(value) => N::of(value),
            Operation::Negate(a) => -at(a),
            Operation::Not(a) => N::of(1.0) - at(a),
            Operation::Abs(a) => at(a).abs(),
            Operation::Sign(a) => at(a).sign(),
            Operation::Floor(a) => at(a).floor(),
            Operation::Sqrt(a) => at(a).sqrt(),
            Operation::Sin(a) => at(a).sin(),
            Operation::Cos(a) => at(a).cos(),
            Operation::Exp(a) => at(a).exp(),
            Operation::Ln(a) => at(a).ln(),
            Operation::Add(a, b) => at(a) + at(b),
            Operation::Subtract(a, b) => at(a) - at(b),
            Operation::Multiply(a, b) => at(a) * at(b),
            Operation::Divide(a, b) => at(a) / at(b),
            Operation::Min(a, b) => at(a).min(at(b)),
            Operation::Max(a, b) => at(a).max(at(b)),
            Operation::Atan2(a, b) => at(a).atan2(at(b)),
            Operation::Less(a, b) => at(a).less(at(b)),
            Operation::LessEqual(a, b) => at(a).less_equal(at(b)),
            Operation::Equal(a, b) => at(a).equal(at(b)),
            Operation::Select(condition, accept, reject) => N::select(at(condition), at(accept), at(reject)),
        }
    }
}

/// The program of a WGSL function of the vocabulary. All are translated at the first call.
///
/// # Panics
///
/// If the vocabulary uses what cannot be translated, which the tests rule out.
pub fn program(function: &str) -> Option<&'static Program> {
    static PROGRAMS: OnceLock<FxHashMap<String, Program>> = OnceLock::new();
    let programs = PROGRAMS.get_or_init(|| {
        let module = double_module();
        let functions = module.functions.iter().filter_map(|(_, function)| Some((function.name.as_deref()?, function)));
        let translated = functions.map(|(name, function)| match translate::program(&module, function) {
            Ok(program) => (name.to_owned(), program),
            Err(error) => panic!("{name}: {error}"),
        });
        translated.collect()
    });
    programs.get(function)
}

impl Row {
    /// The row's function on the CPU.
    ///
    /// # Panics
    ///
    /// If there is no such function, which the tests rule out.
    pub fn program(&self) -> &'static Program {
        program(self.function).unwrap_or_else(|| panic!("the vocabulary has no function {}", self.function))
    }
}
