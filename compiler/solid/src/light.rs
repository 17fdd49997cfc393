//! Lights, as a scene's text places them.

use std::sync::Arc;

use chiaro_syntax::Span;

use crate::affine::Affine;
use crate::scalar::Scalar;

/// What a light's `shadows` may be: the names of the algorithms that draw shadows.
pub const SHADOW_METHODS: &[&str] = &[
    "verified",
    "hard",
    "quilez2010",
    "quilez2019",
    "aaltonen",
    "cone",
    "minimal-cone-printed",
    "minimal-cone",
    "minimal-cone-exact",
    "minimal-cone-plus",
    "proxy",
    "monte-carlo",
    "reference",
];

/// A light, in its own coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// Its shape.
    pub emitter: Emitter,
    /// How much light it gives.
    pub strength: Strength,
    /// A filter before white light, in sRGB: what it takes away is lost.
    pub color: [Scalar; 3],
    /// Whether a flat one shines from its back too.
    pub two_sided: bool,
    /// Whether the camera sees it.
    pub visible: bool,
    /// The name of the algorithm that draws its shadows, where the text asks for one.
    pub shadows: Option<Arc<str>>,
}

impl Light {
    /// Whether it gives no light, whatever values live numbers have.
    pub fn is_dark(&self) -> bool {
        let (Strength::Power(strength) | Strength::Luminance(strength) | Strength::Illuminance(strength)) =
            &self.strength;
        let is_black = |color: &[Scalar; 3]| color.iter().all(|component| component.is(0.0));
        let filters_all = match &self.emitter {
            Emitter::Environment { zenith, horizon, ground } => [zenith, horizon, ground].into_iter().all(is_black),
            _ => false,
        };
        strength.is(0.0) || is_black(&self.color) || filters_all
    }
}

/// The shape of a light. Flat ones lie in the plane z = 0 and shine towards +z. Lengths are in millimetres.
#[derive(Clone, Debug, PartialEq)]
pub enum Emitter {
    /// A sphere about the origin.
    Sphere {
        /// Its radius.
        radius: Scalar,
    },
    /// A disk about the origin.
    Disk {
        /// Its radius.
        radius: Scalar,
    },
    /// A rectangle about the origin.
    Rect {
        /// Its width along x and height along y.
        size: [Scalar; 2],
    },
    /// A cylinder about the x axis, its middle at the origin; its ends are dark.
    Tube {
        /// Its radius.
        radius: Scalar,
        /// Its length.
        length: Scalar,
    },
    /// A simple polygon, three corners or more, anticlockwise as seen from +z.
    Polygon {
        /// The corners.
        corners: Vec<[Scalar; 2]>,
    },
    /// A disk infinitely far away, towards +z: placed by rotations only.
    Sun {
        /// The angle that it is seen under, its diameter, in radians.
        angle: Scalar,
    },
    /// The sky all around: a gradient from the horizon to the zenith, and the ground below. Colours in sRGB; each
    /// multiplies the light's own.
    Environment {
        /// Towards +z.
        zenith: [Scalar; 3],
        /// All around.
        horizon: [Scalar; 3],
        /// Towards −z.
        ground: [Scalar; 3],
    },
}

/// How much light a light gives.
#[derive(Clone, Debug, PartialEq)]
pub enum Strength {
    /// Its luminous flux Φ, in lumens. A sphere's luminance is then Φ / (π A) with its area A in square metres.
    Power(Scalar),
    /// Its luminance, in candela per square metre.
    Luminance(Scalar),
    /// The illuminance on a surface that faces it, in lux; of a sun only.
    Illuminance(Scalar),
}

/// A light in the world.
#[derive(Clone, Debug)]
pub struct PlacedLight {
    /// The light.
    pub light: Light,
    /// From its coordinates to the world's.
    pub placement: Affine,
    /// The text it came from: the head of its module's instance.
    pub span: Span,
}
