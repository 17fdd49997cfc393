//! Which pixels show a part of the scene.

use chiaro_field::Graph;

use crate::error::Result;
use crate::gpu::Gpu;
use crate::inspect::Inspector;
use crate::kernel::{Slot, buffer};
use crate::model::Program;
use crate::stopwatch::Stopwatch;

/// How many parts stay compiled.
const MOST_PARTS: usize = 24;
/// How far from the part's surface a point may be that shows it, in pixels: primary rays end nearer to the surface.
const TOLERANCE: f64 = 0.25;
/// The same as a part of the distance from the eye: what f32 can't tell.
const PRECISION: f64 = 4e-6;
/// The edge of a dispatch of many workgroups.
const ROW: u32 = 32768;

/// Finds which pixels show parts of a scene, such as the solid that an expression made.
#[derive(Debug, Default)]
pub struct Masker {
    /// What tells a part's kernel from another's, and the kernel; the one used last is the last.
    compiled: Vec<(String, Program)>,
}

/// The pixels that show something.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mask {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Whether each pixel shows it: rows from the top.
    pub covered: Vec<bool>,
}

impl Masker {
    /// The pixels of the inspector's last view whose surface is also that of this field; its live numbers have these
    /// values. Compiles the field unless it did so lately.
    pub fn mask(&mut self, inspector: &mut Inspector, part: &Graph, parameters: &[f64]) -> Result<Mask> {
        let gpu = inspector.gpu().clone();
        let seen = inspector.positions()?;
        let size = inspector.size();
        let Some((positions, pixel_angle)) = inspector.seen() else {
            return Ok(Mask { size, covered: Vec::new() });
        };
        let program = self.program(&gpu, part, parameters)?;
        program.set_parameters(&gpu, parameters)?;
        let answers = buffer(&gpu, "distances", Slot::ReadWrite, 4 * seen.len() as u64)?;
        let own = [(0, positions.as_entire_binding()), (1, answers.as_entire_binding())];
        let groups = [program.bind_shared(&gpu, None)?, program.kernel.bind(&gpu, 1, &own)?];
        let count = (seen.len() as u32).div_ceil(64);
        let rows = [count.min(ROW), count.div_ceil(ROW)];
        program.kernel.run(&gpu, &Stopwatch::new(&gpu)?, &groups.each_ref(), rows)?;
        let distances: Vec<f32> = bytemuck::pod_collect_to_vec(&gpu.read(&answers)?);

        let shows = |(seen, distance): (&[f32; 4], &f32)| {
            let depth = f64::from(seen[3]);
            depth >= 0.0 && f64::from(distance.abs()) <= depth * (TOLERANCE * pixel_angle + PRECISION)
        };
        Ok(Mask { size, covered: seen.iter().zip(&distances).map(shows).collect() })
    }

    /// The part's kernel, compiled unless it is known.
    fn program(&mut self, gpu: &Gpu, part: &Graph, parameters: &[f64]) -> Result<&Program> {
        let key = format!("{:?} {:?} {:?} {:?}", part.root, part.points, part.nodes, part.slots);
        let known = match self.compiled.iter().position(|(known, _)| *known == key) {
            Some(index) => self.compiled.remove(index),
            None => (key, Program::distances(gpu, part, parameters)?),
        };
        if self.compiled.len() == MOST_PARTS {
            self.compiled.remove(0);
        }
        self.compiled.push(known);
        Ok(&self.compiled[self.compiled.len() - 1].1)
    }
}

impl Mask {
    /// Whether a pixel shows it; those beside the picture don't.
    pub fn shows(&self, x: i64, y: i64) -> bool {
        let [width, height] = self.size.map(i64::from);
        (0..width).contains(&x) && (0..height).contains(&y) && self.covered[(y * width + x) as usize]
    }

    /// The pixels that show it and have a neighbour that does not; those at the picture's edge are none.
    pub fn outline(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        let [width, height] = self.size;
        let inside = move |x: i64, y: i64| {
            let (x, y) = (x.clamp(0, i64::from(width) - 1), y.clamp(0, i64::from(height) - 1));
            self.shows(x, y)
        };
        let pixels = (0..height).flat_map(move |y| (0..width).map(move |x| [x, y]));
        pixels.filter(move |[x, y]| {
            let (x, y) = (i64::from(*x), i64::from(*y));
            let around = [(x - 1, y), (x + 1, y), (x, y - 1), (x, y + 1)];
            self.shows(x, y) && around.iter().any(|(x, y)| !inside(*x, *y))
        })
    }
}
