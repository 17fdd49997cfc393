//! What floats over the picture: how it is looked at, and what is selected.

use chiaro_compiler::shader::Shadows;
use chiaro_render::{Direct, Inspection, Plane};
use egui::{Align2, Area, ComboBox, Frame, Id, Rect, Slider, Ui, vec2};

use super::{handles, legend, navigation};
use crate::app::Editor;
use crate::command::Command;
use crate::studio::{Eye, Look};
use crate::theme::sign;

/// What stands behind the name of a menu.
const OPENS: &str = "▾";

/// The views along the axes, with OpenSCAD's angles in degrees.
pub(crate) const PRESETS: [(&str, [f64; 3]); 7] = [
    ("Front", [90.0, 0.0, 0.0]),
    ("Back", [90.0, 0.0, 180.0]),
    ("Left", [90.0, 0.0, -90.0]),
    ("Right", [90.0, 0.0, 90.0]),
    ("Top", [0.0, 0.0, 0.0]),
    ("Bottom", [180.0, 0.0, 0.0]),
    ("Diagonal", [55.0, 0.0, 25.0]),
];

/// Shows the controls over the picture.
pub(super) fn show(editor: &mut Editor, ui: &Ui, rect: Rect) {
    floating(ui, "picture controls", Align2::LEFT_TOP, rect, |ui| {
        ui.horizontal(|ui| {
            view_menu(editor, ui);
            look_menu(editor, ui);
            light_menu(editor, ui);
        });
        section_controls(editor, ui);
    });
    if let Some(shown) = editor.viewport.legend.clone() {
        floating(ui, "legend", Align2::RIGHT_TOP, rect, |ui| legend::show(ui, &shown));
    }
    if editor.viewport.stance.is_off {
        floating(ui, "size hint", Align2::CENTER_BOTTOM, rect, |ui| size_hint(editor, ui));
    }
    if editor.viewport.selection.is_some() {
        floating(ui, "selection", Align2::LEFT_BOTTOM, rect, |ui| selection_chain(editor, ui));
    }
}

fn floating(ui: &Ui, name: &str, corner: Align2, rect: Rect, contents: impl FnOnce(&mut Ui)) {
    let inside = rect.shrink(8.0);
    let at = corner.pos_in_rect(&inside);
    Area::new(Id::unique(name)).pivot(corner).fixed_pos(at).constrain_to(inside).order(egui::Order::Middle).show(
        ui.ctx(),
        |ui| {
            ui.set_max_width(inside.width());
            Frame::popup(ui.style()).inner_margin(vec2(6.0, 4.0)).show(ui, contents);
        },
    );
}

fn view_menu(editor: &mut Editor, ui: &mut Ui) {
    ui.menu_button(("View", sign(OPENS)), |ui| views(editor, ui));
}

/// The choices of from where to look.
pub(crate) fn views(editor: &mut Editor, ui: &mut Ui) {
    let viewport = &mut editor.viewport;
    if ui.button("Frame all").clicked() {
        viewport.frame_all();
    }
    if ui.add_enabled(viewport.selection.is_some(), egui::Button::new("Frame selection")).clicked() {
        frame_selection(editor);
    }
    let viewport = &mut editor.viewport;
    if ui.button("As the scene says").clicked() {
        viewport.eye = Eye::Scene;
    }
    ui.separator();
    for (name, rotation) in PRESETS {
        if ui.button(name).clicked() {
            viewport.frame_from(rotation);
        }
    }
    ui.separator();
    let mut is_parallel = viewport.field_of_view() <= navigation::PARALLEL;
    if ui
        .checkbox(&mut is_parallel, "Orthographic")
        .on_hover_text("A lens of 1°: lines stay parallel to the eye")
        .changed()
        && let Some(view) = viewport.drawn()
    {
        let field_of_view = if is_parallel { navigation::PARALLEL } else { navigation::PERSPECTIVE };
        viewport.eye = Eye::At(navigation::through(view, field_of_view));
    }
    ui.checkbox(&mut viewport.flies, "Fly").on_hover_text("Drags turn the head; W, A, S, D, Q and E move the eye");
}

/// Looks so that the selected solids fill the picture.
pub(crate) fn frame_selection(editor: &mut Editor) {
    let parameters = editor.session.parameters();
    let (Some(selection), Some(view), Some(rect)) =
        (&editor.viewport.selection, editor.viewport.drawn(), editor.viewport.rect)
    else {
        return;
    };
    let boxes = selection.solids.iter().map(|solid| selection.provenance.bounds(*solid, &parameters));
    let Some(bounds) = boxes.reduce(|a, b| a.union(&b)).filter(|bounds| !bounds.is_empty()) else { return };
    let camera = Eye::Framed(view.rotation, view.field_of_view).camera(&Default::default());
    let aspect = f64::from(rect.width() / rect.height().max(1.0));
    editor.viewport.eye = Eye::At(chiaro_render::View::framing(&camera, &parameters, &bounds, aspect));
    editor.viewport.stance.choose();
}

fn look_menu(editor: &mut Editor, ui: &mut Ui) {
    let now = look_name(&editor.viewport.look);
    ui.menu_button((now, sign(OPENS)), |ui| looks(editor, ui));
}

/// The choices of what to show.
pub(crate) fn looks(editor: &mut Editor, ui: &mut Ui) {
    let offset = editor.viewport.drawn().map_or(0.0, |view| view.target[1]);
    let plane = editor.viewport.plane.unwrap_or(Plane { normal: [0.0, 1.0, 0.0], offset });
    let looks = [
        Look::Lit,
        Look::Inspected(Inspection::Normals),
        Look::Inspected(Inspection::Depth),
        Look::Inspected(Inspection::Evaluations),
        Look::Inspected(Inspection::FieldClass),
        Look::Inspected(Inspection::DistanceError(None)),
        Look::Inspected(Inspection::Section(plane)),
        Look::Inspected(Inspection::DistanceError(Some(plane))),
    ];
    for look in looks {
        let name = look_name(&look);
        if ui.radio(look_name(&editor.viewport.look) == name, name).clicked() {
            editor.viewport.look = look;
        }
    }
}

fn look_name(look: &Look) -> &'static str {
    match look {
        Look::Lit => "Lit",
        Look::Inspected(Inspection::Normals) => "Normals",
        Look::Inspected(Inspection::Depth) => "Depth",
        Look::Inspected(Inspection::Evaluations) => "Evaluations",
        Look::Inspected(Inspection::Section(_)) => "Section",
        Look::Inspected(Inspection::FieldClass) => "Field class and L",
        Look::Inspected(Inspection::DistanceError(None)) => "Distance error",
        Look::Inspected(Inspection::DistanceError(Some(_))) => "Distance error on a section",
    }
}

/// Moves the plane of a section.
fn section_controls(editor: &mut Editor, ui: &mut Ui) {
    let bounds =
        editor.session.shown.as_ref().map(|shown| shown.scene.graph.facts[shown.scene.graph.root.0 as usize].bounds);
    let (Look::Inspected(Inspection::Section(plane) | Inspection::DistanceError(Some(plane))), Some(bounds)) =
        (&mut editor.viewport.look, bounds)
    else {
        return;
    };
    ui.horizontal(|ui| {
        let mut axis = (0..3).find(|axis| plane.normal[*axis] != 0.0).unwrap_or(1);
        for (index, name) in ["x", "y", "z"].into_iter().enumerate() {
            if ui.radio(axis == index, name).clicked() {
                axis = index;
                plane.normal = [0.0; 3];
                plane.normal[axis] = 1.0;
                plane.offset = bounds.center()[axis];
            }
        }
        let finite = |end: f64, other: f64| if end.is_finite() { end } else { other };
        let range = finite(bounds.min[axis], -100.0)..=finite(bounds.max[axis], 100.0);
        ui.add(Slider::new(&mut plane.offset, range).text("mm"));
    });
    editor.viewport.plane = Some(*plane);
}

fn light_menu(editor: &mut Editor, ui: &mut Ui) {
    ui.menu_button(("Light", sign(OPENS)), |ui| {
        let viewport = &mut editor.viewport;
        method_choice(ui, "Shadows", &mut viewport.direct);
        let mut compares = viewport.compared.is_some();
        if ui.checkbox(&mut compares, "Compare with another").changed() {
            viewport.compared = compares.then_some((Direct::By(Shadows::Hard), 0.5));
        }
        if let Some((method, _)) = &mut viewport.compared {
            method_choice(ui, "Right of the divider", method);
        }
        ui.separator();
        ui.checkbox(&mut viewport.floor, "Floor");
        ui.add(Slider::new(&mut viewport.exposure, -6.0..=6.0).text("Exposure in stops"));
        ui.add(Slider::new(&mut editor.settings.samples, 1..=4096).logarithmic(true).text("Samples"));
    });
}

fn method_choice(ui: &mut Ui, label: &str, direct: &mut Direct) {
    ComboBox::from_label(label).selected_text(method_name(*direct)).show_ui(ui, |ui| {
        for method in Shadows::ALL.map(Direct::By).into_iter().chain([Direct::Sampled]) {
            ui.selectable_value(direct, method, method_name(method));
        }
    });
}

/// A method's name, as on the command line.
pub(super) fn method_name(direct: Direct) -> &'static str {
    match direct {
        Direct::By(method) => method.name(),
        Direct::Sampled => "reference",
    }
}

/// Tells how to see a model whose size changed since the view was chosen.
fn size_hint(editor: &mut Editor, ui: &mut Ui) {
    ui.horizontal(|ui| {
        ui.label("The model's size changed.");
        let mut button = egui::Button::new(Command::FrameAll.name());
        if let Some(shortcut) = Command::FrameAll.shortcut() {
            button = button.shortcut_text(ui.ctx().format_shortcut(&shortcut));
        }
        if ui.add(button).clicked() {
            editor.viewport.frame_all();
        }
    });
}

/// The selected expression and those around it: each can be chosen.
fn selection_chain(editor: &mut Editor, ui: &mut Ui) {
    let Some(selection) = editor.viewport.selection.clone() else { return };
    let mut chosen = None;
    ui.horizontal_wrapped(|ui| {
        for (index, origin) in selection.chain.iter().enumerate().take(8) {
            if index > 0 {
                ui.weak("in");
            }
            if ui.selectable_label(index == selection.at, &origin.what).clicked() {
                chosen = Some(index);
            }
        }
        if selection.solids.len() > 1 {
            ui.weak(format!("{} times", selection.solids.len()));
        }
    });
    if let Some(obstacle) = handles::obstacle(editor) {
        ui.weak(format!("no handles here: {obstacle}"));
    }
    if let Some(index) = chosen {
        editor.select(selection.chain, index);
    }
}
