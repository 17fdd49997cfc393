//! The picture, and how one looks at it.

mod navigation;

use chiaro_render::View;
use egui::{Color32, ColorImage, Rect, Sense, TextureHandle, TextureOptions, Ui, Vec2, pos2};

use crate::app::Editor;
use crate::studio::{Frame, Timings, Wanted};

/// The largest picture, in pixels: more would only be slow.
const MOST_PIXELS: f32 = 2.0e6;

/// What is known about the picture in the window.
#[derive(Default)]
pub(crate) struct Viewport {
    texture: Option<TextureHandle>,
    other: Option<TextureHandle>,
    /// From where the user looks; none, where the scene says it.
    pub(crate) view: Option<View>,
    /// From where the picture in the window is seen.
    pub(crate) drawn: Option<View>,
    pub(crate) samples: u32,
    pub(crate) timings: Timings,
    /// Where the picture is in the window.
    pub(crate) rect: Option<Rect>,
    /// The divider between two light algorithms, as a part of the width.
    pub(crate) wipe: Option<f32>,
    pub(crate) is_moving: bool,
}

impl Viewport {
    /// Shows a new picture.
    fn take(&mut self, ui: &Ui, frame: &Frame) {
        let image = |rgba: &[u8]| {
            let [width, height] = frame.size;
            ColorImage::from_rgba_unmultiplied([width as usize, height as usize], rgba)
        };
        put(&mut self.texture, ui, "picture", image(&frame.rgba));
        match &frame.other {
            Some(rgba) => put(&mut self.other, ui, "other picture", image(rgba)),
            None => self.other = None,
        }
        self.drawn = Some(frame.view);
        self.samples = frame.samples;
        self.timings = frame.timings;
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
    if let Some(frame) = editor.session.frame.take() {
        editor.viewport.take(ui, &frame);
    }
    let (rect, response) = ui.allocate_exact_size(ui.available_size(), Sense::click_and_drag());
    editor.viewport.rect = Some(rect);
    navigation::navigate(editor, ui, &response);
    want(editor, ui, rect.size());

    let painter = ui.painter_at(rect);
    let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
    if let Some(texture) = &editor.viewport.texture {
        painter.image(texture.id(), rect, whole, Color32::WHITE);
    }
}

/// Asks for the picture that fits.
fn want(editor: &mut Editor, ui: &Ui, size: Vec2) {
    let pixels = size * ui.ctx().pixels_per_point();
    let shrink = (MOST_PIXELS / (pixels.x * pixels.y).max(1.0)).sqrt().min(1.0);
    let size = [pixels.x, pixels.y].map(|edge| (edge * shrink).round().max(1.0) as u32);
    let wanted = Wanted {
        size,
        view: editor.viewport.view,
        samples: editor.settings.samples,
        moving: editor.viewport.is_moving || editor.clock.is_running(),
        ..editor.session.wanted().clone()
    };
    editor.session.want(wanted);
}
