//! How languages differ from WGSL.

use super::builtins;
use super::types::{Scalar, Type};

/// A family of languages that read alike.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dialect {
    /// GLSL from version 330 and ES 300 on, and what is made after it: Shadertoy.
    Glsl,
    /// Godot's, from version 4 of the engine on: GLSL in which no name may hide another one.
    Godot4,
    /// Godot's before that: without structs, constant arrays and marks of unsigned literals.
    Godot3,
    /// HLSL from shader model 5 on.
    Hlsl,
    /// The Metal shading language.
    Metal,
}

impl Dialect {
    /// Whether it is GLSL, or made after it.
    pub(super) fn is_glsl(self) -> bool {
        matches!(self, Dialect::Glsl | Dialect::Godot4 | Dialect::Godot3)
    }

    /// Whether it is Godot's, where a name must not be that of anything else that is visible.
    pub(super) fn is_godot(self) -> bool {
        matches!(self, Dialect::Godot4 | Dialect::Godot3)
    }

    /// Whether it has structs.
    pub(super) fn has_structs(self) -> bool {
        self != Dialect::Godot3
    }

    /// Whether constants of the text may be arrays.
    pub(super) fn has_constant_arrays(self) -> bool {
        self != Dialect::Godot3
    }

    /// What the language calls a built-in function.
    pub(super) fn builtin(self, name: &str) -> Option<&'static str> {
        match self {
            Dialect::Glsl | Dialect::Godot4 | Dialect::Godot3 => builtins::glsl(name),
            Dialect::Hlsl => builtins::hlsl(name),
            Dialect::Metal => builtins::metal(name),
        }
    }

    /// What the language calls a type; of an array, its elements' type.
    pub(super) fn type_name(self, ty: &Type) -> String {
        match ty {
            Type::Scalar(scalar) => self.scalar_name(*scalar).to_owned(),
            Type::Vector(size, scalar) => match self {
                Dialect::Hlsl | Dialect::Metal => format!("{}{size}", self.scalar_name(*scalar)),
                _ => format!("{}vec{size}", glsl_prefix(*scalar)),
            },
            Type::Matrix(size) => match self {
                Dialect::Hlsl | Dialect::Metal => format!("float{size}x{size}"),
                _ => format!("mat{size}"),
            },
            Type::Struct(name) => name.clone(),
            Type::Array(element, _) => self.type_name(element),
            Type::Nothing => "void".to_owned(),
        }
    }

    fn scalar_name(self, scalar: Scalar) -> &'static str {
        match scalar.concrete() {
            Scalar::Bool => "bool",
            Scalar::I32 => "int",
            Scalar::U32 => "uint",
            _ => "float",
        }
    }

    /// Words of the language that a name may not be.
    pub(super) fn reserves(self, name: &str) -> bool {
        let own: &[&str] = match self {
            Dialect::Glsl | Dialect::Godot4 | Dialect::Godot3 => &GLSL_WORDS,
            Dialect::Hlsl => &HLSL_WORDS,
            Dialect::Metal => &METAL_WORDS,
        };
        own.contains(&name)
            || (self.is_glsl() && (name.starts_with("gl_") || name.contains("__")))
            || (self.is_godot() && GODOT_WORDS.contains(&name))
    }

    /// All words that some language keeps for itself, and what it calls its built-in functions.
    pub(crate) fn words() -> impl Iterator<Item = &'static str> {
        let reserved = [&GLSL_WORDS[..], &GODOT_WORDS, &HLSL_WORDS, &METAL_WORDS].into_iter().flatten().copied();
        reserved.chain(builtins::words())
    }

    /// What a constant of the text starts with.
    pub(super) fn constant(self) -> &'static str {
        match self {
            Dialect::Glsl | Dialect::Godot4 | Dialect::Godot3 => "const",
            Dialect::Hlsl => "static const",
            Dialect::Metal => "constant",
        }
    }
}

fn glsl_prefix(scalar: Scalar) -> &'static str {
    match scalar.concrete() {
        Scalar::Bool => "b",
        Scalar::I32 => "i",
        Scalar::U32 => "u",
        _ => "",
    }
}

/// Words of GLSL, Shadertoy and Godot that a WGSL name may be.
const GLSL_WORDS: [&str; 64] = [
    "active",
    "asm",
    "attribute",
    "buffer",
    "cast",
    "centroid",
    "char",
    "class",
    "coherent",
    "common",
    "double",
    "enum",
    "extern",
    "external",
    "filter",
    "fixed",
    "flat",
    "global",
    "goto",
    "half",
    "hint",
    "highp",
    "image",
    "inline",
    "inout",
    "input",
    "instance",
    "interface",
    "invariant",
    "layout",
    "long",
    "lowp",
    "mediump",
    "namespace",
    "noinline",
    "noperspective",
    "out",
    "output",
    "partition",
    "patch",
    "precise",
    "precision",
    "public",
    "readonly",
    "resource",
    "sample",
    "sampler",
    "shared",
    "short",
    "signed",
    "sizeof",
    "smooth",
    "static",
    "subroutine",
    "superp",
    "template",
    "texture",
    "this",
    "typedef",
    "uniform",
    "union",
    "unsigned",
    "using",
    "varying",
];

/// Words of Godot, beside those of GLSL, that a WGSL name may be.
const GODOT_WORDS: [&str; 5] = ["E", "PI", "TAU", "render_mode", "shader_type"];

/// Words of HLSL, and of what Unity includes, that a WGSL name may be.
const HLSL_WORDS: [&str; 57] = [
    "PI",
    "auto",
    "asm",
    "cbuffer",
    "centroid",
    "char",
    "class",
    "column_major",
    "compile",
    "discard",
    "double",
    "dword",
    "export",
    "extern",
    "fixed",
    "groupshared",
    "half",
    "in",
    "inline",
    "inout",
    "input",
    "interface",
    "line",
    "lineadj",
    "linear",
    "long",
    "matrix",
    "namespace",
    "nointerpolation",
    "noperspective",
    "out",
    "packoffset",
    "pass",
    "point",
    "precise",
    "register",
    "row_major",
    "sample",
    "sampler",
    "shared",
    "short",
    "signed",
    "snorm",
    "stateblock",
    "static",
    "string",
    "tbuffer",
    "technique",
    "template",
    "texture",
    "triangle",
    "triangleadj",
    "typedef",
    "uniform",
    "unorm",
    "unsigned",
    "vector",
];

/// Words of Metal and C++ that a WGSL name may be.
const METAL_WORDS: [&str; 52] = [
    "and",
    "asm",
    "auto",
    "catch",
    "char",
    "class",
    "constant",
    "constexpr",
    "default",
    "delete",
    "device",
    "double",
    "enum",
    "explicit",
    "extern",
    "fragment",
    "friend",
    "goto",
    "half",
    "inline",
    "kernel",
    "long",
    "mutable",
    "namespace",
    "new",
    "not",
    "operator",
    "or",
    "private",
    "protected",
    "public",
    "register",
    "sampler",
    "short",
    "signed",
    "sizeof",
    "static",
    "template",
    "texture",
    "this",
    "thread",
    "threadgroup",
    "throw",
    "try",
    "typedef",
    "typename",
    "union",
    "unsigned",
    "using",
    "vertex",
    "virtual",
    "xor",
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn types_have_the_names_of_the_language() {
        let vector = Type::Vector(3, Scalar::U32);
        assert_eq!(Dialect::Glsl.type_name(&vector), "uvec3");
        assert_eq!(Dialect::Hlsl.type_name(&vector), "uint3");
        assert_eq!(Dialect::Metal.type_name(&Type::Matrix(2)), "float2x2");
    }
}
