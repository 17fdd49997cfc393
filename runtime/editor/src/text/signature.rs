//! What the call under way takes, above the caret.

use chiaro_assist::CallHint;
use egui::text::{LayoutJob, TextFormat};
use egui::{Align2, Area, Frame, Id, Order, Rect, TextStyle, Ui};

use crate::app::Editor;

/// Shows it while the text is being written.
pub(super) fn show(editor: &Editor, ui: &Ui, caret: Rect, has_focus: bool) {
    let is_quiet = editor.text.list.is_some() || editor.text.drag.is_some();
    if !has_focus || is_quiet || !caret.is_positive() {
        return;
    }
    let Some(hint) = &editor.text.around.call else { return };
    let area = Area::new(Id::unique("signature")).order(Order::Foreground).interactable(false);
    let area = area.pivot(Align2::LEFT_BOTTOM).fixed_pos(caret.left_top() - egui::vec2(0.0, 4.0));
    area.constrain_to(ui.ctx().content_rect()).show(ui.ctx(), |ui| {
        Frame::popup(ui.style()).inner_margin(4.0).show(ui, |ui| {
            ui.set_max_width(460.0);
            ui.label(signature(ui, hint));
            if !hint.manual.is_empty() {
                super::manual::show(ui, &hint.manual);
            }
        });
    });
}

/// The signature, with the parameter at the caret picked out.
fn signature(ui: &Ui, hint: &CallHint) -> LayoutJob {
    let font = TextStyle::Monospace.resolve(ui.style());
    let visuals = ui.visuals();
    let weak = TextFormat::simple(font.clone(), visuals.weak_text_color());
    let strong = TextFormat::simple(font, visuals.strong_text_color());
    let active = hint.active.clone().filter(|range| hint.signature.get(range.clone()).is_some()).unwrap_or(0..0);
    let mut job = LayoutJob::default();
    job.wrap.max_width = 450.0;
    job.append(&hint.signature[..active.start], 0.0, weak.clone());
    job.append(&hint.signature[active.clone()], 0.0, strong);
    job.append(&hint.signature[active.end..], 0.0, weak);
    job
}
