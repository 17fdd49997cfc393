//! Asking for files: by the system's dialog, or in the window itself where the system has none.
//!
//! The system's dialog runs on a thread of its own: the window goes on while it is open.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use egui::{Context, Id, Key, Modal};

use super::path_field::PathField;
use crate::worker::Job;

/// Nobody answers a dialog so fast: it did not open.
const IMMEDIATE: Duration = Duration::from_millis(300);

/// How the files of scenes end.
const SCENES: [&str; 2] = ["csg", "scad"];

/// A question for files that is open.
pub(crate) struct Choice {
    title: &'static str,
    before: PathBuf,
    /// The endings of the files it is about.
    endings: Vec<String>,
    asking: Asking,
}

enum Asking {
    System(Job<Vec<PathBuf>>, Instant),
    Window(PathField),
}

impl Choice {
    /// Asks for files to open.
    pub(crate) fn to_open(context: &Context) -> Self {
        let folder = std::env::current_dir().unwrap_or_default().join("");
        Self::new("Open", folder, &SCENES, context, |dialog| {
            let dialog = dialog.add_filter("Scenes", &SCENES).add_filter("All files", &["*"]);
            dialog.pick_files().unwrap_or_default()
        })
    }

    /// Asks for the name of a file to be written.
    pub(crate) fn to_save(title: &'static str, before: &Path, context: &Context) -> Self {
        let before = std::path::absolute(before).unwrap_or_else(|_| before.to_owned());
        let wanted = before.clone();
        let ending = ending(&before);
        Self::new(title, before, &[&ending], context, move |mut dialog| {
            if let Some(folder) = wanted.parent().filter(|folder| folder.is_dir()) {
                dialog = dialog.set_directory(folder);
            }
            if let Some(name) = wanted.file_name() {
                dialog = dialog.set_file_name(name.to_string_lossy());
            }
            if let Some(ending) = wanted.extension() {
                let ending = ending.to_string_lossy().into_owned();
                dialog = dialog.add_filter(ending.to_uppercase(), &[ending]);
            }
            dialog.save_file().into_iter().collect()
        })
    }

    fn new(
        title: &'static str,
        before: PathBuf,
        endings: &[&str],
        context: &Context,
        ask: impl FnOnce(rfd::FileDialog) -> Vec<PathBuf> + Send + 'static,
    ) -> Self {
        let start = || Job::start(context, move |_| ask(rfd::FileDialog::new().set_title(title))).ok();
        let asking = match has_system_dialog().then(start).flatten() {
            Some(job) => Asking::System(job, Instant::now()),
            None => Asking::Window(PathField::new(&before, endings)),
        };
        let endings = endings.iter().map(|ending| (*ending).to_owned()).collect();
        Self { title, before, endings, asking }
    }

    /// Asks in the window.
    #[cfg(test)]
    pub(super) fn in_window(title: &'static str, before: &Path) -> Self {
        let (before, endings) = (before.to_owned(), SCENES.map(str::to_owned).to_vec());
        let asking = Asking::Window(PathField::new(&before, &SCENES));
        Self { title, before, endings, asking }
    }

    /// Whether the window itself asks: it doesn't ask before something is written over.
    pub(super) fn is_in_window(&self) -> bool {
        matches!(self.asking, Asking::Window(..))
    }

    /// The answer, once it is there: no file, if the user wants none.
    pub(super) fn poll(&mut self, context: &Context) -> Option<Vec<PathBuf>> {
        match &mut self.asking {
            Asking::System(job, asked) => match job.poll()? {
                Ok(files) if !files.is_empty() || asked.elapsed() > IMMEDIATE => Some(files),
                _ => {
                    let endings: Vec<&str> = self.endings.iter().map(String::as_str).collect();
                    self.asking = Asking::Window(PathField::new(&self.before, &endings));
                    self.poll(context)
                }
            },
            Asking::Window(field) => ask_in_window(self.title, field, context),
        }
    }
}

/// How a path ends; nothing, if it has no ending.
fn ending(path: &Path) -> String {
    path.extension().map_or(String::new(), |ending| ending.to_string_lossy().into_owned())
}

/// Whether the system may have a dialog. On Linux that is asked for over D-Bus, or else of `zenity`.
fn has_system_dialog() -> bool {
    if !cfg!(target_os = "linux") {
        return true;
    }
    let has_bus = || {
        std::env::var_os("XDG_RUNTIME_DIR").is_some_and(|folder| Path::new(&folder).join("bus").exists())
            || std::env::var_os("DBUS_SESSION_BUS_ADDRESS").is_some()
    };
    let has_zenity = || {
        let path = std::env::var_os("PATH").unwrap_or_default();
        std::env::split_paths(&path).any(|folder| folder.join("zenity").exists())
    };
    has_bus() || has_zenity()
}

/// Asks for a path in a field of the window.
fn ask_in_window(title: &'static str, field: &mut PathField, context: &Context) -> Option<Vec<PathBuf>> {
    let (mut is_meant, mut is_declined) = (false, false);
    let modal = Modal::new(Id::unique("path")).show(context, |ui| {
        ui.set_width(460.0);
        ui.heading(title);
        ui.add_space(6.0);
        let path = ui.horizontal(|ui| {
            let label = ui.label("File");
            field.show(ui).labelled_by(label.id)
        });
        let path = path.inner;
        is_meant = path.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        ui.add_space(4.0);
        field.show_list(ui, &path);
        ui.weak("Tab completes the path");
        ui.add_space(8.0);
        ui.horizontal(|ui| {
            is_meant |= ui.button("OK").clicked();
            is_declined = ui.button("Cancel").clicked();
        });
        path
    });
    if is_meant {
        match field.chosen() {
            Some(path) => return Some(vec![path.to_owned()]),
            None => field.go_on(&modal.inner),
        }
    }
    (is_declined || modal.should_close()).then(Vec::new)
}
