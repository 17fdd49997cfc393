//! A picture in one pass, as exported shaders draw it: the scene, its setting as constants, and the pass.

use std::fmt::Write;

use crate::template::FOR_SCREENS;

/// What the pass knows of a scene beside its two functions: `setting_view.wgsl` as plain data. Lengths are in millimetres;
/// radiances are such that a white surface in full light is about 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// The Lipschitz constant of the scene's distance.
    pub lipschitz: f32,
    /// The length below which f32 can't tell points of the scene apart.
    pub epsilon: f32,
    /// The box outside which there is nothing: its least and its greatest corner.
    pub bounds: [[f32; 3]; 2],
    /// The floor's height, if there is a floor.
    pub floor: Option<f32>,
    /// How the studio is turned about z: the angle's cosine and sine.
    pub azimuth: [f32; 2],
    /// The sky; without one the scene stands in the studio.
    pub sky: Option<Sky>,
    /// The lights.
    pub lights: Vec<Light>,
}

/// Linear radiances of a sky.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sky {
    /// Straight up.
    pub zenith: [f32; 3],
    /// All around.
    pub horizon: [f32; 3],
    /// Below.
    pub ground: [f32; 3],
}

/// `Light` of `light.wgsl`, field by field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// What these four mean depends on the kind.
    pub numbers: [[f32; 4]; 4],
    /// Linear red, green and blue.
    pub radiance: [f32; 3],
    /// One of the kinds.
    pub kind: u32,
    /// The sum of its flags.
    pub flags: u32,
}

/// What stands below a scene's functions in a program: the setting, and the functions of `one_pass/`, of which `one_pass`
/// draws a ray. How a program begins and what it shows is up to the caller.
pub fn one_pass(setting: &Setting) -> String {
    [&[setting.wgsl().as_str()], FILES, &[FOR_SCREENS]].concat().join("\n")
}

impl Setting {
    /// The functions of `setting_view.wgsl` and `one_pass/lights_bound.wgsl` as constants.
    pub fn wgsl(&self) -> String {
        let mut text = String::from("// The setting of this scene. Lengths are in millimetres.\n");
        let mut constant = |comment: &str, name: &str, ty: &str, value: String| {
            // Writing to a string can't fail.
            let _ = write!(text, "\n/// {comment}\nfn setting_{name}() -> {ty} {{\n    return {value};\n}}\n");
        };
        let dark = Sky { zenith: [0.0; 3], horizon: [0.0; 3], ground: [0.0; 3] };
        let Sky { zenith, horizon, ground } = self.sky.unwrap_or(dark);
        let [least, greatest] = self.bounds;
        constant("By how much distances may be too long.", "lipschitz", "f32", number(self.lipschitz));
        constant("The length below which points can't be told apart.", "epsilon", "f32", number(self.epsilon));
        constant("The box outside which there is nothing.", "box_min", "vec3<f32>", vector(&least));
        constant("Its greatest corner.", "box_max", "vec3<f32>", vector(&greatest));
        constant("Whether there is a floor.", "has_floor", "bool", self.floor.is_some().to_string());
        constant("The floor's height.", "floor", "f32", number(self.floor.unwrap_or_default()));
        constant(
            "Whether a studio surrounds the scene, or else a sky.",
            "is_studio",
            "bool",
            self.sky.is_none().to_string(),
        );
        constant("How the studio is turned about z: cosine, sine.", "azimuth", "vec2<f32>", vector(&self.azimuth));
        constant("The sky's radiance overhead.", "zenith", "vec3<f32>", vector(&zenith));
        constant("The sky's radiance at the horizon.", "horizon", "vec3<f32>", vector(&horizon));
        constant("The radiance from below.", "ground", "vec3<f32>", vector(&ground));
        constant("How many lights there are.", "light_count", "i32", self.lights.len().to_string());
        text + &self.lights_wgsl()
    }

    fn lights_wgsl(&self) -> String {
        let mut text = String::from("\n/// One of the lights.\nfn setting_light(i: i32) -> Light {\n");
        for (i, light) in self.lights.iter().enumerate() {
            let _ = write!(text, "    if i == {i} {{\n        return {};\n    }}\n", light.wgsl());
        }
        text + &format!("    return {};\n}}\n", Light::DARK.wgsl())
    }
}

impl Light {
    /// A light that sends nothing.
    const DARK: Self = Self { numbers: [[0.0; 4]; 4], radiance: [0.0; 3], kind: 0, flags: 0 };

    fn wgsl(&self) -> String {
        let [red, green, blue] = self.radiance;
        let [a, b, c, d] = self.numbers.map(|v| vector(&v));
        let radiance = vector(&[red, green, blue, 0.0]);
        format!("Light({a}, {b}, {c}, {d}, {radiance}, vec4<u32>({}u, {}u, 0u, 0u))", self.kind, self.flags)
    }
}

fn number(value: f32) -> String {
    format!("{value:?}")
}

fn vector(numbers: &[f32]) -> String {
    let numbers: Vec<String> = numbers.iter().map(|&value| number(value)).collect();
    format!("vec{}<f32>({})", numbers.len(), numbers.join(", "))
}

/// The pass, below what it asks of the setting.
pub(crate) const FILES: &[&str] = &[
    include_str!("../templates/basis.wgsl"),
    include_str!("../templates/ray.wgsl"),
    include_str!("../templates/trace_surface.wgsl"),
    include_str!("../templates/trace_studio.wgsl"),
    include_str!("../templates/light.wgsl"),
    include_str!("../templates/light_bounds.wgsl"),
    include_str!("../templates/light_crossing.wgsl"),
    include_str!("../templates/light_outline.wgsl"),
    include_str!("../templates/light_forms.wgsl"),
    include_str!("../templates/shadows/disc.wgsl"),
    include_str!("../templates/shadows/pieces.wgsl"),
    include_str!("../templates/shadows/verified/march.wgsl"),
    include_str!("../templates/one_pass/gloss.wgsl"),
    include_str!("../templates/light_lobe.wgsl"),
    include_str!("../templates/one_pass/query.wgsl"),
    include_str!("../templates/one_pass/light_cone.wgsl"),
    include_str!("../templates/one_pass/surroundings.wgsl"),
    include_str!("../templates/one_pass/lobe.wgsl"),
    include_str!("../templates/one_pass/one_pass.wgsl"),
    include_str!("../templates/one_pass/rays.wgsl"),
];
