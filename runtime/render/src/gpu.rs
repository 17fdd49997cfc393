//! The graphics device.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};
use std::time::Duration;

use pollster::block_on;
use wgpu::{
    Adapter, Backends, BufferUsages, CommandEncoder, Device, DeviceDescriptor, DeviceType, ErrorFilter, Features,
    Instance, InstanceDescriptor, InstanceFlags, Limits, PollType, Queue,
};

use crate::error::{Error, Result};
use crate::kernel::Kernel;
use crate::kernels::Kernels;
use crate::picture::BYTES_PER_PIXEL;

/// How long one submission may take. Software drivers compile large shaders within their first one.
const PATIENCE: Duration = Duration::from_secs(300);

/// Which graphics adapter to use.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Preference {
    /// The fastest kind there is: a graphics card, else a software adapter.
    #[default]
    Any,
    /// A graphics card.
    Hardware,
    /// A software adapter such as Mesa's lavapipe, which draws the same on every machine.
    Software,
    /// The first whose name contains this, in any case of letters.
    Named(String),
}

/// A graphics adapter of this machine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AdapterDescription {
    /// Its name.
    pub name: String,
    /// Whether the processor does its work.
    pub software: bool,
    /// The driver, with its version.
    pub driver: String,
    /// The interface it is reached by, such as Vulkan.
    pub interface: String,
}

/// A graphics device, ready to draw. Clones are the same device.
#[derive(Clone, Debug)]
pub struct Gpu {
    pub(crate) device: Device,
    pub(crate) queue: Queue,
    description: AdapterDescription,
    fault: Arc<Mutex<Option<Error>>>,
    pipelines: Arc<AtomicUsize>,
    kernels: Arc<Mutex<Kernels>>,
    /// What resolves pictures, once one was made.
    pub(crate) resolve: Arc<OnceLock<Kernel>>,
}

/// The graphics adapters of this machine, best first.
pub fn adapters() -> Vec<AdapterDescription> {
    available().iter().map(describe).collect()
}

impl Gpu {
    /// Opens a device.
    pub fn new(preference: &Preference) -> Result<Self> {
        let available = available();
        if available.is_empty() {
            return Err(Error::NoDriver);
        }
        match available.iter().find(|adapter| preference.admits(&describe(adapter))) {
            Some(adapter) => Self::open(adapter),
            None => {
                let names: Vec<String> = available.iter().map(|adapter| describe(adapter).name).collect();
                Err(Error::NoAdapter { wanted: preference.to_string(), available: names.join(", ") })
            }
        }
    }

    fn open(adapter: &Adapter) -> Result<Self> {
        let description = describe(adapter);
        let offered = adapter.limits();
        let descriptor = DeviceDescriptor {
            label: Some("chiaro"),
            required_features: adapter.features() & Features::TIMESTAMP_QUERY,
            required_limits: Limits {
                max_buffer_size: offered.max_buffer_size,
                max_storage_buffers_per_shader_stage: offered.max_storage_buffers_per_shader_stage,
                max_storage_buffer_binding_size: offered.max_storage_buffer_binding_size,
                max_uniform_buffer_binding_size: offered.max_uniform_buffer_binding_size,
                max_texture_dimension_2d: offered.max_texture_dimension_2d,
                ..Limits::default()
            },
            ..DeviceDescriptor::default()
        };
        let (device, queue) = block_on(adapter.request_device(&descriptor))
            .map_err(|error| Error::Unusable { adapter: description.name.clone(), reason: error.to_string() })?;

        // What no error scope catches is kept until somebody can answer it.
        let fault = Arc::new(Mutex::new(None));
        let uncaptured = fault.clone();
        device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
            lock(&uncaptured).get_or_insert(Error::Refused(one_line(&error.to_string())));
        }));
        let lost = fault.clone();
        device.set_device_lost_callback(move |reason, message| {
            if reason != wgpu::DeviceLostReason::Destroyed {
                lock(&lost).get_or_insert(Error::Lost(one_line(&message)));
            }
        });
        Ok(Self {
            device,
            queue,
            description,
            fault,
            pipelines: Arc::default(),
            kernels: Arc::default(),
            resolve: Arc::default(),
        })
    }

    /// What draws.
    pub fn description(&self) -> &AdapterDescription {
        &self.description
    }

    /// The device, for programs that show pictures in a window of their own.
    pub fn device(&self) -> &Device {
        &self.device
    }

    /// The most pixels that a picture may have along one edge.
    pub fn longest_edge(&self) -> u32 {
        self.device.limits().max_texture_dimension_2d
    }

    /// The most pixels that a picture may have in all.
    pub fn most_pixels(&self) -> u64 {
        let limits = self.device.limits();
        limits.max_storage_buffer_binding_size.min(limits.max_buffer_size) / BYTES_PER_PIXEL
    }

    /// How many pipelines were compiled so far; moving a live number, the view, or a member of a large union
    /// compiles none.
    pub fn pipelines_compiled(&self) -> usize {
        self.pipelines.load(Ordering::Relaxed)
    }

    /// The kernels that were compiled lately.
    pub(crate) fn kernels(&self) -> MutexGuard<'_, Kernels> {
        lock(&self.kernels)
    }

    pub(crate) fn count_pipeline(&self) {
        self.pipelines.fetch_add(1, Ordering::Relaxed);
    }

    /// Does what may upset the driver, and answers its complaint as an error.
    pub(crate) fn checked<T>(&self, work: impl FnOnce() -> T) -> Result<T> {
        let validation = self.device.push_error_scope(ErrorFilter::Validation);
        let memory = self.device.push_error_scope(ErrorFilter::OutOfMemory);
        let internal = self.device.push_error_scope(ErrorFilter::Internal);
        let done = work();
        let complaints = [internal, memory, validation].map(|scope| block_on(scope.pop()));
        if let Some(fault) = lock(&self.fault).clone() {
            return Err(fault);
        }
        match complaints.into_iter().flatten().next() {
            Some(complaint) => Err(Error::Refused(one_line(&complaint.to_string()))),
            None => Ok(done),
        }
    }

    /// Submits the commands and waits until they are done.
    pub(crate) fn finish(&self, encoder: CommandEncoder) -> Result<()> {
        let index = self.checked(|| self.queue.submit([encoder.finish()]))?;
        self.wait(PollType::Wait { submission_index: Some(index), timeout: Some(PATIENCE) })
    }

    /// The bytes of a buffer that can be copied from.
    pub(crate) fn read(&self, buffer: &wgpu::Buffer) -> Result<Vec<u8>> {
        let copy = self.checked(|| {
            self.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("read back"),
                size: buffer.size(),
                usage: BufferUsages::MAP_READ | BufferUsages::COPY_DST,
                mapped_at_creation: false,
            })
        })?;
        let mut encoder = self.device.create_command_encoder(&Default::default());
        encoder.copy_buffer_to_buffer(buffer, 0, &copy, 0, buffer.size());
        self.finish(encoder)?;
        self.read_mapped(&copy)
    }

    /// The bytes of a buffer that can be mapped.
    pub(crate) fn read_mapped(&self, buffer: &wgpu::Buffer) -> Result<Vec<u8>> {
        buffer.map_async(wgpu::MapMode::Read, .., |_| {});
        self.wait(PollType::Wait { submission_index: None, timeout: Some(PATIENCE) })?;
        let bytes = match buffer.get_mapped_range(..) {
            Ok(range) => range.to_vec(),
            Err(error) => return Err(Error::Refused(one_line(&error.to_string()))),
        };
        buffer.unmap();
        Ok(bytes)
    }

    fn wait(&self, poll: PollType) -> Result<()> {
        let polled = self.device.poll(poll);
        if let Some(fault) = lock(&self.fault).clone() {
            return Err(fault);
        }
        polled.map(|_| ()).map_err(|_| Error::Stuck(PATIENCE.as_secs()))
    }
}

impl Preference {
    fn admits(&self, adapter: &AdapterDescription) -> bool {
        match self {
            Preference::Any => true,
            Preference::Hardware => !adapter.software,
            Preference::Software => adapter.software,
            Preference::Named(name) => adapter.name.to_lowercase().contains(&name.to_lowercase()),
        }
    }
}

impl std::fmt::Display for Preference {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Preference::Any => f.write_str("usable"),
            Preference::Hardware => f.write_str("a graphics card"),
            Preference::Software => f.write_str("a software adapter"),
            Preference::Named(name) => write!(f, "named \"{name}\""),
        }
    }
}

/// The machine's adapters, the fastest kind first.
fn available() -> Vec<Adapter> {
    let descriptor = InstanceDescriptor {
        backends: Backends::from_env().unwrap_or(Backends::PRIMARY),
        flags: InstanceFlags::empty().with_env(),
        ..InstanceDescriptor::new_without_display_handle()
    };
    let instance = Instance::new(descriptor);
    let mut adapters = block_on(instance.enumerate_adapters(Backends::all()));
    adapters.sort_by_key(|adapter| match adapter.get_info().device_type {
        DeviceType::DiscreteGpu => 0,
        DeviceType::IntegratedGpu => 1,
        DeviceType::VirtualGpu => 2,
        DeviceType::Other => 3,
        DeviceType::Cpu => 4,
    });
    adapters
}

fn describe(adapter: &Adapter) -> AdapterDescription {
    let info = adapter.get_info();
    AdapterDescription {
        name: info.name,
        software: info.device_type == DeviceType::Cpu,
        driver: format!("{} {}", info.driver, info.driver_info).trim().to_string(),
        interface: info.backend.to_string(),
    }
}

/// A lock that a panic elsewhere does not take away: the value is only ever replaced as a whole.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A driver's message without its line breaks.
fn one_line(message: &str) -> String {
    message.split_whitespace().collect::<Vec<_>>().join(" ")
}
