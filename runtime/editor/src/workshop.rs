//! Scenes as files of other programs, made while the window goes on.

use std::ops::ControlFlow;
use std::path::Path;

use chiaro_compiler::{Compilation, Scene, compile};
use chiaro_exports::{File, Format, MeshFormat, Shaded, mesh, mesh_beside, mesh_files, occupied, shader_files, write};
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
        let target = match format {
            Format::Mesh(format) => return meshed(scene, format, path, progress),
            Format::Shader(target) => target,
        };
        let gpu = Gpu::new(&self.adapter).map_err(|error| error.to_string())?;
        let title = path.file_stem().unwrap_or_default().to_string_lossy();
        let shaded = Shaded { title: &title, scene, sources: &compilation.sources, view: self.view };
        let mut files = shader_files(Some(&gpu), &shaded, target, path).map_err(|error| format!("{error:#}"))?;
        if let Some(path) = mesh_beside(target, &files, path) {
            files.extend(meshed(scene, MeshFormat::Obj, &path, progress)?);
        }
        Ok(files)
    }
}

/// The files of a mesh; none, if it was cancelled.
fn meshed(scene: &Scene, format: MeshFormat, path: &Path, progress: &Progress) -> Result<Vec<File>, String> {
    let made = mesh(scene, &scene.defaults(), &Detail::default(), &mut |now| {
        progress.show(now.done, now.of);
        if progress.is_cancelled() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    match made {
        Ok(model) => Ok(mesh_files(&model, format, path)),
        // What was cancelled is no mistake.
        Err(_) if progress.is_cancelled() => Ok(Vec::new()),
        Err(error) => Err(format!("{error:#}")),
    }
}
