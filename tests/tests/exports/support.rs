//! Examples as exports, and the programs that judge them.

use std::io::Write;
use std::process::Command;
use std::sync::Arc;

use chiaro_compiler::export::{self, Language, Target};
use chiaro_compiler::field::Graph;
use chiaro_compiler::solid::LiveParameter;
use chiaro_compiler::syntax::{Diagnostic, Sources};
use chiaro_compiler::{Options, World, compile};
use chiaro_tests::exported::exported;
use chiaro_tests::world::DiskWorld;
use chiaro_tests::{MemoryWorld, corpus, workspace};
use wgpu::util::DeviceExt;

/// A scene to be exported.
pub(crate) struct Example {
    pub(crate) name: String,
    pub(crate) graph: Graph,
    pub(crate) values: Vec<f64>,
    parameters: Vec<LiveParameter>,
    sources: Sources,
}

/// All scenes of the folder of examples, without those of the light suite.
pub(crate) fn examples() -> Vec<Example> {
    let folder = workspace().join("examples_csg");
    let files = corpus::examples().into_iter().filter(|path| path.parent() == Some(&folder));
    files.map(|path| Example::compiled(&DiskWorld, &path.to_string_lossy())).collect()
}

impl Example {
    /// The scene of a text.
    pub(crate) fn of(name: &str, text: &str) -> Self {
        Self::compiled(&MemoryWorld::of(name, text), name)
    }

    fn compiled(world: &dyn World, file: &str) -> Self {
        let compilation = compile(world, file, &Options::default());
        let scene = compilation.scene.unwrap_or_else(|| panic!("{file}: {:?}", compilation.diagnostics));
        let name = std::path::Path::new(file).file_stem().unwrap().to_string_lossy().into_owned();
        let values = scene.defaults();
        Self { name, graph: scene.picture(), values, parameters: scene.parameters, sources: compilation.sources }
    }

    /// The same, called so, with this said of each of its live numbers.
    pub(crate) fn saying(mut self, title: &str, descriptions: &[String]) -> Self {
        title.clone_into(&mut self.name);
        for (parameter, description) in self.parameters.iter_mut().zip(descriptions) {
            parameter.description = Some(description.clone());
        }
        self
    }

    /// Its export.
    pub(crate) fn export(&self, target: Target) -> Result<Vec<export::File>, Diagnostic> {
        exported(&self.name, &self.graph, &self.parameters, &self.sources, target)
    }

    /// The bytes of an export that is one file.
    pub(crate) fn bytes(&self, target: Target) -> Vec<u8> {
        let mut files = self.export(target).unwrap_or_else(|error| panic!("{}: {}", self.name, error.message));
        assert_eq!(files.len(), 1);
        files.remove(0).bytes
    }

    /// The same as text.
    pub(crate) fn text(&self, target: Target) -> String {
        String::from_utf8(self.bytes(target)).unwrap()
    }
}

/// The text of the file whose path ends so: the shortest, if several do.
pub(crate) fn text_at(files: &[export::File], ending: &str) -> String {
    let matching = files.iter().filter(|file| file.path.ends_with(ending));
    let file = matching.min_by_key(|file| file.path.len()).unwrap_or_else(|| panic!("no file is called …{ending}"));
    String::from_utf8(file.bytes.clone()).unwrap()
}

/// What a text is compiled as.
#[derive(Clone, Copy)]
pub(crate) enum Stage {
    Fragment,
    /// A fragment shader for Vulkan.
    Vulkan,
    Compute,
    HlslPixel,
    HlslCompute,
}

/// The SPIR-V that glslang makes of a text; for OpenGL's languages nothing, if there is no error. A warning counts as an error.
pub(crate) fn compiled_by_glslang(name: &str, text: &str, stage: Stage) -> Vec<u8> {
    let folder = tempfile::tempdir().unwrap();
    let (input, output) = (folder.path().join("shader"), folder.path().join("shader.spv"));
    std::fs::write(&input, text).unwrap();
    let stage_name = if matches!(stage, Stage::Compute | Stage::HlslCompute) { "comp" } else { "frag" };
    let mut command = Command::new("glslangValidator");
    command.args(["-S", stage_name]);
    match stage {
        Stage::Fragment => &mut command,
        Stage::Compute | Stage::Vulkan => command.arg("-V").arg("-o").arg(&output),
        Stage::HlslPixel => command.args(["-D", "-V", "-e", "pixel", "--auto-map-bindings", "-o"]).arg(&output),
        Stage::HlslCompute => command.args(["-D", "-V", "-e", "distances", "-o"]).arg(&output),
    };
    let result = command.arg(&input).output().expect("glslang-tools is what tools/setup.sh --tests installs");
    let said = String::from_utf8_lossy(&result.stdout);
    assert!(result.status.success() && !said.contains("WARNING"), "{name}: {said}");
    std::fs::read(&output).unwrap_or_default()
}

/// What glslang's preprocessor leaves of a text.
pub(crate) fn preprocessed_by_glslang(text: &str) -> String {
    let folder = tempfile::tempdir().unwrap();
    let input = folder.path().join("shader");
    std::fs::write(&input, text).unwrap();
    let result = Command::new("glslangValidator").args(["-E", "-S", "frag"]).arg(&input).output();
    String::from_utf8(result.expect("glslang-tools is what tools/setup.sh --tests installs").stdout).unwrap()
}

/// Panics unless naga accepts a text.
pub(crate) fn validated_by_naga(name: &str, text: &str) {
    let module =
        naga::front::wgsl::parse_str(text).unwrap_or_else(|error| panic!("{name}: {}", error.emit_to_string(text)));
    naga::valid::Validator::new(naga::valid::ValidationFlags::all(), naga::valid::Capabilities::empty())
        .validate(&module)
        .unwrap_or_else(|error| panic!("{name}: {}", error.emit_to_string(text)));
}

/// Checks SPIR-V by spirv-val.
pub(crate) fn validated(name: &str, words: &[u8]) {
    let mut file = tempfile::NamedTempFile::new().unwrap();
    file.write_all(words).unwrap();
    let result =
        Command::new("spirv-val").arg(file.path()).output().expect("tools/setup.sh --tests installs spirv-tools");
    assert!(result.status.success(), "{name}: {}", String::from_utf8_lossy(&result.stderr));
}

/// What an exported library answers when it is asked for a number at these points p, compiled by glslang and run on the graphics
/// adapter.
pub(crate) fn answers_on_gpu(example: &Example, language: Language, asked: &str, points: &[[f32; 3]]) -> Vec<f32> {
    let library = example.text(Target::Library(language));
    let constants: String = library.lines().filter_map(default_of).collect();
    let words = match language {
        Language::Hlsl => {
            let text =
                with_constants(&library, "cbuffer Parameters {", "};\n", &constants.replace("const ", "static const "));
            let main = format!(
                "\n[[vk::binding(0)]] StructuredBuffer<float4> points_asked;\n[[vk::binding(1)]] RWStructuredBuffer<float> answers;\n\
                 [numthreads(64, 1, 1)] void distances(uint3 id : SV_DispatchThreadID) {{\n\
                 float3 p = points_asked[id.x].xyz;\nanswers[id.x] = {asked};\n}}\n"
            );
            compiled_by_glslang(&example.name, &(text + &main), Stage::HlslCompute)
        }
        _ => {
            let library =
                with_constants(&library, "layout(std140, PARAMETERS_PLACE) uniform Parameters {", "};\n", &constants);
            let head = "#version 450\nlayout(local_size_x = 64) in;\n\
                        layout(std430, binding = 0) readonly buffer Points { vec4 points_asked[]; };\n\
                        layout(std430, binding = 1) buffer Answers { float answers[]; };\n";
            let main = format!(
                "\nvoid main() {{\nuint i = gl_GlobalInvocationID.x;\nvec3 p = points_asked[i].xyz;\nanswers[i] = {asked};\n}}\n"
            );
            compiled_by_glslang(&example.name, &[head, &library, &main].concat(), Stage::Compute)
        }
    };
    run(&words, if language == Language::Hlsl { "distances" } else { "main" }, points)
}

/// A live number's declaration as a constant with the default that the comment behind it tells.
fn default_of(line: &str) -> Option<String> {
    let declared = line.trim_start().trim_start_matches("uniform ").strip_prefix("float ")?;
    let (name, comment) = declared.split_once("; // ")?;
    let (_, default) = comment.split_once(" by default")?.0.rsplit_once(", ")?;
    Some(format!("const float {name} = float({default});\n"))
}

/// A text with constants in the place of a block.
fn with_constants(text: &str, start: &str, end: &str, constants: &str) -> String {
    let Some((before, rest)) = text.split_once(start) else { return text.to_owned() };
    let (_, behind) = rest.split_once(end).unwrap();
    [before, constants, behind].concat()
}

/// Runs a compute shader in SPIR-V over points.
fn run(spirv: &[u8], entry: &str, points: &[[f32; 3]]) -> Vec<f32> {
    let shared = device();
    let (device, queue) = &*shared;
    let count = points.len().next_multiple_of(64);
    let rows: Vec<f32> =
        points.iter().flat_map(|[x, y, z]| [*x, *y, *z, 0.0]).chain(std::iter::repeat(0.0)).take(4 * count).collect();
    let bytes: Vec<u8> = rows.iter().flat_map(|x| x.to_le_bytes()).collect();
    let module = device
        .create_shader_module(wgpu::ShaderModuleDescriptor { label: None, source: wgpu::util::make_spirv(spirv) });
    let usage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC;
    let asked = device.create_buffer_init(&wgpu::util::BufferInitDescriptor { label: None, contents: &bytes, usage });
    let size = 4 * count as u64;
    let answers = device.create_buffer(&wgpu::BufferDescriptor { label: None, size, usage, mapped_at_creation: false });
    let read = device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size,
        usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: None,
        layout: None,
        module: &module,
        entry_point: Some(entry),
        compilation_options: wgpu::PipelineCompilationOptions::default(),
        cache: None,
    });
    let entries = [&asked, &answers].map(wgpu::Buffer::as_entire_binding);
    let entries: Vec<wgpu::BindGroupEntry> =
        (0..).zip(entries).map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource }).collect();
    let layout = pipeline.get_bind_group_layout(0);
    let group =
        device.create_bind_group(&wgpu::BindGroupDescriptor { label: None, layout: &layout, entries: &entries });
    let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    {
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &group, &[]);
        pass.dispatch_workgroups(count as u32 / 64, 1, 1);
    }
    encoder.copy_buffer_to_buffer(&answers, 0, &read, 0, size);
    queue.submit([encoder.finish()]);
    read.map_async(wgpu::MapMode::Read, .., |result| result.unwrap());
    device.poll(wgpu::PollType::wait_indefinitely()).unwrap();
    let bytes = read.get_mapped_range(..).unwrap().to_vec();
    let floats = bytes.chunks_exact(4).map(|bytes| f32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]));
    floats.take(points.len()).collect()
}

/// The device that all tests of this program share.
fn device() -> Arc<(wgpu::Device, wgpu::Queue)> {
    static DEVICE: std::sync::OnceLock<Arc<(wgpu::Device, wgpu::Queue)>> = std::sync::OnceLock::new();
    let make = || {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
        let adapter = pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default())).unwrap();
        Arc::new(pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor::default())).unwrap())
    };
    DEVICE.get_or_init(make).clone()
}
