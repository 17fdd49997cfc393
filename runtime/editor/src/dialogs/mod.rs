//! What is asked in windows of its own.

mod choice;
pub(crate) mod export;
pub(crate) mod files;
mod keys;
mod overwrite;
mod place;
pub(crate) mod record;
mod recovered;
mod unsaved;

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
    pub(crate) export: Option<export::Export>,
    pub(crate) record: Option<record::Record>,
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
            || self.export.as_ref().is_some_and(export::Export::is_asking)
            || self.record.as_ref().is_some_and(record::Record::is_asking)
    }

    /// Opens the export in the place of what is open, unless that is at work.
    pub(crate) fn open_export(&mut self, export: export::Export) {
        if !self.is_busy() {
            (self.export, self.record) = (Some(export), None);
        }
    }

    /// Opens the recording in the place of what is open, unless that is at work.
    pub(crate) fn open_record(&mut self, record: record::Record) {
        if !self.is_busy() {
            (self.export, self.record) = (None, Some(record));
        }
    }

    pub(crate) fn is_busy(&self) -> bool {
        self.export.as_ref().is_some_and(export::Export::is_busy)
            || self.record.as_ref().is_some_and(record::Record::is_busy)
    }
}

/// Shows the dialogs that are open.
pub(crate) fn show(editor: &mut Editor, ui: &mut Ui) {
    let context = ui.ctx().clone();
    unsaved::catch_close(editor, &context);
    files::poll(editor, &context);
    keys::show(editor, &context);
    export::show(editor, &context);
    record::show(editor, &context);
    recovered::show(editor, &context);
    unsaved::show(editor, &context);
}
