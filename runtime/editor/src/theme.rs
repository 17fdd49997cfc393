//! How the window looks: quiet greys about the picture, one accent, round corners.

use egui::style::{Selection, WidgetVisuals};
use egui::{
    Color32, Context, CornerRadius, FontFamily, FontId, Margin, RichText, Shadow, Stroke, Style, TextStyle, Theme,
    Visuals,
};

/// The corners of buttons and of windows, in points.
const CORNER: CornerRadius = CornerRadius::same(5);
const WINDOW_CORNER: CornerRadius = CornerRadius::same(9);

/// The colours of one theme.
struct Palette {
    /// Behind everything.
    panel: Color32,
    /// Windows and menus.
    window: Color32,
    /// Where one writes.
    field: Color32,
    /// What can be pressed, as it lies there, under the pointer, and pressed.
    button: [Color32; 3],
    line: Color32,
    /// About what can be pressed.
    edge: Color32,
    text: Color32,
    strong: Color32,
    weak: Color32,
    accent: Color32,
    selection: Color32,
    error: Color32,
    warning: Color32,
    shadow: u8,
}

const LIGHT: Palette = Palette {
    panel: Color32::from_rgb(246, 246, 244),
    window: Color32::from_rgb(252, 252, 251),
    field: Color32::from_rgb(255, 255, 255),
    button: [Color32::from_rgb(232, 232, 229), Color32::from_rgb(222, 223, 221), Color32::from_rgb(206, 209, 210)],
    line: Color32::from_rgb(218, 218, 214),
    edge: Color32::from_rgb(206, 206, 202),
    text: Color32::from_rgb(52, 54, 58),
    strong: Color32::from_rgb(16, 18, 22),
    weak: Color32::from_rgb(104, 107, 112),
    accent: Color32::from_rgb(24, 98, 160),
    selection: Color32::from_rgb(196, 220, 240),
    error: Color32::from_rgb(184, 44, 36),
    warning: Color32::from_rgb(150, 96, 0),
    shadow: 40,
};

const DARK: Palette = Palette {
    panel: Color32::from_rgb(31, 33, 36),
    window: Color32::from_rgb(38, 40, 44),
    field: Color32::from_rgb(23, 24, 27),
    button: [Color32::from_rgb(50, 53, 58), Color32::from_rgb(62, 66, 72), Color32::from_rgb(76, 81, 88)],
    line: Color32::from_rgb(54, 57, 62),
    edge: Color32::from_rgb(66, 70, 76),
    text: Color32::from_rgb(206, 208, 211),
    strong: Color32::from_rgb(244, 245, 246),
    weak: Color32::from_rgb(148, 152, 158),
    accent: Color32::from_rgb(110, 180, 234),
    selection: Color32::from_rgb(36, 74, 108),
    error: Color32::from_rgb(240, 116, 100),
    warning: Color32::from_rgb(230, 176, 84),
    shadow: 120,
};

/// Gives both themes their look, with text of that size in points.
pub(crate) fn apply(context: &Context, text_size: f32) {
    for (theme, palette) in [(Theme::Light, &LIGHT), (Theme::Dark, &DARK)] {
        context.style_mut_of(theme, |style| {
            space(style);
            write(style, text_size);
            style.visuals = visuals(theme, palette);
        });
    }
}

/// A sign as a button's face. The proportional font has none.
pub(crate) fn sign(sign: &str) -> RichText {
    RichText::new(sign).monospace()
}

fn space(style: &mut Style) {
    let spacing = &mut style.spacing;
    spacing.item_spacing = egui::vec2(7.0, 5.0);
    spacing.button_padding = egui::vec2(8.0, 3.0);
    spacing.menu_margin = Margin::same(6);
    spacing.window_margin = Margin::same(14);
    spacing.interact_size.y = 22.0;
    spacing.indent = 16.0;
    spacing.slider_width = 120.0;
    spacing.combo_width = 90.0;
    spacing.scroll = egui::style::ScrollStyle::thin();
}

fn write(style: &mut Style, text_size: f32) {
    // The panels' text follows the size of the program's, from afar.
    let body = (13.0 + 0.4 * (text_size - 14.0)).clamp(10.0, 22.0);
    let font = |size: f32| FontId::new(size, FontFamily::Proportional);
    style.text_styles = [
        (TextStyle::Small, font(body - 2.5)),
        (TextStyle::Body, font(body)),
        (TextStyle::Button, font(body)),
        (TextStyle::Heading, font(body + 5.0)),
        (TextStyle::Monospace, FontId::new(body - 0.5, FontFamily::Monospace)),
    ]
    .into();
}

fn visuals(theme: Theme, palette: &Palette) -> Visuals {
    let mut visuals = theme.default_visuals();
    visuals.panel_fill = palette.panel;
    visuals.window_fill = palette.window;
    visuals.window_stroke = Stroke::new(1.0, palette.line);
    visuals.window_corner_radius = WINDOW_CORNER;
    visuals.menu_corner_radius = WINDOW_CORNER;
    visuals.extreme_bg_color = palette.field;
    visuals.code_bg_color = palette.button[0];
    visuals.faint_bg_color = palette.panel.lerp_to_gamma(palette.button[0], 0.5);
    visuals.weak_text_color = Some(palette.weak);
    visuals.hyperlink_color = palette.accent;
    visuals.error_fg_color = palette.error;
    visuals.warn_fg_color = palette.warning;
    visuals.selection = Selection { bg_fill: palette.selection, stroke: Stroke::new(1.0, palette.strong) };
    visuals.slider_trailing_fill = true;
    visuals.indent_has_left_vline = false;
    let shadow = Shadow { offset: [0, 4], blur: 18, spread: 0, color: Color32::from_black_alpha(palette.shadow) };
    (visuals.window_shadow, visuals.popup_shadow) = (shadow, shadow);

    let widget = |fill: Color32, line: Color32, text: Color32| WidgetVisuals {
        bg_fill: fill,
        weak_bg_fill: fill,
        bg_stroke: Stroke::new(1.0, line),
        corner_radius: CORNER,
        fg_stroke: Stroke::new(1.0, text),
        expansion: 0.0,
    };
    let widgets = &mut visuals.widgets;
    widgets.noninteractive = widget(palette.panel, palette.line, palette.text);
    widgets.inactive = widget(palette.button[0], palette.edge, palette.text);
    widgets.hovered = widget(palette.button[1], palette.line, palette.strong);
    widgets.active = widget(palette.button[2], palette.accent, palette.strong);
    widgets.open = widget(palette.button[1], palette.line, palette.strong);
    visuals
}
