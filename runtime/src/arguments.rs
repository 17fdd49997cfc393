//! The command line.

use std::path::PathBuf;

use chiaro_compiler::shader::Shadows;
use chiaro_render::{Direct, Preference};
use clap::{Args, Parser, Subcommand, ValueEnum};

use crate::view::View;

/// Compiles CSG scenes to shader code, and draws them.
#[derive(Debug, Parser)]
#[command(version, max_term_width = 100)]
pub(crate) struct Arguments {
    #[command(flatten)]
    pub(crate) global: Global,

    /// Read scenes, and what they include, only from this folder and those in it, wherever links lead. May be said several
    /// times. Without it, a scene may include whatever its user may read.
    #[arg(long, global = true, value_name = "FOLDER")]
    pub(crate) jail: Vec<PathBuf>,

    #[command(subcommand)]
    pub(crate) command: Command,
}

/// What every subcommand takes.
#[derive(Clone, Copy, Debug, Args)]
pub(crate) struct Global {
    /// Say nothing but errors, and draw no progress bars.
    #[arg(long, short, global = true)]
    pub(crate) quiet: bool,

    /// How to write diagnostics to standard error.
    #[arg(long, global = true, value_name = "FORMAT", default_value = "human")]
    pub(crate) message_format: MessageFormat,
}

/// How diagnostics are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum MessageFormat {
    /// With the source text, for people.
    Human,
    /// One JSON object a line, for programs.
    Json,
}

/// The subcommands.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Open scenes in the editor: the text at one side, the lit scene at the other.
    #[cfg(feature = "editor")]
    Edit(Edit),
    /// Show a scene in a window, and draw it anew whenever its file is saved.
    #[cfg(feature = "editor")]
    Watch(Watch),
    /// Draw a scene into a picture.
    Render(Render),
    /// Write a scene for other programs: as shader code, as an engine's files, or as a triangle mesh.
    Export(Export),
    /// Compile a scene and report what is wrong with it.
    Check(Check),
    /// Format scenes: their indentation and spaces, and nothing else.
    Fmt(Fmt),
    /// Print what one stage of the compiler makes of a scene.
    Dump(Dump),
    /// Answer the signed distance at given points.
    Distance(Distance),
    /// Compare shadow methods with the truth: how far they are from it, and what they cost.
    Compare(Compare),
    /// List the graphics adapters that pictures can be drawn on.
    Adapters,
}

/// The scene, and what is said about it on the command line.
#[derive(Clone, Debug, Args)]
pub(crate) struct SceneArguments {
    /// The scene: a .csg or .scad file.
    pub(crate) file: PathBuf,

    /// Set a parameter or another top-level variable, as in -D 'width=20' or -D 'label="A"'.
    #[arg(short = 'D', value_name = "NAME=VALUE", value_parser = definition)]
    pub(crate) definitions: Vec<(String, String)>,

    /// What an explicit $fn means: from 3 to 12 a polygon and above it a true curve (auto), always a polygon, or
    /// always a true curve.
    #[arg(long, value_name = "WHEN", default_value = "auto")]
    pub(crate) facets: FacetPolicy,
}

/// What an explicit `$fn` means.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(crate) enum FacetPolicy {
    /// Up to 12 a polygon, above it a true curve.
    Auto,
    /// Always a polygon.
    Exact,
    /// Always a true curve.
    Smooth,
}

/// Arguments of `edit`.
#[cfg(feature = "editor")]
#[derive(Debug, Args)]
pub(crate) struct Edit {
    /// The scenes: .csg or .scad files, new ones too. Without any, those that were open the last time.
    pub(crate) files: Vec<PathBuf>,

    #[command(flatten)]
    pub(crate) adapter: AdapterArguments,
}

/// Arguments of `watch`.
#[cfg(feature = "editor")]
#[derive(Debug, Args)]
pub(crate) struct Watch {
    /// The scene: a .csg or .scad file.
    pub(crate) file: PathBuf,

    /// Set a parameter or another top-level variable, as in -D 'width=20' or -D 'label="A"'.
    #[arg(short = 'D', value_name = "NAME=VALUE", value_parser = definition)]
    pub(crate) definitions: Vec<(String, String)>,

    #[command(flatten)]
    pub(crate) adapter: AdapterArguments,
}

/// Arguments of `render`.
#[derive(Debug, Args)]
pub(crate) struct Render {
    #[command(flatten)]
    pub(crate) scene: SceneArguments,

    /// The picture: .png, or .exr for linear radiance in 32-bit floating point. Use - for a .png on standard output.
    #[arg(long, short, value_name = "PICTURE")]
    pub(crate) output: PathBuf,

    /// Width and height in pixels.
    #[arg(long, value_name = "WxH", default_value = "960x720", value_parser = size)]
    pub(crate) size: (u32, u32),

    /// Rays a pixel: more of them make shadows and edges smoother.
    #[arg(long, value_name = "N", default_value_t = 64, value_parser = clap::value_parser!(u32).range(1..=65_536))]
    pub(crate) samples: u32,

    /// Draw as exported shaders draw it: at once, with four rays a pixel, and no samples.
    #[arg(long, conflicts_with_all = ["samples", "shadows", "shadow_cells"])]
    pub(crate) one_pass: bool,

    /// From where to look: front, back, left, right, top, bottom, diagonal; or OpenSCAD's camera, RX,RY,RZ in degrees
    /// (framed from the bounds) or TX,TY,TZ,RX,RY,RZ,DISTANCE. Otherwise the scene's own view.
    #[arg(long, value_name = "VIEW", allow_hyphen_values = true)]
    pub(crate) view: Option<View>,

    /// How direct light is found: verified (proven cones), another shadow method, or reference (random samples: slow, noisy,
    /// and right).
    #[arg(long, value_name = "METHOD", default_value = "verified")]
    pub(crate) shadows: ShadowChoice,

    /// Into how many cells verified cones cut a light where it is partly covered: 1 is fastest, 37 as good as hundreds
    /// of rays.
    #[arg(long, value_name = "N", default_value_t = 19, value_parser = clap::value_parser!(u32).range(1..=64))]
    pub(crate) shadow_cells: u32,

    /// Leave out the floor below the scene.
    #[arg(long)]
    pub(crate) no_floor: bool,

    /// Draw this many pictures while $t goes from 0 to 1; their numbers are put before the ending of the name.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub(crate) frames: Option<u32>,

    #[command(flatten)]
    pub(crate) adapter: AdapterArguments,
}

/// Arguments of `export`.
#[derive(Debug, Args)]
pub(crate) struct Export {
    #[command(flatten)]
    pub(crate) scene: SceneArguments,

    /// The file, or the folder of targets that are several files. Its ending says the format, if --to does not. Use - for
    /// standard output, if the target is one file.
    #[arg(long, short, value_name = "FILE")]
    pub(crate) output: PathBuf,

    /// What to write.
    #[arg(long, value_name = "TARGET")]
    pub(crate) to: Option<Target>,

    /// Of shading languages, write a whole program that draws the scene, in the place of functions to call.
    #[arg(long)]
    pub(crate) program: bool,

    /// Write over files that are there already.
    #[arg(long)]
    pub(crate) force: bool,

    /// How far a mesh may be off the surface, in millimetres; a two-thousandth of the scene's diagonal by default.
    #[arg(long, value_name = "MM", value_parser = positive)]
    pub(crate) tolerance: Option<f64>,

    /// Into how many cells the longest side is divided to look for the surface: what is thinner than a cell may be missed.
    /// Chosen by the tolerance if nothing is said.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(2..=1_000_000))]
    pub(crate) resolution: Option<u32>,

    #[command(flatten)]
    pub(crate) adapter: AdapterArguments,
}

/// What `export` can write.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Target {
    /// Triangles without materials, binary.
    Stl,
    /// A mesh with its materials in an .mtl file beside it.
    Obj,
    /// A mesh with vertex colours, binary.
    Ply,
    /// A mesh with colours, for printing.
    #[value(name = "3mf")]
    ThreeMf,
    /// A mesh with materials for physically based shading; its data in a .bin file beside it.
    Gltf,
    /// The same in one file.
    Glb,
    /// Functions in WGSL; with --program a vertex and a fragment shader.
    Wgsl,
    /// Functions in GLSL 330; with --program a fragment shader.
    #[value(name = "glsl-330", alias = "glsl")]
    Glsl330,
    /// The same in GLSL 450.
    #[value(name = "glsl-450")]
    Glsl450,
    /// The same in GLSL ES 300, for WebGL 2 and phones.
    #[value(name = "glsl-es-300")]
    GlslEs300,
    /// Functions in HLSL, shader model 5 and later; with --program a vertex and a pixel shader.
    Hlsl,
    /// Functions in the Metal shading language; with --program a vertex and a fragment function.
    #[value(alias = "metal")]
    Msl,
    /// A vertex and a fragment shader in SPIR-V.
    #[value(name = "spirv", alias = "spir-v")]
    SpirV,
    /// The Image pass of a shader on shadertoy.com.
    Shadertoy,
    /// A fragment shader for glslViewer.
    #[value(name = "glslviewer")]
    GlslViewer,
    /// A page that draws the scene with WebGL 2.
    #[value(name = "webgl", alias = "html")]
    WebGl,
    /// A page that draws the scene with WebGPU.
    #[value(name = "webgpu")]
    WebGpu,
    /// A folder for Godot 4: a material for the solid and one for the picture, with a scene for each.
    Godot,
    /// The same for Godot 3.
    #[value(name = "godot-3")]
    Godot3,
    /// A crate with materials for Bevy.
    Bevy,
    /// A folder for Blender: a mesh, and a script that imports it with lights, sky and camera.
    Blender,
    /// A generator in the Interactive Shader Format, for VJs' programs.
    Isf,
    /// Modules for three.js, and pages that show them: a folder.
    Three,
    /// A folder for a Unity project: shaders for its Universal and its built-in pipeline.
    Unity,
    /// A folder for Unreal: shader code, and a script that makes a material of it.
    Unreal,
}

/// Which graphics adapter to use.
#[derive(Debug, Args)]
pub(crate) struct AdapterArguments {
    /// Use the adapter whose name contains this, as listed by `chiaro adapters`.
    #[arg(long, value_name = "NAME")]
    pub(crate) adapter: Option<String>,
}

impl AdapterArguments {
    /// The adapter that the command line asks for.
    pub(crate) fn preference(&self) -> Preference {
        self.adapter.clone().map_or(Preference::Any, Preference::Named)
    }
}

/// Arguments of `check`.
#[derive(Debug, Args)]
pub(crate) struct Check {
    #[command(flatten)]
    pub(crate) scene: SceneArguments,
}

/// Arguments of `fmt`.
#[derive(Debug, Args)]
pub(crate) struct Fmt {
    /// The scenes, to be formatted in place; - reads standard input and writes standard output.
    #[arg(required = true, value_name = "FILE")]
    pub(crate) files: Vec<PathBuf>,

    /// Change nothing, but report what is not formatted, and fail if there is any.
    #[arg(long)]
    pub(crate) check: bool,
}

/// Arguments of `dump`.
#[derive(Debug, Args)]
pub(crate) struct Dump {
    #[command(flatten)]
    pub(crate) scene: SceneArguments,

    /// The stage whose result is printed.
    #[arg(long, value_name = "STAGE")]
    pub(crate) stage: Stage,
}

/// The stages of the compiler.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Stage {
    /// The text as it was parsed.
    Syntax,
    /// The shapes and operators that the program came to.
    Solid,
    /// The graph of distances, with what is known of each.
    Field,
    /// The shader code of the scene.
    Wgsl,
}

/// Arguments of `distance`.
#[derive(Debug, Args)]
pub(crate) struct Distance {
    #[command(flatten)]
    pub(crate) scene: SceneArguments,

    /// A file with one JSON object a line, `{"p":[x,y,z]}`, or two coordinates for a plane scene. Use - for standard
    /// input.
    #[arg(long, value_name = "POINTS")]
    pub(crate) points: PathBuf,

    /// Evaluate the shader code on the graphics adapter instead of the CPU. Away from a union of many shapes it answers a bound
    /// of the distance, at least 0.7 times that.
    #[arg(long)]
    pub(crate) gpu: bool,

    #[command(flatten)]
    pub(crate) adapter: AdapterArguments,
}

/// Arguments of `compare`.
#[derive(Debug, Args)]
pub(crate) struct Compare {
    /// The scenes. One without lights is compared under the studio's key light.
    pub(crate) scenes: Vec<PathBuf>,

    /// The folder of the report; one with an earlier report is written over.
    #[arg(long, short, value_name = "FOLDER", default_value = "comparison")]
    pub(crate) output: PathBuf,

    /// Compare on the light suite too: nine scenes under balls of radius 0.15, 0.4 and 0.9, three of them under
    /// rectangles of 0.6x0.3 and 1.6x0.8 as well.
    #[arg(long)]
    pub(crate) suite: bool,

    /// Like figure 4 of Bán, Bálint, Valasek 2019, with its numbers: the light suite at 1920x1080 under balls of radius
    /// 0.25 and rectangles of 0.6x0.3, with 35 and 100 random rays.
    #[arg(long)]
    pub(crate) figure4: bool,

    /// Compare pictures in one pass, as exported shaders draw them, with converged ones of as many samples, and print how alike
    /// they are. Nothing is written.
    #[arg(long, value_name = "SAMPLES", conflicts_with_all = ["suite", "figure4", "output"], requires = "scenes")]
    pub(crate) one_pass: Option<u32>,

    /// Of the suite, compare on these scenes only: primitives,fence.
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    pub(crate) only: Vec<String>,

    /// Set a top-level variable of the scenes, as in -D rectangle=true.
    #[arg(short = 'D', value_name = "NAME=VALUE", value_parser = definition)]
    pub(crate) definitions: Vec<(String, String)>,

    /// The methods, with the number of their cells or rays behind a colon: aaltonen,verified:8,monte-carlo:64.
    #[arg(long, value_name = "METHODS", value_delimiter = ',')]
    pub(crate) methods: Vec<MethodChoice>,

    /// The radii that sphere lights are given, in millimetres.
    #[arg(long, value_name = "RADII", value_delimiter = ',', value_parser = positive)]
    pub(crate) radii: Vec<f64>,

    /// By what lights are scaled instead; as they are, if nothing is said.
    #[arg(long = "scale", value_name = "FACTORS", value_delimiter = ',', value_parser = positive)]
    pub(crate) scales: Vec<f64>,

    /// Width and height in pixels.
    #[arg(long, value_name = "WxH", default_value = "256x256", value_parser = size)]
    pub(crate) size: (u32, u32),

    /// How sure the truth has to be: half the 95 % confidence interval of V.
    #[arg(long, value_name = "HALF-WIDTH", default_value_t = 0.004, value_parser = positive)]
    pub(crate) error: f64,

    /// The most random rays that a pixel draws for the truth.
    #[arg(long, value_name = "N", default_value_t = 1024, value_parser = clap::value_parser!(u32).range(64..=262_144))]
    pub(crate) truth_samples: u32,

    #[command(flatten)]
    pub(crate) adapter: AdapterArguments,
}

/// A shadow method with the number of its cells or rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct MethodChoice {
    pub(crate) method: Shadows,
    pub(crate) cells: u32,
}

impl std::str::FromStr for MethodChoice {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (name, cells) = text.split_once(':').unwrap_or((text, "8"));
        let names = || Shadows::ALL.map(Shadows::name).join(", ");
        let method = Shadows::named(name).ok_or_else(|| format!("there is no method {name}; there are {}", names()))?;
        let cells = cells.parse().ok().filter(|cells| (1..=4096).contains(cells));
        Ok(Self { method, cells: cells.ok_or("behind the colon, write a number from 1 to 4096")? })
    }
}

impl std::fmt::Display for MethodChoice {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.method.name())?;
        if self.method.has_cells() { write!(f, " {}", self.cells) } else { Ok(()) }
    }
}

fn positive(text: &str) -> Result<f64, String> {
    let number = text.trim().parse().ok().filter(|x: &f64| x.is_finite() && *x > 0.0);
    number.ok_or_else(|| "write a number above zero".to_owned())
}

/// How direct light is found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ShadowChoice(pub(crate) Direct);

impl std::str::FromStr for ShadowChoice {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        match Shadows::named(name) {
            Some(method) => Ok(Self(Direct::By(method))),
            None if name == "reference" => Ok(Self(Direct::Sampled)),
            None => {
                let names: Vec<&str> = Shadows::ALL.iter().map(|method| method.name()).collect();
                Err(format!("write {} or reference", names.join(", ")))
            }
        }
    }
}

fn definition(text: &str) -> Result<(String, String), String> {
    match text.split_once('=') {
        Some((name, value)) if !name.trim().is_empty() => Ok((name.trim().to_owned(), value.trim().to_owned())),
        _ => Err("write NAME=VALUE, as in -D width=20".to_owned()),
    }
}

fn size(text: &str) -> Result<(u32, u32), String> {
    let parse = |side: &str| side.trim().parse::<u32>().ok().filter(|side| (1..=16_384).contains(side));
    let sides = text.split_once(['x', 'X', '×']).and_then(|(width, height)| Some((parse(width)?, parse(height)?)));
    sides.ok_or_else(|| "write WIDTHxHEIGHT with sides from 1 to 16384 pixels, as in 960x720".to_owned())
}
