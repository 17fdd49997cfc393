//! What is told about the place under the pointer: messages with their fixes, the manual, numbers to drag.

use std::ops::Range;

use chiaro_assist::hover;
use chiaro_compiler::syntax::Severity;
use egui::text_edit::TextEditOutput;
use egui::{Area, CursorIcon, Frame, Id, Order, Rect, RichText, Ui};

use super::edits::Change;
use super::messages::Message;
use super::{colors, navigate, numbers};
use crate::app::Editor;

/// The pointer has to rest so long, in seconds.
const REST: f64 = 0.35;
/// In points.
const WIDTH: f32 = 440.0;
/// So far from what is told one may stray on the way to it, in points.
const STRAY: f32 = 6.0;

/// What the pointer rests on.
#[derive(Default)]
pub(super) struct Hovering {
    /// The byte, and since when in the window's time.
    at: Option<(usize, f64)>,
    told: Option<Told>,
}

/// What is being told.
struct Told {
    /// The word that it is about, and the text's version then.
    range: Range<usize>,
    version: u64,
    place: Rect,
    window: Rect,
    messages: Vec<Message>,
    title: String,
    body: String,
    is_number: bool,
}

/// Tells about what the pointer rests on; a click with Ctrl goes to its definition.
pub(super) fn show(editor: &mut Editor, ui: &Ui, output: &TextEditOutput, page: Rect) {
    let pointer = ui.input(|input| input.pointer.hover_pos()).filter(|at| page.contains(*at));
    let over = pointer.filter(|_| output.response.contains_pointer());
    let byte = over.and_then(|at| editor.text.layout.byte_at(at - output.galley_pos));
    follow_links(editor, ui, output, byte);
    let is_busy = ui.input(|input| {
        input.pointer.any_down() || !input.events.is_empty() && input.pointer.is_moving() && byte.is_none()
    });
    if editor.text.list.is_some() || editor.text.drag.is_some() && editor.text.hover.told.is_none() {
        editor.text.hover = Hovering::default();
        return;
    }
    forget(editor, ui);
    rest(editor, ui, byte, is_busy, output);
    let Some(mut told) = editor.text.hover.told.take() else { return };
    let (window, asked) = tell(editor, ui, &told);
    told.window = window;
    match asked {
        Some(Asked::Fix(change)) => editor.change(&change),
        Some(Asked::Drag(steps)) => {
            if editor.text.drag.is_none()
                && let Some(number) = numbers::at(&editor.session.active().text, told.range.start)
            {
                numbers::begin(editor, &number);
            }
            numbers::step(editor, steps);
            editor.text.hover.told = Some(told);
        }
        Some(Asked::Drop) => {
            numbers::end(editor);
            editor.text.hover.told = Some(told);
        }
        None => editor.text.hover.told = Some(told),
    }
}

/// While Ctrl is held, names are links.
fn follow_links(editor: &mut Editor, ui: &Ui, output: &TextEditOutput, byte: Option<usize>) {
    let Some(byte) = byte.filter(|_| ui.input(|input| input.modifiers.command)) else { return };
    ui.ctx().set_cursor_icon(CursorIcon::PointingHand);
    if output.response.clicked() {
        navigate::to_definition(editor, byte);
    }
}

/// Forgets what was told if the pointer left it, or if the text changed by other means than a drag.
fn forget(editor: &mut Editor, ui: &Ui) {
    let is_dragged = editor.text.drag.is_some();
    let version = editor.text.layout.version();
    let Some(told) = &mut editor.text.hover.told else { return };
    if is_dragged {
        told.version = version;
        return;
    }
    // Who uses the keyboard looks elsewhere.
    let has_typed = ui.input(|input| !input.keys_down.is_empty());
    let pointer = ui.input(|input| input.pointer.hover_pos()).filter(|_| !has_typed);
    let stays =
        pointer.is_some_and(|at| told.place.expand(STRAY).contains(at) || told.window.expand(STRAY).contains(at));
    if !stays || told.version != version {
        editor.text.hover.told = None;
    }
}

/// Finds what to tell when the pointer rested long enough.
fn rest(editor: &mut Editor, ui: &Ui, byte: Option<usize>, is_busy: bool, output: &TextEditOutput) {
    let now = ui.input(|input| input.time);
    let Some(byte) = byte.filter(|_| !is_busy) else {
        editor.text.hover.at = None;
        return;
    };
    let since = match editor.text.hover.at {
        Some((at, since)) if at == byte => since,
        _ => now,
    };
    editor.text.hover.at = Some((byte, since));
    let is_told = editor.text.hover.told.as_ref().is_some_and(|told| told.range.contains(&byte));
    if is_told {
        return;
    }
    if now - since < REST {
        ui.ctx().request_repaint_after_secs((REST - (now - since)) as f32);
        return;
    }
    if let Some(told) = found(editor, byte, output) {
        editor.text.hover.told = Some(told);
    }
}

fn found(editor: &Editor, byte: usize, output: &TextEditOutput) -> Option<Told> {
    let text = &editor.session.active().text;
    let layout = &editor.text.layout;
    let messages: Vec<Message> =
        editor.text.messages.found.iter().filter(|message| message.is_at(byte)).cloned().collect();
    let manual = if layout.is_small() { hover(text, byte) } else { None };
    let number = numbers::at(text, byte);
    let range = manual.as_ref().map(|manual| manual.range.clone());
    let range = range.or_else(|| number.as_ref().map(|number| number.range.clone()));
    let range = range.or_else(|| messages.first().map(|message| message.range.clone()))?;
    let (title, body) = manual.map_or_else(Default::default, |manual| (manual.title, manual.body));
    let place = layout.caret(byte).translate(output.galley_pos.to_vec2());
    Some(Told {
        range,
        version: layout.version(),
        place,
        window: place,
        messages,
        title,
        body,
        is_number: number.is_some(),
    })
}

/// What was done in the window.
enum Asked {
    Fix(Change),
    /// So many steps of a number.
    Drag(f32),
    Drop,
}

fn tell(editor: &Editor, ui: &Ui, told: &Told) -> (Rect, Option<Asked>) {
    let mut asked = None;
    let content = ui.ctx().content_rect();
    let is_low = told.place.bottom() + 160.0 > content.bottom();
    let area = Area::new(Id::unique("hover")).order(Order::Foreground).constrain_to(content);
    let area = match is_low {
        true => area.pivot(egui::Align2::LEFT_BOTTOM).fixed_pos(told.place.left_top() - egui::vec2(0.0, 4.0)),
        false => area.fixed_pos(told.place.left_bottom() + egui::vec2(0.0, 4.0)),
    };
    let shown = area.show(ui.ctx(), |ui| {
        Frame::popup(ui.style()).inner_margin(6.0).show(ui, |ui| {
            ui.set_max_width(WIDTH);
            for message in &told.messages {
                asked = tell_message(ui, message).map(Asked::Fix).or(asked.take());
            }
            if !told.messages.is_empty() && !told.title.is_empty() {
                ui.separator();
            }
            if !told.title.is_empty() {
                ui.label(RichText::new(&told.title).monospace().color(ui.visuals().strong_text_color()));
            }
            if !told.body.is_empty() {
                super::manual::show(ui, &told.body);
            }
            if told.is_number {
                asked = number(editor, ui).or(asked.take());
            }
        });
    });
    (shown.response.rect, asked)
}

/// A message with its hints and fixes. The fix that was clicked, if one was.
fn tell_message(ui: &mut Ui, message: &Message) -> Option<Change> {
    let severity = message.severity();
    let name = match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Note => "note",
    };
    ui.horizontal_wrapped(|ui| {
        ui.colored_label(colors::of_severity(severity, ui.visuals().dark_mode), name);
        ui.label(&message.diagnostic.message);
    });
    for hint in &message.diagnostic.hints {
        super::manual::show(ui, hint);
    }
    let mut taken = None;
    for fix in &message.fixes {
        if ui.button(fix.title.replace('`', "")).clicked() {
            taken = Some(fix.change.clone());
        }
    }
    taken
}

/// A strip that changes the number when it is dragged.
fn number(editor: &Editor, ui: &mut Ui) -> Option<Asked> {
    let strip = egui::Button::new("Drag to change").sense(egui::Sense::drag());
    let response = ui.add(strip).on_hover_cursor(CursorIcon::ResizeHorizontal);
    ui.weak("In the text: Ctrl and drag. Shift makes finer steps.");
    if response.dragged() {
        return Some(Asked::Drag(response.drag_delta().x / 4.0));
    }
    (response.drag_stopped() && editor.text.drag.is_some()).then_some(Asked::Drop)
}
