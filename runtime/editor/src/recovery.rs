//! Unsaved work, kept where a crash can't take it.
//!
//! Practice: every few seconds the texts with unsaved changes are written into one file of this process. It goes when there is
//! nothing unsaved, or when the window is closed in order. A file whose process is gone is what a crash left.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use egui::Context;
use serde::{Deserialize, Serialize};

use crate::document::Document;
use crate::worker::Job;

/// Unsaved texts are written this often.
const EVERY: Duration = Duration::from_secs(2);

/// A text with unsaved changes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Kept {
    /// Its file, if it has one.
    pub(crate) path: Option<PathBuf>,
    pub(crate) text: String,
}

/// What a crash left.
#[derive(Debug, Default)]
pub(crate) struct Found {
    pub(crate) texts: Vec<Kept>,
    files: Vec<PathBuf>,
}

/// Keeps the unsaved texts of this process.
pub(crate) struct Recovery {
    /// None where there is no place for it.
    folder: Option<PathBuf>,
    kept: Vec<Kept>,
    looked: Instant,
    writing: Option<Job<Result<(), String>>>,
    /// Files of crashes whose texts are open again: they go when these are written.
    taken_over: Vec<PathBuf>,
}

impl Recovery {
    /// Keeps texts in a folder of the data folder.
    pub(crate) fn new(data: Option<&Path>) -> Self {
        Self {
            folder: data.map(|data| data.join("unsaved")),
            kept: Vec::new(),
            looked: Instant::now(),
            writing: None,
            taken_over: Vec::new(),
        }
    }

    /// What crashes left, if anything.
    pub(crate) fn find(&self) -> Option<Found> {
        let mut found = Found::default();
        for entry in std::fs::read_dir(self.folder.as_ref()?).ok()?.flatten() {
            let path = entry.path();
            let process = path.file_stem().and_then(|stem| stem.to_str()).and_then(|stem| stem.parse().ok());
            if process.is_none_or(is_running) {
                continue;
            }
            let texts = std::fs::read(&path).ok().and_then(|bytes| serde_json::from_slice::<Vec<Kept>>(&bytes).ok());
            let Some(texts) = texts else {
                log::warn!("{} can't be read", path.display());
                continue;
            };
            found.texts.extend(texts);
            found.files.push(path);
        }
        (!found.texts.is_empty()).then_some(found)
    }

    /// The texts found are open again.
    pub(crate) fn take_over(&mut self, found: Found) {
        self.taken_over.extend(found.files);
    }

    /// Nobody wants what was found.
    pub(crate) fn discard(&mut self, found: &Found) {
        remove(&found.files);
    }

    /// Writes what is unsaved, if it is time.
    pub(crate) fn keep(&mut self, context: &Context, documents: &[Document]) {
        if let Some(result) = self.writing.as_mut().and_then(Job::poll) {
            self.writing = None;
            match result.and_then(|result| result) {
                Ok(()) => remove(&std::mem::take(&mut self.taken_over)),
                Err(reason) => log::warn!("unsaved texts can't be kept: {reason}"),
            }
        }
        let Some(folder) = self.folder.clone() else { return };
        let unsaved = || documents.iter().filter(|document| document.is_modified());
        if self.writing.is_some() || self.looked.elapsed() < EVERY {
            if unsaved().next().is_some() {
                context.request_repaint_after(EVERY);
            }
            return;
        }
        self.looked = Instant::now();
        let is_kept = |(document, kept): (&Document, &Kept)| document.path == kept.path && document.text == kept.text;
        if unsaved().count() == self.kept.len() && unsaved().zip(&self.kept).all(is_kept) {
            return;
        }
        self.kept =
            unsaved().map(|document| Kept { path: document.path.clone(), text: document.text.clone() }).collect();
        let kept = self.kept.clone();
        self.writing = Job::start(context, move |_| write(&folder, &kept)).ok();
    }

    /// The window is closed in order: nothing is left to be kept.
    pub(crate) fn close(&mut self) {
        // What is being written may not come after what is removed now.
        while self.writing.as_mut().is_some_and(|writing| writing.poll().is_none()) {
            std::thread::sleep(Duration::from_millis(5));
        }
        self.writing = None;
        if let Some(folder) = &self.folder {
            remove(&[own_file(folder)]);
        }
        remove(&std::mem::take(&mut self.taken_over));
    }
}

fn write(folder: &Path, kept: &[Kept]) -> Result<(), String> {
    let path = own_file(folder);
    if kept.is_empty() {
        remove(&[path]);
        return Ok(());
    }
    std::fs::create_dir_all(folder).map_err(|error| error.to_string())?;
    let bytes = serde_json::to_vec_pretty(kept).map_err(|error| error.to_string())?;
    chiaro_files::write(&path, &bytes).map_err(|error| format!("{error:#}"))
}

fn own_file(folder: &Path) -> PathBuf {
    folder.join(format!("{}.json", std::process::id()))
}

fn remove(files: &[PathBuf]) {
    for file in files {
        // It may be gone already.
        let _ = std::fs::remove_file(file);
    }
}

/// Whether a process of that number runs this program. Where the system doesn't say, only this one is known to.
fn is_running(process: u32) -> bool {
    if process == std::process::id() {
        return true;
    }
    let folder = Path::new("/proc").join(process.to_string());
    // The number may be another program's by now; and what has ended is there until its parent has looked at it.
    let program = std::fs::read_link(folder.join("exe")).ok();
    program.is_some_and(|program| program.file_name() == own_name().as_deref()) && !has_ended(&folder)
}

fn own_name() -> Option<std::ffi::OsString> {
    Some(std::env::current_exe().ok()?.file_name()?.to_owned())
}

/// Whether a process, of which the system tells in this folder, is only waiting for its parent.
fn has_ended(folder: &Path) -> bool {
    let stat = std::fs::read_to_string(folder.join("stat")).unwrap_or_default();
    stat.rsplit_once(") ").is_none_or(|(_, rest)| rest.starts_with(['Z', 'X']))
}
