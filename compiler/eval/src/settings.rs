//! What the user of the compiler chooses.

use crate::geometry::Facets;

/// How scenes are evaluated.
#[derive(Clone, Debug, Default)]
pub(crate) struct Settings {
    /// What an explicit `$fn` does to curves.
    pub(crate) facets: Facets,
}
