//! Diagnostics as data. They are rendered only at the rim: by the terminal, the editor, or as JSON.

use crate::source::Span;

/// How bad a diagnostic is. An error means that there is no scene; a warning, that it may not be the one meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// Something worth knowing, such as the output of `echo` or a live number that became structural.
    Note,
    /// The scene compiles, but perhaps not to what was meant.
    Warning,
    /// There is no scene.
    Error,
}

/// A second place that explains a diagnostic.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// The place.
    pub span: Span,
    /// What is to be seen there.
    pub message: String,
}

/// A change of the text that would mend what a diagnostic is about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Suggestion {
    /// What gives way; empty where something is missing.
    pub span: Span,
    /// What should stand there.
    pub text: String,
}

/// One thing to tell the user: what is wrong, where, and how to mend it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// How bad it is.
    pub severity: Severity,
    /// What is wrong, in the user's words, without a full stop.
    pub message: String,
    /// Where. Only what concerns no place of any file, such as a file that can't be read, has none.
    pub span: Option<Span>,
    /// What the span itself shows, if the message needs it.
    pub label: Option<Box<str>>,
    /// Other places that explain it, such as an earlier definition or the call that led here.
    pub related: Vec<Label>,
    /// How to mend it.
    pub hints: Vec<String>,
    /// The change of the text that would most likely mend it.
    pub suggestion: Option<Box<Suggestion>>,
}

impl Diagnostic {
    /// A diagnostic of that severity about `span`.
    pub fn new(severity: Severity, span: impl Into<Option<Span>>, message: impl Into<String>) -> Self {
        let (message, span) = (message.into(), span.into());
        Self { severity, message, span, label: None, related: Vec::new(), hints: Vec::new(), suggestion: None }
    }

    /// An error about `span`.
    pub fn error(span: impl Into<Option<Span>>, message: impl Into<String>) -> Self {
        Self::new(Severity::Error, span, message)
    }

    /// A warning about `span`.
    pub fn warning(span: impl Into<Option<Span>>, message: impl Into<String>) -> Self {
        Self::new(Severity::Warning, span, message)
    }

    /// A note about `span`.
    pub fn note(span: impl Into<Option<Span>>, message: impl Into<String>) -> Self {
        Self::new(Severity::Note, span, message)
    }

    /// Says what the span itself shows.
    pub fn with_label(mut self, label: impl Into<String>) -> Self {
        self.label = Some(label.into().into_boxed_str());
        self
    }

    /// Adds a place that explains the diagnostic.
    pub fn with_related(mut self, span: Span, message: impl Into<String>) -> Self {
        self.related.push(Label { span, message: message.into() });
        self
    }

    /// Says which change of the text would mend it, unless that has been said.
    pub fn with_suggestion(mut self, span: Span, text: impl Into<String>) -> Self {
        self.suggestion.get_or_insert_with(|| Box::new(Suggestion { span, text: text.into() }));
        self
    }

    /// Adds a way to mend it.
    pub fn with_hint(mut self, hint: impl Into<String>) -> Self {
        self.hints.push(hint.into());
        self
    }
}
