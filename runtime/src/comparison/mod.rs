//! Comparing shadow methods with the truth: metrics, and the report.

pub(crate) mod metrics;
mod page;
pub(crate) mod pictures;
mod plot;
mod published;
pub(crate) mod report;
pub(crate) mod ssim;
pub(crate) mod suite;

use metrics::Score;

/// Cases that have a mean of their own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Group {
    /// The suite's solids that are exact distances, under balls.
    Basic,
    /// The suite's thin sheets, many edges, and fields that are mere bounds, under balls.
    Hard,
    /// The suite under rectangles.
    Rectangles,
    /// Scenes of the user's.
    Own,
}

impl Group {
    pub(crate) const ALL: [Self; 4] = [Self::Basic, Self::Hard, Self::Rectangles, Self::Own];

    pub(crate) fn title(self) -> &'static str {
        match self {
            Self::Basic => "primitives, temple, fence with card and ring, row",
            Self::Hard => "thin card, pickets, gear, blend, bounds",
            Self::Rectangles => "primitives, temple, fence under rectangles",
            Self::Own => "scenes that were named",
        }
    }
}

/// What the methods came to for one light of one scene.
#[derive(Debug)]
pub(crate) struct Case {
    /// The scene, the light and its size.
    pub(crate) name: String,
    pub(crate) scene: String,
    pub(crate) group: Group,
    pub(crate) size: (u32, u32),
    /// Half the truth's confidence interval, and how many rays it took of pixels near penumbrae, and on average.
    pub(crate) half_width: f64,
    pub(crate) samples: u32,
    pub(crate) mean_samples: f64,
    pub(crate) entries: Vec<Entry>,
}

/// What one method came to.
#[derive(Debug)]
pub(crate) struct Entry {
    /// The method's name, with the number of its cells or rays.
    pub(crate) method: String,
    pub(crate) score: Score,
}
