//! Plots with logarithmic axes as SVG.

use std::fmt::Write;

use super::page::escaped;

const SIZE: (f64, f64) = (860.0, 430.0);
const LEFT: f64 = 76.0;
const RIGHT: f64 = 150.0;
const TOP: f64 = 16.0;
const BOTTOM: f64 = 50.0;
const LABEL_HEIGHT: f64 = 13.0;

/// A method in a plot: how good, and at what cost.
pub(crate) struct Point {
    pub(crate) label: String,
    pub(crate) cost: f64,
    pub(crate) error: f64,
}

/// Errors upwards against costs to the right. The methods of one name that differ in their number are joined.
pub(crate) fn svg(title: &str, cost_label: &str, error_label: &str, points: &[Point]) -> String {
    let points: Vec<&Point> = points.iter().filter(|point| point.cost > 0.0 && point.error > 0.0).collect();
    if points.is_empty() {
        return String::new();
    }
    let (costs, errors) = (Axis::of(points.iter().map(|p| p.cost)), Axis::of(points.iter().map(|p| p.error)));
    let place = |point: &Point| {
        let x = LEFT + costs.part(point.cost) * (SIZE.0 - LEFT - RIGHT);
        (x, SIZE.1 - BOTTOM - errors.part(point.error) * (SIZE.1 - TOP - BOTTOM))
    };
    let mut svg = format!(
        "<figure class=\"plot\"><figcaption>{title}</figcaption><svg viewBox=\"0 0 {} {}\" role=\"img\" \
         aria-label=\"{title}\">",
        SIZE.0, SIZE.1
    );
    grid(&mut svg, &costs, &errors);
    lines(&mut svg, &points, place);
    let places: Vec<(f64, f64)> = points.iter().map(|point| place(point)).collect();
    let mut taken: Vec<Rectangle> = places.iter().map(|&(x, y)| Rectangle::around(x, y, 5.0)).collect();
    for (point, &(x, y)) in points.iter().zip(&places) {
        let class = family(&point.label);
        let label = label_place(x, y, 6.6 * point.label.chars().count() as f64, &taken);
        taken.push(label);
        let _ = write!(
            svg,
            "<circle class=\"{class}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4.5\"><title>{}: {:.4} at {:.1}</title></circle>\
             <text x=\"{:.1}\" y=\"{:.1}\">{}</text>",
            escaped(&point.label),
            point.error,
            point.cost,
            label.left,
            label.bottom - 3.0,
            escaped(&point.label)
        );
    }
    let middle = (TOP + SIZE.1 - BOTTOM) / 2.0;
    let _ = write!(
        svg,
        "<text class=\"axis\" x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{cost_label}</text>\
         <text class=\"axis\" transform=\"translate(16 {middle:.1}) rotate(-90)\" text-anchor=\"middle\">{error_label}\
         </text></svg></figure>",
        (LEFT + SIZE.0 - RIGHT) / 2.0,
        SIZE.1 - 8.0
    );
    svg
}

/// A logarithmic axis.
struct Axis {
    low: f64,
    high: f64,
}

impl Axis {
    fn of(values: impl Iterator<Item = f64>) -> Self {
        let (low, high) =
            values.map(f64::log10).fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        Self { low: low - 0.12, high: high + 0.12 }
    }

    fn part(&self, value: f64) -> f64 {
        (value.log10() - self.low) / (self.high - self.low)
    }

    fn ticks(&self) -> impl Iterator<Item = f64> {
        let decades = self.low.floor() as i32..=self.high.ceil() as i32;
        decades
            .flat_map(|decade| [1.0, 2.0, 5.0].map(|digit| digit * 10f64.powi(decade)))
            .filter(|tick| (self.low..=self.high).contains(&tick.log10()))
    }
}

fn grid(svg: &mut String, costs: &Axis, errors: &Axis) {
    let (right, bottom) = (SIZE.0 - RIGHT, SIZE.1 - BOTTOM);
    for tick in costs.ticks() {
        let x = LEFT + costs.part(tick) * (right - LEFT);
        let _ = write!(
            svg,
            "<path class=\"grid\" d=\"M{x:.1} {TOP}V{bottom}\"/><text class=\"tick\" x=\"{x:.1}\" y=\"{:.1}\" \
             text-anchor=\"middle\">{}</text>",
            bottom + 16.0,
            short(tick)
        );
    }
    for tick in errors.ticks() {
        let y = bottom - errors.part(tick) * (bottom - TOP);
        let _ = write!(
            svg,
            "<path class=\"grid\" d=\"M{LEFT} {y:.1}H{right}\"/><text class=\"tick\" x=\"{:.1}\" y=\"{:.1}\" \
             text-anchor=\"end\">{}</text>",
            LEFT - 6.0,
            y + 4.0,
            short(tick)
        );
    }
}

/// A tick's number without the digits that binary fractions leave.
fn short(tick: f64) -> String {
    let decimals = (-tick.log10().floor()).max(0.0) as usize;
    format!("{tick:.decimals$}")
}

/// Joins what differs in its number only.
fn lines(svg: &mut String, points: &[&Point], place: impl Fn(&Point) -> (f64, f64)) {
    for pair in points.windows(2) {
        let name = |point: &Point| point.label.split_once(' ').map(|(name, _)| name.to_owned());
        if name(pair[0]).is_some() && name(pair[0]) == name(pair[1]) {
            let ((x0, y0), (x1, y1)) = (place(pair[0]), place(pair[1]));
            let class = family(&pair[0].label);
            let _ = write!(svg, "<path class=\"{class} join\" d=\"M{x0:.1} {y0:.1}L{x1:.1} {y1:.1}\"/>");
        }
    }
}

/// What a method is drawn as.
fn family(label: &str) -> &'static str {
    match label.split(' ').next() {
        Some("verified") => "ours",
        Some("monte-carlo" | "proxy") => "random",
        _ => "others",
    }
}

#[derive(Clone, Copy)]
struct Rectangle {
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
}

impl Rectangle {
    fn around(x: f64, y: f64, reach: f64) -> Self {
        Self { left: x - reach, right: x + reach, top: y - reach, bottom: y + reach }
    }

    fn overlap(&self, other: &Self) -> f64 {
        let width = self.right.min(other.right) - self.left.max(other.left);
        let height = self.bottom.min(other.bottom) - self.top.max(other.top);
        width.max(0.0) * height.max(0.0)
    }
}

/// Where a label of this width overlaps others the least: beside its point, or ever farther above or below.
fn label_place(x: f64, y: f64, width: f64, taken: &[Rectangle]) -> Rectangle {
    let at = |left: f64, middle: f64| Rectangle {
        left,
        right: left + width,
        top: middle - 0.5 * LABEL_HEIGHT,
        bottom: middle + 0.5 * LABEL_HEIGHT,
    };
    let shifts = [0.0, -7.0, 7.0, -14.0, 14.0, -21.0, 21.0, -28.0, 28.0];
    let beside = shifts.into_iter().flat_map(|shift| [at(x + 8.0, y + shift), at(x - 8.0 - width, y + shift)]);
    let inside = |place: &Rectangle| place.left > LEFT && place.top > 0.0 && place.bottom < SIZE.1 - BOTTOM;
    let cost = |place: &Rectangle| taken.iter().map(|other| other.overlap(place)).sum::<f64>();
    beside.filter(inside).min_by(|a, b| cost(a).total_cmp(&cost(b))).unwrap_or(at(x + 8.0, y))
}
