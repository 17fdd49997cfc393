//! The system's dialogs for files, and saving.
//!
//! Each dialog runs on a thread of its own: the window goes on while it is open.

use std::collections::VecDeque;
use std::path::{Path, PathBuf};

use egui::{Context, ViewportCommand};

use crate::app::Editor;
use crate::document::DocumentId;
use crate::worker::Job;

/// A system's dialog that is open.
pub(crate) type Choice = Job<Option<PathBuf>>;

/// The dialogs and savings under way.
#[derive(Default)]
pub(crate) struct Files {
    opening: Option<Job<Vec<PathBuf>>>,
    saving: Option<Saving>,
}

/// Texts that are saved one after the other.
struct Saving {
    waiting: VecDeque<DocumentId>,
    /// The text whose file is being chosen.
    named: Option<(DocumentId, Choice)>,
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
        if self.opening.is_none() {
            self.opening = Job::start(context, |_| {
                let dialog = rfd::FileDialog::new().set_title("Open").add_filter("Scenes", &["csg", "scad"]);
                dialog.add_filter("All files", &["*"]).pick_files().unwrap_or_default()
            })
            .ok();
        }
    }
}

/// Asks for the name of a file to be written.
pub(crate) fn choose_to_save(context: &Context, title: &str, before: &Path) -> Option<Choice> {
    let (title, before) = (title.to_owned(), before.to_owned());
    let choice = Job::start(context, move |_| {
        let mut dialog = rfd::FileDialog::new().set_title(title);
        if let Some(folder) = before.parent().filter(|folder| folder.is_dir()) {
            dialog = dialog.set_directory(folder);
        }
        if let Some(name) = before.file_name() {
            dialog = dialog.set_file_name(name.to_string_lossy());
        }
        if let Some(ending) = before.extension() {
            let ending = ending.to_string_lossy().into_owned();
            dialog = dialog.add_filter(ending.to_uppercase(), &[ending]);
        }
        dialog.save_file()
    });
    choice.ok()
}

impl Editor {
    /// Saves the text that is edited; under another name if that is wanted, or if it has none.
    pub(crate) fn save_active(&mut self, context: &Context, as_other: bool) {
        let id = self.session.active().id;
        self.save_then(vec![id], Then::Stay);
        if as_other && let Some(saving) = &mut self.dialogs.files.saving {
            saving.waiting.clear();
            saving.named = named(self.session.active().path.as_deref(), context).map(|choice| (id, choice));
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
        self.dialogs.files.saving = Some(Saving { waiting: documents.into(), named: None, then });
    }
}

fn named(path: Option<&Path>, context: &Context) -> Option<Choice> {
    choose_to_save(context, "Save as", path.unwrap_or(Path::new("scene.csg")))
}

/// Goes on with what is under way.
pub(crate) fn poll(editor: &mut Editor, context: &Context) {
    if let Some(result) = editor.dialogs.files.opening.as_mut().and_then(Job::poll) {
        editor.dialogs.files.opening = None;
        for path in result.unwrap_or_default() {
            editor.open(&path);
        }
    }
    if let Some(mut saving) = editor.dialogs.files.saving.take() {
        match advance(editor, &mut saving, context) {
            Ok(true) => finish(editor, saving.then, context),
            Ok(false) => editor.dialogs.files.saving = Some(saving),
            Err(reason) => editor.session.trouble = reason.or(editor.session.trouble.take()),
        }
    }
}

/// Saves what can be saved now; true if that is all. An error ends it: without a reason, if the user doesn't want it.
fn advance(editor: &mut Editor, saving: &mut Saving, context: &Context) -> Result<bool, Option<String>> {
    loop {
        if let Some((id, choice)) = &mut saving.named {
            let Some(chosen) = choice.poll() else { return Ok(false) };
            let path = chosen.map_err(Some)?.ok_or(None)?;
            editor.session.rename(*id, with_ending(path));
            save(editor, *id)?;
            saving.named = None;
        }
        let Some(id) = saving.waiting.pop_front() else { return Ok(true) };
        let Some(document) = editor.session.documents().iter().find(|document| document.id == id) else { continue };
        match &document.path {
            Some(_) => save(editor, id)?,
            None => saving.named = Some((id, named(None, context).ok_or(None)?)),
        }
    }
}

fn save(editor: &mut Editor, id: DocumentId) -> Result<(), Option<String>> {
    let Some(document) = editor.session.documents_mut().iter_mut().find(|document| document.id == id) else {
        return Ok(());
    };
    document.save().map_err(|reason| Some(format!("{} is not saved: {reason}", document.title())))?;
    if let Some(path) = document.path.clone() {
        editor.settings.opened(&path);
    }
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
