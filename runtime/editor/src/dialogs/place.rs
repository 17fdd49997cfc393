//! Where something is written to: a field for the path, and the system's dialog.

use std::path::{Path, PathBuf};

use egui::{Context, Ui};

use super::choice::Choice;
use super::path_field;
use crate::app::Editor;
use crate::document::{Document, DocumentId};

/// The path of a file to be written, of the scene that is drawn.
pub(crate) struct Place {
    pub(crate) path: String,
    /// The path as long as the user chooses no other.
    suggested: String,
    /// How the file's name ends; none for a folder.
    ending: Option<&'static str>,
    /// The scene, and what it is called.
    document: DocumentId,
    title: String,
    choice: Option<Choice>,
}

impl Place {
    /// A file beside the scene's, of the same name with another ending; none for a folder.
    pub(crate) fn beside_scene(editor: &Editor, ending: Option<&'static str>) -> Self {
        let scene = editor.session.scene_document();
        let suggested = beside(scene, ending);
        let (document, title) = (scene.id, scene.title());
        Self { path: suggested.clone(), suggested, ending, document, title, choice: None }
    }

    /// Keeps up with which scene is drawn, and with its name. True if it is another scene: a path
    /// that was chosen for the one before is no place for it.
    pub(crate) fn follow(&mut self, editor: &Editor) -> bool {
        let scene = editor.session.scene_document();
        let is_another = scene.id != self.document;
        let suggested = beside(scene, self.ending);
        if is_another || self.path == self.suggested {
            self.path.clone_from(&suggested);
        }
        (self.document, self.title, self.suggested) = (scene.id, scene.title(), suggested);
        is_another
    }

    /// Gives it another ending, or none.
    pub(crate) fn end(&mut self, ending: Option<&'static str>) {
        let ended = |path: &str| Path::new(path).with_extension(ending.unwrap_or("")).display().to_string();
        (self.path, self.suggested, self.ending) = (ended(&self.path), ended(&self.suggested), ending);
    }

    /// The path as one to write to.
    pub(crate) fn path(&self) -> PathBuf {
        PathBuf::from(&self.path)
    }

    /// Shows which scene it is of.
    pub(crate) fn show_scene(&self, ui: &mut Ui) {
        ui.label("Scene");
        ui.label(&self.title);
    }

    /// Shows it: a label, and what stands behind it.
    pub(crate) fn show(&mut self, ui: &mut Ui) {
        self.poll(ui.ctx());
        let label = ui.label("File");
        ui.horizontal(|ui| {
            let width = (ui.available_width() - 90.0).max(80.0);
            let field = ui.add(egui::TextEdit::singleline(&mut self.path).desired_width(width)).labelled_by(label.id);
            if field.changed() {
                self.path = path_field::meant(&self.path);
            }
            if ui.button("Choose…").clicked() {
                self.choose(ui.ctx());
            }
        });
    }

    fn choose(&mut self, context: &Context) {
        if self.choice.is_none() {
            self.choice = Some(Choice::to_save("Write to", &self.path(), context));
        }
    }

    fn poll(&mut self, context: &Context) {
        if let Some(chosen) = self.choice.as_mut().and_then(|choice| choice.poll(context)) {
            self.choice = None;
            if let Some(path) = chosen.first() {
                self.path = path.display().to_string();
            }
        }
    }
}

/// A file beside that of a text.
fn beside(scene: &Document, ending: Option<&str>) -> String {
    let path = scene.path.clone().unwrap_or_else(|| scene.title().into());
    let path = std::path::absolute(&path).unwrap_or(path);
    path.with_extension(ending.unwrap_or("")).display().to_string()
}
