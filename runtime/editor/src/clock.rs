//! The time `$t` of scenes that move.

use std::time::Instant;

/// How long a round of `$t` from 0 to 1 takes at first, in seconds.
const PERIOD: f64 = 4.0;

/// The time of the scene, which stands or runs.
#[derive(Debug)]
pub(crate) struct Clock {
    /// From 0 to 1.
    pub(crate) time: f64,
    /// Seconds of a round.
    pub(crate) period: f64,
    running_since: Option<(Instant, f64)>,
}

impl Default for Clock {
    fn default() -> Self {
        Self { time: 0.0, period: PERIOD, running_since: None }
    }
}

impl Clock {
    pub(crate) fn is_running(&self) -> bool {
        self.running_since.is_some()
    }

    /// Starts or stops.
    pub(crate) fn toggle(&mut self) {
        self.running_since = match self.running_since {
            Some(_) => None,
            None => Some((Instant::now(), self.time)),
        };
    }

    /// Moves to a time, and goes on from there if it runs.
    pub(crate) fn set(&mut self, time: f64) {
        self.time = time.clamp(0.0, 1.0);
        if let Some(since) = &mut self.running_since {
            *since = (Instant::now(), self.time);
        }
    }

    /// Lets time pass. True if it moved.
    pub(crate) fn advance(&mut self) -> bool {
        let Some((since, from)) = self.running_since else { return false };
        self.time = (from + since.elapsed().as_secs_f64() / self.period.max(0.01)).fract();
        true
    }
}
