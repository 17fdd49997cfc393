//! What to do with changes, before they would be lost.

use egui::{Context, Id, Modal, Ui, ViewportCommand};

use super::files::Then;
use crate::app::Editor;
use crate::document::DocumentId;

/// Something is to be closed whose changes are not saved.
pub(crate) struct Unsaved {
    /// The texts with changes.
    documents: Vec<DocumentId>,
    then: Then,
}

impl Editor {
    /// Closes a text, after asking what to do with its changes.
    pub(crate) fn ask_to_close(&mut self, index: usize) {
        let Some(document) = self.session.documents().get(index) else { return };
        let (id, is_modified) = (document.id, document.is_modified());
        if is_modified {
            self.dialogs.unsaved = Some(Unsaved { documents: vec![id], then: Then::Close(id) });
        } else {
            self.close_now(id);
        }
    }

    /// Closes a text as it is.
    pub(crate) fn close_now(&mut self, id: DocumentId) {
        if let Some(index) = self.session.documents().iter().position(|document| document.id == id) {
            self.session.close(index);
        }
    }

    /// Whether the window may close now. If not, the user is asked.
    pub(crate) fn may_quit(&mut self) -> bool {
        let modified = self.session.documents().iter().filter(|document| document.is_modified());
        let documents: Vec<DocumentId> = modified.map(|document| document.id).collect();
        if self.dialogs.may_quit || documents.is_empty() {
            self.dialogs.may_quit = true;
            return true;
        }
        self.dialogs.unsaved = Some(Unsaved { documents, then: Then::Quit });
        false
    }
}

/// Holds the window open while there is something to ask.
pub(super) fn catch_close(editor: &mut Editor, context: &Context) {
    if context.input(|input| input.viewport().close_requested()) && !editor.may_quit() {
        context.send_viewport_cmd(ViewportCommand::CancelClose);
    }
}

/// Asks.
pub(super) fn show(editor: &mut Editor, context: &Context) {
    let Some(unsaved) = &editor.dialogs.unsaved else { return };
    let named = |document: &crate::document::Document| document.title();
    let is_asked = |document: &&crate::document::Document| unsaved.documents.contains(&document.id);
    let titles: Vec<String> = editor.session.documents().iter().filter(is_asked).map(named).collect();
    let modal = Modal::new(Id::unique("unsaved")).show(context, |ui| ask(ui, &titles));
    let answer = if modal.should_close() { Some(Answer::Cancel) } else { modal.inner };
    let Some(answer) = answer else { return };
    let Some(unsaved) = editor.dialogs.unsaved.take() else { return };
    match answer {
        Answer::Cancel => {}
        Answer::Save => editor.save_then(unsaved.documents, unsaved.then),
        Answer::Discard => match unsaved.then {
            Then::Quit => {
                editor.dialogs.may_quit = true;
                context.send_viewport_cmd(ViewportCommand::Close);
            }
            Then::Close(id) => editor.close_now(id),
            Then::Stay => {}
        },
    }
}

#[derive(Clone, Copy)]
enum Answer {
    Save,
    Discard,
    Cancel,
}

fn ask(ui: &mut Ui, titles: &[String]) -> Option<Answer> {
    ui.set_width(340.0);
    let mut answer = None;
    let (question, save, discard) = match titles {
        [title] => (format!("Save the changes to {title}?"), "Save", "Discard"),
        _ => (format!("Save the changes to {} texts?", titles.len()), "Save all", "Discard all"),
    };
    ui.heading(question);
    ui.add_space(4.0);
    if titles.len() > 1 {
        ui.label(titles.join(", "));
    }
    ui.weak("They are lost otherwise.");
    ui.add_space(12.0);
    ui.horizontal(|ui| {
        if ui.button(save).clicked() {
            answer = Some(Answer::Save);
        }
        if ui.button(discard).clicked() {
            answer = Some(Answer::Discard);
        }
        if ui.button("Cancel").clicked() {
            answer = Some(Answer::Cancel);
        }
    });
    answer
}
