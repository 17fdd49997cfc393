//! Pictures for files, drawn at any size on a device of their own while the window goes on.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use chiaro_compiler::vocabulary::Bounds;
use chiaro_compiler::{Scene, compile};
use chiaro_files::images::{Format, write_exr, write_png};
use chiaro_render::{Floor, Gpu, Inspection, Inspector, Lighting, Model, Picture, Preference, View};

use crate::session::Session;
use crate::studio::{BufferWorld, Eye, LiveValue, Look, Program, Wanted};
use crate::worker::Progress;

/// The name of OpenSCAD's clock.
pub(crate) const CLOCK: &str = "$t";

/// What to draw, and how.
#[derive(Clone)]
pub(crate) struct Shot {
    pub(crate) scene: Arc<Scene>,
    /// The text the scene is of, for times that need a scene of their own.
    pub(crate) program: Program,
    pub(crate) wanted: Wanted,
    pub(crate) adapter: Preference,
    /// Width and height in pixels.
    pub(crate) size: [u32; 2],
    /// Samples of each pixel.
    pub(crate) samples: u32,
}

/// The frames of a film.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Film {
    pub(crate) frames: u32,
    /// From which `$t` on, and to which; the last frame is one before it.
    pub(crate) range: [f64; 2],
    pub(crate) frames_per_second: u16,
    pub(crate) format: FilmFormat,
}

/// What a film is written to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FilmFormat {
    /// A PNG file for each frame.
    Sequence,
    /// One animated PNG.
    Animation,
}

impl Film {
    /// The first file that is written.
    pub(crate) fn first_file(&self, path: &Path) -> PathBuf {
        match self.format {
            FilmFormat::Sequence => numbered(path, 0, self.frames),
            FilmFormat::Animation => path.to_owned(),
        }
    }
}

impl Shot {
    /// The picture in the window, if there is one: the scene as it is seen there.
    pub(crate) fn of(session: &Session, adapter: Preference, size: [u32; 2], samples: u32) -> Option<Self> {
        let scene = session.shown.as_ref()?.scene.clone();
        Some(Self { scene, program: session.program(), wanted: session.wanted().clone(), adapter, size, samples })
    }
}

/// Draws a picture into a file, PNG or EXR by the ending of its name. An error says what went wrong; none, if it was
/// cancelled.
pub(crate) fn still(shot: &Shot, path: &Path, progress: &Progress) -> Result<(), String> {
    let format = Format::of(path).map_err(|error| format!("{error:#}"))?;
    progress.expect(shot.samples);
    let gpu = Gpu::new(&shot.adapter).map_err(said)?;
    let size = (shot.size[0], shot.size[1]);
    if let Look::Inspected(inspection) = shot.wanted.look {
        if format == Format::Exr {
            return Err("only what is lit has radiance: write a PNG, or show the scene lit".to_owned());
        }
        return match inspected(&gpu, shot, &inspection, progress)? {
            Some(pixels) => write_png(path, size, pixels).map_err(|error| format!("{error:#}")),
            None => Ok(()),
        };
    }
    let mut set = Set::new(&gpu, shot)?;
    if !set.draw(shot.samples, progress)? {
        return Ok(());
    }
    let written = match format {
        Format::Png => write_png(path, size, set.picture.resolve().map_err(said)?),
        Format::Exr => write_exr(path, size, &set.picture.hdr().map_err(said)?),
    };
    written.map_err(|error| format!("{error:#}"))
}

/// The scene as it is shown when it is not lit, in 8 bits of sRGB and alpha; none, if it was cancelled.
fn inspected(gpu: &Gpu, shot: &Shot, inspection: &Inspection, progress: &Progress) -> Result<Option<Vec<u8>>, String> {
    let values = shot.wanted.parameters(&shot.scene);
    let model = Model::new(gpu, &shot.scene.picture(), &values).map_err(said)?;
    let frame = model.extent(gpu).map_err(said)?;
    let aspect = f64::from(shot.size[0]) / f64::from(shot.size[1].max(1));
    let view = match shot.wanted.eye {
        Eye::At(view) => view,
        eye => View::framing(&eye.camera(&shot.scene.camera), &values, &frame, aspect),
    };
    let mut inspector = Inspector::new(gpu, &model).map_err(said)?;
    inspector.set_parameters(&values).map_err(said)?;
    let drawing = inspector.draw_while(view, shot.size, inspection, &|| !progress.is_cancelled()).map_err(said)?;
    Ok(drawing.map(|drawing| drawing.pixels))
}

/// Draws a film into files. Nothing is left of a film that was cancelled or failed.
pub(crate) fn film(shot: &Shot, film: Film, path: &Path, progress: &Progress) -> Result<(), String> {
    progress.expect(film.frames * shot.samples);
    let gpu = Gpu::new(&shot.adapter).map_err(said)?;
    let mut sink = Sink::new(film, shot.size, path)?;
    let result = frames(&gpu, shot, film, &mut sink, progress);
    match result {
        Ok(true) => sink.finish(path),
        other => {
            sink.discard();
            other.map(|_| ())
        }
    }
}

/// True if all frames were drawn.
fn frames(gpu: &Gpu, shot: &Shot, film: Film, sink: &mut Sink, progress: &Progress) -> Result<bool, String> {
    let [from, to] = film.range;
    let time = |frame: u32| from + (to - from) * f64::from(frame) / f64::from(film.frames.max(1));
    let has_clock = shot.scene.parameters.iter().any(|parameter| &*parameter.name == CLOCK);
    let first = at_time(shot, time(0), has_clock)?;
    let mut set = Set::new(gpu, &first)?;
    for frame in 0..film.frames {
        if frame > 0 {
            let shot = at_time(shot, time(frame), has_clock)?;
            if has_clock { set.set_time(&shot)? } else { set.replace(gpu, &shot)? }
        }
        if !set.draw(shot.samples, progress)? {
            return Ok(false);
        }
        sink.write(frame, set.picture.resolve().map_err(said)?)?;
    }
    Ok(true)
}

/// The shot at another time: with the clock moved, or compiled anew where that decides the scene's structure.
fn at_time(shot: &Shot, time: f64, has_clock: bool) -> Result<Shot, String> {
    let mut shot = shot.clone();
    if has_clock {
        shot.wanted.values.retain(|value| value.name != CLOCK);
        shot.wanted.values.push(LiveValue { name: CLOCK.to_owned(), component: None, value: time });
        return Ok(shot);
    }
    let mut options = shot.program.options.clone();
    options.definitions.retain(|(name, _)| name != CLOCK);
    options.definitions.push((CLOCK.to_owned(), time.to_string()));
    let compilation = compile(&BufferWorld::new(shot.program.buffers.clone()), &shot.program.main, &options);
    shot.scene = Arc::new(compilation.scene.ok_or_else(|| format!("the scene has errors when $t is {time}"))?);
    Ok(shot)
}

/// A scene with its picture in progress.
struct Set {
    scene: Arc<Scene>,
    wanted: Wanted,
    aspect: f64,
    /// The box that is framed where nothing says from where to look.
    frame: Bounds,
    /// The first view: the studio's lights stand as it sees them.
    first_view: View,
    picture: Picture,
}

impl Set {
    fn new(gpu: &Gpu, shot: &Shot) -> Result<Self, String> {
        let values = shot.wanted.parameters(&shot.scene);
        let model = Model::new(gpu, &shot.scene.picture(), &values).map_err(said)?;
        let frame = model.extent(gpu).map_err(said)?;
        let aspect = f64::from(shot.size[0]) / f64::from(shot.size[1].max(1));
        let first_view = View::framing_model(gpu, &model, &shot.scene.camera, aspect).map_err(said)?;
        let picture = Picture::new(gpu, &model, first_view, shot.size).map_err(said)?;
        let (scene, wanted) = (shot.scene.clone(), shot.wanted.clone());
        let mut set = Self { scene, wanted, aspect, frame, first_view, picture };
        set.prepare()?;
        Ok(set)
    }

    /// Another scene, seen in the same way.
    fn replace(&mut self, gpu: &Gpu, shot: &Shot) -> Result<(), String> {
        let model = Model::new(gpu, &shot.scene.picture(), &shot.wanted.parameters(&shot.scene)).map_err(said)?;
        self.picture = Picture::new(gpu, &model, self.first_view, self.picture.size()).map_err(said)?;
        (self.scene, self.wanted) = (shot.scene.clone(), shot.wanted.clone());
        self.prepare()
    }

    /// The same scene at another time.
    fn set_time(&mut self, shot: &Shot) -> Result<(), String> {
        self.wanted = shot.wanted.clone();
        self.picture.set_parameters(&self.wanted.parameters(&self.scene)).map_err(said)?;
        self.place()
    }

    fn prepare(&mut self) -> Result<(), String> {
        self.picture.set_exposure(self.wanted.exposure.exp2());
        let floor = if self.wanted.floor { Floor::At(self.frame.min[2]) } else { Floor::Missing };
        self.picture.set_floor(floor).map_err(said)?;
        self.picture.set_direct(self.wanted.direct).map_err(said)?;
        self.place()
    }

    /// Puts the camera and the lights where they are now.
    fn place(&mut self) -> Result<(), String> {
        let values = self.wanted.parameters(&self.scene);
        let view = match self.wanted.eye {
            Eye::At(view) => view,
            eye => View::framing(&eye.camera(&self.scene.camera), &values, &self.frame, self.aspect),
        };
        self.picture.set_view(view).map_err(said)?;
        if !self.scene.lights.is_empty() {
            self.picture.set_lighting(Lighting::of(&self.scene.lights, &values, &view)).map_err(said)?;
        }
        Ok(())
    }

    /// Draws that many samples; false if it was cancelled.
    fn draw(&mut self, samples: u32, progress: &Progress) -> Result<bool, String> {
        for _ in 0..samples {
            while !self.picture.step().map_err(said)? {
                if progress.is_cancelled() {
                    return Ok(false);
                }
            }
            if progress.is_cancelled() {
                return Ok(false);
            }
            progress.step();
        }
        Ok(true)
    }
}

/// Where the frames go.
enum Sink {
    Files { path: PathBuf, count: u32, size: [u32; 2], written: Vec<PathBuf> },
    Animation(Box<png::Writer<Memory>>, Memory),
}

/// Bytes that are written to one after the other, and read at the end.
#[derive(Clone, Default)]
struct Memory(Arc<std::sync::Mutex<Vec<u8>>>);

impl std::io::Write for Memory {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.0.lock().unwrap_or_else(std::sync::PoisonError::into_inner).extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

impl Sink {
    fn new(film: Film, size: [u32; 2], path: &Path) -> Result<Self, String> {
        if film.format == FilmFormat::Sequence {
            return Ok(Sink::Files { path: path.to_owned(), count: film.frames, size, written: Vec::new() });
        }
        let memory = Memory::default();
        let mut encoder = png::Encoder::new(memory.clone(), size[0], size[1]);
        encoder.set_color(png::ColorType::Rgba);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_animated(film.frames, 0).map_err(said)?;
        encoder.set_frame_delay(1, film.frames_per_second.max(1)).map_err(said)?;
        Ok(Sink::Animation(Box::new(encoder.write_header().map_err(said)?), memory))
    }

    fn write(&mut self, frame: u32, rgba: Vec<u8>) -> Result<(), String> {
        match self {
            Sink::Files { path, count, size, written } => {
                let path = numbered(path, frame, *count);
                write_png(&path, (size[0], size[1]), rgba).map_err(|error| format!("{error:#}"))?;
                written.push(path);
                Ok(())
            }
            Sink::Animation(writer, _) => writer.write_image_data(&rgba).map_err(said),
        }
    }

    fn finish(self, path: &Path) -> Result<(), String> {
        let Sink::Animation(writer, memory) = self else { return Ok(()) };
        writer.finish().map_err(said)?;
        let bytes = std::mem::take(&mut *memory.0.lock().unwrap_or_else(std::sync::PoisonError::into_inner));
        chiaro_files::write(path, &bytes).map_err(|error| format!("{error:#}"))
    }

    /// Removes what was written.
    fn discard(self) {
        if let Sink::Files { written, .. } = self {
            for path in written {
                // It may be gone already.
                let _ = std::fs::remove_file(path);
            }
        }
    }
}

fn said(error: impl std::fmt::Display) -> String {
    error.to_string()
}

/// `clock.png` as `clock_07.png`, with as many digits as the last frame needs.
fn numbered(path: &Path, frame: u32, count: u32) -> PathBuf {
    let digits = count.saturating_sub(1).to_string().len();
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let ending = path.extension().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!("{stem}_{frame:0digits$}.{ending}"))
}
