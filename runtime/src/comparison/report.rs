//! The report: a page that opens from disk, with pictures beside it, and the numbers as JSON.

use std::fmt::Write;
use std::path::Path;

use anyhow::{Context, Result};
use serde_json::json;

use super::metrics::{Score, moments, shaded};
use super::{Case, Entry};
use crate::{files, images};

/// The methods that costs and errors are also told as multiples of.
const YARDSTICKS: [&str; 2] = ["aaltonen", "quilez2019"];

/// Writes the report into a folder, which is there.
pub(crate) fn write(folder: &Path, cases: &[Case], device: &str) -> Result<()> {
    for (index, case) in cases.iter().enumerate() {
        pictures(folder, index, case)?;
    }
    let results = serde_json::to_vec_pretty(&results(cases, device)).context("cannot encode the results")?;
    files::write(&folder.join("results.json"), &results)?;
    files::write(&folder.join("index.html"), page(cases, device).as_bytes())
}

/// Every method's mean score over all cases, in the order of the methods.
pub(crate) fn means(cases: &[Case]) -> Vec<(String, Score)> {
    let Some(first) = cases.first() else { return Vec::new() };
    let mean = |at: usize| {
        let of = |value: fn(&Score) -> f64| {
            cases.iter().map(|case| value(&case.entries[at].score)).sum::<f64>() / cases.len() as f64
        };
        Score {
            ssim: of(|s| s.ssim),
            ssim_deviation: of(|s| s.ssim_deviation),
            shaded: of(|s| s.shaded),
            shaded_deviation: of(|s| s.shaded_deviation),
            penumbra: of(|s| s.penumbra),
            rmse: of(|s| s.rmse),
            bias: of(|s| s.bias),
            most: of(|s| s.most),
            evaluations: of(|s| s.evaluations),
            evaluations_95: of(|s| s.evaluations_95),
            milliseconds: of(|s| s.milliseconds),
        }
    };
    first.entries.iter().enumerate().map(|(at, entry)| (entry.method.clone(), mean(at))).collect()
}

/// The table of scores as text.
pub(crate) fn table(scores: &[(String, Score)]) -> String {
    let mut text = format!(
        "{:<22}{:>8}{:>8}{:>9}{:>8}{:>9}{:>8}{:>9}{:>8}{:>9}{:>8}{:>8}\n",
        "method", "SSIM V", "±", "penumbra", "shaded", "±", "RMSE", "bias", "evals", "ms", "×Aalt.", "×Q2019"
    );
    for (method, score) in scores {
        let ratio = |yardstick| cost_ratio(scores, score, yardstick).map_or("–".to_owned(), |x| format!("{x:.2}"));
        let _ = writeln!(
            text,
            "{method:<22}{:>8.4}{:>8.3}{:>9.4}{:>8.4}{:>9.3}{:>8.4}{:>9.4}{:>8.1}{:>9.1}{:>8}{:>8}",
            score.ssim,
            score.ssim_deviation,
            score.penumbra,
            score.shaded,
            score.shaded_deviation,
            score.rmse,
            score.bias,
            score.evaluations,
            score.milliseconds,
            ratio(YARDSTICKS[0]),
            ratio(YARDSTICKS[1]),
        );
    }
    text
}

fn cost_ratio(scores: &[(String, Score)], score: &Score, yardstick: &str) -> Option<f64> {
    let (_, of) = scores.iter().find(|(method, _)| method == yardstick)?;
    (of.evaluations > 0.0).then(|| score.evaluations / of.evaluations)
}

fn scores(case: &Case) -> Vec<(String, Score)> {
    case.entries.iter().map(|entry| (entry.method.clone(), entry.score)).collect()
}

fn results(cases: &[Case], device: &str) -> serde_json::Value {
    let entry = |entry: &Entry| json!({ "method": entry.method, "score": entry.score });
    let case = |case: &Case| {
        json!({
            "case": case.name,
            "size": [case.size.0, case.size.1],
            "truth": { "half_width": case.half_width, "samples": case.samples },
            "methods": case.entries.iter().map(entry).collect::<Vec<_>>(),
        })
    };
    let mean = |(method, score): (String, Score)| json!({ "method": method, "score": score });
    json!({
        "device": device,
        "cases": cases.iter().map(case).collect::<Vec<_>>(),
        "means": means(cases).into_iter().map(mean).collect::<Vec<_>>(),
    })
}

/// The pictures of a case: of V, shaded, and of the local SSIM; and V as numbers.
fn pictures(folder: &Path, index: usize, case: &Case) -> Result<()> {
    let grey = |name: String, values: &[f32]| {
        let pixel = |&value: &f32| {
            let byte = (255.0 * value.clamp(0.0, 1.0)).round() as u8;
            [byte, byte, byte, 255]
        };
        images::write_png(&folder.join(name), case.size, values.iter().flat_map(pixel).collect())
    };
    let numbers = |name: String, values: &[f32]| {
        let rows: Vec<[f32; 4]> = values.iter().map(|&v| [v, v, v, 1.0]).collect();
        images::write_exr(&folder.join(name), case.size, &rows)
    };
    grey(format!("{index}_truth_v.png"), &case.truth)?;
    grey(format!("{index}_truth_shaded.png"), &shaded(&case.mask, &case.truth, &case.shade))?;
    numbers(format!("{index}_truth_v.exr"), &case.truth)?;
    for entry in &case.entries {
        let name = file_name(&entry.method);
        grey(format!("{index}_{name}_v.png"), &entry.visible)?;
        grey(format!("{index}_{name}_shaded.png"), &shaded(&case.mask, &entry.visible, &case.shade))?;
        grey(format!("{index}_{name}_ssim.png"), &entry.map)?;
        numbers(format!("{index}_{name}_v.exr"), &entry.visible)?;
    }
    Ok(())
}

fn file_name(method: &str) -> String {
    method.replace(' ', "_")
}

const STYLE: &str = "
:root { color-scheme: light dark; font: 15px/1.5 system-ui, sans-serif; }
body { margin: 2rem auto; max-width: 90rem; padding: 0 1rem; }
table { border-collapse: collapse; margin: 1rem 0; font-variant-numeric: tabular-nums; }
td, th { padding: .2rem .7rem; text-align: right; border-bottom: 1px solid #8884; }
td:first-child, th:first-child { text-align: left; }
.row { display: flex; gap: .6rem; overflow-x: auto; padding-bottom: .5rem; }
figure { margin: 0; } figure img { display: block; width: 220px; image-rendering: auto; margin-bottom: 3px; }
figcaption { font-size: 13px; } svg { max-width: 100%; } svg text { font: 12px system-ui, sans-serif; fill: currentColor; }
";

fn page(cases: &[Case], device: &str) -> String {
    let means = means(cases);
    let mut html = format!(
        "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>Shadow methods compared</title>\
         <style>{STYLE}</style><body><h1>Shadow methods compared</h1><p>{} cases, on {}. V is the part of the light that \
         is seen; SSIM is that of Wang et al. 2004, the mean ± the standard deviation of its map.</p>",
        cases.len(),
        escaped(device)
    );
    html += "<h2>Means over all cases</h2>";
    html += &html_table(&means);
    html +=
        &plot("Error of V (1 − SSIM) against cost", "evaluations a pixel", &means, |s| (s.evaluations, 1.0 - s.ssim));
    html += &plot("RMSE of V against time", "milliseconds a frame", &means, |s| (s.milliseconds, s.rmse));
    for (index, case) in cases.iter().enumerate() {
        let _ = write!(
            html,
            "<h2>{}</h2><p>{} × {} pixels; truth: {} rays a pixel, 95 % confidence within ±{:.4}.</p>",
            escaped(&case.name),
            case.size.0,
            case.size.1,
            case.samples,
            case.half_width
        );
        html += "<div class=\"row\">";
        html += &figure("truth", &format!("{index}_truth"), false);
        for entry in &case.entries {
            let (mean, deviation) = moments(entry.map.iter().copied());
            let caption = format!("{}: {mean:.4} ± {deviation:.3}", entry.method);
            html += &figure(&caption, &format!("{index}_{}", file_name(&entry.method)), true);
        }
        html += "</div>";
        html += &html_table(&scores(case));
    }
    html + "</body></html>"
}

fn figure(caption: &str, stem: &str, has_map: bool) -> String {
    let caption = escaped(caption);
    let picture = |kind: &str| format!("<img src=\"{stem}_{kind}.png\" alt=\"{caption}, {kind}\" loading=\"lazy\">");
    let map = if has_map { picture("ssim") } else { String::new() };
    format!("<figure>{}{}{map}<figcaption>{caption}</figcaption></figure>", picture("v"), picture("shaded"))
}

fn html_table(scores: &[(String, Score)]) -> String {
    let mut html = "<table><tr><th>method<th>SSIM of V<th>penumbra<th>shaded<th>RMSE<th>bias<th>most<th>evaluations\
                    <th>95 %<th>ms<th>× Aaltonen<th>× Quilez 2019</tr>"
        .to_owned();
    for (method, s) in scores {
        let ratio = |yardstick| cost_ratio(scores, s, yardstick).map_or("–".to_owned(), |x| format!("{x:.2}"));
        let _ = write!(
            html,
            "<tr><td>{}<td>{:.4} ± {:.3}<td>{:.4}<td>{:.4} ± {:.3}<td>{:.4}<td>{:+.4}<td>{:.3}<td>{:.1}<td>{:.0}\
             <td>{:.1}<td>{}<td>{}</tr>",
            escaped(method),
            s.ssim,
            s.ssim_deviation,
            s.penumbra,
            s.shaded,
            s.shaded_deviation,
            s.rmse,
            s.bias,
            s.most,
            s.evaluations,
            s.evaluations_95,
            s.milliseconds,
            ratio(YARDSTICKS[0]),
            ratio(YARDSTICKS[1]),
        );
    }
    html + "</table>"
}

/// A plot with logarithmic axes, error upwards against cost to the right.
fn plot(title: &str, cost_label: &str, scores: &[(String, Score)], of: fn(&Score) -> (f64, f64)) -> String {
    const SIZE: (f64, f64) = (760.0, 380.0);
    const MARGIN: f64 = 48.0;
    let points: Vec<(f64, f64)> = scores.iter().map(|(_, s)| of(s)).map(|(x, y)| (x.max(1e-3), y.max(1e-6))).collect();
    let range = |value: fn(&(f64, f64)) -> f64| {
        let logs = || points.iter().map(|p| value(p).log10());
        let (low, high) = (logs().fold(f64::INFINITY, f64::min), logs().fold(f64::NEG_INFINITY, f64::max));
        (low - 0.1, high + 0.1)
    };
    let (x_range, y_range) = (range(|p| p.0), range(|p| p.1));
    let x_of = |x: f64| MARGIN + (x.log10() - x_range.0) / (x_range.1 - x_range.0) * (SIZE.0 - 3.5 * MARGIN);
    let y_of = |y: f64| SIZE.1 - MARGIN - (y.log10() - y_range.0) / (y_range.1 - y_range.0) * (SIZE.1 - 2.0 * MARGIN);
    let mut svg = format!(
        "<h3>{title}</h3><svg viewBox=\"0 0 {} {}\" width=\"{}\" role=\"img\" aria-label=\"{title}\">",
        SIZE.0, SIZE.1, SIZE.0
    );
    let ticks = |(low, high): (f64, f64)| {
        (low.floor() as i32..=high.ceil() as i32)
            .flat_map(|decade| [1.0, 2.0, 5.0].map(|digit| digit * 10f64.powi(decade)))
            .filter(move |tick| (low..=high).contains(&tick.log10()))
    };
    for tick in ticks(x_range) {
        let x = x_of(tick);
        let (top, bottom) = (MARGIN, SIZE.1 - MARGIN);
        let _ = write!(
            svg,
            "<path d=\"M{x:.1} {top}V{bottom}\" stroke=\"#8884\"/><text x=\"{x:.1}\" y=\"{:.1}\" \
             text-anchor=\"middle\">{tick}</text>",
            bottom + 16.0
        );
    }
    for tick in ticks(y_range) {
        let y = y_of(tick);
        let right = SIZE.0 - 2.5 * MARGIN;
        let _ = write!(
            svg,
            "<path d=\"M{MARGIN} {y:.1}H{right}\" stroke=\"#8884\"/><text x=\"{:.1}\" y=\"{:.1}\" \
             text-anchor=\"end\">{tick}</text>",
            MARGIN - 5.0,
            y + 4.0
        );
    }
    for ((method, _), &(x, y)) in scores.iter().zip(&points) {
        let (x, y) = (x_of(x), y_of(y));
        let color = if method.starts_with("verified") { "#d9480f" } else { "#1971c2" };
        let _ = write!(
            svg,
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\" fill=\"{color}\"/><text x=\"{:.1}\" y=\"{:.1}\">{}</text>",
            x + 7.0,
            y + 4.0,
            escaped(method)
        );
    }
    let _ = write!(svg, "<text x=\"{:.1}\" y=\"{:.1}\">{cost_label}</text></svg>", 0.4 * SIZE.0, SIZE.1 - 8.0);
    svg
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
