//! Fits the table of `templates/gloss.wgsl`: linearly transformed cosines for the glossy lobe of our surfaces.
//!
//! ```sh
//! cargo run --release -p chiaro_shader --example fit_gloss -- compiler/shader/templates/gloss.bin
//! ```
//!
//! Theory: Heitz, Dupuy, Hill, Neubelt, "Real-Time Polygonal-Light Shading with Linearly Transformed Cosines", 2016.
//! Changes: The matrix is written in the frame of the mirror image's direction and without the factor α, so that it is
//! smooth down to mirrors and few entries do. What is fitted is the part above the horizon, because that is what the
//! shader takes. The distance is ∫ (f − g)² / (f + g): in proportion to the lobe, and finite everywhere.
//! Practice: nothing is random; two runs on the same machine write the same bytes.

mod lobe;
mod ltc;
mod minimize;
mod vector;

use std::io::Write;
use std::path::PathBuf;

use lobe::{GRID, Lobe, squares};
use ltc::Ltc;
use minimize::minimized;

/// The edge of the table, the least roughness and the least cosine in it: those of `templates/gloss.wgsl`.
const EDGE: usize = 32;
const LEAST_ROUGHNESS: f64 = 0.03;
const LEAST_COSINE: f64 = 0.01;

/// What it costs to stray from the neighbours.
const STIFFNESS: f64 = 1e-3;

/// The logarithm of a; b/α and c/α; the logarithm of d/α.
type Parameters = [f64; 4];

fn main() -> std::io::Result<()> {
    let Some(path) = std::env::args_os().nth(1).map(PathBuf::from) else {
        return Err(std::io::Error::other("say where to write the table"));
    };
    let mut bytes = Vec::new();
    for row in table() {
        row.into_iter().for_each(|number| bytes.extend((number as f32).to_le_bytes()));
    }
    std::fs::write(path, bytes)
}

/// For each roughness the rows of all angles: a, b/α, c/α, d/α; the albedo, its grazing part, 0, 0.
fn table() -> Vec<[f64; 8]> {
    let mut rows: Vec<[f64; 8]> = Vec::new();
    let mut smoother: Vec<Parameters> = Vec::new();
    for i in 0..EDGE {
        let part = i as f64 / (EDGE - 1) as f64;
        let roughness = LEAST_ROUGHNESS + (1.0 - LEAST_ROUGHNESS) * part;
        let mut fits: Vec<Parameters> = Vec::new();
        let mut worst = 0.0_f64;
        for j in 0..EDGE {
            // Evenly in √(1 − cos θ).
            let x = j as f64 / (EDGE - 1) as f64;
            let cosine = 1.0 - (1.0 - LEAST_COSINE) * x * x;
            let lobe = Lobe::new(roughness * roughness, cosine);
            // Where neighbours are, start from those; the first is a mirror's, twice as wide across as along the plane.
            let neighbours = match (smoother.get(j), fits.last()) {
                (Some(one), Some(other)) => vec![*one, *other],
                (None, Some(_)) | (None, None) => vec![[cosine.ln(), 0.0, 0.0, (2.0 * cosine).ln()]],
                (Some(one), None) => vec![*one],
            };
            let (fit, distance) = fitted(&lobe, &neighbours);
            let albedo = lobe.albedo();
            let Ltc { a, b, c, d } = ltc(fit, 1.0);
            rows.push([a, b, c, d, albedo.whole, albedo.grazing, 0.0, 0.0]);
            fits.push(fit);
            worst = worst.max(distance);
        }
        // Says how far it is; a pipe that is gone doesn't matter.
        let _ = writeln!(std::io::stderr(), "roughness {roughness:.3}: distances up to {worst:.4}");
        smoother = fits;
    }
    rows
}

/// The best of the fits from these starts. Where the lobe hardly cares, it stays near them, so that what is between two
/// entries is as good as they are.
fn fitted(lobe: &Lobe, starts: &[Parameters]) -> (Parameters, f64) {
    let whole = lobe.albedo().whole;
    let middle = |k: usize| starts.iter().map(|start| start[k]).sum::<f64>() / starts.len() as f64;
    let strays = |parameters: &Parameters| (0..4).map(|k| (parameters[k] - middle(k)).powi(2)).sum::<f64>();
    let objective = |parameters: &Parameters| {
        distance(lobe, whole, &ltc(*parameters, lobe.alpha())) + STIFFNESS * strays(parameters)
    };
    starts
        .iter()
        .map(|start| minimized(*start, 0.1, 400, objective))
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .unwrap_or(([0.0; 4], f64::INFINITY))
}

fn ltc([a, b, c, d]: Parameters, alpha: f64) -> Ltc {
    Ltc { a: a.exp(), b: b * alpha, c: c * alpha, d: d.exp() * alpha }
}

/// ∫ (f − g)² / (f + g) / 2 over the directions above the horizon, by samples of both.
fn distance(lobe: &Lobe, whole: f64, ltc: &Ltc) -> f64 {
    let of_direction = |w| {
        let (f, g) = (lobe.value(w) / whole, ltc.density(lobe, w));
        if f + g > 0.0 { ((f - g) / (f + g)).powi(2) } else { 0.0 }
    };
    let of_square = |u| of_direction(lobe.drawn(u).0) + of_direction(ltc.drawn(lobe, u));
    squares(GRID).map(of_square).sum::<f64>() / (GRID * GRID) as f64
}
