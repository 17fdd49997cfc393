//! One question: the value of a node at a point.

use std::sync::LazyLock;

use chiaro_plane::Loft;
use chiaro_solid::Profile;
use chiaro_vocabulary::Row;
use chiaro_vocabulary::cpu::Program;
use chiaro_vocabulary::rows::{self, joint_steps};

use super::compiled::{Compiled, Distance, Function, Piece, Place};
use super::memory::{Memory, Remembered};
use crate::graph::{NodeId, Operation, PointId};

/// The distance to nothing, in millimetres: the vocabulary's FAR.
const FAR: f64 = 1e15;

/// A question under way.
pub(super) struct Query<'a, N> {
    pub(super) compiled: &'a Compiled,
    pub(super) memory: &'a mut Memory<N>,
    /// The point that is asked about.
    pub(super) point: [N; 3],
    /// The same as plain numbers.
    pub(super) position: [f64; 3],
}

/// The programs of the vocabulary's building blocks.
struct Helpers {
    outline_start: &'static Program,
    outline_line: &'static Program,
    outline_arc: &'static Program,
    outline_end: &'static Program,
    loft_level: &'static Program,
    loft_side: &'static Program,
    polytope_start: &'static Program,
    polytope_triangle: &'static Program,
    polytope_end: &'static Program,
    extrude: &'static Program,
    taper: &'static Program,
    confine_disc: &'static Program,
    confine_join: &'static Program,
    plane_point: &'static Program,
    joint_of_two: [&'static Program; 3],
    joint_term: &'static Program,
    joint_step: &'static Program,
}

static HELPERS: LazyLock<Helpers> = LazyLock::new(|| Helpers {
    outline_start: rows::OUTLINE_START.program(),
    outline_line: rows::OUTLINE_LINE.program(),
    outline_arc: rows::OUTLINE_ARC.program(),
    outline_end: rows::OUTLINE_END.program(),
    loft_level: rows::LOFT_LEVEL.program(),
    loft_side: rows::LOFT_SIDE.program(),
    polytope_start: rows::POLYTOPE_START.program(),
    polytope_triangle: rows::POLYTOPE_TRIANGLE.program(),
    polytope_end: rows::POLYTOPE_END.program(),
    extrude: rows::OP_EXTRUDE.program(),
    taper: rows::OP_TAPER.program(),
    confine_disc: rows::CONFINE_DISC.program(),
    confine_join: rows::CONFINE_JOIN.program(),
    plane_point: rows::PLANE_POINT.program(),
    joint_of_two: [&rows::JOINT_CHAMFER, &rows::JOINT_FILLET, &rows::JOINT_SMOOTH].map(Row::program),
    joint_term: rows::JOINT_TERM.program(),
    joint_step: rows::JOINT_STEP.program(),
});

impl<N: Remembered> Query<'_, N> {
    pub(super) fn node(&mut self, id: NodeId) -> N {
        let compiled = self.compiled;
        let node = &compiled.nodes[id.0 as usize];
        let Some(place) = node.shared else { return self.distance(&node.item) };
        if let Some(known) = self.memory.node(place) {
            return known;
        }
        let value = self.distance(&node.item);
        self.memory.keep_node(place, value);
        value
    }

    fn distance(&mut self, distance: &Distance) -> N {
        let helpers = &*HELPERS;
        match distance {
            Distance::Nothing => N::of(FAR),
            Distance::Solid(function, point) => {
                let point = self.point(*point);
                self.call_with(function, &point)[0]
            }
            Distance::Plane(function, point) => {
                let [x, y, _] = self.point(*point);
                self.call_with(function, &[x, y])[0]
            }
            Distance::Outline(pieces, point) => self.outline(pieces, *point),
            Distance::Loft(loft, point) => self.loft(loft, *point),
            Distance::Polytope(triangles, point) => self.polytope(triangles, *point),
            Distance::Least(children, tree) => {
                let mut least = children.iter().fold(N::of(FAR), |least, child| least.min(self.node(*child)));
                if let Some(tree) = tree {
                    tree.nearest(self.position, least.plain(), &mut |child| {
                        least = least.min(self.node(child));
                        least.plain()
                    });
                }
                least
            }
            Distance::Greatest(children) => {
                children.iter().fold(N::of(-FAR), |greatest, child| greatest.max(self.node(*child)))
            }
            Distance::Joint { operation, profile, exponent, radius, children } => {
                let sign = |value: N| if *operation == Operation::Union { value } else { -value };
                let distances: Vec<N> = children.iter().map(|child| sign(self.node(*child))).collect();
                sign(self.joint(&distances, *profile, N::of(*exponent), N::of(*radius)))
            }
            Distance::Negate(child) => -self.node(*child),
            Distance::Adjust(function, child) => {
                let child = self.node(*child);
                self.call_with(function, &[child])[0]
            }
            Distance::Extrude(height, child, point) => {
                let (child, [_, _, z]) = (self.node(*child), self.point(*point));
                self.call(helpers.extrude, &[child, z, N::of(*height)])[0]
            }
            Distance::Taper(arguments, child, point) => {
                let (child, [_, _, z]) = (self.node(*child), self.point(*point));
                let [height, x, y] = arguments.map(N::of);
                self.call(helpers.taper, &[child, z, height, x, y])[0]
            }
            Distance::Confine { radius, lipschitz, child, point } => {
                let (child, [x, y, _]) = (self.node(*child), self.point(*point));
                let gap = (x * x + y * y).sqrt() - N::of(*radius);
                self.call(helpers.confine_join, &[child, gap, N::of(*lipschitz)])[0]
            }
            Distance::Same(child) => self.node(*child),
        }
    }

    #[inline(never)]
    fn point(&mut self, id: PointId) -> [N; 3] {
        let compiled = self.compiled;
        let point = &compiled.points[id.0 as usize];
        let Some(place) = point.shared else { return self.place(&point.item) };
        if let Some(known) = self.memory.point(place) {
            return known;
        }
        let value = self.place(&point.item);
        self.memory.keep_point(place, value);
        value
    }

    #[inline(never)]
    fn place(&mut self, place: &Place) -> [N; 3] {
        match place {
            Place::World => self.point,
            Place::Space(rows, from) => {
                let [x, y, z] = self.point(*from);
                rows.map(|[a, b, c, d]| N::of(a) * x + N::of(b) * y + N::of(c) * z + N::of(d))
            }
            Place::Plane(rows, from) => {
                let [x, y, _] = self.point(*from);
                let [x, y] = rows.map(|[a, b, d]| N::of(a) * x + N::of(b) * y + N::of(d));
                [x, y, N::of(0.0)]
            }
            Place::Warp(function, from) => {
                let point = self.point(*from);
                self.call_with(function, &point)
            }
            Place::Confined(radius, from) => {
                let [x, y, z] = self.point(*from);
                self.call(HELPERS.confine_disc, &[x, y, z, N::of(*radius)])
            }
            Place::Flattened(from) => {
                let point = self.point(*from);
                self.call(HELPERS.plane_point, &point)
            }
        }
    }

    #[inline(never)]
    fn outline(&mut self, pieces: &[Piece], point: PointId) -> N {
        let [x, y, _] = self.point(point);
        let start = self.call(HELPERS.outline_start, &[]);
        let [squared, sign, _] = pieces.iter().fold(start, |[squared, sign, _], piece| {
            let ([ax, ay], [bx, by]) = (piece.from.map(N::of), piece.to.map(N::of));
            match piece.arc {
                None => self.call(HELPERS.outline_line, &[squared, sign, x, y, ax, ay, bx, by]),
                Some(([cx, cy], sweep)) => {
                    let (cx, cy, sweep) = (N::of(cx), N::of(cy), N::of(sweep));
                    self.call(HELPERS.outline_arc, &[squared, sign, x, y, ax, ay, bx, by, cx, cy, sweep])
                }
            }
        });
        self.call(HELPERS.outline_end, &[squared, sign])[0]
    }

    #[inline(never)]
    fn loft(&mut self, loft: &Loft, point: PointId) -> N {
        let [x, y, z] = self.point(point);
        let count = N::of(loft.stages().len() as f64);
        let [stage, t, _] = self.call(HELPERS.loft_level, &[z, N::of(loft.height()), count]);
        let sides = loft.stages().get(stage.plain() as usize).map_or(&[][..], Vec::as_slice);
        let start = self.call(HELPERS.outline_start, &[]);
        let [squared, sign, _] = sides.iter().fold(start, |[squared, sign, _], side| {
            let [[ax, ay], [bx, by]] = side.from.map(|end| end.map(N::of));
            let [[cx, cy], [dx, dy]] = side.to.map(|end| end.map(N::of));
            self.call(HELPERS.loft_side, &[squared, sign, x, y, t, ax, ay, bx, by, cx, cy, dx, dy])
        });
        self.call(HELPERS.outline_end, &[squared, sign])[0]
    }

    #[inline(never)]
    fn polytope(&mut self, triangles: &[[[f64; 3]; 3]], point: PointId) -> N {
        let [x, y, z] = self.point(point);
        let start = self.call(HELPERS.polytope_start, &[]);
        let [squared, height, _] = triangles.iter().fold(start, |[squared, height, _], corners| {
            let [[ax, ay, az], [bx, by, bz], [cx, cy, cz]] = corners.map(|corner| corner.map(N::of));
            let arguments = [squared, height, x, y, z, ax, ay, az, bx, by, bz, cx, cy, cz];
            self.call(HELPERS.polytope_triangle, &arguments)
        });
        self.call(HELPERS.polytope_end, &[squared, height])[0]
    }

    #[inline(never)]
    fn joint(&mut self, distances: &[N], profile: Profile, exponent: N, radius: N) -> N {
        if let [a, b] = *distances {
            let [chamfer, fillet, smooth] = HELPERS.joint_of_two;
            let program = match profile {
                Profile::Chamfer => chamfer,
                Profile::Fillet => fillet,
                Profile::Smooth => smooth,
            };
            return self.call(program, &[a, b, radius])[0];
        }
        let least = distances.iter().fold(N::of(FAR), |least, distance| least.min(*distance));
        (0..joint_steps(distances.len())).fold(least, |x, _| {
            let start = [N::of(0.0); 3];
            let [sum, slope, _] = distances.iter().fold(start, |[sum, slope, _], distance| {
                self.call(HELPERS.joint_term, &[sum, slope, *distance, x, radius, exponent])
            });
            self.call(HELPERS.joint_step, &[sum, slope, x, radius])[0]
        })
    }

    /// Calls a function with its first argument.
    fn call_with(&mut self, function: &Function, first: &[N]) -> [N; 3] {
        let Memory { scratch, arguments, .. } = &mut *self.memory;
        arguments.clear();
        arguments.extend_from_slice(first);
        arguments.extend(function.arguments.iter().map(|argument| N::of(*argument)));
        function.program.call(arguments, scratch)
    }

    fn call(&mut self, program: &Program, arguments: &[N]) -> [N; 3] {
        program.call(arguments, &mut self.memory.scratch)
    }
}
