//! Opening and saving.

use std::collections::VecDeque;
use std::path::{Path, PathBuf};

use egui::{Context, ViewportCommand};

use super::choice::Choice;
use super::overwrite::Overwrite;
use crate::app::Editor;
use crate::document::{Document, DocumentId};

/// The dialogs and savings under way.
#[derive(Default)]
pub(crate) struct Files {
    opening: Option<Choice>,
    saving: Option<Saving>,
}

/// Texts that are saved one after the other.
struct Saving {
    waiting: VecDeque<DocumentId>,
    /// The text whose file is being chosen.
    named: Option<(DocumentId, Choice)>,
    /// The file that was chosen, where something is already.
    taken: Option<(DocumentId, PathBuf, Overwrite)>,
    then: Then,
}

/// What follows when all is saved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Then {
    /// Nothing.
    Stay,
    /// The text is closed.
    Close(DocumentId),
    /// The window is closed.
    Quit,
}

impl Files {
    /// Asks for files to open.
    pub(crate) fn choose_to_open(&mut self, context: &Context) {
        self.opening.get_or_insert_with(|| Choice::to_open(context));
    }

    /// Whether the window itself asks for a file.
    pub(super) fn is_asking(&self) -> bool {
        if self.saving.as_ref().is_some_and(|saving| saving.taken.is_some()) {
            return true;
        }
        let named = self.saving.as_ref().and_then(|saving| saving.named.as_ref());
        self.opening.iter().chain(named.map(|(_, choice)| choice)).any(Choice::is_in_window)
    }
}

impl Editor {
    /// Saves the text that is edited; under another name if that is wanted, or if it has none.
    pub(crate) fn save_active(&mut self, context: &Context, as_other: bool) {
        let id = self.session.active().id;
        self.save_then(vec![id], Then::Stay);
        if as_other && let Some(saving) = &mut self.dialogs.files.saving {
            saving.waiting.clear();
            saving.named = Some((id, named(self.session.active(), context)));
        }
    }

    /// Saves all texts with changes.
    pub(crate) fn save_all(&mut self, _: &Context) {
        let modified = self.session.documents().iter().filter(|document| document.is_modified());
        let modified = modified.map(|document| document.id).collect();
        self.save_then(modified, Then::Stay);
    }

    /// Saves these texts. If that works out, something follows.
    pub(crate) fn save_then(&mut self, documents: Vec<DocumentId>, then: Then) {
        self.dialogs.files.saving = Some(Saving { waiting: documents.into(), named: None, taken: None, then });
    }
}

#[cfg(test)]
impl Files {
    /// Saves a text as if the system had no dialog to ask for its file.
    pub(crate) fn save_in_window(&mut self, id: DocumentId, path: &Path) {
        let named = Some((id, Choice::in_window("Save as", path)));
        self.saving = Some(Saving { waiting: VecDeque::new(), named, taken: None, then: Then::Stay });
    }
}

fn named(document: &Document, context: &Context) -> Choice {
    Choice::to_save("Save as", &document.path.clone().unwrap_or_else(|| document.title().into()), context)
}

/// Goes on with what is under way.
pub(crate) fn poll(editor: &mut Editor, context: &Context) {
    if let Some(paths) = editor.dialogs.files.opening.as_mut().and_then(|choice| choice.poll(context)) {
        editor.dialogs.files.opening = None;
        paths.iter().for_each(|path| editor.open(path));
    }
    if let Some(mut saving) = editor.dialogs.files.saving.take() {
        match advance(editor, &mut saving, context) {
            Ok(true) => finish(editor, saving.then, context),
            Ok(false) => editor.dialogs.files.saving = Some(saving),
            Err(reason) => editor.session.failure = reason.or(editor.session.failure.take()),
        }
    }
}

/// Saves what can be saved now; true if that is all. An error ends it: without a reason, if the user doesn't want it.
fn advance(editor: &mut Editor, saving: &mut Saving, context: &Context) -> Result<bool, Option<String>> {
    loop {
        if let Some((id, choice)) = &mut saving.named {
            let Some(chosen) = choice.poll(context) else { return Ok(false) };
            let chosen = chosen.into_iter().next().ok_or(None)?;
            let path = with_ending(chosen.clone());
            let (id, is_asked) = (*id, !choice.is_in_window() && path == chosen);
            saving.named = None;
            // The system's dialog asked already, if that is the name it knows.
            match path.exists() && !is_asked && !is_own_file(editor, id, &path) {
                true => saving.taken = Some((id, path.clone(), Overwrite::new(path))),
                false => save_as(editor, id, path)?,
            }
        }
        if let Some((id, path, overwrite)) = &saving.taken {
            let Some(answer) = overwrite.ask(context) else { return Ok(false) };
            let (id, path) = (*id, path.clone());
            saving.taken = None;
            match answer {
                true => save_as(editor, id, path)?,
                false => return Err(None),
            }
        }
        let Some(id) = saving.waiting.pop_front() else { return Ok(true) };
        let Some(document) = editor.session.documents().iter().find(|document| document.id == id) else { continue };
        match &document.path {
            Some(_) => save(editor, id)?,
            None => saving.named = Some((id, named(document, context))),
        }
    }
}

/// Whether a text has that file already.
fn is_own_file(editor: &Editor, id: DocumentId, path: &Path) -> bool {
    let document = editor.session.documents().iter().find(|document| document.id == id);
    document.is_some_and(|document| document.path.as_deref() == std::path::absolute(path).ok().as_deref())
}

/// Saves a text to another file, which is its own from then on if that worked.
fn save_as(editor: &mut Editor, id: DocumentId, path: PathBuf) -> Result<(), Option<String>> {
    let path = std::path::absolute(&path).unwrap_or(path);
    save_to(editor, id, Some(path.clone()))?;
    editor.session.rename(id, path);
    Ok(())
}

fn save(editor: &mut Editor, id: DocumentId) -> Result<(), Option<String>> {
    save_to(editor, id, None)
}

/// Saves a text to its file, or to another one.
fn save_to(editor: &mut Editor, id: DocumentId, other: Option<PathBuf>) -> Result<(), Option<String>> {
    let Some(document) = editor.session.documents_mut().iter_mut().find(|document| document.id == id) else {
        return Ok(());
    };
    let Some(path) = other.or_else(|| document.path.clone()) else { return Ok(()) };
    document.save_to(&path).map_err(|reason| Some(format!("{} is not saved: {reason}", document.title())))?;
    editor.session.failure = None;
    editor.settings.opened(&path);
    Ok(())
}

fn finish(editor: &mut Editor, then: Then, context: &Context) {
    match then {
        Then::Stay => {}
        Then::Close(id) => editor.close_now(id),
        Then::Quit => {
            editor.dialogs.may_quit = true;
            context.send_viewport_cmd(ViewportCommand::Close);
        }
    }
}

/// A name without an ending gets that of scenes.
fn with_ending(path: PathBuf) -> PathBuf {
    if path.extension().is_some() { path } else { path.with_extension("csg") }
}
