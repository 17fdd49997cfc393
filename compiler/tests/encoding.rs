//! Scenes whose bytes are not UTF-8.

use chiaro_compiler::syntax::{Diagnostic, Severity};
use chiaro_compiler::{Options, World, compile};

/// A scene and the file that it uses, as bytes.
struct Files<'a>(&'a [u8], &'a [u8]);

impl World for Files<'_> {
    fn find(&self, _: &str, path: &str) -> Option<String> {
        (path == "part.scad").then(|| path.to_owned())
    }

    fn read(&self, name: &str) -> Result<Vec<u8>, String> {
        Ok(if name == "part.scad" { self.1 } else { self.0 }.to_vec())
    }
}

/// What is told of a scene that compiles.
fn told(scene: &[u8], part: &[u8]) -> Vec<Diagnostic> {
    let compilation = compile(&Files(scene, part), "scene.scad", &Options::default());
    assert!(compilation.scene.is_some(), "{:?}", compilation.diagnostics);
    compilation.diagnostics
}

#[test]
fn a_bare_no_break_space_is_white_space() {
    assert!(told(b"cube(\xa03);\xa0", b"").is_empty());
}

#[test]
fn other_bytes_count_as_latin_1_with_one_warning_for_each_file() {
    let told = told(b"use <part.scad>\necho(\"caf\xe9\", \"\xfc\", name()); cube(1);", b"function name() = \"\xd6l\";");
    let warnings: Vec<&str> =
        told.iter().filter(|told| told.severity == Severity::Warning).map(|told| &*told.message).collect();
    assert_eq!(warnings.len(), 2, "{told:?}");
    assert!(warnings.contains(&"this byte is no UTF-8, and counts as `é`"));
    assert!(warnings.contains(&"this byte is no UTF-8, and counts as `Ö`"));
    assert!(told.iter().any(|told| told.message == "ECHO: \"café\", \"ü\", \"Öl\""), "{told:?}");
}

#[test]
fn a_byte_outside_of_texts_is_still_no_token() {
    let compilation = compile(&Files(b"cube(\xff);", b""), "scene.scad", &Options::default());
    assert!(compilation.scene.is_none());
}
