//! Films of the clock `$t`.

use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use chiaro_compiler::compile;
use chiaro_files::{Batch, images};
use chiaro_render::Gpu;

use super::set::Set;
use super::{Shot, inspected, said};
use crate::studio::{BufferWorld, LiveValue, Look};
use crate::worker::Progress;

/// The name of OpenSCAD's clock.
pub(crate) const CLOCK: &str = "$t";

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
    /// The first file that is there already of those that would be written.
    pub(crate) fn occupied(self, path: &Path) -> Option<PathBuf> {
        let count = if self.format == FilmFormat::Sequence { self.frames } else { 1 };
        (0..count).map(|frame| self.file(path, frame)).find(|file| file.exists())
    }

    /// The file of a frame: in a sequence `clock_07.png` for `clock.png`.
    fn file(self, path: &Path, frame: u32) -> PathBuf {
        if self.format == FilmFormat::Animation {
            return path.to_owned();
        }
        let digits = self.frames.saturating_sub(1).to_string().len();
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        let ending = path.extension().unwrap_or_default().to_string_lossy();
        path.with_file_name(format!("{stem}_{frame:0digits$}.{ending}"))
    }

    /// The time of a frame.
    fn time(self, frame: u32) -> f64 {
        let [from, to] = self.range;
        from + (to - from) * f64::from(frame) / f64::from(self.frames.max(1))
    }
}

/// Draws a film into files. Nothing is written of a film that was cancelled or failed.
pub(crate) fn film(shot: &Shot, film: Film, path: &Path, progress: &Progress) -> Result<(), String> {
    progress.expect(u64::from(film.frames) * shot.steps());
    let gpu = Gpu::new(&shot.adapter).map_err(said)?;
    let mut sink = Sink::new(film, shot.size)?;
    let mut set = None;
    for frame in 0..film.frames {
        let now = at_time(shot, film.time(frame))?;
        let Some(pixels) = drawn(&gpu, &mut set, &now, progress)? else { return Ok(()) };
        sink.write(&film.file(path, frame), shot.size, pixels)?;
    }
    sink.finish(path)
}

/// A frame in 8 bits of sRGB and alpha; none, if the film was cancelled. The set goes on from one frame to the next.
fn drawn(gpu: &Gpu, set: &mut Option<Set>, shot: &Shot, progress: &Progress) -> Result<Option<Vec<u8>>, String> {
    if let Look::Inspected(inspection) = shot.wanted.look {
        return inspected(gpu, shot, &inspection, progress);
    }
    let set = match set {
        None => set.insert(Set::new(gpu, shot)?),
        Some(set) => {
            set.go_on(shot)?;
            set
        }
    };
    match set.draw(shot.samples, progress)? {
        true => set.picture.resolve().map(Some).map_err(said),
        false => Ok(None),
    }
}

/// The shot at another time: with the clock moved, or compiled anew where that decides the scene's structure.
fn at_time(shot: &Shot, time: f64) -> Result<Shot, String> {
    let mut shot = shot.clone();
    if shot.scene.parameters.iter().any(|parameter| &*parameter.name == CLOCK) {
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

/// Where the frames go.
enum Sink {
    Files(Batch),
    Animation(Box<png::Writer<Memory>>, Memory),
}

/// Bytes that are written to one after the other, and read at the end.
#[derive(Clone, Default)]
struct Memory(Arc<Mutex<Vec<u8>>>);

impl std::io::Write for Memory {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

impl Sink {
    fn new(film: Film, size: [u32; 2]) -> Result<Self, String> {
        if film.format == FilmFormat::Sequence {
            return Ok(Sink::Files(Batch::default()));
        }
        let memory = Memory::default();
        let mut encoder = png::Encoder::new(memory.clone(), size[0], size[1]);
        encoder.set_color(png::ColorType::Rgba);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_animated(film.frames, 0).map_err(said)?;
        encoder.set_frame_delay(1, film.frames_per_second.max(1)).map_err(said)?;
        Ok(Sink::Animation(Box::new(encoder.write_header().map_err(said)?), memory))
    }

    /// Takes a frame, for a file if it has one of its own.
    fn write(&mut self, file: &Path, [width, height]: [u32; 2], rgba: Vec<u8>) -> Result<(), String> {
        match self {
            Sink::Files(batch) => images::png((width, height), rgba)
                .and_then(|bytes| batch.write(file, &bytes))
                .map_err(|error| format!("{error:#}")),
            Sink::Animation(writer, _) => writer.write_image_data(&rgba).map_err(said),
        }
    }

    fn finish(self, path: &Path) -> Result<(), String> {
        let written = match self {
            Sink::Files(batch) => batch.finish(),
            Sink::Animation(writer, memory) => {
                writer.finish().map_err(said)?;
                let bytes = std::mem::take(&mut *memory.0.lock().unwrap_or_else(PoisonError::into_inner));
                chiaro_files::write(path, &bytes)
            }
        };
        written.map_err(|error| format!("{error:#}"))
    }
}
