//! Adding lights to a picture.

use std::time::Duration;

use chiaro_shader::Template;
use wgpu::{BindGroup, Buffer};

use crate::error::Result;
use crate::gpu::Gpu;
use crate::kernel::{Slot, buffer, workgroups};
use crate::model::{Model, Program};
use crate::shadow::Receivers;
use crate::stopwatch::Stopwatch;

/// What adds a light to a picture, by how much of it the receivers see.
#[derive(Debug)]
pub(crate) struct ShadePass {
    program: Program,
    light: Buffer,
    groups: [BindGroup; 2],
}

impl ShadePass {
    /// For the receivers of a picture's parts; `view` is its uniform.
    pub(crate) fn new(gpu: &Gpu, model: &Model, receivers: &Receivers, sums: &Buffer, view: &Buffer) -> Result<Self> {
        let slots = [(0, Slot::Read), (1, Slot::Read), (2, Slot::Read), (3, Slot::ReadWrite), (4, Slot::Read)];
        let program = model.program(gpu, Template::Shade, "shade", &slots)?;
        let light = buffer(gpu, "light's index", Slot::Read, 16)?;
        let own = [
            (0, receivers.receivers.as_entire_binding()),
            (1, receivers.lights.as_entire_binding()),
            (2, receivers.visibilities.as_entire_binding()),
            (3, sums.as_entire_binding()),
            (4, light.as_entire_binding()),
        ];
        let groups = [program.bind_shared(gpu, Some(view))?, program.kernel.bind(gpu, 1, &own)?];
        Ok(Self { program, light, groups })
    }

    /// Adds the light of this index to a part of this size.
    pub(crate) fn run(&self, gpu: &Gpu, stopwatch: &Stopwatch, light: u32, size: [u32; 2]) -> Result<Duration> {
        gpu.queue.write_buffer(&self.light, 0, bytemuck::bytes_of(&[light, 0, 0, 0]));
        self.program.kernel.run(gpu, stopwatch, &self.groups.each_ref(), workgroups(size))
    }
}
