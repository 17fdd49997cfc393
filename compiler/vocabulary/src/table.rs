//! The table: one row for each function of the vocabulary.

use crate::bounds::Bounds;
use crate::form::Form;
use crate::interval::Interval;

/// What is known of a distance function's values, apart from its Lipschitz constant. From strong to weak.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Class {
    /// The signed distance, everywhere.
    Exact,
    /// The distance outside; inside, the sign is right and the magnitude at most the distance.
    ExactOutside,
    /// The sign is right everywhere and the magnitude, divided by the Lipschitz constant, at most the distance.
    Bound,
}

/// What a function of the vocabulary is for, and so the first arguments it takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// `(p: vec3, parameters…) -> f32`: the distance to a solid.
    Solid,
    /// `(p: vec2, parameters…) -> f32`: the distance to a plane shape.
    Plane,
    /// `(p: vec3, parameters…) -> vec3`: where a warped solid is to be asked.
    Warp,
    /// `(p: vec3, parameters…) -> vec2`: where a solid made from a plane shape asks that shape.
    Section,
    /// `(d: f32, parameters…) -> f32`: changes a distance.
    Adjust,
    /// A building block of other functions or of n-ary reductions, called by name from the field; its signature is
    /// its own.
    Helper,
}

/// A parameter's type in WGSL. In [`Row::bounds`] and in the solid tree, arguments are flattened to numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Type {
    /// One number.
    Float,
    /// Two numbers.
    Vec2,
    /// Three numbers.
    Vec3,
}

impl Type {
    /// How many numbers it takes.
    pub fn len(self) -> usize {
        match self {
            Type::Float => 1,
            Type::Vec2 => 2,
            Type::Vec3 => 3,
        }
    }

    /// Never: every type takes a number.
    pub fn is_empty(self) -> bool {
        false
    }
}

/// What a number means, for diagnostics and the manual.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Unit {
    /// A length in millimetres that has to be positive, or there is no solid.
    Size,
    /// A length in millimetres of either sign.
    Length,
    /// An angle: degrees in scenes, radians in WGSL.
    Angle,
    /// A direction, of length 1 in WGSL.
    Direction,
    /// A plain number.
    Number,
}

/// One parameter of a row, as the WGSL function takes it.
#[derive(Clone, Copy, Debug)]
pub struct Parameter {
    /// Its name, in scenes and in WGSL.
    pub name: &'static str,
    /// Its type in WGSL.
    pub ty: Type,
    /// Its unit.
    pub unit: Unit,
    /// Its value in scenes where none is given, for every component; none means that it must be given.
    pub default: Option<f64>,
    /// One line of manual.
    pub manual: &'static str,
}

/// One function of the vocabulary.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// Its name: in the dump of a solid, and in scenes if [`module`](Self::module) says so.
    pub name: &'static str,
    /// The WGSL function.
    pub function: &'static str,
    /// What it is for.
    pub kind: Kind,
    /// Its parameters behind the first argument, in WGSL's order.
    pub parameters: &'static [Parameter],
    /// What its values are. For a warp or an adjustment: the best class it can hand on.
    pub class: Class,
    /// Whether scenes instantiate it by its name with just these parameters.
    pub module: bool,
    /// Whether turning the shape about the origin changes nothing, so that a rotation above it can be left out.
    pub round: bool,
    /// What is known of its faces.
    pub form: &'static Form,
    /// A box around a shape for all values of its parameters, flattened.
    pub bounds: fn(&[Interval]) -> Bounds,
    /// One line of manual.
    pub manual: &'static str,
    /// A scene that shows it; empty for what has no module.
    pub example: &'static str,
}

impl Row {
    /// How many numbers its parameters take together.
    pub fn arity(&self) -> usize {
        self.parameters.iter().map(|parameter| parameter.ty.len()).sum()
    }
}

/// Rows are the same if their names are: the table holds each name once.
impl PartialEq for Row {
    fn eq(&self, other: &Row) -> bool {
        self.name == other.name
    }
}

impl Eq for Row {}

impl std::hash::Hash for Row {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        self.name.hash(state);
    }
}
