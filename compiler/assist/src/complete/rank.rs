//! Which completions fit what has been typed, and how well.

use super::Completion;

/// A completion, and how likely it is by itself: the less, the likelier.
pub(super) struct Candidate {
    pub(super) completion: Completion,
    pub(super) order: u8,
}

/// The candidates that fit, the best first.
pub(super) fn ranked(candidates: Vec<Candidate>, typed: &str) -> Vec<Completion> {
    let fit = |candidate: Candidate| Some((misfit(typed, &candidate.completion.label)?, candidate));
    let mut fitting: Vec<_> = candidates.into_iter().filter_map(fit).collect();
    fitting.sort_by(|(misfit, a), (other, b)| {
        let key = |candidate: &Candidate| candidate.completion.label.to_lowercase();
        (misfit, a.order).cmp(&(other, b.order)).then_with(|| key(a).cmp(&key(b)))
    });
    let mut items: Vec<Completion> = Vec::with_capacity(fitting.len());
    for (_, candidate) in fitting {
        let is_known =
            |item: &Completion| item.label == candidate.completion.label && item.kind == candidate.completion.kind;
        if !items.iter().any(is_known) {
            items.push(candidate.completion);
        }
    }
    items
}

/// How badly a label fits what has been typed: 0 if it begins like it, more if it only holds its letters in their order;
/// none, if it does not.
fn misfit(typed: &str, label: &str) -> Option<u8> {
    let (typed_small, label_small) = (typed.to_lowercase(), label.to_lowercase());
    if label.starts_with(typed) {
        Some(0)
    } else if label_small.starts_with(&typed_small) {
        Some(1)
    } else if label_small.split('_').any(|part| part.starts_with(&typed_small)) {
        Some(2)
    } else if label_small.contains(&typed_small) {
        Some(3)
    } else if holds(&label_small, &typed_small) {
        Some(4)
    } else {
        None
    }
}

/// Whether a text has all letters of another in their order, and begins with the first of them.
fn holds(text: &str, letters: &str) -> bool {
    let mut rest = text.chars();
    letters.chars().next() == text.chars().next() && letters.chars().all(|letter| rest.any(|other| other == letter))
}
