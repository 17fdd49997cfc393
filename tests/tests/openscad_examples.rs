//! The programs that OpenSCAD's package brings, which nobody here wrote: each compiles, or says by name what is not
//! supported yet.

use std::path::Path;

use chiaro_compiler::syntax::Severity;
use chiaro_compiler::{Options, compile};
use chiaro_tests::world::DiskWorld;
use chiaro_tests::{OPENSCAD_EXAMPLES, scad_files};

/// The examples that need what there isn't yet, with parts of the messages that say so: each error has one of them, and
/// each of them occurs. (`MCAD` is a library that the package does not bring.)
const UNSUPPORTED: &[(&str, &[&str])] = &[
    ("Advanced/GEB.scad", &["`text` is not supported"]),
    ("Advanced/children.scad", &["`text` is not supported"]),
    ("Advanced/children_indexed.scad", &["`text` is not supported"]),
    ("Advanced/surface_image.scad", &["`surface` is not supported"]),
    ("Basics/LetterBlock.scad", &["`text` is not supported"]),
    ("Basics/logo_and_text.scad", &["`text` is not supported"]),
    ("Basics/projection.scad", &["`import` is not supported"]),
    ("Basics/rotate_extrude.scad", &["`text` is not supported"]),
    ("Basics/text_on_cube.scad", &["`text` is not supported"]),
    ("Functions/polygon_areas.scad", &["`text` is not supported"]),
    ("Functions/recursion.scad", &["`text` is not supported"]),
    ("Old/example007.scad", &["`import` is not supported"]),
    ("Old/example008.scad", &["`import` is not supported"]),
    (
        "Old/example009.scad",
        &["`import` is not supported", "`dxf_dim` is not supported", "`dxf_cross` is not supported"],
    ),
    ("Old/example010.scad", &["`surface` is not supported"]),
    ("Old/example012.scad", &["`import` is not supported"]),
    ("Old/example013.scad", &["`import` is not supported"]),
    ("Old/example015.scad", &["`import` is not supported"]),
    ("Old/example016.scad", &["`import` is not supported"]),
    ("Old/example021.scad", &["the shadow of this solid is not supported"]),
    ("Old/example023.scad", &["there is no function `8bit_polyfont`"]),
    ("Parametric/sign.scad", &["`text` is not supported"]),
];

#[test]
fn every_example_compiles_or_names_what_it_needs() {
    let files = scad_files(Path::new(OPENSCAD_EXAMPLES));
    assert!(files.len() >= 40, "OpenSCAD's examples are missing: run tools/setup.sh --tests");
    let mut surprises = Vec::new();
    for path in files {
        let name = path.strip_prefix(OPENSCAD_EXAMPLES).unwrap_or(&path).display().to_string();
        let compilation = compile(&DiskWorld, &path.to_string_lossy(), &Options::default());
        let errors: Vec<&str> = compilation
            .diagnostics
            .iter()
            .filter(|diagnostic| diagnostic.severity == Severity::Error)
            .map(|diagnostic| diagnostic.message.as_str())
            .collect();
        let as_expected = match UNSUPPORTED.iter().find(|(example, _)| *example == name) {
            Some((_, needs)) => is_about(&errors, needs),
            None => errors.is_empty() && compilation.scene.is_some(),
        };
        if !as_expected {
            surprises.push(format!("{name}: {errors:?}"));
        }
    }
    assert!(surprises.is_empty(), "{}", surprises.join("\n"));
}

/// Whether each error is about one of the needs, and each need has an error.
fn is_about(errors: &[&str], needs: &[&str]) -> bool {
    errors.iter().all(|error| needs.iter().any(|need| error.contains(need)))
        && needs.iter().all(|need| errors.iter().any(|error| error.contains(need)))
}
