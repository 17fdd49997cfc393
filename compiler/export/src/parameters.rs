//! Live parameters as exported code gets them: each under its own name, as a slider of the target's own.

use chiaro_solid::scalar::{Function, Operation};
use chiaro_solid::{LiveParameter, Scalar};
use deunicode::deunicode_with_tofu;
use rustc_hash::FxHashSet;

use crate::prose::Prose;

/// A live parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// A name that is unique in the exported text.
    pub name: String,
    /// What the scene calls it, for people: `size[0]`.
    pub label: Prose,
    /// Its value until somebody moves it.
    pub default: f64,
    /// The least value.
    pub min: f64,
    /// The greatest value.
    pub max: f64,
    /// The distance between neighbouring values on a slider, if the scene says.
    pub step: Option<f64>,
    /// What the scene says about it.
    pub description: Option<Prose>,
    /// Whether it is `$t`, which goes from 0 to 1 again and again.
    pub is_time: bool,
}

/// The parameters of a scene that its field depends on, in their order, and names that are not taken.
pub(crate) fn parameters(live: &[LiveParameter], is_taken: &dyn Fn(&str) -> bool) -> Vec<Parameter> {
    let mut given: FxHashSet<String> = FxHashSet::default();
    let mut named = |parameter: &LiveParameter| {
        let is_time = &*parameter.name == "$t";
        let component = parameter.component.map(|index| ["x", "y", "z", "w"].get(index).copied().unwrap_or("n"));
        let word = if is_time { "time".to_owned() } else { snake_case(&parameter.name, "value") };
        let own = component.map_or(word.clone(), |component| format!("{word}_{component}"));
        let mut name = own.clone();
        // `_value` more often than a text has words is not needed.
        while is_taken(&name) || !given.insert(name.clone()) {
            name += "_value";
        }
        let label = match parameter.component {
            Some(index) => format!("{}[{index}]", parameter.name),
            None => parameter.name.to_string(),
        };
        Parameter {
            name,
            label: Prose::new(&label),
            default: parameter.default,
            min: parameter.range.min,
            max: parameter.range.max,
            step: parameter.step,
            description: parameter.description.as_deref().map(Prose::new),
            is_time,
        }
    };
    live.iter().map(&mut named).collect()
}

/// A name as shaders like it: `wall_thickness` for `wallThickness`, `grosse` for `Größe`. Never a number first, nor two underscores
/// in a row. What has no letters and no numbers is called otherwise.
pub fn snake_case(name: &str, otherwise: &str) -> String {
    let mut result = String::new();
    let mut was_lower = false;
    for c in deunicode_with_tofu(name, "_").chars() {
        if c.is_ascii_uppercase() && was_lower {
            result.push('_');
        }
        was_lower = c.is_ascii_lowercase() || c.is_ascii_digit();
        match c.is_ascii_alphanumeric() {
            true => result.push(c.to_ascii_lowercase()),
            false if !result.is_empty() && !result.ends_with('_') => result.push('_'),
            false => {}
        }
    }
    let result = result.trim_end_matches('_');
    match result.chars().next() {
        None => otherwise.to_owned(),
        Some(first) if first.is_ascii_digit() => format!("n{result}"),
        Some(_) => result.to_owned(),
    }
}

/// A live number as WGSL, in terms of the uniform variable `parameters`. Angles of scenes are in degrees.
///
/// What goes into functions that are not defined everywhere is within their domains for all values of the parameters, but
/// in single precision it may be rounded to just outside of them.
pub(crate) fn expression(scalar: &Scalar, parameters: &[Parameter]) -> String {
    let Scalar::Live(live) = scalar else { return number(scalar.constant().unwrap_or_default()) };
    match &live.operation {
        Operation::Parameter(id) => {
            let name = parameters.get(id.0 as usize).map_or("unknown", |parameter| &parameter.name);
            format!("parameters.{name}")
        }
        Operation::Apply(function, arguments) => {
            let arguments: Vec<String> = arguments.iter().map(|argument| expression(argument, parameters)).collect();
            applied(*function, &arguments)
        }
    }
}

fn applied(function: Function, x: &[String]) -> String {
    let infix = |operator: &str| format!("({} {operator} {})", x[0], x[1]);
    let call = |name: &str| format!("{name}({})", x.join(", "));
    let of_angle = |name: &str| format!("{name}(radians({}))", x[0]);
    let angle = |name: &str| format!("degrees({name}({}))", x.join(", "));
    let within_one = |name: &str| format!("degrees({name}(clamp({}, -1.0, 1.0)))", x[0]);
    let logarithm = format!("log(max({}, 1e-37))", x[0]);
    match function {
        Function::Negate => format!("(-{})", x[0]),
        Function::Add => infix("+"),
        Function::Subtract => infix("-"),
        Function::Multiply => infix("*"),
        Function::Divide => infix("/"),
        Function::Modulo => format!("({0} - {1} * trunc({0} / {1}))", x[0], x[1]),
        Function::Power => call("live_power"),
        Function::Min => call("min"),
        Function::Max => call("max"),
        Function::Abs => call("abs"),
        Function::Sign => call("sign"),
        Function::Sqrt => format!("sqrt(max({}, 0.0))", x[0]),
        Function::Exp => call("exp"),
        Function::Ln => logarithm,
        Function::Log => format!("({logarithm} / log(10.0))"),
        Function::Floor => call("floor"),
        Function::Ceil => call("ceil"),
        Function::Round => format!("(sign({0}) * floor(abs({0}) + 0.5))", x[0]),
        Function::Sin => of_angle("sin"),
        Function::Cos => of_angle("cos"),
        Function::Tan => of_angle("tan"),
        Function::Asin => within_one("asin"),
        Function::Acos => within_one("acos"),
        Function::Atan => angle("atan"),
        Function::Atan2 => angle("atan2"),
        Function::Less => format!("select(0.0, 1.0, {} < {})", x[0], x[1]),
        Function::LessEqual => format!("select(0.0, 1.0, {} <= {})", x[0], x[1]),
        Function::Select => format!("select({}, {}, {} != 0.0)", x[2], x[1], x[0]),
        Function::SmallestSingularValue => {
            let row = |i: usize| format!("vec3({}, {}, {})", x[3 * i], x[3 * i + 1], x[3 * i + 2]);
            format!("least_stretch({}, {}, {})", row(0), row(1), row(2))
        }
    }
}

/// A number as WGSL writes floats.
pub(crate) fn number(value: f64) -> String {
    let single = value.clamp(f64::from(f32::MIN), f64::from(f32::MAX)) as f32;
    let size = single.abs();
    if size != 0.0 && !(1e-4..1e7).contains(&size) {
        return format!("{single:e}");
    }
    let digits = single.to_string();
    if digits.contains('.') { digits } else { digits + ".0" }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_in_snake_case() {
        let cases = [
            ("wallThickness", "wall_thickness"),
            ("_hole__size_", "hole_size"),
            ("2nd", "n2nd"),
            ("$t", "t"),
            ("__", "value"),
            ("日本", "ri_ben"),
            ("Größe der Öffnung", "grosse_der_offnung"),
        ];
        for (name, expected) in cases {
            assert_eq!(snake_case(name, "value"), expected);
        }
    }
}
