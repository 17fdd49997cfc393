//! Expectations written as comments into the scenes they are about.
//!
//! * `// Error: 5-9 message` (or `Warning`, `Note`) stands above the line it is about; the columns are counted from 1
//!   and the second is behind the last character. A diagnostic that ends on a later line has `5-`, and one without a
//!   place stands at the top as `// Error: message`. `// Label:`, `// See: ‹text› message` and `// Hint:` lines
//!   follow it: what the place itself shows, other places that explain it, and how to mend it.
//! * `// Distance: [x, y, z] = value` is the signed distance there; ` with name = value, …` behind it moves live
//!   parameters first.
//! * `// Field: class, L = 1, bounds [x, y, z] .. [x, y, z]` are the facts about the whole scene, or `// Field: nothing`
//!   if it is empty. Every scene that compiles has this line, so that no change makes fields looser unnoticed.
//! * `// Parameters: name = default [least to greatest], …` are the live parameters.
//! * `// Solid:` is followed by the solid tree, each line behind `// | `.
//! * `// Lights:` is followed by the lights in the same way, and `// Camera:` by what the scene says of its view.
//!
//! Every diagnostic and the field's facts have to be expected. The rest is checked where it is written. A scene with an
//! error has no facts, and none may be expected of it.
//!
//! Two kinds of lines are orders, not expectations: `// File: name.scad` begins another file, which the scene can use
//! or include, and `// Facets: exact` (or `smooth`) sets the option.

use std::fmt::Write;

use chiaro_compiler::field::Evaluator;
use chiaro_compiler::solid;
use chiaro_compiler::syntax::{Diagnostic, Severity, Span};
use chiaro_compiler::{Compilation, Facets, Options, Scene, compile};

use crate::MemoryWorld;

/// How far a number may be from the one that is written with a few digits.
const TOLERANCE: f64 = 1e-4;

/// The same as a part of the number, for great ones, which are written with all digits.
const RELATIVE: f64 = 1e-9;

/// Numbers from here on are written with an exponent.
const GREAT: f64 = 1e9;

/// The most characters of a text that are quoted.
const LONGEST_QUOTE: usize = 40;

/// What the facts about the whole scene are written as.
const FIELD: &str = "// Field: ";

/// What diagnostics are written as.
const DIAGNOSTICS: [&str; 6] = ["// Error:", "// Warning:", "// Note:", "// Label:", "// See:", "// Hint:"];

/// What a scene's text comes to, with its orders and other files.
pub fn compiled(name: &str, text: &str) -> Compilation {
    compiled_sections(name, text, &sections(name, text))
}

fn compiled_sections(name: &str, text: &str, sections: &[Section]) -> Compilation {
    let mut world = MemoryWorld::default();
    for section in sections {
        // Diagnostics are comments and lines of their own: without them, spans are those of the bare text.
        world = world.with(section.name, section.lines.join("\n"));
    }
    compile(&world, name, &Options { facets: facets(text), ..Options::default() })
}

/// The text with its expectations replaced by what comes out. It is unchanged if all of them hold.
pub fn actual(name: &str, text: &str) -> String {
    let sections = sections(name, text);
    let compilation = compiled_sections(name, text, &sections);
    let mut found = Annotations::of(&compilation, &sections);
    let evaluator = compilation.scene.as_ref().map(|scene| (scene, Evaluator::new(&scene.graph, &scene.defaults())));

    let mut out = String::new();
    for (number, section) in sections.iter().enumerate() {
        out.extend(section.heading.map(|heading| format!("{heading}\n")));
        for (index, line) in section.lines.iter().enumerate() {
            out.push_str(&found.take(number, index));
            match &evaluator {
                Some((scene, evaluator)) => {
                    out += &checked(scene, evaluator, line).unwrap_or_else(|| (*line).to_owned())
                }
                None if is_fact(line) => continue,
                None => out.push_str(line),
            }
            out.push('\n');
        }
        if let Some((scene, _)) = &evaluator
            && number == 0
            && !section.lines.iter().any(|line| line.starts_with(FIELD))
        {
            out += &(describe_field(scene) + "\n");
        }
        out.push_str(&found.take(number, section.lines.len()));
    }
    out
}

/// Whether a line is an expectation that only a scene can meet.
fn is_fact(line: &str) -> bool {
    let starts = [FIELD, "// Distance: ", "// Parameters:"];
    starts.iter().any(|start| line.starts_with(start)) || ["// Solid:", "// Lights:", "// Camera:"].contains(&line)
}

/// One of the files that a scene's text consists of, without the expectations of diagnostics.
struct Section<'a> {
    name: &'a str,
    /// The line that begins it, except of the first.
    heading: Option<&'a str>,
    lines: Vec<&'a str>,
}

fn sections<'a>(name: &'a str, text: &'a str) -> Vec<Section<'a>> {
    let mut sections = vec![Section { name, heading: None, lines: Vec::new() }];
    for line in text.lines() {
        if let Some(name) = line.strip_prefix("// File: ") {
            sections.push(Section { name, heading: Some(line), lines: Vec::new() });
        } else if !DIAGNOSTICS.iter().any(|start| line.starts_with(start))
            && !line.starts_with("// | ")
            && let Some(section) = sections.last_mut()
        {
            section.lines.push(line);
        }
    }
    sections
}

fn facets(text: &str) -> Facets {
    let order = text.lines().find_map(|line| line.strip_prefix("// Facets: "));
    match order {
        Some("exact") => Facets::Exact,
        Some("smooth") => Facets::Smooth,
        _ => Facets::Auto,
    }
}

/// The expectations of diagnostics, for each section and line of it, counted from 0.
struct Annotations(Vec<Vec<String>>);

impl Annotations {
    fn of(compilation: &Compilation, sections: &[Section]) -> Self {
        let empty = |section: &Section| vec![String::new(); section.lines.len() + 1];
        let mut annotations = Self(sections.iter().map(empty).collect());
        for diagnostic in &compilation.diagnostics {
            annotations.add(compilation, sections, diagnostic);
        }
        annotations
    }

    fn add(&mut self, compilation: &Compilation, sections: &[Section], diagnostic: &Diagnostic) {
        let place = diagnostic.span.and_then(|span| {
            let file = compilation.sources.get(span.file);
            let section = sections.iter().position(|section| section.name == file.name)?;
            Some((section, file.line_column(span.start), file.line_column(span.end)))
        });
        let text = annotation(compilation, diagnostic, place.map(|(_, start, end)| (start, end)));
        let (section, line) = place.map_or((0, 0), |(section, (line, _), _)| (section, line - 1));
        let last = self.0[section].len() - 1;
        self.0[section][line.min(last)].push_str(&text);
    }

    fn take(&mut self, section: usize, line: usize) -> String {
        std::mem::take(&mut self.0[section][line])
    }
}

/// A place's first and last line and column.
type Place = ((usize, usize), (usize, usize));

/// A diagnostic's expectation.
fn annotation(compilation: &Compilation, diagnostic: &Diagnostic, place: Option<Place>) -> String {
    let severity = match diagnostic.severity {
        Severity::Error => "Error",
        Severity::Warning => "Warning",
        Severity::Note => "Note",
    };
    let place = match place {
        None => String::new(),
        Some(((first, start), (last, end))) if first == last => format!("{start}-{end} "),
        Some(((_, start), _)) => format!("{start}- "),
    };
    let mut text = format!("// {severity}: {place}{}\n", in_one_line(&diagnostic.message));
    if let Some(label) = &diagnostic.label {
        let _ = writeln!(text, "// Label: {}", in_one_line(label));
    }
    for related in &diagnostic.related {
        let quote = quote(compilation, related.span);
        let _ = writeln!(text, "// See: ‹{quote}› {}", in_one_line(&related.message));
    }
    for hint in &diagnostic.hints {
        let _ = writeln!(text, "// Hint: {}", in_one_line(hint));
    }
    text
}

fn in_one_line(text: &str) -> String {
    text.replace('\n', " ⏎ ")
}

/// The text at a place, or the beginning of it.
fn quote(compilation: &Compilation, span: Span) -> String {
    let text = in_one_line(compilation.sources.text(span));
    let begin: String = text.chars().take(LONGEST_QUOTE).collect();
    if begin.len() < text.len() { begin + "…" } else { begin }
}

/// The line as it should be, if it is an expectation about a scene.
fn checked(scene: &Scene, evaluator: &Evaluator, line: &str) -> Option<String> {
    if let Some(rest) = line.strip_prefix("// Distance: ") {
        return Some(checked_distance(scene, evaluator, line, rest));
    }
    if line.starts_with(FIELD) {
        let actual = describe_field(scene);
        return Some(if is_same(line, &actual) { line.to_owned() } else { actual });
    }
    if line.starts_with("// Parameters:") {
        return Some(describe_parameters(scene));
    }
    let (heading, text) = match line {
        "// Solid:" => (line, solid::print(&scene.solid)),
        "// Lights:" => (line, solid::print_lights(&scene.lights)),
        "// Camera:" => (line, solid::print_camera(&scene.camera)),
        _ => return None,
    };
    Some(text.lines().fold(heading.to_owned(), |text, line| format!("{text}\n// | {line}")))
}

fn checked_distance(scene: &Scene, evaluator: &Evaluator, line: &str, rest: &str) -> String {
    let (rest, moved) = rest.split_once(" with ").unwrap_or((rest, ""));
    let (point, written) = rest.split_once(" = ").unwrap_or((rest, ""));
    let coordinates = numbers(point);
    let at = std::array::from_fn(|axis| coordinates.get(axis).copied().unwrap_or(0.0));
    let distance = match moved {
        "" => evaluator.distance(at),
        moved => Evaluator::new(&scene.graph, &with_moved(scene, moved)).distance(at),
    };
    if written.trim().parse().is_ok_and(|written: f64| is_close(written, distance)) {
        return line.to_owned();
    }
    let with = if moved.is_empty() { String::new() } else { format!(" with {moved}") };
    format!("// Distance: {point} = {}{with}", rounded(distance))
}

/// The live parameters' values, of which those in `moves` are others than the default.
fn with_moved(scene: &Scene, moves: &str) -> Vec<f64> {
    let mut values = scene.defaults();
    for (name, value) in moves.split(',').filter_map(|setting| setting.split_once('=')) {
        let index = scene.parameters.iter().position(|parameter| full_name(parameter) == name.trim());
        let (Some(index), Ok(value)) = (index, value.trim().parse()) else { return vec![f64::NAN; values.len()] };
        values[index] = value;
    }
    values
}

fn is_close(a: f64, b: f64) -> bool {
    a == b || (a - b).abs() <= TOLERANCE.max(RELATIVE * a.abs())
}

/// Whether two lines have the same words, numbers taken as the same if they are close.
fn is_same(a: &str, b: &str) -> bool {
    let words = |line: &str| -> Vec<String> {
        line.split([' ', ',', '[', ']']).filter(|word| !word.is_empty()).map(str::to_owned).collect()
    };
    let is_same_word = |(a, b): (&String, &String)| match (a.parse(), b.parse()) {
        (Ok(a), Ok(b)) => is_close(a, b),
        _ => a == b,
    };
    let (a, b) = (words(a), words(b));
    a.len() == b.len() && a.iter().zip(&b).all(is_same_word)
}

fn describe_field(scene: &Scene) -> String {
    let facts = scene.graph.facts[scene.graph.root.0 as usize];
    if facts.bounds.is_empty() {
        return format!("{FIELD}nothing");
    }
    let corner = |point: [f64; 3]| point.map(rounded).join(", ");
    let (min, max) = (corner(facts.bounds.min), corner(facts.bounds.max));
    format!("{FIELD}{:?}, L = {}, bounds [{min}] .. [{max}]", facts.class, rounded(facts.lipschitz))
}

fn describe_parameters(scene: &Scene) -> String {
    let describe = |parameter: &solid::LiveParameter| {
        let (min, max) = (rounded(parameter.range.min), rounded(parameter.range.max));
        format!("{} = {} [{min} to {max}]", full_name(parameter), rounded(parameter.default))
    };
    let all: Vec<String> = scene.parameters.iter().map(describe).collect();
    if all.is_empty() { "// Parameters: none".to_owned() } else { format!("// Parameters: {}", all.join(", ")) }
}

/// A live parameter's name, with its index if it is one of a list.
fn full_name(parameter: &solid::LiveParameter) -> String {
    let index = parameter.component.map_or(String::new(), |index| format!("[{index}]"));
    format!("{}{index}", parameter.name)
}

fn numbers(text: &str) -> Vec<f64> {
    text.trim_matches(['[', ']', ' ']).split(',').filter_map(|number| number.trim().parse().ok()).collect()
}

/// With four decimals at most, or all digits and an exponent.
fn rounded(value: f64) -> String {
    if value.is_finite() && value.abs() >= GREAT {
        return format!("{value:e}");
    }
    let text = format!("{}", (value * 1e4).round() / 1e4);
    if text == "-0" { "0".to_owned() } else { text }
}
