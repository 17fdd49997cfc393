//! Collecting diagnostics, but not too many of them.

use crate::diagnostic::{Diagnostic, Severity};
use crate::source::Span;

/// The most errors of a file that are shown, and likewise the most warnings.
const MAX_SHOWN: usize = 100;

/// The diagnostics of one file.
#[derive(Default)]
pub(super) struct Reports {
    diagnostics: Vec<Diagnostic>,
    errors: usize,
    warnings: usize,
    first_hidden: Option<Span>,
}

impl Reports {
    pub(super) fn push(&mut self, diagnostic: Diagnostic) {
        let count = match diagnostic.severity {
            Severity::Error => &mut self.errors,
            Severity::Warning | Severity::Note => &mut self.warnings,
        };
        *count += 1;
        if *count <= MAX_SHOWN {
            self.diagnostics.push(diagnostic);
        } else if self.first_hidden.is_none() {
            self.first_hidden = diagnostic.span;
        }
    }

    /// All diagnostics, in the order of the text.
    pub(super) fn finish(mut self) -> Vec<Diagnostic> {
        self.diagnostics.sort_by_key(|diagnostic| diagnostic.span.map(|span| span.start));
        let kind = if self.errors > MAX_SHOWN { "errors" } else { "warnings" };
        let more = self.first_hidden.map(|span| Diagnostic::note(span, format!("further {kind} are not shown")));
        self.diagnostics.extend(more);
        self.diagnostics
    }
}
