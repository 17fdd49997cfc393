//! Where something is written to: a field for the path, and the system's dialog.

use std::path::{Path, PathBuf};

use egui::{Context, Ui};

use super::files::{Choice, choose_to_save};
use crate::worker::Job;

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
        self.poll();
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
            self.choice = choose_to_save(context, "Write to", &self.path());
        }
    }

    fn poll(&mut self) {
        if let Some(result) = self.choice.as_mut().and_then(Job::poll) {
            self.choice = None;
            if let Ok(Some(path)) = result {
                self.path = path.display().to_string();
            }
        }
    }
}
