//! Solids as text, for people and for tests: one node a line, its children indented below it.
//!
//! Lengths are in millimetres. Angles that a node has for itself are in degrees; shapes show their arguments as WGSL
//! takes them. Numbers are rounded to six digits; live ones are shown as formulas of the parameters `p0`, `p1`, ….

mod aside;

use std::fmt::Write;

use chiaro_plane::{Edge, Region};

use crate::affine::Affine;
use crate::scalar::{Function, Operation, Scalar};
use crate::scene::Material;
use crate::tree::{Boolean, Joint, Profile, Solid, SolidKind};

pub use aside::{print_camera, print_lights};

/// Formulas of more operations than this are shown by their range alone.
const LONGEST_FORMULA: u32 = 40;

/// A solid and all below it.
pub fn print(solid: &Solid) -> String {
    let mut text = String::new();
    print_node(solid, 0, &mut text);
    text
}

fn print_node(solid: &Solid, depth: usize, text: &mut String) {
    let (line, children) = describe(&solid.kind);
    let _ = writeln!(text, "{:indent$}{line}", "", indent = 2 * depth);
    for child in children {
        print_node(child, depth + 1, text);
    }
}

/// A node's line, and its children.
fn describe(kind: &SolidKind) -> (String, Vec<&Solid>) {
    match kind {
        SolidKind::Empty => ("empty".into(), vec![]),
        SolidKind::Shape(row, arguments) => (format!("{} {}", row.name, list(arguments)).trim_end().into(), vec![]),
        SolidKind::Region(region) => (describe_region(region), vec![]),
        SolidKind::SphereHull(balls) => {
            let ball = |(center, radius): &([Scalar; 3], Scalar)| format!("({}) {}", list(center), number(radius));
            let balls: Vec<String> = balls.iter().map(ball).collect();
            (format!("sphere_hull {}", balls.join(", ")), vec![])
        }
        SolidKind::Boolean { operation, joint, children } => {
            let joint = joint.as_ref().map_or(String::new(), describe_joint);
            (format!("{}{joint}", boolean_name(*operation)), children.iter().map(|child| &**child).collect())
        }
        SolidKind::Transform(map, child) => (describe_map(map), vec![child]),
        SolidKind::Paint(material, child) => (describe_material(material), vec![child]),
        SolidKind::Offset(by, child) => (format!("offset {}", number(by)), vec![child]),
        SolidKind::Shell(thickness, child) => (format!("shell {}", number(thickness)), vec![child]),
        SolidKind::Twist(rate, child) => (format!("twist {} per mm", angle(rate)), vec![child]),
        SolidKind::Extrude { height, twist, scale, child } => (describe_extrusion(height, twist, scale), vec![child]),
        SolidKind::Loft(loft) => {
            let (stages, sides) = (loft.stages().len(), loft.sides());
            (format!("loft {} in {stages} stages of {sides} sides", number(&loft.height().into())), vec![])
        }
        SolidKind::Revolve { sweep, facets, child } => (describe_revolution(sweep.as_ref(), *facets), vec![child]),
        SolidKind::Slice(child) => ("slice".into(), vec![child]),
    }
}

fn boolean_name(operation: Boolean) -> &'static str {
    match operation {
        Boolean::Union => "union",
        Boolean::Difference => "difference",
        Boolean::Intersection => "intersection",
    }
}

fn describe_joint(joint: &Joint) -> String {
    let profile = match joint.profile {
        Profile::Chamfer => "chamfer",
        Profile::Fillet => "fillet",
        Profile::Smooth => "smooth",
    };
    format!(" {profile} {}", number(&joint.radius))
}

fn describe_map(map: &Affine) -> String {
    let rows = map.rows();
    let is_diagonal = (0..3).all(|i| (0..4).all(|j| i == j || rows[i][j].is(0.0)));
    if map.is_translation() {
        format!("move {} {} {}", number(&rows[0][3]), number(&rows[1][3]), number(&rows[2][3]))
    } else if is_diagonal {
        format!("scale {} {} {}", number(&rows[0][0]), number(&rows[1][1]), number(&rows[2][2]))
    } else {
        format!("matrix [{}; {}; {}]", list(&rows[0]), list(&rows[1]), list(&rows[2]))
    }
}

/// The colour, and what else is unlike what nobody painted.
fn describe_material(material: &Material) -> String {
    let unpainted = Material::default();
    let mut line = format!("paint {}", list(&material.color));
    let others = [
        ("roughness", &material.roughness, &unpainted.roughness),
        ("metallic", &material.metallic, &unpainted.metallic),
        ("emission", &material.emission, &unpainted.emission),
    ];
    for (name, value, usual) in others {
        if value != usual {
            let _ = write!(line, " {name} {}", number(value));
        }
    }
    line
}

fn describe_extrusion(height: &Scalar, twist: &Scalar, scale: &[Scalar; 2]) -> String {
    let mut line = format!("extrude {}", number(height));
    if !twist.is(0.0) {
        let _ = write!(line, " twist {}", angle(twist));
    }
    if !scale.iter().all(|factor| factor.is(1.0)) {
        let _ = write!(line, " scale {}", list(scale));
    }
    line
}

fn describe_revolution(sweep: Option<&[Scalar; 2]>, facets: Option<u32>) -> String {
    let mut line = String::from("revolve");
    if let Some([start, sweep]) = sweep {
        let _ = write!(line, " {} from {}", angle(sweep), angle(start));
    }
    if let Some(facets) = facets {
        let _ = write!(line, " facets {facets}");
    }
    line
}

/// Its numbers of contours and edges, and its bounding box: outlines may be long.
fn describe_region(region: &Region) -> String {
    let arcs = region.edges().filter(|edge| matches!(edge, Edge::Arc { .. })).count();
    let lines = region.edges().count() - arcs;
    let ([x, y], [u, v]) = region.bounds().unwrap_or_default();
    let contours = region.contours.len();
    let plural = if contours == 1 { "" } else { "s" };
    let bounds = format!("({} {}) to ({} {})", short(x), short(y), short(u), short(v));
    format!("region {contours} contour{plural}, {lines} lines, {arcs} arcs, {bounds}")
}

fn list(numbers: &[Scalar]) -> String {
    numbers.iter().map(number).collect::<Vec<_>>().join(" ")
}

fn angle(radians: &Scalar) -> String {
    match radians.constant() {
        Some(radians) => format!("{}°", short(radians.to_degrees())),
        None => format!("{} rad", number(radians)),
    }
}

/// A constant of at most six digits, or a live number's formula.
pub fn number(scalar: &Scalar) -> String {
    match scalar {
        Scalar::Constant(value) => short(*value),
        Scalar::Live(_) if scalar.size() > LONGEST_FORMULA => {
            let range = scalar.range();
            format!("live({} to {})", short(range.min), short(range.max))
        }
        Scalar::Live(expression) => match &expression.operation {
            Operation::Parameter(id) => format!("p{}", id.0),
            Operation::Apply(function, arguments) => formula(*function, arguments),
        },
    }
}

fn formula(function: Function, arguments: &[Scalar]) -> String {
    let sign = match function {
        Function::Add => "+",
        Function::Subtract => "-",
        Function::Multiply => "*",
        Function::Divide => "/",
        Function::Modulo => "%",
        Function::Power => "^",
        Function::Less => "<",
        Function::LessEqual => "<=",
        Function::Negate => return format!("-{}", number(&arguments[0])),
        _ => {
            let name = format!("{function:?}").to_lowercase();
            return format!("{name}({})", arguments.iter().map(number).collect::<Vec<_>>().join(", "));
        }
    };
    format!("({} {sign} {})", number(&arguments[0]), number(&arguments[1]))
}

/// A number with six digits at the most.
pub fn short(value: f64) -> String {
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    // Zero has no sign here.
    format!("{}", if rounded == 0.0 { 0.0 } else { rounded })
}

#[cfg(test)]
mod tests {
    use super::*;
    use chiaro_syntax::{FileId, Span};
    use chiaro_vocabulary::{Interval, rows};

    use crate::scalar::ParameterId;

    #[test]
    fn trees_are_indented_and_numbers_short() {
        let span = Span::new(FileId(0), 0..0);
        let live = Scalar::parameter(ParameterId(0), Interval::new(1.0, 2.0));
        let half = [live.clone() + Scalar::from(1.0), Scalar::from(1.0 / 3.0), Scalar::from(-0.0)];
        let shape = Solid::new(SolidKind::Shape(&rows::BOX, half.to_vec()), span);
        let moved =
            Solid::new(SolidKind::Transform(Affine::translation([1.0, 2.0, 3.0].map(Scalar::from)), shape), span);
        let ball = Solid::new(SolidKind::Shape(&rows::SPHERE, vec![live.clone()]), span);
        let joint = Some(Joint { profile: Profile::Fillet, radius: Scalar::from(0.5) });
        let children = vec![moved, ball];
        let union = Solid::new(SolidKind::Boolean { operation: Boolean::Union, joint, children }, span);
        let twisted = Solid::new(SolidKind::Twist(Scalar::from(std::f64::consts::PI / 60.0), union), span);
        let expected = "\
twist 3° per mm
  union fillet 0.5
    move 1 2 3
      box (p0 + 1) 0.333333 0
    sphere p0
";
        assert_eq!(print(&twisted), expected);
    }

    #[test]
    fn formulas_that_share_their_parts_stay_short() {
        let span = Span::new(FileId(0), 0..0);
        let mut live = Scalar::parameter(ParameterId(0), Interval::new(1.0, 2.0));
        for _ in 0..200 {
            live = live.clone() * live;
        }
        let ball = Solid::new(SolidKind::Shape(&rows::SPHERE, vec![live]), span);
        assert_eq!(print(&ball), "sphere live(-inf to inf)\n");
    }
}
