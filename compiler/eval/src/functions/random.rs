//! `rands`: the same random numbers as OpenSCAD's for the same seed.

use chiaro_syntax::Diagnostic;

use super::{BuiltIn, Invocation, row};
use crate::evaluator::{Evaluator, Result};
use crate::value::Value;

pub(super) const TABLE: &[BuiltIn] = &[row("rands", rands)];

/// The modulus of a seed's hash, a Mersenne prime.
const MODULUS: u64 = (1 << 31) - 1;
/// How many words the generator's state has.
const WORDS: usize = 624;
/// How far ahead the word lies that a new one is mixed with.
const AHEAD: usize = 397;

/// `rands(min, max, count)` or `rands(min, max, count, seed)`.
fn rands(evaluator: &mut Evaluator, call: &Invocation) -> Result<Value> {
    if !call.counts(evaluator, 3, 4) {
        return Ok(Value::Undef);
    }
    let mut numbers = [0.0; 4];
    for (at, number) in numbers.iter_mut().enumerate().take(call.arguments.len()) {
        match call.constant(evaluator, at, "an argument of `rands`")? {
            Some(constant) => *number = constant,
            None => return Ok(Value::Undef),
        }
    }
    let [min, max, count, seed] = numbers;
    if numbers[..3].iter().any(|number| !number.is_finite()) {
        let message = "`rands` takes finite numbers; the largest there is stands for others, and 1 for their count";
        evaluator.warn(Diagnostic::warning(call.span, message));
    }
    let min = if min.is_finite() { min } else { -f64::MAX / 2.0 };
    let max = if max.is_finite() { max } else { f64::MAX / 2.0 };
    let count = if count.is_finite() { count.abs().trunc() } else { 1.0 };
    if count > evaluator.options.limits.list_length as f64 {
        let message = format!("this makes more than {} random numbers", evaluator.options.limits.list_length);
        return Err(evaluator.abort(Diagnostic::error(call.span, message)));
    }
    if call.arguments.len() == 4 {
        evaluator.random = Random::new(hash(seed));
    }
    let (min, max) = (min.min(max), min.max(max));
    evaluator.charge(count as u64, call.span)?;
    let values = (0..count as usize).map(|_| {
        let part = if min < max { evaluator.random.unit() } else { 0.0 };
        Value::number(part * (max - min) + min)
    });
    let values = values.collect();
    evaluator.list(values, call.span)
}

/// The seed's value modulo 2³¹ − 1, as Python hashes numbers.
fn hash(seed: f64) -> u32 {
    if !seed.is_finite() {
        let infinite = if seed > 0.0 { 314_159u32 } else { 314_159u32.wrapping_neg() };
        return if seed.is_nan() { 0 } else { infinite };
    }
    if seed == 0.0 {
        return 0;
    }
    // The seed is mantissa · 2^exponent with a whole mantissa, and 2³¹ is 1 modulo the modulus.
    let bits = seed.abs().to_bits();
    let (biased, fraction) = ((bits >> 52) as i64, bits & ((1 << 52) - 1));
    let mantissa = if biased == 0 { fraction } else { fraction | (1 << 52) };
    let exponent = (biased.max(1) - 1075).rem_euclid(31);
    let residue = ((mantissa % MODULUS) << exponent) % MODULUS;
    if seed < 0.0 { (residue as u32).wrapping_neg() } else { residue as u32 }
}

/// The Mersenne Twister MT19937 of Matsumoto and Nishimura.
pub(crate) struct Random {
    state: [u32; WORDS],
    next: usize,
}

impl Default for Random {
    /// Compiling is deterministic, so that what nobody seeds has a seed too: the generator's usual one.
    fn default() -> Self {
        Self::new(5489)
    }
}

impl Random {
    fn new(seed: u32) -> Self {
        let mut state = [seed; WORDS];
        for i in 1..WORDS {
            let previous = state[i - 1];
            state[i] = (previous ^ (previous >> 30)).wrapping_mul(1_812_433_253).wrapping_add(i as u32);
        }
        Self { state, next: WORDS }
    }

    /// A number from 0 up to, but without, 1, made of two words.
    fn unit(&mut self) -> f64 {
        let (low, high) = (f64::from(self.word()), f64::from(self.word()));
        let unit = (low + high * 2f64.powi(32)) / 2f64.powi(64);
        if unit < 1.0 { unit } else { 1.0f64.next_down() }
    }

    fn word(&mut self) -> u32 {
        if self.next == WORDS {
            self.twist();
        }
        let mut word = self.state[self.next];
        self.next += 1;
        word ^= word >> 11;
        word ^= (word << 7) & 0x9d2c_5680;
        word ^= (word << 15) & 0xefc6_0000;
        word ^ (word >> 18)
    }

    fn twist(&mut self) {
        for i in 0..WORDS {
            let joined = (self.state[i] & 0x8000_0000) | (self.state[(i + 1) % WORDS] & 0x7fff_ffff);
            let odd = if joined & 1 == 1 { 0x9908_b0df } else { 0 };
            self.state[i] = self.state[(i + AHEAD) % WORDS] ^ (joined >> 1) ^ odd;
        }
        self.next = 0;
    }
}
