//! What the texts around a scene's functions may mention of it.

use chiaro_syntax::Diagnostic;
use minijinja::syntax::SyntaxConfig;
use minijinja::value::Serde;
use minijinja::{AutoEscape, Environment, UndefinedBehavior, Value, context};
use serde::Serialize;

use crate::lamps::Lamps;
use crate::parameters::{Parameter, snake_case};
use crate::prose::Prose;
use crate::source::described;
use crate::subject::Scene;

const ABOUT: &str = include_str!("../packages/languages/about.txt");

macro_rules! parts {
    ($($path:literal),* $(,)?) => { [$(($path, include_str!(concat!("../packages/", $path)))),*] };
}

/// What templates include and extend, under its path in the folder of packages.
const PARTS: [(&str, &str); 8] = parts![
    "three/page.html",
    "three/solid.d.ts",
    "three/time.js",
    "three/webgl/parameters.glsl",
    "three/webgpu/depth.js",
    "three/webgpu/parameters.wgsl",
    "web/head.html",
    "web/view.js",
];

/// What templates know. They put texts down as they are; so a text of the scene's is [`Prose`] or a name.
#[derive(Serialize)]
pub(crate) struct Context {
    /// What people call the scene.
    title: Prose,
    /// The title as a name of files, uniforms and functions: `wall_clock`.
    pub(crate) name: String,
    /// The title as a name of types: `WallClock`.
    type_name: String,
    /// What a text starts with, as comments.
    about: String,
    version: &'static str,
    parameters: Vec<Live>,
    box_min: [f64; 3],
    box_max: [f64; 3],
    /// Whether the scene goes on outside of the box.
    is_endless: bool,
    lipschitz: f32,
    eye: [f64; 3],
    target: [f64; 3],
    up: [f64; 3],
    /// The vertical field of view in degrees.
    field_of_view: f64,
    aspect: f64,
    lamps: Lamps,
}

/// A live parameter.
#[derive(Serialize)]
struct Live {
    name: String,
    label: Prose,
    /// What people read of it.
    text: Prose,
    default: f64,
    min: f64,
    max: f64,
    step: f64,
    is_time: bool,
}

impl Context {
    pub(crate) fn new(scene: &Scene, parameters: &[Parameter]) -> Result<Self, Diagnostic> {
        let live = |parameter: &Parameter| Live {
            name: parameter.name.clone(),
            label: parameter.label.clone(),
            text: described(parameter),
            default: parameter.default,
            min: parameter.min,
            max: parameter.max,
            // Without a step of the scene's own, a slider has a thousand.
            step: parameter.step.unwrap_or((parameter.max - parameter.min) / 1000.0),
            is_time: parameter.is_time,
        };
        let camera = &scene.camera;
        // To the micrometre: a box that is slightly larger does no harm.
        let rounded = |x: f32, by: f64| (f64::from(x) * 1e3 + by).round() / 1e3;
        let [box_min, box_max] = scene.setting.bounds;
        let (box_min, box_max) = (box_min.map(|x| rounded(x, -0.5)), box_max.map(|x| rounded(x, 0.5)));
        let bounds = scene.graph.facts[scene.graph.root.0 as usize].bounds;
        let name = snake_case(scene.title, "scene");
        let mut context = Self {
            title: Prose::title(scene.title),
            type_name: camel_case(&name),
            name,
            about: String::new(),
            version: env!("CARGO_PKG_VERSION"),
            parameters: parameters.iter().map(live).collect(),
            box_min,
            box_max,
            is_endless: !bounds.is_empty() && !bounds.diagonal().is_finite(),
            lipschitz: scene.setting.lipschitz,
            eye: camera.eye,
            target: camera.target,
            up: camera.up,
            field_of_view: 2.0 * camera.half_height.atan().to_degrees(),
            aspect: camera.aspect,
            lamps: Lamps::of(scene.setting),
        };
        context.about = context.fill(ABOUT, "")?.trim_end().to_owned();
        Ok(context)
    }

    /// The same, of a scene that is called otherwise if its name is one of these words.
    pub(crate) fn with_other_name(mut self, taken: &str) -> Self {
        if taken.split_whitespace().any(|word| word == self.name) {
            self.name += "_scene";
            self.type_name = camel_case(&self.name);
        }
        self
    }

    /// A template filled in, with this as its shader code.
    pub(crate) fn fill(&self, template: &str, code: &str) -> Result<String, Diagnostic> {
        let mut environment = Environment::new();
        environment.set_undefined_behavior(UndefinedBehavior::Strict);
        // Names and prose stand everywhere as they are, whatever the ending of the file that is included.
        environment.set_auto_escape_callback(|_| AutoEscape::None);
        // Lines of instructions leave nothing behind.
        let failed = |error: minijinja::Error| {
            Diagnostic::error(None, format!("a text of this export can't be made: {error:#}"))
        };
        let syntax = SyntaxConfig::builder().trim_blocks(true).lstrip_blocks(true).keep_trailing_newline(true).build();
        environment.set_syntax(syntax.map_err(failed)?);
        environment.add_filter("float", |value: f64| crate::parameters::number(value));
        environment.add_filter("template_literal", template_literal);
        environment.add_filter("uuid", uuid);
        for (name, text) in PARTS {
            environment.add_template(name, text).map_err(failed)?;
        }
        environment.render_str(template, context! { code, ..Value::from(Serde(self)) }).map_err(failed)
    }
}

/// The same 128 bits for a name everywhere, as a UUID without hyphens (FNV-1a).
fn uuid(name: String) -> String {
    let mix = |hash: u128, byte| (hash ^ u128::from(byte)).wrapping_mul((1 << 88) + 0x13b);
    format!("{:032x}", name.bytes().fold(0x6c62_272e_07bb_0142_62b8_2175_6295_c58d, mix))
}

/// A text as it stands between the backticks of JavaScript's template literals.
fn template_literal(text: String) -> String {
    text.replace('\\', r"\\").replace('`', r"\`").replace("${", r"\${")
}

/// `WallClock` for `wall_clock`.
fn camel_case(name: &str) -> String {
    let capital = |word: &str| word[..1].to_ascii_uppercase() + &word[1..];
    name.split('_').filter(|word| !word.is_empty()).map(capital).collect()
}
