//! Writing what the scene came to: its picture, its text, and what other programs read.

mod kind;

use std::path::PathBuf;

use chiaro_compiler::export::{Language, Target};
use chiaro_exports::{Format, MeshFormat};
use egui::{Grid, Ui};

use super::frame_size::FrameSize;
use super::place::Place;
use super::writing::{Form, Work};
use crate::app::Editor;
use crate::darkroom::{Shot, still};
use crate::workshop::Piece;
use kind::Kind;

/// What to write, and where to.
pub(crate) struct Export {
    kind: Kind,
    place: Place,
    frame: FrameSize,
}

impl Export {
    /// Ready to write the shader.
    pub(crate) fn of_shader(editor: &Editor, language: Language) -> Self {
        Self::new(editor, Kind::Other(Format::Shader(Target::Library(language))))
    }

    /// Ready to write a mesh.
    pub(crate) fn of_scene(editor: &Editor) -> Self {
        Self::new(editor, Kind::Other(Format::Mesh(MeshFormat::Stl)))
    }

    /// Ready to write the picture.
    pub(crate) fn of_picture(editor: &Editor) -> Self {
        Self::new(editor, Kind::Png)
    }

    fn new(editor: &Editor, kind: Kind) -> Self {
        Self { kind, place: Place::beside_scene(editor, kind.ending()), frame: FrameSize::of(editor) }
    }
}

impl Form for Export {
    fn title(&self) -> &'static str {
        "Export"
    }

    fn follow(&mut self, editor: &Editor) -> bool {
        self.place.follow(editor)
    }

    fn controls(&mut self, ui: &mut Ui) -> bool {
        let before = self.kind;
        Grid::new("export").num_columns(2).spacing([12.0, 6.0]).show(ui, |ui| {
            self.place.show_scene(ui);
            ui.end_row();
            ui.label("Format");
            self.kind.choose(ui);
            ui.end_row();
            self.place.show(ui);
            ui.end_row();
            if self.kind.is_picture() {
                self.frame.show(ui);
                ui.end_row();
            }
        });
        let is_another = self.kind != before;
        if is_another {
            self.place.end(self.kind.ending());
        }
        is_another
    }

    fn occupied(&self) -> Option<PathBuf> {
        Some(self.place.path()).filter(|path| path.exists())
    }

    fn work(&self, editor: &Editor, replaces: bool) -> Option<Work> {
        let (path, adapter) = (self.place.path(), editor.adapter.clone());
        Some(match self.kind {
            Kind::Png | Kind::Exr => {
                let shot = Shot::of(&editor.session, adapter, self.frame.size, self.frame.samples)?;
                Box::new(move |progress| still(&shot, &path, progress))
            }
            Kind::Scene => {
                let text = editor.session.scene_document().text.clone();
                Box::new(move |_| chiaro_files::write(&path, text.as_bytes()).map_err(|error| format!("{error:#}")))
            }
            Kind::Other(format) => {
                let piece = Piece::of(&editor.session, editor.viewport.drawn(), adapter)?;
                Box::new(move |progress| piece.export(format, &path, replaces, progress))
            }
        })
    }

    fn done(&self) -> String {
        format!("{} is written", self.place.path)
    }
}
