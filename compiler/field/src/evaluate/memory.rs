//! What a thread remembers during a query, and the memory it keeps for the next.

use std::cell::RefCell;

use chiaro_vocabulary::cpu::{Dual, Number, Scratch};

/// Values of points and nodes that are asked for more than once in a query.
pub(super) struct Memory<N> {
    /// The number of the query. What is remembered of another one counts as forgotten.
    query: u64,
    points: Vec<(u64, [N; 3])>,
    nodes: Vec<(u64, N)>,
    pub(super) scratch: Scratch<N>,
    pub(super) arguments: Vec<N>,
}

impl<N: Number> Memory<N> {
    fn new() -> Self {
        Self { query: 0, points: Vec::new(), nodes: Vec::new(), scratch: Scratch::new(), arguments: Vec::new() }
    }

    /// Forgets the query before, and makes room for so many points and nodes.
    pub(super) fn begin(&mut self, points: usize, nodes: usize) {
        self.query += 1;
        if self.points.len() < points {
            self.points.resize(points, (0, [N::of(0.0); 3]));
        }
        if self.nodes.len() < nodes {
            self.nodes.resize(nodes, (0, N::of(0.0)));
        }
    }

    pub(super) fn point(&self, index: u32) -> Option<[N; 3]> {
        let (query, point) = self.points[index as usize];
        (query == self.query).then_some(point)
    }

    pub(super) fn keep_point(&mut self, index: u32, point: [N; 3]) {
        self.points[index as usize] = (self.query, point);
    }

    pub(super) fn node(&self, index: u32) -> Option<N> {
        let (query, value) = self.nodes[index as usize];
        (query == self.query).then_some(value)
    }

    pub(super) fn keep_node(&mut self, index: u32, value: N) {
        self.nodes[index as usize] = (self.query, value);
    }
}

/// A number type that each thread has memory for.
pub(super) trait Remembered: Number {
    /// Calls `ask` with the thread's memory.
    fn with_memory<R>(ask: impl FnOnce(&mut Memory<Self>) -> R) -> R;
    /// The number without its gradient.
    fn plain(self) -> f64;
}

impl Remembered for f64 {
    fn with_memory<R>(ask: impl FnOnce(&mut Memory<Self>) -> R) -> R {
        thread_local! {
            static MEMORY: RefCell<Memory<f64>> = RefCell::new(Memory::new());
        }
        MEMORY.with_borrow_mut(ask)
    }

    fn plain(self) -> f64 {
        self
    }
}

impl Remembered for Dual {
    fn with_memory<R>(ask: impl FnOnce(&mut Memory<Self>) -> R) -> R {
        thread_local! {
            static MEMORY: RefCell<Memory<Dual>> = RefCell::new(Memory::new());
        }
        MEMORY.with_borrow_mut(ask)
    }

    fn plain(self) -> f64 {
        self.value
    }
}
