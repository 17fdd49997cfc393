//! The open texts, one tab each.

use egui::{Color32, Response, RichText, ScrollArea, Sense, Ui, vec2};

use crate::app::Editor;
use crate::document::DocumentId;

/// What was asked of a tab.
enum Asked {
    Show,
    Close,
    Draw(DocumentId),
}

/// Shows the tabs.
pub(super) fn show(editor: &mut Editor, ui: &mut Ui) {
    let drawn = editor.session.scene_document().id;
    let (count, active) = (editor.session.documents().len(), editor.session.active_index());
    let mut asked = None;
    ScrollArea::horizontal().id_salt("tabs").show(ui, |ui| {
        ui.horizontal(|ui| {
            for index in 0..count {
                if let Some(wish) = tab(editor, ui, index, index == active, drawn) {
                    asked = Some((index, wish));
                }
            }
        });
    });
    editor.text.shown_tab = Some(editor.session.active().id);
    match asked {
        Some((index, Asked::Show)) => {
            editor.session.activate(index);
            editor.text.wants_focus = true;
        }
        Some((index, Asked::Close)) => editor.ask_to_close(index),
        Some((_, Asked::Draw(id))) => editor.session.draw(id),
        None => {}
    }
}

fn tab(editor: &Editor, ui: &mut Ui, index: usize, is_active: bool, drawn: DocumentId) -> Option<Asked> {
    let document = &editor.session.documents()[index];
    let (title, id) = (document.title(), document.id);
    let name = if document.is_modified() { format!("{title} •") } else { title.clone() };
    let is_drawn = id == drawn && editor.session.documents().len() > 1;
    let text = if is_drawn { RichText::new(name).strong() } else { RichText::new(name) };
    let mut asked = None;
    let response = ui.selectable_label(is_active, text);
    let path = document.path.as_ref().map_or("not saved yet".to_owned(), |path| path.display().to_string());
    let note = if is_drawn { "\nThis is the scene in the picture." } else { "" };
    let response = response.on_hover_text(format!("{path}{note}"));
    if is_active && editor.text.shown_tab != Some(id) {
        response.scroll_to_me(None);
    }
    if response.clicked() {
        asked = Some(Asked::Show);
    }
    if response.middle_clicked() || cross(ui, &title).clicked() {
        asked = Some(Asked::Close);
    }
    response.context_menu(|ui| {
        if ui.add_enabled(id != drawn, egui::Button::new("Draw this file")).clicked() {
            asked = Some(Asked::Draw(id));
        }
        if ui.button("Close").clicked() {
            asked = Some(Asked::Close);
        }
    });
    asked
}

/// A small cross that closes the tab at its left.
fn cross(ui: &mut Ui, title: &str) -> Response {
    let (rect, response) = ui.allocate_exact_size(vec2(14.0, 14.0), Sense::click());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, format!("Close {title}")));
    let color = if response.hovered() { ui.visuals().strong_text_color() } else { ui.visuals().weak_text_color() };
    let arm = rect.shrink(4.0);
    let stroke = egui::Stroke::new(1.2, color);
    if response.hovered() {
        ui.painter().rect_filled(rect, 3.0, Color32::from_gray(128).gamma_multiply(0.25));
    }
    ui.painter().line_segment([arm.left_top(), arm.right_bottom()], stroke);
    ui.painter().line_segment([arm.right_top(), arm.left_bottom()], stroke);
    response
}
