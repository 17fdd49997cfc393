//! The programs that OpenSCAD's package brings, which nobody here wrote: each compiles, or says by name what is not
//! supported yet.

use std::path::Path;

use chiaro_compiler::syntax::Severity;
use chiaro_compiler::{Options, compile};
use chiaro_tests::world::DiskWorld;
use chiaro_tests::{OPENSCAD_EXAMPLES, scad_files};

/// The examples that need what there isn't yet, with a part of the message that says so.
const UNSUPPORTED: &[(&str, &str)] = &[];

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
            Some((_, needs)) => !errors.is_empty() && errors.iter().all(|error| error.contains(needs)),
            None => errors.is_empty() && compilation.scene.is_some(),
        };
        if !as_expected {
            surprises.push(format!("{name}: {errors:?}"));
        }
    }
    assert!(surprises.is_empty(), "{}", surprises.join("\n"));
}
