//! Somebody who uses the editor.

use std::fs;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use chiaro_render::Preference;
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Role, Vec2, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{AccessKitNode, Queryable};
use image::{Rgba, RgbaImage};
use tempfile::TempDir;

use super::{kept, likeness};
use crate::app::{Editor, Options};
use crate::studio::Look;

/// In points, which are pixels here.
const WINDOW: Vec2 = vec2(1200.0, 640.0);
/// Nothing takes so long, on any machine.
const PATIENCE: Duration = Duration::from_secs(400);
/// Samples of a picture that is waited for.
const SAMPLES: u32 = 4;

/// Somebody before a window.
pub(super) struct Person {
    pub(super) harness: Harness<'static, Editor>,
    folder: TempDir,
}

impl Person {
    /// Opens a scene with this text.
    pub(super) fn with(text: &str) -> Self {
        Self::with_files(&[("main.csg", text)])
    }

    /// Opens the first of some files that lie in one folder.
    pub(super) fn with_files(files: &[(&str, &str)]) -> Self {
        let folder = tempfile::tempdir().unwrap();
        for (name, text) in files {
            fs::write(folder.path().join(name), text).unwrap();
        }
        let first = files.first().map(|(name, _)| folder.path().join(name));
        Self::before(folder, first.into_iter().collect())
    }

    /// Opens an editor with these files of a folder.
    pub(super) fn before(folder: TempDir, files: Vec<PathBuf>) -> Self {
        let options = Options {
            files,
            adapter: Preference::Software,
            data: Some(folder.path().join("data")),
            ..Default::default()
        };
        let build = move |context: &mut eframe::CreationContext<'static>| {
            let mut editor = Editor::new(context, options);
            editor.settings.samples = SAMPLES;
            editor
        };
        let harness = Harness::builder().with_size(WINDOW).with_step_dt(0.1).wgpu().build_eframe(build);
        let mut person = Self { harness, folder };
        person.frames(2);
        person
    }

    pub(super) fn editor(&self) -> &Editor {
        self.harness.state()
    }

    pub(super) fn editor_mut(&mut self) -> &mut Editor {
        self.harness.state_mut()
    }

    pub(super) fn text(&self) -> &str {
        &self.editor().session.active().text
    }

    pub(super) fn file(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Lets some frames pass.
    pub(super) fn frames(&mut self, count: usize) {
        self.harness.run_steps(count);
    }

    /// Waits until something is so.
    #[track_caller]
    pub(super) fn until(&mut self, what: &str, is_so: impl Fn(&Editor) -> bool) {
        let begun = Instant::now();
        while !is_so(self.editor()) {
            let editor = self.editor();
            assert!(
                begun.elapsed() < PATIENCE,
                "not {what}: {:?}, {:?}",
                editor.session.trouble,
                editor.session.active().text
            );
            std::thread::sleep(Duration::from_millis(10));
            self.harness.step();
        }
    }

    /// Waits until the picture is of the text, in all its samples.
    #[track_caller]
    pub(super) fn until_drawn(&mut self) {
        self.until("drawn", |editor| {
            let (session, viewport) = (&editor.session, &editor.viewport);
            let is_compiled = session.outcome.as_ref().is_some() && !session.is_outdated();
            // What isn't lit has one sample.
            let is_fine = viewport.samples() >= SAMPLES || viewport.look != Look::Lit;
            is_compiled && is_fine && !session.wanted().moving && viewport.is_settled(session.wanted())
        });
    }

    /// Waits until the text is compiled, with or without errors.
    #[track_caller]
    pub(super) fn until_compiled(&mut self) {
        self.until("compiled", |editor| editor.session.is_compiled());
    }

    /// Waits until picture and text are one.
    #[track_caller]
    pub(super) fn until_linked(&mut self) {
        self.until_drawn();
        let is_linked = |editor: &Editor| editor.session.shown.as_ref().is_some_and(|shown| shown.provenance.is_some());
        self.until("linked", is_linked);
    }

    /// Writes letter by letter.
    pub(super) fn types(&mut self, text: &str) {
        for letter in text.chars() {
            self.harness.event(Event::Text(letter.to_string()));
            self.frames(1);
        }
    }

    /// Does several things so fast that the window sees all of them in one frame.
    pub(super) fn at_once(&mut self, events: impl IntoIterator<Item = Event>) {
        self.harness.input_mut().events.extend(events);
        self.frames(1);
    }

    /// Sets the fields for a number that have this name, one after the other.
    pub(super) fn sets(&mut self, label: &str, values: &[f64]) {
        for (index, value) in values.iter().enumerate() {
            let fields: Vec<_> = self.harness.get_all_by_role_and_label(Role::SpinButton, label).collect();
            assert_eq!(fields.len(), values.len(), "{label}");
            fields[index].set_value_accesskit(*value);
            drop(fields);
            self.frames(1);
        }
    }

    pub(super) fn presses(&mut self, modifiers: Modifiers, key: Key) {
        self.harness.key_press_modifiers(modifiers, key);
        self.frames(2);
    }

    /// Where a byte of the text is in the window.
    pub(super) fn place(&self, byte: usize) -> Pos2 {
        let page = self.harness.get_by_role(Role::MultilineTextInput).rect();
        self.editor().text.place(byte) + page.min.to_vec2() + vec2(1.0, 0.0)
    }

    /// Puts the caret before some part of the text.
    #[track_caller]
    pub(super) fn goes_to(&mut self, part: &str) {
        let at = self.place(self.text().find(part).unwrap());
        self.clicks(at, Modifiers::NONE);
        assert!(self.text()[self.editor().session.active().caret..].starts_with(part));
    }

    /// Rests with the pointer on some part of the text.
    pub(super) fn rests_on(&mut self, part: &str) {
        let at = self.place(self.text().find(part).unwrap());
        self.harness.hover_at(at + vec2(3.0, 0.0));
        self.frames(8);
    }

    pub(super) fn clicks(&mut self, at: Pos2, modifiers: Modifiers) {
        self.harness.event(Event::ModifiersChanged(modifiers));
        self.harness.hover_at(at);
        self.frames(1);
        for pressed in [true, false] {
            self.harness.event(Event::PointerButton { pos: at, button: PointerButton::Primary, pressed, modifiers });
            self.frames(1);
        }
        self.harness.event(Event::ModifiersChanged(Modifiers::NONE));
        self.frames(1);
    }

    /// Clicks what has this name.
    #[track_caller]
    pub(super) fn clicks_on(&mut self, label: &str) {
        self.harness.get_by_label(label).click();
        self.frames(3);
    }

    /// Clicks a button that has this name.
    #[track_caller]
    pub(super) fn clicks_button(&mut self, label: &str) {
        self.harness.get_by_role_and_label(Role::Button, label).click();
        self.frames(3);
    }

    /// Drags from one place to another in some steps.
    pub(super) fn drags(&mut self, from: Pos2, by: Vec2, modifiers: Modifiers) {
        let button = |pos, pressed| Event::PointerButton { pos, button: PointerButton::Primary, pressed, modifiers };
        self.harness.event(Event::ModifiersChanged(modifiers));
        self.harness.hover_at(from);
        self.frames(2);
        self.harness.event(button(from, true));
        self.frames(1);
        for step in 1..=8 {
            self.harness.hover_at(from + by * (step as f32 / 8.0));
            self.frames(1);
        }
        self.harness.event(button(from + by, false));
        self.harness.event(Event::ModifiersChanged(Modifiers::NONE));
        self.frames(2);
    }

    /// Compares the window, but for its status line, with the picture of it that is kept. `CHIARO_BLESS=1` keeps this one.
    #[track_caller]
    pub(super) fn sees(&mut self, name: &str) {
        self.harness.remove_cursor();
        // A caret that blinks is there after some numbers of frames, and not after others.
        self.harness.ctx.all_styles_mut(|style| style.visuals.text_cursor.blink = false);
        self.frames(2);
        let is_outlined = |editor: &Editor| editor.viewport.selection.is_none() || editor.viewport.is_outlined();
        self.until("outlined", is_outlined);
        let is_highlighted =
            |editor: &Editor| editor.session.wanted().highlighted.is_none() || editor.viewport.is_highlighted();
        self.until("highlighted", is_highlighted);
        let seen = self.harness.render().unwrap();
        let seen = self.without_paths(seen);
        let path = kept::path(name);
        if std::env::var_os("CHIARO_BLESS").is_some() {
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            seen.save(&path).unwrap();
            return;
        }
        let before = image::open(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display())).to_rgba8();
        let difference = likeness::difference(&kept::compared(&seen), &kept::compared(&before));
        if difference > kept::TOLERANCE {
            let now = std::env::temp_dir().join(format!("chiaro-editor-{name}.png"));
            seen.save(&now).unwrap();
            panic!("{name} differs by {difference:.2}: see {}; CHIARO_BLESS=1 keeps it", now.display());
        }
    }

    /// A window in which nothing is seen of where the folder is: it has another name each time.
    fn without_paths(&self, mut window: RgbaImage) -> RgbaImage {
        let folder = self.folder.path().display().to_string();
        let shows_folder = |node: &AccessKitNode| {
            [node.value(), node.label()].into_iter().flatten().any(|text| text.contains(&folder))
        };
        for node in self.harness.query_all_by(shows_folder) {
            let rect = node.rect();
            for (x, y, pixel) in window.enumerate_pixels_mut() {
                if rect.contains(pos2(x as f32 + 0.5, y as f32 + 0.5)) {
                    *pixel = Rgba([0, 0, 0, 255]);
                }
            }
        }
        window
    }
}
