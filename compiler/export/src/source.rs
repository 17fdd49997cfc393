//! A scene as one WGSL text, which all other languages are translations of.

use std::fmt::Display;

use chiaro_field::Graph;
use chiaro_shader::{Library, Names, library};
use chiaro_solid::LiveParameter;
use chiaro_syntax::Diagnostic;
use rustc_hash::FxHashSet;

use crate::parameters::{Parameter, expression, number, parameters};
use crate::prose::Prose;
use crate::words::{is_reserved, words};

/// The functions that live numbers may be computed with.
const LIVE: &str = include_str!("../wgsl/live.wgsl");

/// More rows of tables than this don't fit into what all languages allow of constants.
const MOST_ROWS: usize = 4096;

/// A scene's functions as WGSL without resources: it reads the members of a variable `parameters`, and nothing else.
#[derive(Clone, Debug)]
pub struct Source {
    /// The declarations: what the scene's functions call, tables, then these functions, from `scene_distance` to
    /// `scene_surface`.
    pub text: String,
    /// The scene's live parameters that the text reads.
    pub parameters: Vec<Parameter>,
}

impl Source {
    /// That of a field with these live numbers; values are called as `names` says.
    ///
    /// An error if the scene has outlines with more edges than constants may hold.
    pub fn new(graph: &Graph, live: &[LiveParameter], names: Names, caller: &str) -> Result<Self, Diagnostic> {
        Self::of(library(graph, names, caller)?, graph, live, caller)
    }

    /// That of a field's library.
    pub(crate) fn of(
        library: Library,
        graph: &Graph,
        live: &[LiveParameter],
        caller: &str,
    ) -> Result<Self, Diagnostic> {
        let Library { vocabulary, functions, tables, .. } = library;
        if tables.rows.len() > MOST_ROWS {
            let root = graph.spans.get(graph.root.0 as usize).copied();
            let count = tables.rows.len();
            let message = format!(
                "the outlines of this scene are too detailed for one shader: {count} rows of at most {MOST_ROWS}"
            );
            return Err(Diagnostic::error(root, message)
                .with_hint("export a mesh instead (--to stl), or use fewer points in polygons and polyhedra"));
        }
        let used: FxHashSet<&str> = [&*vocabulary, &functions, caller].into_iter().flat_map(words).collect();
        let parameters = parameters(live, &|word| used.contains(word) || is_reserved(word));
        let functions = with_parameters(&functions, graph, &parameters);
        let helpers = called(LIVE, &functions);
        let tables = table(&tables.rows);
        let text = [&vocabulary, &helpers, &tables, &functions].map(String::as_str).concat();
        let read = parameters.into_iter().filter(|own| words(&text).any(|word| word == own.name)).collect();
        Ok(Self { text, parameters: read })
    }

    /// The text with the struct and the uniform variable that its parameters are read from, if it has any. The group may be a word
    /// that the target puts a number for.
    pub fn with_uniforms(&self, group: impl Display, binding: u32) -> String {
        if self.parameters.is_empty() {
            return self.text.clone();
        }
        let mut members = String::new();
        for parameter in &self.parameters {
            members += &format!("    // {}\n    {}: f32,\n", described(parameter), parameter.name);
        }
        let declared = format!("struct Parameters {{\n{members}}}\n\n");
        let bound = format!("@group({group}) @binding({binding}) var<uniform> parameters: Parameters;\n\n");
        declared + &bound + &self.text
    }
}

/// What a parameter is, for people.
pub(crate) fn described(parameter: &Parameter) -> Prose {
    let Parameter { label, default, min, max, description, .. } = parameter;
    let own = format!("{label}: from {min} to {max}, {default} by default");
    Prose::new(&description.as_ref().map_or(own.clone(), |text| format!("{text} ({own})")))
}

/// The functions with live numbers computed where they are read.
fn with_parameters(functions: &str, graph: &Graph, parameters: &[Parameter]) -> String {
    let mut result = String::with_capacity(functions.len());
    let mut rest = functions;
    while let Some(at) = rest.find("live[") {
        let (before, behind) = (&rest[..at], &rest[at + "live[".len()..]);
        let read = behind.split_once("].").and_then(|(row, behind)| {
            let component = behind.chars().next().and_then(|c| "xyzw".find(c))?;
            let slot = 4 * row.trim_end_matches('u').parse::<usize>().ok()? + component;
            Some((graph.slots.get(slot)?, &behind[1..]))
        });
        result += before;
        match read {
            Some((scalar, behind)) => {
                result += &expression(scalar, parameters);
                rest = behind;
            }
            None => {
                result += "live[";
                rest = behind;
            }
        }
    }
    result + rest
}

/// Those of the functions that a text calls, with their comments.
fn called(functions: &str, text: &str) -> String {
    let blocks = functions.split_inclusive("\n}\n").map(|block| block.trim_start_matches('\n'));
    let is_called = |block: &&str| {
        let name =
            block.split_once("\nfn ").or_else(|| block.split_once("fn ")).and_then(|(_, rest)| words(rest).next());
        name.is_some_and(|name| words(text).any(|word| word == name))
    };
    blocks.filter(is_called).map(|block| format!("{}\n", without_heading(block))).collect()
}

/// A function without the comment of the file above it.
fn without_heading(block: &str) -> &str {
    block.rsplit_once("\n\n").map_or(block, |(_, own)| own)
}

/// The rows of tables as a constant.
fn table(rows: &[[f32; 4]]) -> String {
    if rows.is_empty() {
        return String::new();
    }
    let row = |row: &[f32; 4]| format!("    vec4({}),\n", row.map(|x| number(f64::from(x))).join(", "));
    let rows_text: String = rows.iter().map(row).collect();
    let count = rows.len();
    format!(
        "// The edges of large outlines and the triangles of large polytopes.\nvar<private> tables: array<vec4<f32>, {count}> = array<vec4<f32>, {count}>(\n{rows_text});\n\n"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_is_called_comes_along() {
        assert!(called(LIVE, "let a = live_power(2.0, x);").starts_with("// x to the power y"));
        assert!(!called(LIVE, "let a = live_power(2.0, x);").contains("least_stretch"));
        assert_eq!(called(LIVE, "let a = 1.0;"), "");
    }
}
