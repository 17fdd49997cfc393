//! Comparing shadow methods with the truth: metrics, and the report.

pub(crate) mod metrics;
pub(crate) mod report;
pub(crate) mod ssim;

use metrics::Score;

/// What the methods came to for one light of one scene.
#[derive(Debug)]
pub(crate) struct Case {
    /// The scene, the light and its size.
    pub(crate) name: String,
    pub(crate) size: (u32, u32),
    /// Which pixels see a surface.
    pub(crate) mask: Vec<bool>,
    /// The true V, 1 where there is no surface.
    pub(crate) truth: Vec<f32>,
    /// What V is multiplied by in the shaded picture, from 0 to 1.
    pub(crate) shade: Vec<f32>,
    /// Half the truth's confidence interval, and how many rays each pixel drew for it.
    pub(crate) half_width: f64,
    pub(crate) samples: u32,
    pub(crate) entries: Vec<Entry>,
}

/// What one method came to.
#[derive(Debug)]
pub(crate) struct Entry {
    /// The method's name, with the number of its cells or rays.
    pub(crate) method: String,
    pub(crate) visible: Vec<f32>,
    /// The map of local SSIM of V.
    pub(crate) map: Vec<f32>,
    pub(crate) score: Score,
}
