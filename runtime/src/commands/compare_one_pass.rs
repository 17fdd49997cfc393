//! `chiaro compare --one-pass`: how far pictures in one pass are from converged ones.

use std::io::Write;
use std::process::ExitCode;

use anyhow::Result;
use chiaro_compiler::Scene;
use chiaro_render::{Gpu, Lighting, Model, Picture, View};

use crate::arguments::{Compare, FacetPolicy, Global, SceneArguments};
use crate::comparison::ssim;
use crate::{compile, terminal};

/// How alike two pictures of a scene are, and what the one in one pass cost.
struct Likeness {
    /// The mean of the local SSIM of luma.
    ssim: f64,
    /// The mean absolute difference of red, green and blue, in steps of 8 bits.
    error: f64,
    /// Evaluations of the scene for a ray.
    evaluations: f64,
    milliseconds: f64,
}

pub(crate) fn run(arguments: &Compare, samples: u32, global: &Global) -> Result<ExitCode> {
    let gpu = Gpu::new(&arguments.adapter.preference())?;
    let mut out = std::io::stdout();
    writeln!(out, "scene                      SSIM  mean error  evaluations/ray  ms")?;
    let mut all = Vec::new();
    for file in &arguments.scenes {
        let scene = SceneArguments {
            file: file.clone(),
            definitions: arguments.definitions.clone(),
            facets: FacetPolicy::Auto,
        };
        let Some(scene) = compile::scene(&scene, global)? else { return Ok(ExitCode::FAILURE) };
        let likeness = likeness(&gpu, &scene, arguments.size, samples, global)?;
        let name = file.file_stem().unwrap_or_default().to_string_lossy();
        let Likeness { ssim, error, evaluations, milliseconds } = likeness;
        writeln!(out, "{name:24} {ssim:6.4} {error:11.2} {evaluations:16.1} {milliseconds:5.0}")?;
        all.push(ssim);
    }
    let mean = all.iter().sum::<f64>() / all.len().max(1) as f64;
    let least = all.iter().copied().fold(f64::INFINITY, f64::min);
    writeln!(out, "mean SSIM {mean:.4}, least {least:.4}")?;
    Ok(ExitCode::SUCCESS)
}

fn likeness(gpu: &Gpu, scene: &Scene, size: (u32, u32), samples: u32, global: &Global) -> Result<Likeness> {
    let (graph, values) = (scene.picture(), scene.defaults());
    let model = Model::new(gpu, &graph, &values)?;
    let view = View::framing_model(gpu, &model, &scene.camera, f64::from(size.0) / f64::from(size.1))?;
    let mut picture = Picture::new(gpu, &model, view, [size.0, size.1])?;
    if !scene.lights.is_empty() {
        picture.set_lighting(Lighting::of(&scene.lights, &values, &view))?;
    }
    picture.draw_in_one_pass()?;
    let drawn = picture.resolve()?;
    let evaluations = picture.evaluations()?.sample;
    let milliseconds = 1e3 * picture.timings().sample.as_secs_f64();

    picture.restart()?;
    let progress = terminal::progress(global, u64::from(samples), "samples");
    for _ in 0..samples {
        picture.sample()?;
        progress.inc(1);
    }
    progress.finish_and_clear();
    let converged = picture.resolve()?;

    let [a, b] = [&drawn, &converged].map(|picture| luma(picture));
    let map = ssim::map(size.0 as usize, &a, &b);
    let ssim = map.iter().map(|&s| f64::from(s)).sum::<f64>() / map.len() as f64;
    let difference = |(a, b): (&u8, &u8)| f64::from(a.abs_diff(*b));
    // The fourth channel is always full.
    let error = drawn.iter().zip(&converged).map(difference).sum::<f64>() / (3 * map.len()) as f64;
    Ok(Likeness { ssim, error, evaluations, milliseconds })
}

/// The luma of pixels in sRGB (Rec. 709), from 0 to 1.
fn luma(pixels: &[u8]) -> Vec<f32> {
    let of = |pixel: &[u8]| {
        let [red, green, blue] = [0, 1, 2].map(|i| f32::from(pixel[i]) / 255.0);
        0.2126 * red + 0.7152 * green + 0.0722 * blue
    };
    pixels.chunks_exact(4).map(of).collect()
}
