//! Splicing: a scene's functions in the place of a template's stubs.

use chiaro_field::{Crowds, Graph};
use chiaro_syntax::Diagnostic;
use naga::Module;

use crate::emit::{Emitted, emit, emit_with_crowds};
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

/// Splices a scene into a template, as straight-line code. An error says that the scene is too large for a shader, or holds
/// a NaN.
pub fn splice(graph: &Graph, template: Template) -> Result<Shader, Diagnostic> {
    Ok(Shader::new(graph, emit(graph, template.parsed())?))
}

/// Splices a scene into a template with loops over the members of its crowds: the module is the same for scenes whose
/// members differ by numbers, and stays small however many there are. If there are any crowds it reads
/// [`CrowdData`](crate::CrowdData).
pub fn splice_with_crowds(graph: &Graph, crowds: &Crowds, template: Template) -> Result<Shader, Diagnostic> {
    if crowds.is_empty() {
        return splice(graph, template);
    }
    Ok(Shader::new(graph, emit_with_crowds(graph, crowds, template.parsed_with_crowds())?))
}

impl Shader {
    fn new(graph: &Graph, Emitted { module, tables, .. }: Emitted) -> Self {
        let is_live =
            module.global_variables.iter().any(|(_, variable)| variable.binding == Some(crate::bindings::LIVE));
        let live_numbers = if is_live { graph.slots.len() } else { 0 };
        let entry_points = module.entry_points.iter().map(|entry_point| entry_point.name.clone()).collect();
        Self { module, tables, live_numbers, entry_points }
    }
}
