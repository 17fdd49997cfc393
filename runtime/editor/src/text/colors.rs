//! The colours of the text.

use chiaro_assist::Kind;
use chiaro_compiler::syntax::Severity;
use egui::Color32;

/// The colour of a kind of word, before a dark or a light page.
pub(super) fn of_kind(kind: Kind, is_dark: bool) -> Color32 {
    let (dark, light) = match kind {
        Kind::Keyword => (0xc8_92_ea, 0x8a_2f_b0),
        Kind::BuiltInModule => (0x82_aa_ff, 0x1f_4f_bf),
        Kind::BuiltInFunction => (0x6f_cb_d6, 0x0b_68_76),
        Kind::Module => (0xa9_c7_ff, 0x2b_5f_c0),
        Kind::Function => (0x9b_e0_c5, 0x1a_70_4f),
        Kind::Parameter => (0xf0_b9_8d, 0x8c_43_10),
        Kind::Variable => (0xd6_d9_df, 0x24_29_2f),
        Kind::SpecialVariable => (0xf2_d4_7c, 0x7d_5c_00),
        Kind::Number => (0xf2_9e_74, 0xb0_38_18),
        Kind::String => (0xb5_d3_83, 0x3a_74_14),
        Kind::Comment => (0x92_9c_aa, 0x62_6a_74),
        Kind::Operator => (0xa4_b8_cc, 0x48_58_68),
        Kind::Punctuation => (0xa4_aa_b4, 0x55_5d_66),
        Kind::Modifier => (0xff_7a_b2, 0xbf_17_5a),
        Kind::Error => (0xff_70_66, 0xbe_24_20),
    };
    rgb(if is_dark { dark } else { light })
}

/// The colour of a message's squiggle and mark.
pub(super) fn of_severity(severity: Severity, is_dark: bool) -> Color32 {
    let (dark, light) = match severity {
        Severity::Error => (0xf0_5a_4e, 0xd0_2c_24),
        Severity::Warning => (0xe8_a8_3c, 0xb8_72_00),
        Severity::Note => (0x5a_a2_e8, 0x1f_6f_c8),
    };
    rgb(if is_dark { dark } else { light })
}

/// Behind what is marked, the weakest first.
#[derive(Clone, Copy)]
pub(super) enum Mark {
    /// The line of the caret.
    Line,
    /// The expression that is selected in the picture.
    Solid,
    /// Another place of the name at the caret.
    Reference,
    /// A hit of the search.
    Hit,
    /// The selection, while the text is not being written.
    Selection,
    /// A pair of brackets.
    Bracket,
    /// A number that can be dragged.
    Number,
    /// What was asked for from elsewhere: a frame about it.
    Flash,
}

impl Mark {
    pub(super) fn color(self, is_dark: bool) -> Color32 {
        let light = |alpha: u8| Color32::from_white_alpha(alpha);
        let dark = |alpha: u8| Color32::from_black_alpha(alpha);
        let tint = |color: u32, alpha: u8| rgb(color).gamma_multiply_u8(alpha);
        match (self, is_dark) {
            (Self::Line, true) => light(9),
            (Self::Line, false) => dark(9),
            (Self::Solid, true) => tint(0xff_a0_30, 42),
            (Self::Solid, false) => tint(0xff_98_10, 56),
            (Self::Reference, true) => tint(0x90_a8_d0, 64),
            (Self::Reference, false) => tint(0x50_70_b0, 48),
            (Self::Hit, true) => tint(0xd8_b0_20, 60),
            (Self::Hit, false) => tint(0xff_d0_20, 130),
            (Self::Selection, true) => tint(0x70_98_c8, 40),
            (Self::Selection, false) => tint(0x70_98_c8, 70),
            (Self::Bracket, true) => tint(0x90_c0_ff, 56),
            (Self::Bracket, false) => tint(0x40_80_d0, 70),
            (Self::Number, true) => tint(0xf2_9e_74, 70),
            (Self::Number, false) => tint(0xe0_70_40, 60),
            (Self::Flash, true) => rgb(0xff_c8_50),
            (Self::Flash, false) => rgb(0xe0_90_00),
        }
    }
}

fn rgb(code: u32) -> Color32 {
    let [_, red, green, blue] = code.to_be_bytes();
    Color32::from_rgb(red, green, blue)
}

#[cfg(test)]
mod tests {
    use super::*;

    const KINDS: [Kind; 15] = [
        Kind::Keyword,
        Kind::BuiltInModule,
        Kind::BuiltInFunction,
        Kind::Module,
        Kind::Function,
        Kind::Parameter,
        Kind::Variable,
        Kind::SpecialVariable,
        Kind::Number,
        Kind::String,
        Kind::Comment,
        Kind::Operator,
        Kind::Punctuation,
        Kind::Modifier,
        Kind::Error,
    ];

    /// What WCAG asks of what is large or bold, and of signs: less is hard to read.
    const LEAST_CONTRAST: f32 = 3.0;

    /// WCAG's contrast of two opaque colours.
    fn contrast(a: Color32, b: Color32) -> f32 {
        let luminance = |color: Color32| {
            let [red, green, blue, _] = egui::Rgba::from(color).to_array();
            0.2126 * red + 0.7152 * green + 0.0722 * blue
        };
        let (a, b) = (luminance(a), luminance(b));
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    }

    #[test]
    fn words_can_be_read_on_every_mark() {
        let context = egui::Context::default();
        crate::theme::apply(&context, 14.0);
        for theme in [egui::Theme::Dark, egui::Theme::Light] {
            let (is_dark, style) = (theme == egui::Theme::Dark, context.style_of(theme));
            let page = style.visuals.panel_fill;
            let behind = |marks: &[Mark]| marks.iter().fold(page, |page, mark| page.blend(mark.color(is_dark)));
            use Mark::{Bracket, Hit, Line, Number, Reference, Selection, Solid};
            let marks: [&[Mark]; 7] = [
                &[Line],
                &[Line, Solid],
                &[Line, Reference],
                &[Line, Hit],
                &[Line, Solid, Selection],
                &[Line, Bracket],
                &[Line, Number],
            ];
            let backgrounds = marks.into_iter().map(behind).chain([style.visuals.selection.bg_fill]);
            for background in backgrounds {
                for kind in KINDS {
                    let contrast = contrast(of_kind(kind, is_dark), background);
                    assert!(contrast >= LEAST_CONTRAST, "{kind:?} on {background:?}, {theme:?}: {contrast}");
                }
            }
        }
    }
}
