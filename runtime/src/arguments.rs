//! The command line.

use std::path::PathBuf;

use chiaro_compiler::shader::Shadows;
use chiaro_render::Direct;
use clap::{Args, Parser, Subcommand, ValueEnum};

use crate::view::View;

/// Compiles CSG scenes to shader code, and draws them.
#[derive(Debug, Parser)]
#[command(version, max_term_width = 100)]
pub(crate) struct Arguments {
    #[command(flatten)]
    pub(crate) global: Global,
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
    /// Draw a scene into a picture.
    Render(Render),
    /// Compile a scene and report what is wrong with it.
    Check(Check),
    /// Print what one stage of the compiler makes of a scene.
    Dump(Dump),
    /// Answer the signed distance at given points.
    Distance(Distance),
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

/// Arguments of `render`.
#[derive(Debug, Args)]
pub(crate) struct Render {
    #[command(flatten)]
    pub(crate) scene: SceneArguments,

    /// The picture: .png, or .exr for linear radiance in 32-bit floating point.
    #[arg(long, short, value_name = "PICTURE")]
    pub(crate) output: PathBuf,

    /// Width and height in pixels.
    #[arg(long, value_name = "WxH", default_value = "960x720", value_parser = size)]
    pub(crate) size: (u32, u32),

    /// Rays a pixel: more of them make shadows and edges smoother.
    #[arg(long, value_name = "N", default_value_t = 64, value_parser = clap::value_parser!(u32).range(1..=65_536))]
    pub(crate) samples: u32,

    /// From where to look: front, back, left, right, top, bottom, diagonal; or OpenSCAD's camera, RX,RY,RZ in degrees
    /// (framed from the bounds) or TX,TY,TZ,RX,RY,RZ,DISTANCE. Otherwise the scene's own view.
    #[arg(long, value_name = "VIEW", allow_hyphen_values = true)]
    pub(crate) view: Option<View>,

    /// How direct light is found: verified (proven cones), another shadow method, or reference (random samples: slow, noisy,
    /// and right).
    #[arg(long, value_name = "METHOD", default_value = "verified")]
    pub(crate) shadows: ShadowChoice,

    /// Leave out the floor below the scene.
    #[arg(long)]
    pub(crate) no_floor: bool,

    /// Draw this many pictures while $t goes from 0 to 1; their numbers are put before the ending of the name.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub(crate) frames: Option<u32>,

    #[command(flatten)]
    pub(crate) adapter: AdapterArguments,
}

/// Which graphics adapter to use.
#[derive(Debug, Args)]
pub(crate) struct AdapterArguments {
    /// Use the adapter whose name contains this, as listed by `chiaro adapters`.
    #[arg(long, value_name = "NAME")]
    pub(crate) adapter: Option<String>,
}

/// Arguments of `check`.
#[derive(Debug, Args)]
pub(crate) struct Check {
    #[command(flatten)]
    pub(crate) scene: SceneArguments,
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

    /// Evaluate the shader code on the graphics adapter instead of the CPU.
    #[arg(long)]
    pub(crate) gpu: bool,

    #[command(flatten)]
    pub(crate) adapter: AdapterArguments,
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
