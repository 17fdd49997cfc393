//! A picture that gets better with every sample.

use std::time::Duration;

use chiaro_shader::{Setting, Shadows};
use wgpu::{BindGroup, Buffer, Texture};

use crate::cells::MOST_CELLS;
use crate::error::{Error, Result};
use crate::gpu::Gpu;
use crate::kernel::{Slot, buffer, workgroups};
use crate::lights::{Direct, Lighting};
use crate::model::{Model, Program};
use crate::one_pass::{self, Eye, OnePass};
use crate::parts::Parts;
use crate::resolve::Resolver;
use crate::shade::ShadePass;
use crate::shadow::{DRAWN_LIGHT, Receivers, ShadowPass, Task};
use crate::stopwatch::Stopwatch;
use crate::uniform::{Level, Studio, ViewUniform};
use crate::view::View;

/// What the largest buffer of a picture takes for each pixel.
pub(crate) const BYTES_PER_PIXEL: u64 = 16;

/// The edges in pixels of the prepass's tiles, from coarse to fine; the last is `START_EDGE` of `trace_meet.wgsl`.
const LEVEL_EDGES: [u32; 2] = [16, 4];

/// A picture of a model from a view. It starts black; every sample adds a path of light for each pixel.
#[derive(Debug)]
pub struct Picture {
    gpu: Gpu,
    model: Model,
    size: [u32; 2],
    view: View,
    studio: Studio,
    floor: Floor,
    /// Brightness as a factor.
    exposure: f32,
    uses_prepass: bool,
    lighting: Lighting,
    direct: Direct,
    /// How many cells shadow methods cut a light into.
    cells: u32,
    buffers: Buffers,
    /// The shadow methods used so far.
    shadow_passes: Vec<(Shadows, ShadowPass)>,
    shade_pass: ShadePass,
    resolver: Resolver,
    levels: Vec<Level>,
    parts: Parts,
    samples: u32,
    /// Whether the prepass's depths are those of the view and the live numbers.
    has_starts: bool,
    timings: Timings,
    stopwatch: Stopwatch,
}

/// Where the studio's floor is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Floor {
    /// Under the scene's lowest point, wherever the live numbers move it.
    #[default]
    Measured,
    /// At this height, in millimetres.
    At(f64),
    /// Nowhere.
    Missing,
}

/// How long the last runs took on the device, by its own clock where it has one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Timings {
    /// The prepass.
    pub prepass: Duration,
    /// The last whole sample of every pixel.
    pub sample: Duration,
    /// What the sample in progress took so far.
    pub so_far: Duration,
}

/// How often the scene was evaluated, on average for a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Evaluations {
    /// For the prepass, once per view.
    pub prepass: f64,
    /// For one sample.
    pub sample: f64,
}

#[derive(Debug)]
struct Buffers {
    view: Buffer,
    starts: Buffer,
    sums: Buffer,
    receivers: Receivers,
    prepass_groups: [BindGroup; 2],
    trace_groups: [BindGroup; 2],
}

/// Into how many cells verified cones cut a light unless a caller says otherwise.
const DEFAULT_CELLS: u32 = 19;
/// How many rays are drawn at once, or drivers would end them.
const MOST_RAYS: u32 = 8;
/// How direct light is found unless a light or a caller says otherwise.
pub(crate) const DEFAULT_DIRECT: Direct = Direct::By(Shadows::Verified);

impl Picture {
    /// A picture of `size` pixels (width, height). The studio's lights stand as this view sees them, and stay there
    /// when the view changes.
    pub fn new(gpu: &Gpu, model: &Model, view: View, size: [u32; 2]) -> Result<Self> {
        let [width, height] = size;
        let (longest_edge, most_pixels) = (gpu.longest_edge(), gpu.most_pixels());
        let pixels = u64::from(width) * u64::from(height);
        if pixels == 0 || pixels > most_pixels || width.max(height) > longest_edge {
            return Err(Error::PictureSize { width, height, longest_edge, most_pixels });
        }
        let levels = levels(size);
        let studio = Studio { floor: model.lowest(gpu)?, azimuth: view.rotation[2].to_radians() };
        let lighting = Lighting::studio(studio.azimuth);
        let parts = Parts::new(size);
        let receivers = Receivers::new(gpu, parts.most_pixels(), &lighting.rows(DEFAULT_DIRECT))?;
        let buffers = Buffers::new(gpu, model, size, &levels, receivers)?;
        let shade_pass = ShadePass::new(gpu, model, &buffers.receivers, &buffers.sums, &buffers.view)?;
        let resolver = Resolver::new(gpu, size, &buffers.sums)?;
        Ok(Self {
            gpu: gpu.clone(),
            model: model.clone(),
            size,
            view,
            studio,
            floor: Floor::Measured,
            exposure: 1.0,
            uses_prepass: true,
            lighting,
            direct: DEFAULT_DIRECT,
            cells: DEFAULT_CELLS,
            buffers,
            shadow_passes: Vec::new(),
            shade_pass,
            resolver,
            levels,
            parts,
            samples: 0,
            has_starts: false,
            timings: Timings::default(),
            stopwatch: Stopwatch::new(gpu)?,
        })
    }

    /// Looks from elsewhere, and starts anew.
    pub fn set_view(&mut self, view: View) -> Result<()> {
        self.view = view;
        self.restart()
    }

    /// Moves the live numbers to these values, in the order of their ids, and starts anew.
    pub fn set_parameters(&mut self, parameters: &[f64]) -> Result<()> {
        self.model.set_parameters(&self.gpu, parameters)?;
        self.place_floor()?;
        self.restart()
    }

    /// Lights the scene by these lights instead of the studio's, and starts anew.
    pub fn set_lighting(&mut self, lighting: Lighting) -> Result<()> {
        self.lighting = lighting;
        self.place_lights()?;
        self.restart()
    }

    /// Chooses how direct light is found, but for lights that ask for a method of their own, and starts anew.
    pub fn set_direct(&mut self, direct: Direct) -> Result<()> {
        self.direct = direct;
        self.place_lights()?;
        self.restart()
    }

    /// Chooses how many cells verified cones cut a light into, and starts anew: from 1 to 64. Methods that draw
    /// rays draw at most eight at once.
    pub fn set_cells(&mut self, cells: u32) -> Result<()> {
        self.cells = cells.clamp(1, MOST_CELLS);
        self.restart()
    }

    /// Moves the floor, and starts anew.
    pub fn set_floor(&mut self, floor: Floor) -> Result<()> {
        self.floor = floor;
        self.place_floor()?;
        self.restart()
    }

    /// Sets the brightness as a factor; it needs no new samples.
    pub fn set_exposure(&mut self, exposure: f32) {
        self.exposure = exposure;
    }

    /// Decides whether rays start where the cone prepass ended, and starts anew. It is on unless switched off to
    /// measure what it saves.
    pub fn set_prepass(&mut self, on: bool) -> Result<()> {
        self.uses_prepass = on;
        self.restart()
    }

    /// Width and height in pixels.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// From where it is seen.
    pub fn view(&self) -> View {
        self.view
    }

    /// How many samples each pixel has; while one is in progress, some have one more.
    pub fn samples(&self) -> u32 {
        self.samples
    }

    /// Adds a sample to every pixel.
    pub fn sample(&mut self) -> Result<()> {
        while !self.step()? {}
        Ok(())
    }

    /// Adds a sample to some pixels, for about a tenth of a second; true if the sample is now complete.
    pub fn step(&mut self) -> Result<bool> {
        if !self.has_starts {
            self.run_prepass()?;
        }
        let part = self.parts.current();
        let finest = self.levels[self.levels.len() - 1];
        let uniform = self.uniform().at_sample(self.samples, part, finest, self.uses_prepass);
        let mut took = self.run(&self.model.trace, &self.buffers.trace_groups, &uniform, part.size)?;
        took += self.light(part.size)?;
        self.timings.so_far += took;
        let complete = self.parts.advance(took);
        if complete {
            self.samples += 1;
            self.timings.sample = std::mem::take(&mut self.timings.so_far);
        }
        Ok(complete)
    }

    /// Draws the whole picture in one pass, as exported shaders draw it, in the place of all samples.
    pub fn draw_in_one_pass(&mut self) -> Result<()> {
        self.restart()?;
        let Buffers { receivers, sums, view, .. } = &self.buffers;
        let pass = OnePass::new(&self.gpu, &self.model, &receivers.lights, sums, view)?;
        let finest = self.levels[self.levels.len() - 1];
        let mut took = Duration::ZERO;
        loop {
            let part = self.parts.current();
            let uniform = self.uniform().at_sample(0, part, finest, false);
            self.gpu.queue.write_buffer(view, 0, bytemuck::bytes_of(&uniform));
            let of_part = pass.run(&self.gpu, &self.stopwatch, part.size)?;
            took += of_part;
            if self.parts.advance(of_part) {
                break;
            }
        }
        self.timings = Timings { sample: took, ..Timings::default() };
        self.samples = 1;
        Ok(())
    }

    /// What an exported shader has to know of the scene as it stands.
    pub fn setting(&self) -> Setting {
        one_pass::setting(&self.uniform(), &self.lighting, &self.lighting.rows(self.direct))
    }

    /// From where it is seen, as a shader has to know it.
    pub fn eye(&self) -> Eye {
        one_pass::eye(&self.uniform())
    }

    /// The picture so far for a screen: rows from the top, red, green, blue and alpha in 8 bits of sRGB each.
    pub fn resolve(&self) -> Result<Vec<u8>> {
        self.resolver.run(&self.gpu, self.samples, self.exposure)?;
        self.resolver.read(&self.gpu)
    }

    /// The picture so far in a texture of the device, which stays the same one. Its format is `Rgba8Unorm`, its
    /// contents are encoded as sRGB.
    pub fn texture(&self) -> Result<&Texture> {
        self.resolver.run(&self.gpu, self.samples, self.exposure)
    }

    /// The radiance of each pixel so far: rows from the top, linear red, green, blue and 1. Of a scene with lights in
    /// candela per square metre; in the studio, a white surface in full light is about 1.
    pub fn hdr(&self) -> Result<Vec<[f32; 4]>> {
        let scale = 1.0 / (self.samples.max(1) as f32 * self.lighting.exposure as f32);
        let radiance = |sum: [f32; 4]| [sum[0] * scale, sum[1] * scale, sum[2] * scale, 1.0];
        Ok(self.sums()?.into_iter().map(radiance).collect())
    }

    /// How often the scene was evaluated for the samples so far.
    pub fn evaluations(&self) -> Result<Evaluations> {
        let pixels = f64::from(self.size[0]) * f64::from(self.size[1]);
        let traced: f64 = self.sums()?.iter().map(|sum| f64::from(sum[3])).sum();
        let bytes = self.gpu.read(&self.buffers.starts)?;
        let starts: Vec<[f32; 2]> = bytemuck::pod_collect_to_vec(&bytes);
        let prepass: f64 = starts.iter().map(|start| f64::from(start[1])).sum();
        Ok(Evaluations { prepass: prepass / pixels, sample: traced / pixels / f64::from(self.samples.max(1)) })
    }

    /// How long the last runs took.
    pub fn timings(&self) -> Timings {
        self.timings
    }

    /// Lights what the part's pixels see by the lights that are not sampled.
    fn light(&mut self, size: [u32; 2]) -> Result<Duration> {
        let mut took = Duration::ZERO;
        for (light, method) in self.lit_by() {
            let cells = if method == Shadows::Verified { self.cells } else { self.cells.min(MOST_RAYS) };
            let task = Task::new(light, self.samples, cells, size);
            let pass = self.shadow_pass(method)?;
            took += self.shadow_passes[pass].1.run(&self.gpu, &self.stopwatch, task)?;
            took += self.shade_pass.run(&self.gpu, &self.stopwatch, light, size)?;
        }
        Ok(took)
    }

    /// The lights that are not sampled, with their methods. Where there are too many, `DRAWN_LIGHT` stands for those that
    /// share the picture's method.
    fn lit_by(&self) -> Vec<(u32, Shadows)> {
        let are_many = self.lighting.are_many();
        let by_method = |direct: Direct| match direct {
            Direct::By(method) => Some(method),
            Direct::Sampled => None,
        };
        let drawn = by_method(self.direct).filter(|_| are_many).map(|method| (DRAWN_LIGHT, method));
        let single = self.lighting.lights.iter().enumerate().filter_map(|(index, light)| {
            let direct = if are_many { light.shadows } else { light.shadows.or(Some(self.direct)) };
            Some((index as u32, by_method(direct?)?))
        });
        single.chain(drawn).collect()
    }

    /// The index of a method's pass, which is compiled when first asked for.
    fn shadow_pass(&mut self, method: Shadows) -> Result<usize> {
        if let Some(index) = self.shadow_passes.iter().position(|(known, _)| *known == method) {
            return Ok(index);
        }
        let Buffers { receivers, view, .. } = &self.buffers;
        let pass = ShadowPass::new(&self.gpu, &self.model, method, receivers, view)?;
        self.shadow_passes.push((method, pass));
        Ok(self.shadow_passes.len() - 1)
    }

    /// Gives the lights to the kernels.
    fn place_lights(&mut self) -> Result<()> {
        let rows = self.lighting.rows(self.direct);
        if self.buffers.receivers.set_lights(&self.gpu, &rows) {
            return Ok(());
        }
        let receivers = Receivers::new(&self.gpu, self.parts.most_pixels(), &rows)?;
        self.buffers = Buffers::new(&self.gpu, &self.model, self.size, &self.levels, receivers)?;
        let Buffers { receivers, sums, view, .. } = &self.buffers;
        self.shade_pass = ShadePass::new(&self.gpu, &self.model, receivers, sums, view)?;
        self.resolver = Resolver::new(&self.gpu, self.size, sums)?;
        self.shadow_passes.clear();
        Ok(())
    }

    fn place_floor(&mut self) -> Result<()> {
        self.studio.floor = match self.floor {
            Floor::Measured => self.model.lowest(&self.gpu)?,
            Floor::At(height) => Some(height),
            Floor::Missing => None,
        };
        Ok(())
    }

    /// Forgets all samples.
    pub fn restart(&mut self) -> Result<()> {
        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        encoder.clear_buffer(&self.buffers.sums, 0, None);
        self.gpu.finish(encoder)?;
        self.samples = 0;
        self.parts.restart();
        self.has_starts = false;
        self.timings.so_far = Duration::ZERO;
        Ok(())
    }

    fn run_prepass(&mut self) -> Result<()> {
        let mut took = Duration::ZERO;
        let mut before = None;
        for &level in self.levels.iter().filter(|_| self.uses_prepass) {
            let uniform = self.uniform().at_level(level, before, true);
            let tiles = self.size.map(|edge| edge.div_ceil(level.edge));
            took += self.run(&self.model.prepass, &self.buffers.prepass_groups, &uniform, tiles)?;
            before = Some(level);
        }
        self.timings.prepass = took;
        self.has_starts = true;
        Ok(())
    }

    /// Runs a program with one invocation for each of `invocations`.
    fn run(
        &self,
        program: &Program,
        groups: &[BindGroup; 2],
        uniform: &ViewUniform,
        invocations: [u32; 2],
    ) -> Result<Duration> {
        self.gpu.queue.write_buffer(&self.buffers.view, 0, bytemuck::bytes_of(uniform));
        program.kernel.run(&self.gpu, &self.stopwatch, &groups.each_ref(), workgroups(invocations))
    }

    fn uniform(&self) -> ViewUniform {
        ViewUniform::new(&self.view, &self.model.bounds(), self.model.lipschitz, self.studio, self.size)
            .within(&self.lighting)
    }

    fn sums(&self) -> Result<Vec<[f32; 4]>> {
        Ok(bytemuck::pod_collect_to_vec(&self.gpu.read(&self.buffers.sums)?))
    }
}

impl Buffers {
    fn new(gpu: &Gpu, model: &Model, size: [u32; 2], levels: &[Level], receivers: Receivers) -> Result<Self> {
        let pixels = u64::from(size[0]) * u64::from(size[1]);
        let tiles: u64 = levels.iter().map(|level| tiles(size, level.edge)).sum();
        let view = buffer(gpu, "view", Slot::Uniform, size_of::<ViewUniform>() as u64)?;
        let starts = buffer(gpu, "starting depths", Slot::ReadWrite, 8 * tiles)?;
        let sums = buffer(gpu, "sums of samples", Slot::ReadWrite, BYTES_PER_PIXEL * pixels)?;
        let own_prepass = [(0, starts.as_entire_binding())];
        let own_trace = [
            (0, starts.as_entire_binding()),
            (1, sums.as_entire_binding()),
            (2, receivers.receivers.as_entire_binding()),
            (3, receivers.lights.as_entire_binding()),
        ];
        let prepass_groups =
            [model.prepass.bind_shared(gpu, Some(&view))?, model.prepass.kernel.bind(gpu, 1, &own_prepass)?];
        let trace_groups = [model.trace.bind_shared(gpu, Some(&view))?, model.trace.kernel.bind(gpu, 1, &own_trace)?];
        Ok(Self { view, starts, sums, receivers, prepass_groups, trace_groups })
    }
}

/// The levels of the prepass, stored one behind the other.
pub(crate) fn levels(size: [u32; 2]) -> Vec<Level> {
    let mut first = 0;
    LEVEL_EDGES
        .iter()
        .map(|&edge| {
            let level = Level { edge, first };
            first += tiles(size, edge) as u32;
            level
        })
        .collect()
}

pub(crate) fn tiles(size: [u32; 2], edge: u32) -> u64 {
    u64::from(size[0].div_ceil(edge)) * u64::from(size[1].div_ceil(edge))
}
