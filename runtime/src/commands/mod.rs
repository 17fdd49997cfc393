//! The subcommands, one file each.

pub(crate) mod adapters;
pub(crate) mod check;
pub(crate) mod compare;
pub(crate) mod distance;
pub(crate) mod dump;
pub(crate) mod fmt;
pub(crate) mod render;
