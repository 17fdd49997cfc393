//! How large a picture may be that has to come at once.

use std::time::Duration;

/// A small picture should take no longer than this.
const QUICK: Duration = Duration::from_millis(50);
/// The parts of the full width and height that small pictures have.
const SCALES: [f64; 6] = [1.0, 0.75, 0.5, 0.35, 0.25, 0.15];
/// No picture is smaller than this.
const LEAST_EDGE: u32 = 64;

/// What a sample of a pixel took lately.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Pace {
    seconds_per_pixel: Option<f64>,
}

impl Pace {
    /// The largest size that can be drawn at once.
    pub(crate) fn small(&self, full: [u32; 2]) -> [u32; 2] {
        let scaled = |scale: f64| full.map(|edge| ((f64::from(edge) * scale) as u32).max(LEAST_EDGE.min(edge)));
        let Some(seconds_per_pixel) = self.seconds_per_pixel else { return scaled(0.25) };
        let is_quick = |size: &[u32; 2]| pixels(*size) * seconds_per_pixel <= QUICK.as_secs_f64();
        let least = scaled(SCALES[SCALES.len() - 1]);
        SCALES.into_iter().map(scaled).find(is_quick).unwrap_or(least)
    }

    /// Remembers how long a sample took.
    pub(crate) fn note(&mut self, size: [u32; 2], took: Duration) {
        let now = took.as_secs_f64() / pixels(size).max(1.0);
        // The first sample of a scene includes what drivers compile then: it counts less than what follows.
        self.seconds_per_pixel =
            Some(self.seconds_per_pixel.map_or(now, |before| now.min(before + 0.3 * (now - before))));
    }
}

fn pixels(size: [u32; 2]) -> f64 {
    f64::from(size[0]) * f64::from(size[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slow_scenes_are_drawn_small_and_quick_ones_in_full() {
        let full = [960, 540];
        let mut pace = Pace::default();
        assert_eq!(pace.small(full), [240, 135]);
        pace.note([240, 135], Duration::from_millis(1));
        assert_eq!(pace.small(full), full);
        for _ in 0..20 {
            pace.note([240, 135], Duration::from_secs(2));
        }
        assert_eq!(pace.small(full), [144, 81]);
        assert_eq!(pace.small([40, 30]), [40, 30]);
    }
}
