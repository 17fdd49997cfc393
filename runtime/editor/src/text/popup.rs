//! A list at the caret to choose from.

use egui::{Area, Frame, Id, Key, Modifiers, Order, Pos2, Rect, RichText, ScrollArea, Ui};

use super::edits::Change;

/// The most rows that are seen at once.
const ROWS: f32 = 9.0;
/// In points.
const WIDTH: f32 = 430.0;

/// What can be chosen.
#[derive(Clone)]
pub(super) struct Choice {
    pub(super) label: String,
    /// A word for what kind of thing it is.
    pub(super) kind: &'static str,
    /// The signature, and what it is about.
    pub(super) detail: String,
    pub(super) documentation: String,
    pub(super) change: Change,
}

/// A list of choices.
pub(super) struct List {
    /// The list's name.
    pub(super) name: &'static str,
    pub(super) choices: Vec<Choice>,
    pub(super) chosen: usize,
    /// The place in the text that it is at, in bytes.
    pub(super) at: usize,
    /// Where it was drawn last.
    rect: Option<Rect>,
    /// The choice moved, and has to be scrolled to.
    has_moved: bool,
}

/// What became of the list.
pub(super) enum Answer {
    Stays,
    Closed,
    Taken(Change),
}

impl List {
    pub(super) fn new(name: &'static str, choices: Vec<Choice>, at: usize) -> Self {
        Self { name, choices, chosen: 0, at, rect: None, has_moved: true }
    }

    /// Whether the pointer is over it.
    pub(super) fn is_under(&self, pointer: Option<Pos2>) -> bool {
        self.rect.zip(pointer).is_some_and(|(rect, pointer)| rect.contains(pointer))
    }

    /// Takes the keys that are the list's.
    pub(super) fn take_keys(&mut self, ui: &Ui) -> Answer {
        let pressed = |key| ui.input_mut(|input| input.consume_key(Modifiers::NONE, key));
        let count = self.choices.len();
        let page = ROWS as usize - 1;
        let moves = [(Key::ArrowDown, 1), (Key::ArrowUp, count - 1), (Key::PageDown, page), (Key::PageUp, 0)];
        for (key, steps) in moves {
            if pressed(key) {
                self.has_moved = true;
                self.chosen = match key {
                    Key::PageDown => (self.chosen + steps).min(count - 1),
                    Key::PageUp => self.chosen.saturating_sub(page),
                    _ => (self.chosen + steps) % count,
                };
            }
        }
        if pressed(Key::Escape) {
            return Answer::Closed;
        }
        if pressed(Key::Enter) || pressed(Key::Tab) {
            return Answer::Taken(self.choices[self.chosen].change.clone());
        }
        Answer::Stays
    }

    /// Shows the list below the caret, or above it where there is no room. Answers what was clicked.
    pub(super) fn show(&mut self, ui: &Ui, caret: Rect) -> Option<Change> {
        let window = ui.ctx().content_rect();
        let is_above = caret.bottom() + 220.0 > window.bottom() && caret.top() - window.top() > 220.0;
        let area = Area::new(Id::unique(self.name)).order(Order::Foreground).constrain_to(window);
        let area = if is_above {
            area.pivot(egui::Align2::LEFT_BOTTOM).fixed_pos(caret.left_top() - egui::vec2(0.0, 3.0))
        } else {
            area.fixed_pos(caret.left_bottom() + egui::vec2(0.0, 3.0))
        };
        let mut taken = None;
        let shown = area.accessible_name(self.name).show(ui.ctx(), |ui| {
            Frame::popup(ui.style()).inner_margin(4.0).show(ui, |ui| {
                ui.set_width(WIDTH);
                taken = self.rows(ui);
                self.about(ui);
            });
        });
        self.rect = Some(shown.response.rect);
        taken
    }

    fn rows(&mut self, ui: &mut Ui) -> Option<Change> {
        let mut taken = None;
        let height = ui.text_style_height(&egui::TextStyle::Monospace) + 2.0 * ui.spacing().button_padding.y;
        ui.spacing_mut().item_spacing.y = 0.0;
        let area = ScrollArea::vertical().id_salt("choices").max_height(ROWS * height).animated(false);
        area.show(ui, |ui| {
            for (at, choice) in self.choices.iter().enumerate() {
                let row = ui.horizontal(|ui| {
                    let row = ui.selectable_label(at == self.chosen, RichText::new(&choice.label).monospace());
                    ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| ui.weak(choice.kind));
                    row
                });
                if at == self.chosen && self.has_moved {
                    row.inner.scroll_to_me(None);
                }
                if row.inner.clicked() {
                    taken = Some(choice.change.clone());
                }
            }
        });
        self.has_moved = false;
        taken
    }

    /// What is to be said about the choice.
    fn about(&self, ui: &mut Ui) {
        let Some(choice) = self.choices.get(self.chosen) else { return };
        if choice.detail.is_empty() && choice.documentation.is_empty() {
            return;
        }
        ui.separator();
        let area = ScrollArea::vertical().id_salt("about").max_height(140.0);
        area.show(ui, |ui| {
            ui.spacing_mut().item_spacing.y = 3.0;
            if !choice.detail.is_empty() {
                ui.label(RichText::new(&choice.detail).monospace());
            }
            if !choice.documentation.is_empty() {
                super::manual::show(ui, &choice.documentation);
            }
        });
    }
}
