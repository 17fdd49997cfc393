//! The WGSL of the vocabulary, as text and as naga's module.

use std::sync::OnceLock;

use naga::valid::{Capabilities, ValidationFlags, Validator};

const SOURCE: &str = concat!(
    include_str!("../wgsl/constants.wgsl"),
    "\n",
    include_str!("../wgsl/solids.wgsl"),
    "\n",
    include_str!("../wgsl/planes.wgsl"),
    "\n",
    include_str!("../wgsl/warps.wgsl"),
    "\n",
    include_str!("../wgsl/sections.wgsl"),
    "\n",
    include_str!("../wgsl/joints.wgsl"),
    "\n",
    include_str!("../wgsl/outlines.wgsl"),
);

/// All functions of the vocabulary as one WGSL text, with their comments.
pub fn source() -> &'static str {
    SOURCE
}

/// The vocabulary as naga's module: functions and constants, no entry point. Parsed and validated at the first call.
///
/// # Panics
///
/// If the vocabulary's own WGSL is invalid, which the tests rule out.
pub fn module() -> &'static naga::Module {
    static MODULE: OnceLock<naga::Module> = OnceLock::new();
    MODULE.get_or_init(|| parsed(SOURCE))
}

/// The same in double precision, which naga knows beyond WGSL: so no constant is ever rounded to single precision.
///
/// # Panics
///
/// As [`module`].
pub(crate) fn double_module() -> naga::Module {
    parsed(&in_double(SOURCE))
}

/// The text with f64 in the place of f32, and with all floating-point literals marked as such.
fn in_double(source: &str) -> String {
    let mut double = String::with_capacity(source.len() + source.len() / 8);
    let mut rest = source;
    while let Some(start) = rest.find(|c: char| c.is_alphanumeric() || c == '_') {
        let (between, from) = rest.split_at(start);
        let (token, behind) = from.split_at(token_len(from));
        double += between;
        double += if token == "f32" { "f64" } else { token };
        if token.starts_with(|c: char| c.is_ascii_digit()) && token.contains(['.', 'e']) {
            double += "lf";
        }
        rest = behind;
    }
    double + rest
}

/// How long the word or number is that a text begins with. Numbers may have a point and a signed exponent.
fn token_len(text: &str) -> usize {
    let is_number = text.starts_with(|c: char| c.is_ascii_digit());
    let mut last = ' ';
    let end = text.find(|c: char| {
        let in_exponent = last == 'e' && (c == '-' || c == '+');
        last = c;
        !(c.is_alphanumeric() || c == '_' || (is_number && (c == '.' || in_exponent)))
    });
    end.unwrap_or(text.len())
}

fn parsed(source: &str) -> naga::Module {
    let module = naga::front::wgsl::parse_str(source)
        .unwrap_or_else(|error| panic!("{}", error.emit_to_string_with_path(source, "vocabulary.wgsl")));
    let validated = Validator::new(ValidationFlags::all(), Capabilities::FLOAT64).validate(&module);
    if let Err(error) = validated {
        panic!("{}", error.emit_to_string_with_path(source, "vocabulary.wgsl"));
    }
    module
}

#[cfg(test)]
mod tests {
    use naga::{ScalarKind, TypeInner, VectorSize};

    use super::*;
    use crate::rows::rows;
    use crate::table::{Kind, Type};

    /// Words of HLSL, MSL, GLSL or WGSL that one might take for a name here.
    const RESERVED: &[&str] = &[
        "half",
        "line",
        "point",
        "triangle",
        "sample",
        "input",
        "output",
        "discard",
        "filter",
        "active",
        "common",
        "partition",
        "fixed",
        "vector",
        "matrix",
        "texture",
        "sampler",
        "buffer",
        "shared",
        "union",
        "template",
        "this",
        "using",
        "external",
        "interface",
        "flat",
        "noise",
        "smooth",
        "inline",
        "register",
        "thread",
        "device",
        "kernel",
        "constant",
        "vertex",
        "fragment",
        "centroid",
        "linear",
        "static",
        "typedef",
        "unsigned",
        "signed",
        "long",
        "short",
        "double",
        "char",
        "int",
        "float",
        "bool",
        "void",
        "export",
        "import",
        "pass",
        "technique",
    ];

    fn type_of(ty: naga::Handle<naga::Type>) -> Option<Type> {
        match module().types[ty].inner {
            TypeInner::Scalar(scalar) if scalar.kind == ScalarKind::Float => Some(Type::Float),
            TypeInner::Vector { size: VectorSize::Bi, .. } => Some(Type::Vec2),
            TypeInner::Vector { size: VectorSize::Tri, .. } => Some(Type::Vec3),
            _ => None,
        }
    }

    #[test]
    fn literals_and_types_become_double() {
        let text = "fn f(p_2: vec3<f32>) -> f32 { return 2.0 * p_2.x - 1e-30 + 0.5e+3*TAU; } // 3 of f32";
        let double = "fn f(p_2: vec3<f64>) -> f64 { return 2.0lf * p_2.x - 1e-30lf + 0.5e+3lf*TAU; } // 3 of f64";
        assert_eq!(in_double(text), double);
    }

    #[test]
    fn every_row_has_its_function() {
        for row in rows() {
            let functions = || module().functions.iter().map(|(_, function)| function);
            let function = functions().find(|function| function.name.as_deref() == Some(row.function));
            let function = function.unwrap_or_else(|| panic!("{} has no function {}", row.name, row.function));
            let (first, result) = match row.kind {
                Kind::Solid => (Some(("p", Type::Vec3)), Some(Type::Float)),
                Kind::Plane => (Some(("p", Type::Vec2)), Some(Type::Float)),
                Kind::Warp => (Some(("p", Type::Vec3)), Some(Type::Vec3)),
                Kind::Section => (Some(("p", Type::Vec3)), Some(Type::Vec2)),
                Kind::Adjust => (Some(("d", Type::Float)), Some(Type::Float)),
                Kind::Helper => (None, None),
            };
            let of_row = row.parameters.iter().map(|parameter| (parameter.name, parameter.ty));
            let expected: Vec<_> = first.into_iter().chain(of_row).collect();
            let found: Vec<_> = (function.arguments.iter())
                .map(|argument| (argument.name.as_deref().unwrap(), type_of(argument.ty).unwrap()))
                .collect();
            assert_eq!(found, expected, "arguments of {}", row.function);
            if let Some(result) = result {
                assert_eq!(type_of(function.result.as_ref().unwrap().ty), Some(result), "{}", row.function);
            }
        }
    }

    #[test]
    fn names_survive_every_target_language() {
        for (_, function) in module().functions.iter() {
            let arguments = function.arguments.iter().map(|argument| argument.name.as_deref().unwrap());
            let locals = function.named_expressions.values().map(String::as_str);
            for name in arguments.chain(locals).chain(function.name.as_deref()) {
                let snake = name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_');
                let ends_well = name.ends_with(|c: char| c.is_ascii_lowercase());
                assert!(snake && ends_well && !name.contains("__"), "{name}");
                assert!(!RESERVED.contains(&name), "{name} is reserved");
            }
        }
    }

    #[test]
    fn names_are_unique_and_examples_show_them() {
        for (index, row) in rows().iter().enumerate() {
            assert!(rows()[..index].iter().all(|other| other.name != row.name), "{} twice", row.name);
            assert!(!row.module || !row.example.is_empty(), "{} has no example", row.name);
            assert!(row.example.is_empty() || row.example.contains(&format!("{}(", row.name)), "{}", row.example);
        }
    }

    #[test]
    fn functions_are_straight_line_code() {
        for (_, function) in module().functions.iter() {
            let branches = |statement: &naga::Statement| {
                !matches!(
                    statement,
                    naga::Statement::Emit(_) | naga::Statement::Call { .. } | naga::Statement::Return { .. }
                )
            };
            assert!(!function.body.iter().any(branches), "{:?} branches", function.name);
        }
    }
}
