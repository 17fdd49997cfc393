//! The shadow methods: how much of a light a receiver sees.

/// The passes of [`Shadows::Verified`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Verified {
    /// Entry `shadow`: the whole light, for each receiver.
    Gate,
    /// Entry `choose`: which receivers are as their neighbours say. It asks no scene.
    Choose,
    /// Entry `cells`: the cells of the light for receivers that are not.
    Cells,
    /// Entry `settle`: what the cells come to. It asks no scene.
    Settle,
}

impl Verified {
    /// How many stages there are: the receivers of a stage are predicted from those of the stages before.
    pub const STAGES: usize = 3;

    pub(crate) fn files(self) -> &'static [&'static str] {
        match self {
            Verified::Gate => {
                &[TASK, DISC, PIECES, LATTICE, MARCH, include_str!("../templates/shadows/verified/gate.wgsl")]
            }
            Verified::Choose => &[TASK, LATTICE, SUMS, include_str!("../templates/shadows/verified/choose.wgsl")],
            Verified::Cells => {
                &[TASK, DISC, PIECES, LATTICE, SUMS, MARCH, include_str!("../templates/shadows/verified/cells.wgsl")]
            }
            Verified::Settle => &[TASK, SUMS, include_str!("../templates/shadows/verified/settle.wgsl")],
        }
    }
}

/// An algorithm that answers how much of a light each receiver sees.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Shadows {
    /// Cones that are proven free, and cells where they are not.
    Verified,
    /// A ray to the light's centre.
    Hard,
    /// Quilez 2010: the nearest miss.
    Quilez2010,
    /// Quilez 2019: the nearest miss or the deepest hit.
    Quilez2019,
    /// Aaltonen 2018: the nearest miss, triangulated.
    Aaltonen,
    /// Bálint and Valasek 2018: whether the light's cone is free.
    Cone,
    /// Bán, Bálint, Valasek 2019: algorithm 2 as printed.
    MinimalConePrinted,
    /// Bán, Bálint, Valasek 2019: algorithm 2 as it must be meant, with the cubic of section 4.1.
    MinimalCone,
    /// The same with the exact area of section 4.1.
    MinimalConeExact,
    /// The same with longer steps and the receiver's horizon.
    MinimalConePlus,
    /// Bán, Bálint, Valasek 2019, section 4.2: random points of the light against a half space.
    Proxy,
    /// Random rays.
    MonteCarlo,
}

impl Shadows {
    /// All of them.
    pub const ALL: [Shadows; 12] = [
        Shadows::Verified,
        Shadows::Hard,
        Shadows::Quilez2010,
        Shadows::Quilez2019,
        Shadows::Aaltonen,
        Shadows::Cone,
        Shadows::MinimalConePrinted,
        Shadows::MinimalCone,
        Shadows::MinimalConeExact,
        Shadows::MinimalConePlus,
        Shadows::Proxy,
        Shadows::MonteCarlo,
    ];

    /// Its name, as scenes and command lines write it.
    pub fn name(self) -> &'static str {
        match self {
            Shadows::Verified => "verified",
            Shadows::Hard => "hard",
            Shadows::Quilez2010 => "quilez2010",
            Shadows::Quilez2019 => "quilez2019",
            Shadows::Aaltonen => "aaltonen",
            Shadows::Cone => "cone",
            Shadows::MinimalConePrinted => "minimal-cone-printed",
            Shadows::MinimalCone => "minimal-cone",
            Shadows::MinimalConeExact => "minimal-cone-exact",
            Shadows::MinimalConePlus => "minimal-cone-plus",
            Shadows::Proxy => "proxy",
            Shadows::MonteCarlo => "monte-carlo",
        }
    }

    /// The method of that name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|method| method.name() == name)
    }

    /// Whether it cuts lights into cells, or draws several rays: whether it heeds a number of them.
    pub fn has_cells(self) -> bool {
        matches!(self, Shadows::Verified | Shadows::Proxy | Shadows::MonteCarlo)
    }

    pub(crate) fn files(self) -> &'static [&'static str] {
        match self {
            Shadows::Verified => Verified::Gate.files(),
            Shadows::Hard => &[TASK, KERNEL, DISC, include_str!("../templates/shadows/hard.wgsl")],
            Shadows::Quilez2010 => &[TASK, KERNEL, DISC, include_str!("../templates/shadows/quilez2010.wgsl")],
            Shadows::Quilez2019 => &[TASK, KERNEL, DISC, include_str!("../templates/shadows/quilez2019.wgsl")],
            Shadows::Aaltonen => &[TASK, KERNEL, DISC, include_str!("../templates/shadows/aaltonen.wgsl")],
            Shadows::Cone => &[TASK, KERNEL, DISC, include_str!("../templates/shadows/cone.wgsl")],
            Shadows::MinimalConePrinted => {
                &[TASK, KERNEL, DISC, MINIMAL, SMOOTH, include_str!("../templates/shadows/minimal/printed.wgsl")]
            }
            Shadows::MinimalCone => &[TASK, KERNEL, DISC, MINIMAL, SMOOTH, RESOLVED],
            Shadows::MinimalConeExact => {
                &[TASK, KERNEL, DISC, MINIMAL, RESOLVED, include_str!("../templates/shadows/minimal/exact.wgsl")]
            }
            Shadows::MinimalConePlus => {
                &[TASK, KERNEL, DISC, MINIMAL, SMOOTH, include_str!("../templates/shadows/minimal/plus.wgsl")]
            }
            Shadows::Proxy => &[TASK, KERNEL, DISC, include_str!("../templates/shadows/proxy.wgsl")],
            Shadows::MonteCarlo => &[TASK, KERNEL, DISC, include_str!("../templates/shadows/monte_carlo.wgsl")],
        }
    }
}

const TASK: &str = include_str!("../templates/shadows/task.wgsl");
const LATTICE: &str = include_str!("../templates/shadows/verified/lattice.wgsl");
const SUMS: &str = include_str!("../templates/shadows/verified/sums.wgsl");
const MARCH: &str = include_str!("../templates/shadows/verified/march.wgsl");
const KERNEL: &str = include_str!("../templates/shadows/kernel.wgsl");
const DISC: &str = include_str!("../templates/shadows/disc.wgsl");
const PIECES: &str = include_str!("../templates/shadows/pieces.wgsl");
const MINIMAL: &str = include_str!("../templates/shadows/minimal_cone.wgsl");
const SMOOTH: &str = include_str!("../templates/shadows/minimal/smooth.wgsl");
const RESOLVED: &str = include_str!("../templates/shadows/minimal/resolved.wgsl");
