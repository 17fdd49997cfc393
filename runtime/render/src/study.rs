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
    /// The irradiance per radiance if nothing covered the light, in closed form.
    pub irradiance: Vec<f32>,
    /// How long it took, by the device's clock if it has one.
    pub time: Duration,
}

/// What random rays converge to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Truth {
    /// V, as in [`Outcome`].
    pub visible: Vec<f32>,
    /// The irradiance per radiance if nothing covered the light, in closed form.
    pub irradiance: Vec<f32>,
    /// E: the irradiance per radiance that arrives, ∫ max(cos θ, 0) dω over what is seen of the light, by the same rays.
    /// A white surface has the radiance E/π.
    pub received: Vec<f32>,
    /// What half the 95 % confidence interval of E is at most, but for one in a hundred of the receivers in penumbrae.
    pub received_half_width: f64,
    /// What half the 95 % confidence interval of V is at most, but for one in a hundred of the receivers in penumbrae.
    /// Of flat lights and tubes, V is weighed by the irradiance as part of the picture's greatest: at a terminator,
    /// where hardly any light arrives, V itself means nothing.
    pub half_width: f64,
    /// How many rays each receiver has drawn that is near a penumbra.
    pub samples: u32,
    /// How many each pixel has drawn on average.
    pub mean_samples: f64,
    /// How often the scene was evaluated for each pixel, on average.
    pub evaluations: f64,
}

/// How many independent sequences the truth is drawn with, and Student's factor for their mean's 95 % interval.
const SEQUENCES: u32 = 8;
const STUDENT: f64 = 2.365;
/// How far around a receiver, in pixels, rays have to agree with its own for it to have settled.
const AGREEMENT_REACH: usize = 3;
/// How many random rays a receiver draws in one dispatch.
const RAYS_AT_ONCE: u32 = 8;
/// `WITH_IRRADIANCE` of `monte_carlo.wgsl`.
const WITH_IRRADIANCE: u32 = 1;

impl Outcome {
    /// Adds a share of the rays.
    fn add(&mut self, rows: &[[f32; 4]], share: f32) {
        if self.visible.is_empty() {
            *self = Self {
                visible: vec![0.0; rows.len()],
                bare: vec![0.0; rows.len()],
                evaluations: vec![0.0; rows.len()],
                irradiance: rows.iter().map(|row| row[3]).collect(),
                time: self.time,
            };
        }
        for (pixel, row) in rows.iter().enumerate() {
            self.visible[pixel] += share * row[0];
            self.bare[pixel] += share * row[1];
            self.evaluations[pixel] += row[2];
        }
    }
}

/// What random rays have told of a receiver.
#[derive(Clone, Debug, Default)]
struct Estimate {
    /// For each sequence, the sum of the means of its batches, each of `RAYS_AT_ONCE` rays.
    sums: [f64; SEQUENCES as usize],
    /// How many batches there were, of all sequences together.
    batches: u32,
}

impl Estimate {
    fn add(&mut self, sequence: usize, mean_of_batch: f64) {
        self.sums[sequence] += mean_of_batch;
        self.batches += 1;
    }

    fn rays(&self) -> f64 {
        f64::from(self.batches * RAYS_AT_ONCE)
    }

    fn mean(&self) -> f64 {
        self.sums.iter().sum::<f64>() / f64::from(self.batches.max(1))
    }

    /// Half the 95 % confidence interval of the mean.
    fn half_width(&self) -> f64 {
        let of_each = f64::from(self.batches.max(1)) / f64::from(SEQUENCES);
        let mean = self.mean();
        let squares: f64 = self.sums.iter().map(|sum| (sum / of_each - mean).powi(2)).sum();
        STUDENT * (squares / f64::from((SEQUENCES - 1) * SEQUENCES)).sqrt()
    }

    /// The half width that all but one in a hundred of the receivers in penumbrae keep to.
    fn worst_half_width(estimates: &[Self], weights: &[f64]) -> f64 {
        let in_penumbra = |(estimate, _): &(&Self, &f64)| estimate.mean() > 0.0 && estimate.mean() < 1.0;
        let mut half_widths: Vec<f64> = estimates
            .iter()
            .zip(weights)
            .filter(in_penumbra)
            .map(|(estimate, weight)| weight * estimate.half_width())
            .collect();
        half_widths.sort_by(f64::total_cmp);
        half_widths.get(half_widths.len() * 99 / 100).copied().unwrap_or(0.0)
    }

    /// The same of E, where `visible` is of V.
    fn worst_received(received: &[Self], visible: &[Self]) -> f64 {
        let is_part = |visible: &Self| visible.mean() > 0.0 && visible.mean() < 1.0;
        let in_penumbrae = received.iter().zip(visible).filter(|(_, visible)| is_part(visible));
        let mut half_widths: Vec<f64> = in_penumbrae.map(|(received, _)| received.half_width()).collect();
        half_widths.sort_by(f64::total_cmp);
        half_widths.get(half_widths.len() * 99 / 100).copied().unwrap_or(0.0)
    }
}

/// How much an error of V matters: where V counts by irradiance, as much as there is of it.
fn weights(light: &LightRow, irradiance: &[f32]) -> Vec<f64> {
    let most = irradiance.iter().copied().fold(f32::MIN_POSITIVE, f32::max);
    let is_round = light.round_solid_angle([0.0; 3]).is_some();
    irradiance.iter().map(|e| if is_round { 1.0 } else { f64::from(e / most) }).collect()
}

/// Which receivers see part of a light only, or have a neighbour that does or that sees otherwise.
fn unsettled([width, height]: [u32; 2], estimates: &[Estimate]) -> Vec<bool> {
    let (width, height) = (width as usize, height as usize);
    // Of each row, the least and the greatest mean around each pixel; then of each column.
    let means: Vec<(f64, f64)> = estimates.iter().map(|estimate| (estimate.mean(), estimate.mean())).collect();
    let spread = |of: &[(f64, f64)], at: &dyn Fn(usize) -> usize, count: usize, along: usize| {
        let around = along.saturating_sub(AGREEMENT_REACH)..(along + AGREEMENT_REACH + 1).min(count);
        around.map(|k| of[at(k)]).fold((f64::INFINITY, f64::NEG_INFINITY), |a, b| (a.0.min(b.0), a.1.max(b.1)))
    };
    let rows: Vec<(f64, f64)> =
        (0..means.len()).map(|i| spread(&means, &|k| i / width * width + k, width, i % width)).collect();
    let both = |i: usize| spread(&rows, &|k| k * width + i % width, height, i / width);
    (0..means.len()).map(both).map(|range| range != (0.0, 0.0) && range != (1.0, 1.0)).collect()
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
    /// into such, or of random rays. The time is without that for compiling the method.
    pub fn run(&mut self, method: Shadows, cells: u32, light: &LightRow) -> Result<Outcome> {
        // Drivers may compile within the first run.
        let task = Task::new(0, 0, cells, self.size);
        self.dispatch(method, Task { cells: cells.min(4), ..task }, light)?;
        let mut outcome = Outcome::default();
        let mut done = 0;
        while done < cells.max(1) {
            // Many rays are drawn in several dispatches, or drivers would end them.
            let at_once = if method == Shadows::MonteCarlo { RAYS_AT_ONCE.min(cells - done) } else { cells.max(1) };
            let time = self.dispatch(method, Task { sample: done, cells: at_once, ..task }, light)?;
            outcome.add(&self.visibilities()?, at_once as f32 / cells.max(1) as f32);
            outcome.time += time;
            done += at_once;
        }
        Ok(outcome)
    }

    /// Draws random rays until the 95 % confidence intervals of V, but for one in a hundred of the receivers that see
    /// part of the light, have a half width of at most `half_width`, or until each has drawn `most_samples`.
    ///
    /// The interval is Student's over the means of eight independently scrambled sequences (Owen, "Monte Carlo Variance
    /// of Scrambled Net Quadrature", 1997): the scatter of samples within a sequence would overestimate its error.
    ///
    /// Receivers far from every penumbra draw no more than the first 64 rays: those whose rays, and whose neighbours'
    /// rays within three pixels, all arrived or all did not. By the rule of three, the mean V of such a neighbourhood of
    /// 49 is within 0.001 of theirs with 95 % confidence.
    pub fn truth(&mut self, light: &LightRow, half_width: f64, most_samples: u32) -> Result<Truth> {
        let receivers = self.gpu.read(&self.receivers.receivers)?;
        let truth = self.converged(light, half_width, most_samples, &receivers);
        // Those that have settled are there again for others.
        self.gpu.queue.write_buffer(&self.receivers.receivers, 0, &receivers);
        truth
    }

    fn converged(&mut self, light: &LightRow, half_width: f64, most_samples: u32, receivers: &[u8]) -> Result<Truth> {
        let pixels = (self.size[0] * self.size[1]) as usize;
        let mut estimates = vec![Estimate::default(); pixels];
        let mut received = vec![Estimate::default(); pixels];
        let mut active = vec![true; pixels];
        let mut truth = Truth::default();
        let mut of_each = 0;
        loop {
            let batch = if of_each == 0 { RAYS_AT_ONCE } else { of_each };
            for (sequence, first) in (0..SEQUENCES).flat_map(|s| (0..batch / RAYS_AT_ONCE).map(move |k| (s, k))) {
                let sample = sequence << 16 | (of_each + first * RAYS_AT_ONCE);
                let task = Task { stage: WITH_IRRADIANCE, ..Task::new(0, sample, RAYS_AT_ONCE, self.size) };
                self.dispatch(Shadows::MonteCarlo, task, light)?;
                let rows = self.visibilities()?;
                for (pixel, row) in rows.iter().enumerate().filter(|(pixel, _)| active[*pixel]) {
                    estimates[pixel].add(sequence as usize, f64::from(row[0]));
                    received[pixel].add(sequence as usize, f64::from(row[1]));
                    truth.evaluations += f64::from(row[2]) / pixels as f64;
                }
                if truth.irradiance.is_empty() {
                    truth.irradiance = rows.iter().map(|row| row[3]).collect();
                }
            }
            if of_each == 0 {
                active = unsettled(self.size, &estimates);
                self.keep(&active, receivers);
            }
            of_each += batch;
            truth.half_width = Estimate::worst_half_width(&estimates, &weights(light, &truth.irradiance));
            truth.samples = of_each * SEQUENCES;
            // A sequence has 65536 rays.
            if truth.half_width <= half_width || 2 * truth.samples > most_samples || of_each >= 1 << 15 {
                truth.visible = estimates.iter().map(|estimate| estimate.mean() as f32).collect();
                truth.received = received.iter().map(|estimate| estimate.mean() as f32).collect();
                truth.received_half_width = Estimate::worst_received(&received, &estimates);
                truth.mean_samples = estimates.iter().map(Estimate::rays).sum::<f64>() / pixels as f64;
                return Ok(truth);
            }
        }
    }

    /// Leaves only some of these receivers a surface, so that no others are lit.
    fn keep(&self, active: &[bool], receivers: &[u8]) {
        const OFFSET: std::ops::Range<usize> = 12..16;
        let mut rows = receivers.to_vec();
        for (row, _) in rows.chunks_exact_mut(RECEIVER_BYTES as usize).zip(active).filter(|(_, active)| !**active) {
            row[OFFSET].copy_from_slice(&(-1.0_f32).to_ne_bytes());
        }
        self.gpu.queue.write_buffer(&self.receivers.receivers, 0, &rows);
    }

    fn dispatch(&mut self, method: Shadows, task: Task, light: &LightRow) -> Result<Duration> {
        self.receivers.set_lights(&self.gpu, &[*light]);
        let pass = self.pass(method)?;
        self.passes[pass].1.run(&self.gpu, &self.stopwatch, task)
    }

    fn visibilities(&self) -> Result<Vec<[f32; 4]>> {
        Ok(bytemuck::pod_collect_to_vec(&self.gpu.read(&self.receivers.visibilities)?))
    }

    fn pass(&mut self, method: Shadows) -> Result<usize> {
        if let Some(index) = self.passes.iter().position(|(known, _)| *known == method) {
            return Ok(index);
        }
        let pass = ShadowPass::new(&self.gpu, &self.model, method, &self.receivers, &self.view)?;
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
        let uniform = ViewUniform::new(&view, &self.model.bounds(), self.model.lipschitz, studio, self.size)
            .at_sample(0, whole, Level { edge: 1, first: 0 }, false)
            .receivers_only();
        gpu.queue.write_buffer(&self.view, 0, bytemuck::bytes_of(&uniform));
        program.kernel.run(gpu, &self.stopwatch, &groups, workgroups(self.size))?;
        Ok(())
    }
}
