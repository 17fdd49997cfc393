//! "Did you mean": the known name nearest to an unknown one.

use chiaro_syntax::{Diagnostic, Span};

/// The most similar of the known names, if one is similar enough to be what was meant.
pub(crate) fn nearest<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> Option<String> {
    let likeness = |other: &str| {
        let case_only = name.eq_ignore_ascii_case(other);
        if case_only { 0.5 } else { strsim::damerau_levenshtein(name, other) as f64 }
    };
    // A third of the letters may differ; of very short names none, or every name would be like any other.
    let tolerance = (name.chars().count() as f64 / 3.0).floor().max(0.5);
    let best = known
        .filter(|other| *other != name && other.len().abs_diff(name.len()) <= 4)
        .map(|other| (likeness(other), other))
        .filter(|(distance, _)| *distance <= tolerance)
        .min_by(|a, b| a.0.total_cmp(&b.0).then_with(|| a.1.cmp(b.1)));
    best.map(|(_, other)| other.to_string())
}

/// A diagnostic about a name that is not known, written at `span`, with the nearest one that is known.
pub(crate) fn with_nearest<'a>(
    diagnostic: Diagnostic,
    span: Span,
    name: &str,
    known: impl Iterator<Item = &'a str>,
) -> Diagnostic {
    match nearest(name, known) {
        Some(nearest) => meant(diagnostic, span, &nearest),
        None => diagnostic,
    }
}

/// A diagnostic with the name that may have been meant at `span`.
pub(crate) fn meant(diagnostic: Diagnostic, span: Span, name: &str) -> Diagnostic {
    diagnostic.with_hint(format!("did you mean `{name}`?")).with_suggestion(span, name)
}
