//! What moves a surface by a distance: `offset`, `round`, `shell`; and `fill`.

use std::sync::Arc;

use chiaro_plane::Join;
use chiaro_solid::{Dimension, Scalar, Solid, SolidKind};
use chiaro_syntax::{Diagnostic, Span};
use chiaro_vocabulary::Class;

use super::exactness::{class, culprit};
use super::instance::{Instance, Module};
use super::make::{self, empty, is_empty, region};
use super::outline::{filled, grown_region, outline};
use super::{Built, Stop, decide};

pub(super) const MODULES: &[Module] = &[
    Module { name: "offset", positional: &["r", "delta", "chamfer"], named: &[], build: offset },
    Module { name: "fill", positional: &[], named: &[], build: fill },
    Module { name: "round", positional: &["r"], named: &[], build: round },
    Module { name: "shell", positional: &["thickness"], named: &[], build: shell },
];

/// Round corners with `r`, sharp or chamfered ones with `delta`; `r = 1` without either.
fn offset(instance: &mut Instance) -> Built {
    let child = instance.union_in(Dimension::Plane);
    let (radius, delta) = (instance.finite_number("r")?, instance.finite_number("delta")?);
    let Some(by) = radius.is_none().then_some(delta).flatten() else {
        return grown(radius.unwrap_or(Scalar::ONE), child, instance.head);
    };
    let join = if instance.flag("chamfer", false)? { Join::Chamfer } else { Join::SHARP };
    let by = decide::constant(&by, instance.place("delta"), "an offset with sharp corners")?;
    Ok(region(grown_region(&child, by, join)?, instance.head))
}

fn fill(instance: &mut Instance) -> Built {
    let child = instance.union_in(Dimension::Plane);
    Ok(region(filled(&outline(&child)?), instance.head))
}

/// Grows what it is applied to: convex edges become round with that radius, and every face moves out by it.
fn round(instance: &mut Instance) -> Built {
    let child = instance.union();
    let Some(radius) = instance.finite_number("r")? else {
        instance.warn(instance.head, "`round` needs its radius `r`; without, it does nothing");
        return Ok(child);
    };
    grown(radius, child, instance.head)
}

/// The wall that lies half to each side of the surface.
fn shell(instance: &mut Instance) -> Built {
    let child = instance.union();
    let thickness = instance.finite_number("thickness")?.unwrap_or(Scalar::ONE);
    let span = instance.place("thickness");
    if is_empty(&child) || !instance.are_sizes(std::slice::from_ref(&thickness), span)? {
        return Ok(empty(instance.head));
    }
    let child = if class(&child) == Class::Exact {
        child
    } else if child.dimension() == Some(Dimension::Plane) {
        region(outline(&child)?, instance.head)
    } else {
        return Err(inexact(instance.head, &child, Class::Exact, "this shell's wall would not be equally thick"));
    };
    Ok(if is_empty(&child) { child } else { Solid::new(SolidKind::Shell(thickness, child), instance.head) })
}

/// A solid grown by a distance in every direction, round at convex edges; shrunk, if it is negative.
pub(super) fn grown(by: Scalar, child: Arc<Solid>, span: Span) -> Built {
    if is_empty(&child) || by.is(0.0) {
        return Ok(child);
    }
    let shrinks = by.range().min < 0.0;
    let needed = if shrinks { Class::Exact } else { Class::ExactOutside };
    let exact = class(&child) <= needed;
    match child.dimension() {
        // What shrinks may vanish, which only its outline tells.
        Some(Dimension::Plane) if shrinks || !exact => match grown_outline(&by, &child, span) {
            Err(Stop::Demote(_)) if exact => Ok(make::offset(by, child, span)),
            outline => outline,
        },
        _ if exact => Ok(make::offset(by, child, span)),
        _ => Err(inexact(span, &child, needed, "the edges of what this grows would stay sharp")),
    }
}

fn grown_outline(by: &Scalar, child: &Solid, span: Span) -> Built {
    let by = decide::constant(by, span, "the offset of a plane shape that is made of others")?;
    Ok(region(grown_region(child, by, Join::Round)?, span))
}

/// The error that a distance is not exact enough.
fn inexact(span: Span, child: &Arc<Solid>, needed: Class, consequence: &str) -> Stop {
    let diagnostic = Diagnostic::error(span, format!("this is not supported yet: {consequence}"))
        .with_related(culprit(child, needed).span, "of this, the distance is not known exactly")
        .with_hint("it works on shapes, and on unions, moves and uniform scales of them where they are only grown");
    Stop::Error(Box::new(diagnostic))
}
