//! Every scene there is to test with: our examples, those of the suite, and the ones that OpenSCAD's package brings.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use chiaro_compiler::{Compilation, Options, Scene, compile};

use crate::world::DiskWorld;
use crate::{OPENSCAD_EXAMPLES, expectations, scad_files, workspace};

/// A scene that compiles, with the file it is from.
#[derive(Debug)]
pub struct Subject {
    /// The file.
    pub path: PathBuf,
    /// What was compiled.
    pub compilation: Compilation,
    /// The scene, taken out of it.
    pub scene: Scene,
}

/// Every scene that compiles. All of our examples do, and those scenes of the suite that expect no error; of OpenSCAD's
/// examples, those without a missing feature.
pub fn every_scene() -> &'static [Subject] {
    static SCENES: OnceLock<Vec<Subject>> = OnceLock::new();
    SCENES.get_or_init(|| {
        let ours: Vec<Subject> = examples().into_iter().map(|path| compiled(&path)).collect();
        let small = scad_files(&workspace().join("tests/scenes"));
        let small: Vec<Subject> = small.iter().filter_map(|path| small_scene(path)).collect();
        let theirs = scad_files(Path::new(OPENSCAD_EXAMPLES));
        let theirs: Vec<Subject> = theirs.into_iter().filter_map(from_disk).collect();
        assert!(small.len() >= 140, "only {} scenes of the suite compile", small.len());
        assert!(theirs.len() >= 25, "only {} of OpenSCAD's examples compile: run tools/setup.sh --tests", theirs.len());
        ours.into_iter().chain(small).chain(theirs).collect()
    })
}

/// The files of our examples.
pub fn examples() -> Vec<PathBuf> {
    let examples = scad_files(&workspace().join("examples_csg"));
    assert!(examples.len() >= 20, "our examples are not where they should be");
    examples
}

/// A scene on disk that has to compile.
pub fn compiled(path: &Path) -> Subject {
    from_disk(path.to_owned()).unwrap_or_else(|| panic!("{}: it doesn't compile", path.display()))
}

fn from_disk(path: PathBuf) -> Option<Subject> {
    let compilation = compile(&DiskWorld, &path.to_string_lossy(), &Options::default());
    subject(path, compilation)
}

/// A scene of the suite. Unless it expects an error it has to compile.
fn small_scene(path: &Path) -> Option<Subject> {
    let bytes = fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let text = String::from_utf8_lossy(&bytes);
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let subject = subject(path.to_owned(), expectations::compiled(&name, &text));
    let expects_error = text.lines().any(|line| line.starts_with("// Error:"));
    assert!(subject.is_some() || expects_error, "{}: it doesn't compile", path.display());
    subject
}

fn subject(path: PathBuf, mut compilation: Compilation) -> Option<Subject> {
    let scene = compilation.scene.take()?;
    Some(Subject { path, compilation, scene })
}
