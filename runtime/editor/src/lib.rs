//! The live-reload editor: text at one side, the lit scene at the other.
//!
//! [`Editor`] is the window's contents. A `Session` holds the open texts, and asks a `Studio` to compile and draw them. The
//! studio has two threads, one that compiles and one that draws; each always works on the newest request and forgets older
//! ones, so that the window's own thread never waits, and the last good picture stays while a text is broken.
//!
//! ```text
//! window ──Program──► compiling thread ──Subject──► drawing thread ──Frame──► window
//!        ──Wanted───────────────────────────────────►
//! ```

// The window, from the outside in.
mod app;
mod command;
mod dialogs;
mod gallery;
mod menu;
mod panels;
mod status;
mod text;
mod theme;
mod viewport;

// What it shows: the open texts and their scene, and the threads that compile and draw it.
mod document;
mod history;
mod live_edit;
mod session;
mod studio;

mod clock;
mod darkroom;
mod disk;
mod recovery;
mod settings;
mod worker;
mod workshop;

#[cfg(test)]
mod tests;

pub use app::{Editor, Options};

/// The name that the system knows the editor by.
const NAME: &str = "chiaro";

/// Opens the editor's window, and returns when it is closed.
///
/// # Errors
/// If there is no display, or no graphics driver that can draw a window.
pub fn run(options: Options) -> eframe::Result {
    let native = eframe::NativeOptions {
        viewport: egui::ViewportBuilder::default()
            .with_title("Chiaro")
            .with_app_id(NAME)
            .with_inner_size([1440.0, 860.0])
            .with_min_inner_size([640.0, 400.0]),
        ..Default::default()
    };
    eframe::run_native(NAME, native, Box::new(|context| Ok(Box::new(Editor::new(context, options)))))
}
