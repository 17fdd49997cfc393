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
        Kind::Comment => (0x80_8a_9a, 0x66_6e_78),
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
    /// What was asked for from elsewhere.
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
            (Self::Solid, true) => tint(0xff_a0_30, 44),
            (Self::Solid, false) => tint(0xff_98_10, 56),
            (Self::Reference, true) => tint(0x90_a8_d0, 64),
            (Self::Reference, false) => tint(0x50_70_b0, 48),
            (Self::Hit, true) => tint(0xd8_b0_20, 90),
            (Self::Hit, false) => tint(0xff_d0_20, 130),
            (Self::Selection, true) => tint(0x70_98_c8, 70),
            (Self::Selection, false) => tint(0x70_98_c8, 70),
            (Self::Bracket, true) => tint(0x90_c0_ff, 80),
            (Self::Bracket, false) => tint(0x40_80_d0, 70),
            (Self::Number, true) => tint(0xf2_9e_74, 70),
            (Self::Number, false) => tint(0xe0_70_40, 60),
            (Self::Flash, true) => tint(0xff_e0_80, 120),
            (Self::Flash, false) => tint(0xff_c0_20, 140),
        }
    }
}

fn rgb(code: u32) -> Color32 {
    let [_, red, green, blue] = code.to_be_bytes();
    Color32::from_rgb(red, green, blue)
}
