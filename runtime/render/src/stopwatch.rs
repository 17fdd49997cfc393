//! How long kernels run: by the device's own clock, where it has one, else by the processor's.

use std::time::{Duration, Instant};

use wgpu::{
    Buffer, BufferDescriptor, BufferUsages, CommandEncoder, ComputePassTimestampWrites, Features, QuerySet,
    QuerySetDescriptor, QueryType,
};

use crate::error::Result;
use crate::gpu::Gpu;

/// Measures one kernel at a time.
#[derive(Debug)]
pub(crate) struct Stopwatch {
    device_clock: Option<DeviceClock>,
}

#[derive(Debug)]
struct DeviceClock {
    queries: QuerySet,
    ticks: Buffer,
    nanoseconds_per_tick: f64,
}

impl Stopwatch {
    /// The best there is on the device. Software adapters work by the processor's clock (and lavapipe's own tells
    /// when a pass was recorded).
    pub(crate) fn new(gpu: &Gpu) -> Result<Self> {
        if gpu.description().software || !gpu.device.features().contains(Features::TIMESTAMP_QUERY) {
            return Ok(Self { device_clock: None });
        }
        gpu.checked(|| {
            let queries = gpu.device.create_query_set(&QuerySetDescriptor {
                label: Some("stopwatch"),
                ty: QueryType::Timestamp,
                count: 2,
            });
            let ticks = gpu.device.create_buffer(&BufferDescriptor {
                label: Some("ticks"),
                size: 16,
                usage: BufferUsages::QUERY_RESOLVE | BufferUsages::COPY_SRC,
                mapped_at_creation: false,
            });
            let nanoseconds_per_tick = f64::from(gpu.queue.get_timestamp_period());
            Self { device_clock: Some(DeviceClock { queries, ticks, nanoseconds_per_tick }) }
        })
    }

    /// What a pass has to write.
    pub(crate) fn writes(&self) -> Option<ComputePassTimestampWrites<'_>> {
        let clock = self.device_clock.as_ref()?;
        Some(ComputePassTimestampWrites {
            query_set: &clock.queries,
            beginning_of_pass_write_index: Some(0),
            end_of_pass_write_index: Some(1),
        })
    }

    /// Has to follow the pass.
    pub(crate) fn collect(&self, encoder: &mut CommandEncoder) {
        if let Some(clock) = &self.device_clock {
            encoder.resolve_query_set(&clock.queries, 0..2, &clock.ticks, 0);
        }
    }

    /// How long the pass took that was submitted at `submitted` and is done.
    pub(crate) fn read(&self, gpu: &Gpu, submitted: Instant) -> Result<Duration> {
        let elapsed = submitted.elapsed();
        let Some(clock) = &self.device_clock else {
            return Ok(elapsed);
        };
        let ticks: Vec<u64> = bytemuck::pod_collect_to_vec(&gpu.read(&clock.ticks)?);
        let on_device = ticks[1].saturating_sub(ticks[0]) as f64 * clock.nanoseconds_per_tick;
        // A device whose clock stands still, or was set in between, is not believed.
        let believable = on_device > 0.0 && on_device <= elapsed.as_nanos() as f64;
        Ok(if believable { Duration::from_nanos(on_device as u64) } else { elapsed })
    }
}
