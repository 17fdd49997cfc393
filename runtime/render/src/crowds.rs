//! The crowds of a scene on a device: the numbers of their members, and where each of these matters.

use std::sync::{Mutex, PoisonError};

use chiaro_field::{Crowds, Graph};
use chiaro_shader::CrowdData;
use wgpu::Buffer;

use crate::error::{Error, Result};
use crate::gpu::Gpu;
use crate::kernel::{Slot, buffer};
use crate::model::check_parameters;

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

impl CrowdTable {
    /// The table of a scene while the live numbers have these values, if it has crowds.
    pub(crate) fn new(gpu: &Gpu, graph: &Graph, parameters: &[f64]) -> Result<Option<Self>> {
        let crowds = Crowds::of(graph);
        if crowds.is_empty() {
            return Ok(None);
        }
        check_parameters(&graph.slots, parameters)?;
        let data = CrowdData::of(graph, &crowds, parameters);
        let is_moving = crowds.live_numbers(graph).next().is_some();
        let present = data.words.len();
        let room = if is_moving { CrowdData::most_words(&crowds).max(present) } else { present };
        let moving = is_moving.then(|| Moving { graph: graph.clone(), parameters: Mutex::new(parameters.to_vec()) });
        let grids = buffer(gpu, "grids", Slot::Uniform, size_of_val(&data.grids) as u64)?;
        let words = buffer(gpu, "many shapes", Slot::Read, 4 * room as u64)?;
        let table = Self { crowds, grids, words, moving };
        table.write(gpu, &data)?;
        Ok(Some(table))
    }

    /// Moves the live numbers to these values.
    pub(crate) fn set_parameters(&self, gpu: &Gpu, parameters: &[f64]) -> Result<()> {
        let Some(Moving { graph, parameters: present }) = &self.moving else { return Ok(()) };
        let mut present = present.lock().unwrap_or_else(PoisonError::into_inner);
        check_parameters(&graph.slots, parameters)?;
        if *present == parameters {
            return Ok(());
        }
        self.write(gpu, &CrowdData::of(graph, &self.crowds, parameters))?;
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
