//! What a scene says in words is nothing but words in every export: a hostile scene and a harmless one of the same shapes come to
//! the same code. And what reads the exports sees the same: parsers of JavaScript, HTML, Python, JSON, GLSL, HLSL and WGSL.

use std::path::Path;
use std::process::Command;

use chiaro_compiler::export::{File, Language, Package, Target};
use scraper::{Html, Node, Selector};

use super::support::{Example, Stage, compiled_by_glslang, validated_by_naga};

/// Texts that would do something if they got out of their comments and strings: some language ends one with each.
const HOSTILE: [&str; 36] = [
    "</script><script>globalThis.PWNED = 1</script>",
    "<!-- <script> --> ]]> <![CDATA[ <b onmouseover=PWNED>",
    "*/ globalThis.PWNED = 1; /*",
    "x\u{2028}/* /* */ globalThis.PWNED=1 // */ //",
    "x\u{2029}globalThis.PWNED = 1 //",
    "x\u{85}globalThis.PWNED = 1 //",
    "x\u{b}globalThis.PWNED = 1 //",
    "x\u{c}globalThis.PWNED = 1 //",
    "x\nglobalThis.PWNED = 1 //",
    "x\rglobalThis.PWNED = 1 //",
    "x\u{2028}pad: f32, } struct Q { a: f32, //",
    "x\npad: f32, } struct Q { a: f32, //",
    "x\n#error PWNED",
    "x\r\n#include \"/etc/passwd\"",
    "x \\\n#define sphere PWNED",
    "x\n#!/bin/sh",
    "\\",
    "why??/",
    "@group(0) @binding(0) var<uniform> live[0].x: f32; @vertex",
    "#{MATERIAL_BIND_GROUP} #import PWNED #ifdef X #endif",
    "{{ title }} {% include \"PWNED\" %} {# x #}",
    "\"; globalThis.PWNED = 1; \"",
    "'; globalThis.PWNED = 1; '",
    "`; globalThis.PWNED = 1; `",
    "${globalThis.PWNED = 1}",
    "\\`; globalThis.PWNED = 1; //\\`",
    "\"\"\"\nimport os; os.PWNED\n\"\"\"",
    "'''\nimport os; os.PWNED\n'''",
    "```\n# PWNED\n```",
    "\u{202e}\u{2066} // @0 // @1",
    "\u{0}\u{1b}]0;PWNED\u{7}\u{7f}\u{feff}",
    "\\u002a\\u002f \\u2028globalThis.PWNED = 1",
    "&lt;/script&gt;&#60;script>",
    "ENDHLSL ENDCG } } Shader \"PWNED\" { }",
    "%> <?php PWNED ?> <% PWNED %>",
    "PWNED = {0} %s %n, by default 5) float PWNED; // (",
];

/// A title that would do the same.
const HOSTILE_TITLE: &str =
    "a</title><script>globalThis.PWNED = 1</script> */ \"; '; `${PWNED}` \u{2028}PWNED \n#error\r\\ {{ name }} ??/";

/// All that scenes are exported to.
fn targets() -> Vec<Target> {
    use Language::{Glsl330, Glsl450, GlslEs300, Hlsl, Metal, SpirV, Wgsl};
    use Package::{Bevy, Blender, GlslViewer, Godot3, Godot4, Isf, Shadertoy, Three, Unity, Unreal, WebGl, WebGpu};
    let libraries = [Wgsl, Glsl330, Glsl450, GlslEs300, Hlsl, Metal].map(Target::Library);
    let programs = [Wgsl, Glsl330, Glsl450, GlslEs300, Hlsl, Metal, SpirV].map(Target::Program);
    let packages = [Shadertoy, GlslViewer, WebGl, WebGpu, Isf, Three, Godot4, Godot3, Bevy, Blender, Unity, Unreal];
    libraries.into_iter().chain(programs).chain(packages.map(Target::Package)).collect()
}

/// A scene with a live number for each hostile text.
fn scene() -> Example {
    let number = |index: usize| {
        format!("size_{index} = 5; // [1:10]\ntranslate([0, 0, {}]) sphere(size_{index});\n", 20 * index)
    };
    Example::of("words.csg", &(0..HOSTILE.len()).map(number).collect::<String>())
}

fn harmless() -> Example {
    scene().saying("words", &(0..HOSTILE.len()).map(|index| format!("How large ball {index} is")).collect::<Vec<_>>())
}

fn hostile() -> Example {
    scene().saying("words", &HOSTILE.map(str::to_owned))
}

/// What a file is written in. The export's own name stands for files without one.
fn language_of(target: Target, file: &File) -> String {
    let ending = Path::new(&file.path).extension().map(|ending| ending.to_string_lossy().into_owned());
    ending.unwrap_or_else(|| match target {
        Target::Package(Package::WebGl | Package::WebGpu) => "html".to_owned(),
        Target::Program(Language::SpirV) => "spv".to_owned(),
        _ => "shader".to_owned(),
    })
}

#[test]
fn hostile_texts_change_no_code() {
    let (harmless, hostile) = (harmless(), hostile());
    for target in targets() {
        let [expected, found] = [&harmless, &hostile].map(|example| example.export(target).unwrap());
        assert_eq!(paths(&expected), paths(&found), "{target:?}");
        for (expected, found) in expected.iter().zip(&found) {
            let place = format!("{target:?}: {}", found.path);
            let language = language_of(target, found);
            match &*language {
                // These say nothing of live numbers in words.
                "spv" | "md" | "toml" | "godot" | "tscn" => assert!(expected.bytes == found.bytes, "{place}"),
                _ => {
                    let [expected, found] =
                        [expected, found].map(|file| String::from_utf8(file.bytes.clone()).unwrap());
                    assert!(expected != found || !expected.contains("How large ball"), "{place} has the texts");
                    is_in_ordinary_lines(&found, &place);
                    for has_nested_comments in [false, true] {
                        let [expected, found] =
                            [&expected, &found].map(|text| code(text, &language, has_nested_comments));
                        assert!(expected == found, "{place}: {}", first_difference(&expected, &found));
                    }
                }
            }
        }
    }
}

fn paths(files: &[File]) -> Vec<&str> {
    files.iter().map(|file| &*file.path).collect()
}

/// Nothing that some language takes for the end of a line, or for none, where people see something else.
fn is_in_ordinary_lines(text: &str, place: &str) {
    for line in text.split('\n') {
        let odd = line.chars().find(|c| c.is_control() || ('\u{2028}'..='\u{202e}').contains(c));
        assert_eq!(odd, None, "{place}: {line:?}");
        assert!(!line.ends_with('\\') && !line.ends_with("??/"), "{place}: {line:?}");
    }
}

fn first_difference(expected: &[String], found: &[String]) -> String {
    let same = expected.iter().zip(found).take_while(|(a, b)| a == b).count();
    let around = |tokens: &[String]| tokens[same.saturating_sub(8)..tokens.len().min(same + 8)].join(" ");
    format!("expected … {} …\nfound … {} …", around(expected), around(found))
}

/// The words and signs of a text that aren't in comments. What scenes say is left out of strings.
fn code(text: &str, language: &str, has_nested_comments: bool) -> Vec<String> {
    match language {
        "html" => html(text, has_nested_comments),
        "py" => vec![python(text)],
        "js" | "ts" => Lexer { quotes: "\"'", has_literals: true, has_nested_comments }.tokens(text),
        _ => Lexer { quotes: "\"", has_literals: false, has_nested_comments }.tokens(text),
    }
}

struct Lexer {
    /// What strings are between.
    quotes: &'static str,
    /// Whether there are texts between backticks. In ours is shader code.
    has_literals: bool,
    has_nested_comments: bool,
}

impl Lexer {
    fn tokens(&self, text: &str) -> Vec<String> {
        let mut tokens = Vec::new();
        let mut rest = text.trim_start();
        while let Some(first) = rest.chars().next() {
            let length = if rest.starts_with("//") {
                // The end of a line in any language.
                rest.find(['\n', '\r', '\u{b}', '\u{c}', '\u{85}', '\u{2028}', '\u{2029}']).unwrap_or(rest.len())
            } else if rest.starts_with("/*") {
                self.block_comment(rest)
            } else if self.quotes.contains(first) {
                let length = string(rest, first);
                let says = rest[..length].contains(" by default");
                tokens.push(if says { "\"…\"".to_owned() } else { rest[..length].to_owned() });
                length
            } else if self.has_literals && first == '`' {
                let length = string(rest, first);
                let shader = Lexer { quotes: "", has_literals: false, ..*self };
                tokens.push("`".to_owned());
                tokens.extend(shader.tokens(&rest[1..length - 1]));
                tokens.push("`".to_owned());
                length
            } else {
                let is_part = |c: char| c.is_alphanumeric() || c == '_';
                let length =
                    if is_part(first) { rest.find(|c| !is_part(c)).unwrap_or(rest.len()) } else { first.len_utf8() };
                tokens.push(rest[..length].to_owned());
                length
            };
            rest = rest[length..].trim_start();
        }
        tokens
    }

    fn block_comment(&self, text: &str) -> usize {
        let mut depth = 1;
        let mut at = 2;
        while depth > 0 {
            let rest = &text[at..];
            let end = rest.find("*/").unwrap_or_else(|| panic!("a comment does not end: {text}"));
            match rest[..end].find("/*").filter(|_| self.has_nested_comments) {
                Some(start) => (depth, at) = (depth + 1, at + start + 2),
                None => (depth, at) = (depth - 1, at + end + 2),
            }
        }
        at
    }
}

/// The length of a string with its quotes.
fn string(text: &str, quote: char) -> usize {
    let mut is_escaped = false;
    let inner = text[1..].find(|c| {
        let ends = c == quote && !is_escaped;
        is_escaped = c == '\\' && !is_escaped;
        ends
    });
    inner.unwrap_or_else(|| panic!("a string does not end: {text}")) + 2
}

/// The elements of a page with their attributes, its texts, and the code of its scripts.
fn html(text: &str, has_nested_comments: bool) -> Vec<String> {
    let mut tokens = Vec::new();
    for node in Html::parse_document(text).tree.nodes() {
        match node.value() {
            Node::Element(element) => tokens.push(format!("{element:?}")),
            Node::Text(words) => {
                let script = node.parent().and_then(|parent| parent.value().as_element().cloned());
                match script.filter(|element| element.name() == "script") {
                    Some(script) if script.attr("type").is_some_and(|kind| kind.starts_with("x-shader")) => {
                        tokens.extend(code(words, "shader", has_nested_comments));
                    }
                    Some(_) => tokens.extend(code(words, "js", has_nested_comments)),
                    None => tokens.push(words.to_string()),
                }
            }
            Node::Comment(comment) => tokens.push(comment.to_string()),
            _ => {}
        }
    }
    tokens
}

/// Python's syntax tree of a text, without what a scene says in strings.
fn python(text: &str) -> String {
    const DUMP: &str = "import ast, sys\ntree = ast.parse(sys.stdin.buffer.read().decode())\n\
        for node in ast.walk(tree):\n    if isinstance(node, ast.Constant) and ' by default' in str(node.value): node.value = '…'\n\
        print(ast.dump(tree))";
    run("python3", &["-c", DUMP], text)
}

/// What a program prints for an input. Fails if it isn't installed, or ends with an error.
fn run(program: &str, arguments: &[&str], input: &str) -> String {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("input");
    std::fs::write(&file, input).unwrap();
    let output = Command::new(program)
        .args(arguments)
        .stdin(std::fs::File::open(&file).unwrap())
        .output()
        .unwrap_or_else(|error| panic!("{program}: {error}; tools/setup.sh --tests installs it"));
    assert!(output.status.success(), "{program}: {}\n{input}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// The exports of scenes whose texts, and whose title, are hostile.
fn hostile_exports(target: Target) -> Vec<File> {
    let texts = HOSTILE.map(str::to_owned);
    [hostile(), scene().saying(HOSTILE_TITLE, &texts)].iter().flat_map(|scene| scene.export(target).unwrap()).collect()
}

fn texts(files: &[File], ending: &str) -> Vec<String> {
    let wanted = files.iter().filter(|file| file.path.ends_with(ending));
    let texts: Vec<String> = wanted.map(|file| String::from_utf8(file.bytes.clone()).unwrap()).collect();
    assert!(!texts.is_empty(), "no file ends in {ending}");
    texts
}

/// Runs modules and scripts with something of every name that they import or ask for, and tells whether a text of the scene ran.
const RUN: &str = r#"
const vm = require("node:vm");
const text = require("node:fs").readFileSync(0, "utf8");
const thing = new Proxy(class {}, { get: (target, name) => name in target ? target[name] : thing, apply: () => thing });
const code = text
    .replace(/^import \{([^}]*)\} from "[^"]*";$/gm, (_, names) => `const {${names.replaceAll(" as ", ": ")}} = thing;`)
    .replace(/^import (?:\* as )?(\w+) from "[^"]*";$/gm, "const $1 = thing;")
    .replace(/^export /gm, "");
const context = vm.createContext({ thing });
new vm.Script(code);
try { vm.runInContext(code, context, { timeout: 10000 }); } catch (error) { if (error.name === "SyntaxError") throw error; }
if (vm.runInContext("'PWNED' in globalThis", context)) throw new Error("a text of the scene ran");
"#;

#[test]
fn javascript_runs_nothing_of_a_scenes_texts() {
    for text in texts(&hostile_exports(Target::Package(Package::Three)), ".js") {
        run("node", &["--input-type=module", "--check"], &text);
        run("node", &["--input-type=commonjs", "-e", RUN], &text);
    }
    for package in [Package::WebGl, Package::WebGpu] {
        for page in texts(&hostile_exports(Target::Package(package)), "") {
            let page = Html::parse_document(&page);
            let scripts: Vec<String> =
                page.select(&selector("script:not([type])")).map(|script| script.text().collect()).collect();
            assert_eq!(scripts.len(), 1);
            run("node", &["--input-type=commonjs", "-e", RUN], &scripts[0]);
        }
    }
}

#[test]
fn the_runner_notices_what_runs() {
    let runs =
        |text: &str| std::panic::catch_unwind(|| run("node", &["--input-type=commonjs", "-e", RUN], text)).is_ok();
    assert!(runs("import { A as B } from \"three\";\nexport class C extends B {}\n// x globalThis.PWNED = 1"));
    assert!(!runs("import { A } from \"three\";\n// x\u{2028}globalThis.PWNED = 1"));
}

#[test]
fn pages_have_the_elements_that_they_have() {
    let three = Target::Package(Package::Three);
    let pages = [Target::Package(Package::WebGl), Target::Package(Package::WebGpu)].map(|target| (target, ""));
    for (target, ending) in pages.into_iter().chain([(three, ".html")]) {
        for page in texts(&hostile_exports(target), ending) {
            let page = Html::parse_document(&page);
            let title: String = page.select(&selector("title")).flat_map(|title| title.text()).collect();
            assert!(!title.is_empty() && !title.contains(['<', '"']), "{title}");
            assert_eq!(page.select(&selector("script")).count(), 2, "{target:?}");
            assert_eq!(page.select(&selector("[onmouseover], b")).count(), 0);
        }
    }
}

fn selector(text: &str) -> Selector {
    Selector::parse(text).unwrap()
}

#[test]
fn python_and_json_are_read() {
    for package in [Package::Blender, Package::Unreal] {
        texts(&hostile_exports(Target::Package(package)), ".py").iter().for_each(|text| drop(python(text)));
    }
    for text in texts(&hostile_exports(Target::Package(Package::Isf)), "") {
        let head = text.strip_prefix("/*").and_then(|text| text.split_once("*/")).unwrap().0;
        let head: serde_json::Value = serde_json::from_str(head).unwrap();
        assert_eq!(head["INPUTS"].as_array().unwrap().len(), HOSTILE.len() + 3);
    }
}

#[test]
fn compilers_accept_hostile_texts() {
    for example in [hostile(), scene().saying(HOSTILE_TITLE, &HOSTILE.map(str::to_owned))] {
        for target in [Target::Library(Language::Wgsl), Target::Program(Language::Wgsl)] {
            validated_by_naga("hostile", &example.text(target));
        }
        for language in [Language::Glsl330, Language::GlslEs300] {
            compiled_by_glslang("hostile", &example.text(Target::Program(language)), Stage::Fragment);
        }
        compiled_by_glslang("hostile", &example.text(Target::Program(Language::Hlsl)), Stage::HlslPixel);
    }
}

#[test]
fn a_material_for_bevy_is_in_its_group_whatever_a_scene_says() {
    for text in texts(&hostile_exports(Target::Package(Package::Bevy)), ".wgsl") {
        if text.contains("var<uniform> parameters: Parameters;") {
            assert!(
                text.contains("\n@group(#{MATERIAL_BIND_GROUP}) @binding(0) var<uniform> parameters: Parameters;\n")
            );
        }
        assert!(!text.contains("@group(0)"));
    }
}

#[test]
fn a_line_separator_in_a_comment_hurts_nobody() {
    for c in ['\u{b}', '\u{c}', '\u{85}', '\u{2028}', '\u{2029}'] {
        let example = Example::of("pasted.csg", &format!("// How{c}wide\nwidth = 10; // [5:20]\ncube(width);"));
        for target in targets() {
            let files = example.export(target).unwrap_or_else(|error| panic!("{target:?}, {c:?}: {}", error.message));
            // SPIR-V is no text.
            let texts = files.into_iter().filter_map(|file| String::from_utf8(file.bytes).ok());
            let is_text = target != Target::Program(Language::SpirV);
            assert!(texts.filter(|_| is_text).all(|text| !text.contains(c)), "{target:?}, {c:?}");
        }
    }
}

#[test]
fn names_in_any_script_are_names_of_files() {
    for (title, expected) in [("日本", "ri_ben"), ("Größe", "grosse"), (".", "scene"), ("Винт", "vint")] {
        let example = Example::of("x.csg", "sphere(5);").saying(title, &[]);
        let files = example.export(Target::Package(Package::Blender)).unwrap();
        assert_eq!(files[0].path, format!("{expected}.py"));
    }
}
