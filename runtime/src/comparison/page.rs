//! The report's page. It needs nothing but the pictures beside it.

use std::fmt::Write;

use super::metrics::Score;
use super::pictures::stem;
use super::plot::{self, Point};
use super::published::FIGURE4;
use super::report::{Summary, YARDSTICKS, ratios, summaries};
use super::{Case, Group, suite};

const STYLE: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("page.js");

pub(crate) fn html(cases: &[Case], device: &str) -> String {
    let summaries = summaries(cases);
    let mut html = format!(
        "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\">\
         <meta name=\"viewport\" content=\"width=device-width\"><title>Shadow methods compared</title>\
         <style>{STYLE}</style><body><h1>Shadow methods compared</h1><p>{} cases on {}. V is the part of a light that a \
         point sees. SSIM compares it, and a picture shaded with it, with the truth from random rays \
         (<a href=\"#how\">how</a>); ± is the standard deviation of the map of local SSIM.</p>",
        cases.len(),
        escaped(device)
    );
    for (index, summary) in summaries.iter().enumerate() {
        means(&mut html, summary, index == 0);
    }
    if cases.iter().any(|case| case.size == suite::FIGURE_SIZE) {
        published(&mut html, cases);
    }
    html += "<h2>Cases</h2><nav>";
    for (index, case) in cases.iter().enumerate() {
        let _ = write!(html, "<a href=\"#case{index}\">{}</a>", escaped(&case.name));
    }
    html += "</nav>";
    for (index, case) in cases.iter().enumerate() {
        of_case(&mut html, index, case);
    }
    html += HOW;
    let _ = write!(html, "<script>{SCRIPT}</script></body></html>");
    html
}

pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// The means over some cases: a table and plots, folded away if they are not the first.
fn means(html: &mut String, summary: &Summary, is_first: bool) {
    let title = format!("Means over {} ({})", escaped(&summary.title), summary.cases);
    if is_first {
        let _ = write!(html, "<h2>{title}</h2>");
    } else {
        let _ = write!(html, "<details><summary>{title}</summary>");
    }
    *html += &table(&summary.means);
    *html += "<div class=\"plots\">";
    *html +=
        &plot_of("Error against work", "evaluations of the scene a pixel", "1 − SSIM of V", &summary.means, |s| {
            (s.evaluations, 1.0 - s.ssim)
        });
    *html += &plot_of("Error against time", "milliseconds a frame", "RMSE of V", &summary.means, |s| {
        (s.milliseconds, s.rmse)
    });
    *html += if is_first { "</div>" } else { "</div></details>" };
}

fn plot_of(title: &str, cost: &str, error: &str, scores: &[(String, Score)], of: fn(&Score) -> (f64, f64)) -> String {
    let point = |(label, score): &(String, Score)| {
        let (cost, error) = of(score);
        Point { label: label.clone(), cost, error }
    };
    plot::svg(title, cost, error, &scores.iter().map(point).collect::<Vec<_>>())
}

/// What the paper printed below its figure, and what came out here.
fn published(html: &mut String, cases: &[Case]) {
    *html += "<h2>Beside figure 4</h2><p>Bán, Bálint, Valasek, “Area Lights in Signed Distance Function Scenes” \
              (Eurographics 2019 short papers) printed the SSIM of shaded pictures of another scene, at 1920 × 1080 on a \
              GeForce 1070 Ti. Times are also told as multiples of the first row's for balls, and of full Monte Carlo's \
              with 100 rays for rectangles: such ratios depend less on the machine.</p><div class=\"scroll\"><table><tr>\
              <th>picture<th class=\"text\">of the paper<th>SSIM<th>ms<th>ratio<th class=\"text\">here<th>SSIM<th>ms\
              <th>ratio</tr>";
    for row in &FIGURE4 {
        let group_matches = |case: &&Case| (case.group == Group::Rectangles) == row.is_rectangle;
        let score = |method: &str| -> Option<Score> {
            let scores: Option<Vec<Score>> = cases
                .iter()
                .filter(group_matches)
                .map(|case| case.entries.iter().find(|entry| entry.method == method).map(|entry| entry.score))
                .collect();
            scores.filter(|scores| !scores.is_empty()).map(|scores| Score::mean(&scores))
        };
        let (yardstick, of) = if row.is_rectangle { ("monte-carlo 100", 52.7) } else { ("aaltonen", 1.32) };
        let _ = write!(
            html,
            "<tr><td>{}<td class=\"text\">{}<td>{}<td>{:.2}<td>{:.2}<td class=\"text\">{}{}</tr>",
            row.picture,
            row.what,
            row.shaded.map_or("–".to_owned(), |(mean, deviation)| format!("{mean:.4} ± {deviation:.3}")),
            row.milliseconds,
            row.milliseconds / of,
            row.method,
            measured(score(row.method), score(yardstick)),
        );
    }
    *html += "</table></div>";
}

fn measured(score: Option<Score>, yardstick: Option<Score>) -> String {
    let Some(score) = score else { return "<td>–<td>–<td>–".to_owned() };
    let ratio = yardstick.map_or("–".to_owned(), |of| format!("{:.2}", score.milliseconds / of.milliseconds));
    let shaded = format!("{:.4} ± {:.3}", score.shaded, score.shaded_deviation);
    format!("<td>{shaded}<td>{:.1}<td>{ratio}", score.milliseconds)
}

fn of_case(html: &mut String, index: usize, case: &Case) {
    let _ = write!(
        html,
        "<h2 id=\"case{index}\">{}</h2><p>{} × {} pixels. Truth: {} rays a pixel near penumbrae ({:.0} on average); of \
         the pixels in penumbrae, 99 % have 95 % confidence intervals within ±{:.4}.</p>",
        escaped(&case.name),
        case.size.0,
        case.size.1,
        case.samples,
        case.mean_samples,
        case.half_width
    );
    viewer(html, index, case);
    let scores: Vec<(String, Score)> = case.entries.iter().map(|e| (e.method.clone(), e.score)).collect();
    *html += &table(&scores);
}

/// Two answers to wipe between, and all of them side by side.
fn viewer(html: &mut String, index: usize, case: &Case) {
    let truth = stem(index, "truth");
    let names: Vec<&str> = std::iter::once("truth").chain(case.entries.iter().map(|e| &*e.method)).collect();
    let chosen = names.iter().find(|name| **name == "verified 8").or(names.get(1)).copied().unwrap_or("truth");
    let options = |selected: &str| -> String {
        let option = |name: &&str| {
            let is_selected = if *name == selected { " selected" } else { "" };
            format!("<option value=\"{}\"{is_selected}>{}</option>", stem(index, name), escaped(name))
        };
        names.iter().map(option).collect()
    };
    let wide = if case.size.0 > case.size.1 { " wide" } else { "" };
    let _ = write!(
        html,
        "<div class=\"viewer\"><div><div class=\"controls\"><label>left <select>{}</select></label><label>right \
         <select>{}</select></label><label>as <select><option value=\"shaded\">shaded</option><option value=\"v\">V\
         </option><option value=\"ssim\">SSIM map of V</option></select></label></div>\
         <div class=\"stage{wide}\" tabindex=\"0\" title=\"Move to wipe, wheel to zoom, double click to see all\">\
         <div class=\"half\"><img src=\"{truth}_shaded.png\" alt=\"left\"></div>\
         <div class=\"half\"><img src=\"{}_shaded.png\" alt=\"right\"></div>\
         <i></i><b class=\"left\">truth</b><b class=\"right\">{}</b></div></div><div class=\"sheet\">",
        options("truth"),
        options(chosen),
        stem(index, chosen),
        escaped(chosen)
    );
    for entry in &case.entries {
        let (stem, score) = (stem(index, &entry.method), &entry.score);
        let is_chosen = if entry.method == chosen { " class=\"chosen\"" } else { "" };
        let _ = write!(
            html,
            "<figure{is_chosen} data-stem=\"{stem}\"><img src=\"{stem}_shaded.png\" alt=\"{0}\" loading=\"lazy\">\
             <figcaption>{0}<br>{1:.4} ± {2:.3}, {3:.1} ev.</figcaption></figure>",
            escaped(&entry.method),
            score.ssim,
            score.ssim_deviation,
            score.evaluations
        );
    }
    *html += "</div></div>";
}

fn table(scores: &[(String, Score)]) -> String {
    let best = |of: fn(&Score) -> f64| scores.iter().map(|(_, s)| of(s)).fold(f64::NEG_INFINITY, f64::max);
    let (best_ssim, best_shaded) = (best(|s| s.ssim), best(|s| s.shaded));
    let mark = |is_best: bool| if is_best { " class=\"best\"" } else { "" };
    let mut html = format!(
        "<div class=\"scroll\"><table><tr><th>method<th>SSIM of V<th>in penumbrae<th>shaded<th>lit<th>RMSE<th>bias<th>worst\
         <th>evaluations<th>95 %<th>ms<th>× {}<th>× {}</tr>",
        YARDSTICKS[0].1, YARDSTICKS[1].1
    );
    for (method, s) in scores {
        let [aaltonen, quilez] = ratios(scores, s);
        let class = if method.starts_with("verified") { " class=\"ours\"" } else { "" };
        let _ = write!(
            html,
            "<tr{class}><td>{}<td{}>{:.4} <small>± {:.3}</small><td>{:.4}<td{}>{:.4} <small>± {:.3}</small><td>{:.4} <small>± {:.3}</small><td>{:.4}\
             <td>{:+.4}<td>{:.3}<td>{:.1}<td>{:.0}<td>{:.1}<td>{aaltonen}<td>{quilez}</tr>",
            escaped(method),
            mark(s.ssim == best_ssim),
            s.ssim,
            s.ssim_deviation,
            s.penumbra,
            mark(s.shaded == best_shaded),
            s.shaded,
            s.shaded_deviation,
            s.lit,
            s.lit_deviation,
            s.rmse,
            s.bias,
            s.most,
            s.evaluations,
            s.evaluations_95,
            s.milliseconds,
        );
    }
    html + "</table></div>"
}

const HOW: &str = "<h2 id=\"how\">How this was measured</h2>
<p><b>Truth.</b> V by random rays in eight independently scrambled Sobol' sequences. Of balls it is the part of the solid \
angle, of flat lights and tubes the part of the irradiance, with the point's own horizon counted as cover. Each point draws \
64 rays; those go on that see part of the light, or have one within three pixels that does or that sees otherwise, until \
Student's 95 % interval over the eight means is as narrow as was asked or the rays run out.</p>
<p><b>SSIM</b> is that of Wang, Bovik, Sheikh, Simoncelli (2004): a Gaussian window of 11 × 11 with σ = 1.5, K₁ = 0.01, K₂ = 0.03. \
“In penumbrae” is its mean within three pixels of one. The shaded picture is (0.75 V E₀/Ω + 0.06)<sup>1/2.2</sup> of a matt \
grey on a background of 0.55; “lit” is the same picture with the whole integral in it: E by random rays in the truth, \
E₀ V/V₀ of the methods, as pictures are lit. E₀ is the irradiance of the uncovered light and Ω its solid angle, or the greatest E₀ of a flat \
light. V of flat lights and tubes is compared as V E₀/Ω: at a terminator, where hardly any light arrives, V means nothing.</p>
<p><b>Cost.</b> Evaluations of the scene for a pixel that sees a surface, their mean and 95th percentile; milliseconds by the \
device's timestamps, or by the processor's clock on software adapters, without compiling.</p>
<p><b>Methods.</b> quilez2010 and quilez2019: Quilez's articles on soft shadows of distance fields, of 2010 and 2019. aaltonen: \
Aaltonen, GDC 2018. cone: Bálint and Valasek 2018. minimal-cone and its kin, proxy: Bán, Bálint, Valasek 2019. monte-carlo: \
Sobol' sequences scrambled after Owen, rectangles after Ureña, Fajardo, King 2013. verified: verified cones, with the number of \
the light's cells.</p>";
