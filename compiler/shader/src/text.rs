//! A scene as readable WGSL: the vocabulary's own text, with its comments, above the scene's functions.

mod loops;
mod spelling;

use std::fmt::Write;

use chiaro_field::{AllSeries, Graph};
use chiaro_syntax::{Diagnostic, Span};
use naga::back::wgsl::{WriterFlags, write_string};
use naga::valid::{Capabilities, ValidationFlags, Validator};
use naga::{AddressSpace, ArraySize, Function, Handle, Module, TypeInner};
use rustc_hash::{FxHashMap, FxHashSet};

use crate::emit::{Emitted, OwnFunction, emit, emit_to_read};
use crate::tables::Tables;
use crate::template::{SCENE, Template};

/// A text, with what its lines stand for.
#[derive(Clone, Debug, Default)]
pub struct Listing {
    /// The text.
    pub text: String,
    /// The lines, counted from 0, that make the distance of a shape or operator, with the expression it is in the scene's text.
    pub lines: Vec<(usize, Span)>,
}

/// A scene's functions as text, in parts.
#[derive(Clone, Debug, Default)]
pub struct Library {
    /// The constants, types and functions of the vocabulary that the scene's functions mention or call, with their comments.
    pub vocabulary: String,
    /// The scene's own functions, the last two of which are `scene_distance` and `scene_surface`. They read live number i
    /// as component i mod 4 of `live[i / 4]`, and row i of the tables as `tables[i]`.
    pub functions: String,
    /// What the lines of `functions` stand for, as those of a [`Listing`].
    pub lines: Vec<(usize, Span)>,
    /// The rows of the tables; none, if the functions read none.
    pub tables: Tables,
}

/// What values that come from an expression are to be called, for readers to recognise them: a word in snake case that
/// doesn't start with a digit.
pub type Names<'a> = &'a dyn Fn(Span) -> Option<String>;

/// The scene as a WGSL library of `scene_distance` and `scene_surface`, with what they call and nothing else.
///
/// Where it declares `live` or `tables`, the bindings are those of [`bindings`](crate::bindings).
pub fn wgsl(graph: &Graph) -> Result<String, Diagnostic> {
    Ok(listing(graph)?.text)
}

/// The same, with what its lines stand for.
pub fn listing(graph: &Graph) -> Result<Listing, Diagnostic> {
    let emitted = emit(graph, Template::Library.parsed())?;
    let Library { vocabulary, functions, lines, .. } = library_of(&emitted, "")?;
    let above = vocabulary + &variables(&emitted.module);
    let first = above.lines().count();
    let lines = lines.into_iter().map(|(line, span)| (first + line, span)).collect();
    Ok(Listing { lines, text: above + functions.trim_end() + "\n" })
}

/// The same in parts, with values called by these names, for a text that mentions functions and constants of the vocabulary.
pub fn library(graph: &Graph, names: Names, caller: &str) -> Result<Library, Diagnostic> {
    let series = AllSeries::of(graph);
    let mut emitted = emit_to_read(graph, &series, Template::Library.parsed(), names)?;
    let tables = std::mem::take(&mut emitted.tables);
    Ok(Library { tables, ..library_of(&emitted, caller)? })
}

fn library_of(emitted: &Emitted, caller: &str) -> Result<Library, Diagnostic> {
    let functions = own_text(emitted)?;
    let called = called(emitted, &functions, caller);
    let vocabulary = called.iter().map(|declaration| format!("{}\n", declaration.text)).collect();
    let spans =
        functions.lines().enumerate().filter_map(|(line, text)| Some((line, *emitted.names.get(named(text)?)?)));
    Ok(Library { lines: spans.collect(), vocabulary, functions, tables: Tables::default() })
}

/// The name of the value that a line makes.
fn named(line: &str) -> Option<&str> {
    line.trim_start().strip_prefix("let ")?.split_once(" = ").map(|(name, _)| name)
}

/// A declaration of a WGSL text, with the comment above it.
struct Declaration {
    is_function: bool,
    name: &'static str,
    text: &'static str,
}

/// The declarations of the vocabulary and of `scene.wgsl` that the scene and a pass below it reach, in their order.
fn called(emitted: &Emitted, own: &str, pass: &str) -> Vec<Declaration> {
    let own_functions: FxHashSet<Handle<Function>> = emitted.functions.iter().map(|own| own.handle).collect();
    let functions: FxHashSet<&str> = (emitted.module.functions.iter())
        .filter(|(handle, _)| !own_functions.contains(handle))
        .filter_map(|(_, function)| function.name.as_deref())
        .collect();
    let mut mentioned: FxHashSet<&str> = words(own).chain(words(pass)).collect();
    let mut called = Vec::new();
    // Constants and types stand above those who mention them.
    let all: Vec<Declaration> = declarations(chiaro_vocabulary::source()).chain(declarations(SCENE)).collect();
    for declaration in all.into_iter().rev() {
        let names = if declaration.is_function { &functions } else { &mentioned };
        if names.contains(declaration.name) {
            mentioned.extend(words(declaration.text));
            called.push(declaration);
        }
    }
    called.reverse();
    called
}

/// The declarations of a text whose top-level declarations, and nothing else, start with a keyword in the first
/// column.
fn declarations(text: &'static str) -> impl Iterator<Item = Declaration> {
    let (mut start, mut end) = (0, 0);
    let mut open: Option<(&str, &str)> = None;
    text.split_inclusive('\n').filter_map(move |line| {
        end += line.len();
        if let Some((keyword @ ("fn" | "const" | "struct"), rest)) = line.split_once(' ') {
            open = words(rest).next().map(|name| (keyword, name));
        }
        let Some((keyword, name)) = open else {
            // A blank line parts a comment from what follows.
            start = if line.trim().is_empty() { end } else { start };
            return None;
        };
        let closes = line.starts_with('}') || keyword == "const";
        if !closes {
            return None;
        }
        open = None;
        let declaration = Declaration { is_function: keyword == "fn", name, text: &text[start..end] };
        start = end;
        Some(declaration)
    })
}

/// The identifiers, and numbers, of a text.
fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').filter(|word| !word.is_empty())
}

/// The declarations of `live` and `tables`, if there are any.
fn variables(module: &Module) -> String {
    let mut text = String::new();
    for (_, variable) in module.global_variables.iter() {
        let (Some(name), Some(binding)) = (&variable.name, variable.binding) else { continue };
        let space = match variable.space {
            AddressSpace::Uniform => "uniform",
            _ => "storage",
        };
        let length = match module.types[variable.ty].inner {
            TypeInner::Array { size: ArraySize::Constant(length), .. } => format!(", {length}"),
            _ => String::new(),
        };
        let (group, binding) = (binding.group, binding.binding);
        // Writing to a string can't fail.
        let _ = writeln!(text, "@group({group}) @binding({binding}) var<{space}> {name}: array<vec4<f32>{length}>;\n");
    }
    text
}

/// The text of the functions that stand for the graph.
fn own_text(emitted: &Emitted) -> Result<String, Diagnostic> {
    let written = written(&emitted.module)
        .map_err(|error| Diagnostic::error(None, format!("this scene makes invalid WGSL: {error}")))?;
    let texts = function_texts(&written);
    let mut text = String::new();
    for OwnFunction { handle, comment } in &emitted.functions {
        let function = &emitted.module.functions[*handle];
        let Some(own) = function.name.as_deref().and_then(|name| texts.get(name)) else { continue };
        text += if comment.is_empty() { stub_comment(function) } else { comment };
        text += &spelling::tidied(&loops::as_written(&unwrapped(&renamed(own, function))));
        text += "\n";
    }
    Ok(text)
}

/// The module as naga writes it.
fn written(module: &Module) -> Result<String, String> {
    let info = Validator::new(ValidationFlags::all(), Capabilities::default())
        .validate(module)
        .map_err(|error| error.into_inner().to_string())?;
    write_string(module, &info, WriterFlags::empty()).map_err(|error| error.to_string())
}

/// The text of each function by its name. Functions start and end in the first column, and nothing in them does.
fn function_texts(written: &str) -> FxHashMap<&str, &str> {
    let starts = written.match_indices("\nfn ").map(|(at, _)| at + 1);
    let texts = starts.filter_map(|start| {
        let text = &written[start..];
        let name = words(text).nth(1)?;
        let end = text.find("\n}\n")? + "\n}\n".len();
        Some((name, &text[..end]))
    });
    texts.collect()
}

/// What `scene.wgsl` says about the function.
fn stub_comment(function: &Function) -> &'static str {
    let stub = declarations(SCENE).find(|stub| Some(stub.name) == function.name.as_deref());
    stub.and_then(|stub| stub.text.split_once("fn ")).map_or("", |(comment, _)| comment)
}

/// The text with every value by its own name. naga writes `_e7` for the result of a call that is expression 7, and
/// `p_3` for a name that three functions before have used; no name of ours ends in a digit.
fn renamed(text: &str, function: &Function) -> String {
    let by_index: FxHashMap<usize, &str> =
        function.named_expressions.iter().map(|(handle, name)| (handle.index(), name.as_str())).collect();
    let locals = function.local_variables.iter().filter_map(|(_, local)| local.name.as_deref());
    let arguments = function.arguments.iter().filter_map(|argument| argument.name.as_deref());
    let own: FxHashSet<&str> = by_index.values().copied().chain(locals).chain(arguments).collect();
    let name = |word: &str| -> Option<&str> {
        let (base, number) = word.rsplit_once('_')?;
        match number.strip_prefix('e') {
            Some(index) if base.is_empty() => by_index.get(&index.parse().ok()?).copied(),
            _ => own.get(base).copied().filter(|_| number.bytes().all(|byte| byte.is_ascii_digit())),
        }
    };
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let mut result = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(start) = rest.find(is_part) {
        let end = rest[start..].find(|c| !is_part(c)).map_or(rest.len(), |length| start + length);
        let word = &rest[start..end];
        result += &rest[..start];
        result += name(word).unwrap_or(word);
        rest = &rest[end..];
    }
    result + rest
}

/// The text without the parentheses that naga writes around a whole value: `let a = (b + c);`.
fn unwrapped(text: &str) -> String {
    let line = |line: &str| {
        let (start, value) = line.split_once(" = (")?;
        let value = value.strip_suffix(");\n")?;
        is_balanced(value).then(|| format!("{start} = {value};\n"))
    };
    text.split_inclusive('\n').map(|text| line(text).unwrap_or_else(|| text.to_string())).collect()
}

/// Whether every closing parenthesis has its opening one before it.
fn is_balanced(text: &str) -> bool {
    let mut depth = 0_usize;
    text.chars().all(|c| match c {
        '(' => {
            depth += 1;
            true
        }
        ')' => match depth.checked_sub(1) {
            Some(less) => {
                depth = less;
                true
            }
            None => false,
        },
        _ => true,
    })
}
