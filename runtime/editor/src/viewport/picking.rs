//! A click on a surface selects the expression that made it.

use egui::Response;

use crate::app::Editor;

/// Answers a click.
pub(super) fn pick(editor: &mut Editor, response: &Response) {
    if !response.clicked() {
        return;
    }
    let (Some(pointer), Some(view)) = (response.interact_pointer_pos(), editor.viewport.drawn()) else { return };
    let Some(provenance) = editor.session.shown.as_ref().and_then(|shown| shown.provenance.clone()) else { return };
    let size = response.rect.size();
    let at = pointer - response.rect.min;
    let pixels = [size.x.max(1.0) as u32, size.y.max(1.0) as u32];
    let (eye, direction) = view.ray([f64::from(at.x), f64::from(at.y)], pixels);
    let parameters = editor.session.parameters();
    match provenance.hit(eye, direction, &parameters) {
        Some(point) => {
            let chain = provenance.origin(point, &parameters);
            editor.select(chain, 0);
        }
        None => editor.viewport.selection = None,
    }
}
