//! Splicing: a scene's functions in the place of a template's stubs.

use chiaro_field::Graph;
use chiaro_syntax::Diagnostic;
use naga::Module;

use crate::emit::{Emitted, emit};
use crate::tables::Tables;
use crate::template::Template;

/// A module that is ready for a GPU or a writer.
#[derive(Clone, Debug)]
pub struct Shader {
    /// The module; valid without any capability, unless its template needs some.
    pub module: Module,
    /// What to upload to [`TABLES`](crate::bindings::TABLES); the binding exists if there are any rows.
    pub tables: Tables,
    /// How many live numbers to upload to [`LIVE`](crate::bindings::LIVE), in the order of the graph's slots and padded
    /// with zeros to a multiple of four; the binding exists if there are any.
    pub live_numbers: usize,
    /// The names of the template's entry points.
    pub entry_points: Vec<String>,
}

/// Splices a scene into a template. An error says that the scene is too large for a shader, or holds a NaN.
pub fn splice(graph: &Graph, template: Template) -> Result<Shader, Diagnostic> {
    let Emitted { module, tables, .. } = emit(graph, template.parsed(), &|_| None)?;
    let is_live = module.global_variables.iter().any(|(_, variable)| variable.binding == Some(crate::bindings::LIVE));
    let live_numbers = if is_live { graph.slots.len() } else { 0 };
    let entry_points = module.entry_points.iter().map(|entry_point| entry_point.name.clone()).collect();
    Ok(Shader { module, tables, live_numbers, entry_points })
}
