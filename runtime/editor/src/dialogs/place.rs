//! Where something is written to: a field for the path, and the system's dialog.

use std::path::{Path, PathBuf};

use egui::{Context, Ui};

use super::choice::Choice;
use crate::app::Editor;

/// The path of a file to be written.
pub(crate) struct Place {
    pub(crate) path: String,
    choice: Option<Choice>,
}

impl Place {
    /// A file beside the scene's, of the same name with another ending; none for a folder.
    pub(crate) fn beside_scene(editor: &Editor, ending: Option<&str>) -> Self {
        let scene = editor.session.scene_document();
        let path = scene.path.clone().unwrap_or_else(|| scene.title().into());
        let path = std::path::absolute(&path).unwrap_or(path);
        let mut place = Self { path: path.display().to_string(), choice: None };
        place.end(ending);
        place
    }

    /// Gives it another ending, or none.
    pub(crate) fn end(&mut self, ending: Option<&str>) {
        self.path = Path::new(&self.path).with_extension(ending.unwrap_or("")).display().to_string();
    }

    /// The path as one to write to.
    pub(crate) fn path(&self) -> PathBuf {
        PathBuf::from(&self.path)
    }

    /// Shows it: a label, and what stands behind it.
    pub(crate) fn show(&mut self, ui: &mut Ui) {
        self.poll(ui.ctx());
        let label = ui.label("File");
        ui.horizontal(|ui| {
            let width = (ui.available_width() - 90.0).max(80.0);
            ui.add(egui::TextEdit::singleline(&mut self.path).desired_width(width)).labelled_by(label.id);
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
