//! Where things are: boxes around what nodes say is solid.
//!
//! A shape's row knows its box where the shape is asked; that box is pulled back through the chain of points to the
//! point the scene is asked about. Joints and offsets need more than the solid's box: the box of all points whose
//! value is at most δ. It is the solid's box grown by δ times the node's *growth*.

use chiaro_solid::{Affine, Profile, Scalar};
use chiaro_vocabulary::{Bounds, Class, Interval, Row, rows};
use rustc_hash::FxHashMap;

use crate::graph::{Node, NodeId, Operation, Point, PointId};

/// The point that the scene is asked about.
pub(crate) const WORLD: PointId = PointId(0);

/// Where a node's value is small.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Extent {
    /// A box around the points with values of at most zero.
    pub(crate) bounds: Bounds,
    /// The points with values of at most δ > 0 are within δ times this of the box, along each axis (for a single
    /// shape even as the crow flies). Infinite where that is not known.
    pub(crate) growth: f64,
    /// How far the box may grow before it meets the rim of a [`Point::Confined`] that the node is asked at, from where
    /// on small values reach out without end. Infinite where there is none.
    pub(crate) room: f64,
}

/// The ranges of numbers and maps: over all values of the live parameters, or at some of them.
pub(crate) trait Ranges {
    /// The values that a number takes.
    fn range(&self, number: &Scalar) -> Interval;
    /// The map that undoes this point's map.
    fn placement(&self, map: &Affine, point: PointId) -> Placement;
}

/// A map from where a shape is asked to where it stands.
pub(crate) struct Placement {
    /// Its rows.
    pub(crate) rows: [[Interval; 4]; 3],
    /// What it makes lengths longer by at the most.
    pub(crate) stretch: f64,
}

/// Measures extents in a graph, finished or not.
pub(crate) struct Measure<'a> {
    pub(crate) points: &'a [Point],
    pub(crate) nodes: &'a [Node],
    pub(crate) ranges: &'a dyn Ranges,
}

/// Extents by node and by the point whose coordinates they are in.
type Memo = FxHashMap<(NodeId, PointId), Extent>;

impl Extent {
    const EVERYWHERE: Extent = Extent { bounds: Bounds::ALL, growth: 0.0, room: f64::INFINITY };
    const NOWHERE: Extent = Extent { bounds: Bounds::EMPTY, growth: f64::INFINITY, room: f64::INFINITY };

    fn exact(bounds: Bounds) -> Extent {
        Extent { bounds, growth: 1.0, room: f64::INFINITY }
    }

    /// A box around the points whose value is at most `value`.
    pub(crate) fn within(&self, value: f64) -> Bounds {
        self.grown(value).bounds
    }

    /// The growth, if it holds however far the box grows; else infinite.
    pub(crate) fn endless_growth(&self) -> f64 {
        if self.room == f64::INFINITY { self.growth } else { f64::INFINITY }
    }

    /// The extent of the node with its values reduced by `value`.
    fn grown(&self, value: f64) -> Extent {
        if value <= 0.0 || self.bounds == Bounds::ALL {
            return *self;
        }
        let by = self.growth * value;
        if by.is_finite() && by < self.room {
            Extent { bounds: self.bounds.inflate(by), growth: self.growth, room: self.room - by }
        } else {
            Extent::EVERYWHERE
        }
    }

    fn union(extents: impl Iterator<Item = Extent>) -> Extent {
        let none = Extent { bounds: Bounds::EMPTY, growth: 0.0, room: f64::INFINITY };
        extents.fold(none, |all, extent| Extent {
            bounds: all.bounds.union(&extent.bounds),
            growth: all.growth.max(extent.growth),
            room: all.room.min(extent.room),
        })
    }

    /// Where all values are small. Boxes that don't meet may do so when they are grown, which is not followed.
    fn intersection(extents: impl Iterator<Item = Extent>) -> Extent {
        let all = extents.fold(Extent::EVERYWHERE, |all, extent| Extent {
            bounds: all.bounds.intersection(&extent.bounds),
            growth: all.growth.max(if extent.bounds == Bounds::ALL { 0.0 } else { extent.growth }),
            room: all.room.min(extent.room),
        });
        if all.bounds.is_empty() { Extent::NOWHERE } else { all }
    }
}

impl Measure<'_> {
    /// A node's extent in the world, from the extents of all nodes before it.
    pub(crate) fn in_world(&self, node: &Node, known: &[Extent]) -> Extent {
        self.extent(node, WORLD, known, &mut Memo::default())
    }

    /// A node's extent in the coordinates of a point that everything in it is asked at or behind.
    pub(crate) fn in_frame(&self, id: NodeId, frame: PointId, known: &[Extent]) -> Extent {
        self.child(id, frame, known, &mut Memo::default())
    }

    fn child(&self, id: NodeId, frame: PointId, known: &[Extent], memo: &mut Memo) -> Extent {
        if frame == WORLD {
            return known[id.0 as usize];
        }
        if let Some(extent) = memo.get(&(id, frame)) {
            return *extent;
        }
        let extent = self.extent(&self.nodes[id.0 as usize], frame, known, memo);
        memo.insert((id, frame), extent);
        extent
    }

    fn extent(&self, node: &Node, frame: PointId, known: &[Extent], memo: &mut Memo) -> Extent {
        match node {
            Node::Nothing => Extent::NOWHERE,
            Node::Shape(row, arguments, point) => self.pull(self.of_shape(row, arguments), *point, frame),
            Node::Outline(region, point) => {
                let bounds = region.bounds().map_or(Bounds::EMPTY, |(min, max)| Bounds {
                    min: [min[0], min[1], f64::NEG_INFINITY],
                    max: [max[0], max[1], f64::INFINITY],
                });
                self.pull(Extent::exact(bounds), *point, frame)
            }
            Node::Loft(loft, point) => {
                let bounds = loft.bounds().map_or(Bounds::EMPTY, |(min, max)| Bounds {
                    min: [min[0], min[1], f64::NEG_INFINITY],
                    max: [max[0], max[1], f64::INFINITY],
                });
                self.pull(Extent::exact(bounds), *point, frame)
            }
            Node::Polytope(triangles, point) => {
                let corners = triangles.iter().flatten();
                let bounds =
                    corners.fold(Bounds::EMPTY, |all, corner| all.union(&Bounds { min: *corner, max: *corner }));
                self.pull(Extent::exact(bounds), *point, frame)
            }
            Node::Boolean(operation, joint, children) => {
                let children = children.iter().map(|child| self.child(*child, frame, known, memo));
                match (operation, joint) {
                    (Operation::Intersection, _) => Extent::intersection(children),
                    (Operation::Union, None) => Extent::union(children),
                    (Operation::Union, Some(joint)) => {
                        let bulge = bulge(joint.profile, children.len()) * self.ranges.range(&joint.radius).max;
                        Extent::union(children.map(|child| child.grown(bulge)))
                    }
                }
            }
            Node::Negate(_) => Extent::EVERYWHERE,
            Node::Adjust(row, arguments, child) => {
                let child = self.child(*child, frame, known, memo);
                self.adjusted(row, arguments, child)
            }
            Node::Extrude(height, child, point) => {
                let across = self.rounded(*child, *point, known, memo);
                let z = Interval { min: 0.0, max: self.ranges.range(height).max };
                let along = Extent::exact(Bounds::new(Interval::ALL, Interval::ALL, z));
                self.pull(Extent::intersection([across, along].into_iter()), *point, frame)
            }
            Node::Taper(_, _, child, _) | Node::Paint(_, child) => self.child(*child, frame, known, memo),
            Node::Confine(radius, lipschitz, child, point) => {
                let within = self.rounded(*child, *point, known, memo);
                let radius = self.ranges.range(radius).max;
                let across = Interval { min: -radius, max: radius };
                let disc = Extent { growth: 0.0, ..Extent::exact(Bounds::new(across, across, Interval::ALL)) };
                let both = Extent::intersection([within, disc].into_iter());
                let growth = both.growth + 1.0 / lipschitz;
                self.pull(Extent { growth, room: f64::INFINITY, ..both }, *point, frame)
            }
        }
    }

    /// A child's extent with a growth that also holds as the crow flies, so that it may be turned.
    fn rounded(&self, id: NodeId, frame: PointId, known: &[Extent], memo: &mut Memo) -> Extent {
        let extent = self.child(id, frame, known, memo);
        match self.nodes[id.0 as usize] {
            Node::Shape(..) | Node::Outline(..) | Node::Loft(..) | Node::Polytope(..) => extent,
            _ => Extent { growth: 3f64.sqrt() * extent.growth, ..extent },
        }
    }

    fn of_shape(&self, row: &Row, arguments: &[Scalar]) -> Extent {
        let arguments: Vec<Interval> = arguments.iter().map(|argument| self.ranges.range(argument)).collect();
        let growth = if row.class == Class::Bound { f64::INFINITY } else { 1.0 };
        Extent { growth, ..Extent::exact((row.bounds)(&arguments)) }
    }

    fn adjusted(&self, row: &Row, arguments: &[Scalar], child: Extent) -> Extent {
        let Some(by) = arguments.first().map(|argument| self.ranges.range(argument)) else { return child };
        if *row == rows::OFFSET {
            child.grown(by.max)
        } else if *row == rows::SHELL {
            child.grown(0.5 * by.max)
        } else if *row == rows::SCALE {
            let growth = if by.min > 0.0 { child.growth / by.min } else { f64::INFINITY };
            Extent { growth, ..child }
        } else {
            Extent::EVERYWHERE
        }
    }

    /// An extent at a point, in the coordinates of a point before it.
    fn pull(&self, mut extent: Extent, mut point: PointId, frame: PointId) -> Extent {
        while point != frame && !extent.bounds.is_empty() {
            let (parent, pulled) = match &self.points[point.0 as usize] {
                Point::World => break,
                Point::Affine(map, parent) => (*parent, placed(extent, &self.ranges.placement(map, point))),
                Point::Warp(row, arguments, parent) => (*parent, self.unwarped(extent, row, arguments)),
                Point::Confined(radius, parent) => (*parent, unconfined(extent, self.ranges.range(radius).min)),
                Point::Flattened(parent) => (*parent, unflattened(extent)),
            };
            (point, extent) = (parent, pulled);
        }
        extent
    }

    /// The points that a warp or section sends into an extent.
    fn unwarped(&self, extent: Extent, row: &Row, arguments: &[Scalar]) -> Extent {
        let (x, y, z) = (extent.bounds.axis(0), extent.bounds.axis(1), extent.bounds.axis(2));
        let around = |radius: f64| Interval { min: -radius, max: radius };
        let radius = x.magnitude().hypot(y.magnitude());
        if *row == rows::SLICE {
            Extent { bounds: Bounds::new(x, y, Interval::ALL), ..extent }
        } else if *row == rows::TWIST {
            Extent { bounds: Bounds::new(around(radius), around(radius), z), ..extent }
        } else if *row == rows::REVOLVE || *row == rows::REVOLVE_FACETS {
            if x.max < 0.0 {
                return Extent::NOWHERE;
            }
            Extent { bounds: Bounds::new(around(x.max), around(x.max), y), ..extent }
        } else if *row == rows::EXTRUDE {
            let scale = [2, 3].map(|index: usize| self.ranges.range(&arguments[index]));
            let (across, growth) = unextruded([x, y], scale, &arguments[1]);
            Extent {
                bounds: Bounds::new(across[0], across[1], Interval::ALL),
                growth: extent.growth * growth,
                room: extent.room * growth,
            }
        } else {
            Extent::EVERYWHERE
        }
    }
}

/// How far a joint of radius 1 between that many operands reaches beyond all of them: x in n (1 − x)ᵖ = 1.
pub(crate) fn bulge(profile: Profile, operands: usize) -> f64 {
    1.0 - (operands as f64).powf(-1.0 / f64::from(exponent(profile)))
}

/// The exponent of a joint's formula.
pub(crate) fn exponent(profile: Profile) -> u8 {
    match profile {
        Profile::Chamfer => 1,
        Profile::Fillet => 2,
        Profile::Smooth => 3,
    }
}

/// An extent under the map from where it is asked to where it stands.
fn placed(extent: Extent, placement: &Placement) -> Extent {
    let axes = [0, 1, 2].map(|axis| extent.bounds.axis(axis));
    let mapped = placement.rows.each_ref().map(|row| {
        let terms = (0..3).map(|axis| row[axis] * axes[axis]);
        let linear = terms.fold(Interval::point(0.0), |sum, term| sum + term);
        if row.iter().all(|entry| entry.is_point()) {
            return linear + row[3];
        }
        // A row of a live map is no longer than the map stretches, whatever its entries may be.
        let counting = (0..3).filter(|axis| row[*axis] != Interval::point(0.0));
        let reach = counting.map(|axis| axes[axis].magnitude().powi(2)).sum::<f64>().sqrt() * placement.stretch;
        Interval { min: linear.min.max(-reach), max: linear.max.min(reach) } + row[3]
    });
    let [x, y, z] = mapped;
    let Placement { stretch, .. } = placement;
    Extent { bounds: Bounds::new(x, y, z), growth: extent.growth * stretch, room: extent.room * stretch }
}

/// What the confinement to a disc sends into an extent: nothing more, if the extent keeps clear of the disc's rim.
fn unconfined(extent: Extent, radius: f64) -> Extent {
    let reach = extent.bounds.axis(0).magnitude().hypot(extent.bounds.axis(1).magnitude());
    if reach < radius {
        return Extent { room: extent.room.min(radius - reach), ..extent };
    }
    Extent { bounds: Bounds::new(Interval::ALL, Interval::ALL, extent.bounds.axis(2)), ..extent }
}

/// What flattening sends into an extent: all that is above or below its part in the plane z = 0.
fn unflattened(extent: Extent) -> Extent {
    let bounds = &extent.bounds;
    if bounds.axis(2).contains(0.0) {
        Extent { bounds: Bounds::new(bounds.axis(0), bounds.axis(1), Interval::ALL), ..extent }
    } else {
        Extent::NOWHERE
    }
}

/// The ranges of x and y that a tapering section sends into those of its plane, over all levels; and by how much more
/// than the lesser scale, which [`Node::Taper`] divides by, distances are stretched.
fn unextruded(plane: [Interval; 2], scale: [Interval; 2], twist: &Scalar) -> ([Interval; 2], f64) {
    const LEAST_SCALE: f64 = 1e-4;
    let scale = scale.map(|axis| Interval { min: axis.min.max(LEAST_SCALE), max: axis.max.max(LEAST_SCALE) });
    let levels = scale.map(|axis| axis.hull(Interval::point(1.0)));
    let uniform = scale[0] == scale[1] && scale[0].is_point();
    let uneven = (scale[0].max / scale[1].min).max(scale[1].max / scale[0].min).max(1.0);
    let growth = if uniform { 1.0 } else { uneven };
    let turned = if twist.is(0.0) {
        plane
    } else {
        let radius = plane[0].magnitude().hypot(plane[1].magnitude());
        [Interval { min: -radius, max: radius }; 2]
    };
    ([turned[0] * levels[0], turned[1] * levels[1]], growth)
}
