//! `color`: the material of what it is applied to.

mod names;

use chiaro_solid::{Material, Scalar, Solid, SolidKind};
use chiaro_syntax::{Diagnostic, Span};

use super::arguments::numbers;
use super::instance::{Instance, Module, error};
use super::make::is_empty;
use super::{Built, Stop, decide};
use crate::suggest;
use crate::value::Value;

pub(super) const MODULES: &[Module] = &[Module {
    name: "color",
    positional: &["c", "alpha"],
    named: &["roughness", "metallic", "emission"],
    build: color,
}];

/// The names of colours, in alphabetical order, each with its red, green and blue as one number.
pub fn color_names() -> &'static [(&'static str, u32)] {
    &names::NAMES
}

fn color(instance: &mut Instance) -> Built {
    let child = instance.union();
    let color = read_color(instance);
    let unpainted = Material::default();
    let surface = [share(instance, "roughness")?, share(instance, "metallic")?, brightness(instance)?];
    if is_empty(&child) || (color.is_none() && surface.iter().all(Option::is_none)) {
        return Ok(child);
    }
    let [roughness, metallic, emission] = surface;
    let material = Material {
        color: color.unwrap_or(unpainted.color),
        roughness: roughness.unwrap_or(unpainted.roughness),
        metallic: metallic.unwrap_or(unpainted.metallic),
        emission: emission.unwrap_or(unpainted.emission),
    };
    Ok(Solid::new(SolidKind::Paint(material, child), instance.head))
}

/// The colour with its opacity, which may be given apart from it.
fn read_color(instance: &mut Instance) -> Option<[Scalar; 4]> {
    let alpha = instance.number("alpha");
    let mut color = components(instance, "c", "nothing is painted")?;
    if let Some(alpha) = alpha {
        color[3] = alpha;
    }
    limited(instance, "c", color)
}

/// A colour with its opacity, if one is given; `otherwise` says what happens if there is no such colour.
pub(super) fn read(instance: &mut Instance, parameter: &str, otherwise: &str) -> Option<[Scalar; 4]> {
    let color = components(instance, parameter, otherwise)?;
    limited(instance, parameter, color)
}

/// The components as they are written.
fn components(instance: &mut Instance, parameter: &str, otherwise: &str) -> Option<[Scalar; 4]> {
    let (value, span) = instance.value(parameter)?;
    match &value {
        Value::String(name) => {
            let color = parse(name);
            if color.is_none() {
                instance.report(unknown(name, span, otherwise));
            }
            color.map(|color| color.map(Scalar::from))
        }
        value => match numbers(value).as_deref() {
            Some([r, g, b]) => Some([r.clone(), g.clone(), b.clone(), Scalar::ONE]),
            Some([r, g, b, a]) => Some([r.clone(), g.clone(), b.clone(), a.clone()]),
            _ => instance.unfit(parameter, value, span, "a colour's name or a list of 3 or 4 numbers"),
        },
    }
}

fn unknown(name: &str, span: Span, otherwise: &str) -> Diagnostic {
    let warning = Diagnostic::warning(span, format!("there is no colour \"{name}\", so that {otherwise}"));
    let near = suggest::nearest(&name.to_lowercase(), names::NAMES.iter().map(|(name, _)| *name));
    match near {
        Some(near) => {
            warning.with_hint(format!("did you mean \"{near}\"?")).with_suggestion(span, format!("\"{near}\""))
        }
        None => warning.with_hint("a colour is a name, \"#rrggbb\", \"#rrggbbaa\" or a list of 3 or 4 numbers"),
    }
}

/// The components from 0 to 1; none if OpenSCAD's dumps would mark it as invalid like that.
fn limited(instance: &mut Instance, parameter: &str, color: [Scalar; 4]) -> Option<[Scalar; 4]> {
    if color.iter().any(|component| component.range().max < 0.0) {
        return None;
    }
    if color.iter().any(|component| component.range().min < 0.0 || component.range().max > 1.0) {
        let message = "a colour's components go from 0 to 1; what is beyond counts as that";
        instance.warn(instance.place(parameter), message);
    }
    Some(color.map(|component| component.max(Scalar::ZERO).min(Scalar::ONE)))
}

/// The colour of a name in any case, or of hexadecimal digits.
fn parse(text: &str) -> Option<[f64; 4]> {
    if let Some(digits) = text.strip_prefix('#') {
        return parse_hexadecimal(digits);
    }
    let name = text.to_lowercase();
    if name == "transparent" {
        return Some([0.0; 4]);
    }
    let index = names::NAMES.binary_search_by(|(candidate, _)| (*candidate).cmp(&name)).ok()?;
    let [_, r, g, b] = names::NAMES[index].1.to_be_bytes();
    Some([r, g, b, 255].map(|component| f64::from(component) / 255.0))
}

/// The colour of 3, 4, 6 or 8 digits.
fn parse_hexadecimal(digits: &str) -> Option<[f64; 4]> {
    let values: Vec<f64> = digits.chars().map(|digit| digit.to_digit(16).map(f64::from)).collect::<Option<_>>()?;
    let components: Vec<f64> = match values.len() {
        3 | 4 => values.iter().map(|value| value / 15.0).collect(),
        6 | 8 => values.chunks(2).map(|pair| (16.0 * pair[0] + pair[1]) / 255.0).collect(),
        _ => return None,
    };
    Some(std::array::from_fn(|i| components.get(i).copied().unwrap_or(1.0)))
}

/// A number from 0 to 1, if it is given.
fn share(instance: &mut Instance, parameter: &str) -> Result<Option<Scalar>, Stop> {
    let Some(number) = instance.number(parameter) else { return Ok(None) };
    let range = number.range();
    if range.min < 0.0 || range.max > 1.0 {
        return Err(error(instance.place(parameter), format!("`{parameter}` goes from 0 to 1")));
    }
    Ok(Some(number))
}

/// A finite number that is not negative, if it is given.
fn brightness(instance: &mut Instance) -> Result<Option<Scalar>, Stop> {
    let Some(number) = instance.number("emission") else { return Ok(None) };
    let span = instance.place("emission");
    if !number.is_finite() || decide::is_negative(&number, span, "whether an emission is negative")? {
        return Err(error(span, "`emission` is a multiple of the colour and cannot be negative"));
    }
    Ok(Some(number))
}
