//! The kernels that a device compiled lately. Scenes whose modules are equal share them: those with crowds, which differ by
//! the numbers in a table.

use std::fmt::{self, Debug, Write};
use std::hash::{DefaultHasher, Hasher};

use crate::kernel::Kernel;

/// How many kernels are kept: those of some scenes, each in all the views of it.
const KEPT: usize = 64;

/// The kernels, the one asked for last at the end.
#[derive(Debug, Default)]
pub(crate) struct Kernels(Vec<(Fingerprint, Kernel)>);

/// What tells kernels apart: 128 bits of what they are compiled from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Fingerprint([u64; 2]);

impl Kernels {
    pub(crate) fn known(&mut self, fingerprint: Fingerprint) -> Option<Kernel> {
        let place = self.0.iter().position(|(known, _)| *known == fingerprint)?;
        let kept = self.0.remove(place);
        let kernel = kept.1.clone();
        self.0.push(kept);
        Some(kernel)
    }

    pub(crate) fn keep(&mut self, fingerprint: Fingerprint, kernel: &Kernel) {
        if self.0.len() == KEPT {
            self.0.remove(0);
        }
        self.0.push((fingerprint, kernel.clone()));
    }
}

impl Fingerprint {
    /// That of anything which shows all that it consists of: naga's modules can't be hashed themselves.
    pub(crate) fn of(source: &dyn Debug) -> Self {
        let mut seeded = DefaultHasher::new();
        seeded.write_u8(1);
        let mut hashed = Hashed([DefaultHasher::new(), seeded]);
        // Writing to a hasher can't fail.
        let _ = write!(hashed, "{source:?}");
        Self(hashed.0.map(|hasher| hasher.finish()))
    }
}

/// Hashes text without keeping it.
struct Hashed([DefaultHasher; 2]);

impl Write for Hashed {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0.iter_mut().for_each(|hasher| hasher.write(text.as_bytes()));
        Ok(())
    }
}
