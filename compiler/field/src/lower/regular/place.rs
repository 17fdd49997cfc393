//! How what is asked at a point lies in the coordinates of a frame.

use chiaro_solid::Affine;
use chiaro_vocabulary::rows;

use super::linear::Linear;
use crate::build::Builder;
use crate::graph::{Point, PointId};
use crate::hull::{Vec3, dot, length, scale};
use crate::matrix;

/// Lengths and angles that differ by less than this part count as equal.
pub(super) const SAME: f64 = 1e-9;

/// A map with a constant linear part.
#[derive(Clone, Debug)]
pub(super) struct Map {
    linear: [Vec3; 3],
    shift: [Linear; 3],
}

/// The way from where a shape is asked to a frame.
#[derive(Clone, Debug)]
pub(super) struct Place {
    /// The map to the frame; of a turned profile, to the half plane of radius and height.
    pub(super) map: Map,
    /// From the solid that a profile is turned to, to the frame.
    pub(super) turned: Option<Turned>,
}

/// What a profile is turned to.
#[derive(Clone, Debug)]
pub(super) struct Turned {
    /// From its coordinates, where z is its axis, to the frame.
    pub(super) map: Map,
    /// Whether its sides are flat.
    pub(super) facets: bool,
}

impl Place {
    /// How a point's coordinates lie in those of a frame; none if they are bent, or turn with live numbers.
    pub(super) fn of(builder: &Builder, point: PointId, frame: PointId) -> Option<Place> {
        let mut map = Map::identity();
        let mut profile: Option<(Map, bool)> = None;
        let mut at = point;
        while at != frame {
            match builder.get_point(at) {
                Point::Affine(undone, parent) => {
                    let inverse;
                    let forward = match builder.forward(at) {
                        Some(forward) => forward,
                        None => {
                            inverse = undone.inverse();
                            &inverse
                        }
                    };
                    map = Map::new(forward, builder.dimension(at) == 2)?.after(&map);
                    at = *parent;
                }
                Point::Warp(row, _, parent) if **row == rows::SLICE => at = *parent,
                Point::Warp(row, _, parent) if **row == rows::REVOLVE || **row == rows::REVOLVE_FACETS => {
                    if profile.is_some() {
                        return None;
                    }
                    profile = Some((map, **row == rows::REVOLVE_FACETS));
                    map = Map::identity();
                    at = *parent;
                }
                _ => return None,
            }
        }
        match profile {
            None => Some(Place { map, turned: None }),
            Some((profile, facets)) => Some(Place { map: profile, turned: Some(Turned { map, facets }) }),
        }
    }
}

impl Map {
    pub(super) fn identity() -> Self {
        let linear = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        Self { linear, shift: Default::default() }
    }

    /// The map of a solid; of a plane shape, what it does to x and y.
    fn new(map: &Affine, plane: bool) -> Option<Self> {
        let mut linear = Self::identity().linear;
        let mut shift: [Linear; 3] = Default::default();
        let axes = if plane { 2 } else { 3 };
        for (row, entries) in map.rows().iter().enumerate().take(axes) {
            for column in 0..axes {
                linear[row][column] = entries[column].constant()?;
            }
            shift[row] = Linear::from(&entries[3]);
        }
        Some(Self { linear, shift })
    }

    fn after(&self, inner: &Map) -> Map {
        let entry = |i: usize, j: usize| (0..3).map(|k| self.linear[i][k] * inner.linear[k][j]).sum();
        let linear = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
        Map { linear, shift: self.point(&inner.shift) }
    }

    /// Where a point comes to.
    pub(super) fn point(&self, point: &[Linear; 3]) -> [Linear; 3] {
        std::array::from_fn(|i| {
            let terms = point.iter().enumerate();
            terms.fold(self.shift[i].clone(), |sum, (k, coordinate)| sum.plus(coordinate, self.linear[i][k]))
        })
    }

    /// Where a constant direction comes to.
    pub(super) fn direction(&self, direction: Vec3) -> Vec3 {
        self.linear.map(|row| dot(row, direction))
    }

    /// The point that comes to one of the frame, by a map that multiplies all lengths by this.
    pub(super) fn point_below(&self, point: &[Linear; 3], factor: f64) -> [Linear; 3] {
        let from: [Linear; 3] = std::array::from_fn(|i| point[i].clone().plus(&self.shift[i], -1.0));
        let square = factor * factor;
        std::array::from_fn(|j| (0..3).fold(Linear::default(), |sum, i| sum.plus(&from[i], self.linear[i][j] / square)))
    }

    /// A direction of the frame by the transpose of the map.
    pub(super) fn direction_below(&self, direction: Vec3) -> Vec3 {
        std::array::from_fn(|j| (0..3).map(|i| self.linear[i][j] * direction[i]).sum())
    }

    /// What lengths are multiplied by, if all are by the same.
    pub(super) fn factor(&self) -> Option<f64> {
        let columns: [Vec3; 3] = std::array::from_fn(|j| std::array::from_fn(|i| self.linear[i][j]));
        let factor = length(columns[2]);
        let uniform = (0..3).all(|j| (length(columns[j]) - factor).abs() <= SAME * factor);
        let square = (0..3).all(|j| dot(columns[j], columns[(j + 1) % 3]).abs() <= SAME * factor * factor);
        (uniform && square).then_some(factor)
    }

    /// The half space that one of the shape, with a normal of length 1, comes to; and what distances between parallel
    /// planes are divided by.
    pub(super) fn plane(&self, normal: Vec3, offset: &Linear) -> (Vec3, Linear, f64) {
        let rows = self.linear.map(|row| [row[0], row[1], row[2], 0.0]);
        let inverse = matrix::inverse(&rows);
        let turned: Vec3 = std::array::from_fn(|i| (0..3).map(|k| inverse[k][i] * normal[k]).sum());
        let weight = length(turned);
        let turned = scale(turned, 1.0 / weight);
        let shifted = (0..3).fold(offset.times(1.0 / weight), |sum, i| sum.plus(&self.shift[i], turned[i]));
        (turned, shifted, weight)
    }

    /// The half space of the shape that comes to one of the frame; and what distances between parallel planes are
    /// multiplied by.
    pub(super) fn plane_below(&self, normal: Vec3, offset: &Linear) -> (Vec3, Linear, f64) {
        let pulled = self.direction_below(normal);
        let weight = length(pulled);
        let shifted = (0..3).fold(offset.clone(), |sum, i| sum.plus(&self.shift[i], -normal[i]));
        (scale(pulled, 1.0 / weight), shifted.times(1.0 / weight), 1.0 / weight)
    }
}
