//! `chiaro distance`: answers the signed distance at given points.

use std::io::{BufWriter, Write, stdin, stdout};
use std::path::Path;
use std::process::ExitCode;

use anyhow::{Context, Result, bail};
use chiaro_compiler::Scene;
use chiaro_compiler::field::Evaluator;
use chiaro_compiler::solid::Dimension;
use chiaro_render::Gpu;
use serde::Deserialize;
use serde_json::json;

use crate::arguments::{Distance, Global};
use crate::{compile, terminal};

/// A line of the input; what else it says is ignored. Lines without a point, such as a header, are passed over.
#[derive(Deserialize)]
struct Line {
    p: Option<Vec<f64>>,
}

pub(crate) fn run(arguments: &Distance, global: &Global) -> Result<ExitCode> {
    let compilation = compile::compilation(&arguments.scene, global)?;
    let Some(scene) = &compilation.scene else { return Ok(ExitCode::FAILURE) };
    compile::drawn(answer(scene, arguments, global), &compilation.sources, global)
}

fn answer(scene: &Scene, arguments: &Distance, global: &Global) -> Result<ExitCode> {
    let points = read_points(&arguments.points, scene.dimension(), global)?;
    let distances = if arguments.gpu {
        let gpu = Gpu::new(&arguments.adapter.preference())?;
        let distances = chiaro_render::distances(&gpu, &scene.graph, &scene.defaults(), &points)?;
        distances.into_iter().map(f64::from).collect()
    } else {
        on_cpu(scene, &points, global)
    };

    let lipschitz = scene.graph.facts[scene.graph.root.0 as usize].lipschitz;
    let coordinates = if scene.dimension() == Some(Dimension::Plane) { 2 } else { 3 };
    let mut output = BufWriter::new(stdout().lock());
    for (point, distance) in points.iter().zip(distances) {
        // JSON has no infinity: an empty scene is farther than any number.
        let distance = distance.clamp(f64::MIN, f64::MAX);
        let answer = json!({ "p": point[..coordinates], "f": distance, "lipschitz": lipschitz });
        writeln!(output, "{answer}").context("cannot write to standard output")?;
    }
    output.flush().context("cannot write to standard output")?;
    Ok(ExitCode::SUCCESS)
}

fn on_cpu(scene: &Scene, points: &[[f64; 3]], global: &Global) -> Vec<f64> {
    let evaluator = Evaluator::new(&scene.graph, &scene.defaults());
    let progress = terminal::progress(global, points.len() as u64, "distances");
    let distances = points.iter().map(|point| evaluator.distance(*point));
    let distances = progress.wrap_iter(distances).collect();
    progress.finish_and_clear();
    distances
}

/// Reads the points, one a line. What can't be read is an error with the line's number.
fn read_points(path: &Path, dimension: Option<Dimension>, global: &Global) -> Result<Vec<[f64; 3]>> {
    let text = if path == Path::new("-") {
        std::io::read_to_string(stdin()).context("cannot read standard input")?
    } else {
        std::fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))?
    };
    let mut points = Vec::new();
    for (index, line) in text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty()) {
        let place = || format!("{}:{}", path.display(), index + 1);
        let line: Line =
            serde_json::from_str(line).with_context(|| format!("{}: expected {{\"p\":[x,y,z]}}", place()))?;
        let Some(p) = line.p else {
            terminal::note(global, &format!("{}: no \"p\" here; passed over", place()));
            continue;
        };
        points.push(match (p.as_slice(), dimension) {
            (&[x, y, z], _) => [x, y, z],
            (&[x, y], Some(Dimension::Plane) | None) => [x, y, 0.0],
            (&[_, _], Some(Dimension::Space)) => bail!("{}: the scene is solid; give three coordinates", place()),
            (p, _) => bail!("{}: a point has two or three coordinates, not {}", place(), p.len()),
        });
    }
    Ok(points)
}
