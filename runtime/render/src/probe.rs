//! Asking the field itself, on the device.

use chiaro_field::Graph;
use chiaro_shader::Template;

use crate::crowds::LargeUnions;
use crate::error::Result;
use crate::gpu::Gpu;
use crate::kernel::{Slot, buffer};
use crate::model::{Program, Source};
use crate::stopwatch::Stopwatch;

/// The edge of a dispatch of many workgroups.
const ROW: u32 = 32768;

/// The scene's signed distance in millimetres at each of the points, as pictures find it: away from a large union it may be
/// less, by a factor of up to √2.
pub fn distances(gpu: &Gpu, graph: &Graph, parameters: &[f64], points: &[[f64; 3]]) -> Result<Vec<f32>> {
    let program = Program::distances(gpu, graph, parameters)?;
    program.set_parameters(gpu, parameters)?;
    program.ask(gpu, points)
}

impl Program {
    /// The program that answers distances to a scene while its live numbers have these values, or others set later.
    pub(crate) fn distances(gpu: &Gpu, graph: &Graph, parameters: &[f64]) -> Result<Self> {
        let source = Source::of(graph, &LargeUnions::new(gpu, graph, parameters)?, Template::Distances)?;
        Program::new(gpu, source, "distances", false, &[(0, Slot::Read), (1, Slot::ReadWrite)])
    }

    /// The distances at these points.
    pub(crate) fn ask(&self, gpu: &Gpu, points: &[[f64; 3]]) -> Result<Vec<f32>> {
        if points.is_empty() {
            return Ok(Vec::new());
        }
        let rows: Vec<[f32; 4]> = points.iter().map(|&[x, y, z]| [x as f32, y as f32, z as f32, 0.0]).collect();
        let questions = buffer(gpu, "points", Slot::Read, 16 * rows.len() as u64)?;
        let answers = buffer(gpu, "distances", Slot::ReadWrite, 4 * rows.len() as u64)?;
        gpu.queue.write_buffer(&questions, 0, bytemuck::cast_slice(&rows));
        let shared = self.bind_shared(gpu, None)?;
        let own = [(0, questions.as_entire_binding()), (1, answers.as_entire_binding())];
        let own = self.kernel.bind(gpu, 1, &own)?;

        let workgroups = (rows.len() as u32).div_ceil(64);
        let rows = [workgroups.min(ROW), workgroups.div_ceil(ROW)];
        self.kernel.run(gpu, &Stopwatch::new(gpu)?, &[&shared, &own], rows)?;
        Ok(bytemuck::pod_collect_to_vec(&gpu.read(&answers)?))
    }
}
