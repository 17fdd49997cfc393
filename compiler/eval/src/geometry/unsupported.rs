//! OpenSCAD's modules that there are no solids for yet, and its old names: errors that say so.

use chiaro_syntax::Diagnostic;

use super::instance::{Instance, Module};
use super::{Built, Stop};

pub(super) const MODULES: &[Module] = &[
    unsupported("text", &["text", "size", "font", "direction", "language", "script", "halign", "valign", "spacing"]),
    unsupported("import", &["file", "layer", "convexity", "origin", "scale", "width", "height", "center"]),
    unsupported("surface", &["file", "center", "convexity", "invert"]),
    unsupported("roof", &["method", "convexity"]),
    replaced("import_stl"),
    replaced("import_off"),
    replaced("import_dxf"),
    replaced("dxf_linear_extrude"),
    replaced("dxf_rotate_extrude"),
    replaced("child"),
];

const fn unsupported(name: &'static str, positional: &'static [&'static str]) -> Module {
    Module { name, positional, named: &[], build: refuse }
}

const fn replaced(name: &'static str) -> Module {
    Module { name, positional: &["file", "layer", "convexity", "origin"], named: &[], build: refuse }
}

fn refuse(instance: &mut Instance) -> Built {
    let diagnostic = Diagnostic::error(instance.head, format!("`{}` is not supported yet", instance.name));
    let diagnostic = match hint(instance.name) {
        Some(hint) => diagnostic.with_hint(hint),
        None => diagnostic,
    };
    Err(Stop::Error(Box::new(diagnostic)))
}

fn hint(name: &str) -> Option<&'static str> {
    match name {
        "text" => Some("letters can be drawn with `polygon`; `*` in front of it leaves it out"),
        "import" => {
            Some("`include` and `use` take programs and dumps, but no meshes; `*` in front of it leaves it out")
        }
        "surface" => Some("extrusions, one for each step of height, come near it; `*` in front of it leaves it out"),
        "roof" => Some("over a rectangle, `linear_extrude(…, scale = …)` makes one; `*` in front of it leaves it out"),
        "import_stl" | "import_off" | "import_dxf" => Some("OpenSCAD's name for it is `import` by now"),
        "dxf_linear_extrude" => Some("OpenSCAD's way to write it is `linear_extrude() import(…)` by now"),
        "dxf_rotate_extrude" => Some("OpenSCAD's way to write it is `rotate_extrude() import(…)` by now"),
        "child" => Some("OpenSCAD's name for it is `children` by now"),
        _ => None,
    }
}
