//! Studying shadow methods: what single lights come to at the centres of a picture's pixels, without noise from
//! anything else.

use std::time::Duration;

use chiaro_shader::Shadows;
use wgpu::{BindGroup, Buffer};

use crate::error::{Error, Result};
use crate::gpu::Gpu;
use crate::kernel::{Slot, buffer, workgroups};
use crate::lights::{Direct, LightRow, Lighting};
use crate::model::Model;
use crate::shadow::{RECEIVER_BYTES, Receivers, ShadowPass, Task};
use crate::stopwatch::Stopwatch;
use crate::uniform::{Level, Part, Studio, ViewUniform};
use crate::view::View;

/// What a picture's pixels see, to be lit by one light after the other.
#[derive(Debug)]
pub struct Study {
    gpu: Gpu,
    model: Model,
    size: [u32; 2],
    view: Buffer,
    receivers: Receivers,
    passes: Vec<(Shadows, ShadowPass)>,
    stopwatch: Stopwatch,
}

/// What a pixel sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Receiver {
    /// The point on the surface, in millimetres.
    pub position: [f32; 3],
    /// How far along the normal shadow rays start, in millimetres; negative if the pixel sees no surface.
    pub offset: f32,
    /// The unit normal, outwards.
    pub normal: [f32; 3],
}

/// What a shadow method answers, for each pixel in rows from the top; 0 where there is no surface.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outcome {
    /// V: the part of the light that is seen, with the receiver's horizon counted as cover; of flat lights and tubes
    /// by irradiance, of others by solid angle.
    pub visible: Vec<f32>,
    /// The same if nothing but the horizon covered the light.
    pub bare: Vec<f32>,
    /// How often the scene was evaluated.
    pub evaluations: Vec<f32>,
    /// How long it took, by the device's clock if it has one.
    pub time: Duration,
}

impl Study {
    /// Traces a ray through the centre of each pixel of a picture of this size.
    pub fn new(gpu: &Gpu, model: &Model, view: View, size: [u32; 2]) -> Result<Self> {
        let [width, height] = size;
        let pixels = u64::from(width) * u64::from(height);
        let limits = gpu.device.limits();
        let most_pixels = limits.max_storage_buffer_binding_size.min(limits.max_buffer_size) / RECEIVER_BYTES;
        if pixels == 0 || pixels > most_pixels || width.max(height) > gpu.longest_edge() {
            return Err(Error::PictureSize { width, height, longest_edge: gpu.longest_edge(), most_pixels });
        }
        let lights = Lighting::studio(0.0).rows(Direct::Sampled);
        let study = Self {
            gpu: gpu.clone(),
            model: model.clone(),
            size,
            view: buffer(gpu, "view", Slot::Uniform, size_of::<ViewUniform>() as u64)?,
            receivers: Receivers::new(gpu, pixels, &lights)?,
            passes: Vec::new(),
            stopwatch: Stopwatch::new(gpu)?,
        };
        study.trace(view)?;
        Ok(study)
    }

    /// What the pixels see: rows from the top.
    pub fn receivers(&self) -> Result<Vec<Receiver>> {
        let rows: Vec<[f32; 16]> = bytemuck::pod_collect_to_vec(&self.gpu.read(&self.receivers.receivers)?);
        let receiver = |row: [f32; 16]| Receiver {
            position: [row[0], row[1], row[2]],
            offset: row[3],
            normal: [row[4], row[5], row[6]],
        };
        Ok(rows.into_iter().map(receiver).collect())
    }

    /// Asks a method how much of a light the receivers see. `cells` is the number of cells of methods that cut lights
    /// into such. The time is without that for compiling the method.
    pub fn run(&mut self, method: Shadows, cells: u32, light: &LightRow) -> Result<Outcome> {
        self.receivers.set_lights(&self.gpu, &[*light]);
        let pass = self.pass(method)?;
        let task = Task { light: 0, sample: 0, cells, receivers: self.size[0] * self.size[1] };
        // Drivers may compile within the first run.
        self.passes[pass].1.run(&self.gpu, &self.stopwatch, Task { receivers: 1, ..task })?;
        let time = self.passes[pass].1.run(&self.gpu, &self.stopwatch, task)?;
        let rows: Vec<[f32; 4]> = bytemuck::pod_collect_to_vec(&self.gpu.read(&self.receivers.visibilities)?);
        let column = |i: usize| rows.iter().map(|row| row[i]).collect();
        Ok(Outcome { visible: column(0), bare: column(1), evaluations: column(2), time })
    }

    fn pass(&mut self, method: Shadows) -> Result<usize> {
        if let Some(index) = self.passes.iter().position(|(known, _)| *known == method) {
            return Ok(index);
        }
        let parameters = self.model.parameters();
        let pass = ShadowPass::new(&self.gpu, &self.model.graph, method, &parameters, &self.receivers, &self.view)?;
        self.passes.push((method, pass));
        Ok(self.passes.len() - 1)
    }

    fn trace(&self, view: View) -> Result<()> {
        let (gpu, program) = (&self.gpu, &self.model.trace);
        let pixels = u64::from(self.size[0]) * u64::from(self.size[1]);
        let starts = buffer(gpu, "starting depths", Slot::ReadWrite, 8 * pixels)?;
        let sums = buffer(gpu, "sums", Slot::ReadWrite, 16 * pixels)?;
        let own = [
            (0, starts.as_entire_binding()),
            (1, sums.as_entire_binding()),
            (2, self.receivers.receivers.as_entire_binding()),
            (3, self.receivers.lights.as_entire_binding()),
        ];
        let shared = program.bind_shared(gpu, Some(&self.view))?;
        let groups: [&BindGroup; 2] = [&shared, &program.kernel.bind(gpu, 1, &own)?];

        let studio = Studio { floor: None, azimuth: 0.0 };
        let whole = Part { origin: [0; 2], size: self.size };
        let uniform = ViewUniform::new(&view, &self.model.bounds, self.model.lipschitz, studio, self.size)
            .at_sample(0, whole, Level { edge: 1, first: 0 }, false)
            .receivers_only();
        gpu.queue.write_buffer(&self.view, 0, bytemuck::bytes_of(&uniform));
        program.kernel.run(gpu, &self.stopwatch, &groups, workgroups(self.size))?;
        Ok(())
    }
}
