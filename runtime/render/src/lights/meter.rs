//! An incident-light meter: how a photographer exposes for a scene without looking at its surfaces.

use chiaro_vocabulary::Bounds;

use super::{LightRow, Lighting, QUAD, SUN, Surroundings, TUBE, difference, length, twice_area};

/// What a white surface in the metered light comes to in the picture.
const WHITE: f64 = 0.85;

/// The factor from radiance to the picture: the median, over points spread in the box, of what a white surface facing
/// the light there would send back, comes to [`WHITE`]. 1 in the dark.
pub(crate) fn exposure(lighting: &Lighting, bounds: &Bounds) -> f64 {
    let mut readings: Vec<f64> = points(bounds).map(|point| irradiance(lighting, point)).collect();
    readings.sort_by(f64::total_cmp);
    let median = readings[readings.len() / 2];
    if median > 0.0 && median.is_finite() { WHITE * std::f64::consts::PI / median } else { 1.0 }
}

/// 3 × 3 × 3 points of the box.
fn points(bounds: &Bounds) -> impl Iterator<Item = [f64; 3]> + '_ {
    let (centre, size) = (bounds.center(), bounds.size());
    (0..27).map(move |i| {
        let step = [i % 3, i / 3 % 3, i / 9].map(|k| f64::from(k) - 1.0);
        [0, 1, 2].map(|axis| centre[axis] + 0.4 * step[axis] * size[axis])
    })
}

/// The luminous irradiance at a point, if it faced every light.
fn irradiance(lighting: &Lighting, point: [f64; 3]) -> f64 {
    let pi = std::f64::consts::PI;
    let sky = match lighting.surroundings {
        Surroundings::Studio => 0.5,
        Surroundings::Sky { zenith, horizon, .. } => 0.5 * (luminance(zenith) + luminance(horizon)),
    };
    let from_lights: f64 = lighting.lights.iter().map(|light| of_light(&light.row, point)).sum();
    pi * sky + from_lights
}

/// A light's illuminance at a point that faces it, about: radiance times area over the distance squared, and no more
/// than if it filled the sky.
fn of_light(row: &LightRow, point: [f64; 3]) -> f64 {
    let pi = std::f64::consts::PI;
    let corner = |v: [f32; 4]| [0, 1, 2].map(|i| f64::from(v[i]));
    let radiance = luminance(corner(row.radiance));
    let radius = f64::from(row.a[3]);
    let (centre, area) = match row.kind[0] {
        SUN => return radiance * pi * radius * radius,
        QUAD => {
            let corners = [row.a, row.b, row.c, row.d].map(corner);
            let centre = [0, 1, 2].map(|i| 0.25 * corners.iter().map(|corner| corner[i]).sum::<f64>());
            (centre, 0.5 * length(twice_area(&corners)))
        }
        TUBE => (corner(row.a), 4.0 * radius * length(corner(row.b))),
        _ => (corner(row.a), pi * radius * radius),
    };
    let distance = length(difference(centre, point));
    radiance * (area / (distance * distance)).min(pi)
}

/// The luminance of linear red, green and blue (Rec. 709).
fn luminance([red, green, blue]: [f64; 3]) -> f64 {
    0.2126 * red + 0.7152 * green + 0.0722 * blue
}
