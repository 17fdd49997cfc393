//! How large a picture is, and how good.

use egui::{DragValue, Ui};

use crate::app::Editor;

/// The most pixels along an edge.
const MOST_EDGE: u32 = 8192;
/// The most samples of a pixel.
const MOST_SAMPLES: u32 = 65_536;

/// The size of a picture in pixels, and its samples of each.
pub(super) struct FrameSize {
    pub(super) size: [u32; 2],
    pub(super) samples: u32,
}

impl FrameSize {
    /// As large as the picture in the window.
    pub(super) fn of(editor: &Editor) -> Self {
        Self { size: editor.session.wanted().size, samples: editor.settings.samples }
    }

    /// Shows the controls: a label, and what stands behind it.
    pub(super) fn show(&mut self, ui: &mut Ui) {
        let label = ui.label("Size");
        ui.horizontal(|ui| {
            let [width, height] = &mut self.size;
            ui.add(DragValue::new(width).range(1..=MOST_EDGE)).labelled_by(label.id);
            ui.label("×");
            ui.add(DragValue::new(height).range(1..=MOST_EDGE).suffix(" px")).labelled_by(label.id);
            ui.add_space(12.0);
            let label = ui.label("Samples");
            ui.add(DragValue::new(&mut self.samples).range(1..=MOST_SAMPLES)).labelled_by(label.id);
        });
    }
}
