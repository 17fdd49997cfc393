//! What is asked in windows of its own.

mod choice;
pub(crate) mod export;
pub(crate) mod files;
mod frame_size;
mod keys;
mod overwrite;
mod path_field;
mod place;
pub(crate) mod record;
mod recovered;
mod unsaved;
pub(crate) mod writing;

use egui::{Context, Key, Modifiers, Order, Popup, Ui};

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

    /// Closes the dialog on top, of those that stay open beside the text.
    fn close_top(&mut self, context: &Context) {
        let top = context.memory(|memory| memory.areas().top_layer_id(Order::Middle));
        let is_writing_top = top.is_some_and(|layer| layer.id == writing::id());
        if self.shows_keys && !(is_writing_top && self.writing.is_some()) {
            self.shows_keys = false;
        } else if let Some(writing) = self.writing.take() {
            writing.close();
        }
    }
}

/// Closes a dialog by the key for that. Questions, menus and lists that are open see to it
/// themselves.
pub(crate) fn close_by_key(editor: &mut Editor, context: &Context) {
    let dialogs = &mut editor.dialogs;
    let is_open = dialogs.shows_keys || dialogs.writing.is_some();
    let is_for_other = dialogs.is_blocking() || Popup::is_any_open(context) || !editor.text.is_quiet();
    if is_open && !is_for_other && context.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape)) {
        dialogs.close_top(context);
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
