//! `chiaro compare`: how far the shadow methods are from the truth, and what they cost.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::{Context, Result, bail};
use chiaro_compiler::Scene;
use chiaro_files::{Folders, Temporary};
use chiaro_render::{Gpu, LightRow, Lighting, Model, Receiver, Study, View};
use indicatif::ProgressBar;

use crate::arguments::{Compare, FacetPolicy, Global, MethodChoice, SceneArguments};
use crate::comparison::metrics::{self, Answer, Reference};
use crate::comparison::pictures::Pictures;
use crate::comparison::{Case, Entry, Group, report, suite};
use crate::{compile, files, images, terminal};

pub(crate) fn run(arguments: &Compare, global: &Global) -> Result<ExitCode> {
    if let Some(samples) = arguments.one_pass {
        return super::compare_one_pass::run(arguments, samples, global);
    }
    let mut made = Folders::default();
    let folder = prepared(&arguments.output, &mut made)?;
    let gpu = Gpu::new(&arguments.adapter.preference())?;
    let temporary = Temporary::folder().context("cannot make a temporary folder")?;
    // The suite's scenes are our own.
    files::admit(temporary.path());
    let subjects = subjects(arguments, temporary.path())?;

    let mut cases = Vec::new();
    for (scene, group) in &subjects {
        let compilation = compile::compilation(scene, global)?;
        let Some(solid) = &compilation.scene else { return Ok(ExitCode::FAILURE) };
        let mut subject = Subject::new(&gpu, solid, &scene.file, *group, arguments)?;
        subject.write_receivers(&folder)?;
        let methods = arguments.methods(*group);
        let lights = subject.lights(arguments);
        let progress = terminal::progress(global, lights.len() as u64 * (methods.len() as u64 + 1), &subject.name);
        for (name, light) in lights {
            let place = Place { folder: &folder, index: cases.len() };
            cases.push(subject.case(name, &light, &methods, arguments, &place, &progress)?);
            // Whoever waits for hours can look, and keeps what there is if it is stopped.
            report::write(&folder, &cases, &gpu.description().name)?;
        }
        progress.finish_and_clear();
    }
    if !global.quiet {
        let tables: Vec<String> = report::summaries(&cases).iter().map(report::table).collect();
        std::io::stdout().write_all(tables.join("\n").as_bytes())?;
    }
    terminal::note(global, &format!("the report is {}", folder.join("index.html").display()));
    Ok(ExitCode::SUCCESS)
}

/// The folder of the report: a new one, which is removed again if nothing comes into it, an empty one, or that of an earlier report.
fn prepared(folder: &Path, made: &mut Folders) -> Result<PathBuf> {
    if folder.exists() {
        let mut entries = std::fs::read_dir(folder).with_context(|| format!("cannot read {}", folder.display()))?;
        if entries.next().is_some() && !folder.join("results.json").is_file() {
            bail!("{} is in use for something else: name another folder with --output", folder.display());
        }
    }
    made.make(folder).with_context(|| format!("cannot make the folder {}", folder.display()))?;
    Ok(folder.to_owned())
}

/// What is compared on: the scenes that are named, and those of the suite, which are written into a folder.
fn subjects(arguments: &Compare, folder: &Path) -> Result<Vec<(SceneArguments, Group)>> {
    let scene = |file: &Path, definitions: Vec<(String, String)>| SceneArguments {
        file: file.to_owned(),
        definitions,
        facets: FacetPolicy::Auto,
    };
    let mut subjects: Vec<(SceneArguments, Group)> =
        arguments.scenes.iter().map(|file| (scene(file, arguments.definitions.clone()), Group::Own)).collect();
    for member in arguments.suite_scenes()? {
        let file = folder.join(format!("{}.csg", member.name));
        std::fs::write(&file, member.text).with_context(|| format!("cannot write {}", file.display()))?;
        for group in member.groups() {
            let mut definitions = arguments.definitions.clone();
            if group == Group::Rectangles {
                definitions.push(("rectangle".to_owned(), "true".to_owned()));
            }
            subjects.push((scene(&file, definitions), group));
        }
    }
    if subjects.is_empty() {
        bail!("name scenes to compare the methods on, or ask for the light suite with --suite");
    }
    Ok(subjects)
}

impl Compare {
    fn size(&self) -> (u32, u32) {
        if self.figure4 { suite::FIGURE_SIZE } else { self.size }
    }

    fn methods(&self, group: Group) -> Vec<MethodChoice> {
        if self.methods.is_empty() { suite::methods(group, self.figure4) } else { self.methods.clone() }
    }

    /// The suite's scenes that are asked for.
    fn suite_scenes(&self) -> Result<Vec<&'static suite::SuiteScene>> {
        if let Some(unknown) = self.only.iter().find(|name| suite::SUITE.iter().all(|scene| scene.name != **name)) {
            let names: Vec<&str> = suite::SUITE.iter().map(|scene| scene.name).collect();
            bail!("the suite has no scene {unknown}; it has {}", names.join(", "));
        }
        let is_asked = |scene: &&suite::SuiteScene| self.only.is_empty() || self.only.iter().any(|n| n == scene.name);
        let is_whole = self.suite || self.figure4 || !self.only.is_empty();
        Ok(suite::SUITE.iter().filter(is_asked).filter(|_| is_whole).collect())
    }
}

/// Where a case's pictures go.
struct Place<'a> {
    folder: &'a Path,
    index: usize,
}

/// A scene whose pixels are being lit.
struct Subject {
    name: String,
    group: Group,
    size: (u32, u32),
    study: Study,
    receivers: Vec<Receiver>,
    lighting: Lighting,
}

impl Subject {
    fn new(gpu: &Gpu, scene: &Scene, file: &Path, group: Group, arguments: &Compare) -> Result<Self> {
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
        Ok(Self { name, group, size, study, receivers, lighting })
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
        let is_figure = arguments.figure4;
        let radii: &[f64] = match (&*arguments.radii, self.group) {
            ([], _) if is_figure => &[suite::FIGURE_RADIUS],
            ([], Group::Basic | Group::Hard) => &suite::RADII,
            (radii, _) => radii,
        };
        let scales: &[f64] = match (&*arguments.scales, self.group) {
            ([], Group::Rectangles) if !is_figure => &suite::RECTANGLE_SCALES,
            ([], _) => &[1.0],
            (scales, _) => scales,
        };
        let many = self.lighting.lights.len() > 1;
        let mut lights = Vec::new();
        for (index, source) in self.lighting.lights.iter().enumerate() {
            let name = if many { format!("{}, light {}", self.name, index + 1) } else { self.name.clone() };
            match source.row.sphere_radius() {
                Some(radius) if !radii.is_empty() => {
                    lights.extend(radii.iter().map(|r| (format!("{name}, radius {r}"), source.row.scaled(r / radius))));
                }
                _ => lights.extend(scales.iter().map(|scale| {
                    let lit = if self.group == Group::Rectangles { ", rectangle" } else { "" };
                    let times = if scales.len() > 1 { format!(" × {scale:.2}") } else { String::new() };
                    (format!("{name}{lit}{times}"), source.row.scaled(*scale))
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
        place: &Place,
        progress: &ProgressBar,
    ) -> Result<Case> {
        let mask: Vec<bool> = self.receivers.iter().map(|receiver| receiver.offset >= 0.0).collect();
        // Where there is no surface, nothing is in the way.
        let masked = |visible: &[f32]| -> Vec<f32> {
            visible.iter().zip(&mask).map(|(&v, &seen)| if seen { v.clamp(0.0, 1.0) } else { 1.0 }).collect()
        };
        let truth = self.study.truth(light, arguments.error, arguments.truth_samples)?;
        progress.inc(1);
        let wholes = self.wholes(light, &truth.irradiance);
        let part =
            |of: &[f32]| -> Vec<f32> { of.iter().zip(&wholes).map(|(e, whole)| (e / whole).clamp(0.0, 1.0)).collect() };
        let (shade, received) = (part(&truth.irradiance), part(&truth.received));
        let visible_truth = masked(&truth.visible);
        let Place { folder, index } = *place;
        let pictures = Pictures { folder, index, size: self.size, mask: &mask, shade: &shade };
        pictures.write("truth", &visible_truth)?;
        let reference = Reference {
            width: self.size.0 as usize,
            mask: &mask,
            truth: &visible_truth,
            shade: &shade,
            received: &received,
            by_irradiance: light.round_solid_angle([0.0; 3]).is_none(),
        };
        let mut entries = Vec::new();
        for choice in methods {
            let outcome = self.study.run(choice.method, choice.cells, light)?;
            let visible = masked(&outcome.visible);
            let answer = Answer {
                visible: &visible,
                bare: &outcome.bare,
                evaluations: &outcome.evaluations,
                milliseconds: 1e3 * outcome.time.as_secs_f64(),
            };
            let (score, map) = metrics::score(&reference, &answer);
            let method = choice.to_string();
            pictures.write(&method, &visible)?;
            pictures.write_map(&method, &map)?;
            entries.push(Entry { method, score });
            progress.inc(1);
        }
        Ok(Case {
            name,
            scene: self.name.clone(),
            group: self.group,
            size: self.size,
            half_width: truth.half_width,
            samples: truth.samples,
            mean_samples: truth.mean_samples,
            entries,
        })
    }

    /// What irradiances are told as parts of: the solid angle of a round light, so that a part is its mean cosine, or the
    /// picture's greatest irradiance.
    fn wholes(&self, light: &LightRow, irradiance: &[f32]) -> Vec<f32> {
        let most = irradiance.iter().copied().fold(f32::MIN_POSITIVE, f32::max);
        let whole = |receiver: &Receiver| {
            light.round_solid_angle(receiver.position.map(f64::from)).map_or(most, |solid_angle| solid_angle as f32)
        };
        self.receivers.iter().map(whole).collect()
    }
}
