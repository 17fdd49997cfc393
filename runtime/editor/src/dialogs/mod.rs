//! What is asked in windows of its own.

mod choice;
pub(crate) mod export;
pub(crate) mod files;
mod frame_size;
mod keys;
mod overwrite;
mod place;
pub(crate) mod record;
mod recovered;
mod unsaved;
pub(crate) mod writing;

use egui::Ui;

use crate::app::Editor;
use crate::recovery::Found;

/// Which dialogs are open.
#[derive(Default)]
pub(crate) struct Dialogs {
    pub(crate) files: files::Files,
    /// What to do with changes, before something is closed.
    pub(crate) unsaved: Option<unsaved::Unsaved>,
    pub(crate) recovered: Option<Found>,
    /// What is to be written: a picture, a mesh, a film.
    pub(crate) writing: Option<writing::Writing>,
    pub(crate) shows_keys: bool,
    /// Nothing has to be asked any more before the window closes.
    pub(crate) may_quit: bool,
}

impl Dialogs {
    /// Whether an answer is needed before anything else.
    pub(crate) fn is_blocking(&self) -> bool {
        self.unsaved.is_some()
            || self.recovered.is_some()
            || self.files.is_asking()
            || self.writing.as_ref().is_some_and(writing::Writing::is_asking)
    }

    /// Opens a form in the place of what is open, unless that is at work.
    pub(crate) fn open(&mut self, form: impl writing::Form + 'static) {
        if !self.is_busy() {
            self.writing = Some(writing::Writing::new(form));
        }
    }

    pub(crate) fn is_busy(&self) -> bool {
        self.writing.as_ref().is_some_and(writing::Writing::is_busy)
    }
}

/// Shows the dialogs that are open.
pub(crate) fn show(editor: &mut Editor, ui: &mut Ui) {
    let context = ui.ctx().clone();
    unsaved::catch_close(editor, &context);
    files::poll(editor, &context);
    keys::show(editor, &context);
    writing::show(editor, &context);
    recovered::show(editor, &context);
    unsaved::show(editor, &context);
}
