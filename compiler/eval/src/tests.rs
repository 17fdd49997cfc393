//! Tests of whole programs: text in, echoes, messages and solids out.

mod language;
mod limits;
mod live;
mod messages;

use std::collections::BTreeMap;

use chiaro_solid::{LiveParameter, print};
use chiaro_syntax::{Severity, SourceFile, Sources};

use crate::{Options, STACK_BYTES, World, evaluate};

/// What a program came to.
#[derive(Debug, Default)]
struct Outcome {
    echoes: Vec<String>,
    notes: Vec<String>,
    warnings: Vec<String>,
    /// Each with the place and its hints.
    errors: Vec<String>,
    /// The solid tree, printed.
    solid: Option<String>,
    parameters: Vec<LiveParameter>,
}

/// Files by name. Names are paths from one root.
struct Files(BTreeMap<&'static str, &'static str>);

impl World for Files {
    fn find(&self, _: &str, path: &str) -> Option<String> {
        self.0.contains_key(path).then(|| path.to_string())
    }

    fn read(&self, name: &str) -> Result<Vec<u8>, String> {
        self.0.get(name).map(|text| text.as_bytes().to_vec()).ok_or_else(|| "it is not there".into())
    }
}

/// Evaluates a program among some files, in the way the user chose.
fn run_with(text: &str, files: &[(&'static str, &'static str)], options: Options) -> Outcome {
    let text = text.to_string();
    let world = Files(files.iter().copied().collect());
    let run = move || {
        let mut sources = Sources::default();
        let main = sources.add(SourceFile::new("main.scad", text));
        let evaluation = evaluate(&world, &mut sources, main, &options);
        let mut outcome = Outcome::default();
        for diagnostic in evaluation.diagnostics {
            match (diagnostic.severity, diagnostic.message.strip_prefix("ECHO: ")) {
                (Severity::Note, Some(echo)) => outcome.echoes.push(echo.into()),
                (Severity::Note, None) => outcome.notes.push(diagnostic.message),
                (Severity::Warning, _) => outcome.warnings.push(diagnostic.message),
                (Severity::Error, _) => {
                    let place = diagnostic.span.map_or("", |span| sources.text(span));
                    let hints: String = diagnostic.hints.iter().map(|hint| format!(" ({hint})")).collect();
                    outcome.errors.push(format!("{place}: {}{hints}", diagnostic.message));
                }
            }
        }
        if let Some(scene) = evaluation.scene {
            outcome.solid = Some(print(&scene.root));
            outcome.parameters = scene.parameters;
        }
        outcome
    };
    let thread = std::thread::Builder::new().stack_size(STACK_BYTES).spawn(run);
    thread.expect("a thread").join().expect("no panic")
}

fn run(text: &str) -> Outcome {
    run_with(text, &[], Options::default())
}

/// What a program without errors echoes.
fn echo(text: &str) -> String {
    let outcome = run(text);
    assert!(outcome.errors.is_empty(), "{text}: {:?}", outcome.errors);
    outcome.echoes.join("; ")
}

/// The value of an expression, as `echo` writes it.
fn value(expression: &str) -> String {
    echo(&format!("echo({expression});"))
}

/// The errors of a program.
fn errors(text: &str) -> Vec<String> {
    run(text).errors
}
