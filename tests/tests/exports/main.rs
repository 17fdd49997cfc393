//! Exported shader code of every example in every language, as other people's compilers see it: glslang for GLSL and HLSL,
//! spirv-val for SPIR-V, naga for WGSL. And the numbers it comes to, on the graphics adapter, beside those of the CPU.

mod engines;
mod godot;
mod support;

use chiaro_compiler::export::{Language, Package, Target};
use chiaro_compiler::field::Evaluator;
use chiaro_compiler::vocabulary::Bounds;
use chiaro_tests::sampling::Random;
use support::{Example, Stage, compiled_by_glslang, distances_on_gpu, examples, validated, validated_by_naga};

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
        let image = example.text(Target::Package(Package::Shadertoy));
        let page = "#version 300 es\nprecision highp float;\nprecision highp int;\nuniform vec3 iResolution;\n\
                    uniform float iTime;\nuniform vec4 iMouse;\nout vec4 pixel;\n";
        let main = "\nvoid main() { mainImage(pixel, gl_FragCoord.xy); }\n";
        compiled_by_glslang(&example.name, &format!("{page}{image}{main}"), Stage::Fragment);
    }
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
        let root = &example.graph.facts[example.graph.root.0 as usize];
        let bounds = chiaro_tests::sampling::sample_box(&root.bounds);
        let points = random_points(&bounds, 10_000);
        let evaluator = Evaluator::new(&example.graph, &example.values);
        let expected: Vec<f64> = points.iter().map(|point| evaluator.distance(point.map(f64::from))).collect();
        let allowed = RELATIVE * bounds.diagonal() * root.lipschitz.max(1.0);
        let differences = [Language::Glsl450, Language::Hlsl].map(|language| {
            let found = distances_on_gpu(&example, language, &points);
            let difference = |(found, expected): (&f32, &f64)| (f64::from(*found) - expected).abs();
            found.iter().zip(&expected).map(difference).fold(0.0, f64::max)
        });
        table += &format!("{}, {:.2e}, {:.2e}, of {allowed:.2e}\n", example.name, differences[0], differences[1]);
        assert!(differences.iter().all(|difference| *difference <= allowed), "{table}");
    }
    std::fs::write(concat!(env!("CARGO_TARGET_TMPDIR"), "/distances.csv"), table).unwrap();
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
