//! `camera`: from where the scene is seen.

use chiaro_solid::Scalar;
use chiaro_syntax::Diagnostic;

use super::aside::PlacedCamera;
use super::instance::{Instance, Module, error};
use super::make::empty;
use super::{Built, Stop};

pub(super) const MODULES: &[Module] =
    &[Module { name: "camera", positional: &["eye", "target", "fov"], named: &[], build: camera }];

fn camera(instance: &mut Instance) -> Built {
    instance.without_children();
    let Some(eye) = point(instance, "eye")? else {
        let needs = Diagnostic::error(instance.head, "`camera` needs its `eye`")
            .with_hint("`camera([x, y, z])` looks from there at the origin, or at `target`");
        return Err(Stop::Error(Box::new(needs)));
    };
    let target = point(instance, "target")?.unwrap_or([Scalar::ZERO, Scalar::ZERO, Scalar::ZERO]);
    if eye == target {
        return Err(error(instance.place("eye"), "the camera stands where it looks at"));
    }
    let field_of_view = field_of_view(instance)?;
    let span = instance.head;
    instance.aside.cameras.push(PlacedCamera { eye, target, field_of_view, span });
    Ok(empty(span))
}

fn point(instance: &mut Instance, parameter: &str) -> Result<Option<[Scalar; 3]>, Stop> {
    let Some(point) = instance.vector::<3>(parameter, 3, 0.0) else { return Ok(None) };
    if !point.iter().all(Scalar::is_finite) {
        return Err(error(instance.place(parameter), format!("`{parameter}` has to be finite")));
    }
    Ok(Some(point))
}

/// The vertical field of view. Of a live one, what is out of bounds counts as the bound when the picture is drawn.
fn field_of_view(instance: &mut Instance) -> Result<Option<Scalar>, Stop> {
    let Some(angle) = instance.number("fov") else { return Ok(None) };
    let range = angle.range();
    if angle.is_finite() && range.max > 0.0 && range.min < 180.0 {
        return Ok(Some(angle));
    }
    Err(error(instance.place("fov"), "`fov` is an angle between 0 and 180 degrees"))
}
