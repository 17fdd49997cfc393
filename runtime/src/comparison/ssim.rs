//! Structural similarity.
//!
//! Theory: Wang, Bovik, Sheikh, Simoncelli, "Image Quality Assessment: From Error Visibility to Structural Similarity"
//! (2004), with the paper's settings: a Gaussian window of 11 × 11 pixels with σ = 1.5, K₁ = 0.01, K₂ = 0.03, population
//! covariances, values from 0 to 1.
//! Practice: the window is separable; beyond its edge a picture is mirrored.

/// The standard deviation of the window, and its radius, in pixels.
const SIGMA: f64 = 1.5;
const RADIUS: usize = 5;
const C1: f64 = 0.01 * 0.01;
const C2: f64 = 0.03 * 0.03;

/// The local similarity of two pictures of the same width, at every pixel.
pub(crate) fn map(width: usize, a: &[f32], b: &[f32]) -> Vec<f32> {
    let of = |f: &dyn Fn(f64, f64) -> f64| -> Vec<f64> {
        let values: Vec<f64> = a.iter().zip(b).map(|(&a, &b)| f(f64::from(a), f64::from(b))).collect();
        blurred(width, &values)
    };
    let (mean_a, mean_b) = (of(&|a, _| a), of(&|_, b| b));
    let (aa, bb, ab) = (of(&|a, _| a * a), of(&|_, b| b * b), of(&|a, b| a * b));
    let similarity = |i: usize| {
        let (ma, mb) = (mean_a[i], mean_b[i]);
        let covariance = ab[i] - ma * mb;
        let variances = (aa[i] - ma * ma) + (bb[i] - mb * mb);
        let luminance = (2.0 * ma * mb + C1) / (ma * ma + mb * mb + C1);
        (luminance * (2.0 * covariance + C2) / (variances + C2)) as f32
    };
    (0..a.len()).map(similarity).collect()
}

fn blurred(width: usize, values: &[f64]) -> Vec<f64> {
    let height = values.len() / width.max(1);
    let weights = window();
    let convolved = |count: usize, at: usize, value: &dyn Fn(usize) -> f64| -> f64 {
        weights.iter().enumerate().map(|(k, weight)| weight * value(mirrored(at + k, count))).sum()
    };
    let mut rows = vec![0.0; values.len()];
    for y in 0..height {
        for x in 0..width {
            rows[y * width + x] = convolved(width, x, &|x| values[y * width + x]);
        }
    }
    let mut both = vec![0.0; values.len()];
    for y in 0..height {
        for x in 0..width {
            both[y * width + x] = convolved(height, y, &|y| rows[y * width + x]);
        }
    }
    both
}

fn window() -> [f64; 2 * RADIUS + 1] {
    let weights: [f64; 2 * RADIUS + 1] =
        std::array::from_fn(|k| (-0.5 * ((k as f64 - RADIUS as f64) / SIGMA).powi(2)).exp());
    let sum: f64 = weights.iter().sum();
    weights.map(|weight| weight / sum)
}

/// The pixel `shifted − RADIUS` of a row of `count`, mirrored at both ends with the end pixels repeated.
fn mirrored(shifted: usize, count: usize) -> usize {
    let period = 2 * count;
    let at = (shifted + period * RADIUS - RADIUS) % period;
    if at < count { at } else { period - 1 - at }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_pictures_are_alike_and_opposite_ones_are_not() {
        let ramp: Vec<f32> = (0..256).map(|i| (i % 16) as f32 / 15.0).collect();
        let opposite: Vec<f32> = ramp.iter().map(|x| 1.0 - x).collect();
        assert!(map(16, &ramp, &ramp).iter().all(|s| (s - 1.0).abs() < 1e-6));
        assert!(map(16, &ramp, &opposite).iter().all(|&s| s < 0.5));
    }

    /// Values of scikit-image's `structural_similarity` with the same settings.
    #[test]
    fn it_is_what_others_compute() {
        let a: Vec<f32> = (0..32 * 24).map(|i| ((i % 32) as f32 * 0.3).sin() * 0.5 + 0.5).collect();
        let b: Vec<f32> =
            a.iter().enumerate().map(|(i, x)| (x + 0.1 * ((i / 32) as f32 * 0.7).cos()).clamp(0.0, 1.0)).collect();
        let map = map(32, &a, &b);
        let mean = map.iter().map(|&s| f64::from(s)).sum::<f64>() / map.len() as f64;
        assert!((mean - REFERENCE_MEAN).abs() < 1e-5, "{mean}");
        assert!((f64::from(map[0]) - REFERENCE_CORNER).abs() < 1e-5, "{}", map[0]);
    }

    const REFERENCE_MEAN: f64 = 0.8954545;
    const REFERENCE_CORNER: f64 = 0.9409083;
}
