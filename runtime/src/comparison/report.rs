//! The report: a page that opens from disk, with pictures beside it, the numbers as JSON, and a table as text.

use std::fmt::Write;
use std::path::Path;

use anyhow::{Context, Result};
use serde_json::json;

use super::metrics::Score;
use super::{Case, Entry, Group, page};
use crate::files;

/// The methods that costs are also told as multiples of, and what they are called.
pub(crate) const YARDSTICKS: [(&str, &str); 2] = [("aaltonen", "Aaltonen"), ("quilez2019", "Quilez 2019")];

/// A part of the cases, and what each method came to on average over it.
pub(crate) struct Summary {
    pub(crate) title: String,
    pub(crate) cases: usize,
    pub(crate) means: Vec<(String, Score)>,
}

/// Writes the report into a folder, which is there.
pub(crate) fn write(folder: &Path, cases: &[Case], device: &str) -> Result<()> {
    let results = serde_json::to_vec_pretty(&results(cases, device)).context("cannot encode the results")?;
    files::write(&folder.join("results.json"), &results)?;
    files::write(&folder.join("index.html"), page::html(cases, device).as_bytes())
}

/// The means over all cases, over each group of them, and over each scene, where these are not the same.
pub(crate) fn summaries(cases: &[Case]) -> Vec<Summary> {
    let all: Vec<&Case> = cases.iter().collect();
    let mut summaries = vec![summary("all cases", &all)];
    let groups = Group::ALL.map(|group| (group, of(cases, |case| case.group == group)));
    let mut parts = Vec::new();
    for (group, of_group) in groups.iter().filter(|(_, cases)| !cases.is_empty()) {
        parts.push(summary(group.title(), of_group));
        let mut scenes: Vec<&str> = of_group.iter().map(|case| &*case.scene).collect();
        scenes.dedup();
        if scenes.len() > 1 {
            parts.extend(scenes.iter().map(|name| {
                let of_scene = of(cases, |case| case.group == *group && case.scene == *name);
                let lit = if *group == Group::Rectangles { " under rectangles" } else { "" };
                summary(&format!("{name}{lit}"), &of_scene)
            }));
        }
    }
    if parts.len() > 1 {
        summaries.extend(parts);
    }
    summaries
}

fn of(cases: &[Case], belongs: impl Fn(&Case) -> bool) -> Vec<&Case> {
    cases.iter().filter(|case| belongs(case)).collect()
}

/// The mean scores of the methods that all of these cases have, in the first one's order.
fn summary(title: &str, cases: &[&Case]) -> Summary {
    let scores_of = |method: &str| -> Option<Vec<Score>> {
        let score = |case: &&Case| case.entries.iter().find(|entry| entry.method == method).map(|entry| entry.score);
        cases.iter().map(score).collect()
    };
    let methods = cases.first().map_or(&[][..], |case| &case.entries[..]);
    let mean = |entry: &Entry| Some((entry.method.clone(), Score::mean(&scores_of(&entry.method)?)));
    Summary { title: title.to_owned(), cases: cases.len(), means: methods.iter().filter_map(mean).collect() }
}

/// The table of scores as text.
pub(crate) fn table(summary: &Summary) -> String {
    let mut text = format!(
        "{} ({})\n{:<22}{:>8}{:>8}{:>9}{:>8}{:>9}{:>8}{:>9}{:>8}{:>9}{:>8}{:>8}\n",
        summary.title,
        summary.cases,
        "method",
        "SSIM V",
        "±",
        "penumbra",
        "shaded",
        "±",
        "RMSE",
        "bias",
        "evals",
        "ms",
        "×Aalt.",
        "×Q2019"
    );
    for (method, score) in &summary.means {
        let [aaltonen, quilez] = ratios(&summary.means, score);
        let _ = writeln!(
            text,
            "{method:<22}{:>8.4}{:>8.3}{:>9.4}{:>8.4}{:>9.3}{:>8.4}{:>9.4}{:>8.1}{:>9.1}{aaltonen:>8}{quilez:>8}",
            score.ssim,
            score.ssim_deviation,
            score.penumbra,
            score.shaded,
            score.shaded_deviation,
            score.rmse,
            score.bias,
            score.evaluations,
            score.milliseconds,
        );
    }
    text
}

/// A method's evaluations as multiples of the yardsticks', or a dash where these are missing.
pub(crate) fn ratios(scores: &[(String, Score)], score: &Score) -> [String; 2] {
    YARDSTICKS.map(|(yardstick, _)| {
        let of = scores.iter().find(|(method, _)| method == yardstick).map(|(_, of)| of.evaluations);
        of.filter(|of| *of > 0.0).map_or("–".to_owned(), |of| format!("{:.2}", score.evaluations / of))
    })
}

fn results(cases: &[Case], device: &str) -> serde_json::Value {
    let entry = |entry: &Entry| json!({ "method": entry.method, "score": entry.score });
    let case = |case: &Case| {
        json!({
            "case": case.name,
            "scene": case.scene,
            "group": case.group.title(),
            "size": [case.size.0, case.size.1],
            "truth": {
                "half_width": case.half_width, "samples": case.samples, "mean_samples": case.mean_samples,
            },
            "methods": case.entries.iter().map(entry).collect::<Vec<_>>(),
        })
    };
    let mean = |(method, score): &(String, Score)| json!({ "method": method, "score": score });
    let means = |summary: &Summary| summary.means.iter().map(mean).collect::<Vec<_>>();
    let summaries = summaries(cases);
    json!({
        "device": device,
        "cases": cases.iter().map(case).collect::<Vec<_>>(),
        "means": summaries.first().map(means),
        "parts": summaries
            .iter()
            .skip(1)
            .map(|part| json!({ "of": part.title, "cases": part.cases, "means": means(part) }))
            .collect::<Vec<_>>(),
    })
}
