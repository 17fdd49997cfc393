//! Plane shapes as exact outlines, for what distances are not enough for: mitred and repeated offsets, hulls, filled
//! holes. An outline has no live numbers.

use chiaro_plane::region::Point;
use chiaro_plane::{Contour, Edge, Join, Region};
use chiaro_solid::{Affine, Boolean, Scalar, Solid, SolidKind};
use chiaro_syntax::Span;
use chiaro_vocabulary::Row;

use super::instance::error;
use super::{Stop, decide};

/// The most crossings that outlines are worked out with, and the most edges that are grown: what is swept by edges close
/// together crosses far more often than they do.
const MOST_CROSSINGS: f64 = 2_000.0;
const MOST_GROWN_EDGES: usize = 20_000;

/// The outline of a plane shape.
pub(super) fn outline(solid: &Solid) -> Result<Region, Stop> {
    match &solid.kind {
        SolidKind::Empty => Ok(Region::default()),
        SolidKind::Shape(row, arguments) => shape_outline(row, &known(arguments, solid.span)?, solid.span),
        SolidKind::Region(region) => untangled(vec![(**region).clone()], solid.span).map(|mut one| one.remove(0)),
        SolidKind::Boolean { operation, joint: None, children } => {
            let outlines = children.iter().map(|child| outline(child)).collect::<Result<Vec<_>, _>>()?;
            Ok(boolean(*operation, &untangled(outlines, solid.span)?))
        }
        SolidKind::Transform(map, child) => Ok(outline(child)?.transform(plane_rows(map, solid.span)?)),
        SolidKind::Paint(_, child) => outline(child),
        SolidKind::Offset(by, child) => grown_region(child, known_number(by, solid.span)?, Join::Round),
        SolidKind::Shell(thickness, child) => {
            let half = 0.5 * known_number(thickness, solid.span)?;
            Ok(grown_region(child, half, Join::Round)?.difference(&[grown_region(child, -half, Join::Round)?]))
        }
        SolidKind::Boolean { joint: Some(_), .. } => {
            Err(error(solid.span, "what is joined with a radius has no exact outline yet"))
        }
        SolidKind::Slice(_) => Err(error(solid.span, "the cut through a solid has no exact outline yet")),
        _ => Err(error(solid.span, "this is no plane shape")),
    }
}

/// The outline of a plane shape, grown by a distance, or shrunk if that is negative.
pub(super) fn grown_region(solid: &Solid, by: f64, join: Join) -> Result<Region, Stop> {
    Ok(growable(outline(solid)?, solid.span)?.offset(by, join))
}

/// An outline without what no disc of that radius inside it reaches: its corners are rounded, its narrow parts gone.
pub(super) fn opened(region: &Region, radius: f64, span: Span) -> Result<Region, Stop> {
    let region = untangled(vec![region.clone()], span)?.remove(0);
    Ok(growable(region, span)?.offset(-radius, Join::Round).offset(radius, Join::Round))
}

/// The outline without crossings, unless it is too fine to be grown or shrunk.
fn growable(region: Region, span: Span) -> Result<Region, Stop> {
    let region = region.normalized();
    let edges = region.edges().count();
    if edges > MOST_GROWN_EDGES {
        let message = format!("this outline of {edges} edges is too fine to be grown or shrunk");
        return Err(error(span, message));
    }
    Ok(region)
}

/// An outline without its holes.
pub(super) fn filled(region: &Region) -> Region {
    let outer = |contour: &Contour| contour.signed_area() > 0.0;
    let contours = region.normalized().contours.into_iter().filter(outer);
    let parts: Vec<Region> = contours.map(|contour| Region { contours: vec![contour] }).collect();
    Region::union(&parts)
}

/// The outlines, unless they cross themselves and each other too often.
fn untangled(outlines: Vec<Region>, span: Span) -> Result<Vec<Region>, Stop> {
    let crossings = Region::crossings_estimate(&outlines);
    if crossings > MOST_CROSSINGS {
        let message = format!("this outline is too tangled: it crosses itself about {crossings:.0} times");
        return Err(error(span, message));
    }
    Ok(outlines)
}

fn boolean(operation: Boolean, outlines: &[Region]) -> Region {
    match (operation, outlines) {
        (Boolean::Union, _) => Region::union(outlines),
        (Boolean::Intersection, _) => Region::intersection(outlines),
        (Boolean::Difference, [first, others @ ..]) => first.difference(others),
        (Boolean::Difference, []) => Region::default(),
    }
}

fn shape_outline(row: &Row, arguments: &[f64], span: Span) -> Result<Region, Stop> {
    match (row.name, arguments) {
        ("circle", [radius]) => Ok(Region::circle(*radius)),
        ("rectangle", [x, y]) => Ok(Region::rectangle([-x, -y], [*x, *y])),
        ("ngon", [radius, sides]) => Ok(Region::ngon(*radius, *sides as u32)),
        ("ellipse", [x, y]) => Ok(Region::circle(1.0).transform([[*x, 0.0, 0.0], [0.0, *y, 0.0]])),
        ("ring", [outer, inner]) => Ok(Region::circle(*outer).difference(&[Region::circle(*inner)])),
        ("pie", [radius, start, sweep]) => Ok(pie(*radius, *start, *sweep)),
        ("egg", [bottom, top, height]) => {
            let discs = [Region::circle(*bottom), Region::disc([0.0, *height], *top)];
            Ok(Region::hull(&discs))
        }
        ("vesica", [radius, apart]) => {
            let disc = |x: f64| Region::disc([x, 0.0], *radius);
            Ok(Region::intersection(&[disc(-0.5 * apart), disc(0.5 * apart)]))
        }
        ("star", [outer, inner, points]) => Ok(star(*outer, *inner, *points as u32)),
        _ => Err(error(span, format!("`{}` has no exact outline yet", row.name))),
    }
}

/// Points and notches in turn, the first point on the x axis.
fn star(outer: f64, inner: f64, points: u32) -> Region {
    let corner = |k: u32| -> Point {
        let radius = if k.is_multiple_of(2) { outer } else { inner };
        let (sin, cos) = (std::f64::consts::PI * f64::from(k) / f64::from(points)).sin_cos();
        [radius * cos, radius * sin]
    };
    Region::polygon(&(0..points.saturating_mul(2)).map(corner).collect::<Vec<_>>(), None)
}

/// The sector of a disc.
fn pie(radius: f64, start: f64, sweep: f64) -> Region {
    if sweep.abs() >= std::f64::consts::TAU {
        return Region::circle(radius);
    }
    let arc = Edge::Arc { center: [0.0, 0.0], radius, start, sweep };
    let into = Edge::Line { from: [0.0, 0.0], to: arc.start() };
    let back = Edge::Line { from: arc.end(), to: [0.0, 0.0] };
    Region { contours: vec![Contour { edges: vec![into, arc, back] }] }
}

/// What a map does in the plane.
fn plane_rows(map: &Affine, span: Span) -> Result<[[f64; 3]; 2], Stop> {
    let row = |i: usize| -> Result<[f64; 3], Stop> {
        let [x, y, _, shift] = &map.rows()[i];
        Ok([known_number(x, span)?, known_number(y, span)?, known_number(shift, span)?])
    };
    Ok([row(0)?, row(1)?])
}

fn known(numbers: &[Scalar], span: Span) -> Result<Vec<f64>, Stop> {
    numbers.iter().map(|number| known_number(number, span)).collect()
}

fn known_number(number: &Scalar, span: Span) -> Result<f64, Stop> {
    decide::constant(number, span, "a plane shape whose outline has to be known")
}
