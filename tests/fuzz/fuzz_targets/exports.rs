//! Exports of random scenes, whatever their parameters are called and described as, are accepted by compilers of the
//! languages they are in: WGSL by naga, GLSL and HLSL by glslang, JavaScript by oxc.
#![no_main]

use std::io::Write;
use std::process::{Command, Stdio};

use arbitrary::Unstructured;
use chiaro_compiler::export::{File, Language, Package, Target};
use chiaro_compiler::{Options, compile};
use chiaro_tests::exported::{TARGETS, exported};
use chiaro_tests::{MemoryWorld, programs};
use libfuzzer_sys::fuzz_target;
use naga::valid::{Capabilities, ValidationFlags, Validator};
use oxc_allocator::Allocator;
use oxc_parser::Parser;
use oxc_span::SourceType;

/// A line of a description in plain text: what isn't text ends it.
fn line(bytes: &mut Unstructured) -> String {
    let text: &str = bytes.arbitrary().unwrap_or_default();
    text.chars().take(40).map(|c| if c.is_control() { ' ' } else { c }).collect()
}

/// A parameter's name: a word of some language, or anything the grammar allows.
fn name(bytes: &mut Unstructured) -> String {
    const WORDS: [&str; 12] =
        ["float", "const", "class", "half4", "fn", "live", "_", "sample", "main", "resolution", "gl_x", "__proto__"];
    match bytes.int_in_range(0..=2_u8).unwrap_or(0) {
        0 => "size".to_owned(),
        1 => WORDS[bytes.int_in_range(0..=WORDS.len() - 1).unwrap_or(0)].to_owned(),
        _ => {
            let letters: [u8; 4] = bytes.arbitrary().unwrap_or_default();
            letters.map(|letter| char::from(b"abcxyzABZ_0129"[usize::from(letter) % 14])).iter().collect()
        }
    }
}

fn check_wgsl(text: &str) {
    let module = naga::front::wgsl::parse_str(text).unwrap_or_else(|error| panic!("{}", error.emit_to_string(text)));
    let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
    validator.validate(&module).unwrap_or_else(|error| panic!("{}", error.emit_to_string(text)));
}

fn check_by_glslang(text: &str, arguments: &[&str]) {
    let child = Command::new("glslangValidator")
        .args(["--stdin", "-S", "frag"])
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn();
    let mut child = child.expect("glslang-tools is what tools/setup.sh --tests installs");
    child.stdin.take().expect("it was piped").write_all(text.as_bytes()).expect("glslang reads it");
    let output = child.wait_with_output().expect("glslang ends");
    assert!(output.status.success(), "{}\n{text}", String::from_utf8_lossy(&output.stdout));
}

fn check_javascript(text: &str, kind: SourceType) {
    let allocator = Allocator::default();
    let parsed = Parser::new(&allocator, text, kind).parse();
    assert!(parsed.diagnostics.is_empty(), "{:?}\n{text}", parsed.diagnostics);
}

/// What is between a tag that starts so and its end.
fn between<'a>(page: &'a str, tag: &str) -> &'a str {
    let (_, rest) = page.split_once(tag).expect("the page has the tag");
    rest.split_once("</script>").expect("the tag ends").0
}

fn check(target: Target, file: &File) {
    let text = || String::from_utf8(file.bytes.clone()).expect("it is text");
    match target {
        Target::Library(Language::Wgsl) | Target::Program(Language::Wgsl) => check_wgsl(&text()),
        Target::Program(Language::Glsl330 | Language::GlslEs300) => check_by_glslang(&text(), &[]),
        Target::Program(Language::Hlsl) => {
            let null = if cfg!(windows) { "NUL" } else { "/dev/null" };
            check_by_glslang(&text(), &["-D", "-V", "-e", "pixel", "--auto-map-bindings", "-o", null]);
        }
        Target::Package(Package::WebGl) => {
            let shader = between(&text(), "<script id=\"shader\" type=\"x-shader/x-fragment\">").to_owned();
            check_by_glslang(&shader, &[]);
            check_javascript(between(&text(), "<script>"), SourceType::script());
        }
        Target::Package(Package::WebGpu) => {
            check_wgsl(between(&text(), "<script id=\"shader\" type=\"x-shader/x-wgsl\">"));
            check_javascript(between(&text(), "<script>"), SourceType::script());
        }
        Target::Package(Package::Three) if file.path.ends_with(".js") => check_javascript(&text(), SourceType::mjs()),
        _ => {}
    }
}

fuzz_target!(|bytes: &[u8]| {
    let mut bytes = Unstructured::new(bytes);
    let target = TARGETS[bytes.int_in_range(0..=TARGETS.len() - 1).unwrap_or(0)];
    let (name, about, title) = (name(&mut bytes), line(&mut bytes), line(&mut bytes));
    let program = programs::scene(&mut bytes);
    let text = format!("// {about}\n{name} = 3; // [1:9]\ntranslate([{name}, 0, 0]) sphere({name});\n{program}");
    let compilation = compile(&MemoryWorld::of("fuzz.scad", &*text), "fuzz.scad", &Options::default());
    let Some(scene) = compilation.scene else { return };
    let files = exported(&title, &scene.picture(), &scene.parameters, &compilation.sources, target)
        .unwrap_or_else(|error| panic!("{target:?}: {}\n{text}", error.message));
    for file in &files {
        check(target, file);
    }
});
