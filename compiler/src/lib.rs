//! The compiler from CSG scenes to shader code: the whole pipeline behind one call.
//!
//! ```text
//! text ──parse──► syntax tree ──evaluate──► solid tree ──lower──► field graph ──splice──► naga module
//! ```
//!
//! * [`chiaro_syntax::parse`] reads a text; it never fails, but answers diagnostics beside its tree.
//! * [`chiaro_eval::evaluate`] runs the program: what is left are shapes, operators, materials and live numbers.
//! * [`chiaro_field::lower`] makes one graph of distances of it, with sound facts about every node.
//! * [`chiaro_shader::splice`] emits the graph into a template's naga module, and [`chiaro_shader::wgsl`] as text.
//!
//! [`compile`] goes from a file's name to the field graph. Every stage is a function from one plain datum to the next;
//! no stage looks back, and none touches a file, a clock or a GPU: files come through the caller's [`World`].

#[cfg(feature = "export")]
mod naming;
mod provenance;
mod scene;

use std::panic::resume_unwind;

use chiaro_eval::{Evaluation, STACK_BYTES, evaluate};
use chiaro_syntax::{Diagnostic, Severity, Sources};

pub use chiaro_eval::{Facets, LiveLiteral, Options, World};
#[cfg(feature = "export")]
pub use chiaro_export as export;
pub use chiaro_field as field;
pub use chiaro_shader as shader;
pub use chiaro_solid as solid;
pub use chiaro_syntax as syntax;
pub use chiaro_vocabulary as vocabulary;
#[cfg(feature = "export")]
pub use naming::ModuleNames;
pub use provenance::{Bent, Matrix, Origin, Provenance, SolidId, Tree};
pub use scene::Scene;

/// What compiling a file came to: a scene unless there is an error, and in any case what there is to say.
#[derive(Debug)]
pub struct Compilation {
    /// Every file read, the scene's own first. Spans refer to these.
    pub sources: Sources,
    /// The output of `echo` in the order of execution, then errors, warnings and notes in the order of the text, then what
    /// lowering has to say.
    pub diagnostics: Vec<Diagnostic>,
    /// The scene, if there is no error.
    pub scene: Option<Scene>,
}

impl Compilation {
    /// Whether anything is an error; then there is no scene.
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(|diagnostic| diagnostic.severity == Severity::Error)
    }
}

/// The most distinct live numbers of a scene. Shaders that read more of them run far slower than if all were constants.
const MOST_LIVE_NUMBERS: usize = 1024;

/// Compiles the file `name` of `world`, up to its field graph.
///
/// A scene that can't be drawn with its parameters live, because a slope or a bound would have no limit or because too
/// many numbers depend on them, is compiled again with constants in their place, and a note says so.
pub fn compile(world: &dyn World, name: &str, options: &Options) -> Compilation {
    let mut compilation = attempt(world, name, options);
    if let Some(reason) = reason_to_freeze(&compilation) {
        compilation = attempt(world, name, &Options { frozen: true, ..options.clone() });
        let note = format!("changing a parameter recompiles this scene: {reason}");
        compilation.diagnostics.push(Diagnostic::note(None, note));
    }
    if compilation.has_errors() {
        compilation.scene = None;
    }
    compilation
}

/// Why the scene should not have live numbers, if it has any.
fn reason_to_freeze(compilation: &Compilation) -> Option<String> {
    let scene = compilation.scene.as_ref()?;
    if scene.graph.slots.is_empty() {
        return None;
    }
    let errors = compilation.diagnostics.iter().filter(|diagnostic| diagnostic.severity == Severity::Error);
    match errors.map(|error| &error.message).next() {
        Some(message) => Some(message.clone()),
        None if scene.graph.slots.len() > MOST_LIVE_NUMBERS => Some("too many numbers depend on them".to_owned()),
        None => None,
    }
}

/// Compiles with just these options. There is a scene even if lowering it had errors.
fn attempt(world: &dyn World, name: &str, options: &Options) -> Compilation {
    let mut sources = Sources::default();
    let bytes = match world.read(name) {
        Ok(bytes) => bytes,
        Err(reason) => {
            let diagnostic = Diagnostic::error(None, format!("cannot read {name}: {reason}"));
            return Compilation { sources, diagnostics: vec![diagnostic], scene: None };
        }
    };
    let (main, odd_bytes) = sources.add_bytes(name, &bytes);
    let compiled = with_deep_stack(|| {
        let Evaluation { scene, mut diagnostics } = evaluate(world, &mut sources, main, options);
        diagnostics.splice(0..0, odd_bytes);
        let scene = scene.map(|evaluated| Scene::lower(evaluated, &mut diagnostics));
        Compilation { sources, diagnostics, scene }
    });
    compiled.unwrap_or_else(|error| {
        let message = format!("the system refuses a thread with a stack of {STACK_BYTES} bytes: {error}");
        let diagnostics = vec![Diagnostic::error(None, message)];
        Compilation { sources: Sources::default(), diagnostics, scene: None }
    })
}

/// Runs `work` on a thread of its own whose stack fits the deepest program that the evaluator's limits allow. An error
/// if the system has no room for that.
fn with_deep_stack<T: Send>(work: impl FnOnce() -> T + Send) -> std::io::Result<T> {
    std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().stack_size(STACK_BYTES).spawn_scoped(scope, work)?;
        Ok(thread.join().unwrap_or_else(|panic| resume_unwind(panic)))
    })
}
