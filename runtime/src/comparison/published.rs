//! What Bán, Bálint, Valasek, "Area Lights in Signed Distance Function Scenes" (2019) measured for their figure 4, at
//! 1920 × 1080 on a GeForce 1070 Ti.

/// A picture of the figure.
pub(crate) struct Published {
    /// The letter of the picture, and what it shows.
    pub(crate) picture: &'static str,
    pub(crate) what: &'static str,
    /// Whether it is lit by a rectangle instead of a ball.
    pub(crate) is_rectangle: bool,
    /// The method that stands for it here.
    pub(crate) method: &'static str,
    /// Mean and standard deviation of the shaded picture's SSIM.
    pub(crate) shaded: Option<(f64, f64)>,
    pub(crate) milliseconds: f64,
}

pub(crate) const FIGURE4: [Published; 8] = [
    ball("a", "Quilez 2010 as improved by Aaltonen 2018", "aaltonen", Some((0.9862, 0.0891)), 1.32),
    ball("b", "fast method, section 4.1: as printed", "minimal-cone-printed", Some((0.9968, 0.0375)), 1.57),
    ball("b", "fast method, section 4.1: as resolved", "minimal-cone", Some((0.9968, 0.0375)), 1.57),
    ball("c", "Monte Carlo of V, 100 rays", "monte-carlo 100", None, 36.4),
    rectangle("h", "section 4.2, 35 rays", "proxy 35", 9.41),
    rectangle("j", "section 4.2, 100 rays", "proxy 100", 24.3),
    rectangle("i", "full Monte Carlo, 35 rays", "monte-carlo 35", 24.3),
    rectangle("d", "full Monte Carlo, 100 rays", "monte-carlo 100", 52.7),
];

const fn ball(
    picture: &'static str,
    what: &'static str,
    method: &'static str,
    shaded: Option<(f64, f64)>,
    milliseconds: f64,
) -> Published {
    Published { picture, what, is_rectangle: false, method, shaded, milliseconds }
}

const fn rectangle(picture: &'static str, what: &'static str, method: &'static str, milliseconds: f64) -> Published {
    Published { picture, what, is_rectangle: true, method, shaded: None, milliseconds }
}
