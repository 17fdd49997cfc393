//! Files that change on the disk.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, channel};

use notify::{RecommendedWatcher, RecursiveMode, Watcher};

/// Watches the folders of files, so that saves by atomic renames are seen too.
pub(crate) struct Watch {
    watcher: Option<RecommendedWatcher>,
    changes: Receiver<PathBuf>,
    folders: BTreeSet<PathBuf>,
}

impl Watch {
    /// Watches nothing yet; `wake` is called when something changes. Where the system has no way to watch, nothing ever
    /// changes, and the log says so.
    pub(crate) fn new(wake: impl Fn() + Send + 'static) -> Self {
        let (sender, changes) = channel();
        let watcher = notify::recommended_watcher(move |event: notify::Result<notify::Event>| {
            let Ok(event) = event else { return };
            if event.kind.is_access() {
                return;
            }
            for path in event.paths {
                // Nobody listens any more when the window is being closed.
                let _ = sender.send(path);
            }
            wake();
        });
        let watcher = watcher.inspect_err(|error| log::warn!("files can't be watched: {error}")).ok();
        Self { watcher, changes, folders: BTreeSet::new() }
    }

    /// Watches the folders of these files, and no others.
    pub(crate) fn watch<'p>(&mut self, files: impl Iterator<Item = &'p Path>) {
        let wanted: BTreeSet<PathBuf> = files.filter_map(|file| Some(file.parent()?.to_owned())).collect();
        let Some(watcher) = &mut self.watcher else { return };
        for gone in self.folders.difference(&wanted) {
            // A folder that is gone can't be unwatched, and need not be.
            let _ = watcher.unwatch(gone);
        }
        for new in wanted.difference(&self.folders) {
            if let Err(error) = watcher.watch(new, RecursiveMode::NonRecursive) {
                log::warn!("{} can't be watched: {error}", new.display());
            }
        }
        self.folders = wanted;
    }

    /// What changed since the last call.
    pub(crate) fn changes(&self) -> BTreeSet<PathBuf> {
        self.changes.try_iter().collect()
    }
}
