//! Shadow passes: how much of a light each receiver of a part sees.

use std::time::Duration;

use chiaro_shader::{Shadows, Template};
use wgpu::{BindGroup, Buffer};

use crate::cells::{MOST_CELLS, cells_of_disc};
use crate::error::Result;
use crate::gpu::Gpu;
use crate::kernel::{Slot, buffer};
use crate::lights::LightRow;
use crate::model::{Model, Program};
use crate::stopwatch::Stopwatch;
use crate::verified::VerifiedPasses;

/// The size of a `Receiver` in bytes.
pub(crate) const RECEIVER_BYTES: u64 = 64;
/// The edge of a dispatch of many workgroups.
const ROW: u32 = 32768;

/// `DRAWN_LIGHT` of `receiver.wgsl`: stands for the light that was drawn for a receiver.
pub(crate) const DRAWN_LIGHT: u32 = u32::MAX;

/// What the passes of a part share: what its pixels see, and how much of a light each sees.
#[derive(Clone, Debug)]
pub(crate) struct Receivers {
    pub(crate) receivers: Buffer,
    pub(crate) visibilities: Buffer,
    pub(crate) lights: Buffer,
    lights_held: usize,
}

impl Receivers {
    /// Room for this many pixels and these lights.
    pub(crate) fn new(gpu: &Gpu, pixels: u64, lights: &[LightRow]) -> Result<Self> {
        let rows = buffer(gpu, "lights", Slot::Read, size_of_val(lights) as u64)?;
        gpu.queue.write_buffer(&rows, 0, bytemuck::cast_slice(lights));
        Ok(Self {
            receivers: buffer(gpu, "receivers", Slot::ReadWrite, RECEIVER_BYTES * pixels)?,
            visibilities: buffer(gpu, "visibilities", Slot::ReadWrite, 16 * pixels)?,
            lights: rows,
            lights_held: lights.len(),
        })
    }

    /// Changes the lights' numbers, if there are as many as before.
    pub(crate) fn set_lights(&self, gpu: &Gpu, lights: &[LightRow]) -> bool {
        if lights.len() == self.lights_held {
            gpu.queue.write_buffer(&self.lights, 0, bytemuck::cast_slice(lights));
        }
        lights.len() == self.lights_held
    }
}

/// `Task` of `shadows/task.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub(crate) struct Task {
    pub(crate) light: u32,
    pub(crate) sample: u32,
    pub(crate) cells: u32,
    pub(crate) receivers: u32,
    pub(crate) width: u32,
    pub(crate) looking: f32,
    pub(crate) following: f32,
    pub(crate) stage: u32,
}

impl Task {
    /// Light a part of this size by the light of this index.
    pub(crate) fn new(light: u32, sample: u32, cells: u32, [width, height]: [u32; 2]) -> Self {
        Self { light, sample, cells, receivers: width * height, width, ..Self::default() }
    }

    /// A buffer for it and the cells of a disc.
    pub(crate) fn buffer(gpu: &Gpu) -> Result<Buffer> {
        buffer(gpu, "task", Slot::Read, size_of::<Task>() as u64 + 16 * u64::from(MOST_CELLS))
    }

    /// Writes it into its buffer.
    pub(crate) fn write(&self, gpu: &Gpu, buffer: &Buffer) {
        let cells = cells_of_disc(self.cells.clamp(1, MOST_CELLS), self.sample);
        gpu.queue.write_buffer(buffer, 0, bytemuck::bytes_of(self));
        gpu.queue.write_buffer(buffer, size_of::<Task>() as u64, bytemuck::cast_slice(&cells));
    }
}

/// A shadow method, compiled for a scene and bound to a part's receivers.
#[derive(Debug)]
pub(crate) enum ShadowPass {
    Single(SinglePass),
    Verified(Box<VerifiedPasses>),
}

/// A method that is one kernel.
#[derive(Debug)]
pub(crate) struct SinglePass {
    program: Program,
    task: Buffer,
    groups: [BindGroup; 2],
}

impl ShadowPass {
    /// Compiles a method, unless the model has it already; `view` is the uniform of the picture.
    pub(crate) fn new(gpu: &Gpu, model: &Model, method: Shadows, receivers: &Receivers, view: &Buffer) -> Result<Self> {
        Ok(match method {
            Shadows::Verified => Self::Verified(Box::new(VerifiedPasses::new(gpu, model, receivers, view)?)),
            _ => Self::Single(SinglePass::new(gpu, model, method, receivers, view)?),
        })
    }

    /// Answers for all receivers of a part, and says how long it took.
    pub(crate) fn run(&self, gpu: &Gpu, stopwatch: &Stopwatch, task: Task) -> Result<Duration> {
        match self {
            Self::Single(pass) => pass.run(gpu, stopwatch, task),
            Self::Verified(passes) => passes.run(gpu, stopwatch, task),
        }
    }
}

impl SinglePass {
    fn new(gpu: &Gpu, model: &Model, method: Shadows, receivers: &Receivers, view: &Buffer) -> Result<Self> {
        let slots = [(0, Slot::Read), (1, Slot::Read), (2, Slot::ReadWrite), (3, Slot::Read)];
        let program = model.program(gpu, Template::Shadows(method), "shadow", &slots)?;
        let task = Task::buffer(gpu)?;
        let own = [
            (0, receivers.receivers.as_entire_binding()),
            (1, receivers.lights.as_entire_binding()),
            (2, receivers.visibilities.as_entire_binding()),
            (3, task.as_entire_binding()),
        ];
        let groups = [program.bind_shared(gpu, Some(view))?, program.kernel.bind(gpu, 1, &own)?];
        Ok(Self { program, task, groups })
    }

    fn run(&self, gpu: &Gpu, stopwatch: &Stopwatch, task: Task) -> Result<Duration> {
        task.write(gpu, &self.task);
        self.program.kernel.run(gpu, stopwatch, &self.groups.each_ref(), linear_workgroups(task.receivers))
    }
}

/// Workgroups of 64 for this many invocations, in rows: no axis of a dispatch may have more than 65535.
pub(crate) fn linear_workgroups(invocations: u32) -> [u32; 2] {
    let groups = invocations.div_ceil(64).max(1);
    [groups.min(ROW), groups.div_ceil(ROW)]
}
