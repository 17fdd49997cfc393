//! Measuring how far a scene really reaches.
//!
//! The compiler's bounds are sound but may be loose: what a difference cuts off still counts. A floor has to be where
//! the scene ends, and a picture should be filled, so the prepass looks at the scene from outside.

use chiaro_vocabulary::Bounds;
use wgpu::BindGroup;

use crate::error::Result;
use crate::gpu::Gpu;
use crate::kernel::{Slot, buffer, workgroups};
use crate::model::Model;
use crate::stopwatch::Stopwatch;
use crate::uniform::{Level, Studio, ViewUniform};
use crate::view::{View, bounds_support};

/// The edge in pixels of what is seen from a side.
const SIZE: u32 = 128;
/// Widths of cones, in pixels; behind them come rays without width.
const EDGES: [u32; 3] = [16, 4, 1];
/// How many diagonals of the box away the eye is.
const REMOTE: f64 = 16.0;
/// By how much of the diagonal cones may end before the surface. If rays end later, they missed something thin.
const CONES_END_EARLY: f64 = 0.04;

/// The box that the model fills, within its bounds, for its present live numbers.
pub(crate) fn extent(gpu: &Gpu, model: &Model) -> Result<Bounds> {
    let bounds = model.bounds();
    let mut extent = bounds;
    for axis in 0..3 {
        let [below, above] = [-1.0, 1.0].map(|side| {
            let mut direction = [0.0; 3];
            direction[axis] = side;
            support(gpu, model, direction)
        });
        extent.min[axis] = -below?;
        extent.max[axis] = above?;
    }
    // Nothing is to be seen: there is nothing to be framed but the bounds.
    Ok(if extent.is_empty() { bounds } else { extent })
}

/// The height of the model's lowest point, for its present live numbers.
pub(crate) fn lowest(gpu: &Gpu, model: &Model) -> Result<f64> {
    Ok(-support(gpu, model, [0.0, 0.0, -1.0])?)
}

/// How far the model reaches in a direction, for its present live numbers: the most that p · direction is for a point p
/// of it.
pub(crate) fn support(gpu: &Gpu, model: &Model, direction: [f64; 3]) -> Result<f64> {
    let bounds = &model.bounds();
    let (diagonal, size) = (bounds.diagonal(), direction.iter().map(|x| x * x).sum::<f64>().sqrt());
    let distance = REMOTE * diagonal;
    let field_of_view = 2.0 * (0.5 / (REMOTE - 0.5)).atan().to_degrees();
    let eye = [0, 1, 2].map(|axis| bounds.center()[axis] + distance / size * direction[axis]);
    let view = View::from_eye(eye, bounds.center(), field_of_view);

    let of_eye: f64 = (0..3).map(|axis| eye[axis] * direction[axis]).sum();
    let of_bounds = bounds_support(bounds, direction);
    let [by_cones, by_rays] = nearest(gpu, model, &view)?;
    let half_depth: f64 = (0..3).map(|axis| 0.5 * bounds.size()[axis] * direction[axis].abs() / size).sum();
    if by_cones >= distance + half_depth {
        return Ok(of_bounds);
    }
    let thin_missed = by_rays - by_cones > CONES_END_EARLY * diagonal;
    let beyond_eye = if thin_missed { by_cones } else { by_rays };
    Ok(of_bounds.min(of_eye - size * beyond_eye))
}

/// How far before the eye anything begins: never too far by cones, and at least so far by rays.
fn nearest(gpu: &Gpu, model: &Model, view: &View) -> Result<[f64; 2]> {
    let rays = Level { edge: 1, first: 0 };
    let mut levels = vec![rays];
    for edge in EDGES {
        let last = levels[levels.len() - 1];
        levels.push(Level { edge, first: last.first + SIZE.div_ceil(last.edge).pow(2) });
    }
    let tiles = levels.iter().map(|level| u64::from(SIZE.div_ceil(level.edge)).pow(2)).sum::<u64>();

    let program = &model.prepass;
    let uniforms = buffer(gpu, "view", Slot::Uniform, size_of::<ViewUniform>() as u64)?;
    let starts = buffer(gpu, "starting depths", Slot::ReadWrite, 8 * tiles)?;
    let shared = program.bind_shared(gpu, Some(&uniforms))?;
    let own = program.kernel.bind(gpu, 1, &[(0, starts.as_entire_binding())])?;
    let groups: [&BindGroup; 2] = [&shared, &own];

    let studio = Studio { floor: None, azimuth: 0.0 };
    let uniform = ViewUniform::new(view, &model.bounds(), model.lipschitz, studio, [SIZE; 2]);
    let stopwatch = Stopwatch::new(gpu)?;
    let mut before = None;
    for level in levels[1..].iter().chain([&rays]) {
        let of_level = uniform.at_level(*level, before, *level != rays);
        gpu.queue.write_buffer(&uniforms, 0, bytemuck::bytes_of(&of_level));
        program.kernel.run(gpu, &stopwatch, &groups, workgroups([SIZE.div_ceil(level.edge); 2]))?;
        before = Some(*level);
    }

    let depths: Vec<[f32; 2]> = bytemuck::pod_collect_to_vec(&gpu.read(&starts)?);
    let depths = &depths;
    let nearest_of = |level: Level| {
        (0..SIZE * SIZE).map(move |tile| {
            // Depths are along rays: what counts is how far that is along the view's direction.
            let off_axis = |pixel: u32| (f64::from(2 * pixel + 1) / f64::from(SIZE) - 1.0) * view.half_height();
            let (x, y) = (off_axis(tile % SIZE), off_axis(tile / SIZE));
            f64::from(depths[(level.first + tile) as usize][0]) / (1.0 + x * x + y * y).sqrt()
        })
    };
    let finest_cones = levels[levels.len() - 1];
    Ok([finest_cones, rays].map(|level| nearest_of(level).fold(f64::INFINITY, f64::min)))
}
