//! Pictures in one pass: as exported shaders draw them, without samples. And what such a shader has to know.

use std::time::Duration;

use chiaro_field::Graph;
use chiaro_shader::{Light, Setting, Sky, Template};
use chiaro_vocabulary::Bounds;
use wgpu::{BindGroup, Buffer};

use crate::error::Result;
use crate::gpu::Gpu;
use crate::kernel::{Slot, workgroups};
use crate::lights::{LightRow, Lighting, Surroundings};
use crate::model::{Model, Program};
use crate::picture::DEFAULT_DIRECT;
use crate::stopwatch::Stopwatch;
use crate::uniform::{Studio, ViewUniform};
use crate::view::{View, drawn_bounds};

/// From where a picture is seen, as shaders need it: lengths in millimetres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eye {
    /// Where the eye is.
    pub position: [f32; 3],
    /// Where it looks, of length 1.
    pub forward: [f32; 3],
    /// The way from the picture's centre to its right edge, on the plane one millimetre before the eye.
    pub right: [f32; 3],
    /// Likewise to its upper edge.
    pub up: [f32; 3],
    /// The angle between neighbouring pixels, in radians.
    pub pixel_angle: f32,
}

/// The pass of a picture.
#[derive(Debug)]
pub(crate) struct OnePass {
    program: Program,
    groups: [BindGroup; 2],
}

impl OnePass {
    /// Compiles the pass, unless the model has it already; `view` is the picture's uniform.
    pub(crate) fn new(gpu: &Gpu, model: &Model, lights: &Buffer, sums: &Buffer, view: &Buffer) -> Result<Self> {
        let slots = [(0, Slot::Read), (1, Slot::ReadWrite)];
        let program = model.program(gpu, Template::OnePass, "draw", &slots)?;
        let own = [(0, lights.as_entire_binding()), (1, sums.as_entire_binding())];
        let groups = [program.bind_shared(gpu, Some(view))?, program.kernel.bind(gpu, 1, &own)?];
        Ok(Self { program, groups })
    }

    /// Draws a part of this size.
    pub(crate) fn run(&self, gpu: &Gpu, stopwatch: &Stopwatch, size: [u32; 2]) -> Result<Duration> {
        self.program.kernel.run(gpu, stopwatch, &self.groups.each_ref(), workgroups(size))
    }
}

/// What an exported shader has to know of a scene that no device draws. `bounds` are the compiler's for the live numbers' present
/// values: where they end, the floor is, be the scene's lowest point above it.
pub fn setting_within_bounds(
    graph: &Graph,
    bounds: &Bounds,
    view: &View,
    lighting: &Lighting,
    size: [u32; 2],
) -> Setting {
    let facts = graph.facts[graph.root.0 as usize];
    let floor = facts.bounds.min[2].is_finite().then_some(drawn_bounds(bounds).min[2]);
    let studio = Studio { floor, azimuth: view.rotation[2].to_radians() };
    let uniform = ViewUniform::new(view, &drawn_bounds(&facts.bounds), facts.lipschitz, studio, size);
    setting(&uniform.within(lighting), lighting, &lighting.rows(DEFAULT_DIRECT))
}

/// What a shader knows of a scene that is lit like this, in numbers.
pub(crate) fn setting(uniform: &ViewUniform, lighting: &Lighting, rows: &[LightRow]) -> Setting {
    let is_studio = lighting.surroundings == Surroundings::Studio;
    let sky = || Sky { zenith: xyz(uniform.zenith), horizon: xyz(uniform.horizon), ground: xyz(uniform.ground) };
    Setting {
        lipschitz: uniform.eye[3],
        epsilon: uniform.box_min[3],
        bounds: [xyz(uniform.box_min), xyz(uniform.box_max)],
        floor: (uniform.studio[1] > 0.5).then_some(uniform.studio[0]),
        azimuth: [uniform.studio[2], uniform.studio[3]],
        sky: (!is_studio).then(sky),
        lights: rows.iter().map(LightRow::exported).collect(),
    }
}

pub(crate) fn eye(uniform: &ViewUniform) -> Eye {
    Eye {
        position: xyz(uniform.eye),
        forward: xyz(uniform.forward),
        right: xyz(uniform.right),
        up: xyz(uniform.up),
        pixel_angle: uniform.forward[3],
    }
}

impl LightRow {
    fn exported(&self) -> Light {
        Light {
            numbers: [self.a, self.b, self.c, self.d],
            radiance: xyz(self.radiance),
            kind: self.kind[0],
            flags: self.kind[1],
        }
    }
}

fn xyz([x, y, z, _]: [f32; 4]) -> [f32; 3] {
    [x, y, z]
}
