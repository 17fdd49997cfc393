//! What there is to say about the scene: errors, warnings and notes, with their places.

use chiaro_compiler::syntax::{Diagnostic, Severity, Span};
use egui::{CollapsingHeader, Color32, RichText, ScrollArea, Sense, Ui, Visuals, vec2};

use crate::app::Editor;

/// The groups in which messages are shown.
const GROUPS: [(Severity, &str); 3] =
    [(Severity::Error, "Errors"), (Severity::Warning, "Warnings"), (Severity::Note, "Notes and echo")];

/// A message as it is shown.
struct Message {
    severity: Severity,
    text: String,
    /// File and line.
    place: Option<String>,
    span: Option<Span>,
    hints: Vec<String>,
    related: Vec<(Span, String)>,
}

/// How many errors and warnings there are.
pub(crate) fn counts(editor: &Editor) -> [usize; 2] {
    let diagnostics = editor.session.outcome.as_ref().map_or(&[][..], |outcome| &outcome.diagnostics);
    let count = |severity| diagnostics.iter().filter(|diagnostic| diagnostic.severity == severity).count();
    [count(Severity::Error), count(Severity::Warning)]
}

/// The colour of a severity.
pub(crate) fn color(visuals: &Visuals, severity: Severity) -> Color32 {
    match severity {
        Severity::Error => visuals.error_fg_color,
        Severity::Warning => visuals.warn_fg_color,
        Severity::Note => visuals.weak_text_color(),
    }
}

/// Shows them.
pub(crate) fn show(editor: &mut Editor, ui: &mut Ui) {
    let Some(outcome) = &editor.session.outcome else { return };
    let messages: Vec<Message> = outcome.diagnostics.iter().map(|diagnostic| message(editor, diagnostic)).collect();
    if messages.is_empty() {
        ui.label("Nothing to say: the scene is fine.");
        return;
    }
    if ui.button("Copy all").clicked() {
        let lines: Vec<String> = messages.iter().map(line).collect();
        ui.ctx().copy_text(lines.join("\n"));
    }
    let mut revealed = None;
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        for (severity, title) in GROUPS {
            let group: Vec<&Message> = messages.iter().filter(|message| message.severity == severity).collect();
            if group.is_empty() {
                continue;
            }
            let title =
                RichText::new(format!("{title} ({})", group.len())).strong().color(color(ui.visuals(), severity));
            CollapsingHeader::new(title).id_salt(severity as u8).default_open(true).show(ui, |ui| {
                for message in group {
                    revealed = one(ui, message).or(revealed);
                }
            });
        }
    });
    if let Some(span) = revealed {
        reveal(editor, span);
    }
}

fn message(editor: &Editor, diagnostic: &Diagnostic) -> Message {
    Message {
        severity: diagnostic.severity,
        text: match &diagnostic.label {
            Some(label) => format!("{}: {label}", diagnostic.message),
            None => diagnostic.message.clone(),
        },
        place: diagnostic.span.and_then(|span| place(editor, span)),
        span: diagnostic.span,
        hints: diagnostic.hints.clone(),
        related: diagnostic.related.iter().map(|label| (label.span, label.message.clone())).collect(),
    }
}

/// File and line, as people say them.
fn place(editor: &Editor, span: Span) -> Option<String> {
    let outcome = editor.session.outcome.as_ref()?;
    let file = outcome.sources.get(span.file);
    let before = file.text.get(..span.start as usize)?;
    let line = before.bytes().filter(|byte| *byte == b'\n').count() + 1;
    let name = std::path::Path::new(&file.name).file_name()?.to_string_lossy().into_owned();
    Some(format!("{name}:{line}"))
}

/// A message as a line of a log.
fn line(message: &Message) -> String {
    let severity = match message.severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Note => "note",
    };
    let place = message.place.as_ref().map_or(String::new(), |place| format!("{place}: "));
    format!("{place}{severity}: {}", message.text)
}

/// Shows a message. The place that was clicked, if one was.
fn one(ui: &mut Ui, message: &Message) -> Option<Span> {
    let mut revealed = None;
    ui.horizontal_wrapped(|ui| {
        let (dot, _) = ui.allocate_exact_size(vec2(8.0, 8.0), Sense::hover());
        ui.painter().circle_filled(dot.center(), 3.0, color(ui.visuals(), message.severity));
        if message.span.is_some() {
            if ui.link(&message.text).clicked() {
                revealed = message.span;
            }
        } else {
            ui.label(&message.text);
        }
        if let Some(place) = &message.place {
            ui.label(RichText::new(place).small().weak());
        }
    });
    ui.indent("more", |ui| {
        for (span, text) in &message.related {
            if ui.link(RichText::new(text).small()).clicked() {
                revealed = Some(*span);
            }
        }
        for hint in &message.hints {
            ui.label(RichText::new(hint).small().weak());
        }
    });
    revealed
}

/// Puts the caret at a place of a text, which is opened if need be.
fn reveal(editor: &mut Editor, span: Span) {
    let Some(outcome) = &editor.session.outcome else { return };
    let name = outcome.sources.get(span.file).name.clone();
    match editor.session.documents().iter().position(|document| document.name() == name) {
        Some(index) => editor.session.activate(index),
        None => {
            if let Err(reason) = editor.session.open(std::path::Path::new(&name)) {
                editor.session.failure = Some(reason);
                return;
            }
        }
    }
    editor.reveal(span.range());
}
