//! Compute pipelines and what is bound to them.

use std::borrow::Cow;
use std::mem::take;
use std::time::{Duration, Instant};

use naga::{AddressSpace, Block, Expression, Function, GlobalVariable, Handle, Module, Span, Statement, StorageAccess};
use wgpu::{
    BindGroup, BindGroupDescriptor, BindGroupEntry, BindGroupLayout, BindGroupLayoutDescriptor, BindGroupLayoutEntry,
    BindingResource, BindingType, Buffer, BufferBindingType, BufferDescriptor, BufferUsages, ComputePassDescriptor,
    ComputePipeline, ComputePipelineDescriptor, PipelineLayoutDescriptor, ShaderModuleDescriptor, ShaderSource,
    ShaderStages, StorageTextureAccess, TextureFormat, TextureViewDimension,
};

use crate::error::{Error, Result};
use crate::gpu::Gpu;
use crate::kernels::Fingerprint;
use crate::stopwatch::Stopwatch;

/// What a binding is.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Slot {
    Uniform,
    Read,
    ReadWrite,
    /// The same, and dispatches read their sizes from it.
    Groups,
    /// A texture of [`PIXEL_FORMAT`] that is written.
    Pixels,
}

/// The format of finished pictures. The bytes are sRGB; a texture that says so could not be written by a kernel.
pub(crate) const PIXEL_FORMAT: TextureFormat = TextureFormat::Rgba8Unorm;

/// A compute pipeline with explicit bindings.
#[derive(Clone, Debug)]
pub(crate) struct Kernel {
    pipeline: ComputePipeline,
    layouts: Vec<BindGroupLayout>,
}

impl Kernel {
    /// Compiles an entry point of a module, unless the device has lately done so; the slots of each of its groups come
    /// with their binding's number.
    pub(crate) fn new(gpu: &Gpu, module: Module, entry: &str, groups: &[&[(u32, Slot)]]) -> Result<Self> {
        let fingerprint = Fingerprint::of(&(&module, entry, groups));
        if let Some(known) = gpu.kernels().known(fingerprint) {
            return Ok(known);
        }
        let kernel = Self::compiled(gpu, module, entry, groups)?;
        gpu.kernels().keep(fingerprint, &kernel);
        Ok(kernel)
    }

    fn compiled(gpu: &Gpu, module: Module, entry: &str, groups: &[&[(u32, Slot)]]) -> Result<Self> {
        let device = &gpu.device;
        let module = if gpu.description().software { without_uniforms(module) } else { module };
        let kernel = gpu.checked(|| {
            let layouts: Vec<BindGroupLayout> = groups.iter().map(|slots| layout(gpu, entry, slots)).collect();
            let references: Vec<Option<&BindGroupLayout>> = layouts.iter().map(Some).collect();
            let pipeline_layout = device.create_pipeline_layout(&PipelineLayoutDescriptor {
                label: Some(entry),
                bind_group_layouts: &references,
                immediate_size: 0,
            });
            let shader = device.create_shader_module(ShaderModuleDescriptor {
                label: Some(entry),
                source: ShaderSource::Naga(Cow::Owned(module)),
            });
            let pipeline = device.create_compute_pipeline(&ComputePipelineDescriptor {
                label: Some(entry),
                layout: Some(&pipeline_layout),
                module: &shader,
                entry_point: Some(entry),
                compilation_options: Default::default(),
                cache: None,
            });
            Kernel { pipeline, layouts }
        })?;
        gpu.count_pipeline();
        Ok(kernel)
    }

    /// Binds resources to a group's slots.
    pub(crate) fn bind(&self, gpu: &Gpu, group: usize, resources: &[(u32, BindingResource)]) -> Result<BindGroup> {
        let entries: Vec<BindGroupEntry> = resources
            .iter()
            .map(|(binding, resource)| BindGroupEntry { binding: *binding, resource: resource.clone() })
            .collect();
        gpu.checked(|| {
            gpu.device.create_bind_group(&BindGroupDescriptor {
                label: None,
                layout: &self.layouts[group],
                entries: &entries,
            })
        })
    }

    /// Runs it with this many workgroups, and waits for it; says how long it took.
    pub(crate) fn run(
        &self,
        gpu: &Gpu,
        stopwatch: &Stopwatch,
        groups: &[&BindGroup],
        workgroups: [u32; 2],
    ) -> Result<Duration> {
        run_all(gpu, stopwatch, &[], &[Dispatch { kernel: self, groups, size: Size::Workgroups(workgroups) }])
    }
}

/// A kernel that is to be run.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Dispatch<'a> {
    pub(crate) kernel: &'a Kernel,
    pub(crate) groups: &'a [&'a BindGroup],
    pub(crate) size: Size<'a>,
}

/// How large a dispatch is.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Size<'a> {
    Workgroups([u32; 2]),
    /// As three numbers in a buffer of [`Slot::Groups`] say, from this byte on, once the dispatches before are done.
    From(&'a Buffer, u64),
}

/// Fills the first bytes of buffers with zeros, runs kernels one after the other, and waits for them; says how long the kernels took.
pub(crate) fn run_all(
    gpu: &Gpu,
    stopwatch: &Stopwatch,
    cleared: &[(&Buffer, u64)],
    dispatches: &[Dispatch],
) -> Result<Duration> {
    let started = Instant::now();
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    for (buffer, bytes) in cleared {
        encoder.clear_buffer(buffer, 0, Some(*bytes));
    }
    let mut pass =
        encoder.begin_compute_pass(&ComputePassDescriptor { label: None, timestamp_writes: stopwatch.writes() });
    for dispatch in dispatches {
        pass.set_pipeline(&dispatch.kernel.pipeline);
        for (index, group) in dispatch.groups.iter().enumerate() {
            pass.set_bind_group(index as u32, *group, &[]);
        }
        match dispatch.size {
            Size::Workgroups([x, y]) => pass.dispatch_workgroups(x, y, 1),
            Size::From(buffer, offset) => pass.dispatch_workgroups_indirect(buffer, offset),
        }
    }
    drop(pass);
    stopwatch.collect(&mut encoder);
    gpu.finish(encoder)?;
    stopwatch.read(gpu, started)
}

/// The workgroups for one invocation a pixel, of the tracing templates' 8 × 8 invocations each.
pub(crate) fn workgroups(pixels: [u32; 2]) -> [u32; 2] {
    pixels.map(|count| count.div_ceil(8))
}

/// The same module, but what it had as uniforms it copies from storage when it starts.
///
/// Practice: lavapipe compiles a kernel anew, and keeps what it compiled, for every dispatch if a uniform alone decides a
/// branch. Reading storage within loops would be slow, for it is read for one invocation after the other there.
fn without_uniforms(mut module: Module) -> Module {
    let uniforms: Vec<_> = module
        .global_variables
        .iter()
        .filter(|(_, variable)| variable.space == AddressSpace::Uniform)
        .map(|(handle, variable)| (handle, variable.clone()))
        .collect();
    for (copy, uniform) in uniforms {
        let space = AddressSpace::Storage { access: StorageAccess::LOAD };
        let stored = module.global_variables.append(GlobalVariable { space, ..uniform }, Span::UNDEFINED);
        let private = &mut module.global_variables[copy];
        (private.space, private.binding) = (AddressSpace::Private, None);
        for entry in &mut module.entry_points {
            copy_first(&mut entry.function, stored, copy);
        }
    }
    module
}

/// Makes a function begin by copying a variable to another.
fn copy_first(function: &mut Function, from: Handle<GlobalVariable>, to: Handle<GlobalVariable>) {
    let expressions = &mut function.expressions;
    let source = expressions.append(Expression::GlobalVariable(from), Span::UNDEFINED);
    let pointer = expressions.append(Expression::GlobalVariable(to), Span::UNDEFINED);
    let before = expressions.len();
    let value = expressions.append(Expression::Load { pointer: source }, Span::UNDEFINED);
    let mut body = Block::new();
    body.push(Statement::Emit(expressions.range_from(before)), Span::UNDEFINED);
    body.push(Statement::Store { pointer, value }, Span::UNDEFINED);
    body.extend_block(take(&mut function.body));
    function.body = body;
}

fn layout(gpu: &Gpu, label: &str, slots: &[(u32, Slot)]) -> BindGroupLayout {
    let entries: Vec<BindGroupLayoutEntry> = slots.iter().map(|&(binding, slot)| entry(gpu, binding, slot)).collect();
    gpu.device.create_bind_group_layout(&BindGroupLayoutDescriptor { label: Some(label), entries: &entries })
}

fn entry(gpu: &Gpu, binding: u32, slot: Slot) -> BindGroupLayoutEntry {
    let buffer = |ty| BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None };
    let ty = match slot {
        Slot::Uniform if !gpu.description().software => buffer(BufferBindingType::Uniform),
        Slot::Uniform | Slot::Read => buffer(BufferBindingType::Storage { read_only: true }),
        Slot::ReadWrite | Slot::Groups => buffer(BufferBindingType::Storage { read_only: false }),
        Slot::Pixels => BindingType::StorageTexture {
            access: StorageTextureAccess::WriteOnly,
            format: PIXEL_FORMAT,
            view_dimension: TextureViewDimension::D2,
        },
    };
    BindGroupLayoutEntry { binding, visibility: ShaderStages::COMPUTE, ty, count: None }
}

/// A buffer that a storage or uniform slot takes and that can be copied from and to.
pub(crate) fn buffer(gpu: &Gpu, what: &'static str, slot: Slot, bytes: u64) -> Result<Buffer> {
    let limits = gpu.device.limits();
    let (usage, binding_limit) = match slot {
        Slot::Uniform => (BufferUsages::UNIFORM | BufferUsages::STORAGE, limits.max_uniform_buffer_binding_size),
        Slot::Groups => (BufferUsages::STORAGE | BufferUsages::INDIRECT, limits.max_storage_buffer_binding_size),
        _ => (BufferUsages::STORAGE, limits.max_storage_buffer_binding_size),
    };
    let limit = binding_limit.min(limits.max_buffer_size);
    if bytes > limit {
        return Err(Error::SceneSize { what, needed: bytes, limit });
    }
    gpu.checked(|| {
        gpu.device.create_buffer(&BufferDescriptor {
            label: Some(what),
            size: bytes,
            usage: usage | BufferUsages::COPY_SRC | BufferUsages::COPY_DST,
            mapped_at_creation: false,
        })
    })
}

#[cfg(test)]
mod tests {
    use naga::valid::{Capabilities, ValidationFlags, Validator};

    use super::*;

    #[test]
    fn uniforms_become_copies_of_storage_at_the_same_bindings() {
        let module = naga::front::wgsl::parse_str(
            "@group(0) @binding(1) var<uniform> live: array<vec4<f32>, 2>;
            @group(1) @binding(0) var<storage, read_write> answer: array<f32>;
            @compute @workgroup_size(1) fn ask() { if live[1].x > 0.5 { answer[0] = live[0].y; } }",
        );
        let module = without_uniforms(module.unwrap());
        Validator::new(ValidationFlags::all(), Capabilities::empty()).validate(&module).unwrap();
        let variables: Vec<_> = module.global_variables.iter().map(|(_, variable)| variable).collect();
        assert!(variables.iter().all(|variable| variable.space != AddressSpace::Uniform), "{variables:?}");
        let binding = naga::ResourceBinding { group: 0, binding: 1 };
        let stored: Vec<_> = variables.iter().filter(|variable| variable.binding == Some(binding)).collect();
        assert_eq!(stored.len(), 1, "{variables:?}");
        assert_eq!(stored[0].space, AddressSpace::Storage { access: StorageAccess::LOAD });
        // Without the copy, kernels would read zeros.
        let first = module.entry_points[0].function.body.get(1);
        assert!(matches!(first, Some(Statement::Store { .. })), "{first:?}");
    }
}
