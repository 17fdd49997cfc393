//! The packages of engines that can't be run here, as compilers see them that know of the engines what their shaders read.

use std::collections::BTreeSet;
use std::io::Write;
use std::process::{Command, Stdio};

use chiaro_compiler::export::{Package, Target};

use super::support::{Example, Stage, compiled_by_glslang, examples, text_at, validated_by_naga};

#[test]
fn isf_has_its_inputs() {
    for example in examples() {
        let generator = example.text(Target::Package(Package::Isf));
        let head = generator.strip_prefix("/*").and_then(|text| text.split_once("*/")).unwrap().0;
        serde_json::from_str::<serde_json::Value>(head).unwrap_or_else(|error| panic!("{}: {error}", example.name));
        let inputs: String = generator.lines().filter_map(isf_uniform).collect();
        let host =
            format!("#version 150\nuniform vec2 RENDERSIZE;\nuniform float TIME;\nout vec4 isf_color;\n{inputs}");
        let generator = generator.replace("gl_FragColor", "isf_color");
        compiled_by_glslang(&example.name, &format!("{host}{generator}"), Stage::Fragment);
    }
}

/// What ISF's hosts declare for a line of the list of inputs.
fn isf_uniform(line: &str) -> Option<String> {
    let (_, rest) = line.split_once("{ \"NAME\": \"")?;
    let (name, rest) = rest.split_once("\", \"TYPE\": \"")?;
    let ty = match rest.split_once('"')?.0 {
        "point2D" => "vec2",
        "long" => "int",
        _ => "float",
    };
    Some(format!("uniform {ty} {name};\n"))
}

#[test]
fn bevys_materials_are_valid() {
    for example in examples() {
        let files = example.export(Target::Package(Package::Bevy)).unwrap();
        for ending in [".wgsl", "_depth.wgsl", "_picture.wgsl"] {
            let text = format!("{BEVY}{}", without_bevy(&text_at(&files, ending)));
            validated_by_naga(&format!("{} {ending}", example.name), &text);
        }
    }
}

#[test]
fn bevys_crate_is_formatted() {
    for example in examples() {
        let files = example.export(Target::Package(Package::Bevy)).unwrap();
        for ending in ["src/lib.rs", "examples/show.rs"] {
            let mut rustfmt = Command::new("rustfmt");
            rustfmt
                .args(["--check", "--edition=2024", "--config-path=/dev/null"])
                .stdin(Stdio::piped())
                .stdout(Stdio::piped());
            let mut rustfmt = rustfmt.spawn().unwrap();
            rustfmt.stdin.take().unwrap().write_all(text_at(&files, ending).as_bytes()).unwrap();
            let result = rustfmt.wait_with_output().unwrap();
            // Of what comes from standard input the status doesn't tell.
            let difference = String::from_utf8(result.stdout).unwrap();
            assert!(result.status.success() && difference.is_empty(), "{} {ending}: {difference}", example.name);
        }
    }
}

/// What Bevy's shaders import, cut down to what is read of it.
const BEVY: &str = "
struct View { clip_from_world: mat4x4<f32>, world_from_view: mat4x4<f32>, clip_from_view: mat4x4<f32>, world_position: vec3<f32>, viewport: vec4<f32> }
struct Mesh { flags: u32 }
@group(0) @binding(0) var<uniform> view: View;
@group(1) @binding(0) var<storage> mesh: array<Mesh>;
struct VertexOutput { @builtin(position) position: vec4<f32>, @location(0) world_position: vec4<f32>, @location(6) @interpolate(flat) instance_index: u32 }
fn get_local_from_world(i: u32) -> mat4x4<f32> { return view.clip_from_world; }
fn get_world_from_local(i: u32) -> mat4x4<f32> { return view.clip_from_world; }
fn get_previous_world_from_local(i: u32) -> mat4x4<f32> { return view.clip_from_world; }
fn calculate_motion_vector(to: vec4<f32>, before: vec4<f32>) -> vec2<f32> { return to.xy - before.xy; }
struct StandardMaterial { base_color: vec4<f32>, emissive: vec4<f32>, perceptual_roughness: f32, metallic: f32 }
struct PbrInput { material: StandardMaterial, frag_coord: vec4<f32>, world_position: vec4<f32>, world_normal: vec3<f32>, N: vec3<f32>, V: vec3<f32>, is_orthographic: bool, flags: u32 }
fn pbr_input_new() -> PbrInput { return PbrInput(); }
fn apply_pbr_lighting(input: PbrInput) -> vec4<f32> { return input.material.base_color; }
fn main_pass_post_lighting_processing(input: PbrInput, color: vec4<f32>) -> vec4<f32> { return color; }
fn calculate_view(p: vec4<f32>, is_orthographic: bool) -> vec3<f32> { return p.xyz; }
";

/// A shader without Bevy's imports and conditions.
fn without_bevy(text: &str) -> String {
    let (above, rest) = text.split_once("#import").unwrap();
    let (_, below) = rest.split_once("\n}\n").unwrap();
    let lines = below.lines().filter(|line| !line.starts_with('#'));
    let text: String = lines.map(|line| format!("{line}\n")).collect();
    above.to_owned() + &text.replace("pbr_types::", "").replace("#{MATERIAL_BIND_GROUP}", "2")
}

/// What Unity's includes declare of what its shaders read.
const UNITY: &str = "cbuffer Unity {\n    float4x4 UNITY_MATRIX_V, UNITY_MATRIX_P, UNITY_MATRIX_VP, unity_WorldToObject, unity_ObjectToWorld;\n    \
                     float4 _ScreenParams, _Time;\n};\n";

#[test]
fn modules_for_three_are_shader_code_between_backticks() {
    // What three.js would put in the place of its includes, and declare before.
    let includes = [
        ("#include <common>", "bool isPerspectiveMatrix(mat4 m) { return m[2][3] == -1.0; }\n"),
        ("#include <colorspace_fragment>", ""),
    ];
    let before = "#version 300 es\n#define varying in\n#define gl_FragColor shown_color\nprecision highp float;\n\
                  precision highp int;\nout vec4 shown_color;\n";
    for example in examples() {
        let files = example.export(Target::Package(Package::Three)).unwrap();
        let name = &example.name;
        let literals = |path: &str| template_literals(&text_at(&files, path));
        if name == "clock" {
            let mesh = text_at(&files, "webgl/clock.js");
            assert!(mesh.contains("this.parameters.time_value = (performance.now() "), "{mesh}");
        }
        let [.., fragment, scene] = &literals(&format!("webgl/{name}_picture.js"))[..] else { panic!("{name}") };
        let picture = includes.iter().fold(format!("{scene}{fragment}"), |text, (from, to)| text.replace(from, to));
        compiled_by_glslang(name, &format!("{before}{picture}"), Stage::Fragment);
        for path in [format!("webgpu/{name}.js"), format!("webgpu/{name}_picture.js")] {
            validated_by_naga(&path, &literals(&path).concat());
        }
    }
}

#[test]
fn no_class_for_three_has_the_name_of_one_of_its_own() {
    let files = Example::of("mesh.csg", "sphere(5);").export(Target::Package(Package::Three)).unwrap();
    for path in ["webgl/mesh.js", "webgpu/mesh.js"] {
        assert!(text_at(&files, path).contains("\nexport class MeshSolid extends Mesh {\n"), "{path}");
    }
}

/// The shader code of a module: what is between a comment that names the language and a closing backtick.
fn template_literals(module: &str) -> Vec<String> {
    let pieces = module.split("sl */ `").skip(1);
    let ends = |text: &str| {
        let end = text.match_indices('`').find(|(at, _)| !text[..*at].ends_with('\\')).expect("the literal ends");
        text[..end.0].replace(r"\`", "`").replace(r"\${", "${").replace(r"\\", r"\")
    };
    pieces.map(ends).collect()
}

#[test]
fn unitys_shaders_compile() {
    for example in examples() {
        let files = example.export(Target::Package(Package::Unity)).unwrap();
        let numbers = unity_numbers(&text_at(&files, ".shader"));
        let solid = format!(
            "{UNITY}{numbers}{}\nfloat4 pixel(float3 p : POINT) : SV_Target {{\n    SceneHit hit = MeetScene(p);\n    \
             return float4(hit.normalWS, SceneDepth(hit.positionCS));\n}}\n",
            text_at(&files, ".hlsl")
        );
        compiled_by_glslang(&example.name, &solid, Stage::HlslPixel);
        // The pass itself is that of HLSL programs, which all examples are compiled as.
        if example.name == "mug" {
            let picture = format!(
                "{UNITY}{numbers}{}\nfloat4 pixel(float3 p : POINT) : SV_Target {{\n    \
                 OnePass seen = one_pass(ScenePoint(p), p, 0.1, p.xy, 0);\n    return float4(shown(seen.color), seen.t);\n}}\n",
                text_at(&files, "_picture.hlsl")
            );
            compiled_by_glslang(&example.name, &picture, Stage::HlslPixel);
        }
    }
}

/// The declarations of the live numbers of a `.shader`, each once, though both pipelines have them.
fn unity_numbers(shader: &str) -> String {
    let is_number = |line: &&str| ["        float _", "        #define _"].iter().any(|start| line.starts_with(start));
    let lines: BTreeSet<&str> = shader.lines().filter(is_number).filter(|line| !line.contains("_unused")).collect();
    lines.into_iter().map(|line| format!("{line}\n")).collect()
}

#[test]
fn unreals_shaders_compile() {
    for example in examples() {
        let files = example.export(Target::Package(Package::Unreal)).unwrap();
        let material = format!(
            "{}\nfloat4 pixel(float3 p : POINT) : SV_Target {{\n    SceneHit hit = MeetScene(p, p, 1.0, 1.0);\n    \
             return float4(hit.Normal, hit.DepthOffset);\n}}\n",
            text_at(&files, ".ush")
        );
        compiled_by_glslang(&example.name, &material, Stage::HlslPixel);
    }
}

#[test]
fn no_crate_for_bevy_is_called_as_one_of_rusts_or_bevys() {
    for (scene, expected) in
        [("box", "box_scene"), ("test", "test_scene"), ("standard", "standard_scene"), ("mug", "mug")]
    {
        let example = Example::of(&format!("{scene}.csg"), "sphere(2);");
        let files = example.export(Target::Package(Package::Bevy)).unwrap();
        assert!(text_at(&files, "Cargo.toml").contains(&format!("name = \"{expected}\"")), "{scene}");
        assert!(!text_at(&files, "src/lib.rs").contains(" StandardMaterial {"), "{scene}");
    }
}
