//! The templates: what runs the scene's functions.

use std::sync::OnceLock;

use naga::{Function, Handle, Module};
use rustc_hash::FxHashMap;

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
}

impl Template {
    /// All of them.
    pub const ALL: [Template; 4] = [Template::Library, Template::Distances, Template::Prepass, Template::Trace];

    /// Its own WGSL, which calls `scene_distance` and `scene_surface`.
    pub fn text(self) -> &'static str {
        match self {
            Template::Library => include_str!("../templates/library.wgsl"),
            Template::Distances => include_str!("../templates/distances.wgsl"),
            Template::Prepass => {
                concat!(include_str!("../templates/trace_view.wgsl"), include_str!("../templates/prepass.wgsl"))
            }
            Template::Trace => concat!(
                include_str!("../templates/trace_view.wgsl"),
                include_str!("../templates/trace_numbers.wgsl"),
                include_str!("../templates/trace_surface.wgsl"),
                include_str!("../templates/trace_studio.wgsl"),
                include_str!("../templates/trace.wgsl"),
            ),
        }
    }

    /// Its module together with the vocabulary and the stubs, parsed when first asked for.
    pub(crate) fn parsed(self) -> &'static Parsed {
        static PARSED: [OnceLock<Parsed>; Template::ALL.len()] = [const { OnceLock::new() }; Template::ALL.len()];
        PARSED[self as usize].get_or_init(|| Parsed::new(self))
    }
}

/// A parsed template.
pub(crate) struct Parsed {
    /// The vocabulary, the stubs and the template.
    pub(crate) module: Module,
    /// The module's functions by name.
    pub(crate) functions: FxHashMap<String, Handle<Function>>,
}

/// The stubs that splicing replaces, with the struct the second one returns.
pub(crate) const SCENE: &str = include_str!("../templates/scene.wgsl");

impl Parsed {
    /// # Panics
    ///
    /// If the text is no WGSL: the templates are part of this crate, and a test parses each.
    fn new(template: Template) -> Self {
        let text = [chiaro_vocabulary::source(), SCENE, template.text()].join("\n");
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
        for template in Template::ALL {
            assert!(template.parsed().functions.contains_key("scene_distance"), "{template:?}");
        }
    }
}
