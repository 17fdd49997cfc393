//! Solids between outlines at successive heights, with flat sides.
//!
//! Between two heights, each straight edge of the outline becomes another one, and the quadrilateral between both is
//! divided along a diagonal into two flat triangles, as in OpenSCAD's extrusions of a few slices. A horizontal section
//! is a polygon whose corners move in proportion to the height.

use crate::flatten::default_tolerance;
use crate::region::{Contour, Point, Region, add, cross, distance, dot, scale, sub};

/// Diagonals whose lengths differ by less than this share of them are equally long.
const SAME_LENGTH: f64 = 1e-5;
/// Edges whose directions differ by less than this sine are parallel, and what is between them flat.
const PARALLEL: f64 = 1e-12;

/// The columns of a matrix that maps the plane.
pub type Matrix = [Point; 2];

/// Stages of the same height, one above the other, from z = 0 on.
#[derive(Clone, Debug, PartialEq)]
pub struct Loft {
    /// The height of all of them together, in millimetres.
    height: f64,
    /// The sides of each stage, from the lowest stage on.
    stages: Vec<Vec<Side>>,
    slope: f64,
}

/// A flat side of a stage. At any height it is a segment, between two points that move along straight lines from the
/// stage's bottom to its top.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Side {
    /// Where it starts, at the bottom and at the top.
    pub from: [Point; 2],
    /// Where it ends, at the bottom and at the top.
    pub to: [Point; 2],
}

impl Loft {
    /// The stages between the images of a region under some matrices, two or more: the outline at z = 0 and that at the
    /// top of each stage. Arcs become chords of the [default tolerance](crate::default_tolerance).
    ///
    /// Quadrilaterals are divided along the shorter diagonal. If both are equally long, it is the one that lies outside
    /// where the levels turn clockwise, or anticlockwise; of holes, the one inside.
    pub fn new(region: &Region, levels: &[Matrix], height: f64, is_clockwise: bool) -> Loft {
        let region = region.normalized();
        let outlines = region.flatten(default_tolerance(&region));
        let mut slope: f64 = 0.0;
        let stage = |pair: &[Matrix]| {
            let mut sides = Vec::new();
            for outline in &outlines {
                let is_hole = Contour::polygon(outline.iter().copied()).signed_area() < 0.0;
                let own = sides_of(outline, pair, is_hole == is_clockwise);
                slope = slope.max(steepest(&own) * (levels.len() - 1) as f64 / height);
                sides.extend(own);
            }
            sides
        };
        let stages = levels.windows(2).map(stage).collect();
        Loft { height, stages, slope }
    }

    /// The height of all stages together, in millimetres.
    pub fn height(&self) -> f64 {
        self.height
    }

    /// The sides of each stage, from the lowest on.
    pub fn stages(&self) -> &[Vec<Side>] {
        &self.stages
    }

    /// How many sides there are.
    pub fn sides(&self) -> usize {
        self.stages.iter().map(Vec::len).sum()
    }

    /// How much the distance from a section changes, at the most, for each millimetre of height.
    pub fn slope(&self) -> f64 {
        self.slope
    }

    /// All numbers that it consists of.
    pub fn numbers(&self) -> impl Iterator<Item = f64> {
        let sides = self.stages.iter().flat_map(|sides| std::iter::once(sides.len() as f64).chain(numbers_of(sides)));
        std::iter::once(self.height).chain(sides)
    }

    /// Its corners, some of them more than once.
    pub fn corners(&self) -> impl Iterator<Item = [f64; 3]> {
        let step = self.height / self.stages.len() as f64;
        self.stages.iter().enumerate().flat_map(move |(index, sides)| {
            let at = move |[x, y]: Point, level: usize| [x, y, (index + level) as f64 * step];
            sides.iter().flat_map(move |side| [0, 1].map(|level| at(side.from[level], level)))
        })
    }

    /// The smallest box around all sections, as its least and its greatest corner; `None` if there are none.
    pub fn bounds(&self) -> Option<(Point, Point)> {
        self.corners().map(|[x, y, _]| ([x, y], [x, y])).reduce(crate::measure::join)
    }

    /// The same, larger by a factor.
    pub fn scaled(&self, factor: f64) -> Loft {
        let scaled = |ends: [Point; 2]| ends.map(|end| scale(end, factor));
        let side = |side: &Side| Side { from: scaled(side.from), to: scaled(side.to) };
        let stages = self.stages.iter().map(|sides| sides.iter().map(side).collect()).collect();
        Loft { height: self.height * factor, stages, slope: self.slope }
    }
}

fn numbers_of(sides: &[Side]) -> impl Iterator<Item = f64> {
    sides.iter().flat_map(|side| side.from.into_iter().chain(side.to)).flatten()
}

/// The point's image.
fn image([x_axis, y_axis]: &Matrix, [x, y]: Point) -> Point {
    add(scale(*x_axis, x), scale(*y_axis, y))
}

/// The sides of one stage over one outline, each starting where the one before it ends.
fn sides_of(outline: &[Point], levels: &[Matrix], back_if_equal: bool) -> Vec<Side> {
    let at = |point: Point| [image(&levels[0], point), image(&levels[1], point)];
    let tops = &levels[1];
    let is_flattened = cross(tops[0], tops[1]) == 0.0;
    let next = outline.iter().cycle().skip(1);
    let mut sides = Vec::with_capacity(2 * outline.len());
    for (from, to) in outline.iter().zip(next) {
        let (from, to) = (at(*from), at(*to));
        let [bottom, top] = [0, 1].map(|level| sub(to[level], from[level]));
        if cross(bottom, top).abs() <= PARALLEL * dot(bottom, bottom).max(dot(top, top)) && dot(bottom, top) >= 0.0 {
            sides.push(Side { from, to });
            continue;
        }
        let (rising, falling) = (distance(from[0], to[1]), distance(to[0], from[1]));
        let is_equal = (rising - falling).abs() <= 0.5 * SAME_LENGTH * (rising + falling);
        let rises = if is_equal { !back_if_equal } else { rising < falling };
        // Where the top has no area, the shorter diagonal would leave parts without thickness.
        let diagonal = if rises != is_flattened { [from[0], to[1]] } else { [to[0], from[1]] };
        sides.push(Side { from, to: diagonal });
        sides.push(Side { from: diagonal, to });
    }
    sides
}

/// The greatest speed that sides and corners of a closed outline have across the nearest points of the plane, between
/// the bottom, at 0, and the top, at 1.
///
/// A side stays parallel to itself, so that all its points have one speed across it. Points nearest to a corner are in
/// directions between those across its two sides; the corner's speed in such a direction is greatest in its own
/// direction if that is between them, and else in that of a side.
fn steepest(sides: &[Side]) -> f64 {
    let across: Vec<Option<Point>> = sides.iter().map(across).collect();
    let mut greatest: f64 = 0.0;
    for (index, side) in sides.iter().enumerate() {
        let Some(normal) = across[index] else { continue };
        let velocity = sub(side.to[1], side.to[0]);
        greatest = greatest.max(dot(velocity, normal).abs());
        let following = (1..=sides.len()).find_map(|step| across[(index + step) % sides.len()]);
        let Some(next) = following else { continue };
        let turn = cross(normal, next);
        let is_between =
            |direction: Point| turn * cross(normal, direction) >= 0.0 && turn * cross(direction, next) >= 0.0;
        let is_spike = dot(normal, next) < -0.999;
        if is_spike || is_between(velocity) || is_between(scale(velocity, -1.0)) {
            greatest = greatest.max(distance(side.to[0], side.to[1]));
        }
    }
    greatest
}

/// The unit vector across a side, the same at any height; none if it is a point at all of them.
fn across(side: &Side) -> Option<Point> {
    let [bottom, top] = [0, 1].map(|level| sub(side.to[level], side.from[level]));
    let along = if dot(bottom, bottom) >= dot(top, top) { bottom } else { top };
    let length = along[0].hypot(along[1]);
    (length > 0.0).then(|| [along[1] / length, -along[0] / length])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn turned(degrees: f64) -> Matrix {
        let (sin, cos) = degrees.to_radians().sin_cos();
        [[cos, sin], [-sin, cos]]
    }

    fn hexagon(stages: usize, twist: f64) -> Loft {
        let levels: Vec<Matrix> = (0..=stages).map(|k| turned(-twist * k as f64 / stages as f64)).collect();
        Loft::new(&Region::ngon(10.0, 6), &levels, 20.0, twist > 0.0)
    }

    /// The signed distance of a point from the section at its height.
    fn distance_in_section(loft: &Loft, [x, y, z]: [f64; 3]) -> f64 {
        let at = (z / loft.height()).clamp(0.0, 1.0) * loft.stages().len() as f64;
        let stage = (at.floor() as usize).min(loft.stages().len() - 1);
        let t = at - stage as f64;
        let between = |ends: [Point; 2]| add(scale(ends[0], 1.0 - t), scale(ends[1], t));
        let corners: Vec<Point> = loft.stages()[stage].iter().map(|side| between(side.from)).collect();
        Region::polygon(&corners, None).signed_distance([x, y])
    }

    #[test]
    fn a_turned_hexagon_has_stages_of_twelve_triangles() {
        let loft = hexagon(2, 60.0);
        assert_eq!((loft.stages().len(), loft.sides()), (2, 24));
        // Halfway up a stage there are twelve corners: of the hexagon's own edges and of the diagonals.
        let corner = 10.0 * 15f64.to_radians().cos();
        for k in 0..12 {
            let direction = f64::to_radians(30.0 * f64::from(k) - 15.0);
            let [x, y] = [corner * direction.cos(), corner * direction.sin()];
            assert!(distance_in_section(&loft, [x, y, 5.0]).abs() < 1e-9, "{k}");
        }
        let (min, max) = loft.bounds().unwrap();
        assert!(distance(min, [-10.0, -10.0]) < 1e-9 && distance(max, [10.0, 10.0]) < 1e-9);
    }

    #[test]
    fn what_only_tapers_has_flat_sides() {
        let levels = [[[1.0, 0.0], [0.0, 1.0]], [[0.5, 0.0], [0.0, 0.5]]];
        let loft = Loft::new(&Region::ngon(10.0, 5), &levels, 4.0, false);
        assert_eq!(loft.sides(), 5);
        // The middle of a side moves in by less than a corner, and points beyond corners see the corner move.
        assert!((loft.slope() - 5.0 / 4.0).abs() < 1e-12);
    }

    #[test]
    fn sections_change_no_faster_than_the_slope() {
        let shapes = [
            Region::ngon(5.0, 3),
            Region::polygon(&[[0.0, 0.0], [9.0, 0.0], [9.0, 2.0], [2.0, 2.0], [2.0, 7.0], [0.0, 7.0]], None),
            Region::polygon(&[[4.0, -1.0], [8.0, -2.0], [8.0, 3.0]], None),
        ];
        for (shape, twist, top) in
            shapes.iter().flat_map(|shape| [(shape, 50.0, 1.0), (shape, -80.0, 0.4), (shape, 0.0, 2.0)])
        {
            let level = |t: f64| turned(-twist * t).map(|[x, y]| [x * (1.0 + t), y * (1.0 + t * (top - 1.0))]);
            let levels: Vec<Matrix> = (0..=3).map(|k| level(f64::from(k) / 3.0)).collect();
            let loft = Loft::new(shape, &levels, 6.0, twist > 0.0);
            let mut steepest = 0.0f64;
            for k in 0..4000u32 {
                let part = |prime: u32| f64::from(k.wrapping_mul(prime) % 4001) / 4001.0;
                let point = [30.0 * part(7) - 15.0, 30.0 * part(1013) - 15.0, 5.9 * part(2003)];
                let above = [point[0], point[1], point[2] + 0.01];
                let change = distance_in_section(&loft, above) - distance_in_section(&loft, point);
                steepest = steepest.max(change.abs() / 0.01);
            }
            assert!(steepest <= loft.slope() + 1e-6, "{steepest} of {}", loft.slope());
            assert!(steepest >= 0.6 * loft.slope(), "{} is far above {steepest}", loft.slope());
        }
    }
}
