//! Where something is written to: a field for the path, and the system's dialog.

use std::path::{Path, PathBuf};

use egui::{Context, Ui};

use super::choice::Choice;

/// The path of a file to be written.
pub(crate) struct Place {
    pub(crate) path: String,
    choice: Option<Choice>,
}

impl Place {
    /// A file beside another one.
    pub(crate) fn beside(scene: Option<&Path>, ending: &str) -> Self {
        let home = || std::env::current_dir().unwrap_or_default().join("scene");
        let path = scene.map_or_else(home, Path::to_owned).with_extension(ending);
        Self { path: path.display().to_string(), choice: None }
    }

    /// Gives it another ending.
    pub(crate) fn end(&mut self, ending: &str) {
        self.path = Path::new(&self.path).with_extension(ending).display().to_string();
    }

    /// The path as one to write to.
    pub(crate) fn path(&self) -> PathBuf {
        PathBuf::from(&self.path)
    }

    /// Shows it.
    pub(crate) fn show(&mut self, ui: &mut Ui) {
        self.poll(ui.ctx());
        ui.horizontal(|ui| {
            let label = ui.label("File");
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
