//! From what pixels see to colours.

use super::Drawing;
use super::legend::{Legend, Mark, nice};

/// Colours from dark violet by green to yellow, evenly spaced, each lighter than the one before: five of matplotlib's map
/// "viridis".
const HEAT: [[u8; 3]; 5] = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];
/// For slopes of 0, 1/2, 1, 3/2 and 2: blue is too short, red is too long.
const SLOPES: [[u8; 3]; 5] = [[33, 62, 155], [122, 164, 214], [242, 242, 238], [236, 146, 110], [178, 24, 43]];
/// For distances that are exact, exact outside, and bounds.
const CLASSES: [([u8; 3], &str); 3] =
    [([60, 160, 90], "exact"), ([70, 130, 200], "exact outside"), ([225, 140, 45], "a bound")];
/// What all of those fade to where the field is steep, with each doubling.
const STEEP: [u8; 3] = [200, 30, 160];
/// The share of evaluations beyond which they all have the last colour, so that a few pixels don't darken all others.
const MOST_OF_THEM: f64 = 0.995;
/// The width of contours, and of the one at zero, in pixels.
const CONTOUR: f64 = 1.0;
const ZERO: f64 = 2.6;
/// About how many pixels are between contours.
const CONTOUR_SPACING: f64 = 22.0;
const INSIDE: [f64; 3] = [240.0, 178.0, 102.0];
const OUTSIDE: [f64; 3] = [232.0, 238.0, 244.0];
const INK: [f64; 3] = [38.0, 44.0, 58.0];
/// How opaque a section's plane is outside of the scene.
const VEIL: f64 = 0.55;

/// A picture with an opaque colour for each pixel that has one.
fn drawing(size: [u32; 2], colors: impl Iterator<Item = Option<[f64; 3]>>, legend: Legend) -> Drawing {
    let pixels = colors.flat_map(|color| match color {
        Some(color) => opaque(color),
        None => [0; 4],
    });
    Drawing { size, pixels: pixels.collect(), legend }
}

pub(super) fn normals(size: [u32; 2], normals: &[[f32; 4]]) -> Drawing {
    let half = |x: f32| 127.5 + 127.5 * f64::from(x);
    let color = |n: &[f32; 4]| is_seen(n).then(|| [half(n[0]), half(n[1]), half(n[2])]);
    let marks = [([255, 128, 128], "+x"), ([128, 255, 128], "+y"), ([128, 128, 255], "+z")];
    let marks = marks.map(|(color, label)| Mark::of_words(color, label)).to_vec();
    drawing(size, normals.iter().map(color), Legend { title: "normal", marks, step: 0.0 })
}

pub(super) fn depth(size: [u32; 2], positions: &[[f32; 4]]) -> Drawing {
    const FAR: f64 = 40.0;
    let depths = || positions.iter().map(|p| f64::from(p[3])).filter(|depth| *depth >= 0.0);
    let (nearest, farthest) = (depths().fold(f64::INFINITY, f64::min), depths().fold(0.0, f64::max));
    let share = |depth: f64| (depth - nearest) / (farthest - nearest).max(f64::MIN_POSITIVE);
    let grey = |share: f64| 255.0 - (255.0 - FAR) * share;
    let color = |p: &[f32; 4]| (p[3] >= 0.0).then(|| [grey(share(f64::from(p[3]))); 3]);
    let mark = |of: f64| Mark::of_value(bytes([grey(of); 3]), nearest + of * (farthest - nearest));
    let marks = if nearest.is_finite() { [0.0, 0.5, 1.0].map(mark).to_vec() } else { Vec::new() };
    drawing(size, positions.iter().map(color), Legend { title: "depth in mm", marks, step: 0.0 })
}

pub(super) fn evaluations(size: [u32; 2], evaluations: &[u32]) -> Drawing {
    let mut sorted = evaluations.to_vec();
    sorted.sort_unstable();
    let most = sorted.get((MOST_OF_THEM * sorted.len() as f64) as usize).map_or(1.0, |most| f64::from(*most));
    let top = nice(most.max(1.0));
    let color = |count: &u32| Some(along(&HEAT, f64::from(*count) / top));
    let marks = (0..HEAT.len()).map(|at| Mark::of_value(HEAT[at], top * at as f64 / (HEAT.len() - 1) as f64));
    let legend = Legend { title: "evaluations", marks: marks.collect(), step: 0.0 };
    drawing(size, evaluations.iter().map(color), legend)
}

pub(super) fn slopes(size: [u32; 2], positions: &[[f32; 4]], normals: &[[f32; 4]]) -> Drawing {
    let color = |(p, n): (&[f32; 4], &[f32; 4])| (p[3] >= 0.0).then(|| shaded(slope_color(n[3]), n));
    drawing(size, positions.iter().zip(normals).map(color), slope_legend())
}

pub(super) fn section_slopes(size: [u32; 2], sections: &[[f32; 4]]) -> Drawing {
    let plane = Contours { sections, width: size[0] as usize, step: f64::INFINITY };
    let color = |index: usize| Some(mixed(slope_color(sections[index][1]), INK, plane.contour(index)?.zero));
    drawing(size, (0..sections.len()).map(color), slope_legend())
}

fn slope_color(slope: f32) -> [f64; 3] {
    along(&SLOPES, 0.5 * f64::from(slope))
}

fn slope_legend() -> Legend {
    let marks = (0..SLOPES.len()).map(|at| Mark::of_value(SLOPES[at], 0.5 * at as f64));
    Legend { title: "slope of the distance", marks: marks.collect(), step: 0.0 }
}

pub(super) fn classes(size: [u32; 2], classes: &[[f32; 4]], positions: &[[f32; 4]], normals: &[[f32; 4]]) -> Drawing {
    let steepest =
        classes.iter().zip(positions).filter(|(_, p)| p[3] >= 0.0).fold(1.0_f32, |most, (c, _)| most.max(c[3]));
    let color = |((class, p), n): ((&[f32; 4], &[f32; 4]), &[f32; 4])| {
        let at = (0..CLASSES.len()).max_by(|a, b| class[*a].total_cmp(&class[*b]))?;
        let steep = mixed(CLASSES[at].0.map(f64::from), STEEP.map(f64::from), steepness(f64::from(class[3])));
        (p[3] >= 0.0).then(|| shaded(steep, n))
    };
    let mut marks: Vec<Mark> = CLASSES.iter().map(|(color, label)| Mark::of_words(*color, label)).collect();
    if steepest > 1.001 {
        let label = format!("steep: L up to {steepest:.3}");
        let steep = mixed(CLASSES[2].0.map(f64::from), STEEP.map(f64::from), steepness(f64::from(steepest)));
        marks.push(Mark::of_words(bytes(steep), &label));
    }
    let seen = classes.iter().zip(positions).zip(normals).map(color);
    drawing(size, seen, Legend { title: "distances", marks, step: 0.0 })
}

/// How much of the colour of steep fields one of this Lipschitz constant has.
fn steepness(lipschitz: f64) -> f64 {
    1.0 - lipschitz.max(1.0).powi(-2)
}

/// A plane with contours, and behind it, where it is outside, what is seen there.
pub(super) fn section(
    size: [u32; 2],
    sections: &[[f32; 4]],
    positions: &[[f32; 4]],
    normals: &[[f32; 4]],
    pixel_angle: f64,
) -> Drawing {
    let step = contour_step(sections, pixel_angle);
    let plane = Contours { sections, width: size[0] as usize, step };
    let pixels = (0..sections.len()).flat_map(|index| {
        let behind = (positions[index][3] >= 0.0).then(|| shaded([196.0, 198.0, 204.0], &normals[index]));
        let Some((color, opacity)) = plane.color(index) else { return behind.map_or([0; 4], opaque) };
        match behind {
            Some(behind) => opaque(mixed(behind, color, opacity)),
            None => with_opacity(color, opacity),
        }
    });
    let inside = bytes(INSIDE);
    let marks = vec![
        Mark::of_words(inside, "inside"),
        Mark::of_words(bytes(OUTSIDE), "outside"),
        Mark::of_value(bytes(INK), 0.0),
        Mark::of_value(bytes(mixed(OUTSIDE, INK, 0.6)), step),
    ];
    Drawing { size, pixels: pixels.collect(), legend: Legend { title: "distance in mm", marks, step } }
}

/// From one contour to the next, so that they are neither crowded nor rare where the plane is nearest to the typical pixel.
fn contour_step(sections: &[[f32; 4]], pixel_angle: f64) -> f64 {
    let mut depths: Vec<f32> = sections.iter().map(|section| section[2]).filter(|depth| *depth >= 0.0).collect();
    depths.sort_unstable_by(f32::total_cmp);
    let middle = depths.get(depths.len() / 4).map_or(0.0, |depth| f64::from(*depth));
    nice(CONTOUR_SPACING * pixel_angle * middle)
}

/// What is at a pixel of a plane.
struct Contour {
    /// The distance.
    value: f64,
    /// How much of the pixel the contour at zero covers.
    zero: f64,
    /// How much of it any contour covers.
    other: f64,
}

/// The contours of the distance on a plane.
struct Contours<'a> {
    sections: &'a [[f32; 4]],
    /// The picture's width in pixels.
    width: usize,
    step: f64,
}

impl Contours<'_> {
    /// A pixel's colour, and how opaque it is; none where the plane is not seen.
    fn color(&self, index: usize) -> Option<([f64; 3], f64)> {
        let Contour { value, zero, other } = self.contour(index)?;
        let is_inside = value < 0.0;
        // Each band is a little darker than the one nearer to the surface.
        let band = (value.abs() / self.step).floor().min(24.0) / 24.0;
        let ground = mixed(if is_inside { INSIDE } else { OUTSIDE }, INK, 0.35 * band);
        let opacity = if is_inside { 1.0 } else { VEIL + (1.0 - VEIL) * zero };
        Some((mixed(ground, INK, zero.max(0.6 * other)), opacity))
    }

    /// The distance at a pixel and the contours on it; none where the plane is not seen.
    fn contour(&self, index: usize) -> Option<Contour> {
        let value = self.value(index)?;
        // How much the value changes from here to the next pixel.
        let change = |to: Option<usize>| Some((self.value(to?)? - value).abs());
        let is_last = (index + 1).is_multiple_of(self.width);
        let across = change(if is_last { index.checked_sub(1) } else { Some(index + 1) });
        let down = change(Some(index + self.width)).or_else(|| change(index.checked_sub(self.width)));
        let slope = across.unwrap_or(0.0).hypot(down.unwrap_or(0.0)).max(1e-30);
        let line = |off: f64, width: f64| (0.5 + 0.5 * width - off.abs() / slope).clamp(0.0, 1.0);
        // Where contours would be closer than they are wide, there are none.
        let apart = (0.5 * self.step / slope - 1.0).clamp(0.0, 1.0);
        let off = if self.step.is_finite() { value - (value / self.step).round() * self.step } else { value };
        Some(Contour { value, zero: line(value, ZERO), other: line(off, CONTOUR) * apart })
    }

    fn value(&self, index: usize) -> Option<f64> {
        let section = self.sections.get(index)?;
        (section[2] >= 0.0).then_some(f64::from(section[0]))
    }
}

fn is_seen(normal: &[f32; 4]) -> bool {
    normal[..3].iter().any(|component| *component != 0.0)
}

/// A colour on a surface, which is lighter where it looks up.
fn shaded(color: [f64; 3], normal: &[f32; 4]) -> [f64; 3] {
    let [x, y, z] = [0, 1, 2].map(|axis| f64::from(normal[axis]));
    let light = 0.72 + 0.2 * z - 0.08 * x - 0.1 * y;
    color.map(|channel| channel * light)
}

/// The colour at a place from 0 to 1 along evenly spaced ones.
fn along(colors: &[[u8; 3]; 5], place: f64) -> [f64; 3] {
    let place = 4.0 * if place.is_nan() { 0.0 } else { place.clamp(0.0, 1.0) };
    let at = (place.floor() as usize).min(3);
    mixed(colors[at].map(f64::from), colors[at + 1].map(f64::from), place - at as f64)
}

fn mixed(from: [f64; 3], to: [f64; 3], share: f64) -> [f64; 3] {
    [0, 1, 2].map(|channel| from[channel] + share * (to[channel] - from[channel]))
}

fn bytes(color: [f64; 3]) -> [u8; 3] {
    color.map(|channel| channel.round() as u8)
}

fn opaque(color: [f64; 3]) -> [u8; 4] {
    with_opacity(color, 1.0)
}

fn with_opacity(color: [f64; 3], opacity: f64) -> [u8; 4] {
    let [red, green, blue] = bytes(color);
    [red, green, blue, (255.0 * opacity).round() as u8]
}
