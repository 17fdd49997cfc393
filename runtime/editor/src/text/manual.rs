//! Texts of the manual: prose with names between `` ` `` in it.

use egui::text::{LayoutJob, TextFormat};
use egui::{FontId, TextStyle, Ui};

/// Shows a text of the manual.
pub(super) fn show(ui: &mut Ui, text: &str) {
    let prose = TextStyle::Body.resolve(ui.style());
    let code = FontId::monospace(prose.size - 1.0);
    let mut job = LayoutJob::default();
    job.wrap.max_width = ui.available_width();
    for (at, part) in text.split('`').enumerate() {
        let (font, color) = match at % 2 {
            0 => (&prose, ui.visuals().text_color()),
            _ => (&code, ui.visuals().strong_text_color()),
        };
        job.append(part, 0.0, TextFormat::simple(font.clone(), color));
    }
    ui.label(job);
}
