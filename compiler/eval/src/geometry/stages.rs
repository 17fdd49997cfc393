//! Extrusions of a few slices: stages with flat sides, as OpenSCAD makes them.

use std::sync::Arc;

use chiaro_plane::Loft;
use chiaro_solid::scalar::degrees;
use chiaro_solid::{Material, Scalar, Solid, SolidKind};

use super::decide;
use super::facets::{Facets, MOST_SIDES_OF_A_SHAPE};
use super::instance::Instance;
use super::outline::outline;
use super::{Built, Stop};

/// Stages that consist of more flat sides than this are taken for a true curve.
const MOST_SIDES: usize = 20_000;
/// Above the limit of a shape, slices that turn by more than this, in degrees, are told to be taken for a true curve.
const WIDE_TURN: f64 = 30.0;

/// How an extrusion changes from the bottom to the top.
pub(super) struct Change<'a> {
    pub(super) height: &'a Scalar,
    /// In degrees, clockwise seen from above.
    pub(super) twist: &'a Scalar,
    pub(super) scale: &'a [Scalar; 2],
}

/// The extrusion in as many stages as there are slices; none, if they stand for a true curve.
pub(super) fn staged(instance: &mut Instance, change: &Change, child: &Arc<Solid>) -> Result<Option<Arc<Solid>>, Stop> {
    let Some(count) = read_slices(instance)? else { return Ok(None) };
    if change.twist.is(0.0) && change.scale[0] == change.scale[1] {
        // Then the levels change in proportion to the height, whatever the number of slices.
        return Ok(None);
    }
    let span = instance.place("slices");
    let known = |number: &Scalar| decide::constant(number, span, "the slices of an extrusion");
    let (height, twist) = (known(change.height)?, known(change.twist)?);
    let scale = [known(&change.scale[0])?, known(&change.scale[1])?];
    let is_shape = instance.facets == Facets::Exact || count <= MOST_SIDES_OF_A_SHAPE;
    if !is_shape {
        let turn = (twist / count).abs();
        if turn > WIDE_TURN {
            let most = MOST_SIDES_OF_A_SHAPE;
            let message =
                format!("`slices` is taken for a true curve, being more than {most}, though each turns by {turn:.0}°");
            instance.warn(span, message);
        }
        return Ok(None);
    }
    if count > MOST_SIDES as f64 {
        return too_fine(instance);
    }
    let level = |index: u32| {
        let t = f64::from(index) / count;
        let [x, y] = scale.map(|top| 1.0 + t * (top - 1.0));
        let (sin, cos) = (degrees::sin(-twist * t), degrees::cos(twist * t));
        [[x * cos, y * sin], [-x * sin, y * cos]]
    };
    let levels: Vec<_> = (0..=count as u32).map(level).collect();
    let region = outline(child)?;
    if region.edges().count().saturating_mul(2 * levels.len()) > MOST_SIDES {
        return too_fine(instance);
    }
    let loft = Loft::new(&region, &levels, height, twist > 0.0);
    if loft.sides() > MOST_SIDES {
        return too_fine(instance);
    }
    painted(loft, child, instance).map(Some)
}

/// The number of slices, a whole one, if it is given.
fn read_slices(instance: &mut Instance) -> Result<Option<f64>, Stop> {
    let Some(number) = instance.number("slices").filter(|_| instance.facets != Facets::Smooth) else { return Ok(None) };
    let count = decide::constant(&number, instance.place("slices"), "the number of slices")?;
    Ok(count.is_finite().then(|| count.floor().max(1.0)))
}

fn too_fine(instance: &mut Instance) -> Result<Option<Arc<Solid>>, Stop> {
    let message = format!("these slices would have more than {MOST_SIDES} flat sides: they are taken for a true curve");
    instance.warn(instance.place("slices"), message);
    Ok(None)
}

/// The stages, in the colour of the plane shape if it has one as a whole.
fn painted(loft: Loft, child: &Solid, instance: &Instance) -> Built {
    let stages = Solid::new(SolidKind::Loft(Arc::new(loft)), instance.head);
    Ok(match material(child) {
        Some(material) => Solid::new(SolidKind::Paint(material.clone(), stages), instance.head),
        None => stages,
    })
}

fn material(solid: &Solid) -> Option<&Material> {
    match &solid.kind {
        SolidKind::Paint(material, _) => Some(material),
        SolidKind::Transform(_, child) | SolidKind::Offset(_, child) => material(child),
        _ => None,
    }
}
