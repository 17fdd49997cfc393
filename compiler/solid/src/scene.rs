//! A whole scene.

use std::sync::Arc;

use crate::light::PlacedLight;
use crate::scalar::{LiveParameter, Scalar};
use crate::tree::Solid;

/// What a scene's text comes to.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Everything there is to see.
    pub root: Arc<Solid>,
    /// Its lights, in the order of the text.
    pub lights: Vec<PlacedLight>,
    /// From where it is seen.
    pub camera: Camera,
    /// The numbers that move without a recompilation, in the order of their ids.
    pub parameters: Vec<LiveParameter>,
}

/// OpenSCAD's view, as far as the scene sets it by assigning `$vpt`, `$vpr`, `$vpd` and `$vpf` at its top level, or by
/// `camera`, which counts more. What it leaves open is framed from the bounds.
#[derive(Clone, Debug, Default)]
pub struct Camera {
    /// `$vpt`: the point looked at, in millimetres.
    pub target: Option<[Scalar; 3]>,
    /// Where the eye is, in millimetres, if `camera` says so; then rotation and distance follow from it and the target.
    pub eye: Option<[Scalar; 3]>,
    /// `$vpr`: how the scene is turned before the camera, in degrees about x, y and z; [55, 0, 25] by default.
    pub rotation: Option<[Scalar; 3]>,
    /// `$vpd`: the distance from the target, in millimetres.
    pub distance: Option<Scalar>,
    /// `$vpf`: the vertical field of view, in degrees; 22.5 by default.
    pub field_of_view: Option<Scalar>,
}

/// How a surface answers light.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Colour in sRGB with opacity, each from 0 to 1, as OpenSCAD's `color` takes it.
    pub color: [Scalar; 4],
    /// From 0, a mirror, to 1, chalk.
    pub roughness: Scalar,
    /// 0 for a dielectric such as plastic, 1 for a metal.
    pub metallic: Scalar,
    /// Light given off, as a multiple of the colour.
    pub emission: Scalar,
}

impl Material {
    /// Of this colour, and otherwise like what nobody painted.
    pub fn of_color(color: [Scalar; 4]) -> Self {
        Self { color, ..Self::default() }
    }
}

impl Default for Material {
    /// What nobody painted: a warm, slightly glossy plastic.
    fn default() -> Self {
        Self {
            color: [0.93, 0.72, 0.28, 1.0].map(Scalar::from),
            roughness: Scalar::from(0.45),
            metallic: Scalar::from(0.0),
            emission: Scalar::from(0.0),
        }
    }
}
