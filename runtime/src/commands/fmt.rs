//! `chiaro fmt`: formats scenes in place, or checks that they are formatted.

use std::io::{Read, stdin};
use std::path::Path;
use std::process::ExitCode;

use anyhow::{Context, Result, anyhow};
use chiaro_assist::format;
use chiaro_compiler::syntax::{Diagnostic, Dialect, Severity, SourceFile, Sources, Span, parse};
use chiaro_files::FileWorld;

use crate::arguments::{Fmt, Global};
use crate::terminal::STANDARD;
use crate::{files, output, terminal};

pub(crate) fn run(arguments: &Fmt, global: &Global) -> Result<ExitCode> {
    let world = FileWorld::new();
    let mut all_well = true;
    for file in &arguments.files {
        let text = read(&world, file)?;
        all_well &= if arguments.check { check(file, text, global)? } else { rewrite(file, text, global)? };
    }
    Ok(if all_well { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn read(world: &FileWorld, file: &Path) -> Result<String> {
    let bytes = if file == Path::new(STANDARD) {
        let mut bytes = Vec::new();
        stdin().read_to_end(&mut bytes).context("cannot read standard input")?;
        bytes
    } else {
        world.read_file(file).map_err(|reason| anyhow!("cannot read {}: {reason}", file.display()))?
    };
    String::from_utf8(bytes).map_err(|_| anyhow!("{} is not encoded in UTF-8", file.display()))
}

/// Formats a file. One that has errors is left as it is, since what it should become is anybody's guess.
fn rewrite(file: &Path, text: String, global: &Global) -> Result<bool> {
    if !is_readable(file, &text, global)? {
        return Ok(false);
    }
    let formatted = format(&text);
    if file == Path::new(STANDARD) {
        output::text(&formatted)?;
    } else if formatted != text {
        files::write(file, formatted.as_bytes())?;
        terminal::note(global, &format!("{} formatted", file.display()));
    }
    Ok(true)
}

/// Reports where a file is not formatted. Answers whether it is.
fn check(file: &Path, text: String, global: &Global) -> Result<bool> {
    if !is_readable(file, &text, global)? {
        return Ok(false);
    }
    let formatted = format(&text);
    if formatted == text {
        return Ok(true);
    }
    let begin = text.lines().zip(formatted.lines()).take_while(|(a, b)| a == b).map(|(line, _)| line.len() + 1).sum();
    let mut sources = Sources::default();
    let begin = text.len().min(begin);
    let end = text[begin..].find('\n').map_or(text.len(), |at| begin + at);
    let id = sources.add(SourceFile::new(file.display().to_string(), text));
    let hint = format!("`chiaro fmt {}` formats it", file.display());
    let error = Diagnostic::error(Span::new(id, begin..end), "this is not formatted from here on").with_hint(hint);
    terminal::report(&sources, &[error], global)?;
    Ok(false)
}

/// Reports what is wrong with a text's syntax. Answers whether there is no error.
fn is_readable(file: &Path, text: &str, global: &Global) -> Result<bool> {
    let name = file.display().to_string();
    let mut sources = Sources::default();
    let id = sources.add(SourceFile::new(name.clone(), text));
    let (_, diagnostics) = parse(id, text, Dialect::of_file(&name));
    let errors: Vec<_> = diagnostics.into_iter().filter(|diagnostic| diagnostic.severity == Severity::Error).collect();
    terminal::report(&sources, &errors, global)?;
    Ok(errors.is_empty())
}
