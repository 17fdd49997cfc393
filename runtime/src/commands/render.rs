//! `chiaro render`: draws a scene into a picture, or into one for each moment of `$t`.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::{Result, bail};
use chiaro_compiler::Scene;
use chiaro_compiler::field::Graph;
use chiaro_compiler::solid::{Camera, PlacedLight};
use chiaro_compiler::syntax::Sources;
use chiaro_compiler::vocabulary::Bounds;
use chiaro_render::{Error, Floor, Gpu, Lighting, Model, Picture, View};
use indicatif::ProgressBar;

use crate::arguments::{Global, Render, SceneArguments};
use crate::images::{self, Format};
use crate::{compile, output, terminal};

/// The name of OpenSCAD's clock, which goes from 0 to 1.
const CLOCK: &str = "$t";

pub(crate) fn run(arguments: &Render, global: &Global) -> Result<ExitCode> {
    let format = format(arguments)?;
    let compilation = compile::compilation(&arguments.scene, global)?;
    let Some(scene) = &compilation.scene else { return Ok(ExitCode::FAILURE) };
    compile::drawn(draw(scene, &compilation.sources, arguments, format, global), &compilation.sources, global)
}

/// The format that the output's name asks for.
fn format(arguments: &Render) -> Result<Format> {
    if !output::is_standard(&arguments.output) {
        return Format::of(&arguments.output);
    }
    if arguments.frames.is_some() {
        bail!("the pictures of --frames are several files, and standard output is one");
    }
    Ok(Format::Png)
}

fn draw(scene: &Scene, sources: &Sources, arguments: &Render, format: Format, global: &Global) -> Result<ExitCode> {
    let gpu = Gpu::new(&arguments.adapter.preference())?;
    let graph = scene.picture();
    let model = Model::new(&gpu, &graph, &scene.defaults())?;
    terminal::report(sources, &model.notes(&graph), global)?;
    let mut studio = Studio::new(&gpu, scene, &graph, &model, arguments)?;

    let frames = arguments.frames.unwrap_or(1);
    let progress = terminal::progress(global, u64::from(frames) * u64::from(arguments.samples), "samples");
    for frame in 0..frames {
        if arguments.frames.is_some() {
            let time = f64::from(frame) / f64::from(frames);
            if studio.has_clock() {
                studio.set_time(&gpu, &graph, time, arguments)?;
            } else if frame > 0 {
                let Some(scene) = scene_at(time, &arguments.scene, global)? else { return Ok(ExitCode::FAILURE) };
                studio.replace(&gpu, &scene, arguments)?;
            }
        }
        if arguments.one_pass {
            studio.picture.draw_in_one_pass()?;
        } else {
            studio.draw(arguments.samples, &progress)?;
        }
        let path = match arguments.frames {
            Some(count) => numbered(&arguments.output, frame, count),
            None => arguments.output.clone(),
        };
        studio.write(&path, format, arguments.size)?;
    }
    progress.finish_and_clear();
    Ok(ExitCode::SUCCESS)
}

/// The scene compiled for another time, where the clock is not live because it decides the scene's structure.
fn scene_at(time: f64, arguments: &SceneArguments, global: &Global) -> Result<Option<Scene>> {
    let mut arguments = arguments.clone();
    arguments.definitions.push((CLOCK.to_owned(), time.to_string()));
    // What there is to say about the scene was said of the first frame; but errors may be new.
    compile::scene(&arguments, &Global { quiet: true, ..*global })
}

/// The camera that the command line asks for, else the scene's.
fn camera(scene: &Scene, arguments: &Render) -> Camera {
    arguments.view.map_or_else(|| scene.camera.clone(), |view| view.apply(&scene.camera))
}

/// A scene with its picture in progress.
struct Studio {
    camera: Camera,
    lights: Vec<PlacedLight>,
    /// The box that is framed where the camera leaves something open.
    frame: Bounds,
    aspect: f64,
    /// The first view: the lights stand as it sees them.
    first_view: View,
    floor: Floor,
    /// The live parameters' values.
    values: Vec<f64>,
    /// Which of them is the clock, if any.
    clock: Option<usize>,
    picture: Picture,
}

impl Studio {
    fn new(gpu: &Gpu, scene: &Scene, graph: &Graph, model: &Model, arguments: &Render) -> Result<Self> {
        let camera = camera(scene, arguments);
        let values = scene.defaults();
        let (width, height) = arguments.size;
        let aspect = f64::from(width) / f64::from(height);

        let clock = scene.parameters.iter().position(|parameter| &*parameter.name == CLOCK);
        // What moves is framed as far as it may reach, so that neither the view nor the floor moves with it.
        let reach = graph.facts[graph.root.0 as usize].bounds;
        let moves = arguments.frames.is_some() && clock.is_some() && reach.is_finite();
        let frame = if moves { reach } else { model.extent(gpu)? };
        let floor = match (arguments.no_floor, arguments.frames) {
            (true, _) => Floor::Missing,
            (false, Some(_)) => Floor::At(frame.min[2]),
            (false, None) => Floor::Measured,
        };
        // All pictures of a movement are seen from the same place; a single one is filled by what it shows.
        let view = match arguments.frames {
            Some(_) => View::framing(&camera, &values, &frame, aspect),
            None => View::framing_model(gpu, model, &camera, aspect)?,
        };
        let mut picture = Picture::new(gpu, model, view, [width, height])?;
        picture.set_floor(floor)?;
        let mut studio = Self {
            camera,
            lights: scene.lights.clone(),
            frame,
            aspect,
            first_view: view,
            floor,
            values,
            clock,
            picture,
        };
        studio.picture.set_direct(arguments.shadows.0)?;
        studio.picture.set_cells(arguments.shadow_cells)?;
        studio.place_lights()?;
        Ok(studio)
    }

    /// Moves the clock, and the camera if the scene moves it. No pipeline is made for it, unless the form of the last ones
    /// does not do any more.
    fn set_time(&mut self, gpu: &Gpu, graph: &Graph, time: f64, arguments: &Render) -> Result<()> {
        if let Some(clock) = self.clock {
            self.values[clock] = time;
        }
        match self.picture.set_parameters(&self.values) {
            Err(Error::Dense { .. }) => return self.remake(gpu, graph, arguments),
            moved => moved?,
        }
        self.place_lights()?;
        self.picture.set_view(View::framing(&self.camera, &self.values, &self.frame, self.aspect))?;
        Ok(())
    }

    fn has_clock(&self) -> bool {
        self.clock.is_some()
    }

    /// Draws another scene in the same frame, seen as it says.
    fn replace(&mut self, gpu: &Gpu, scene: &Scene, arguments: &Render) -> Result<()> {
        self.camera = camera(scene, arguments);
        self.values = scene.defaults();
        self.lights = scene.lights.clone();
        self.remake(gpu, &scene.picture(), arguments)
    }

    /// Compiles a field, and draws it in the same frame.
    fn remake(&mut self, gpu: &Gpu, graph: &Graph, arguments: &Render) -> Result<()> {
        let model = Model::new(gpu, graph, &self.values)?;
        let view = View::framing(&self.camera, &self.values, &self.frame, self.aspect);
        self.picture = Picture::new(gpu, &model, self.first_view, self.picture.size())?;
        self.picture.set_view(view)?;
        self.picture.set_floor(self.floor)?;
        self.picture.set_direct(arguments.shadows.0)?;
        self.picture.set_cells(arguments.shadow_cells)?;
        self.place_lights()
    }

    /// Lights the scene by its own lights, if it has any.
    fn place_lights(&mut self) -> Result<()> {
        if !self.lights.is_empty() {
            self.picture.set_lighting(Lighting::of(&self.lights, &self.values, &self.picture.view()))?;
        }
        Ok(())
    }

    fn draw(&mut self, samples: u32, progress: &ProgressBar) -> Result<()> {
        for _ in 0..samples {
            self.picture.sample()?;
            progress.inc(1);
        }
        Ok(())
    }

    fn write(&self, path: &Path, format: Format, size: (u32, u32)) -> Result<()> {
        let bytes = match format {
            Format::Png => images::png(size, self.picture.resolve()?),
            Format::Exr => images::exr(size, &self.picture.hdr()?),
        };
        output::write(path, &bytes?)
    }
}

/// `clock.png` as `clock_07.png`, with as many digits as the last frame needs.
fn numbered(path: &Path, frame: u32, count: u32) -> PathBuf {
    let digits = (count - 1).to_string().len();
    let mut name = path.file_stem().unwrap_or_default().to_owned();
    name.push(format!("_{frame:0digits$}."));
    name.push(path.extension().unwrap_or_default());
    path.with_file_name(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_sort_by_name() {
        let path = Path::new("out/clock.png");
        assert_eq!(numbered(path, 7, 24), Path::new("out/clock_07.png"));
        assert_eq!(numbered(path, 0, 1), Path::new("out/clock_0.png"));
    }
}
