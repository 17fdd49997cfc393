//! Exported shader code of every example in every language, as other people's compilers see it: glslang for GLSL and HLSL,
//! spirv-val for SPIR-V, naga for WGSL. And the numbers it comes to, on the graphics adapter, beside those of the CPU.

mod engines;
mod godot;
mod hostile;
mod series;
mod support;

use chiaro_compiler::export::{Language, Package, Target};
use chiaro_compiler::field::{Evaluator, Painter};
use chiaro_compiler::vocabulary::Bounds;
use chiaro_tests::sampling::Random;
use support::{Example, Stage, answers_on_gpu, compiled_by_glslang, examples, validated, validated_by_naga};

#[test]
fn wgsl_is_valid() {
    for example in examples() {
        for target in [Target::Library(Language::Wgsl), Target::Program(Language::Wgsl)] {
            validated_by_naga(&example.name, &example.text(target));
        }
    }
}

#[test]
fn glslang_accepts_every_program() {
    for example in examples() {
        for language in [Language::Glsl330, Language::GlslEs300, Language::Hlsl] {
            let text = example.text(Target::Program(language));
            let stage = if language == Language::Hlsl { Stage::HlslPixel } else { Stage::Fragment };
            compiled_by_glslang(&example.name, &text, stage);
        }
        compiled_as_vulkan_and_opengl(&example);
        compiled_by_glslang(&example.name, &example.text(Target::Package(Package::GlslViewer)), Stage::Fragment);
        let image = example.text(Target::Package(Package::Shadertoy));
        let page = "#version 300 es\nprecision highp float;\nprecision highp int;\nuniform vec3 iResolution;\n\
                    uniform float iTime;\nuniform vec4 iMouse;\nout vec4 pixel;\n";
        let main = "\nvoid main() { mainImage(pixel, gl_FragCoord.xy); }\n";
        compiled_by_glslang(&example.name, &format!("{page}{image}{main}"), Stage::Fragment);
    }
}

/// GLSL 4.50 is for both, as a program and as a library that is bound elsewhere.
fn compiled_as_vulkan_and_opengl(example: &Example) {
    let program = example.text(Target::Program(Language::Glsl450));
    compiled_by_glslang(&example.name, &program, Stage::Fragment);
    validated(&example.name, &compiled_by_glslang(&example.name, &program, Stage::Vulkan));
    let library = example.text(Target::Library(Language::Glsl450));
    let main = "layout(location = 0) out vec4 pixel;\n\
                void main() { pixel = scene_surface(vec3(0.0)).color * scene_distance(scene_gradient(vec3(0.0), 1.0)); }\n";
    let place = "#define PARAMETERS_PLACE set = 1, binding = 2\n";
    compiled_by_glslang(&example.name, &["#version 450\n", &library, main].concat(), Stage::Fragment);
    compiled_by_glslang(&example.name, &["#version 450\n", place, &library, main].concat(), Stage::Vulkan);
}

#[test]
fn spirv_is_valid() {
    for example in examples() {
        validated(&example.name, &example.bytes(Target::Program(Language::SpirV)));
    }
}

/// By which part of the size of what is sampled single precision may be off: four units in the last place.
const RELATIVE: f64 = 4.0 / 16_777_216.0;

#[test]
fn distances_are_those_of_the_cpu() {
    let mut table = String::from("scene, largest difference in millimetres in GLSL and in HLSL\n");
    for example in examples() {
        let (differences, allowed) = differences(&example, 10_000);
        table += &format!("{}, {:.2e}, {:.2e}, of {allowed:.2e}\n", example.name, differences[0], differences[1]);
        assert!(differences.iter().all(|difference| *difference <= allowed), "{table}");
    }
    std::fs::write(concat!(env!("CARGO_TARGET_TMPDIR"), "/distances.csv"), table).unwrap();
}

#[test]
fn outlines_of_many_edges_are_loops() {
    let star = "n = 64; linear_extrude(5) polygon([for (i = [0 : n - 1]) (i % 2 ? 10 : 14) * [cos(360 * i / n), sin(360 * i / n)]]);";
    let example = Example::of("star.csg", star);
    let text = example.text(Target::Library(Language::GlslEs300));
    assert!(text.contains("const vec4 tables[") && text.contains("for (uint row_b = "), "{text}");
    validated_by_naga("star", &example.text(Target::Program(Language::Wgsl)));
    compiled_by_glslang("star", &example.text(Target::Program(Language::GlslEs300)), Stage::Fragment);
    compiled_by_glslang("star", &example.text(Target::Program(Language::Hlsl)), Stage::HlslPixel);
}

/// How far off the distances of a library in GLSL and in HLSL are at so many points, and how far they may be.
fn differences(example: &Example, count: usize) -> ([f64; 2], f64) {
    let root = &example.graph.facts[example.graph.root.0 as usize];
    let bounds = chiaro_tests::sampling::sample_box(&root.bounds);
    let points = random_points(&bounds, count);
    let evaluator = Evaluator::new(&example.graph, &example.values);
    let expected: Vec<f64> = points.iter().map(|point| evaluator.distance(point.map(f64::from))).collect();
    let differences = [Language::Glsl450, Language::Hlsl].map(|language| {
        let found = answers_on_gpu(example, language, "scene_distance(p)", &points);
        let difference = |(found, expected): (&f32, &f64)| (f64::from(*found) - expected).abs();
        found.iter().zip(&expected).map(difference).fold(0.0, f64::max)
    });
    (differences, RELATIVE * bounds.diagonal() * root.lipschitz.max(1.0))
}

/// Of all points this part may lie where two materials are as near as rounding can tell.
const AT_EDGES: f64 = 0.01;

#[test]
fn materials_are_those_of_the_cpu() {
    for example in examples() {
        let (found, expected) = colors(&example, 4_000);
        let differ = found.iter().zip(&expected).filter(|(a, b)| (**a - **b).abs() > 0.02).count();
        assert!(differ as f64 <= AT_EDGES * found.len() as f64, "{}: {differ} of {}", example.name, found.len());
    }
}

/// One number for the linear colours of a scene at some points: as a library in GLSL has it on the graphics adapter, and as the CPU.
fn colors(example: &Example, count: usize) -> (Vec<f32>, Vec<f32>) {
    let bounds = chiaro_tests::sampling::sample_box(&example.graph.facts[example.graph.root.0 as usize].bounds);
    let points = random_points(&bounds, count);
    let (evaluator, painter) =
        (Evaluator::new(&example.graph, &example.values), Painter::new(&example.graph, &example.values));
    let asked = "dot(scene_surface(p).color.rgb, vec3(1.0, 2.0, 4.0))";
    let found = answers_on_gpu(example, Language::Glsl450, asked, &points);
    let expected = points.iter().map(|point| {
        let [red, green, blue, _] = painter.look(&evaluator, point.map(f64::from)).color;
        (red + 2.0 * green + 4.0 * blue) as f32
    });
    (found, expected.collect())
}

fn random_points(bounds: &Bounds, count: usize) -> Vec<[f32; 3]> {
    let mut random = Random::new(5);
    (0..count).map(|_| random.point(bounds).map(|x| x as f32)).collect()
}

#[test]
fn values_are_called_after_their_modules() {
    let bracket = examples().into_iter().find(|example| example.name == "bracket").unwrap();
    let text = bracket.text(Target::Library(Language::GlslEs300));
    assert!(text.contains("float screw_hole_cylinder_a = sd_cylinder("), "{text}");
    assert!(text.contains("uniform float thickness; // "), "{text}");
}

#[test]
fn comments_and_loops_stay() {
    let tree = examples().into_iter().find(|example| example.name == "tree").unwrap();
    for language in [Language::Glsl330, Language::Hlsl, Language::Metal] {
        let text = tree.text(Target::Program(language));
        assert!(text.contains("// Theory: "), "{language:?}");
        assert!(text.contains("for (int i = 0; i < rays; i++) {"), "{language:?}");
    }
}

#[test]
fn what_a_target_cannot_express_is_an_error() {
    let example = Example::of("cube.csg", "cube(3);");
    let error = example.export(Target::Library(Language::SpirV)).unwrap_err();
    assert_eq!(error.message, "SPIR-V has no libraries of functions");
    assert_eq!(error.hints, ["export a whole program: --program"]);
}

#[test]
fn an_empty_scene_is_an_error() {
    for text in ["", "union() { }", "intersection() { cube(3); translate([9, 0, 0]) cube(3); }", "sun();"] {
        let example = Example::of("empty.csg", text);
        for target in [
            Target::Library(Language::Glsl330),
            Target::Program(Language::SpirV),
            Target::Package(Package::Shadertoy),
            Target::Package(Package::Blender),
        ] {
            assert!(example.export(target).unwrap_err().message.starts_with("the scene is empty"), "{text}");
        }
    }
}

#[test]
fn glsl_viewer_and_programs_begin_with_their_version() {
    // glslViewer takes another version unless these are the very first characters.
    let example = Example::of("cube.csg", "cube(3);");
    for (target, version) in [
        (Target::Package(Package::GlslViewer), "#version 330\n"),
        (Target::Program(Language::Glsl330), "#version 330 core\n"),
        (Target::Program(Language::Glsl450), "#version 450 core\n"),
        (Target::Program(Language::GlslEs300), "#version 300 es\n"),
    ] {
        assert!(example.text(target).starts_with(version), "{target:?}");
    }
}

#[test]
fn parameters_may_have_the_names_of_words_of_languages() {
    // Words of WGSL, of GLSL, of HLSL, of all of them; and what the code around the scene calls its own values.
    let names = [
        "const", "fn", "self", "where", "float", "void", "ivec3", "volatile", "modf", "half4x4", "mul", "saturate",
        "int", "texture", "sampler", "hit", "sky", "radiance", "dyn",
    ];
    let mut scene: String = names.iter().map(|name| format!("{name} = 5; // [1:10]\n")).collect();
    for (place, name) in names.iter().enumerate() {
        scene += &format!("rotate([0, {name}, 0]) translate([{}, 0, 0]) sphere({name});\n", 20 * place);
    }
    let example = Example::of("words.csg", &scene);
    validated_by_naga("WGSL", &example.text(Target::Program(Language::Wgsl)));
    let glsl = [
        (example.text(Target::Program(Language::GlslEs300)), Stage::Fragment),
        (example.text(Target::Program(Language::Hlsl)), Stage::HlslPixel),
        (example.text(Target::Program(Language::Glsl450)), Stage::Vulkan),
        (example.text(Target::Package(Package::GlslViewer)), Stage::Fragment),
    ];
    for (text, stage) in glsl {
        compiled_by_glslang("words", &text, stage);
    }
}
