//! A scene's functions in a shading language, to look at: with what their lines stand for.

use chiaro_field::Graph;
use chiaro_shader::{Listing, Names, library};
use chiaro_solid::LiveParameter;
use chiaro_syntax::{Diagnostic, Span};

use crate::source::Source;
use crate::target::Language;
use crate::translate::{Dialect, Parameters, translate};

/// What stands behind a line that stands for something, before its number. Comments go with their lines into all languages.
const MARK: &str = " // @";

/// The functions of a field with these live numbers, down to `scene_surface`. SPIR-V, which nobody reads, is listed as WGSL.
///
/// An error if the scene has outlines with more edges than constants may hold.
pub fn listing(graph: &Graph, live: &[LiveParameter], names: Names, language: Language) -> Result<Listing, Diagnostic> {
    let mut library = library(graph, names, "")?;
    let lines = std::mem::take(&mut library.lines);
    library.functions = marked(&library.functions, &lines);
    let source = Source::of(library, graph, live, "")?;
    let text = written(&source, language)?;
    Ok(unmarked(&text, &lines))
}

fn written(source: &Source, language: Language) -> Result<String, Diagnostic> {
    let wgsl = source.with_uniforms(0, 0);
    let variables = Parameters::Variables(&|name: &str| name.to_owned());
    let (dialect, parameters) = match language {
        Language::Wgsl | Language::SpirV => return Ok(wgsl),
        Language::Glsl330 | Language::Glsl450 | Language::GlslEs300 => (Dialect::Glsl, variables),
        Language::Hlsl => (Dialect::Hlsl, variables),
        Language::Metal => (Dialect::Metal, Parameters::Passed),
    };
    let text = translate(&wgsl, dialect, parameters).map_err(|error| Diagnostic::error(None, error.to_string()))?;
    let members = |before: &str| -> String {
        source.parameters.iter().map(|own| format!("{before}float {};\n", own.name)).collect()
    };
    let declared = match parameters {
        Parameters::Passed => String::new(),
        _ if source.parameters.is_empty() => String::new(),
        _ if language == Language::Glsl450 => {
            format!("layout(std140, binding = 0) uniform Parameters {{\n{}}};\n", members("    "))
        }
        Parameters::Variables(_) => members("uniform "),
    };
    Ok(if declared.is_empty() { text } else { declared + "\n" + &text })
}

/// A text whose lines have marks behind them: the numbers of what they stand for.
fn marked(text: &str, lines: &[(usize, Span)]) -> String {
    let mut marks = vec![String::new(); text.lines().count()];
    for (number, (line, _)) in lines.iter().enumerate() {
        if let Some(mark) = marks.get_mut(*line) {
            *mark += &format!("{MARK}{number}");
        }
    }
    text.lines().zip(marks).map(|(line, mark)| format!("{line}{mark}\n")).collect()
}

/// The text without marks, and what its lines stand for.
fn unmarked(text: &str, lines: &[(usize, Span)]) -> Listing {
    let mut listing = Listing::default();
    for (index, line) in text.trim_end().lines().enumerate() {
        let mut parts = line.split(MARK);
        listing.text += parts.next().unwrap_or_default();
        listing.text.push('\n');
        let numbers = parts.filter_map(|number| number.parse::<usize>().ok());
        listing.lines.extend(numbers.filter_map(|number| Some((index, lines.get(number)?.1))));
    }
    listing
}

#[cfg(test)]
mod tests {
    use chiaro_syntax::FileId;

    use super::*;

    #[test]
    fn marks_come_back_as_what_the_lines_stand_for() {
        let span = |start| Span { file: FileId(0), start, end: start + 1 };
        let lines = [(1, span(5)), (1, span(7)), (2, span(9))];
        let text = marked("a\nb // own\nc\n", &lines);
        assert_eq!(text, "a\nb // own // @0 // @1\nc // @2\n");
        let listing = unmarked(&text, &lines);
        assert_eq!((listing.text.as_str(), &listing.lines[..]), ("a\nb // own\nc\n", &lines[..]));
    }
}
