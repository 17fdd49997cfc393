//! A scene, compiled for a device.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use chiaro_field::{Crowds, Graph};
use chiaro_shader::{GLOSS_TABLE, Template, bindings, single, splice_with_crowds};
use chiaro_solid::{Scalar, scalar::ParameterId};
use chiaro_syntax::Diagnostic;
use chiaro_vocabulary::Bounds;
use naga::Module;
use wgpu::{BindGroup, BindingResource, Buffer};

use crate::crowds::{CrowdTable, LargeUnions};
use crate::error::{Error, Result};
use crate::gpu::Gpu;
use crate::kernel::{Kernel, Slot, buffer};
use crate::measure;
use crate::view::drawn_bounds;

/// A scene compiled for a device: its pipelines and what they read. Making one takes long; moving its live numbers
/// does not.
#[derive(Clone, Debug)]
pub struct Model {
    pub(crate) graph: Arc<Graph>,
    pub(crate) prepass: Program,
    pub(crate) trace: Program,
    pub(crate) lipschitz: f64,
    unions: LargeUnions,
    live: Arc<Mutex<Live>>,
}

/// What clones of a model share.
#[derive(Debug)]
struct Live {
    /// The live numbers' present values.
    parameters: Vec<f64>,
    /// The scene's box while they have these.
    bounds: Bounds,
    /// What was compiled beside the prepass and the trace.
    programs: HashMap<Template, Program>,
}

/// The starting depths, the sums, the receivers, the lights.
const TRACE_SLOTS: [(u32, Slot); 4] = [(0, Slot::Read), (1, Slot::ReadWrite), (2, Slot::ReadWrite), (3, Slot::Read)];

/// A template with the scene spliced into it, on its way to a device.
#[derive(Clone, Debug)]
pub(crate) struct Source {
    pub(crate) module: Module,
    pub(crate) live: Vec<Scalar>,
    pub(crate) tables: Vec<[f32; 4]>,
    pub(crate) crowds: Option<Arc<CrowdTable>>,
}

/// A template's pipeline with the scene's numbers.
#[derive(Clone, Debug)]
pub(crate) struct Program {
    pub(crate) kernel: Kernel,
    live: Vec<Scalar>,
    live_buffer: Option<Buffer>,
    tables: Option<Buffer>,
    crowds: Option<Arc<CrowdTable>>,
    gloss: Option<Buffer>,
}

impl Model {
    /// Compiles a scene; its live numbers have these values, in the order of their ids. Large unions become loops over
    /// those of their operands that are near, but for what [`notes`](Self::notes) tells.
    pub fn new(gpu: &Gpu, graph: &Graph, parameters: &[f64]) -> Result<Self> {
        Self::with_unions(gpu, graph, LargeUnions::new(gpu, graph, parameters)?, parameters)
    }

    /// The same with code for each operand of each union, to compare with.
    pub fn unrolled(gpu: &Gpu, graph: &Graph, parameters: &[f64]) -> Result<Self> {
        Self::with_unions(gpu, graph, LargeUnions::default(), parameters)
    }

    fn with_unions(gpu: &Gpu, graph: &Graph, unions: LargeUnions, parameters: &[f64]) -> Result<Self> {
        let facts = graph.facts[graph.root.0 as usize];
        let prepass = Source::of(graph, &unions, Template::Prepass)?;
        let trace = Source::of(graph, &unions, Template::Trace)?;
        let model = Self {
            graph: Arc::new(graph.clone()),
            prepass: Program::new(gpu, prepass, "prepass", true, &[(0, Slot::ReadWrite)])?,
            trace: Program::new(gpu, trace, "trace", true, &TRACE_SLOTS)?,
            lipschitz: facts.lipschitz,
            unions,
            live: Arc::new(Mutex::new(Live { parameters: Vec::new(), bounds: facts.bounds, programs: HashMap::new() })),
        };
        model.set_parameters(gpu, parameters)?;
        Ok(model)
    }

    /// What there is to say of how the scene is drawn, at its places in this graph, which [is of](Self::is_of) the model: notes
    /// about large unions that are code for each of their operands, since too many of these lie in each other.
    pub fn notes(&self, graph: &Graph) -> Vec<Diagnostic> {
        self.unions.notes(graph)
    }

    /// Whether it draws this field: then a new one would be no other.
    pub fn is_of(&self, graph: &Graph) -> bool {
        self.graph.is_same_field(graph)
    }

    /// Whether it is a clone of another one, so that what was made for one of them serves both.
    pub fn is_clone_of(&self, other: &Model) -> bool {
        Arc::ptr_eq(&self.graph, &other.graph)
    }

    /// The box that the scene fills while the live numbers have their present values, cut where it has no end.
    pub fn extent(&self, gpu: &Gpu) -> Result<Bounds> {
        measure::extent(gpu, self)
    }

    /// The height of the scene's lowest point while the live numbers have their present values.
    pub(crate) fn lowest(&self, gpu: &Gpu) -> Result<Option<f64>> {
        // Under what goes down without end there is no place for a floor.
        let has_lower_end = self.live().bounds.min[2].is_finite();
        if has_lower_end { measure::lowest(gpu, self).map(Some) } else { Ok(None) }
    }

    /// Moves the live numbers to these values, in the order of their ids. Pictures of the model have to be told themselves.
    /// If they move too many parts of a large union into each other, that is an [`Error::Dense`]: then a new model is needed.
    pub fn set_parameters(&self, gpu: &Gpu, parameters: &[f64]) -> Result<()> {
        self.prepass.set_parameters(gpu, parameters)?;
        self.trace.set_parameters(gpu, parameters)?;
        let mut live = self.live();
        live.programs.values().try_for_each(|program| program.set_parameters(gpu, parameters))?;
        live.parameters = parameters.to_vec();
        live.bounds = self.graph.bounds_at(parameters)[self.graph.root.0 as usize];
        Ok(())
    }

    /// The box outside of which there is nothing to draw while the live numbers have their present values: that for all their
    /// values may be larger than the scene by any factor.
    pub(crate) fn bounds(&self) -> Bounds {
        drawn_bounds(&self.live().bounds)
    }

    /// The live numbers' present values.
    pub(crate) fn parameters(&self) -> Vec<f64> {
        self.live().parameters.clone()
    }

    /// The scene in a template that has a view, compiled when first asked for; `own` are the slots of the template's own
    /// group. It follows the live numbers.
    pub(crate) fn program(&self, gpu: &Gpu, template: Template, entry: &str, own: &[(u32, Slot)]) -> Result<Program> {
        let mut live = self.live();
        if let Some(program) = live.programs.get(&template) {
            return Ok(program.clone());
        }
        let source = Source::of(&self.graph, &self.unions, template)?;
        let program = Program::new(gpu, source, entry, true, own)?;
        program.set_parameters(gpu, &live.parameters)?;
        live.programs.insert(template, program.clone());
        Ok(program)
    }

    fn live(&self) -> MutexGuard<'_, Live> {
        self.live.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Source {
    /// A scene in a template, with these of its unions.
    pub(crate) fn of(graph: &Graph, unions: &LargeUnions, template: Template) -> Result<Self> {
        let none = Crowds::default();
        let crowds = unions.looped.clone();
        let looped = crowds.as_ref().map_or(&none, |table| &table.crowds);
        let shader = splice_with_crowds(graph, looped, template).map_err(|diagnostic| {
            let notes = unions.notes(graph).into_iter().filter_map(|note| Some((note.span?, note.message)));
            Error::Scene(Box::new(notes.fold(diagnostic, |all, (span, note)| all.with_related(span, note))))
        })?;
        let live = if shader.live_numbers > 0 { graph.slots.clone() } else { Vec::new() };
        Ok(Self { module: shader.module, live, tables: shader.tables.rows, crowds })
    }
}

impl Program {
    /// Compiles a source; `own` are the slots of the template's own group.
    pub(crate) fn new(gpu: &Gpu, source: Source, entry: &str, has_view: bool, own: &[(u32, Slot)]) -> Result<Self> {
        let mut shared = Vec::new();
        if has_view {
            shared.push((bindings::VIEW.binding, Slot::Uniform));
        }
        let mut live_buffer = None;
        if !source.live.is_empty() {
            shared.push((bindings::LIVE.binding, Slot::Uniform));
            let vectors = source.live.len().div_ceil(4) as u64;
            live_buffer = Some(buffer(gpu, "live numbers", Slot::Uniform, 16 * vectors)?);
        }
        let mut tables = None;
        if !source.tables.is_empty() {
            shared.push((bindings::TABLES.binding, Slot::Read));
            let rows = buffer(gpu, "tables", Slot::Read, 16 * source.tables.len() as u64)?;
            gpu.queue.write_buffer(&rows, 0, bytemuck::cast_slice(&source.tables));
            tables = Some(rows);
        }
        if source.crowds.is_some() {
            shared.push((bindings::CROWDS.binding, Slot::Read));
            shared.push((bindings::CROWD_GRIDS.binding, Slot::Uniform));
        }
        let mut gloss = None;
        if source.module.global_variables.iter().any(|(_, variable)| variable.binding == Some(bindings::GLOSS)) {
            shared.push((bindings::GLOSS.binding, Slot::Read));
            let table = buffer(gpu, "gloss", Slot::Read, GLOSS_TABLE.len() as u64)?;
            gpu.queue.write_buffer(&table, 0, GLOSS_TABLE);
            gloss = Some(table);
        }
        let kernel = Kernel::new(gpu, source.module, entry, &[&shared, own])?;
        Ok(Self { kernel, live: source.live, live_buffer, tables, crowds: source.crowds, gloss })
    }

    /// Sets the live numbers that the template reads.
    pub(crate) fn set_parameters(&self, gpu: &Gpu, parameters: &[f64]) -> Result<()> {
        if let Some(crowds) = &self.crowds {
            crowds.set_parameters(gpu, parameters)?;
        }
        let Some(buffer) = &self.live_buffer else {
            return Ok(());
        };
        check_parameters(&self.live, parameters)?;
        let mut values: Vec<f32> = self.live.iter().map(|scalar| single(scalar.value(parameters))).collect();
        values.resize(values.len().next_multiple_of(4), 0.0);
        gpu.queue.write_buffer(buffer, 0, bytemuck::cast_slice(&values));
        Ok(())
    }

    /// Binds the group that all templates share.
    pub(crate) fn bind_shared(&self, gpu: &Gpu, view: Option<&Buffer>) -> Result<BindGroup> {
        let bound = [
            (bindings::VIEW.binding, view),
            (bindings::LIVE.binding, self.live_buffer.as_ref()),
            (bindings::TABLES.binding, self.tables.as_ref()),
            (bindings::CROWDS.binding, self.crowds.as_ref().map(|crowds| &crowds.words)),
            (bindings::CROWD_GRIDS.binding, self.crowds.as_ref().map(|crowds| &crowds.grids)),
            (bindings::GLOSS.binding, self.gloss.as_ref()),
        ];
        let resources: Vec<(u32, BindingResource)> =
            bound.into_iter().filter_map(|(binding, buffer)| Some((binding, buffer?.as_entire_binding()))).collect();
        self.kernel.bind(gpu, 0, &resources)
    }
}

/// Whether there are values for all parameters in these numbers.
pub(crate) fn check_parameters(numbers: &[Scalar], parameters: &[f64]) -> Result<()> {
    let mut needed = 0;
    let mut need = |ParameterId(id): ParameterId| needed = needed.max(id as usize + 1);
    numbers.iter().for_each(|scalar| scalar.visit_parameters(&mut need));
    if needed > parameters.len() { Err(Error::Parameters { needed, given: parameters.len() }) } else { Ok(()) }
}
