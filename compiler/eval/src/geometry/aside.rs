//! What a scene has beside its solids: lights and cameras. Only transforms and modifiers touch it; to every operator
//! it is as if it weren't there.

use chiaro_solid::affine::Similarity;
use chiaro_solid::{Affine, Emitter, PlacedLight, Scalar};
use chiaro_syntax::{Diagnostic, Span};

use super::instance::Instance;
use super::transforms::{is_regular, live_entries};
use super::{Stop, decide};

/// A placement with a number of more operations than this is not worth being live.
const LONGEST_FORMULA: u32 = 4_096;

/// Lights and cameras, in the order of evaluation, each where the transforms around it so far put it.
#[derive(Debug, Default)]
pub(crate) struct Aside {
    pub(crate) lights: Vec<PlacedLight>,
    pub(crate) cameras: Vec<PlacedCamera>,
}

/// A camera, in the coordinates of what is around it.
#[derive(Clone, Debug)]
pub(crate) struct PlacedCamera {
    pub(crate) eye: [Scalar; 3],
    pub(crate) target: [Scalar; 3],
    /// Vertical, in degrees.
    pub(crate) field_of_view: Option<Scalar>,
    pub(crate) span: Span,
}

impl Aside {
    pub(crate) fn is_empty(&self) -> bool {
        self.lights.is_empty() && self.cameras.is_empty()
    }

    pub(crate) fn len(&self) -> usize {
        self.lights.len() + self.cameras.len()
    }

    pub(crate) fn append(&mut self, mut other: Aside) {
        self.lights.append(&mut other.lights);
        self.cameras.append(&mut other.cameras);
    }

    /// Where the first of it stands in the text.
    fn span(&self) -> Option<Span> {
        let lights = self.lights.iter().map(|light| light.span);
        lights.chain(self.cameras.iter().map(|camera| camera.span)).next()
    }
}

impl Instance<'_> {
    /// Says that what the children have put aside is left out, and does so.
    pub(super) fn without_aside(&mut self) {
        if let Some(span) = std::mem::take(self.aside).span() {
            self.leave_out(span);
        }
    }

    /// Moves what the children have put aside. What a map flattens, or takes nowhere, is gone.
    pub(super) fn move_aside(&mut self, map: &Affine) -> Result<(), Stop> {
        if self.aside.is_empty() {
            return Ok(());
        }
        if !decide::are_finite(map.rows().iter().flatten(), self.head)? {
            self.warn(self.head, format!("`{}` is not finite here, so that there is nothing", self.name));
            *self.aside = Aside::default();
            return Ok(());
        }
        if !is_regular(map, self.head)? {
            self.warn(self.head, format!("`{}` flattens this to nothing", self.name));
            *self.aside = Aside::default();
            return Ok(());
        }
        if let Some(rigid) = self.aside.lights.iter().find(|light| !is_flexible(&light.light.emitter)) {
            keeps_shape(map, rigid, self.head)?;
        }
        for light in &mut self.aside.lights {
            light.placement = map.after(&light.placement);
            check_place(light.placement.rows().iter().flatten(), light.span)?;
        }
        for camera in &mut self.aside.cameras {
            camera.eye = map.point(&camera.eye);
            camera.target = map.point(&camera.target);
            check_place(camera.eye.iter().chain(&camera.target), camera.span)?;
        }
        Ok(())
    }
}

/// Whether a light may be stretched and sheared.
fn is_flexible(emitter: &Emitter) -> bool {
    matches!(emitter, Emitter::Rect { .. } | Emitter::Polygon { .. })
}

/// Checks that a map changes all lengths of a light by one factor.
fn keeps_shape(map: &Affine, light: &PlacedLight, span: Span) -> Result<(), Stop> {
    if matches!(map.similarity(), Similarity::Uniform(_)) {
        return Ok(());
    }
    if let Some(number) = live_entries(map) {
        return Err(decide::demote(number, span, "whether a matrix keeps the shape of a light"));
    }
    let hint = "move it, turn it, mirror it, or scale it by one factor; only `rect_light` and `polygon_light` can be \
                stretched and sheared";
    let error = Diagnostic::error(span, "this light can't be stretched or sheared")
        .with_related(light.span, "the light")
        .with_hint(hint);
    Err(Stop::Error(Box::new(error)))
}

/// Checks that numbers are finite and not too long to be computed anew for every picture.
fn check_place<'a>(numbers: impl Iterator<Item = &'a Scalar>, span: Span) -> Result<(), Stop> {
    for number in numbers {
        decide::finite(number, span)?;
        if number.size() > LONGEST_FORMULA {
            let reason = "a place too long to be computed anew for every picture";
            return Err(decide::demote(number.clone(), span, reason));
        }
    }
    Ok(())
}
