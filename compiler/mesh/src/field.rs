//! What a mesher asks a field.

use std::ops::ControlFlow;

use chiaro_field::{Bounds, Evaluator, Graph, Look, Painter};
use chiaro_vocabulary::cpu::Dual;

use crate::Error;

/// A field that is asked for many values at once, so that whoever implements it may spread them over threads.
pub trait Field {
    /// A box around the solid.
    fn bounds(&self) -> Bounds;
    /// The greatest slope of its values anywhere.
    fn lipschitz(&self) -> f64;
    /// The values at these points, in millimetres: negative inside.
    fn distances(&self, points: &[[f64; 3]]) -> Vec<f64>;
    /// The values at these points, with their gradients.
    fn gradients(&self, points: &[[f64; 3]]) -> Vec<Dual>;
    /// How the surface looks at these points, which are near it.
    fn looks(&self, points: &[[f64; 3]]) -> Vec<Look>;
    /// The looks of all materials, by the numbers of their paints.
    fn materials(&self) -> Vec<Look>;
    /// The look of all of the surface, if it has only one material.
    fn only_look(&self) -> Option<Look>;
}

/// The field of a graph while its live parameters have certain values.
#[derive(Debug)]
pub struct GraphField<'a> {
    evaluator: Evaluator,
    painter: Painter<'a>,
}

impl<'a> GraphField<'a> {
    /// For these values of the live parameters in the order of their ids.
    pub fn new(graph: &'a Graph, parameters: &[f64]) -> Self {
        Self { evaluator: Evaluator::new(graph, parameters), painter: Painter::new(graph, parameters) }
    }
}

impl Field for GraphField<'_> {
    fn bounds(&self) -> Bounds {
        self.evaluator.bounds()
    }

    fn lipschitz(&self) -> f64 {
        self.evaluator.lipschitz()
    }

    fn distances(&self, points: &[[f64; 3]]) -> Vec<f64> {
        points.iter().map(|point| self.evaluator.distance(*point)).collect()
    }

    fn gradients(&self, points: &[[f64; 3]]) -> Vec<Dual> {
        points.iter().map(|point| self.evaluator.gradient(*point)).collect()
    }

    fn looks(&self, points: &[[f64; 3]]) -> Vec<Look> {
        points.iter().map(|point| self.painter.look(&self.evaluator, *point)).collect()
    }

    fn materials(&self) -> Vec<Look> {
        self.painter.materials().to_vec()
    }

    fn only_look(&self) -> Option<Look> {
        self.painter.only()
    }
}

/// What a mesher is doing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Looking for the cells that the surface goes through.
    Searching,
    /// Finding where the surface crosses the edges of cells.
    Crossing,
    /// Placing vertices.
    Placing,
    /// Merging triangles.
    Merging,
    /// Asking for materials.
    Painting,
}

/// How far a mesher is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// What it is doing.
    pub stage: Stage,
    /// How many steps of that are done.
    pub done: usize,
    /// How many there are.
    pub of: usize,
}

/// Is told how far the mesher is, and answers whether it shall go on.
pub type Watch<'a> = dyn FnMut(Progress) -> ControlFlow<()> + 'a;

/// So many points are asked for at once.
const BATCH: usize = 1 << 14;

/// A field that is watched while it is asked.
pub(crate) struct Sampler<'a> {
    field: &'a dyn Field,
    watch: &'a mut Watch<'a>,
}

impl<'a> Sampler<'a> {
    pub(crate) fn new(field: &'a dyn Field, watch: &'a mut Watch<'a>) -> Self {
        Self { field, watch }
    }

    /// The field, for what is asked of it once.
    pub(crate) fn field(&self) -> &'a dyn Field {
        self.field
    }

    /// The values at the points that the items stand for.
    pub(crate) fn distances<T>(
        &mut self,
        stage: Stage,
        items: &[T],
        point: impl Fn(&T) -> [f64; 3],
    ) -> Result<Vec<f64>, Error> {
        self.in_batches(stage, items, point, |field, points| numbers(points, field.distances(points), |value| *value))
    }

    /// The same with gradients.
    pub(crate) fn gradients<T>(
        &mut self,
        stage: Stage,
        items: &[T],
        point: impl Fn(&T) -> [f64; 3],
    ) -> Result<Vec<Dual>, Error> {
        self.in_batches(stage, items, point, |field, points| {
            numbers(points, field.gradients(points), |dual: &Dual| dual.value)
        })
    }

    /// How the surface looks at the points that the items stand for.
    pub(crate) fn looks<T>(
        &mut self,
        stage: Stage,
        items: &[T],
        point: impl Fn(&T) -> [f64; 3],
    ) -> Result<Vec<Look>, Error> {
        self.in_batches(stage, items, point, |field, points| Ok(field.looks(points)))
    }

    pub(crate) fn tell(&mut self, stage: Stage, done: usize, of: usize) -> Result<(), Error> {
        match (self.watch)(Progress { stage, done, of }) {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(()) => Err(Error::Cancelled),
        }
    }

    fn in_batches<T, R>(
        &mut self,
        stage: Stage,
        items: &[T],
        point: impl Fn(&T) -> [f64; 3],
        ask: impl Fn(&dyn Field, &[[f64; 3]]) -> Result<Vec<R>, Error>,
    ) -> Result<Vec<R>, Error> {
        let mut answers = Vec::with_capacity(items.len());
        for batch in items.chunks(BATCH) {
            let points: Vec<[f64; 3]> = batch.iter().map(&point).collect();
            answers.extend(ask(self.field, &points)?);
            self.tell(stage, answers.len(), items.len())?;
        }
        Ok(answers)
    }
}

/// The answers at these points, if the values of all of them are numbers.
fn numbers<R>(points: &[[f64; 3]], answers: Vec<R>, value: impl Fn(&R) -> f64) -> Result<Vec<R>, Error> {
    match answers.iter().position(|answer| value(answer).is_nan()) {
        Some(index) => Err(Error::NotANumber { point: points[index] }),
        None => Ok(answers),
    }
}
