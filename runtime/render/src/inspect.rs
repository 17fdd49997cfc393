//! Looking at a scene other than lit: what the pixels' rays meet, what that cost, and the field itself.
//!
//! One ray a pixel and no light, so that a view is drawn as fast as it is moved.

mod classes;
mod colors;
mod legend;

use std::time::Duration;

use bytemuck::pod_collect_to_vec;
use chiaro_shader::{Inspect, Template};
use wgpu::{BindGroup, Buffer};

use crate::crowds::LargeUnions;
use crate::error::{Error, Result};
use crate::gpu::Gpu;
use crate::kernel::{Slot, buffer, workgroups};
use crate::model::{Model, Program, Source};
use crate::parts::Parts;
use crate::picture::{levels, tiles};
use crate::stopwatch::Stopwatch;
use crate::uniform::{Studio, ViewUniform};
use crate::view::View;

pub use legend::{Legend, Mark};

/// What is shown of a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Inspection {
    /// The normals as colours: red for x, green for y, blue for z; half of each for 0.
    Normals,
    /// How far the surface is from the eye: the nearest is white.
    Depth,
    /// How often the scene was evaluated for the ray through each pixel.
    Evaluations,
    /// The scene cut open by a plane, on which the distance's contours are drawn.
    Section(Plane),
    /// What the distances of the operand that made the surface are: exact everywhere, exact outside, or a bound; redder where
    /// anything in it is steep. Its Lipschitz constant L tells by how much: distances are divided by it before they are
    /// compared with others, which takes rays more steps.
    FieldClass,
    /// How far the slope of the distance is from 1, on a plane or else on the surface. Where a distance is exact its slope is
    /// 1; so that is what tells without knowing the true distance. A slope of 1 does not prove it.
    DistanceError(Option<Plane>),
}

/// A plane in the world: the points whose product with the normal is the offset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// Its normal, not zero, of any length.
    pub normal: [f64; 3],
    /// The offset; in millimetres, if the normal has a length of 1.
    pub offset: f64,
}

/// An inspection's picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Rows from the top: red, green, blue in sRGB and opacity, which is not multiplied in, in 8 bits each. Where nothing
    /// is seen all are 0.
    pub pixels: Vec<u8>,
    /// What the colours mean.
    pub legend: Legend,
}

/// Draws inspections of a model. It follows the model's live numbers.
#[derive(Debug)]
pub struct Inspector {
    gpu: Gpu,
    model: Model,
    surface: Program,
    /// Compiled when first asked for.
    section: Option<Program>,
    classes: Option<Program>,
    view: Buffer,
    cut: Buffer,
    screen: Option<Screen>,
    stopwatch: Stopwatch,
    time: Duration,
}

/// What the pixels of a view see.
#[derive(Debug)]
struct Screen {
    look: Look,
    positions: Buffer,
    normals: Buffer,
    evaluations: Buffer,
    sections: Buffer,
    /// The prepass's depths.
    starts: Buffer,
    /// Where pixels see a surface, once somebody asked.
    seen: Option<Vec<[f32; 4]>>,
}

/// What decides what the pixels see.
#[derive(Clone, Debug, PartialEq)]
struct Look {
    view: View,
    size: [u32; 2],
    cut: Option<Plane>,
    parameters: Vec<f64>,
    /// Whether rays start where the prepass ended.
    prepass: bool,
}

/// What the largest buffer takes for each pixel.
const BYTES_PER_PIXEL: u64 = 16;
/// The edge of a dispatch of many workgroups.
const ROW: u32 = 32768;

impl Inspection {
    /// The plane that cuts the scene open.
    fn plane(&self) -> Option<Plane> {
        match self {
            Inspection::Section(plane) => Some(*plane),
            Inspection::DistanceError(plane) => *plane,
            _ => None,
        }
    }
}

impl Inspector {
    /// Compiles what all inspections of a model share; the rest is compiled when it is first asked for.
    pub fn new(gpu: &Gpu, model: &Model) -> Result<Self> {
        let own = [(1, Slot::ReadWrite), (2, Slot::ReadWrite), (3, Slot::ReadWrite)];
        let slots = [&[(0, Slot::Read)], &own[..], &[(4, Slot::Read)]].concat();
        Ok(Self {
            gpu: gpu.clone(),
            model: model.clone(),
            surface: model.program(gpu, Template::Inspect(Inspect::Surface), "inspect", &slots)?,
            section: None,
            classes: None,
            view: buffer(gpu, "view", Slot::Uniform, size_of::<ViewUniform>() as u64)?,
            cut: buffer(gpu, "plane", Slot::Read, 32)?,
            screen: None,
            stopwatch: Stopwatch::new(gpu)?,
            time: Duration::ZERO,
        })
    }

    /// Moves the model's live numbers to these values, in the order of their ids. (A picture of the same model moves them
    /// too; it has to be told itself to start anew.)
    pub fn set_parameters(&mut self, parameters: &[f64]) -> Result<()> {
        self.model.set_parameters(&self.gpu, parameters)
    }

    /// Draws an inspection of `size` pixels (width, height). What the rays met is kept until the view, the size, the plane
    /// or a live number changes.
    pub fn draw(&mut self, view: View, size: [u32; 2], inspection: &Inspection) -> Result<Drawing> {
        let drawing = self.draw_while(view, size, inspection, &|| true)?;
        Ok(drawing.unwrap_or_else(|| unreachable!("nobody interrupted it")))
    }

    /// The same, as long as `goes_on` says so, which is asked about ten times a second; none if it said no.
    pub fn draw_while(
        &mut self,
        view: View,
        size: [u32; 2],
        inspection: &Inspection,
        goes_on: &dyn Fn() -> bool,
    ) -> Result<Option<Drawing>> {
        self.time = Duration::ZERO;
        let prepass = *inspection != Inspection::Evaluations;
        if !self.see(view, size, inspection.plane(), prepass, goes_on)? {
            return Ok(None);
        }
        let drawing = match inspection {
            Inspection::Normals => colors::normals(size, &self.normals()?),
            Inspection::Depth => colors::depth(size, &self.positions()?),
            Inspection::Evaluations => colors::evaluations(size, &self.evaluations()?),
            Inspection::Section(_) => {
                let Some(sections) = self.sections(goes_on)? else { return Ok(None) };
                colors::section(size, &sections, &self.positions()?, &self.normals()?, view.pixel_angle(size))
            }
            Inspection::FieldClass => {
                let classes = self.classes()?;
                colors::classes(size, &classes, &self.positions()?, &self.normals()?)
            }
            Inspection::DistanceError(None) => colors::slopes(size, &self.positions()?, &self.normals()?),
            Inspection::DistanceError(Some(_)) => {
                let Some(sections) = self.sections(goes_on)? else { return Ok(None) };
                colors::section_slopes(size, &sections)
            }
        };
        Ok(Some(drawing))
    }

    /// Finds what pixels see, cut open by a plane if there is one.
    pub fn look(&mut self, view: View, size: [u32; 2], cut: Option<Plane>) -> Result<()> {
        self.look_while(view, size, cut, &|| true).map(|_| ())
    }

    /// The same, as long as `goes_on` says so; false if it was interrupted, and then no pixel sees anything.
    pub fn look_while(
        &mut self,
        view: View,
        size: [u32; 2],
        cut: Option<Plane>,
        goes_on: &dyn Fn() -> bool,
    ) -> Result<bool> {
        self.see(view, size, cut, true, goes_on)
    }

    fn see(
        &mut self,
        view: View,
        size: [u32; 2],
        cut: Option<Plane>,
        prepass: bool,
        goes_on: &dyn Fn() -> bool,
    ) -> Result<bool> {
        let look = Look { view, size, cut, parameters: self.model.parameters(), prepass };
        if self.screen.as_ref().is_some_and(|screen| screen.look == look) {
            return Ok(true);
        }
        self.surface.set_parameters(&self.gpu, &look.parameters)?;
        self.write_plane(cut);
        let screen = match self.screen.take().filter(|screen| screen.look.size == size) {
            Some(screen) => Screen { look, seen: None, ..screen },
            None => Screen::new(&self.gpu, look)?,
        };
        let own = [
            (0, self.cut.as_entire_binding()),
            (1, screen.positions.as_entire_binding()),
            (2, screen.normals.as_entire_binding()),
            (3, screen.evaluations.as_entire_binding()),
            (4, screen.starts.as_entire_binding()),
        ];
        let groups =
            [self.surface.bind_shared(&self.gpu, Some(&self.view))?, self.surface.kernel.bind(&self.gpu, 1, &own)?];
        let free = if prepass { self.run_prepass(&screen)? } else { Duration::ZERO };
        let Some(took) = self.run(&self.surface, &groups, &screen.look, goes_on)? else { return Ok(false) };
        self.time += free + took;
        self.screen = Some(screen);
        Ok(true)
    }

    /// Where the pixels of the last view see a surface, in millimetres: rows from the top. The fourth number is how far from
    /// the eye that is; negative where there is none.
    pub fn positions(&mut self) -> Result<Vec<[f32; 4]>> {
        let Some(screen) = &mut self.screen else { return Ok(Vec::new()) };
        if screen.seen.is_none() {
            screen.seen = Some(pod_collect_to_vec(&self.gpu.read(&screen.positions)?));
        }
        Ok(screen.seen.clone().unwrap_or_default())
    }

    /// The point that a pixel of the last view sees, in millimetres of the world.
    pub fn pick(&mut self, pixel: [u32; 2]) -> Result<Option<[f64; 3]>> {
        let [width, height] = self.size();
        if pixel[0] >= width || pixel[1] >= height {
            return Ok(None);
        }
        let seen = self.positions()?[(pixel[1] * width + pixel[0]) as usize];
        Ok((seen[3] >= 0.0).then(|| [0, 1, 2].map(|axis| f64::from(seen[axis]))))
    }

    /// Width and height of the last view, in pixels.
    pub fn size(&self) -> [u32; 2] {
        self.screen.as_ref().map_or([0; 2], |screen| screen.look.size)
    }

    /// How long the device took for what was drawn last.
    pub fn time(&self) -> Duration {
        self.time
    }

    /// The last view's positions on the device, and the size of a pixel at a distance of 1.
    pub(crate) fn seen(&self) -> Option<(&Buffer, f64)> {
        let screen = self.screen.as_ref()?;
        Some((&screen.positions, screen.look.view.pixel_angle(screen.look.size)))
    }

    pub(crate) fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    fn normals(&self) -> Result<Vec<[f32; 4]>> {
        let Some(screen) = &self.screen else { return Ok(Vec::new()) };
        Ok(pod_collect_to_vec(&self.gpu.read(&screen.normals)?))
    }

    fn evaluations(&self) -> Result<Vec<u32>> {
        let Some(screen) = &self.screen else { return Ok(Vec::new()) };
        Ok(pod_collect_to_vec(&self.gpu.read(&screen.evaluations)?))
    }

    /// The distances where the last view's pixels see its plane.
    fn sections(&mut self, goes_on: &dyn Fn() -> bool) -> Result<Option<Vec<[f32; 4]>>> {
        if self.section.is_none() {
            let slots = [(0, Slot::Read), (1, Slot::ReadWrite)];
            let template = Template::Inspect(Inspect::Section);
            self.section = Some(self.model.program(&self.gpu, template, "section", &slots)?);
        }
        let (Some(program), Some(screen)) = (&self.section, &self.screen) else { return Ok(None) };
        program.set_parameters(&self.gpu, &screen.look.parameters)?;
        let own = [(0, self.cut.as_entire_binding()), (1, screen.sections.as_entire_binding())];
        let groups = [program.bind_shared(&self.gpu, Some(&self.view))?, program.kernel.bind(&self.gpu, 1, &own)?];
        let took = self.run(program, &groups, &screen.look, goes_on)?;
        let Some(took) = took else { return Ok(None) };
        let sections = pod_collect_to_vec(&self.gpu.read(&screen.sections)?);
        self.time += took;
        Ok(Some(sections))
    }

    /// What the field is where the last view's pixels see a surface.
    fn classes(&mut self) -> Result<Vec<[f32; 4]>> {
        if self.classes.is_none() {
            let slots = [(0, Slot::Read), (1, Slot::ReadWrite)];
            let graph = classes::painted(&self.model.graph);
            let unions = LargeUnions::new(&self.gpu, &graph, &self.model.parameters())?;
            let source = Source::of(&graph, &unions, Template::Inspect(Inspect::Materials))?;
            self.classes = Some(Program::new(&self.gpu, source, "inspect_materials", false, &slots)?);
        }
        let (Some(program), Some(screen)) = (&self.classes, &self.screen) else { return Ok(Vec::new()) };
        program.set_parameters(&self.gpu, &screen.look.parameters)?;
        // A section's buffer is free to be used: the next section is computed anew.
        let own = [(0, screen.positions.as_entire_binding()), (1, screen.sections.as_entire_binding())];
        let groups = [program.bind_shared(&self.gpu, None)?, program.kernel.bind(&self.gpu, 1, &own)?];
        let [width, height] = screen.look.size;
        let count = (width * height).div_ceil(64);
        let rows = [count.min(ROW), count.div_ceil(ROW)];
        let took = program.kernel.run(&self.gpu, &self.stopwatch, &groups.each_ref(), rows)?;
        let classes = pod_collect_to_vec(&self.gpu.read(&screen.sections)?);
        self.time += took;
        Ok(classes)
    }

    /// Finds where rays may start.
    fn run_prepass(&self, screen: &Screen) -> Result<Duration> {
        let (program, look) = (&self.model.prepass, &screen.look);
        program.set_parameters(&self.gpu, &look.parameters)?;
        let own = [(0, screen.starts.as_entire_binding())];
        let groups = [program.bind_shared(&self.gpu, Some(&self.view))?, program.kernel.bind(&self.gpu, 1, &own)?];
        let mut took = Duration::ZERO;
        let mut before = None;
        for level in levels(look.size) {
            let uniform = self.uniform(look).at_level(level, before, true);
            self.gpu.queue.write_buffer(&self.view, 0, bytemuck::bytes_of(&uniform));
            let tiles = workgroups(look.size.map(|edge| edge.div_ceil(level.edge)));
            took += program.kernel.run(&self.gpu, &self.stopwatch, &groups.each_ref(), tiles)?;
            before = Some(level);
        }
        Ok(took)
    }

    fn uniform(&self, look: &Look) -> ViewUniform {
        let studio = Studio { floor: None, azimuth: 0.0 };
        ViewUniform::new(&look.view, &self.model.bounds(), self.model.lipschitz, studio, look.size)
    }

    /// Runs a program for each pixel, part by part, as long as `goes_on` says so; none if it said no.
    fn run(
        &self,
        program: &Program,
        groups: &[BindGroup; 2],
        look: &Look,
        goes_on: &dyn Fn() -> bool,
    ) -> Result<Option<Duration>> {
        let levels = levels(look.size);
        let (uniform, finest) = (self.uniform(look), levels[levels.len() - 1]);
        let mut parts = Parts::new(look.size);
        let mut took = Duration::ZERO;
        while goes_on() {
            let part = parts.current();
            let of_part = uniform.at_sample(0, part, finest, look.prepass);
            self.gpu.queue.write_buffer(&self.view, 0, bytemuck::bytes_of(&of_part));
            let of_part = program.kernel.run(&self.gpu, &self.stopwatch, &groups.each_ref(), workgroups(part.size))?;
            took += of_part;
            if parts.advance(of_part) {
                return Ok(Some(took));
            }
        }
        Ok(None)
    }

    fn write_plane(&self, plane: Option<Plane>) {
        let length = |plane: &Plane| plane.normal.iter().map(|x| x * x).sum::<f64>().sqrt();
        let plane = plane.filter(|plane| length(plane) > 0.0 && length(plane).is_finite());
        let row = plane.map_or([0.0; 4], |plane| {
            let [x, y, z] = plane.normal;
            [x, y, z, plane.offset].map(|number| (number / length(&plane)) as f32)
        });
        let rows = [row, [f32::from(u8::from(plane.is_some())), 0.0, 0.0, 0.0]];
        self.gpu.queue.write_buffer(&self.cut, 0, bytemuck::cast_slice(&rows));
    }
}

impl Screen {
    fn new(gpu: &Gpu, look: Look) -> Result<Self> {
        let [width, height] = look.size;
        let pixels = u64::from(width) * u64::from(height);
        let (longest_edge, most_pixels) = (gpu.longest_edge(), gpu.most_pixels());
        if pixels == 0 || pixels > most_pixels || width.max(height) > longest_edge {
            return Err(Error::PictureSize { width, height, longest_edge, most_pixels });
        }
        let rows = |what, bytes| buffer(gpu, what, Slot::ReadWrite, bytes * pixels);
        let tiles: u64 = levels(look.size).iter().map(|level| tiles(look.size, level.edge)).sum();
        Ok(Self {
            look,
            starts: buffer(gpu, "starting depths", Slot::ReadWrite, 8 * tiles)?,
            positions: rows("positions", BYTES_PER_PIXEL)?,
            normals: rows("normals", BYTES_PER_PIXEL)?,
            evaluations: rows("evaluations", 4)?,
            sections: rows("sections", BYTES_PER_PIXEL)?,
            seen: None,
        })
    }
}
