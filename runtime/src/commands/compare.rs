//! `chiaro compare`: how far the shadow methods are from the truth, and what they cost.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::{Context, Result, bail};
use chiaro_compiler::Scene;
use chiaro_compiler::shader::Shadows;
use chiaro_render::{Gpu, LightRow, Lighting, Model, Receiver, Study, View};
use indicatif::ProgressBar;

use crate::arguments::{Compare, FacetPolicy, Global, MethodChoice, SceneArguments};
use crate::commands::render::preference;
use crate::comparison::metrics::{self, Answer};
use crate::comparison::{Case, Entry, report};
use crate::{compile, images, terminal};

/// The light suite, so that `--suite` works wherever the command is.
const SUITE: [(&str, &str); 5] = [
    ("primitives", include_str!("../../../examples_csg/light/primitives.csg")),
    ("temple", include_str!("../../../examples_csg/light/temple.csg")),
    ("fence", include_str!("../../../examples_csg/light/fence.csg")),
    ("row", include_str!("../../../examples_csg/light/row.csg")),
    ("bounds", include_str!("../../../examples_csg/light/bounds.csg")),
];
/// The radii of the suite's lights, and the size of its pictures; and those of the paper's figure 4.
const SUITE_RADII: [f64; 3] = [0.15, 0.4, 0.9];
const FIGURE_RADIUS: f64 = 0.25;
const FIGURE_SIZE: (u32, u32) = (1920, 1080);

pub(crate) fn run(arguments: &Compare, global: &Global) -> Result<ExitCode> {
    let folder = prepared(&arguments.output)?;
    let gpu = Gpu::new(&preference(&arguments.adapter))?;
    let suite = tempfile::tempdir().context("cannot make a temporary folder")?;
    let files = scene_files(arguments, suite.path())?;
    let methods = arguments.methods();

    let mut cases = Vec::new();
    for file in &files {
        let scene = SceneArguments { file: file.clone(), definitions: Vec::new(), facets: FacetPolicy::Auto };
        let compilation = compile::compilation(&scene, global)?;
        let Some(scene) = &compilation.scene else { return Ok(ExitCode::FAILURE) };
        let mut subject = Subject::new(&gpu, scene, file, arguments)?;
        subject.write_receivers(&folder)?;
        let lights = subject.lights(arguments);
        let progress = terminal::progress(global, lights.len() as u64 * (methods.len() as u64 + 1), "methods");
        for (name, light) in lights {
            cases.push(subject.case(name, &light, &methods, arguments, &progress)?);
        }
        progress.finish_and_clear();
    }
    report::write(&folder, &cases, &gpu.description().name)?;
    if !global.quiet {
        std::io::stdout().write_all(report::table(&report::means(&cases)).as_bytes())?;
    }
    terminal::note(global, &format!("the report is {}", folder.join("index.html").display()));
    Ok(ExitCode::SUCCESS)
}

/// The folder of the report: a new one, an empty one, or that of an earlier report.
fn prepared(folder: &Path) -> Result<PathBuf> {
    if folder.exists() {
        let mut entries = std::fs::read_dir(folder).with_context(|| format!("cannot read {}", folder.display()))?;
        if entries.next().is_some() && !folder.join("results.json").is_file() {
            bail!("{} is in use for something else: name another folder with --output", folder.display());
        }
    }
    std::fs::create_dir_all(folder).with_context(|| format!("cannot make the folder {}", folder.display()))?;
    Ok(folder.to_owned())
}

fn scene_files(arguments: &Compare, folder: &Path) -> Result<Vec<PathBuf>> {
    let mut files = arguments.scenes.clone();
    if arguments.suite || arguments.figure4 {
        for (name, text) in SUITE {
            let file = folder.join(format!("{name}.csg"));
            std::fs::write(&file, text).with_context(|| format!("cannot write {}", file.display()))?;
            files.push(file);
        }
    }
    if files.is_empty() {
        bail!("name scenes to compare the methods on, or ask for the light suite with --suite");
    }
    Ok(files)
}

impl Compare {
    fn size(&self) -> (u32, u32) {
        if self.figure4 { FIGURE_SIZE } else { self.size }
    }

    fn methods(&self) -> Vec<MethodChoice> {
        if !self.methods.is_empty() {
            return self.methods.clone();
        }
        let with =
            |method, cells: &[u32]| cells.iter().map(move |&cells| MethodChoice { method, cells }).collect::<Vec<_>>();
        let rays: &[u32] = if self.figure4 { &[35, 100] } else { &[16, 64] };
        let single = Shadows::ALL.into_iter().filter(|method| !method.has_cells());
        let mut methods: Vec<MethodChoice> = single.flat_map(|method| with(method, &[1])).collect();
        methods.extend(with(Shadows::Verified, &[1, 4, 8, 12, 19, 37]));
        methods.extend(with(Shadows::Proxy, rays));
        methods.extend(with(Shadows::MonteCarlo, rays));
        methods
    }
}

/// A scene whose pixels are being lit.
struct Subject {
    name: String,
    size: (u32, u32),
    study: Study,
    receivers: Vec<Receiver>,
    lighting: Lighting,
}

impl Subject {
    fn new(gpu: &Gpu, scene: &Scene, file: &Path, arguments: &Compare) -> Result<Self> {
        let values = scene.defaults();
        let size = arguments.size();
        let model = Model::new(gpu, &scene.picture(), &values)?;
        let aspect = f64::from(size.0) / f64::from(size.1);
        let view = View::framing(&scene.camera, &values, &model.extent(gpu)?, aspect);
        let lighting = match scene.lights.as_slice() {
            [] => Lighting::studio(view.rotation[2].to_radians()),
            lights => Lighting::of(lights, &values, &view),
        };
        let study = Study::new(gpu, &model, view, [size.0, size.1])?;
        let receivers = study.receivers()?;
        let name = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        Ok(Self { name, size, study, receivers, lighting })
    }

    /// Where the pixels' surfaces are, and how they face, so that others can check the truth.
    fn write_receivers(&self, folder: &Path) -> Result<()> {
        let wide = |v: [f32; 3]| [v[0], v[1], v[2], 1.0];
        let offset_points: Vec<[f32; 4]> = self
            .receivers
            .iter()
            .map(|r| wide([0, 1, 2].map(|i| r.position[i] + r.offset.max(0.0) * r.normal[i])))
            .collect();
        let normals: Vec<[f32; 4]> =
            self.receivers.iter().map(|r| if r.offset < 0.0 { [0.0; 4] } else { wide(r.normal) }).collect();
        images::write_exr(&folder.join(format!("{}_points.exr", self.name)), self.size, &offset_points)?;
        images::write_exr(&folder.join(format!("{}_normals.exr", self.name)), self.size, &normals)
    }

    /// The scene's lights in the sizes asked for, with what to call them.
    fn lights(&self, arguments: &Compare) -> Vec<(String, LightRow)> {
        let radii: &[f64] = match (&*arguments.radii, arguments.figure4, arguments.suite) {
            ([], true, _) => &[FIGURE_RADIUS],
            ([], false, true) => &SUITE_RADII,
            (radii, ..) => radii,
        };
        let many = self.lighting.lights.len() > 1;
        let mut lights = Vec::new();
        for (index, source) in self.lighting.lights.iter().enumerate() {
            let name = if many { format!("{}, light {}", self.name, index + 1) } else { self.name.clone() };
            match source.row.sphere_radius() {
                Some(radius) if !radii.is_empty() => {
                    lights.extend(radii.iter().map(|r| (format!("{name}, radius {r}"), source.row.scaled(r / radius))));
                }
                _ => lights.extend(arguments.scales.iter().map(|scale| {
                    let name = if arguments.scales.len() > 1 { format!("{name}, × {scale}") } else { name.clone() };
                    (name, source.row.scaled(*scale))
                })),
            }
        }
        lights
    }

    fn case(
        &mut self,
        name: String,
        light: &LightRow,
        methods: &[MethodChoice],
        arguments: &Compare,
        progress: &ProgressBar,
    ) -> Result<Case> {
        let mask: Vec<bool> = self.receivers.iter().map(|receiver| receiver.offset >= 0.0).collect();
        // Where there is no surface, nothing is in the way.
        let masked = |visible: &[f32]| -> Vec<f32> {
            visible.iter().zip(&mask).map(|(&v, &seen)| if seen { v.clamp(0.0, 1.0) } else { 1.0 }).collect()
        };
        let truth = self.study.truth(light, arguments.error, arguments.truth_samples)?;
        progress.inc(1);
        let shade = self.shade(light, &truth.irradiance);
        let visible_truth = masked(&truth.visible);
        let mut entries = Vec::new();
        for choice in methods {
            let outcome = self.study.run(choice.method, choice.cells, light)?;
            let visible = masked(&outcome.visible);
            let answer = Answer {
                visible: &visible,
                evaluations: &outcome.evaluations,
                milliseconds: 1e3 * outcome.time.as_secs_f64(),
            };
            let (score, map) = metrics::score(self.size.0 as usize, &mask, &visible_truth, &shade, &answer);
            entries.push(Entry { method: choice.to_string(), visible, map, score });
            progress.inc(1);
        }
        Ok(Case {
            name,
            size: self.size,
            mask,
            truth: visible_truth,
            shade,
            half_width: truth.half_width,
            samples: truth.samples,
            entries,
        })
    }

    /// The mean clamped cosine over a round light, or the irradiance of another as a part of the picture's greatest.
    fn shade(&self, light: &LightRow, irradiance: &[f32]) -> Vec<f32> {
        let most = irradiance.iter().copied().fold(f32::MIN_POSITIVE, f32::max);
        let whole = |receiver: &Receiver| match light.round_solid_angle(receiver.position.map(f64::from)) {
            Some(solid_angle) => solid_angle as f32,
            None => most,
        };
        irradiance.iter().zip(&self.receivers).map(|(e, receiver)| (e / whole(receiver)).clamp(0.0, 1.0)).collect()
    }
}
