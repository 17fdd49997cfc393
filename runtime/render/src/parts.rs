//! Cutting a picture into parts so small that no driver's watchdog ends them.

use std::time::Duration;

use crate::uniform::Part;

/// A part should take between these times.
const WORTH_A_DISPATCH: Duration = Duration::from_millis(30);
const SOON_ENOUGH: Duration = Duration::from_millis(120);
/// The edge of the first parts, and of the smallest, in pixels: multiples of `TILE` in `choose.wgsl`.
const FIRST_EDGE: u32 = 64;
const LEAST_EDGE: u32 = 32;
/// The edge of the largest, for which buffers have to have room.
const MOST_EDGE: u32 = 1024;

/// The parts of one sample of a picture, row by row.
#[derive(Clone, Debug)]
pub(crate) struct Parts {
    size: [u32; 2],
    /// The edge of parts, adapted to the time they take.
    edge: u32,
    /// Where the next part starts, and the height of its row.
    next: [u32; 2],
    row: u32,
}

impl Parts {
    /// Of a picture of this size.
    pub(crate) fn new(size: [u32; 2]) -> Self {
        Self { size, edge: FIRST_EDGE, next: [0; 2], row: FIRST_EDGE }
    }

    /// The most pixels that a part has.
    pub(crate) fn most_pixels(&self) -> u64 {
        self.size.into_iter().map(|edge| u64::from(edge.min(MOST_EDGE))).product()
    }

    /// The part to draw next.
    pub(crate) fn current(&self) -> Part {
        let size = [self.edge.min(self.size[0] - self.next[0]), self.row.min(self.size[1] - self.next[1])];
        Part { origin: self.next, size }
    }

    /// Goes on after the current part took this long; true if it was the last.
    pub(crate) fn advance(&mut self, took: Duration) -> bool {
        self.next[0] += self.current().size[0];
        if took > SOON_ENOUGH {
            self.edge = (self.edge / 2).max(LEAST_EDGE);
        } else if took < WORTH_A_DISPATCH {
            self.edge = (self.edge * 2).min(MOST_EDGE);
        }
        if self.next[0] < self.size[0] {
            return false;
        }
        self.next = [0, self.next[1] + self.row.min(self.size[1] - self.next[1])];
        self.row = self.edge;
        if self.next[1] < self.size[1] {
            return false;
        }
        self.restart();
        true
    }

    /// Starts again with the first part.
    pub(crate) fn restart(&mut self) {
        self.next = [0; 2];
        self.row = self.edge;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_cover_every_pixel_once_however_long_they_take() {
        for times in [[0, 0, 0], [500, 500, 500], [0, 500, 50], [10, 200, 10]] {
            let size = [301, 187];
            let mut parts = Parts::new(size);
            for _ in 0..3 {
                let mut covered = vec![0; (size[0] * size[1]) as usize];
                for step in 0.. {
                    let Part { origin, size: extent } = parts.current();
                    for y in origin[1]..origin[1] + extent[1] {
                        for x in origin[0]..origin[0] + extent[0] {
                            covered[(y * size[0] + x) as usize] += 1;
                        }
                    }
                    if parts.advance(Duration::from_millis(times[step % 3])) {
                        break;
                    }
                }
                assert!(covered.iter().all(|&count| count == 1));
            }
        }
    }
}
