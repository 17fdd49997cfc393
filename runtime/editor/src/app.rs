//! The window's contents.

use std::path::PathBuf;

use chiaro_render::Preference;
use egui::{CentralPanel, Panel, Ui};

use crate::clock::Clock;
use crate::session::Session;
use crate::settings::{Settings, Theme};
use crate::viewport::Viewport;
use crate::{dialogs, menu, panels, status, text};

/// How the editor starts.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The scenes to open; none for those of the last time.
    pub files: Vec<PathBuf>,
    /// What to draw with.
    pub adapter: Preference,
    /// Whether there is only the picture, beside an editor of the user's own.
    pub only_picture: bool,
}

/// The live-reload editor.
pub struct Editor {
    pub(crate) session: Session,
    pub(crate) settings: Settings,
    pub(crate) clock: Clock,
    pub(crate) viewport: Viewport,
    pub(crate) text: text::TextPanel,
    pub(crate) panels: panels::Panels,
    pub(crate) dialogs: dialogs::Dialogs,
    pub(crate) only_picture: bool,
}

impl Editor {
    /// The editor, with what it remembers from the last time.
    ///
    /// # Panics
    /// If the system has no room for two threads.
    pub fn new(context: &eframe::CreationContext, options: Options) -> Self {
        let settings: Settings =
            context.storage.and_then(|storage| eframe::get_value(storage, eframe::APP_KEY)).unwrap_or_default();
        let wake = context.egui_ctx.clone();
        let session = Session::new(options.adapter, move || wake.request_repaint());
        let mut editor = Self {
            session: session.expect("two threads"),
            settings,
            clock: Clock::default(),
            viewport: Viewport::default(),
            text: text::TextPanel::default(),
            panels: panels::Panels::default(),
            dialogs: dialogs::Dialogs::default(),
            only_picture: options.only_picture,
        };
        let files = if options.files.is_empty() { editor.settings.open.clone() } else { options.files };
        for file in files {
            editor.open(&file);
        }
        editor
    }

    /// Opens a file, or says why it can't be.
    pub(crate) fn open(&mut self, path: &std::path::Path) {
        match self.session.open(path) {
            Ok(()) => {
                if let Some(path) = self.session.active().path.clone() {
                    self.settings.opened(&path);
                }
            }
            Err(reason) => self.session.trouble = Some(reason),
        }
    }

    /// Lets the time of the scene pass.
    fn advance_clock(&mut self, ui: &Ui) {
        if self.clock.advance() {
            panels::time::show_time(self);
            ui.ctx().request_repaint();
        }
    }
}

impl eframe::App for Editor {
    fn ui(&mut self, ui: &mut Ui, _: &mut eframe::Frame) {
        ui.ctx().set_theme(match self.settings.theme {
            Theme::System => egui::ThemePreference::System,
            Theme::Light => egui::ThemePreference::Light,
            Theme::Dark => egui::ThemePreference::Dark,
        });
        if let Some(due) = self.session.poll() {
            ui.ctx().request_repaint_after(due);
        }
        self.advance_clock(ui);
        menu::shortcuts(self, ui);
        if !self.only_picture {
            Panel::top("menu").show(ui, |ui| menu::show(self, ui));
        }
        Panel::bottom("status").show(ui, |ui| status::show(self, ui));
        if !self.only_picture {
            Panel::left("text").default_size(560.0).show(ui, |ui| text::show(self, ui));
            if self.settings.shows_panel {
                Panel::right("panel").default_size(280.0).show(ui, |ui| panels::show(self, ui));
            }
        }
        CentralPanel::default().frame(egui::Frame::NONE).show(ui, |ui| crate::viewport::show(self, ui));
        dialogs::show(self, ui);
    }

    fn save(&mut self, storage: &mut dyn eframe::Storage) {
        self.settings.open = self.session.documents().iter().filter_map(|document| document.path.clone()).collect();
        eframe::set_value(storage, eframe::APP_KEY, &self.settings);
    }
}
