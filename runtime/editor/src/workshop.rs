//! Scenes as files of other programs, made while the window goes on.

use std::ops::ControlFlow;
use std::path::Path;

use chiaro_compiler::{Compilation, Scene, compile};
use chiaro_exports::{File, Format, Shaded, mesh, mesh_files, occupied, shader_files, write};
use chiaro_mesh::Detail;
use chiaro_render::{Gpu, Preference, View};

use crate::session::Session;
use crate::studio::{BufferWorld, Program};
use crate::worker::Progress;

/// What is exported: the scene with the values of its parameters as they are in the window.
pub(crate) struct Piece {
    program: Program,
    /// From where it is seen.
    view: Option<View>,
    adapter: Preference,
}

impl Piece {
    /// The scene in the window, seen from where it is seen there; none, if there is no scene yet.
    pub(crate) fn of(session: &Session, view: Option<View>, adapter: Preference) -> Option<Self> {
        session.shown.as_ref()?;
        let mut program = session.program();
        let moved = session.moved();
        program.options.definitions.retain(|(name, _)| !moved.contains_key(name));
        program.options.definitions.extend(moved);
        Some(Self { program, view, adapter })
    }

    /// Writes it. What is at `path` is written over; what stands beside it only if `replaces`. An error says what went wrong.
    pub(crate) fn export(self, format: Format, path: &Path, replaces: bool, progress: &Progress) -> Result<(), String> {
        let world = BufferWorld::new(self.program.buffers.clone());
        let compilation = compile(&world, &self.program.main, &self.program.options);
        let scene = compilation.scene.as_ref().ok_or("the scene has errors")?;
        let files = self.files(&compilation, scene, format, path, progress)?;
        if progress.is_cancelled() {
            return Ok(());
        }
        match occupied(&files, path).filter(|_| !replaces) {
            Some(place) => Err(format!("{} is there already: choose another name", place.display())),
            None => write(&files, path).map_err(|error| format!("{error:#}")),
        }
    }

    fn files(
        &self,
        compilation: &Compilation,
        scene: &Scene,
        format: Format,
        path: &Path,
        progress: &Progress,
    ) -> Result<Vec<File>, String> {
        let made = match format {
            Format::Mesh(format) => {
                let made = mesh(scene, &scene.defaults(), &Detail::default(), &mut |now| {
                    progress.show(now.done, now.of);
                    if progress.is_cancelled() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
                });
                // What was cancelled is no mistake.
                if progress.is_cancelled() {
                    return Ok(Vec::new());
                }
                made.map(|model| mesh_files(&model, format, path))
            }
            Format::Shader(target) => {
                let gpu = Gpu::new(&self.adapter).map_err(|error| error.to_string())?;
                let title = path.file_stem().unwrap_or_default().to_string_lossy();
                let shaded = Shaded { title: &title, scene, sources: &compilation.sources, view: self.view };
                shader_files(&gpu, &shaded, target, path)
            }
        };
        made.map_err(|error| format!("{error:#}"))
    }
}
