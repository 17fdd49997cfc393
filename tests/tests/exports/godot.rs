//! Godot's shaders as GLSL, which glslang compiles, and the rules that GLSL doesn't have.

use std::collections::HashSet;

use chiaro_compiler::export::{Package, Target};

use super::support::{Example, Stage, compiled_by_glslang, examples, preprocessed_by_glslang, text_at};

#[test]
fn godots_shaders_compile() {
    for example in examples() {
        for (package, ending) in [(Package::Godot4, "gdshader"), (Package::Godot3, "shader")] {
            let files = example.export(Target::Package(package)).unwrap();
            for kind in ["solid", "picture"] {
                let shader = text_at(&files, &format!("_{kind}.{ending}"));
                assert_eq!(hidden_names(&shader), Vec::<String>::new(), "{}", example.name);
                if package == Package::Godot3 {
                    // It has neither structs nor spaces between the signs of what it writes.
                    assert!(!shader.contains("\nstruct ") && !shader.contains(" - -"), "{}", example.name);
                }
                // The pass itself is that of GLSL programs, which all examples are compiled as.
                if kind == "solid" || example.name == "mug" {
                    for renderer in [None, Some("RENDERER_COMPATIBILITY"), Some("RENDERER_FORWARD_PLUS")] {
                        compiled_by_glslang(&example.name, &as_glsl(&shader, renderer), Stage::Fragment);
                    }
                }
            }
        }
    }
}

#[test]
fn nothing_hides_a_live_number() {
    // Functions of the picture have variables that are called so.
    let example = Example::of("knobs.csg", "k = 6; // [0.5:12]\nhit = 2; // [1:3]\nsphere(k); cube(hit);");
    for (package, ending) in [(Package::Godot4, "gdshader"), (Package::Godot3, "shader")] {
        let files = example.export(Target::Package(package)).unwrap();
        assert_eq!(hidden_names(&text_at(&files, &format!("_picture.{ending}"))), Vec::<String>::new());
    }
}

/// A scene that is copied into a folder of a project finds what is beside it: what it names is relative to it.
#[test]
fn scenes_name_files_beside_them() {
    let example = Example::of("ball.csg", "r = 10; // [5:20]\nsphere(r);");
    for package in [Package::Godot4, Package::Godot3] {
        let files = example.export(Target::Package(package)).unwrap();
        for kind in ["solid", "picture"] {
            let scene = text_at(&files, &format!("_{kind}.tscn"));
            let mut resources = scene.lines().filter(|line| line.starts_with("[ext_resource"));
            let named = |line: &str| line.split_once(" path=\"")?.1.split_once('"').map(|(path, _)| path.to_owned());
            assert!(resources.all(|line| named(line).is_some_and(|path| files.iter().any(|file| file.path == path))));
            assert!(!scene.contains("res://") && scene.contains("[ext_resource"), "{scene}");
        }
    }
}

#[test]
fn vertices_move_where_godot_looks_shadows_up_at_what_they_span() {
    let files = Example::of("ball.csg", "sphere(10);").export(Target::Package(Package::Godot4)).unwrap();
    let shader = text_at(&files, "_solid.gdshader");
    let moves = |renderer| preprocessed_by_glslang(&as_glsl(&shader, renderer)).contains("scene_approach(ray_start");
    assert!(moves(None));
    assert!(moves(Some("RENDERER_COMPATIBILITY")));
    assert!(!moves(Some("RENDERER_FORWARD_PLUS")));
}

#[test]
fn hidden_names_are_found() {
    let shader = "uniform float k : hint_range(0, 1) = 0.5;\nfloat sky(float x) {\n    return x;\n}\n\
                  void f(vec3 p) {\n    for (int i = 0; i < 3; i++) {\n        \
                  float sky = 1.0; // vec3 p\n        float k = 1.0;\n    }\n    for (int i = 0; i < 3; i++) {\n        vec3 p = p;\n    }\n}\n";
    assert_eq!(hidden_names(shader), ["sky", "k", "p"]);
}

/// The version whose types are as strict as Godot's: no number becomes another kind by itself.
const HEAD: &str = "#version 310 es\nprecision highp float;\nprecision highp int;\n";

/// The built-in variables that our shaders use, of both versions.
const BUILT_IN: &str = "\
    const float TIME = 0.0;\nconst bool OUTPUT_IS_SRGB = false;\nconst vec4 FRAGCOORD = vec4(0.5);\n\
    const vec2 SCREEN_UV = vec2(0.5), VIEWPORT_SIZE = vec2(320.0, 240.0);\n\
    const mat4 MODELVIEW_MATRIX = mat4(1.0), PROJECTION_MATRIX = mat4(1.0), INV_PROJECTION_MATRIX = mat4(1.0);\n\
    const mat4 VIEW_MATRIX = mat4(1.0), MODEL_MATRIX = mat4(1.0), WORLD_MATRIX = mat4(1.0), INV_CAMERA_MATRIX = mat4(1.0);\n\
    vec3 VERTEX, LIGHT_VERTEX, NORMAL, ALBEDO, EMISSION;\nvec4 POSITION;\nfloat ROUGHNESS, METALLIC, DEPTH;\n\
    layout(location = 0) out vec4 pixel;\n";

/// What Godot defines from version 4.4 on.
const RENDERERS: &str =
    "#define RENDERER_COMPATIBILITY 0\n#define RENDERER_MOBILE 1\n#define RENDERER_FORWARD_PLUS 2\n";

/// Calls both entry points, and uses what they write.
const MAIN: &str = "\nvoid main() {\n    vertex();\n    fragment();\n    \
    pixel = vec4(VERTEX + LIGHT_VERTEX + NORMAL + ALBEDO + EMISSION, ROUGHNESS + METALLIC + DEPTH) + POSITION;\n}\n";

/// A shader as a fragment shader in GLSL, with live numbers as constants, for a renderer; without one, before Godot 4.4.
fn as_glsl(shader: &str, renderer: Option<&str>) -> String {
    let renderer =
        renderer.map(|renderer| format!("{RENDERERS}#define CURRENT_RENDERER {renderer}\n")).unwrap_or_default();
    let body: String = shader.lines().map(|line| glsl_line(line) + "\n").collect();
    [HEAD, &renderer, BUILT_IN, &body, MAIN].concat()
}

fn glsl_line(line: &str) -> String {
    if line.starts_with("shader_type ") || line.starts_with("render_mode ") {
        return String::new();
    }
    if let Some((declared, default)) = line.strip_prefix("uniform ").and_then(|rest| rest.split_once(" = ")) {
        let name = declared.split(" : ").next().unwrap_or(declared);
        return format!("const {name} = {default}");
    }
    line.strip_prefix("varying ").unwrap_or(line).to_owned()
}

/// The variables whose names something else has that is visible there, which Godot refuses.
fn hidden_names(shader: &str) -> Vec<String> {
    let tokens = tokens(shader);
    let mut types: HashSet<&str> = TYPES.into_iter().collect();
    types.extend(tokens.windows(2).filter(|pair| pair[0] == "struct").map(|pair| pair[1]));
    let mut scopes: Vec<HashSet<&str>> = vec![HashSet::new()];
    // Parameters and a loop's variable are in the block that follows.
    let mut is_open = false;
    let mut in_struct = false;
    let mut hidden = Vec::new();
    for window in tokens.windows(3) {
        let [first, name, behind] = [window[0], window[1], window[2]];
        match first {
            "struct" => in_struct = true,
            "}" if in_struct => in_struct = false,
            "{" if in_struct => {}
            "{" if is_open => is_open = false,
            "{" => scopes.push(HashSet::new()),
            "}" => drop(scopes.pop()),
            "for" => {
                scopes.push(HashSet::new());
                is_open = true;
            }
            _ if in_struct || !types.contains(first) || !["=", ";", ",", ")", "[", "(", ":"].contains(&behind) => {}
            _ if !name.starts_with(|c: char| c.is_ascii_alphabetic()) => {}
            _ => {
                let is_function = behind == "(" && scopes.len() == 1;
                if scopes.iter().any(|scope| scope.contains(name)) {
                    hidden.push(name.to_owned());
                }
                if let Some(scope) = scopes.last_mut() {
                    scope.insert(name);
                }
                if is_function {
                    scopes.push(HashSet::new());
                    is_open = true;
                }
            }
        }
    }
    hidden
}

const TYPES: [&str; 20] = [
    "bool", "bvec2", "bvec3", "bvec4", "int", "ivec2", "ivec3", "ivec4", "uint", "uvec2", "uvec3", "uvec4", "float",
    "vec2", "vec3", "vec4", "mat2", "mat3", "mat4", "void",
];

/// Words and signs, without comments.
fn tokens(text: &str) -> Vec<&str> {
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let mut tokens = Vec::new();
    for line in text.lines() {
        let mut rest = line.split_once("//").map_or(line, |(code, _)| code).trim_start();
        while let Some(first) = rest.chars().next() {
            let length =
                if is_part(first) { rest.find(|c| !is_part(c)).unwrap_or(rest.len()) } else { first.len_utf8() };
            tokens.push(&rest[..length]);
            rest = rest[length..].trim_start();
        }
    }
    tokens
}
