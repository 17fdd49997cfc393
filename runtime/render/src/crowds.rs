//! The crowds of a scene on a device: the numbers of their members, and where each of these matters.

use std::sync::{Arc, Mutex, PoisonError};

use chiaro_field::crowd::Crowd;
use chiaro_field::{Crowds, Graph, NodeId};
use chiaro_shader::CrowdData;
use chiaro_syntax::Diagnostic;
use wgpu::Buffer;

use crate::error::{Error, Result};
use crate::gpu::Gpu;
use crate::kernel::{Slot, buffer};
use crate::model::check_parameters;

/// The large unions of a scene.
#[derive(Clone, Debug, Default)]
pub(crate) struct LargeUnions {
    /// Those that are loops over the members that cells list, if there are any.
    pub(crate) looped: Option<Arc<CrowdTable>>,
    /// Those that are code for each operand, since too many of these lie in each other for cells to tell them apart.
    unrolled: Vec<Unrolled>,
}

#[derive(Clone, Copy, Debug)]
struct Unrolled {
    union: NodeId,
    members: usize,
}

/// A scene's crowds with what kernels read of them, which the programs of one model share.
#[derive(Debug)]
pub(crate) struct CrowdTable {
    pub(crate) crowds: Crowds,
    pub(crate) grids: Buffer,
    pub(crate) words: Buffer,
    /// What it is made of again when a live number moves, if any tells members apart.
    moving: Option<Moving>,
}

#[derive(Debug)]
struct Moving {
    graph: Graph,
    /// The values of the live numbers that the buffer is for.
    parameters: Mutex<Vec<f64>>,
}

impl LargeUnions {
    /// Those of a scene while the live numbers have these values.
    pub(crate) fn new(gpu: &Gpu, graph: &Graph, parameters: &[f64]) -> Result<Self> {
        let mut crowds = Crowds::of(graph);
        if crowds.is_empty() {
            return Ok(Self::default());
        }
        check_parameters(&graph.slots, parameters)?;
        let (data, dense) = CrowdData::of(graph, &mut crowds, parameters);
        let unrolled = |crowd: Crowd| Unrolled { union: crowd.union, members: crowd.members.len() };
        let unrolled = dense.into_iter().map(unrolled).collect();
        let looped = match crowds.is_empty() {
            true => None,
            false => Some(Arc::new(CrowdTable::new(gpu, graph, crowds, &data, parameters)?)),
        };
        Ok(Self { looped, unrolled })
    }

    /// What there is to say of those that are code for each operand, at their places in a graph of the same field.
    pub(crate) fn notes(&self, graph: &Graph) -> Vec<Diagnostic> {
        let note = |unrolled: &Unrolled| {
            let span = graph.spans.get(unrolled.union.0 as usize).copied();
            let message = format!(
                "so many of this union's {} parts lie in each other that each becomes code of its own",
                unrolled.members
            );
            Diagnostic::note(span, message)
                .with_hint("that takes graphics drivers long; leave out parts that others hide")
        };
        self.unrolled.iter().map(note).collect()
    }
}

impl CrowdTable {
    /// The table of these crowds, whose data are those for these values of the live numbers.
    fn new(gpu: &Gpu, graph: &Graph, crowds: Crowds, data: &CrowdData, parameters: &[f64]) -> Result<Self> {
        let is_moving = crowds.live_numbers(graph).next().is_some();
        let present = data.words.len();
        let room = if is_moving { CrowdData::most_words(&crowds).max(present) } else { present };
        let moving = is_moving.then(|| Moving { graph: graph.clone(), parameters: Mutex::new(parameters.to_vec()) });
        let grids = buffer(gpu, "grids", Slot::Uniform, size_of_val(&data.grids) as u64)?;
        let words = buffer(gpu, "many shapes", Slot::Read, 4 * room as u64)?;
        let table = Self { crowds, grids, words, moving };
        table.write(gpu, data)?;
        Ok(table)
    }

    /// Moves the live numbers to these values; an error if too many members lie in each other then.
    pub(crate) fn set_parameters(&self, gpu: &Gpu, parameters: &[f64]) -> Result<()> {
        let Some(Moving { graph, parameters: present }) = &self.moving else { return Ok(()) };
        let mut present = present.lock().unwrap_or_else(PoisonError::into_inner);
        check_parameters(&graph.slots, parameters)?;
        if *present == parameters {
            return Ok(());
        }
        let (data, dense) = CrowdData::of(graph, &mut self.crowds.clone(), parameters);
        if let Some(crowd) = dense.first() {
            return Err(Error::Dense { members: crowd.members.len() });
        }
        self.write(gpu, &data)?;
        *present = parameters.to_vec();
        Ok(())
    }

    fn write(&self, gpu: &Gpu, data: &CrowdData) -> Result<()> {
        let (needed, limit) = (4 * data.words.len() as u64, self.words.size());
        if needed > limit {
            return Err(Error::SceneSize { what: "many shapes", needed, limit });
        }
        gpu.queue.write_buffer(&self.grids, 0, bytemuck::cast_slice(&data.grids));
        gpu.queue.write_buffer(&self.words, 0, bytemuck::cast_slice(&data.words));
        Ok(())
    }
}
