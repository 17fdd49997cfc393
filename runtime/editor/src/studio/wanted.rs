//! What the window wants to see.

use std::sync::Arc;

use chiaro_compiler::shader::Shadows;
use chiaro_compiler::solid::{Camera, LiveParameter, Scalar};
use chiaro_compiler::{Provenance, Scene, SolidId};
use chiaro_render::{Direct, Inspection, View};

/// A complete description of the wanted picture; the drawing thread finds out what changed.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Wanted {
    /// In pixels.
    pub(crate) size: [u32; 2],
    pub(crate) eye: Eye,
    /// Live numbers that differ from their defaults.
    pub(crate) values: Vec<LiveValue>,
    pub(crate) look: Look,
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
    /// Whose outline is drawn.
    pub(crate) outlined: Option<Outlined>,
    /// What is highlighted, hidden by nothing but what is before it.
    pub(crate) highlighted: Option<Outlined>,
}

/// From where the scene is seen.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) enum Eye {
    /// As the scene says; what it leaves open, so that all of it is seen.
    #[default]
    Scene,
    /// Turned this way, in OpenSCAD's degrees, so that all of it is seen; with this vertical field of view in degrees.
    Framed([f64; 3], f64),
    /// From there.
    At(View),
}

/// What is shown of a scene.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) enum Look {
    /// Light on its materials.
    #[default]
    Lit,
    /// Something else about it.
    Inspected(Inspection),
}

/// Solids of a scene.
#[derive(Clone, Debug)]
pub(crate) struct Outlined {
    /// The scene's.
    pub(crate) provenance: Arc<Provenance>,
    pub(crate) solids: Vec<SolidId>,
}

impl PartialEq for Outlined {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.provenance, &other.provenance) && self.solids == other.solids
    }
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
            eye: Eye::Scene,
            values: Vec::new(),
            look: Look::Lit,
            direct: Direct::By(Shadows::Verified),
            other: None,
            floor: true,
            exposure: 0.0,
            samples: 64,
            moving: false,
            outlined: None,
            highlighted: None,
        }
    }
}

impl Wanted {
    /// Whether a picture of the one is one of the other too, if both are seen from the same place.
    /// What is outlined and highlighted lies over the picture.
    pub(crate) fn shows_like(&self, other: &Wanted) -> bool {
        let Wanted { eye, samples, moving, outlined, highlighted, .. } = other.clone();
        Wanted { eye, samples, moving, outlined, highlighted, ..self.clone() } == *other
    }

    /// The values of a scene's live parameters, in the order of their ids.
    pub(crate) fn parameters(&self, scene: &Scene) -> Vec<f64> {
        let value = |parameter: &LiveParameter| {
            let is_it = |value: &&LiveValue| value.name == *parameter.name && value.component == parameter.component;
            self.values.iter().find(is_it).map_or(parameter.default, |value| value.value)
        };
        scene.parameters.iter().map(value).collect()
    }
}

impl Eye {
    /// The camera of a scene seen from here; what it leaves open is to be framed.
    pub(crate) fn camera(&self, scene: &Camera) -> Camera {
        match self {
            Eye::Scene | Eye::At(_) => scene.clone(),
            Eye::Framed(rotation, field_of_view) => Camera {
                rotation: Some(rotation.map(Scalar::from)),
                field_of_view: Some(Scalar::from(*field_of_view)),
                ..Camera::default()
            },
        }
    }
}
