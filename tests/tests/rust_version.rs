//! The Rust version that the workspace states is one that all of its dependencies accept, and the one that README names.

use std::fs;
use std::process::Command;

use chiaro_tests::workspace;
use serde_json::Value;

/// A version's major and minor number.
type Version = (u32, u32);

fn version(text: &str) -> Version {
    let mut parts = text.split('.').map(|part| part.parse().unwrap_or_else(|_| panic!("{text} is no version")));
    (parts.next().unwrap(), parts.next().unwrap_or(0))
}

/// The output of a command that has to succeed.
fn output(command: &mut Command) -> String {
    let output = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    assert!(output.status.success(), "{command:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// The packages that are built on this machine, as `cargo metadata` describes them. Those of other platforms need not
/// be here.
fn packages() -> Vec<Value> {
    let about = output(Command::new("rustc").arg("-vV"));
    let host = about.lines().find_map(|line| line.strip_prefix("host: ")).unwrap();
    let metadata = output(
        Command::new(env!("CARGO"))
            .args(["metadata", "--locked", "--offline", "--format-version", "1", "--filter-platform", host])
            .current_dir(workspace()),
    );
    let mut metadata: Value = serde_json::from_str(&metadata).unwrap();
    let Value::Array(packages) = metadata["packages"].take() else { panic!("cargo lists no packages") };
    packages
}

fn stated_version() -> Version {
    let manifest = fs::read_to_string(workspace().join("Cargo.toml")).unwrap();
    let stated = manifest.lines().find_map(|line| line.strip_prefix("rust-version = ")).unwrap();
    version(stated.trim_matches('"'))
}

#[test]
fn no_dependency_needs_a_newer_rust_than_is_stated() {
    let stated = stated_version();
    let packages = packages();
    let mut with_version = 0;
    for package in &packages {
        let Some(needed) = package["rust_version"].as_str() else { continue };
        let (name, own) = (package["name"].as_str().unwrap(), package["source"].is_null());
        assert!(version(needed) <= stated, "{name} needs Rust {needed}, and Cargo.toml states {stated:?}");
        assert!(!own || version(needed) == stated, "{name} states {needed}, not the workspace's version");
        with_version += 1;
    }
    // The workspace's own members alone are 17.
    assert!(with_version > 100, "only {with_version} of {} packages state a version", packages.len());
}

#[test]
fn the_readme_names_the_stated_version() {
    let readme = fs::read_to_string(workspace().join("README.md")).unwrap();
    let (_, rest) = readme.split_once("[Rust](https://rustup.rs) ").expect("README names Rust");
    let named = rest.split_once(" or newer").expect("README says which Rust or newer").0;
    assert_eq!(version(named), stated_version());
}
