//! How far a method is from the truth.

use serde::Serialize;

use super::ssim;

/// What is behind everything in the shaded picture, and the light that every surface gets there besides.
const BACKGROUND: f32 = 0.55;
const AMBIENT: f32 = 0.06;
const ALBEDO: f32 = 0.75;

/// A method's distance from the truth, and what it cost.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub(crate) struct Score {
    /// The mean and the standard deviation of the local SSIM of V.
    pub(crate) ssim: f64,
    pub(crate) ssim_deviation: f64,
    /// The same of the shaded pictures.
    pub(crate) shaded: f64,
    pub(crate) shaded_deviation: f64,
    /// The same of pictures shaded with the whole integral: with E₀ V/V₀ as pictures are, the truth with E.
    pub(crate) lit: f64,
    pub(crate) lit_deviation: f64,
    /// The mean of the SSIM of V within three pixels of a penumbra.
    pub(crate) penumbra: f64,
    /// Of V over the pixels that see a surface.
    pub(crate) rmse: f64,
    pub(crate) bias: f64,
    pub(crate) most: f64,
    /// Evaluations of the scene for a pixel that sees a surface: their mean and 95th percentile.
    pub(crate) evaluations: f64,
    pub(crate) evaluations_95: f64,
    /// How long it took, in milliseconds.
    pub(crate) milliseconds: f64,
}

impl Score {
    /// The mean of each number.
    pub(crate) fn mean(scores: &[Self]) -> Self {
        let of = |value: fn(&Self) -> f64| scores.iter().map(value).sum::<f64>() / scores.len().max(1) as f64;
        Self {
            ssim: of(|s| s.ssim),
            ssim_deviation: of(|s| s.ssim_deviation),
            shaded: of(|s| s.shaded),
            shaded_deviation: of(|s| s.shaded_deviation),
            lit: of(|s| s.lit),
            lit_deviation: of(|s| s.lit_deviation),
            penumbra: of(|s| s.penumbra),
            rmse: of(|s| s.rmse),
            bias: of(|s| s.bias),
            most: of(|s| s.most),
            evaluations: of(|s| s.evaluations),
            evaluations_95: of(|s| s.evaluations_95),
            milliseconds: of(|s| s.milliseconds),
        }
    }
}

/// What methods are compared with.
pub(crate) struct Reference<'a> {
    pub(crate) width: usize,
    /// Which pixels see a surface.
    pub(crate) mask: &'a [bool],
    /// The true V.
    pub(crate) truth: &'a [f32],
    /// What V is multiplied by in the shaded picture, from 0 to 1.
    pub(crate) shade: &'a [f32],
    /// The true irradiance in the same measure.
    pub(crate) received: &'a [f32],
    /// Whether V counts by irradiance: it is weighed by `shade` then, for at a terminator, where hardly any light
    /// arrives, what part of it is seen means nothing.
    pub(crate) by_irradiance: bool,
}

impl Reference<'_> {
    fn weighed(&self, visible: &[f32]) -> Vec<f32> {
        let weight = |pixel: usize| if self.by_irradiance && self.mask[pixel] { self.shade[pixel] } else { 1.0 };
        visible.iter().enumerate().map(|(pixel, v)| v * weight(pixel)).collect()
    }
}

/// What a method answered.
pub(crate) struct Answer<'a> {
    /// V.
    pub(crate) visible: &'a [f32],
    /// V₀, what is seen if nothing but the horizon is in the way.
    pub(crate) bare: &'a [f32],
    pub(crate) evaluations: &'a [f32],
    pub(crate) milliseconds: f64,
}

/// Scores an answer; also answers its map of local SSIM.
pub(crate) fn score(reference: &Reference, answer: &Answer) -> (Score, Vec<f32>) {
    let Reference { width, mask, truth, shade, .. } = *reference;
    let (visible, truth_weighed) = (reference.weighed(answer.visible), reference.weighed(truth));
    let map = ssim::map(width, &visible, &truth_weighed);
    let of_shaded = ssim::map(width, &shaded(mask, answer.visible, shade), &shaded(mask, truth, shade));
    let (lit, lit_deviation) = lit(reference, answer);
    let (ssim, ssim_deviation) = moments(map.iter().copied());
    let (shaded, shaded_deviation) = moments(of_shaded.iter().copied());
    let near = near_penumbra(width, mask, truth);
    let (penumbra, _) = moments(map.iter().zip(&near).filter(|(_, near)| **near).map(|(s, _)| *s));

    let seen = || mask.iter().enumerate().filter(|(_, seen)| **seen).map(|(pixel, _)| pixel);
    let errors: Vec<f64> = seen().map(|pixel| f64::from(visible[pixel] - truth_weighed[pixel])).collect();
    let count = errors.len().max(1) as f64;
    let mut evaluations: Vec<f64> = seen().map(|pixel| f64::from(answer.evaluations[pixel])).collect();
    evaluations.sort_by(f64::total_cmp);
    let score = Score {
        ssim,
        ssim_deviation,
        shaded,
        shaded_deviation,
        lit,
        lit_deviation,
        penumbra,
        rmse: (errors.iter().map(|e| e * e).sum::<f64>() / count).sqrt(),
        bias: errors.iter().sum::<f64>() / count,
        most: errors.iter().fold(0.0, |most, e| e.abs().max(most)),
        evaluations: evaluations.iter().sum::<f64>() / count,
        evaluations_95: evaluations.get(evaluations.len() * 95 / 100).copied().unwrap_or(0.0),
        milliseconds: answer.milliseconds,
    };
    (score, map)
}

/// Mean and standard deviation of the SSIM of the whole integral.
fn lit(reference: &Reference, answer: &Answer) -> (f64, f64) {
    let Reference { width, mask, shade, received, .. } = *reference;
    let part: Vec<f32> =
        answer.visible.iter().zip(answer.bare).map(|(v, bare)| if *bare > 0.0 { v / bare } else { 0.0 }).collect();
    let whole = vec![1.0; part.len()];
    let map = ssim::map(width, &shaded(mask, &part, shade), &shaded(mask, &whole, received));
    moments(map.iter().copied())
}

/// The picture that is compared besides V: a matt grey under the light, in the sRGB-like curve of exponent 1/2.2.
pub(crate) fn shaded(mask: &[bool], visible: &[f32], shade: &[f32]) -> Vec<f32> {
    let pixel = |i: usize| {
        let linear = if mask[i] { (ALBEDO * visible[i] * shade[i] + AMBIENT).clamp(0.0, 1.0) } else { BACKGROUND };
        linear.powf(1.0 / 2.2)
    };
    (0..mask.len()).map(pixel).collect()
}

/// Mean and standard deviation.
fn moments(values: impl Iterator<Item = f32> + Clone) -> (f64, f64) {
    let count = values.clone().count().max(1) as f64;
    let mean = values.clone().map(f64::from).sum::<f64>() / count;
    let variance = values.map(|x| (f64::from(x) - mean).powi(2)).sum::<f64>() / count;
    (mean, variance.sqrt())
}

/// Which pixels are within three of one in a penumbra, in every direction.
fn near_penumbra(width: usize, mask: &[bool], truth: &[f32]) -> Vec<bool> {
    const REACH: usize = 3;
    let height = mask.len() / width.max(1);
    let mut near = vec![false; mask.len()];
    for y in 0..height {
        for x in 0..width {
            let pixel = y * width + x;
            if !mask[pixel] || !(0.01..0.99).contains(&truth[pixel]) {
                continue;
            }
            for row in y.saturating_sub(REACH)..(y + REACH + 1).min(height) {
                let (first, last) = (x.saturating_sub(REACH), (x + REACH + 1).min(width));
                near[row * width + first..row * width + last].fill(true);
            }
        }
    }
    near
}
