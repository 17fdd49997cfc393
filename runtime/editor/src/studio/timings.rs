//! How long each stage takes on the way from a key to a picture.

use std::time::{Duration, Instant};

/// The stages of one revision of the text.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Timings {
    /// When the text became what it is.
    pub(crate) asked: Option<Instant>,
    /// Text to field graph.
    pub(crate) compile: Duration,
    /// Field graph to pipelines.
    pub(crate) pipelines: Duration,
    /// The first sample that was shown.
    pub(crate) first_sample: Duration,
    /// The last whole sample.
    pub(crate) sample: Duration,
    /// From the text to its first picture.
    pub(crate) to_frame: Duration,
}
