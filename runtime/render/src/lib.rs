//! Draws a compiled scene with wgpu: devices, pipelines, progressive pictures, readback.
