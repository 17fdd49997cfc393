//! Asking before something is written over.

use std::path::PathBuf;

use egui::{Context, Id, Modal};

/// A place where something is already, and what to do with that.
#[derive(Clone, Debug)]
pub(crate) struct Overwrite {
    path: PathBuf,
}

impl Overwrite {
    /// A question about what is at `path`.
    pub(super) fn new(path: PathBuf) -> Self {
        Self { path }
    }

    /// Asks. The answer, once it is there: whether what is there may be written over.
    pub(super) fn ask(&self, context: &Context) -> Option<bool> {
        let name = self.path.file_name().unwrap_or_default().to_string_lossy();
        let folder = self.path.parent().map_or(String::new(), |folder| folder.display().to_string());
        let mut answer = None;
        let modal = Modal::new(Id::unique("overwrite")).show(context, |ui| {
            ui.set_width(340.0);
            ui.heading(format!("Replace {name}?"));
            ui.add_space(4.0);
            ui.label(format!("There is something of that name in {folder}. What is in it would be lost."));
            ui.add_space(12.0);
            ui.horizontal(|ui| {
                if ui.button("Replace").clicked() {
                    answer = Some(true);
                }
                if ui.button("Cancel").clicked() {
                    answer = Some(false);
                }
            });
        });
        answer.or(modal.should_close().then_some(false))
    }
}
