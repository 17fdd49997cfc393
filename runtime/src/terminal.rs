//! What the user sees: diagnostics with their source text or as JSON, and progress bars.

use std::fs;
use std::io::{IsTerminal, Write, stderr};
use std::path::PathBuf;

use anyhow::Result;
use chiaro_compiler::syntax::{self, Severity, SourceFile, Sources, Span};
use codespan_reporting::diagnostic::{Diagnostic, Label, LabelStyle};
use codespan_reporting::files::SimpleFiles;
use codespan_reporting::term::{self, termcolor};
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::{Value, json};

use crate::arguments::{Global, MessageFormat};
use crate::shown::{escaped, shown, shown_line, shown_place};

/// What stands for standard input and output on the command line.
pub(crate) const STANDARD: &str = "-";

/// Writes diagnostics to standard error; with `--quiet`, only the errors.
pub(crate) fn report(sources: &Sources, diagnostics: &[syntax::Diagnostic], global: &Global) -> Result<()> {
    let wanted = diagnostics.iter().filter(|diagnostic| !global.quiet || diagnostic.severity == Severity::Error);
    match global.message_format {
        MessageFormat::Human => write_human(sources, wanted),
        MessageFormat::Json => write_json(sources, wanted),
    }
}

/// Writes why the command itself failed.
pub(crate) fn fail(error: &anyhow::Error, format: MessageFormat) {
    // Standard error is the last place to complain to: if it is closed, nobody listens.
    let _ = match format {
        MessageFormat::Human => writeln!(stderr(), "error: {}", shown_line(&format!("{error:#}"))),
        MessageFormat::Json => {
            let object = json!({ "severity": "error", "message": format!("{error:#}") });
            writeln!(stderr(), "{}", escaped(&object.to_string()))
        }
    };
}

/// Writes a line to standard error for people, unless they asked for quiet.
pub(crate) fn note(global: &Global, text: &str) {
    if !global.quiet && global.message_format == MessageFormat::Human {
        let _ = writeln!(stderr(), "{}", shown_line(text));
    }
}

/// A progress bar of that many steps, if somebody is there to watch it.
pub(crate) fn progress(global: &Global, steps: u64, what: &str) -> ProgressBar {
    if global.quiet || global.message_format == MessageFormat::Json || !stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{msg} {wide_bar} {pos}/{len} {eta}")
        .unwrap_or_else(|_| ProgressStyle::default_bar());
    ProgressBar::new(steps).with_style(style).with_message(shown(what).into_owned())
}

fn write_human<'a>(sources: &Sources, diagnostics: impl Iterator<Item = &'a syntax::Diagnostic>) -> Result<()> {
    let mut files = SimpleFiles::new();
    for (_, file) in sources.iter() {
        files.add(shown_line(&file.name), shown(&file.text));
    }
    let mut writer = termcolor::StandardStream::stderr(if stderr().is_terminal() {
        termcolor::ColorChoice::Auto
    } else {
        termcolor::ColorChoice::Never
    });
    let config = term::Config::default();
    for diagnostic in diagnostics {
        term::emit_to_write_style(&mut writer, &config, &files, &rendered(sources, diagnostic))?;
    }
    Ok(())
}

/// The widest line, in bytes, that is shown whole.
const WIDEST_LINE: usize = 500;
/// How many characters are shown to each side of a place in a wider line.
const EXCERPT: usize = 40;

fn rendered(sources: &Sources, diagnostic: &syntax::Diagnostic) -> Diagnostic<usize> {
    let severity = match diagnostic.severity {
        Severity::Error => codespan_reporting::diagnostic::Severity::Error,
        Severity::Warning => codespan_reporting::diagnostic::Severity::Warning,
        Severity::Note => codespan_reporting::diagnostic::Severity::Note,
    };
    let own = diagnostic.span.map(|span| (LabelStyle::Primary, span, diagnostic.label.as_deref().unwrap_or("")));
    let related = diagnostic.related.iter().map(|other| (LabelStyle::Secondary, other.span, other.message.as_str()));
    let (quoted, named): (Vec<_>, Vec<_>) = own
        .into_iter()
        .chain(related)
        .partition(|(_, span, _)| may_be_quoted(sources.get(span.file)) && !is_in_wide_line(sources, *span));

    let labels = quoted.into_iter().map(|(style, span, message)| {
        let place = |at: u32| shown_place(&sources.get(span.file).text, at as usize);
        Label::new(style, span.file.0 as usize, place(span.start)..place(span.end)).with_message(shown(message))
    });
    let places = named.into_iter().map(|(_, span, message)| shown(&named_place(sources, span, message)).into_owned());
    let hints = diagnostic.hints.iter().map(|hint| format!("help: {}", shown(hint)));
    Diagnostic::new(severity)
        .with_message(shown(&diagnostic.message))
        .with_labels(labels.collect())
        .with_notes(places.chain(hints).collect())
}

/// Whether a file's text may be shown. A scene may name any file that its user may read, and messages go to logs and to servers'
/// answers: so only what is called a scene, wherever links lead, or came from standard input.
fn may_be_quoted(file: &SourceFile) -> bool {
    let is_called_scene = |path: PathBuf| SourceFile::new(path.to_string_lossy(), "").is_called_scene();
    file.name == STANDARD || file.is_called_scene() && fs::canonicalize(&file.name).map_or(true, is_called_scene)
}

/// Whether any line that the span touches is too wide to be shown.
fn is_in_wide_line(sources: &Sources, span: Span) -> bool {
    let text = &sources.get(span.file).text;
    let start = text[..span.start as usize].rfind('\n').map_or(0, |newline| newline + 1);
    let end = text[span.end as usize..].find('\n').map_or(text.len(), |newline| span.end as usize + newline);
    text[start..end].lines().any(|line| line.len() > WIDEST_LINE)
}

/// The place in words, with the text around it if that may be shown: for a line that is too wide to be shown whole.
fn named_place(sources: &Sources, span: Span, message: &str) -> String {
    let file = sources.get(span.file);
    let (line, column) = file.line_column(span.start);
    let place = format!("at {}:{line}:{column}", shown_line(&file.name));
    if !may_be_quoted(file) {
        return format!("{place}: {message}").trim_end_matches(": ").to_owned();
    }
    let (before, after) = file.text.split_at(span.start as usize);
    let before: Vec<char> = before.chars().rev().take_while(|c| *c != '\n').take(EXCERPT).collect();
    let after = after.chars().take_while(|c| *c != '\n').take(EXCERPT);
    let around: String = before.into_iter().rev().chain(after).collect();
    format!("{place}: …{around}… {message}")
}

fn write_json<'a>(sources: &Sources, diagnostics: impl Iterator<Item = &'a syntax::Diagnostic>) -> Result<()> {
    let mut writer = stderr().lock();
    for diagnostic in diagnostics {
        let related: Vec<Value> = diagnostic
            .related
            .iter()
            .map(|other| json!({ "message": other.message, "place": place(sources, other.span) }))
            .collect();
        let suggestion = diagnostic
            .suggestion
            .as_ref()
            .map(|change| json!({ "place": place(sources, change.span), "text": change.text }));
        let object = json!({
            "severity": match diagnostic.severity {
                Severity::Error => "error",
                Severity::Warning => "warning",
                Severity::Note => "note",
            },
            "message": diagnostic.message,
            "place": diagnostic.span.map(|span| place(sources, span)),
            "label": diagnostic.label,
            "related": related,
            "hints": diagnostic.hints,
            "suggestion": suggestion,
        });
        writeln!(writer, "{}", escaped(&object.to_string()))?;
    }
    Ok(())
}

/// File, bytes, and line and column counted from 1.
fn place(sources: &Sources, span: Span) -> Value {
    let file = sources.get(span.file);
    let (line, column) = file.line_column(span.start);
    let (end_line, end_column) = file.line_column(span.end);
    json!({
        "file": file.name, "start": span.start, "end": span.end,
        "line": line, "column": column, "end_line": end_line, "end_column": end_column,
    })
}
