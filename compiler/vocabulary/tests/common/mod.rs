//! Random numbers and calls by name, for the tests of the vocabulary.
#![allow(dead_code, unreachable_pub, reason = "each test file includes this one and uses its part")]

use chiaro_vocabulary::Row;
use chiaro_vocabulary::cpu::{self, Number, Scratch};

/// SplitMix64: the same numbers in every run.
pub struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A number from `low` to `high`.
    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// One of some values.
    pub fn of<T: Copy>(&mut self, values: &[T]) -> T {
        values[(self.bits() % values.len() as u64) as usize]
    }

    pub fn point<const DIMENSION: usize>(&mut self, reach: f64) -> [f64; DIMENSION] {
        std::array::from_fn(|_| self.within(-reach, reach))
    }
}

/// A function of the vocabulary at flattened arguments.
pub fn call<N: Number>(function: &str, arguments: &[&[N]]) -> [N; 3] {
    let program = cpu::program(function).unwrap_or_else(|| panic!("no function {function}"));
    program.call(&arguments.concat(), &mut Scratch::new())
}

/// A row's function at a point or distance, with its flattened parameters.
pub fn ask<N: Number>(row: &Row, at: &[N], arguments: &[f64]) -> N {
    let arguments: Vec<N> = arguments.iter().map(|argument| N::of(*argument)).collect();
    call(row.function, &[at, &arguments])[0]
}

pub fn dot<const DIMENSION: usize>(a: [f64; DIMENSION], b: [f64; DIMENSION]) -> f64 {
    (0..DIMENSION).map(|axis| a[axis] * b[axis]).sum()
}

pub fn length<const DIMENSION: usize>(a: [f64; DIMENSION]) -> f64 {
    dot(a, a).sqrt()
}
