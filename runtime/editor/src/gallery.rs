//! What an empty window shows: examples, and the files of the last times.

use std::path::PathBuf;

use egui::{Align2, Color32, ColorImage, Rect, RichText, ScrollArea, Sense, TextStyle, TextureHandle, Ui, vec2};

use crate::app::Editor;
use crate::command::Command;

/// A scene that comes with the editor.
pub(crate) struct Example {
    /// Its file's name without an ending.
    pub(crate) name: &'static str,
    pub(crate) text: &'static str,
    /// A small picture of it, as PNG.
    picture: &'static [u8],
}

macro_rules! examples {
    ($($name:literal),* $(,)?) => {
        &[$(Example {
            name: $name,
            text: include_str!(concat!("../../../examples_csg/", $name, ".csg")),
            picture: include_bytes!(concat!("../gallery/", $name, ".png")),
        }),*]
    };
}

/// The examples, the simplest first.
pub(crate) const EXAMPLES: &[Example] = examples![
    "hello_sphere",
    "hello_fillet",
    "joints",
    "mug",
    "snowman",
    "die",
    "brick",
    "bracket",
    "bolt",
    "lamp",
    "still_life",
    "gear",
    "clock",
    "piston",
    "chain",
    "ring",
    "pawn",
    "molecule",
    "twisted_vase",
    "shell_box",
    "gyroid_ball",
    "temple",
    "spiral_stairs",
    "tree",
    "menger",
    "city",
    "badge",
];

/// The size of a picture, in points.
const PICTURE: egui::Vec2 = vec2(168.0, 126.0);

/// The pictures that were shown already.
#[derive(Default)]
pub(crate) struct Gallery {
    pictures: Vec<Option<TextureHandle>>,
    /// The user wants to write a scene of their own.
    pub(crate) is_left: bool,
}

impl Example {
    /// What its first line says, in a word or two.
    pub(crate) fn title(&self) -> String {
        let words = self.name.replace('_', " ");
        let mut letters = words.chars();
        letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
    }

    /// Its first comment.
    pub(crate) fn description(&self) -> &'static str {
        self.text.lines().next().map_or("", |line| line.trim_start_matches('/').trim())
    }
}

/// Whether there is nothing else to show.
pub(crate) fn is_wanted(editor: &Editor) -> bool {
    editor.session.is_blank() && !editor.gallery.is_left && !editor.only_picture
}

/// Shows the examples, to be opened by a click.
pub(crate) fn show(editor: &mut Editor, ui: &mut Ui) {
    ui.painter().rect_filled(ui.max_rect(), 0.0, ui.visuals().panel_fill);
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        egui::Frame::NONE.inner_margin(24.0).show(ui, |ui| {
            ui.heading("Begin with a scene");
            ui.add_space(6.0);
            ui.horizontal_wrapped(|ui| {
                if ui.button("New scene").clicked() {
                    editor.gallery.is_left = true;
                    editor.text.wants_focus = true;
                }
                if ui.button("Open…").clicked() {
                    Command::Open.run(editor, ui.ctx());
                }
                ui.weak("or drop a file here");
            });
            recent(editor, ui);
            ui.add_space(14.0);
            ui.strong("Examples");
            ui.add_space(6.0);
            ui.horizontal_wrapped(|ui| {
                ui.spacing_mut().item_spacing = vec2(12.0, 12.0);
                for index in 0..EXAMPLES.len() {
                    card(editor, ui, index);
                }
            });
        });
    });
}

fn recent(editor: &mut Editor, ui: &mut Ui) {
    let recent: Vec<PathBuf> = editor.settings.recent.iter().filter(|path| path.exists()).take(6).cloned().collect();
    if recent.is_empty() {
        return;
    }
    ui.add_space(14.0);
    ui.strong("Recent files");
    for path in recent {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let folder = path.parent().map_or(String::new(), |folder| folder.display().to_string());
        ui.horizontal(|ui| {
            if ui.link(name).clicked() {
                editor.open(&path);
            }
            ui.label(RichText::new(folder).weak().small());
        });
    }
}

fn card(editor: &mut Editor, ui: &mut Ui, index: usize) {
    let example = &EXAMPLES[index];
    let size = PICTURE + vec2(0.0, 24.0);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, example.title()));
    if ui.is_rect_visible(rect) {
        let visuals = *ui.style().interact(&response);
        ui.painter().rect(rect, 8.0, visuals.weak_bg_fill, visuals.bg_stroke, egui::StrokeKind::Inside);
        let image = Rect::from_min_size(rect.min, PICTURE);
        if let Some(texture) = editor.gallery.picture(ui, index) {
            let corners = egui::CornerRadius { nw: 8, ne: 8, sw: 0, se: 0 };
            egui::Image::new((texture.id(), PICTURE)).corner_radius(corners).paint_at(ui, image.shrink(1.0));
        }
        let at = egui::pos2(rect.center().x, 0.5 * (image.max.y + rect.max.y));
        let font = TextStyle::Body.resolve(ui.style());
        ui.painter().text(at, Align2::CENTER_CENTER, example.title(), font, visuals.text_color());
    }
    let response = response.on_hover_text(example.description()).on_hover_cursor(egui::CursorIcon::PointingHand);
    if response.clicked() {
        editor.open_example(example);
    }
}

impl Editor {
    /// Opens a copy of an example, which is the user's to change.
    pub(crate) fn open_example(&mut self, example: &Example) {
        self.session.open_text(&format!("{}.csg", example.name), example.text.to_owned());
        self.text.wants_focus = true;
    }
}

impl Gallery {
    fn picture(&mut self, ui: &Ui, index: usize) -> Option<&TextureHandle> {
        self.pictures.resize(EXAMPLES.len(), None);
        let place = &mut self.pictures[index];
        if place.is_none() {
            let image = decoded(EXAMPLES[index].picture)?;
            *place = Some(ui.ctx().load_texture(EXAMPLES[index].name, image, egui::TextureOptions::LINEAR));
        }
        place.as_ref()
    }
}

fn decoded(png: &[u8]) -> Option<ColorImage> {
    let image = image::load_from_memory(png).ok()?.into_rgba8();
    let size = [image.width() as usize, image.height() as usize];
    Some(ColorImage::new(size, image.pixels().map(|pixel| Color32::from_rgb(pixel[0], pixel[1], pixel[2])).collect()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_example_is_in_the_gallery_with_its_picture() {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples_csg");
        for entry in std::fs::read_dir(folder).unwrap().flatten() {
            let path = entry.path();
            if path.extension().is_some_and(|ending| ending == "csg") {
                let name = path.file_stem().unwrap().to_string_lossy().into_owned();
                assert!(EXAMPLES.iter().any(|example| example.name == name), "{name} is missing");
            }
        }
        for example in EXAMPLES {
            assert!(decoded(example.picture).is_some_and(|image| image.size == [224, 168]), "{}", example.name);
            assert!(!example.description().is_empty(), "{}", example.name);
        }
    }
}
