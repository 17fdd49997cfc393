//! The tree of solids.
//!
//! Practice: the tree is made off the window's thread, once for each revision; the list has a row for each node whose parents are
//! open, and only rows in sight are laid out.

mod outline;

use std::sync::Arc;

use chiaro_compiler::vocabulary::{Bounds, Class};
use chiaro_compiler::{Provenance, SolidId};
use egui::{Align2, Color32, CursorIcon, Pos2, Rect, ScrollArea, Sense, Shape, Stroke, TextStyle, Ui, pos2, vec2};

use crate::app::Editor;
use crate::worker::Job;
use outline::{Node, Outline};

/// How far children stand from their parents, in points.
const INDENT: f32 = 14.0;

/// The tree and which of its nodes are open.
#[derive(Default)]
pub(crate) struct Solids {
    /// The scene that the tree is of.
    provenance: Option<Arc<Provenance>>,
    outline: Outline,
    making: Option<Job<Outline>>,
    /// The solid that was shown as selected: a newly selected one is scrolled to.
    selected: Option<SolidId>,
}

/// Shows it.
pub(crate) fn show(editor: &mut Editor, ui: &mut Ui) {
    refresh(editor, ui);
    let Some(provenance) = editor.panels.solids.provenance.clone() else {
        ui.weak("There is no scene yet.");
        return;
    };
    let selected =
        editor.viewport.selection.as_ref().and_then(|selection| selection.origin()).map(|origin| origin.solid);
    let solids = &mut editor.panels.solids;
    let is_new = selected != solids.selected;
    solids.selected = selected;
    let scroll_to = selected.filter(|_| is_new).and_then(|solid| solids.outline.reveal(solid));
    ui.weak(format!("{} expressions", solids.outline.len()));
    let clicked = rows(ui, &mut solids.outline, selected, scroll_to);
    if let Some(node) = clicked {
        select(editor, &provenance, &node);
    }
}

/// Makes the tree of a new scene.
fn refresh(editor: &mut Editor, ui: &Ui) {
    let parameters = editor.session.parameters();
    let newest = editor.session.shown.as_ref().and_then(|shown| shown.provenance.clone());
    let solids = &mut editor.panels.solids;
    if let Some(Ok(mut outline)) = solids.making.as_mut().and_then(Job::poll) {
        outline.open_like(&solids.outline);
        (solids.outline, solids.making) = (outline, None);
    }
    let Some(newest) = newest else { return };
    let is_known = solids.provenance.as_ref().is_some_and(|known| Arc::ptr_eq(known, &newest));
    if !is_known && solids.making.is_none() {
        let provenance = newest.clone();
        solids.provenance = Some(newest);
        solids.making = Job::start(ui.ctx(), move |_| Outline::new(provenance.tree(&parameters))).ok();
    }
}

/// Selects what a row stands for, in the picture and in the text.
fn select(editor: &mut Editor, provenance: &Arc<Provenance>, node: &Node) {
    let is_shown = |shown: &Arc<Provenance>| Arc::ptr_eq(shown, provenance);
    let shown = editor.session.shown.as_ref().and_then(|shown| shown.provenance.as_ref());
    if !shown.is_some_and(is_shown) {
        return;
    }
    let chain = provenance.chain(node.solid);
    let at = chain.iter().position(|origin| origin.span == node.span).unwrap_or(0);
    editor.panels.solids.selected = chain.get(at).map(|origin| origin.solid);
    editor.select(chain, at);
}

/// Lays out the rows in sight. The node that was clicked, if one was.
fn rows(ui: &mut Ui, outline: &mut Outline, selected: Option<SolidId>, scroll_to: Option<usize>) -> Option<Node> {
    let height = ui.spacing().interact_size.y;
    let pitch = height + ui.spacing().item_spacing.y;
    let mut area = ScrollArea::vertical().auto_shrink(false);
    if let Some(row) = scroll_to {
        area = area.vertical_scroll_offset((row as f32 - 4.0).max(0.0) * pitch);
    }
    let (mut toggled, mut clicked) = (None, None);
    area.show_rows(ui, height, outline.visible().len(), |ui, range| {
        for row in range {
            let index = outline.visible()[row];
            match line(ui, outline, index, height, selected) {
                Some(Touch::Toggle) => toggled = Some(index),
                Some(Touch::Select) => clicked = Some(outline.node(index).clone()),
                None => {}
            }
        }
    });
    if let Some(index) = toggled {
        outline.toggle(index);
    }
    clicked
}

/// What was done to a row.
enum Touch {
    Toggle,
    Select,
}

fn line(ui: &mut Ui, outline: &Outline, index: u32, height: f32, selected: Option<SolidId>) -> Option<Touch> {
    let node = outline.node(index);
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::click());
    let is_selected = selected == Some(node.solid);
    response.widget_info(|| egui::WidgetInfo::selected(egui::Role::Button, true, is_selected, &node.what));
    let visuals = ui.style().interact_selectable(&response, is_selected);
    if is_selected || response.hovered() {
        ui.painter().rect_filled(rect, 4.0, visuals.weak_bg_fill);
    }
    let left = rect.left() + 4.0 + INDENT * node.depth as f32;
    let arrow = Rect::from_min_size(pos2(left, rect.top()), vec2(INDENT, height));
    if node.has_children {
        triangle(ui, arrow.center(), outline.is_open(index), visuals.text_color());
    }
    let name = TextStyle::Body.resolve(ui.style());
    let what = if node.what.is_empty() { "scene" } else { &node.what };
    ui.painter().text(
        pos2(arrow.right() + 4.0, rect.center().y),
        Align2::LEFT_CENTER,
        what,
        name,
        visuals.text_color(),
    );
    let small = TextStyle::Small.resolve(ui.style());
    let weak = ui.visuals().weak_text_color();
    ui.painter().text(pos2(rect.right() - 6.0, rect.center().y), Align2::RIGHT_CENTER, facts(node), small, weak);

    let on_arrow =
        response.interact_pointer_pos().is_some_and(|pointer| node.has_children && pointer.x < arrow.right());
    let touch =
        match (response.clicked() && on_arrow, response.double_clicked() && node.has_children, response.clicked()) {
            (true, ..) | (_, true, _) => Some(Touch::Toggle),
            (_, _, true) => Some(Touch::Select),
            _ => None,
        };
    response.on_hover_cursor(CursorIcon::PointingHand).on_hover_ui(|ui| fields(ui, node));
    touch
}

/// Points downwards if what is below is open, and to the right if not.
fn triangle(ui: &Ui, center: Pos2, is_open: bool, color: Color32) {
    let [along, across] = if is_open { [vec2(0.0, 3.0), vec2(3.5, 0.0)] } else { [vec2(3.0, 0.0), vec2(0.0, 3.5)] };
    let corners = vec![center + along, center - along + across, center - along - across];
    ui.painter().add(Shape::convex_polygon(corners, color, Stroke::NONE));
}

/// Class and L in a word.
fn facts(node: &Node) -> String {
    match node.class {
        None => "empty".to_owned(),
        Some(class) if node.lipschitz == 1.0 => class_name(class).to_owned(),
        Some(class) => format!("{}, L {:.3}", class_name(class), node.lipschitz),
    }
}

fn class_name(class: Class) -> &'static str {
    match class {
        Class::Exact => "exact",
        Class::ExactOutside => "exact outside",
        Class::Bound => "bound",
    }
}

/// All that is known about a node.
fn fields(ui: &mut Ui, node: &Node) {
    ui.strong(if node.what.is_empty() { "The scene" } else { &node.what });
    egui::Grid::new("fields").num_columns(2).spacing([12.0, 2.0]).show(ui, |ui| {
        let mut field = |name: &str, value: String| {
            ui.label(name);
            ui.monospace(value);
            ui.end_row();
        };
        let Some(class) = node.class else {
            field("Solid", "nothing".to_owned());
            return;
        };
        field("Distance", class_name(class).to_owned());
        field("L", format!("{:.4}", node.lipschitz));
        let Bounds { min, max } = node.bounds;
        let numbers = |values: [f64; 3]| values.map(|value| format!("{value:.3}")).join(", ");
        field("From", format!("{} mm", numbers(min)));
        field("To", format!("{} mm", numbers(max)));
        field("Size", format!("{} mm", numbers([0, 1, 2].map(|axis| max[axis] - min[axis]))));
    });
}

#[cfg(test)]
impl Solids {
    /// Whether there is such a node in sight.
    pub(super) fn lists(&self, what: &str) -> bool {
        self.outline.visible().iter().any(|index| self.outline.node(*index).what == what)
    }
}
