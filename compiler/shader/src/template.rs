//! The templates: what runs the scene's functions.

use std::sync::{Mutex, OnceLock, PoisonError};

use naga::{Function, Handle, Module};
use rustc_hash::FxHashMap;

use crate::one_pass;
use crate::shadows::{Shadows, Verified};

/// A WGSL file that scenes are spliced into.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Template {
    /// The scene's functions alone; no entry points.
    Library,
    /// Entry `distances`: answers the distance at each of a list of points.
    Distances,
    /// Finds where the rays of a tile may start.
    Prepass,
    /// Traces rays and lights what they hit.
    Trace,
    /// Entry `shadow`: answers how much of a light each receiver sees.
    Shadows(Shadows),
    /// The passes of verified cones that follow.
    Verified(Verified),
    /// Entry `shade`: adds a light to the picture. It asks no scene.
    Shade,
    /// Entry `draw`: the whole picture in one pass, as exported shaders draw it.
    OnePass,
    /// What views other than pictures are made of.
    Inspect(Inspect),
}

/// The passes of inspections.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Inspect {
    /// Entry `inspect`: answers where pixels see a surface, and at which cost.
    Surface,
    /// Entry `section`: answers the distance where pixels see a plane through the scene.
    Section,
    /// Entry `inspect_materials`: answers the material at each of a list of points.
    Materials,
}

impl Template {
    /// All of them.
    pub fn all() -> impl Iterator<Item = Template> {
        let fixed = [
            Template::Library,
            Template::Distances,
            Template::Prepass,
            Template::Trace,
            Template::Shade,
            Template::OnePass,
        ];
        let verified = [Verified::Choose, Verified::Cells, Verified::Settle].map(Template::Verified);
        let inspect = [Inspect::Surface, Inspect::Section, Inspect::Materials].map(Template::Inspect);
        fixed.into_iter().chain(Shadows::ALL.into_iter().map(Template::Shadows)).chain(verified).chain(inspect)
    }

    /// Its own WGSL, which calls `scene_distance` and `scene_surface`.
    pub fn text(self) -> String {
        self.files().join("\n")
    }

    fn files(self) -> Vec<&'static str> {
        match self {
            Template::Library => vec![include_str!("../templates/library.wgsl")],
            Template::Distances => vec![include_str!("../templates/distances.wgsl")],
            Template::Prepass => [&VIEW[..], &[include_str!("../templates/prepass.wgsl")]].concat(),
            Template::Trace => {
                let own = [
                    MEET,
                    include_str!("../templates/trace_lights.wgsl"),
                    include_str!("../templates/trace_scatter.wgsl"),
                    SAMPLING,
                    include_str!("../templates/trace.wgsl"),
                ];
                [&VIEW[..], &PICTURE, &SURFACES, &[GLOSS], &LIGHTS, &own].concat()
            }
            Template::Shadows(method) => [&VIEW[..], &PICTURE, &LIGHTS, &[SAMPLING], method.files()].concat(),
            Template::Verified(pass) => [&VIEW[..], &PICTURE, &LIGHTS, pass.files()].concat(),
            Template::Shade => {
                let own = [include_str!("../templates/light_lobe.wgsl"), include_str!("../templates/shade.wgsl")];
                [&VIEW[..], &PICTURE, &SURFACES, &[GLOSS], &LIGHTS, &own].concat()
            }
            Template::OnePass => {
                let own = [
                    include_str!("../templates/one_pass/lights_bound.wgsl"),
                    include_str!("../templates/one_pass/picture.wgsl"),
                ];
                [&VIEW[..2], &own, one_pass::FILES].concat()
            }
            Template::Inspect(pass) => pass.files(),
        }
    }

    /// Its module together with the vocabulary and the stubs, parsed when first asked for.
    pub(crate) fn parsed(self) -> &'static Parsed {
        self.parsed_for(false)
    }

    /// The same with what asks crowds.
    pub(crate) fn parsed_with_crowds(self) -> &'static Parsed {
        self.parsed_for(true)
    }

    fn parsed_for(self, crowds: bool) -> &'static Parsed {
        static PARSED: OnceLock<Mutex<FxHashMap<(Template, bool), &'static Parsed>>> = OnceLock::new();
        let mut parsed = PARSED.get_or_init(Mutex::default).lock().unwrap_or_else(PoisonError::into_inner);
        parsed.entry((self, crowds)).or_insert_with(|| Box::leak(Box::new(Parsed::new(self, crowds))))
    }
}

impl Inspect {
    fn files(self) -> Vec<&'static str> {
        let plane = include_str!("../templates/inspect_plane.wgsl");
        match self {
            Inspect::Surface => [&VIEW[..], &[MEET, plane, include_str!("../templates/inspect.wgsl")]].concat(),
            Inspect::Section => [&VIEW[..], &[plane, include_str!("../templates/inspect_section.wgsl")]].concat(),
            Inspect::Materials => vec![include_str!("../templates/inspect_materials.wgsl")],
        }
    }
}

/// How rays meet surfaces.
const MEET: &str = include_str!("../templates/trace_meet.wgsl");

/// How lights are sampled.
const SAMPLING: &str = include_str!("../templates/light_sampling.wgsl");

/// The glossy lobe in a table.
const GLOSS: &str = include_str!("../templates/gloss.wgsl");

/// From where a scene is seen.
const VIEW: [&str; 3] = [
    include_str!("../templates/trace_view.wgsl"),
    include_str!("../templates/setting_view.wgsl"),
    include_str!("../templates/ray.wgsl"),
];

/// What pictures are drawn with.
const PICTURE: [&str; 3] = [
    include_str!("../templates/basis.wgsl"),
    include_str!("../templates/trace_numbers.wgsl"),
    include_str!("../templates/receiver.wgsl"),
];

/// What is known of surfaces and of what surrounds them.
const SURFACES: [&str; 2] =
    [include_str!("../templates/trace_surface.wgsl"), include_str!("../templates/trace_studio.wgsl")];

/// What is known of lights.
const LIGHTS: [&str; 5] = [
    include_str!("../templates/light.wgsl"),
    include_str!("../templates/light_bounds.wgsl"),
    include_str!("../templates/light_crossing.wgsl"),
    include_str!("../templates/light_outline.wgsl"),
    include_str!("../templates/light_forms.wgsl"),
];

/// A parsed template.
pub(crate) struct Parsed {
    /// The vocabulary, the stubs and the template.
    pub(crate) module: Module,
    /// The module's functions by name.
    pub(crate) functions: FxHashMap<String, Handle<Function>>,
}

/// What [`GLOSS`](crate::bindings::GLOSS) is: rows of four 32-bit floats, the least significant byte first. The example
/// `fit_gloss` computes it.
pub const GLOSS_TABLE: &[u8] = include_bytes!("../templates/gloss.bin");

/// From radiance to what a screen shows: WGSL functions that ask nothing.
pub const FOR_SCREENS: &str = include_str!("../templates/display.wgsl");

/// The stubs that splicing replaces, with the struct the second one returns.
pub(crate) const SCENE: &str = include_str!("../templates/scene.wgsl");

impl Parsed {
    /// # Panics
    ///
    /// If the text is no WGSL: the templates are part of this crate, and a test parses each.
    fn new(template: Template, crowds: bool) -> Self {
        let crowds = if crowds { include_str!("../templates/crowd.wgsl") } else { "" };
        let text = [chiaro_vocabulary::source(), SCENE, crowds, &template.text()].join("\n");
        let module = naga::front::wgsl::parse_str(&text)
            .unwrap_or_else(|error| panic!("{template:?}: {}", error.emit_to_string(&text)));
        let named = |(handle, function): (_, &Function)| Some((function.name.clone()?, handle));
        let functions = module.functions.iter().filter_map(named).collect();
        Self { module, functions }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_template_parses() {
        for template in Template::all() {
            assert!(template.parsed().functions.contains_key("scene_distance"), "{template:?}");
            assert!(template.parsed_with_crowds().functions.contains_key("crowd_list"), "{template:?}");
        }
    }
}
