//! Lights as the kernels get them: the Rust side of `light.wgsl`.

use chiaro_shader::Shadows;
use chiaro_shader::lights::{DISK, ONE_OF_MANY, QUAD, RECTANGLE, SAMPLED, SPHERE, SUN, TUBE, TWO_SIDED, VISIBLE};
use chiaro_solid::{Emitter, Light, PlacedLight, Scalar, Strength};

use crate::view::View;

mod meter;
mod polygon;

/// What lights a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Lighting {
    /// The lights.
    pub lights: Vec<LightSource>,
    /// What surrounds the scene.
    pub surroundings: Surroundings,
    /// By what radiances are multiplied on their way into the picture, where a white surface in full light is
    /// about 1.
    pub exposure: f64,
}

/// A light for the kernels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightSource {
    /// Its numbers.
    pub row: LightRow,
    /// The method that draws its shadows, if it is not the picture's.
    pub shadows: Option<Direct>,
}

/// How the light that surfaces get from a light directly is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Direct {
    /// By random samples of the light: slow, noisy, and right.
    Sampled,
    /// By a shadow method.
    By(Shadows),
}

/// What surrounds a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Surroundings {
    /// The studio of scenes without lights.
    Studio,
    /// Linear radiances towards the zenith, the horizon, and below it.
    Sky {
        /// Straight up.
        zenith: [f64; 3],
        /// All around.
        horizon: [f64; 3],
        /// Below.
        ground: [f64; 3],
    },
}

/// `Light` of `light.wgsl`, field by field.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct LightRow {
    pub(crate) a: [f32; 4],
    pub(crate) b: [f32; 4],
    pub(crate) c: [f32; 4],
    pub(crate) d: [f32; 4],
    pub(crate) radiance: [f32; 4],
    pub(crate) kind: [u32; 4],
}

/// Of more lights than this that share the picture's method, one is drawn for each pixel and sample.
const MOST_LIGHTS: usize = 8;

/// The radius of a light that is said to have none, in millimetres.
const POINT_RADIUS: f64 = 0.01;
/// No length is more, in millimetres: kernels multiply up to four.
const FARTHEST: f64 = 1e9;
/// No radiance is more, in candela per square metre: ten thousand suns could be added in single precision.
const MOST_RADIANCE: f64 = 1e30;
/// Square metres in a square millimetre.
const SQUARE_METRES: f64 = 1e-6;

/// The studio's key light: where it stands as the camera sees it (right, away, up), the sine of its angular radius, and
/// the irradiance that it gives a surface facing it.
const KEY_DIRECTION: [f64; 3] = [-0.62, -0.36, 0.70];
const KEY_SINE: f64 = 0.109;
const KEY_IRRADIANCE: [f64; 3] = [2.60, 2.45, 2.28];

impl Lighting {
    /// The studio's, turned about z by an angle in radians.
    pub fn studio(azimuth: f64) -> Self {
        let [x, y, z] = KEY_DIRECTION;
        let (sin, cos) = azimuth.sin_cos();
        let towards = normalized([x * cos - y * sin, y * cos + x * sin, z]);
        let radiance = KEY_IRRADIANCE.map(|e| e / (std::f64::consts::PI * KEY_SINE * KEY_SINE));
        let row = LightRow { a: extended(towards, KEY_SINE), ..LightRow::new(SUN, 0, radiance) };
        Self { lights: vec![LightSource { row, shadows: None }], surroundings: Surroundings::Studio, exposure: 1.0 }
    }

    /// A scene's own, for these values of its live numbers, exposed for what this view looks at.
    pub fn of(lights: &[PlacedLight], parameters: &[f64], view: &View) -> Self {
        let mut lighting = Self {
            lights: Vec::new(),
            surroundings: Surroundings::Sky { zenith: [0.0; 3], horizon: [0.0; 3], ground: [0.0; 3] },
            exposure: 1.0,
        };
        for placed in lights {
            lighting.add(placed, parameters);
        }
        lighting.exposure = meter::exposure(&lighting, &view.subject());
        lighting
    }

    /// Whether so many lights share the picture's method that one is drawn for each pixel and sample.
    pub(crate) fn are_many(&self) -> bool {
        self.lights.iter().filter(|light| light.shadows.is_none()).count() > MOST_LIGHTS
    }

    /// The lights' rows for the kernels, exposed; their flags say how the picture treats them. Never empty: a kernel
    /// can't bind nothing.
    pub(crate) fn rows(&self, direct: Direct) -> Vec<LightRow> {
        let dark = LightRow::new(SPHERE, 0, [0.0; 3]);
        let row = |light: &LightSource| {
            let sampled = light.shadows.unwrap_or(direct) == Direct::Sampled;
            let one_of_many = light.shadows.is_none() && self.are_many();
            let treatment = if sampled { SAMPLED } else { 0 } | if one_of_many { ONE_OF_MANY } else { 0 };
            let radiance = light.row.radiance.map(|x| x * self.exposure as f32);
            LightRow { radiance, kind: [light.row.kind[0], light.row.kind[1] | treatment, 0, 0], ..light.row }
        };
        if self.lights.is_empty() { vec![dark] } else { self.lights.iter().map(row).collect() }
    }

    fn add(&mut self, placed: &PlacedLight, parameters: &[f64]) {
        let place = Place::new(placed, parameters);
        let light = &placed.light;
        if let Emitter::Environment { zenith, horizon, ground } = &light.emitter {
            let luminance = place.number(strength(light));
            let filter = place.linear(&light.color);
            let of = |color: &[Scalar; 3]| {
                let color = place.linear(color);
                [0, 1, 2].map(|i| luminance * filter[i] * color[i])
            };
            self.surroundings = Surroundings::Sky { zenith: of(zenith), horizon: of(horizon), ground: of(ground) };
            return;
        }
        let shadows = light.shadows.as_deref().map(|name| match Shadows::named(name) {
            Some(method) => Direct::By(method),
            // "reference", as a test makes sure.
            None => Direct::Sampled,
        });
        let rows = place.rows(light);
        self.lights.extend(rows.into_iter().map(|row| LightSource { row, shadows }));
    }
}

/// Where a light is, and the values of the live numbers.
struct Place<'a> {
    matrix: [[f64; 4]; 3],
    parameters: &'a [f64],
}

impl<'a> Place<'a> {
    fn new(placed: &PlacedLight, parameters: &'a [f64]) -> Self {
        Self { matrix: placed.placement.value(parameters), parameters }
    }

    fn number(&self, scalar: &Scalar) -> f64 {
        scalar.value(self.parameters)
    }

    /// A colour in sRGB as linear light.
    fn linear(&self, color: &[Scalar; 3]) -> [f64; 3] {
        [0, 1, 2].map(|i| linear_from_srgb(self.number(&color[i]).clamp(0.0, 1.0)))
    }

    fn point(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        self.matrix.map(|row| row[0] * x + row[1] * y + row[2] * z + row[3])
    }

    fn vector(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        self.matrix.map(|row| row[0] * x + row[1] * y + row[2] * z)
    }

    /// At a right angle to what was the plane z = 0, on the side where +z went.
    fn lit_side(&self) -> [f64; 3] {
        let normal = cross(self.vector([1.0, 0.0, 0.0]), self.vector([0.0, 1.0, 0.0]));
        let is_mirrored = dot(normal, self.vector([0.0, 0.0, 1.0])) < 0.0;
        if is_mirrored { normal.map(|x| -x) } else { normal }
    }

    /// By how much lengths along x grow.
    fn scale(&self) -> f64 {
        length(self.vector([1.0, 0.0, 0.0]))
    }

    fn rows(&self, light: &Light) -> Vec<LightRow> {
        let flags = if light.two_sided { TWO_SIDED } else { 0 } | if light.visible { VISIBLE } else { 0 };
        let sides = if light.two_sided { 2.0 } else { 1.0 };
        let centre = self.point([0.0; 3]);
        let row = |kind, area: f64| LightRow::new(kind, flags, self.radiance(light, area));
        match &light.emitter {
            Emitter::Sphere { radius } => {
                let r = (self.number(radius) * self.scale()).max(POINT_RADIUS);
                let area = 4.0 * std::f64::consts::PI * r * r;
                vec![LightRow { a: extended(centre, r), ..row(SPHERE, area) }]
            }
            Emitter::Disk { radius } => {
                let r = (self.number(radius) * self.scale()).max(POINT_RADIUS);
                let area = sides * std::f64::consts::PI * r * r;
                let normal = normalized(self.lit_side());
                vec![LightRow { a: extended(centre, r), b: extended(normal, 0.0), ..row(DISK, area) }]
            }
            Emitter::Tube { radius, length: long } => {
                let r = (self.number(radius) * self.scale()).max(POINT_RADIUS);
                let half = self.vector([0.5 * self.number(long), 0.0, 0.0]);
                let area = 4.0 * std::f64::consts::PI * r * length(half);
                vec![LightRow { a: extended(centre, r), b: extended(half, 0.0), ..row(TUBE, area) }]
            }
            Emitter::Rect { size } => {
                let [x, y] = [0, 1].map(|i| 0.5 * self.number(&size[i]));
                let corners = [[-x, -y], [x, -y], [x, y], [-x, y]];
                self.flat(light, &corners, flags, sides)
            }
            Emitter::Polygon { corners } => {
                let corners: Vec<[f64; 2]> = corners.iter().map(|c| [0, 1].map(|i| self.number(&c[i]))).collect();
                self.flat(light, &corners, flags, sides)
            }
            Emitter::Sun { angle } => {
                let sine = (0.5 * self.number(angle)).clamp(1e-5, 1.5).sin();
                let towards = normalized(self.vector([0.0, 0.0, 1.0]));
                vec![LightRow { a: extended(towards, sine), ..row(SUN, sine * sine) }]
            }
            Emitter::Environment { .. } => Vec::new(),
        }
    }

    /// A polygon of the plane z = 0, as convex pieces.
    fn flat(&self, light: &Light, corners: &[[f64; 2]], flags: u32, sides: f64) -> Vec<LightRow> {
        let placed = |corner: [f64; 2]| self.point([corner[0], corner[1], 0.0]);
        let pieces: Vec<[[f64; 3]; 4]> =
            polygon::quadrilaterals(corners).into_iter().map(|piece| piece.map(placed)).collect();
        let lit = self.lit_side();
        let area: f64 = pieces.iter().map(|piece| 0.5 * length(twice_area(piece))).sum();
        let radiance = self.radiance(light, sides * area);
        let row = |mut piece: [[f64; 3]; 4]| {
            // A mirroring reverses the order of the corners.
            if dot(twice_area(&piece), lit) < 0.0 {
                piece.reverse();
            }
            let rectangle = if is_rectangle(&piece) { RECTANGLE } else { 0 };
            let [a, b, c, d] = piece.map(|corner| extended(corner, 0.0));
            LightRow { a, b, c, d, ..LightRow::new(QUAD, flags | rectangle, radiance) }
        };
        pieces.into_iter().map(row).collect()
    }

    /// The radiance of a light with this much shining area, in square millimetres; of a sun, with this square of the
    /// sine of its angular radius.
    fn radiance(&self, light: &Light, area: f64) -> [f64; 3] {
        let pi = std::f64::consts::PI;
        let luminance = match &light.strength {
            Strength::Luminance(luminance) => self.number(luminance),
            Strength::Power(power) => self.number(power) / (pi * area * SQUARE_METRES),
            Strength::Illuminance(illuminance) => self.number(illuminance) / (pi * area),
        };
        let luminance = if luminance.is_finite() { luminance.max(0.0) } else { 0.0 };
        self.linear(&light.color).map(|filter| luminance * filter)
    }
}

impl LightRow {
    fn new(kind: u32, flags: u32, radiance: [f64; 3]) -> Self {
        let zero = [0.0; 4];
        let [red, green, blue] = radiance.map(|x| x.min(MOST_RADIANCE) as f32);
        Self { a: zero, b: zero, c: zero, d: zero, radiance: [red, green, blue, 0.0], kind: [kind, flags, 0, 0] }
    }

    /// A white sphere of radiance 1.
    pub fn sphere(centre: [f64; 3], radius: f64) -> Self {
        Self { a: extended(centre, radius), ..Self::new(SPHERE, VISIBLE, [1.0; 3]) }
    }

    /// The same light, as many times as large.
    pub fn scaled(&self, factor: f64) -> Self {
        let factor = factor as f32;
        let mut row = *self;
        match self.kind[0] {
            QUAD => {
                let centre = [0, 1, 2].map(|i| 0.25 * (self.a[i] + self.b[i] + self.c[i] + self.d[i]));
                for corner in [&mut row.a, &mut row.b, &mut row.c, &mut row.d] {
                    for i in 0..3 {
                        corner[i] = centre[i] + factor * (corner[i] - centre[i]);
                    }
                }
            }
            kind => {
                row.a[3] *= factor;
                if kind == SUN {
                    row.a[3] = row.a[3].min(0.999);
                }
                if kind == TUBE {
                    (0..3).for_each(|i| row.b[i] *= factor);
                }
            }
        }
        row
    }

    /// Its radiance: linear red, green and blue, in candela per square metre.
    pub fn radiance(&self) -> [f64; 3] {
        [0, 1, 2].map(|i| f64::from(self.radiance[i]))
    }

    /// The solid angle that a sphere or a sun is seen under from a point outside of it.
    pub fn round_solid_angle(&self, point: [f64; 3]) -> Option<f64> {
        let radius = f64::from(self.a[3]);
        let sine = match self.kind[0] {
            SUN => radius,
            SPHERE => radius / length(difference([0, 1, 2].map(|i| f64::from(self.a[i])), point)),
            _ => return None,
        };
        // 1 − cos α, without its cancellation.
        let sine2 = (sine * sine).min(1.0);
        Some(2.0 * std::f64::consts::PI * sine2 / (1.0 + (1.0 - sine2).sqrt()))
    }

    /// The radius in millimetres, of a sphere.
    pub fn sphere_radius(&self) -> Option<f64> {
        (self.kind[0] == SPHERE).then_some(f64::from(self.a[3]))
    }
}

fn strength(light: &Light) -> &Scalar {
    match &light.strength {
        Strength::Power(strength) | Strength::Luminance(strength) | Strength::Illuminance(strength) => strength,
    }
}

/// Linear light from a value of sRGB (IEC 61966-2-1).
fn linear_from_srgb(value: f64) -> f64 {
    if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
}

/// The vector area of a quadrilateral, twice.
fn twice_area([a, b, c, d]: &[[f64; 3]; 4]) -> [f64; 3] {
    cross(difference(*c, *a), difference(*d, *b))
}

fn is_rectangle([a, b, c, d]: &[[f64; 3]; 4]) -> bool {
    let (ab, ad, bc) = (difference(*b, *a), difference(*d, *a), difference(*c, *b));
    let close = 1e-6 * (length(ab) + length(ad));
    length(difference(bc, ad)) < close && dot(ab, ad).abs() < close * length(ab).max(length(ad))
}

/// As the kernels get it. Transforms may take lights farther than single precision reaches: they stay at the end of it.
fn extended(v: [f64; 3], w: f64) -> [f32; 4] {
    let single = |x: f64| if x.is_nan() { 0.0 } else { x.clamp(-FARTHEST, FARTHEST) as f32 };
    [single(v[0]), single(v[1]), single(v[2]), single(w)]
}

fn difference(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| a[i] - b[i])
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn length(v: [f64; 3]) -> f64 {
    dot(v, v).sqrt()
}

fn normalized(v: [f64; 3]) -> [f64; 3] {
    let length = length(v);
    if length > 0.0 { v.map(|x| x / length) } else { [0.0, 0.0, 1.0] }
}

#[cfg(test)]
mod tests {
    use chiaro_solid::Affine;
    use chiaro_syntax::{FileId, Span};

    use super::*;

    /// Where a flat light shines after a map.
    fn shines(emitter: Emitter, placement: Affine) -> [f64; 3] {
        let light = Light {
            emitter,
            strength: Strength::Luminance(Scalar::ONE),
            color: [1.0; 3].map(Scalar::from),
            two_sided: false,
            visible: true,
            shadows: None,
        };
        let placed = PlacedLight { light, placement, span: Span::new(FileId(0), 0..0) };
        let row = Place::new(&placed, &[]).rows(&placed.light)[0];
        let point = |corner: [f32; 4]| [0, 1, 2].map(|i| f64::from(corner[i]));
        match row.kind[0] {
            DISK => point(row.b),
            _ => normalized(twice_area(&[row.a, row.b, row.c, row.d].map(point))),
        }
    }

    #[test]
    fn a_mirror_image_shines_where_the_light_does_in_the_mirror() {
        for (factors, expected) in [([-1.0, 1.0, 1.0], 1.0), ([1.0, 1.0, -1.0], -1.0), ([-1.0, 1.0, -1.0], -1.0)] {
            let disk = Emitter::Disk { radius: Scalar::ONE };
            let rect = Emitter::Rect { size: [Scalar::ONE, Scalar::ONE] };
            for emitter in [disk, rect] {
                let shines = shines(emitter, Affine::scaling(factors.map(Scalar::from)));
                assert_eq!(shines, [0.0, 0.0, expected], "{factors:?}");
            }
        }
    }
}
