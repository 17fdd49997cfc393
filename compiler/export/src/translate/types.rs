//! The types of the WGSL that scenes are written in.

use std::fmt;

/// The type of a value. What is not among them does not occur in exported code.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Type {
    /// A number or a truth value.
    Scalar(Scalar),
    /// Two to four of them.
    Vector(usize, Scalar),
    /// A square matrix of so many columns of floats.
    Matrix(usize),
    /// A struct of the text.
    Struct(String),
    /// So many of one type.
    Array(Box<Type>, usize),
    /// What functions without a result return.
    Nothing,
}

/// What vectors are made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scalar {
    Bool,
    I32,
    U32,
    F32,
    /// A whole number literal, which fits all types of numbers.
    AbstractInt,
    /// A literal with a fraction: a float.
    AbstractFloat,
}

impl Scalar {
    /// The type that WGSL gives a value which nothing else decides.
    pub(crate) fn concrete(self) -> Self {
        match self {
            Scalar::AbstractInt => Scalar::I32,
            Scalar::AbstractFloat => Scalar::F32,
            other => other,
        }
    }

    pub(crate) fn is_abstract(self) -> bool {
        matches!(self, Scalar::AbstractInt | Scalar::AbstractFloat)
    }
}

impl Type {
    pub(crate) const BOOL: Type = Type::Scalar(Scalar::Bool);
    pub(crate) const F32: Type = Type::Scalar(Scalar::F32);

    /// The number of components of a scalar or a vector.
    pub(crate) fn width(&self) -> usize {
        match self {
            Type::Vector(size, _) => *size,
            _ => 1,
        }
    }

    /// What a scalar or vector is made of; of a matrix, floats.
    pub(crate) fn scalar(&self) -> Option<Scalar> {
        match self {
            Type::Scalar(scalar) | Type::Vector(_, scalar) => Some(*scalar),
            Type::Matrix(_) => Some(Scalar::F32),
            _ => None,
        }
    }

    /// The scalar or vector of this many of them.
    pub(crate) fn of(width: usize, scalar: Scalar) -> Type {
        if width == 1 { Type::Scalar(scalar) } else { Type::Vector(width, scalar) }
    }

    /// The same with literals' types decided.
    pub(crate) fn concrete(&self) -> Type {
        match self {
            Type::Scalar(scalar) => Type::Scalar(scalar.concrete()),
            Type::Vector(size, scalar) => Type::Vector(*size, scalar.concrete()),
            other => other.clone(),
        }
    }

    pub(crate) fn is_matrix(&self) -> bool {
        matches!(self, Type::Matrix(_))
    }

    pub(crate) fn is_vector(&self) -> bool {
        matches!(self, Type::Vector(..))
    }
}

impl fmt::Display for Type {
    /// As WGSL writes it.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = |scalar: &Scalar| match scalar.concrete() {
            Scalar::Bool => "bool",
            Scalar::I32 => "i32",
            Scalar::U32 => "u32",
            _ => "f32",
        };
        match self {
            Type::Scalar(scalar) => f.write_str(name(scalar)),
            Type::Vector(size, scalar) => write!(f, "vec{size}<{}>", name(scalar)),
            Type::Matrix(size) => write!(f, "mat{size}x{size}<f32>"),
            Type::Struct(name) => f.write_str(name),
            Type::Array(element, count) => write!(f, "array<{element}, {count}>"),
            Type::Nothing => f.write_str("nothing"),
        }
    }
}
