//! Names of variables in emitted functions.

use rustc_hash::{FxHashMap, FxHashSet};

/// Gives names that are unique within a module.
///
/// They are a prefix with an underscore and letters: never a keyword of a target language, and nothing that naga's
/// writers would add a suffix to.
pub(crate) struct Names {
    taken: FxHashSet<String>,
    counts: FxHashMap<String, usize>,
}

impl Names {
    /// Without the names that are taken.
    pub(crate) fn new(taken: impl Iterator<Item = String>) -> Self {
        Self { taken: taken.collect(), counts: FxHashMap::default() }
    }

    /// The next name with this prefix: `box_a`, `box_b`, …
    pub(crate) fn next(&mut self, prefix: &str) -> String {
        let count = match self.counts.get_mut(prefix) {
            Some(count) => count,
            None => self.counts.entry(prefix.to_owned()).or_default(),
        };
        loop {
            let name = format!("{prefix}_{}", letters(*count));
            *count += 1;
            if !self.taken.contains(&name) {
                return name;
            }
        }
    }
}

/// a, …, z, aa, ab, …
fn letters(mut number: usize) -> String {
    let mut letters = Vec::new();
    loop {
        letters.push(char::from(b'a' + (number % 26) as u8));
        match number / 26 {
            0 => return letters.iter().rev().collect(),
            more => number = more - 1,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_count_in_letters_and_avoid_what_is_taken() {
        let mut names = Names::new(["box_b".to_string()].into_iter());
        assert_eq!([names.next("box"), names.next("box")], ["box_a", "box_c"]);
        assert_eq!([25, 26, 701, 702].map(letters), ["z", "aa", "zz", "aaa"]);
    }
}
