//! The test suite: scenes as text in, diagnostics, facts, distances and small pictures out.
//!
//! * `tests/scenes.rs` runs every file of `scenes/` against the expectations written in it.
//! * The other files of `tests/` are suites of their own.
//!
//! `CHIARO_BLESS=1 cargo test -p chiaro_tests` writes what came out into the expectations. Read the difference before
//! committing it.

pub mod claims;
pub mod corpus;
pub mod expectations;
pub mod exported;
pub mod likeness;
pub mod programs;
pub mod sampling;
pub mod world;

use std::fs;
use std::path::{Path, PathBuf};

pub use world::MemoryWorld;

/// Where Debian's package puts OpenSCAD's examples.
pub const OPENSCAD_EXAMPLES: &str = "/usr/share/openscad/examples";

/// Whether expectations are to be rewritten instead of checked.
pub fn blessing() -> bool {
    std::env::var_os("CHIARO_BLESS").is_some_and(|value| value == "1")
}

/// The folder of the workspace, from which tests read scenes and run the command.
pub fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The scenes of a folder and the folders in it, sorted by name. None, if the folder can't be read.
pub fn scad_files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            found.extend(scad_files(&path));
        } else if path.extension().is_some_and(|ending| ending == "scad" || ending == "csg") {
            found.push(path);
        }
    }
    found.sort();
    found
}
