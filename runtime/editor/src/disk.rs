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

    /// Watches the folders of these files, and no others. What has no full name is no file.
    pub(crate) fn watch<'p>(&mut self, files: impl Iterator<Item = &'p Path>) {
        let files = files.filter(|file| file.is_absolute());
        let wanted: BTreeSet<PathBuf> = files.filter_map(|file| Some(file.parent()?.to_owned())).collect();
        let Some(watcher) = &mut self.watcher else { return };
        if wanted == self.folders {
            return;
        }
        for gone in self.folders.difference(&wanted) {
            // A folder that is gone can't be unwatched, and need not be.
            let _ = watcher.unwatch(gone);
        }
        // A folder has one watch whatever its names are: the other names of what is unwatched have lost it.
        for folder in &wanted {
            if let Err(error) = watcher.watch(folder, RecursiveMode::NonRecursive) {
                log::warn!("{} can't be watched: {error}", folder.display());
            }
        }
        self.folders = wanted;
    }

    /// What changed since the last call.
    pub(crate) fn changes(&self) -> BTreeSet<PathBuf> {
        self.changes.try_iter().collect()
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;

    #[test]
    fn a_folder_is_watched_as_long_as_one_of_its_names_is_wanted() {
        let around = tempfile::tempdir().unwrap();
        let folder = around.path().join("scenes");
        std::fs::create_dir(&folder).unwrap();
        let other_name = folder.join("..").join("scenes");
        let (sender, receiver) = channel();
        let mut watch = Watch::new(move || sender.send(()).unwrap_or_default());
        let (file, other) = (folder.join("a.csg"), other_name.join("b.csg"));
        watch.watch([&*file, &*other, Path::new("untitled.csg")].into_iter());
        watch.watch([&*file].into_iter());
        std::fs::write(&file, "cube(1);").unwrap();
        receiver.recv_timeout(Duration::from_secs(60)).expect("the change is seen");
        assert!(watch.changes().contains(&file));
    }
}
