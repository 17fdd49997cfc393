//! Points: where shapes are asked.

use chiaro_field::{Point, PointId};
use chiaro_solid::{Affine, Scalar};
use chiaro_vocabulary::rows::{CONFINE_DISC, PLANE_POINT};
use naga::{BinaryOperator, VectorSize};

use super::Scope;
use crate::build::Value;

impl Scope<'_, '_> {
    /// The point, of two or three coordinates.
    pub(super) fn point(&mut self, id: PointId) -> Value {
        if let Some(&value) = self.points.get(&id) {
            return value;
        }
        let graph = self.emission.graph;
        let value = match &graph.points[id.0 as usize] {
            Point::World => self.builder.argument(),
            Point::Affine(map, from) => {
                let point = self.point(*from);
                let mapped = match self.dimension(*from) {
                    3 => self.mapped::<3>(map, point),
                    _ => self.mapped::<2>(map, point),
                };
                // What is asked but once is written where it is asked.
                match self.emission.parts.uses_of_point(id) {
                    0 | 1 => mapped,
                    _ => self.name_point(mapped, id, "point"),
                }
            }
            Point::Warp(row, arguments, from) => {
                let point = self.space_point(*from);
                let warped = self.call_row(row, point, arguments);
                self.name_point(warped, id, row.name)
            }
            Point::Confined(radius, from) => {
                let point = self.space_point(*from);
                let radius = self.scalar(radius);
                let confined = self.call(&CONFINE_DISC, &[point, radius]);
                let confined = match self.dimension(*from) {
                    3 => confined,
                    _ => self.builder.truncate(confined, VectorSize::Bi),
                };
                self.name_point(confined, id, "confined")
            }
            Point::Flattened(from) => {
                let point = self.space_point(*from);
                let flattened = match self.dimension(*from) {
                    3 => self.call(&PLANE_POINT, &[point]),
                    _ => point,
                };
                self.name_point(flattened, id, "flattened")
            }
        };
        self.points.insert(id, value);
        value
    }

    /// The point for a function of two coordinates.
    pub(super) fn plane_point(&mut self, id: PointId) -> Value {
        let point = self.point(id);
        match self.dimension(id) {
            2 => point,
            _ => self.builder.truncate(point, VectorSize::Bi),
        }
    }

    /// The point for a function of three coordinates.
    pub(super) fn space_point(&mut self, id: PointId) -> Value {
        let point = self.point(id);
        match self.dimension(id) {
            3 => point,
            _ => {
                let zero = self.constant(0.0);
                self.builder.compose(self.builder.types.vec3, &[point, zero])
            }
        }
    }

    /// How many coordinates the point has.
    fn dimension(&self, id: PointId) -> usize {
        let graph = self.emission.graph;
        let root = std::iter::successors(Some(id), |point| match &graph.points[point.0 as usize] {
            Point::Affine(_, from) | Point::Confined(_, from) => Some(*from),
            _ => None,
        });
        match root.last().map(|root| &graph.points[root.0 as usize]) {
            Some(Point::World) if self.emission.is_in_plane => 2,
            _ => graph.dimension(id),
        }
    }

    /// A point of N coordinates under the map, without what changes nothing.
    pub(super) fn mapped<const N: usize>(&mut self, map: &Affine, point: Value) -> Value {
        let rows = without_residues(map);
        let linear = std::array::from_fn::<_, N, _>(|i| &rows[i][..N]);
        let turned = self.mapped_linearly(linear, point);
        let shift = std::array::from_fn::<_, N, _>(|i| rows[i][3].clone());
        self.shifted(shift, turned)
    }

    fn mapped_linearly<const N: usize>(&mut self, rows: [&[Scalar]; N], point: Value) -> Value {
        let off_diagonal_zero = (0..N).all(|i| (0..N).all(|j| i == j || rows[i][j].is(0.0)));
        if off_diagonal_zero && (0..N).all(|i| rows[i][i].is(1.0)) {
            return point;
        }
        if let Some(signed) = signed_permutation(rows) {
            let components = signed.map(|(axis, negative)| {
                let component = self.builder.component(point, axis);
                if negative { self.builder.negate(component) } else { component }
            });
            return self.builder.vector(&components);
        }
        if off_diagonal_zero {
            let factor = match (1..N).all(|i| rows[i][i] == rows[0][0]) {
                true => self.scalar(&rows[0][0]),
                false => self.vector(&std::array::from_fn::<_, N, _>(|i| rows[i][i].clone())),
            };
            return self.builder.binary(BinaryOperator::Multiply, point, factor);
        }
        let columns =
            std::array::from_fn::<_, N, _>(|j| self.vector(&std::array::from_fn::<_, N, _>(|i| rows[i][j].clone())));
        let ty = if N == 3 { self.builder.types.mat3 } else { self.builder.types.mat2 };
        let matrix = self.builder.compose(ty, &columns);
        self.builder.binary(BinaryOperator::Multiply, matrix, point)
    }

    fn shifted<const N: usize>(&mut self, shift: [Scalar; N], point: Value) -> Value {
        if shift.iter().all(|component| component.is(0.0)) {
            return point;
        }
        // A moved shape reads best as its own place taken away: p - vec3(10, 0, 0).
        let constant = shift.iter().all(|component| component.constant().is_some());
        let (operator, by) = match constant {
            true => (BinaryOperator::Subtract, shift.map(|component| -component)),
            false => (BinaryOperator::Add, shift),
        };
        let by = self.vector(&by);
        self.builder.binary(operator, point, by)
    }
}

/// The rows of a map, with zeros for what rounding left of numbers that cancel out.
fn without_residues(map: &Affine) -> [[Scalar; 4]; 3] {
    const RESIDUE: f64 = 1e-15;
    let farthest = map.rows().iter().filter_map(|row| row[3].constant()).fold(1.0_f64, |most, by| most.max(by.abs()));
    map.rows().each_ref().map(|row| {
        std::array::from_fn(|column| {
            let size = if column == 3 { farthest } else { 1.0 };
            let is_residue = row[column].constant().is_some_and(|number| number.abs() < RESIDUE * size);
            if is_residue { Scalar::ZERO } else { row[column].clone() }
        })
    })
}

/// The axis each coordinate comes from and whether its sign changes, if that is all the rows do.
fn signed_permutation<const N: usize>(rows: [&[Scalar]; N]) -> Option<[(u32, bool); N]> {
    let mut signed = [(0, false); N];
    for (entry, row) in signed.iter_mut().zip(rows) {
        let axis = row.iter().position(|factor| !factor.is(0.0))?;
        let one = row[axis].is(1.0) || row[axis].is(-1.0);
        if !one || row[axis + 1..].iter().any(|factor| !factor.is(0.0)) {
            return None;
        }
        *entry = (axis as u32, row[axis].is(-1.0));
    }
    Some(signed)
}
