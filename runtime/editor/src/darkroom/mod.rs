//! Pictures and films for files, drawn at any size on a device of their own while the window goes on.

mod film;
mod set;

use std::path::Path;
use std::sync::Arc;

use chiaro_compiler::Scene;
use chiaro_files::images::{Format, write_exr, write_png};
use chiaro_render::{Gpu, Inspection, Inspector, Model, Preference, View};

use crate::session::Session;
use crate::studio::{Eye, Look, Program, Wanted};
use crate::worker::Progress;
pub(crate) use film::{CLOCK, Film, FilmFormat, film};
use set::Set;

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

impl Shot {
    /// The picture in the window, if there is one: the scene as it is seen there.
    pub(crate) fn of(session: &Session, adapter: Preference, size: [u32; 2], samples: u32) -> Option<Self> {
        let scene = session.shown.as_ref()?.scene.clone();
        Some(Self { scene, program: session.program(), wanted: session.wanted().clone(), adapter, size, samples })
    }

    /// How many steps of progress it takes: one for each sample, if it has any.
    fn steps(&self) -> u64 {
        match self.wanted.look {
            Look::Lit => self.samples.into(),
            Look::Inspected(_) => 1,
        }
    }
}

/// Draws a picture into a file, PNG or EXR by the ending of its name. An error says what went wrong; none, if it was
/// cancelled.
pub(crate) fn still(shot: &Shot, path: &Path, progress: &Progress) -> Result<(), String> {
    let format = Format::of(path).map_err(|error| format!("{error:#}"))?;
    progress.expect(shot.steps());
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
    let view = seen(gpu, &model, &shot.wanted.eye, &shot.scene, shot.size)?;
    let mut inspector = Inspector::new(gpu, &model).map_err(said)?;
    inspector.set_parameters(&values).map_err(said)?;
    let drawing = inspector.draw_while(view, shot.size, inspection, &|| !progress.is_cancelled()).map_err(said)?;
    progress.step();
    Ok(drawing.map(|drawing| drawing.pixels))
}

/// From where a scene is seen in a picture of that size.
fn seen(gpu: &Gpu, model: &Model, eye: &Eye, scene: &Scene, size: [u32; 2]) -> Result<View, String> {
    match eye {
        Eye::At(view) => Ok(*view),
        eye => View::framing_model(gpu, model, &eye.camera(&scene.camera), aspect(size)).map_err(said),
    }
}

fn aspect([width, height]: [u32; 2]) -> f64 {
    f64::from(width) / f64::from(height.max(1))
}

fn said(error: impl std::fmt::Display) -> String {
    error.to_string()
}
