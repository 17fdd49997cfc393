//! What is exported: a scene's functions, what is known of it, and from where it is seen.

use std::fmt::Display;

use chiaro_field::Graph;
use chiaro_shader::{Names, Setting, one_pass};
use chiaro_solid::LiveParameter;
use chiaro_syntax::Diagnostic;

use crate::parameters::number;
use crate::source::Source;

/// The slope of the distance.
const GRADIENT: &str = include_str!("../wgsl/gradient.wgsl");
/// Where rays meet it.
const SOLID: &str = include_str!("../wgsl/solid.wgsl");
/// What displays show of radiances.
const SHOWN: &str = include_str!("../wgsl/shown.wgsl");
/// What a pixel shows.
const PICTURE: &str = include_str!("../wgsl/picture.wgsl");

/// A scene to be exported.
pub struct Scene<'a> {
    /// What it is called: its file's name without the ending.
    pub title: &'a str,
    /// Its field.
    pub graph: &'a Graph,
    /// Its live numbers.
    pub parameters: &'a [LiveParameter],
    /// What values that come from an expression are called.
    pub names: Names<'a>,
    /// How it is lit, and the box it is in.
    pub setting: &'a Setting,
    /// From where it is seen.
    pub camera: Camera,
}

/// A view of the scene. Lengths are in millimetres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Where the eye is.
    pub eye: [f64; 3],
    /// The point it looks at.
    pub target: [f64; 3],
    /// To the right in the picture, of length 1.
    pub right: [f64; 3],
    /// Upwards in the picture, of length 1.
    pub up: [f64; 3],
    /// Half the picture's height on the plane one millimetre before the eye.
    pub half_height: f64,
    /// The picture's width by its height.
    pub aspect: f64,
}

/// A scene as WGSL.
pub(crate) struct Text {
    /// The functions of the scene, with what else is asked for below.
    pub(crate) source: Source,
    /// What stands below the scene's functions.
    pub(crate) below: String,
}

impl Scene<'_> {
    /// The scene's functions alone: distance, surface and gradient.
    pub(crate) fn library(&self) -> Result<Text, Diagnostic> {
        self.text(self.functions())
    }

    /// What engines take: where rays meet the scene, for them to light it; and the light that we would give it, down to
    /// `one_pass` and `shown`. Both have the same live parameters.
    pub(crate) fn solid_and_lit(&self) -> Result<(Text, Text), Diagnostic> {
        let solid = self.functions() + "\n" + SOLID;
        let lit = self.light();
        let Text { source, .. } = self.text([&*solid, &lit].concat())?;
        Ok((Text { source: source.clone(), below: solid }, Text { source, below: lit }))
    }

    /// The functions that draw it, down to `picture`.
    pub(crate) fn program(&self) -> Result<Text, Diagnostic> {
        self.text([&self.light(), "\n", &self.camera.wgsl(), "\n", PICTURE].concat())
    }

    /// The scene's functions with those below, which may call them.
    fn text(&self, below: String) -> Result<Text, Diagnostic> {
        Ok(Text { source: Source::new(self.graph, self.parameters, self.names, &below)?, below })
    }

    fn functions(&self) -> String {
        format!("\n{}\n{GRADIENT}", self.constants())
    }

    fn light(&self) -> String {
        ["\n", &one_pass(self.setting), "\n", SHOWN].concat()
    }

    fn constants(&self) -> String {
        let [least, greatest] = self.setting.bounds.map(vector);
        let lipschitz = number(f64::from(self.setting.lipschitz));
        format!(
            "// The box that the scene is in.\nconst SCENE_MIN: vec3<f32> = {least};\nconst SCENE_MAX: vec3<f32> = {greatest};\n\n\
             // The greatest slope of the distance: no surface is nearer than |scene_distance(p)| / SCENE_LIPSCHITZ.\n\
             const SCENE_LIPSCHITZ: f32 = {lipschitz};\n"
        )
    }
}

impl Camera {
    fn wgsl(&self) -> String {
        let point = |v: [f64; 3]| vector(v.map(|x| x as f32));
        format!(
            "// The scene's own view: the eye, what it looks at, the directions of the picture's sides, half its height on the\n\
             // plane one millimetre before the eye, and its width by its height.\n\
             const CAMERA_EYE: vec3<f32> = {};\nconst CAMERA_TARGET: vec3<f32> = {};\nconst CAMERA_RIGHT: vec3<f32> = {};\n\
             const CAMERA_UP: vec3<f32> = {};\nconst CAMERA_HALF_HEIGHT: f32 = {};\nconst CAMERA_ASPECT: f32 = {};\n",
            point(self.eye),
            point(self.target),
            point(self.right),
            point(self.up),
            number(self.half_height),
            number(self.aspect),
        )
    }
}

impl Text {
    /// All of it, with a uniform of live parameters at this binding of group 0.
    pub(crate) fn wgsl(&self, binding: u32) -> String {
        self.wgsl_bound(0, binding)
    }

    /// All of it, with a uniform of live parameters at this place.
    pub(crate) fn wgsl_bound(&self, group: impl Display, binding: u32) -> String {
        self.source.with_uniforms(group, binding) + &self.below
    }
}

fn vector(v: [f32; 3]) -> String {
    format!("vec3<f32>({})", v.map(|x| number(f64::from(x))).join(", "))
}
