//! The window's contents.

use std::path::PathBuf;
use std::time::Duration;

use chiaro_render::Preference;
use egui::{CentralPanel, Context, Panel, Ui, UiBuilder};

use crate::clock::Clock;
use crate::command::Command;
use crate::gallery::Gallery;
use crate::recovery::Recovery;
use crate::session::Session;
use crate::settings::{Settings, Theme};
use crate::viewport::Viewport;
use crate::{dialogs, gallery, menu, panels, status, text, theme};

/// The part of the window's width that the text has at first.
const TEXT: f32 = 0.38;

/// The width of the panels at first, in points.
const PANEL: f32 = 356.0;

/// How the editor starts.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The scenes to open; none for those of the last time. Those that aren't there are new.
    pub files: Vec<PathBuf>,
    /// Values of top-level variables of the scene, as expressions of the language.
    pub definitions: Vec<(String, String)>,
    /// What to draw with.
    pub adapter: Preference,
    /// Whether there is only the picture, beside an editor of the user's own.
    pub only_picture: bool,
    /// The folder for what must survive a crash; none for the one the system has for that.
    pub data: Option<PathBuf>,
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
    pub(crate) gallery: Gallery,
    pub(crate) recovery: Recovery,
    pub(crate) adapter: Preference,
    pub(crate) only_picture: bool,
    /// What was asked for after something that had yet to be written into the text: done in the next frame.
    pub(crate) postponed: Vec<Command>,
    /// The size of text that the window's style was made for, in points.
    styled: f32,
    /// What the window is called.
    title: String,
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
        let session = Session::new(options.adapter.clone(), move || wake.request_repaint());
        let data = options.data.or_else(|| eframe::storage_dir(crate::NAME));
        let recovery = Recovery::new(data.as_deref());
        let dialogs = dialogs::Dialogs { recovered: recovery.find(), ..Default::default() };
        let mut editor = Self {
            session: session.expect("two threads"),
            settings,
            clock: Clock::default(),
            viewport: Viewport::default(),
            text: text::TextPanel::default(),
            panels: panels::Panels::default(),
            dialogs,
            gallery: Gallery::default(),
            recovery,
            adapter: options.adapter,
            only_picture: options.only_picture,
            postponed: Vec::new(),
            styled: 0.0,
            title: String::new(),
        };
        match options.files.is_empty() {
            true => editor.open_last(),
            false => {
                options.files.iter().for_each(|file| editor.open_or_begin(file));
                editor.session.activate(0);
            }
        }
        editor.text.wants_focus = true;
        editor.session.define(options.definitions);
        editor
    }

    /// Opens a file, or says why it can't be.
    pub(crate) fn open(&mut self, path: &std::path::Path) {
        match self.session.open(path) {
            Ok(()) => {
                self.text.wants_focus = true;
                self.session.failure = None;
                if let Some(path) = self.session.active().path.clone() {
                    self.settings.opened(&path);
                }
            }
            Err(reason) => {
                self.session.failure = Some(reason);
                self.settings.recent.retain(|recent| recent != path || path.exists());
            }
        }
    }

    /// Opens the files of the last time, as they were then.
    fn open_last(&mut self) {
        let (drawn, recent) = (self.settings.drawn.clone(), self.settings.recent.clone());
        // Those that are gone meanwhile are no trouble of this time.
        let there: Vec<PathBuf> = self.settings.open.iter().filter(|file| file.exists()).cloned().collect();
        there.iter().chain(drawn.iter().filter(|file| there.contains(file))).for_each(|file| self.open(file));
        self.settings.recent = recent;
    }

    /// Opens a file, or begins it if there is none.
    fn open_or_begin(&mut self, path: &std::path::Path) {
        if path.exists() {
            return self.open(path);
        }
        match std::path::absolute(path) {
            Ok(path) => self.session.begin(path),
            Err(reason) => self.session.failure = Some(format!("cannot begin {}: {reason}", path.display())),
        }
    }

    /// Opens the files that were dropped on the window.
    fn take_dropped(&mut self, context: &Context) {
        let dropped = context.input(|input| input.raw.dropped_files.clone());
        for file in dropped.iter() {
            self.open(file.path());
        }
    }

    /// Makes the window look as the user wants.
    fn style(&mut self, context: &Context) {
        context.set_theme(match self.settings.theme {
            Theme::System => egui::ThemePreference::System,
            Theme::Light => egui::ThemePreference::Light,
            Theme::Dark => egui::ThemePreference::Dark,
        });
        if self.styled != self.settings.text_size {
            self.styled = self.settings.text_size;
            theme::apply(context, self.styled);
        }
    }

    /// Calls the window by the text that is open.
    fn name_window(&mut self, context: &Context) {
        let document = self.session.active();
        let mark = if document.is_modified() { " •" } else { "" };
        let title = match self.session.is_blank() {
            true => "Chiaro".to_owned(),
            false => format!("{}{mark} – Chiaro", document.title()),
        };
        if self.title != title {
            context.send_viewport_cmd(egui::ViewportCommand::Title(title.clone()));
            self.title = title;
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
    fn ui(&mut self, ui: &mut Ui, frame: &mut eframe::Frame) {
        self.style(&ui.ctx().clone());
        self.name_window(&ui.ctx().clone());
        self.take_dropped(&ui.ctx().clone());
        if let Some(due) = self.session.poll() {
            ui.ctx().request_repaint_after(due);
        }
        self.advance_clock(ui);
        panels::follow(self, frame.info().cpu_usage.map(Duration::from_secs_f32));
        self.recovery.keep(ui.ctx(), self.session.documents());
        dialogs::close_by_key(self, &ui.ctx().clone());
        menu::shortcuts(self, &ui.ctx().clone());
        if !self.only_picture {
            Panel::top("menu").show(ui, |ui| menu::show(self, ui));
        }
        Panel::bottom("status").show(ui, |ui| status::show(self, ui));
        if !self.only_picture {
            let width = ui.available_width();
            let text = Panel::left("text").default_size((TEXT * width).min(560.0));
            text.show(ui, |ui| within(ui, |ui| text::show(self, ui)));
            if self.settings.shows_panel {
                let panel = Panel::right("panel").default_size(PANEL).min_size(240.0);
                panel.show(ui, |ui| within(ui, |ui| panels::show(self, ui)));
            }
        }
        if self.only_picture && self.session.has_errors() {
            // Whoever writes elsewhere has to see here what is wrong.
            Panel::bottom("messages").max_size(180.0).show(ui, |ui| panels::messages::show(self, ui));
        }
        if panels::time::is_wanted(self) {
            Panel::bottom("time").show(ui, |ui| panels::time::show(self, ui));
        }
        CentralPanel::default().frame(egui::Frame::NONE).show(ui, |ui| match gallery::is_wanted(self) {
            true => gallery::show(self, ui),
            false => crate::viewport::show(self, ui),
        });
        dialogs::show(self, ui);
    }

    fn save(&mut self, storage: &mut dyn eframe::Storage) {
        self.settings.open = self.session.documents().iter().filter_map(|document| document.path.clone()).collect();
        self.settings.drawn = self.session.scene_document().path.clone();
        eframe::set_value(storage, eframe::APP_KEY, &self.settings);
    }

    fn on_exit(&mut self) {
        self.recovery.close();
    }
}

/// Shows contents in the room there is, however wide they would be: a panel that grew with them
/// would make the picture another size, which begins anew then. Only the user changes a panel's
/// width.
fn within(ui: &mut Ui, contents: impl FnOnce(&mut Ui)) {
    let room = ui.available_rect_before_wrap();
    let mut inside = ui.new_child(UiBuilder::new().max_rect(room));
    contents(&mut inside);
    ui.advance_cursor_after_rect(room);
}
