//! Solids to test with.

use std::sync::Arc;

use chiaro_plane::{Loft, Region};
use chiaro_solid::{Affine, Boolean, Joint, Material, Profile, Scalar, Solid, SolidKind};
use chiaro_syntax::{FileId, Span};
use chiaro_vocabulary::{Row, rows};

/// A solid written nowhere.
pub(crate) fn solid(kind: SolidKind) -> Arc<Solid> {
    Solid::new(kind, Span::new(FileId(0), 0..0))
}

pub(crate) fn shape(row: &'static Row, arguments: &[f64]) -> Arc<Solid> {
    solid(SolidKind::Shape(row, arguments.iter().copied().map(Scalar::from).collect()))
}

pub(crate) fn transform(map: Affine, child: Arc<Solid>) -> Arc<Solid> {
    solid(SolidKind::Transform(map, child))
}

pub(crate) fn moved(by: [f64; 3], child: Arc<Solid>) -> Arc<Solid> {
    transform(Affine::translation(by.map(Scalar::from)), child)
}

pub(crate) fn scaled(factors: [f64; 3], child: Arc<Solid>) -> Arc<Solid> {
    transform(Affine::scaling(factors.map(Scalar::from)), child)
}

pub(crate) fn boolean(operation: Boolean, joint: Option<Joint>, children: Vec<Arc<Solid>>) -> Arc<Solid> {
    solid(SolidKind::Boolean { operation, joint, children })
}

pub(crate) fn extrude(height: f64, twist: f64, scale: [f64; 2], child: Arc<Solid>) -> Arc<Solid> {
    let (height, twist, scale) = (Scalar::from(height), Scalar::from(twist), scale.map(Scalar::from));
    solid(SolidKind::Extrude { height, twist, scale, child })
}

/// Random numbers (SplitMix64).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub(crate) fn within(&mut self, least: f64, most: f64) -> f64 {
        least + (most - least) * (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    pub(crate) fn below(&mut self, count: u64) -> u64 {
        self.bits() % count
    }

    pub(crate) fn point(&mut self, reach: f64) -> [f64; 3] {
        [(); 3].map(|()| self.within(-reach, reach))
    }
}

/// Random trees, their numbers made live with some probability.
pub(crate) struct Trees<'a> {
    pub(crate) random: &'a mut Random,
    /// Makes a number live: the range's ends are its first two arguments.
    pub(crate) number: &'a mut dyn FnMut(&mut Random, f64, f64) -> Scalar,
}

impl Trees<'_> {
    fn number(&mut self, least: f64, most: f64) -> Scalar {
        (self.number)(self.random, least, most)
    }

    fn numbers<const N: usize>(&mut self, least: f64, most: f64) -> [Scalar; N] {
        [(); N].map(|()| self.number(least, most))
    }

    /// A random solid of at most this depth.
    pub(crate) fn space(&mut self, depth: u32) -> Arc<Solid> {
        if depth == 0 {
            return self.simple();
        }
        match self.random.below(14) {
            0 => self.simple(),
            1..=3 => {
                let children = (0..2 + self.random.below(3)).map(|_| self.space(depth - 1)).collect();
                self.boolean(children)
            }
            4 | 5 => {
                let map = self.map();
                transform(map, self.space(depth - 1))
            }
            6 => {
                let material = Material::of_color(self.numbers(0.0, 1.0));
                solid(SolidKind::Paint(material, self.space(depth - 1)))
            }
            7 => solid(SolidKind::Offset(self.number(-0.5, 1.0), self.space(depth - 1))),
            8 => solid(SolidKind::Shell(self.number(0.2, 1.0), self.space(depth - 1))),
            9 => solid(SolidKind::Twist(self.number(-0.2, 0.2), self.space(depth - 1))),
            10 => {
                let scale = match self.random.below(3) {
                    0 => [Scalar::ONE, Scalar::ONE],
                    1 => {
                        let scale = self.number(0.0, 1.5);
                        [scale.clone(), scale]
                    }
                    _ => self.numbers(0.0, 1.5),
                };
                let twist = if self.random.below(2) == 0 { Scalar::ZERO } else { self.number(-1.5, 1.5) };
                let height = self.number(2.0, 8.0);
                solid(SolidKind::Extrude { height, twist, scale, child: self.plane(depth - 1) })
            }
            11 => {
                let sweep = (self.random.below(2) == 0).then(|| [self.number(0.0, 6.0), self.number(0.5, 6.0)]);
                let facets = (sweep.is_none() && self.random.below(3) == 0).then(|| 3 + self.random.below(6) as u32);
                let out = Affine::translation([self.number(5.0, 8.0), Scalar::ZERO, Scalar::ZERO]);
                let child = transform(out, self.plane(depth.saturating_sub(2)));
                solid(SolidKind::Revolve { sweep, facets, child })
            }
            12 => {
                let sides = 3 + self.random.below(4) as u32;
                let region =
                    Region::ngon(3.0, sides).transform([[1.0, 0.0, self.random.within(-4.0, 4.0)], [0.0, 1.0, 0.0]]);
                let (turn, stages) = (self.random.within(-1.0, 1.0), 1 + self.random.below(3));
                let (x, y) = (self.random.within(-0.2, 0.3), self.random.within(-0.2, 0.3));
                let level = |k: u64| {
                    let (sin, cos) = (turn * k as f64).sin_cos();
                    let [x, y] = [x, y].map(|rate| 1.0 + rate * k as f64);
                    [[x * cos, y * sin], [-x * sin, y * cos]]
                };
                let levels: Vec<_> = (0..=stages).map(level).collect();
                let height = self.random.within(2.0, 8.0);
                solid(SolidKind::Loft(Arc::new(Loft::new(&region, &levels, height, turn < 0.0))))
            }
            _ => {
                let count = 2 + self.random.below(5);
                let equal = self.random.within(0.3, 1.5);
                let unequal = self.random.below(2) == 0;
                let mut sphere = || {
                    let radius = if unequal { self.random.within(0.2, 2.5) } else { equal };
                    (self.random.point(5.0).map(Scalar::from), Scalar::from(radius))
                };
                solid(SolidKind::SphereHull((0..count).map(|_| sphere()).collect()))
            }
        }
    }

    /// A random plane shape of at most this depth.
    pub(crate) fn plane(&mut self, depth: u32) -> Arc<Solid> {
        if depth == 0 {
            return match self.random.below(5) {
                0 => solid(SolidKind::Shape(&rows::CIRCLE, self.numbers::<1>(1.0, 4.0).to_vec())),
                1 => solid(SolidKind::Shape(&rows::RECTANGLE, self.numbers::<2>(0.5, 4.0).to_vec())),
                2 => shape(&rows::STAR, &[4.0, 2.0, 5.0]),
                3 => solid(SolidKind::Region(Arc::new(Region::ngon(3.0, 5)))),
                _ => solid(SolidKind::Region(Arc::new(Region::disc([1.0, 0.0], 2.0)))),
            };
        }
        match self.random.below(5) {
            0 => {
                let children = (0..2 + self.random.below(2)).map(|_| self.plane(depth - 1)).collect();
                self.boolean(children)
            }
            1 => {
                let scale: [Scalar; 2] = self.numbers(0.5, 1.5);
                let [x, y] = scale;
                transform(Affine::scaling([x, y, Scalar::ONE]), self.plane(depth - 1))
            }
            2 => {
                let turn = Affine::rotation(2, self.number(-180.0, 180.0));
                let [x, y] = self.numbers(-2.0, 2.0);
                transform(Affine::translation([x, y, Scalar::ZERO]).after(&turn), self.plane(depth - 1))
            }
            3 => solid(SolidKind::Offset(self.number(-0.3, 0.5), self.plane(depth - 1))),
            _ => solid(SolidKind::Slice(self.space(depth - 1))),
        }
    }

    fn boolean(&mut self, children: Vec<Arc<Solid>>) -> Arc<Solid> {
        let operation = [Boolean::Union, Boolean::Difference, Boolean::Intersection][self.random.below(3) as usize];
        let joint = (self.random.below(2) == 0).then(|| Joint {
            profile: [Profile::Chamfer, Profile::Fillet, Profile::Smooth][self.random.below(3) as usize],
            radius: self.number(0.3, 1.5),
        });
        boolean(operation, joint, children)
    }

    fn map(&mut self) -> Affine {
        match self.random.below(5) {
            0 => Affine::translation(self.numbers(-4.0, 4.0)),
            1 => Affine::rotation(self.random.below(3) as usize, self.number(-180.0, 180.0)),
            2 => {
                let factor = self.number(0.5, 2.0);
                Affine::scaling([factor.clone(), factor.clone(), factor])
            }
            3 => Affine::scaling(self.numbers(0.5, 2.0)),
            _ => {
                let axis = self.random.point(1.0).map(|c| Scalar::from(c + 2.0));
                let turn = Affine::rotation_about(axis, self.number(-180.0, 180.0));
                let [x, y] = self.numbers(-0.5, 0.5);
                let [one, zero] = [Scalar::ONE, Scalar::ZERO];
                let shear = Affine::new([
                    [one.clone(), x, y, zero.clone()],
                    [zero.clone(), one.clone(), zero.clone(), zero.clone()],
                    [zero.clone(), zero.clone(), one, zero],
                ]);
                Affine::translation(self.numbers(-3.0, 3.0)).after(&turn).after(&shear)
            }
        }
    }

    fn simple(&mut self) -> Arc<Solid> {
        let (row, count): (&'static Row, usize) = match self.random.below(8) {
            0 => (&rows::SPHERE, 1),
            1 => (&rows::BOX, 3),
            2 => (&rows::CYLINDER, 2),
            3 => (&rows::CONE, 3),
            4 => return shape(&rows::TORUS, &[4.0, 1.0]),
            5 => (&rows::ELLIPSOID, 3),
            6 => (&rows::OCTAHEDRON, 1),
            _ => (&rows::CAPSULE, 2),
        };
        let arguments = (0..count).map(|_| self.number(1.0, 4.0)).collect();
        solid(SolidKind::Shape(row, arguments))
    }
}
