//! Runs every scene of `scenes/` against the expectations written in it.

use std::fs;
use std::path::Path;

use chiaro_tests::{blessing, expectations, scad_files};
use libtest_mimic::{Arguments, Failed, Trial};

fn main() {
    let arguments = Arguments::from_args();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
    let trials = scad_files(&folder).into_iter().map(|path| {
        let name = path.strip_prefix(&folder).unwrap_or(&path).display().to_string();
        Trial::test(name, move || check(&path))
    });
    let trials: Vec<Trial> = trials.collect();
    assert!(trials.len() >= 190, "only {} scenes are in {}", trials.len(), folder.display());
    libtest_mimic::run(&arguments, trials).exit();
}

fn check(path: &Path) -> Result<(), Failed> {
    let expected = fs::read_to_string(path)?;
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let actual = expectations::actual(&name, &expected);
    if actual == expected {
        return Ok(());
    }
    if blessing() {
        return Ok(fs::write(path, actual)?);
    }
    Err(difference(&expected, &actual).into())
}

/// The lines that are only in one of both texts.
fn difference(expected: &str, actual: &str) -> String {
    let only = |sign: char, of: &str, other: &str| -> String {
        let lines = of.lines().filter(|line| !other.lines().any(|same| same == *line));
        lines.map(|line| format!("{sign} {line}\n")).collect()
    };
    let lines = only('-', expected, actual) + &only('+', actual, expected);
    format!("expected (-) and actual (+) differ; CHIARO_BLESS=1 accepts the actual\n{lines}")
}
