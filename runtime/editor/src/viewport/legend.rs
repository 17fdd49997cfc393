//! What the colours of an inspection mean.

use chiaro_render::Legend;
use egui::{Color32, Sense, Ui, vec2};

/// Shows the legend as a list of colours.
pub(super) fn show(ui: &mut Ui, legend: &Legend) {
    ui.style_mut().wrap_mode = Some(egui::TextWrapMode::Extend);
    ui.strong(legend.title);
    for mark in &legend.marks {
        ui.horizontal(|ui| {
            let (swatch, _) = ui.allocate_exact_size(vec2(14.0, 14.0), Sense::hover());
            let [red, green, blue] = mark.color;
            let line = egui::Stroke::new(1.0, ui.visuals().weak_text_color());
            ui.painter().rect(swatch, 2.0, Color32::from_rgb(red, green, blue), line, egui::StrokeKind::Inside);
            ui.label(&mark.label);
        });
    }
    if legend.step > 0.0 {
        ui.label(format!("contours every {} mm", legend.step));
    }
}
