//! The light suite, and what is compared on it.

use chiaro_compiler::shader::Shadows;

use super::Group;
use crate::arguments::MethodChoice;

/// The radii of the suite's balls, and by what its rectangles of 0.6 × 0.3 are scaled: the larger are 1.6 × 0.8.
pub(crate) const RADII: [f64; 3] = [0.15, 0.4, 0.9];
pub(crate) const RECTANGLE_SCALES: [f64; 2] = [1.0, 8.0 / 3.0];
/// The radius of the balls of `--figure4`, and the size of its pictures: the paper says no radius.
pub(crate) const FIGURE_RADIUS: f64 = 0.25;
pub(crate) const FIGURE_SIZE: (u32, u32) = (1920, 1080);

/// A scene of the suite.
pub(crate) struct SuiteScene {
    pub(crate) name: &'static str,
    pub(crate) text: &'static str,
    group: Group,
    /// Whether it has a rectangle to be lit by in place of its ball.
    has_rectangle: bool,
}

macro_rules! scene {
    ($name:literal, $group:expr, $has_rectangle:expr) => {
        SuiteScene {
            name: $name,
            text: include_str!(concat!("../../../examples_csg/light/", $name, ".csg")),
            group: $group,
            has_rectangle: $has_rectangle,
        }
    };
}

/// In the command, so that `--suite` works wherever it is.
pub(crate) const SUITE: [SuiteScene; 9] = [
    scene!("primitives", Group::Basic, true),
    scene!("temple", Group::Basic, true),
    scene!("fence", Group::Basic, true),
    scene!("row", Group::Basic, false),
    scene!("thin_card", Group::Hard, false),
    scene!("pickets", Group::Hard, false),
    scene!("gear", Group::Hard, false),
    scene!("blend", Group::Hard, false),
    scene!("bounds", Group::Hard, false),
];

impl SuiteScene {
    /// What it is lit by: its ball, and its rectangle if it has one.
    pub(crate) fn groups(&self) -> impl Iterator<Item = Group> {
        std::iter::once(self.group).chain(self.has_rectangle.then_some(Group::Rectangles))
    }
}

/// What a group is compared by if nobody says otherwise.
pub(crate) fn methods(group: Group, is_figure: bool) -> Vec<MethodChoice> {
    let with =
        |method, cells: &[u32]| cells.iter().map(move |&cells| MethodChoice { method, cells }).collect::<Vec<_>>();
    let rays: &[u32] = if is_figure || group == Group::Rectangles { &[35, 100] } else { &[16, 64] };
    let cells: &[u32] = match (is_figure, group) {
        (_, Group::Rectangles) => &[1, 8, 18, 32],
        (true, _) => &[1, 4, 8, 37],
        (false, _) => &[1, 4, 8, 12, 19, 37],
    };
    let is_single = |method: &Shadows| !method.has_cells() && (!is_figure || FIGURE_METHODS.contains(method));
    let mut methods: Vec<MethodChoice> =
        Shadows::ALL.into_iter().filter(is_single).flat_map(|method| with(method, &[1])).collect();
    methods.extend(with(Shadows::Verified, cells));
    methods.extend(with(Shadows::Proxy, rays));
    methods.extend(with(Shadows::MonteCarlo, rays));
    methods
}

/// Of the methods without cells, those that the figure is about, and the two that came after.
const FIGURE_METHODS: [Shadows; 6] = [
    Shadows::Quilez2010,
    Shadows::Aaltonen,
    Shadows::Quilez2019,
    Shadows::MinimalConePrinted,
    Shadows::MinimalCone,
    Shadows::MinimalConePlus,
];
