//! What the window wants to see.

use chiaro_compiler::Scene;
use chiaro_compiler::shader::Shadows;
use chiaro_render::{Direct, View};

/// A complete description of the wanted picture; the drawing thread finds out what changed.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Wanted {
    /// In pixels.
    pub(crate) size: [u32; 2],
    /// From where; otherwise as the scene says, or framed.
    pub(crate) view: Option<View>,
    /// Live numbers that differ from their defaults.
    pub(crate) values: Vec<LiveValue>,
    pub(crate) direct: Direct,
    /// Another light algorithm, to compare with.
    pub(crate) other: Option<Direct>,
    pub(crate) floor: bool,
    /// Brightness in stops.
    pub(crate) exposure: f32,
    /// How many samples the picture gets before the machine may rest.
    pub(crate) samples: u32,
    /// Whether something moves: then frames come fast and small.
    pub(crate) moving: bool,
}

/// A live number's value.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LiveValue {
    /// Its name; of a number in the text, `@` and where it starts.
    pub(crate) name: String,
    pub(crate) component: Option<usize>,
    pub(crate) value: f64,
}

impl Default for Wanted {
    fn default() -> Self {
        Self {
            size: [640, 480],
            view: None,
            values: Vec::new(),
            direct: Direct::By(Shadows::Verified),
            other: None,
            floor: true,
            exposure: 0.0,
            samples: 64,
            moving: false,
        }
    }
}

impl Wanted {
    /// The values of a scene's live parameters, in the order of their ids.
    pub(crate) fn parameters(&self, scene: &Scene) -> Vec<f64> {
        let value = |parameter: &chiaro_compiler::solid::LiveParameter| {
            let is_it = |value: &&LiveValue| value.name == *parameter.name && value.component == parameter.component;
            self.values.iter().find(is_it).map_or(parameter.default, |value| value.value)
        };
        scene.parameters.iter().map(value).collect()
    }
}
