//! From the sum of samples to the bytes that a screen shows.

use chiaro_shader::FOR_SCREENS;
use wgpu::{
    BindGroup, BindingResource, Buffer, BufferDescriptor, BufferUsages, COPY_BYTES_PER_ROW_ALIGNMENT, Extent3d,
    TexelCopyBufferInfo, TexelCopyBufferLayout, Texture, TextureDescriptor, TextureDimension, TextureUsages,
};

use crate::error::{Error, Result};
use crate::gpu::Gpu;
use crate::kernel::{Kernel, PIXEL_FORMAT, Slot, buffer, workgroups};
use crate::stopwatch::Stopwatch;

/// What resolves one picture.
#[derive(Debug)]
pub(crate) struct Resolver {
    kernel: Kernel,
    resolution: Buffer,
    texture: Texture,
    group: BindGroup,
    stopwatch: Stopwatch,
}

/// The kernel, compiled once for a device.
fn kernel(gpu: &Gpu) -> Result<Kernel> {
    if let Some(kernel) = gpu.resolve.get() {
        return Ok(kernel.clone());
    }
    let module = naga::front::wgsl::parse_str(&[FOR_SCREENS, include_str!("resolve.wgsl")].join("\n"))
        .map_err(|error| Error::Refused(format!("resolve.wgsl: {}", error.message())))?;
    let slots = [(0, Slot::Uniform), (1, Slot::Read), (2, Slot::Pixels)];
    let kernel = Kernel::new(gpu, module, "resolve", &[&slots])?;
    Ok(gpu.resolve.get_or_init(|| kernel).clone())
}

impl Resolver {
    /// For a picture of this size with these sums.
    pub(crate) fn new(gpu: &Gpu, size: [u32; 2], sums: &Buffer) -> Result<Self> {
        let kernel = kernel(gpu)?;
        let resolution = buffer(gpu, "resolution", Slot::Uniform, 16)?;
        let texture = gpu.checked(|| {
            gpu.device.create_texture(&TextureDescriptor {
                label: Some("picture"),
                size: Extent3d { width: size[0], height: size[1], depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: 1,
                dimension: TextureDimension::D2,
                format: PIXEL_FORMAT,
                usage: TextureUsages::STORAGE_BINDING | TextureUsages::TEXTURE_BINDING | TextureUsages::COPY_SRC,
                view_formats: &[],
            })
        })?;
        let view = texture.create_view(&Default::default());
        let resources = [
            (0, resolution.as_entire_binding()),
            (1, sums.as_entire_binding()),
            (2, BindingResource::TextureView(&view)),
        ];
        let group = kernel.bind(gpu, 0, &resources)?;
        Ok(Self { kernel, resolution, texture, group, stopwatch: Stopwatch::new(gpu)? })
    }

    /// Resolves into the texture.
    pub(crate) fn run(&self, gpu: &Gpu, samples: u32, exposure: f32) -> Result<&Texture> {
        let scale = exposure / samples.max(1) as f32;
        gpu.queue.write_buffer(&self.resolution, 0, bytemuck::bytes_of(&[scale, 0.0, 0.0, 0.0]));
        let pixels = [self.texture.width(), self.texture.height()];
        self.kernel.run(gpu, &self.stopwatch, &[&self.group], workgroups(pixels))?;
        Ok(&self.texture)
    }

    /// The texture's bytes: rows from the top, red, green, blue, alpha.
    pub(crate) fn read(&self, gpu: &Gpu) -> Result<Vec<u8>> {
        let row = 4 * self.texture.width();
        let padded = row.next_multiple_of(COPY_BYTES_PER_ROW_ALIGNMENT);
        let copy = gpu.checked(|| {
            gpu.device.create_buffer(&BufferDescriptor {
                label: Some("pixels"),
                size: u64::from(padded) * u64::from(self.texture.height()),
                usage: BufferUsages::MAP_READ | BufferUsages::COPY_DST,
                mapped_at_creation: false,
            })
        })?;
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        let layout = TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(padded), rows_per_image: None };
        encoder.copy_texture_to_buffer(
            self.texture.as_image_copy(),
            TexelCopyBufferInfo { buffer: &copy, layout },
            self.texture.size(),
        );
        gpu.finish(encoder)?;
        let bytes = gpu.read_mapped(&copy)?;
        Ok(bytes.chunks(padded as usize).flat_map(|line| &line[..row as usize]).copied().collect())
    }
}
