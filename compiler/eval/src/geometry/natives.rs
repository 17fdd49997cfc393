//! The shapes that OpenSCAD does not have: one module for each row of the vocabulary's table that says so.

use chiaro_solid::Scalar;
use chiaro_syntax::{Diagnostic, Span};
use chiaro_vocabulary::{Kind, Parameter, Row, Type, Unit, rows};

use super::arguments::not_finite;
use super::decide::{self, Sign};
use super::instance::{Instance, error};
use super::make::{empty, radians, shape};
use super::{Built, Call, Facets, Stop};

/// Which parameters of which shapes have to be less than which others.
const LESS: [(&str, &str, &str); 2] = [("ring", "inner", "outer"), ("star", "inner", "outer")];

/// The most points of a star: its outline has as many corners.
const MOST_POINTS: f64 = 1000.0;

/// The names of these modules.
pub(super) fn names() -> impl Iterator<Item = &'static str> {
    modules().map(|row| row.name)
}

/// The parameters of the module of that name.
pub(super) fn parameters(name: &str) -> Option<Vec<&'static str>> {
    let row = modules().find(|row| row.name == name)?;
    Some(row.parameters.iter().map(|parameter| parameter.name).collect())
}

/// The shape of an instance; none, if no row has this name.
pub(super) fn build(call: Call, facets: Facets, diagnostics: &mut Vec<Diagnostic>) -> Option<Built> {
    let row = modules().find(|row| row.name == call.name)?;
    let parameters = parameters(row.name)?;
    let instance = Instance::bind(call, &parameters, &[], facets, diagnostics);
    Some(instance.and_then(|mut instance| instantiate(row, &mut instance)))
}

fn modules() -> impl Iterator<Item = &'static Row> {
    let shapes = rows::rows().iter().copied();
    shapes.filter(|row| row.module && matches!(row.kind, Kind::Solid | Kind::Plane))
}

fn instantiate(row: &'static Row, instance: &mut Instance) -> Built {
    instance.without_children();
    let mut arguments = Vec::with_capacity(row.arity());
    for parameter in row.parameters {
        let numbers = read(instance, parameter)?;
        let span = instance.place(parameter.name);
        match parameter.unit {
            Unit::Size if !instance.are_sizes(&numbers, span)? => return Ok(empty(instance.head)),
            Unit::Angle => arguments.extend(numbers.into_iter().map(radians)),
            Unit::Direction => arguments.extend(direction(numbers, span)?),
            _ => arguments.extend(numbers),
        }
    }
    for parameter in row.parameters {
        check(row, parameter, &arguments, instance.place(parameter.name))?;
    }
    turn_anticlockwise(row, &mut arguments, instance)?;
    Ok(shape(row, arguments, instance.head))
}

/// A parameter's components, as the scene writes them.
fn read(instance: &mut Instance, parameter: &Parameter) -> Result<Vec<Scalar>, Stop> {
    let name = parameter.name;
    let given = match parameter.ty {
        Type::Float => instance.number(name).map(|number| vec![number]),
        Type::Vec2 => instance.number_or_vector::<2>(name, 2, 0.0).map(Vec::from),
        Type::Vec3 => instance.number_or_vector::<3>(name, 3, 0.0).map(Vec::from),
    };
    let numbers = match (given, parameter.default) {
        (Some(numbers), _) => numbers,
        (None, Some(default)) => vec![Scalar::from(default); parameter.ty.len()],
        (None, None) => {
            let diagnostic = Diagnostic::error(instance.head, format!("`{}` needs its `{name}`", instance.name))
                .with_hint(format!("`{name}`: {}", parameter.manual));
            return Err(Stop::Error(Box::new(diagnostic)));
        }
    };
    match numbers.iter().find(|number| !number.is_finite()) {
        Some(odd) => Err(not_finite(name, odd, instance.place(name))),
        None => Ok(numbers),
    }
}

/// A vector made as long as 1.
fn direction(vector: Vec<Scalar>, span: Span) -> Result<Vec<Scalar>, Stop> {
    let squares = vector.iter().map(|c| c.clone() * c.clone());
    let square = squares.fold(Scalar::ZERO, |sum, square| sum + square);
    match decide::sign(&square, span, "whether a vector has a direction")? {
        Sign::Positive => Ok(vector.into_iter().map(|c| c / square.clone().sqrt()).collect()),
        _ => Err(error(span, "this vector has no direction")),
    }
}

/// What shapes ask of single parameters beyond their units.
fn check(row: &Row, parameter: &Parameter, arguments: &[Scalar], span: Span) -> Result<(), Stop> {
    let name = parameter.name;
    let argument = |name: &str| position(row, name).map_or(Scalar::ZERO, |at| arguments[at].clone());
    if name == "n" {
        let number = argument(name);
        let fractional = number.constant().is_some_and(|n| n.fract() != 0.0);
        let reason = "a number of points";
        let too_few = decide::is_negative(&(number.clone() - Scalar::from(2.0)), span, reason)?;
        let too_many = decide::is_negative(&(Scalar::from(MOST_POINTS) - number), span, reason)?;
        if fractional || too_few || too_many {
            return Err(error(span, format!("`n` has to be a whole number from 2 to {MOST_POINTS}")));
        }
    }
    if let Some((_, _, greater)) = LESS.iter().find(|(shape, less, _)| (*shape, *less) == (row.name, name)) {
        let room = argument(greater) - argument(name);
        if !decide::sign(&room, span, "whether one size is less than another")?.is_positive() {
            return Err(error(span, format!("`{name}` has to be less than `{greater}`")));
        }
    }
    Ok(())
}

/// A sweep that goes clockwise is one that goes anticlockwise from where it ended.
fn turn_anticlockwise(row: &Row, arguments: &mut [Scalar], instance: &Instance) -> Result<(), Stop> {
    let (Some(start), Some(sweep)) = (position(row, "start"), position(row, "sweep")) else { return Ok(()) };
    if decide::is_negative(&arguments[sweep], instance.place("sweep"), "which way an arc goes")? {
        arguments[start] = arguments[start].clone() + arguments[sweep].clone();
        arguments[sweep] = -arguments[sweep].clone();
    }
    Ok(())
}

/// Where a parameter's first component is among the flattened arguments.
fn position(row: &Row, name: &str) -> Option<usize> {
    let index = row.parameters.iter().position(|parameter| parameter.name == name)?;
    Some(row.parameters[..index].iter().map(|parameter| parameter.ty.len()).sum())
}
