//! The subcommands, one file each.

pub(crate) mod adapters;
pub(crate) mod check;
pub(crate) mod compare;
mod compare_one_pass;
pub(crate) mod distance;
pub(crate) mod dump;
#[cfg(feature = "editor")]
pub(crate) mod edit;
pub(crate) mod export;
pub(crate) mod fmt;
pub(crate) mod render;
#[cfg(feature = "editor")]
pub(crate) mod watch;
