//! The picture, and how one looks at it.

pub(crate) mod follow;
mod handles;
mod legend;
mod navigation;
mod outline;
mod overlay;
mod picking;
mod selection;
mod sight;
mod wipe;

pub(crate) use overlay::{frame_selection, looks, views};
pub(crate) use selection::Selection;

use std::time::Duration;

use chiaro_compiler::Scene;
use chiaro_compiler::shader::Shadows;
use chiaro_render::{Direct, Plane, View};
use egui::{Align2, Color32, ColorImage, Rect, Sense, TextureHandle, TextureOptions, Ui, Vec2, pos2};

use crate::app::Editor;
use crate::document::DocumentId;
use crate::status;
use crate::studio::{Eye, Frame, Look, Outlined, Timings, Wanted};

/// The largest picture, in pixels: more would only be slow.
const MOST_PIXELS: f32 = 2.0e6;
/// So long the picture of one text may stand for that of another.
const SOON: Duration = Duration::from_millis(300);
/// How much of it is seen from then on.
const VEIL: f32 = 0.8;
/// The part of a picture that a texture shows: all of it.
const WHOLE: Rect = Rect { min: pos2(0.0, 0.0), max: pos2(1.0, 1.0) };

/// What is known about the picture in the window.
pub(crate) struct Viewport {
    texture: Option<TextureHandle>,
    other: Option<TextureHandle>,
    outline: Option<TextureHandle>,
    /// What the outline is of.
    outlined: Option<Outlined>,
    /// What `#` highlights, over the picture.
    highlight: Option<TextureHandle>,
    legend: Option<chiaro_render::Legend>,
    /// Which text the view is of.
    document: Option<DocumentId>,
    pub(crate) eye: Eye,
    /// What the picture in the window shows; none, if it is that of another text.
    seen: Option<sight::Seen>,
    stance: follow::Stance,
    pub(crate) timings: Timings,
    /// How the texts are looked at that were drawn before this one.
    put_by: Vec<sight::Sight>,
    /// Where the picture is in the window.
    rect: Option<Rect>,
    pub(crate) look: Look,
    /// The plane of the last section.
    plane: Option<Plane>,
    pub(crate) direct: Direct,
    /// The method on the other side of the divider, and where that is as a part of the width.
    pub(crate) compared: Option<(Direct, f32)>,
    pub(crate) floor: bool,
    /// In stops.
    pub(crate) exposure: f32,
    /// Whether drags turn the head instead of the scene, and keys move the eye.
    pub(crate) flies: bool,
    is_moving: bool,
    pub(crate) selection: Option<Selection>,
    /// The caret that the selection was made for, with the scene's revision.
    followed: Option<((DocumentId, usize, usize), u64)>,
    handle: Option<handles::Drag>,
}

impl Default for Viewport {
    fn default() -> Self {
        Self {
            texture: None,
            other: None,
            outline: None,
            outlined: None,
            highlight: None,
            legend: None,
            document: None,
            eye: Eye::Scene,
            seen: None,
            stance: follow::Stance::default(),
            timings: Timings::default(),
            put_by: Vec::new(),
            rect: None,
            look: Look::Lit,
            plane: None,
            direct: Direct::By(Shadows::Verified),
            compared: None,
            floor: true,
            exposure: 0.0,
            flies: false,
            is_moving: false,
            selection: None,
            followed: None,
            handle: None,
        }
    }
}

impl Viewport {
    /// From where the picture in the window is seen; none, if it is that of another text.
    pub(crate) fn drawn(&self) -> Option<View> {
        self.seen.as_ref().map(|seen| seen.view)
    }

    /// The samples of the picture in the window.
    pub(crate) fn samples(&self) -> u32 {
        self.seen.as_ref().map_or(0, |seen| seen.samples)
    }

    /// Looks so that all of the scene is seen, turned this way in OpenSCAD's degrees.
    pub(crate) fn frame_from(&mut self, rotation: [f64; 3]) {
        self.eye = Eye::Framed(rotation, self.field_of_view());
    }

    /// Looks so that all of the scene is seen, turned as it is.
    pub(crate) fn frame_all(&mut self) {
        match self.drawn() {
            Some(view) => self.frame_from(view.rotation),
            None => self.eye = Eye::Scene,
        }
    }

    fn field_of_view(&self) -> f64 {
        self.drawn().map_or(navigation::PERSPECTIVE, |view| view.field_of_view)
    }

    /// Whether the outline in the picture is that of the selection.
    pub(crate) fn is_outlined(&self) -> bool {
        self.outlined.is_some() && self.outlined == self.selection.as_ref().map(Selection::outlined)
    }

    /// Shows a new picture.
    fn take(&mut self, ui: &Ui, frame: Frame, keeps_view: bool) {
        let image = |rgba: &[u8]| {
            let [width, height] = frame.size;
            ColorImage::from_rgba_unmultiplied([width as usize, height as usize], rgba)
        };
        let is_better = self.seen.as_ref().is_some_and(|seen| seen.is_better_than(&frame));
        if !is_better {
            if self.seen.is_none() {
                // What is there is another text's, who may want it back.
                self.texture = None;
            }
            put(&mut self.texture, ui, "picture", image(&frame.rgba));
            self.seen = Some(sight::Seen::of(&frame));
        }
        match &frame.other {
            Some(rgba) => put(&mut self.other, ui, "other picture", image(rgba)),
            None => self.other = None,
        }
        match &frame.mask {
            Some((_, mask)) => put(&mut self.outline, ui, "outline", outline::image(mask)),
            None => self.outline = None,
        }
        match &frame.highlight {
            Some(rgba) => put(&mut self.highlight, ui, "highlight", image(rgba)),
            None => self.highlight = None,
        }
        self.outlined = frame.mask.map(|(outlined, _)| outlined);
        (self.timings, self.legend) = (frame.timings, frame.legend);
        // While the text is edited the picture stands still, unless the scene has a camera of its own. (What was drawn for an
        // eye before this one says nothing.)
        if keeps_view && frame.wanted.eye == self.eye {
            self.eye = Eye::At(frame.view);
        }
    }
}

fn put(texture: &mut Option<TextureHandle>, ui: &Ui, name: &str, image: ColorImage) {
    match texture {
        Some(texture) => texture.set(image, TextureOptions::LINEAR),
        None => *texture = Some(ui.ctx().load_texture(name, image, TextureOptions::LINEAR)),
    }
}

/// Shows the picture and lets the user move it.
pub(crate) fn show(editor: &mut Editor, ui: &mut Ui) {
    let scene = editor.session.scene_document().id;
    if editor.viewport.document != Some(scene) {
        let documents = editor.session.documents();
        editor.viewport.turn_to(scene, |id| documents.iter().any(|document| document.id == id));
    }
    // (One of the text that was drawn before may come yet.)
    if let Some(frame) = editor.session.frame.take().filter(|frame| editor.session.is_of_scene(frame)) {
        // What begins empty is framed when there is something.
        let is_open =
            editor.viewport.eye == Eye::Scene && (has_camera(&frame.scene) || frame.scene.dimension().is_none());
        // A view that frames an older model says nothing about this one.
        let keeps_view = !is_open && !editor.session.is_outdated();
        editor.viewport.take(ui, *frame, keeps_view);
    }
    let (rect, response) = ui.allocate_exact_size(ui.available_size(), Sense::click_and_drag());
    editor.viewport.rect = Some(rect);
    selection::follow_caret(editor);
    let is_taken = handles::drag(editor, ui, &response) || wipe::drag(editor, ui, &response);
    if !is_taken {
        navigation::navigate(editor, ui, &response);
        picking::pick(editor, &response);
    }
    follow::follow(editor, ui);
    want(editor, ui, rect.size());
    paint(editor, ui, rect);
    overlay::show(editor, ui, rect);
}

/// Whether the scene says from where it is seen.
fn has_camera(scene: &Scene) -> bool {
    let camera = &scene.camera;
    camera.target.is_some() || camera.eye.is_some() || camera.rotation.is_some() || camera.distance.is_some()
}

/// Asks for the picture that fits.
fn want(editor: &mut Editor, ui: &Ui, size: Vec2) {
    let pixels = size * ui.ctx().pixels_per_point();
    let shrink = (MOST_PIXELS / (pixels.x * pixels.y).max(1.0)).sqrt().min(1.0);
    let size = [pixels.x, pixels.y].map(|edge| (edge * shrink).round().max(1.0) as u32);
    let viewport = &editor.viewport;
    let wanted = Wanted {
        size,
        eye: viewport.eye,
        values: Vec::new(),
        look: viewport.look,
        direct: viewport.direct,
        other: viewport.compared.map(|(direct, _)| direct).filter(|_| viewport.look == Look::Lit),
        floor: viewport.floor,
        exposure: viewport.exposure,
        // While there is no scene nothing need be drawn, though the one of another text may be there still.
        samples: if editor.session.shown.is_some() { editor.settings.samples } else { 0 },
        moving: viewport.is_moving || viewport.handle.is_some() || editor.clock.is_running(),
        outlined: viewport.selection.as_ref().map(Selection::outlined),
        highlighted: highlighted(editor),
    };
    editor.session.want(wanted);
}

/// What `#` highlights of the scene, once that is known. What isn't lit has colours of its own.
fn highlighted(editor: &Editor) -> Option<Outlined> {
    let provenance = editor.session.shown.as_ref()?.provenance.clone()?;
    let solids = provenance.highlighted().to_vec();
    (editor.viewport.look == Look::Lit && !solids.is_empty()).then_some(Outlined { provenance, solids })
}

fn paint(editor: &Editor, ui: &Ui, rect: Rect) {
    let (viewport, painter) = (&editor.viewport, ui.painter_at(rect));
    painter.rect_filled(rect, 0.0, ui.visuals().extreme_bg_color);
    // A scene with errors that never showed has no picture, whatever was drawn before.
    let has_picture = viewport.seen.is_some() || !editor.session.has_errors();
    let Some(texture) = viewport.texture.as_ref().filter(|_| has_picture) else {
        return tell(ui, &painter, rect, nothing_yet(editor, ui));
    };
    painter.image(texture.id(), rect, WHOLE, Color32::WHITE);
    if viewport.seen.is_none() {
        // What is seen is another text's: that has to be told as soon as somebody could wonder.
        if editor.session.waits_since().is_some_and(|since| since > SOON) {
            painter.rect_filled(rect, 0.0, ui.visuals().extreme_bg_color.gamma_multiply(VEIL));
            tell(ui, &painter, rect, nothing_yet(editor, ui));
        }
        return;
    }
    if let (Some(other), Some((_, part))) = (&viewport.other, viewport.compared) {
        wipe::paint(editor, &painter, rect, other, part);
    }
    if let Some(highlight) = &viewport.highlight {
        painter.image(highlight.id(), rect, WHOLE, Color32::WHITE);
    }
    if let Some(outline) = viewport.outline.as_ref().filter(|_| viewport.is_outlined()) {
        painter.image(outline.id(), rect, WHOLE, Color32::WHITE);
    }
    handles::paint(editor, ui, &painter);
}

/// Why there is no picture of the scene.
fn nothing_yet(editor: &Editor, ui: &Ui) -> String {
    match &editor.session.trouble {
        Some(trouble) => trouble.clone(),
        None if editor.session.has_errors() => "There is nothing to draw before the errors are mended.".to_owned(),
        None => status::under_way(editor, ui).unwrap_or_else(|| "drawing…".to_owned()),
    }
}

/// Writes something into the middle of the picture.
fn tell(ui: &Ui, painter: &egui::Painter, rect: Rect, what: String) {
    let font = egui::TextStyle::Body.resolve(ui.style());
    let galley = painter.layout(what, font, ui.visuals().weak_text_color(), (rect.width() - 48.0).max(0.0));
    painter.galley(Align2::CENTER_CENTER.anchor_size(rect.center(), galley.size()).min, galley, Color32::WHITE);
}

#[cfg(test)]
impl Viewport {
    /// Whether something is highlighted in the picture.
    pub(crate) fn is_highlighted(&self) -> bool {
        self.highlight.is_some()
    }

    /// Where the picture is in the window.
    pub(crate) fn place(&self) -> Rect {
        self.rect.unwrap_or(Rect::NOTHING)
    }

    /// Whether a hint tells that the model's size changed.
    pub(crate) fn is_off(&self) -> bool {
        self.stance.is_off
    }

    /// Whether the picture in the window is the one that is wanted, and stays that.
    pub(crate) fn is_settled(&self, wanted: &Wanted) -> bool {
        self.stance.is_settled() && self.seen.as_ref().is_some_and(|seen| seen.is_wanted(wanted))
    }

    /// Where a point of the scene is seen in the window.
    pub(crate) fn seen(&self, point: [f64; 3]) -> Option<egui::Pos2> {
        let rect = self.rect?;
        let ([x, y], _) = self.drawn()?.project(point, [rect.width() as u32, rect.height() as u32])?;
        Some(rect.min + egui::vec2(x as f32, y as f32))
    }

    /// The selection's handles: name, number or why there is none, and place.
    pub(crate) fn handles(&self, editor: &Editor) -> Vec<(String, Result<f64, String>, [f64; 3])> {
        handles::described(editor)
    }
}
