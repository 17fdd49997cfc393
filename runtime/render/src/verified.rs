//! The passes of verified cones: the gate for all receivers, then stage by stage the cells for those in penumbrae whose
//! neighbours don't tell, then what the cells come to.

use std::time::Duration;

use chiaro_shader::{Shadows, Template, Verified};
use wgpu::{BindGroup, Buffer};

use crate::cells::MOST_CELLS;
use crate::error::Result;
use crate::gpu::Gpu;
use crate::kernel::{Dispatch, Size, Slot, buffer, run_all};
use crate::model::{Model, Program};
use crate::shadow::{Receivers, Task, linear_workgroups};
use crate::stopwatch::Stopwatch;

/// How far ahead a planar silhouette lets a step go, of what it would allow: while looking for contact, and behind it.
const LOOKING: f32 = 0.9;
const FOLLOWING: f32 = 0.4;

const STAGES: usize = Verified::STAGES;
/// The bytes between the sizes of one stage's dispatch and the next.
const GROUPS_BYTES: u64 = 16;

/// Verified cones, compiled for a scene and bound to a part's receivers.
#[derive(Debug)]
pub(crate) struct VerifiedPasses {
    gate: Pass,
    choose: Pass,
    cells: Pass,
    settle: Pass,
    /// One for each stage.
    tasks: Vec<Buffer>,
    lists: Lists,
}

/// A program with the groups of bindings for each task.
#[derive(Debug)]
struct Pass {
    program: Program,
    shared: BindGroup,
    own: Vec<BindGroup>,
}

/// What the passes tell each other; the shaders say what it is.
#[derive(Debug)]
struct Lists {
    touched: Buffer,
    touched_groups: Buffer,
    left: Buffer,
    left_groups: Buffer,
    sums: Buffer,
}

/// A buffer that a pass has at a binding.
type Bound<'a> = (u32, &'a Buffer, Slot);

impl VerifiedPasses {
    pub(crate) fn new(gpu: &Gpu, model: &Model, receivers: &Receivers, view: &Buffer) -> Result<Self> {
        let lists = Lists::new(gpu, receivers.visibilities.size() / 16)?;
        let mut tasks = Vec::new();
        for _ in 0..STAGES {
            tasks.push(Task::buffer(gpu)?);
        }
        let Receivers { receivers: points, visibilities, lights, .. } = receivers;
        let Lists { touched, touched_groups, left, left_groups, sums } = &lists;
        let (read, write) = (Slot::Read, Slot::ReadWrite);

        let build = |template, entry, tasks: &[Buffer], own: &[Bound]| {
            Pass::new(gpu, model.program(gpu, template, entry, &slots(own))?, view, tasks, own)
        };
        let gate = [
            (0, points, read),
            (1, lights, read),
            (2, visibilities, write),
            (4, touched, write),
            (5, touched_groups, Slot::Groups),
        ];
        let choose = [
            (0, points, read),
            (2, visibilities, write),
            (4, touched, read),
            (5, left, write),
            (6, left_groups, Slot::Groups),
            (7, sums, read),
        ];
        let cells = [(0, points, read), (1, lights, read), (2, visibilities, read), (4, left, read), (5, sums, write)];
        let settle = [(2, visibilities, write), (4, sums, read)];
        Ok(Self {
            gate: build(Template::Shadows(Shadows::Verified), "shadow", &tasks[..1], &gate)?,
            choose: build(Template::Verified(Verified::Choose), "choose", &tasks, &choose)?,
            cells: build(Template::Verified(Verified::Cells), "cells", &tasks, &cells)?,
            settle: build(Template::Verified(Verified::Settle), "settle", &tasks[..1], &settle)?,
            tasks,
            lists,
        })
    }

    /// Answers for all receivers of a part, and says how long it took.
    pub(crate) fn run(&self, gpu: &Gpu, stopwatch: &Stopwatch, task: Task) -> Result<Duration> {
        let cells = task.cells.clamp(1, MOST_CELLS);
        for (stage, buffer) in self.tasks.iter().enumerate() {
            let task = Task { cells, looking: LOOKING, following: FOLLOWING, stage: stage as u32, ..task };
            task.write(gpu, buffer);
        }
        let Lists { touched, touched_groups, left, left_groups, sums } = &self.lists;
        let everything = Size::Workgroups(linear_workgroups(task.receivers));
        let gate = self.gate.groups(0);
        let choose: Vec<_> = (0..STAGES).map(|stage| self.choose.groups(stage)).collect();
        let of_cells: Vec<_> = (0..STAGES).map(|stage| self.cells.groups(stage)).collect();
        let settle = self.settle.groups(0);

        let mut dispatches = vec![self.gate.dispatch(&gate, everything)];
        for (stage, (choose, cells)) in choose.iter().zip(&of_cells).enumerate() {
            let at = GROUPS_BYTES * stage as u64;
            dispatches.push(self.choose.dispatch(choose, Size::From(touched_groups, at)));
            dispatches.push(self.cells.dispatch(cells, Size::From(left_groups, at)));
        }
        dispatches.push(self.settle.dispatch(&settle, everything));
        let counts = 4 * STAGES as u64;
        let cleared = [(touched, counts), (left, counts)];
        let whole = [touched_groups, left_groups, sums].map(|buffer| (buffer, buffer.size()));
        run_all(gpu, stopwatch, &[&cleared[..], &whole].concat(), &dispatches)
    }
}

impl Pass {
    /// Binds a pass's buffers, and at binding 3 one task after the other.
    fn new(gpu: &Gpu, program: Program, view: &Buffer, tasks: &[Buffer], own: &[Bound]) -> Result<Self> {
        let shared = program.bind_shared(gpu, Some(view))?;
        let mut groups = Vec::new();
        for task in tasks {
            let resources: Vec<_> =
                own.iter().map(|(binding, buffer, _)| (*binding, buffer.as_entire_binding())).collect();
            groups.push(program.kernel.bind(gpu, 1, &[&resources[..], &[(3, task.as_entire_binding())]].concat())?);
        }
        Ok(Self { program, shared, own: groups })
    }

    fn groups(&self, task: usize) -> [&BindGroup; 2] {
        [&self.shared, &self.own[task]]
    }

    fn dispatch<'a>(&'a self, groups: &'a [&'a BindGroup; 2], size: Size<'a>) -> Dispatch<'a> {
        Dispatch { kernel: &self.program.kernel, groups, size }
    }
}

/// The slots of a pass's buffers and of its task.
fn slots(own: &[Bound]) -> Vec<(u32, Slot)> {
    own.iter().map(|(binding, _, slot)| (*binding, *slot)).chain([(3, Slot::Read)]).collect()
}

impl Lists {
    fn new(gpu: &Gpu, receivers: u64) -> Result<Self> {
        let stages = STAGES as u64;
        let list = |what, slot, numbers: u64| buffer(gpu, what, slot, 4 * numbers);
        Ok(Self {
            touched: list("receivers in penumbrae", Slot::ReadWrite, stages * (1 + receivers))?,
            touched_groups: list("workgroups for receivers in penumbrae", Slot::Groups, 4 * stages)?,
            left: list("receivers to look at", Slot::ReadWrite, stages + receivers)?,
            left_groups: list("workgroups for receivers to look at", Slot::Groups, 4 * stages)?,
            sums: list("sums over cells", Slot::ReadWrite, 3 * receivers)?,
        })
    }
}
