//! Find and replace.

use std::ops::Range;

use chiaro_assist::Edit;
use egui::{Button, Key, Modifiers, TextEdit, Ui};

use super::edits::Change;
use crate::app::Editor;
use crate::theme::sign;

/// The width of the fields, in points.
const FIELD: f32 = 150.0;
/// The most places that are looked for.
const MOST_HITS: usize = 20_000;

/// The search under way.
#[derive(Default)]
pub(crate) struct Find {
    query: Query,
    replacement: String,
    replaces: bool,
    /// What the hits were found for: the query and the text's version.
    of: Option<(Query, u64)>,
    hits: Vec<Range<usize>>,
    /// Where the search began: while the query is written, the first place from here on is shown.
    from: usize,
    /// The field for what is looked for has to get the keyboard.
    wants_focus: bool,
}

/// What is looked for.
#[derive(Clone, Default, PartialEq)]
struct Query {
    text: String,
    with_case: bool,
    whole_words: bool,
}

impl Find {
    pub(super) fn hits(&self) -> &[Range<usize>] {
        &self.hits
    }

    fn update(&mut self, text: &str, version: u64) {
        let of = Some((self.query.clone(), version));
        if self.of != of {
            self.hits = self.query.hits(text);
            self.of = of;
        }
    }
}

impl Query {
    /// Where it stands in a text.
    fn hits(&self, text: &str) -> Vec<Range<usize>> {
        if self.text.is_empty() {
            return Vec::new();
        }
        // Letters are told apart by case in ASCII only: other texts keep their bytes' places.
        let fold = |text: &str| if self.with_case { text.to_owned() } else { text.to_ascii_lowercase() };
        let (folded, wanted) = (fold(text), fold(&self.text));
        let is_of_word = |letter: char| letter.is_alphanumeric() || letter == '_';
        let is_whole = |range: &Range<usize>| {
            let before = text[..range.start].chars().next_back().is_some_and(is_of_word);
            let after = text[range.end..].chars().next().is_some_and(is_of_word);
            !self.whole_words || !before && !after
        };
        let found = folded.match_indices(&wanted).map(|(at, hit)| at..at + hit.len());
        found.filter(is_whole).take(MOST_HITS).collect()
    }
}

/// Opens the bar. What is selected on one line is looked for.
pub(super) fn open(editor: &mut Editor, replaces: bool) {
    let selected = editor.selected();
    let (word, from) = (selected.text[selected.range()].to_owned(), selected.range().start);
    let find = editor.text.find.get_or_insert_default();
    find.replaces |= replaces;
    find.wants_focus = true;
    find.from = from;
    if !word.is_empty() && !word.contains('\n') {
        find.query.text = word;
    }
}

/// Finds the places in the text as it is at this moment: it may have changed since the bar was drawn.
fn look_again(editor: &mut Editor) {
    let Editor { session, text: panel, .. } = editor;
    if let Some(find) = &mut panel.find {
        (find.hits, find.of) = (find.query.hits(&session.active().text), None);
    }
}

/// Goes to the next place, or to the one before.
pub(super) fn go(editor: &mut Editor, forward: bool) {
    let caret = editor.selected().range();
    look_again(editor);
    let Some(find) = &editor.text.find else { return open(editor, false) };
    let hits = &find.hits;
    let next = match forward {
        true => hits.iter().find(|hit| hit.start >= caret.end && hit.end > caret.end).or(hits.first()),
        false => hits.iter().rev().find(|hit| hit.end <= caret.start).or(hits.last()),
    };
    if let Some(hit) = next.cloned() {
        editor.session.active_mut().select(hit.start, hit.end);
        editor.text.shows_caret = true;
    }
}

/// Shows the first place from where the search began, while what is looked for is being written.
fn go_first(editor: &mut Editor) {
    look_again(editor);
    let Some(find) = &editor.text.find else { return };
    if let Some(hit) = find.hits.iter().find(|hit| hit.start >= find.from).or(find.hits.first()).cloned() {
        editor.session.active_mut().select(hit.start, hit.end);
        editor.text.shows_caret = true;
    }
}

/// What was asked of the bar.
#[derive(Clone, Copy, PartialEq)]
enum Asked {
    First,
    Next,
    Previous,
    Replace,
    ReplaceAll,
    Close,
}

/// Shows the bar, if it is open.
pub(super) fn show(editor: &mut Editor, ui: &mut Ui) {
    let caret = editor.selected().range();
    let Editor { session, text: panel, .. } = &mut *editor;
    let Some(find) = &mut panel.find else { return };
    find.update(&session.active().text, panel.layout.version());
    let mut asked = None;
    egui::Grid::new("find").num_columns(2).spacing(ui.spacing().item_spacing).show(ui, |ui| {
        asked = searching(ui, find, &caret);
        ui.end_row();
        if find.replaces {
            asked = replacing(ui, find).or(asked);
        }
    });
    match asked {
        Some(Asked::First) => go_first(editor),
        Some(Asked::Next) => go(editor, true),
        Some(Asked::Previous) => go(editor, false),
        Some(Asked::Replace) => replace(editor),
        Some(Asked::ReplaceAll) => replace_all(editor),
        Some(Asked::Close) => {
            editor.text.find = None;
            editor.text.wants_focus = true;
        }
        None => {}
    }
}

/// The row of what is looked for.
fn searching(ui: &mut Ui, find: &mut Find, caret: &Range<usize>) -> Option<Asked> {
    let mut asked = None;
    let label = ui.label("Find");
    ui.horizontal(|ui| {
        let field = ui.add(TextEdit::singleline(&mut find.query.text).desired_width(FIELD)).labelled_by(label.id);
        if std::mem::take(&mut find.wants_focus) {
            field.request_focus();
        }
        asked = asked_by_key(ui, &field);
        find.wants_focus = matches!(asked, Some(Asked::Next | Asked::Previous));
        let before = find.query.clone();
        toggle(ui, &mut find.query.with_case, "Aa", "Tell capitals apart");
        toggle(ui, &mut find.query.whole_words, "word", "Whole words only");
        if field.changed() || before != find.query {
            asked = Some(Asked::First);
        }
        let is_found = !find.hits.is_empty();
        for (name, what, step) in [("↑", "Previous", Asked::Previous), ("↓", "Next", Asked::Next)] {
            if named(ui.add_enabled(is_found, Button::new(sign(name))), what).clicked() {
                asked = Some(step);
            }
        }
        let chosen = find.hits.iter().position(|hit| hit == caret).map_or("–".to_owned(), |at| (at + 1).to_string());
        ui.weak(format!("{chosen} of {}", find.hits.len()));
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            if named(ui.button(sign("×")), "Close").clicked() {
                asked = Some(Asked::Close);
            }
        });
    });
    asked
}

/// What a key asks for that is pressed in the field.
fn asked_by_key(ui: &Ui, field: &egui::Response) -> Option<Asked> {
    if !field.has_focus() && !field.lost_focus() {
        return None;
    }
    let keys = [
        (Modifiers::SHIFT, Key::Enter, Asked::Previous),
        (Modifiers::NONE, Key::Enter, Asked::Next),
        (Modifiers::NONE, Key::Escape, Asked::Close),
    ];
    let is_pressed = |modifiers, key| ui.input_mut(|input| input.consume_key(modifiers, key));
    keys.into_iter().find(|(modifiers, key, _)| is_pressed(*modifiers, *key)).map(|(.., asked)| asked)
}

/// The row of what it is replaced by.
fn replacing(ui: &mut Ui, find: &mut Find) -> Option<Asked> {
    let label = ui.label("Replace by");
    let row = ui.horizontal(|ui| {
        ui.add(TextEdit::singleline(&mut find.replacement).desired_width(FIELD)).labelled_by(label.id);
        let is_found = !find.hits.is_empty();
        let one = ui.add_enabled(is_found, Button::new("Replace")).clicked().then_some(Asked::Replace);
        let all = ui.add_enabled(is_found, Button::new("Replace all")).clicked().then_some(Asked::ReplaceAll);
        one.or(all)
    });
    row.inner
}

/// A button that stays pressed.
fn toggle(ui: &mut Ui, is_on: &mut bool, name: &str, what: &str) {
    if ui.add(Button::new(name).selected(*is_on)).on_hover_text(what).clicked() {
        *is_on = !*is_on;
    }
}

/// Says what a button does whose face is a sign.
fn named(button: egui::Response, what: &str) -> egui::Response {
    button.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, what));
    button.on_hover_text(what)
}

/// Replaces the hit that is selected, and goes to the next.
fn replace(editor: &mut Editor) {
    look_again(editor);
    let range = editor.selected().range();
    let Some(find) = &editor.text.find else { return };
    if find.hits.contains(&range) {
        editor.change(&Change::replacement(range, find.replacement.clone()));
    }
    go(editor, true);
}

fn replace_all(editor: &mut Editor) {
    look_again(editor);
    let Some(find) = &editor.text.find else { return };
    let edit = |hit: &Range<usize>| Edit { range: hit.clone(), text: find.replacement.clone() };
    let change = Change::around(editor.selected(), find.hits.iter().map(edit).collect());
    editor.session.active_mut().history.pause();
    editor.change(&change);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hits(text: &str, wanted: &str, with_case: bool, whole_words: bool) -> Vec<usize> {
        let query = Query { text: wanted.to_owned(), with_case, whole_words };
        query.hits(text).into_iter().map(|hit| hit.start).collect()
    }

    #[test]
    fn places_are_found() {
        let text = "Cube(1); cubes(2); é cube(3);";
        assert_eq!(hits(text, "cube", false, false), [0, 9, 22]);
        assert_eq!(hits(text, "cube", true, false), [9, 22]);
        assert_eq!(hits(text, "cube", true, true), [22]);
        assert!(hits(text, "", true, true).is_empty());
    }
}
