//! Union, difference and intersection, with OpenSCAD's rules of empty operands and of dimensions.

use std::sync::Arc;

use chiaro_solid::{Boolean, Joint, Profile, Solid, SolidKind};
use chiaro_syntax::{Diagnostic, Span};

use super::decide::{self, Sign};
use super::instance::{Instance, Module, error};
use super::make::{empty, is_empty};
use super::{Built, OnlyChild, Stop};

/// The argument with which what loops below a module make are its operands, one by one.
pub(crate) const EVERY: &str = "every";

const OPERATIONS: [&str; 3] = ["union", "difference", "intersection"];
const JOINT: &[&str] = &["r", "joint", EVERY];

pub(super) const MODULES: &[Module] = &[
    Module { name: "union", positional: &[], named: JOINT, build: union },
    Module { name: "difference", positional: &[], named: JOINT, build: difference },
    Module { name: "intersection", positional: &[], named: JOINT, build: intersection },
    Module { name: "group", positional: &[], named: &[], build: group },
    Module { name: "render", positional: &[], named: &[], build: group },
];

/// Whether a module knows [`EVERY`].
pub(crate) fn takes_every(module: &str) -> bool {
    OPERATIONS.contains(&module)
}

/// What some children are together. Empty ones are dropped, and so are those of another dimension than the first.
pub(crate) fn union_of(children: Vec<Arc<Solid>>, span: Span, diagnostics: &mut Vec<Diagnostic>) -> Arc<Solid> {
    combined(Boolean::Union, None, children, span, diagnostics)
}

fn group(instance: &mut Instance) -> Built {
    Ok(instance.union())
}

fn union(instance: &mut Instance) -> Built {
    boolean(instance, Boolean::Union)
}

fn difference(instance: &mut Instance) -> Built {
    boolean(instance, Boolean::Difference)
}

fn intersection(instance: &mut Instance) -> Built {
    boolean(instance, Boolean::Intersection)
}

fn boolean(instance: &mut Instance, operation: Boolean) -> Built {
    let joint = read_joint(instance)?;
    let every = instance.flag(EVERY, false)?;
    if let (Some(_), false, Some(only)) = (&joint, every, instance.only_child) {
        let lonely = Diagnostic::warning(instance.place("r"), "there is one operand only, so that nothing is joined");
        instance.report(match only {
            OnlyChild::Several => lonely.with_hint("`every = true` joins what loops, conditions and `children()` make"),
            OnlyChild::Operand => lonely.with_hint("what is to be joined stands in braces: `{ … }`"),
        });
    }
    let children = std::mem::take(&mut instance.children);
    let mut warnings = Vec::new();
    let solid = combined(operation, joint, children, instance.head, &mut warnings);
    warnings.into_iter().for_each(|warning| instance.report(warning));
    Ok(solid)
}

fn combined(
    operation: Boolean,
    joint: Option<Joint>,
    children: Vec<Arc<Solid>>,
    span: Span,
    diagnostics: &mut Vec<Diagnostic>,
) -> Arc<Solid> {
    let is_nothing = match operation {
        Boolean::Union => false,
        Boolean::Difference => children.first().is_some_and(|first| is_empty(first)),
        Boolean::Intersection => children.iter().any(|child| is_empty(child)),
    };
    if is_nothing {
        return empty(span);
    }
    let children: Vec<Arc<Solid>> = children.into_iter().filter(|child| !is_empty(child)).collect();
    let count = children.len();
    let mut children = of_one_dimension(children, diagnostics);
    match children.len() {
        // To an intersection, what is left out counts as empty.
        left if left < count && operation == Boolean::Intersection => empty(span),
        0 => empty(span),
        1 => children.remove(0),
        _ => Solid::new(SolidKind::Boolean { operation, joint, children }, span),
    }
}

/// The children of the first one's dimension.
fn of_one_dimension(children: Vec<Arc<Solid>>, diagnostics: &mut Vec<Diagnostic>) -> Vec<Arc<Solid>> {
    let Some(first) = children.first().cloned() else { return children };
    let same = |child: &Arc<Solid>| child.dimension() == first.dimension();
    let (kept, others): (Vec<_>, Vec<_>) = children.into_iter().partition(same);
    if let Some(other) = others.first() {
        let message = "plane shapes and solids do not mix: what is unlike the first child is left out";
        diagnostics.push(Diagnostic::warning(other.span, message).with_related(first.span, "the first child"));
    }
    kept
}

/// How the operands meet; sharply without a radius.
fn read_joint(instance: &mut Instance) -> Result<Option<Joint>, Stop> {
    let profile = read_profile(instance)?;
    let Some(radius) = instance.finite_number("r")? else {
        if profile.is_some() {
            let message = "a joint has no effect without its radius `r`";
            instance.warn(instance.place("joint"), message);
        }
        return Ok(None);
    };
    let span = instance.place("r");
    match decide::sign(&radius, span, "whether operands are joined smoothly")? {
        Sign::Zero => Ok(None),
        Sign::Negative => Err(error(span, "the radius of a joint cannot be negative")),
        Sign::Positive => Ok(Some(Joint { profile: profile.unwrap_or(Profile::Fillet), radius })),
    }
}

fn read_profile(instance: &mut Instance) -> Result<Option<Profile>, Stop> {
    let Some((name, span)) = instance.text("joint") else { return Ok(None) };
    match &*name {
        "fillet" => Ok(Some(Profile::Fillet)),
        "smooth" => Ok(Some(Profile::Smooth)),
        "chamfer" => Ok(Some(Profile::Chamfer)),
        _ => {
            let diagnostic = Diagnostic::error(span, format!("there is no joint \"{name}\""))
                .with_hint("a joint is \"fillet\", \"smooth\" or \"chamfer\"");
            Err(Stop::Error(Box::new(diagnostic)))
        }
    }
}
