//! A field whose questions are answered by all processors.

use std::num::NonZero;
use std::panic::resume_unwind;
use std::thread;

use chiaro_compiler::field::Look;
use chiaro_compiler::vocabulary::Bounds;
use chiaro_compiler::vocabulary::cpu::Dual;
use chiaro_mesh::Field;

/// A field, asked from several threads at once.
pub(crate) struct Parallel<F> {
    field: F,
    threads: usize,
}

impl<F: Field + Sync> Parallel<F> {
    pub(crate) fn new(field: F) -> Self {
        Self { field, threads: thread::available_parallelism().map_or(1, NonZero::get) }
    }

    /// The answers to all points, some from each thread.
    fn spread<R: Send>(&self, points: &[[f64; 3]], ask: impl Fn(&F, &[[f64; 3]]) -> Vec<R> + Sync) -> Vec<R> {
        /// Fewer points than this are not worth a thread.
        const FEWEST: usize = 256;
        /// Room for the deepest graphs, as the first thread has.
        const STACK_BYTES: usize = 64 << 20;
        let part = points.len().div_ceil(self.threads).max(FEWEST);
        if points.len() <= part {
            return ask(&self.field, points);
        }
        let ask = &ask;
        thread::scope(|scope| {
            let start = |points| {
                let work = move || ask(&self.field, points);
                thread::Builder::new().stack_size(STACK_BYTES).spawn_scoped(scope, work).map_err(|_| points)
            };
            let parts: Vec<_> = points.chunks(part).map(start).collect();
            let answer = |part| match part {
                Ok(running) => thread::ScopedJoinHandle::join(running).unwrap_or_else(|panic| resume_unwind(panic)),
                // Where the system has no room for another thread, this one does its work.
                Err(points) => ask(&self.field, points),
            };
            parts.into_iter().flat_map(answer).collect()
        })
    }
}

impl<F: Field + Sync> Field for Parallel<F> {
    fn bounds(&self) -> Bounds {
        self.field.bounds()
    }

    fn lipschitz(&self) -> f64 {
        self.field.lipschitz()
    }

    fn distances(&self, points: &[[f64; 3]]) -> Vec<f64> {
        self.spread(points, |field, points| field.distances(points))
    }

    fn gradients(&self, points: &[[f64; 3]]) -> Vec<Dual> {
        self.spread(points, |field, points| field.gradients(points))
    }

    fn looks(&self, points: &[[f64; 3]]) -> Vec<Look> {
        self.spread(points, |field, points| field.looks(points))
    }

    fn materials(&self) -> Vec<Look> {
        self.field.materials()
    }

    fn only_look(&self) -> Option<Look> {
        self.field.only_look()
    }
}
