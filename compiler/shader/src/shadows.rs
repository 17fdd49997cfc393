//! The shadow methods: how much of a light a receiver sees.

/// An algorithm that answers how much of a light each receiver sees.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Shadows {
    /// A ray to the light's centre.
    Hard,
    /// Cones that are proven free, and cells where they are not.
    Verified,
}

impl Shadows {
    /// All of them.
    pub const ALL: [Shadows; 2] = [Shadows::Hard, Shadows::Verified];

    /// Its name, as scenes and command lines write it.
    pub fn name(self) -> &'static str {
        match self {
            Shadows::Hard => "hard",
            Shadows::Verified => "verified",
        }
    }

    /// The method of that name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|method| method.name() == name)
    }

    pub(crate) fn files(self) -> &'static [&'static str] {
        match self {
            Shadows::Hard => &[KERNEL, DISC, include_str!("../templates/shadows/hard.wgsl")],
            Shadows::Verified => &[KERNEL, DISC, include_str!("../templates/shadows/verified.wgsl")],
        }
    }
}

const KERNEL: &str = include_str!("../templates/shadows/kernel.wgsl");
const DISC: &str = include_str!("../templates/shadows/disc.wgsl");
