//! Facts at certain values of the live parameters.

use chiaro_solid::{Affine, Scalar, singular};
use chiaro_vocabulary::{Bounds, Interval};

use crate::extent::{Extent, Measure, Placement, Ranges};
use crate::graph::{Graph, PointId};
use crate::matrix::{inverse, linear};

impl Graph {
    /// The box of each node while the live parameters, in the order of their ids, have these values. It is within
    /// the box of its facts, which is for all their values.
    pub fn bounds_at(&self, parameters: &[f64]) -> Vec<Bounds> {
        if self.slots.is_empty() {
            return self.facts.iter().map(|facts| facts.bounds).collect();
        }
        let values = Values { parameters };
        let measure = Measure { points: &self.points, nodes: &self.nodes, ranges: &values };
        let mut extents: Vec<Extent> = Vec::with_capacity(self.nodes.len());
        for node in &self.nodes {
            extents.push(measure.in_world(node, &extents));
        }
        extents.iter().zip(&self.facts).map(|(extent, facts)| extent.bounds.intersection(&facts.bounds)).collect()
    }
}

/// The numbers' values while the parameters have theirs.
struct Values<'a> {
    parameters: &'a [f64],
}

impl Ranges for Values<'_> {
    fn range(&self, number: &Scalar) -> Interval {
        Interval::point(number.value(self.parameters))
    }

    fn placement(&self, map: &Affine, _: PointId) -> Placement {
        let rows = inverse(&map.value(self.parameters));
        let stretch = singular::greatest(&linear(&rows));
        Placement { rows: rows.map(|row| row.map(Interval::point)), stretch }
    }
}
