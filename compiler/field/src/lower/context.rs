//! Where one is in the tree.

use chiaro_solid::affine::Similarity;
use chiaro_solid::{Affine, Scalar, singular};
use chiaro_syntax::{Diagnostic, FileId, Span};
use chiaro_vocabulary::Class;

use super::Lowering;
use crate::graph::PointId;
use crate::matrix::{self, constant_rows, linear, magnitude, orthogonal_columns};

/// What a solid needs to know of what stands above it.
///
/// The solid's own coordinates x come to the base point's as `forward(size · since(x))`. Transforms gather in
/// `since` until something measures lengths below them, so that stretches that undo each other cost nothing.
#[derive(Clone, Debug)]
pub(super) struct Context {
    /// Its number: equal for equal contexts of shared subtrees.
    pub(super) id: u32,
    /// The point that maps start from: a [`Point::Affine`](crate::Point::Affine) only where several solids move together.
    pub(super) base: PointId,
    /// From lengths in millimetres of the world to the base point; it makes no length shorter.
    pub(super) forward: Affine,
    /// How many millimetres of the world one millimetre above `since` is.
    pub(super) size: Scalar,
    /// The transforms below that.
    pub(super) since: Affine,
    /// The text of the innermost transform.
    pub(super) transformed_at: Span,
    /// The Lipschitz constant of a distance asked at the base point, by the point the scene is asked about.
    pub(super) slope: f64,
    /// The best class a distance may have here.
    pub(super) best: Class,
    /// Whether the base point is a plane point.
    pub(super) plane: bool,
    /// Whether something above is painted.
    pub(super) painted: bool,
    /// Whether the solid is only being measured.
    pub(super) probe: bool,
}

/// A place to put a shape.
pub(super) struct Place {
    /// From lengths in millimetres of the world to the base point.
    pub(super) forward: Affine,
    /// How many millimetres of the world the shape's are.
    pub(super) size: Scalar,
    /// Whether `forward` keeps all lengths.
    pub(super) rigid: bool,
}

impl Lowering {
    /// The context of a whole tree that is asked at a point.
    pub(super) fn context(&mut self, base: PointId) -> Context {
        Context {
            id: self.next_context(),
            base,
            forward: Affine::identity(),
            size: Scalar::ONE,
            since: Affine::identity(),
            transformed_at: Span::new(FileId(0), 0..0),
            slope: 1.0,
            best: Class::Exact,
            plane: false,
            painted: false,
            probe: false,
        }
    }

    /// A context made from one above it; on the heap, since there is one for each level of the tree.
    #[inline(never)]
    pub(super) fn derive(&mut self, context: &Context, change: impl FnOnce(&mut Context)) -> Box<Context> {
        let mut below = Box::new(context.clone());
        below.id = self.next_context();
        change(&mut below);
        below
    }

    fn next_context(&mut self) -> u32 {
        self.contexts += 1;
        self.contexts
    }

    /// The same context for something that measures lengths: with no transforms left open.
    #[inline(never)]
    pub(super) fn settled(&mut self, context: &Context) -> Box<Context> {
        let place = self.place(context);
        self.derive(context, |below| {
            below.forward = place.forward;
            below.size = place.size;
            below.since = Affine::identity();
            if !place.rigid {
                below.best = Class::Bound;
            }
        })
    }

    /// The context of several solids that move together with live numbers, if they do and keep their shapes: they start from a
    /// point that is moved once for all of them, and their own maps stay constant.
    #[inline(never)]
    pub(super) fn moved(&mut self, context: &Context) -> Option<Box<Context>> {
        let is_constant = |map: &Affine| map.rows().iter().flatten().all(|number| number.constant().is_some());
        let keeps_shapes = matches!(context.open_transforms().similarity(), Similarity::Uniform(_));
        if is_constant(&context.forward) && is_constant(&context.since) || !keeps_shapes {
            return None;
        }
        let place = self.place(context);
        let base = self.point_at(context.base, &place.forward, false);
        Some(self.derive(context, |below| {
            below.base = base;
            below.forward = Affine::identity();
            below.size = place.size;
            below.since = Affine::identity();
        }))
    }

    /// Where a shape is to be put. If lengths are stretched, distances count by the direction they are stretched
    /// least in.
    #[inline(never)]
    pub(super) fn place(&mut self, context: &Context) -> Place {
        let since = context.open_transforms();
        let (factor, rigid) = match since.similarity() {
            Similarity::Uniform(factor) => (factor, true),
            Similarity::AtLeast(factor) => (diagonal_least(&since).unwrap_or(factor), false),
        };
        if !rigid {
            self.warn_of_stretch(&since, context.transformed_at);
        }
        let unscaled = unscaled(&since, &context.size, &[(); 3].map(|()| factor.clone()));
        let forward = if is_identity(&context.forward) { unscaled } else { context.forward.after(&unscaled) };
        Place { forward, size: context.size.clone() * factor, rigid }
    }

    /// Where a shape is to be put that is stretched along its own axes by factors, if the transforms come to that.
    #[inline(never)]
    pub(super) fn stretched_place(&self, context: &Context) -> Option<(Place, [Scalar; 3])> {
        let since = context.open_transforms();
        if matches!(since.similarity(), Similarity::Uniform(_)) {
            return None;
        }
        let factors = orthogonal_columns(&since)?;
        let forward = context.forward.after(&unscaled(&since, &context.size, &factors));
        Some((Place { forward, size: context.size.clone(), rigid: true }, factors))
    }

    fn warn_of_stretch(&mut self, since: &Affine, span: Span) {
        const MUCH: f64 = 8.0;
        let Some(rows) = constant_rows(since) else { return };
        let [most, _, least] = singular::values(&linear(&rows));
        let condition = most / least;
        if condition > MUCH {
            let message = format!("this stretches one direction {condition:.1} times more than another");
            let label = "distances count by the shortest, so rays take many more steps here";
            self.say(Diagnostic::warning(span, message).with_label(label));
        }
    }
}

impl Context {
    /// A length of the solid, once it is settled, in millimetres of the world.
    pub(super) fn length(&self, length: &Scalar) -> Scalar {
        if self.size.is(1.0) { length.clone() } else { length.clone() * self.size.clone() }
    }

    /// The transforms since the context was settled; of a plane shape, with a scale of z that fits.
    fn open_transforms(&self) -> Affine {
        if self.plane { plane_map(&self.since) } else { self.since.clone() }
    }
}

/// The least factor of a scaling of the axes.
fn diagonal_least(map: &Affine) -> Option<Scalar> {
    let [x, y, z] = diagonal(map)?.map(|factor| magnitude(&factor));
    Some(x.min(y).min(z))
}

/// The factors of a map that scales the axes, apart from moving.
fn diagonal(map: &Affine) -> Option<[Scalar; 3]> {
    let rows = map.rows();
    let is_diagonal = (0..3).all(|i| (0..3).all(|j| i == j || rows[i][j].is(0.0)));
    is_diagonal.then(|| [0, 1, 2].map(|i| rows[i][i].clone()))
}

/// The map with lengths multiplied by a size and its columns divided by their factors.
fn unscaled(map: &Affine, size: &Scalar, factors: &[Scalar; 3]) -> Affine {
    let one = |scalar: &Scalar| scalar.is(1.0);
    if one(size) && factors.iter().all(one) {
        return map.clone();
    }
    map.divided(factors, size)
}

/// A map of the plane, with a scale of z that hides nothing: the plane's factor, or its least.
fn plane_map(map: &Affine) -> Affine {
    let rows = map.rows();
    let zero = || Scalar::ZERO;
    if let Some(constant) = constant_rows(map) {
        let [[a, b, _, _], [c, d, _, _], _] = constant;
        let least = least_singular_value([[a, b], [c, d]]);
        return Affine::constant([[a, b, 0.0, constant[0][3]], [c, d, 0.0, constant[1][3]], [0.0, 0.0, least, 0.0]]);
    }
    if matches!(map.similarity(), Similarity::Uniform(_)) {
        return map.clone();
    }
    if rows[0][0] == rows[1][1] && rows[0][1].is(0.0) && rows[1][0].is(0.0) {
        let mut uniform = rows.clone();
        uniform[2] = [zero(), zero(), rows[0][0].clone(), zero()];
        return Affine::similar(uniform, magnitude(&rows[0][0]));
    }
    map.clone()
}

/// The least singular value of a 2 × 2 matrix; exactly the factor, if it is diagonal and uniform.
fn least_singular_value([[a, b], [c, d]]: [[f64; 2]; 2]) -> f64 {
    if b == 0.0 && c == 0.0 {
        return a.abs().min(d.abs());
    }
    // The greatest is the sum of these lengths (split into a turn and a mirrored turn). Their difference, which is the
    // least, would cancel; but the product of both is the determinant.
    let turn = 0.5 * (a + d).hypot(c - b);
    let mirrored = 0.5 * (a - d).hypot(c + b);
    (a * d - b * c).abs() / (turn + mirrored)
}

impl Lowering {
    /// The point at which a shape is asked that stands there. Of a round shape only the place of its centre counts.
    pub(super) fn point_at(&mut self, base: PointId, forward: &Affine, round: bool) -> PointId {
        let forward =
            if round { Affine::translation([0, 1, 2].map(|i| forward.rows()[i][3].clone())) } else { forward.clone() };
        if is_identity(&forward) {
            return base;
        }
        self.builder.affine(undone(&forward), forward, base)
    }
}

fn is_identity(map: &Affine) -> bool {
    map.is_translation() && map.rows().iter().all(|row| row[3].is(0.0))
}

/// The inverse of a map from a place to the base point.
fn undone(forward: &Affine) -> Affine {
    if let Some(rows) = constant_rows(forward) {
        let inverse = matrix::inverse(&rows).map(|row| row.map(Scalar::from));
        return match forward.similarity() {
            Similarity::Uniform(factor) => Affine::similar(inverse, Scalar::ONE / factor),
            Similarity::AtLeast(_) => Affine::new(inverse),
        };
    }
    if forward.is_translation() {
        return Affine::translation([0, 1, 2].map(|i| -forward.rows()[i][3].clone()));
    }
    if let Some(factors) = diagonal(forward) {
        let row = |i: usize| {
            let mut row = [(); 4].map(|()| Scalar::ZERO);
            row[i] = Scalar::ONE / factors[i].clone();
            row[3] = -(forward.rows()[i][3].clone() / factors[i].clone());
            row
        };
        return Affine::new([row(0), row(1), row(2)]);
    }
    match forward.similarity() {
        // Of a rotation or reflection the inverse is the transpose, which costs nothing.
        Similarity::Uniform(factor) if factor.is(1.0) => {
            let rows = forward.rows();
            let entry = |i: usize, j: usize| rows[j][i].clone();
            let shift = |i: usize| {
                let products = (0..3).map(|k| rows[k][i].clone() * rows[k][3].clone());
                -products.fold(Scalar::ZERO, |sum, product| sum + product)
            };
            Affine::new([0, 1, 2].map(|i| [entry(i, 0), entry(i, 1), entry(i, 2), shift(i)]))
        }
        _ => forward.inverse(),
    }
}
