//! Quick fixes at the caret.

use super::popup::{Choice, List};
use crate::app::Editor;

/// Offers the fixes of what is wrong at the caret, or else in its line.
pub(super) fn ask(editor: &mut Editor) {
    let caret = editor.session.active().caret;
    let layout = &editor.text.layout;
    let line = layout.line(layout.line_of(caret));
    let is_near = |range: &std::ops::Range<usize>| range.start <= line.end && line.start <= range.end;
    let mut near: Vec<_> = editor.text.messages.found.iter().filter(|message| is_near(&message.range)).collect();
    near.sort_by_key(|message| !(message.range.start <= caret && caret <= message.range.end));
    let fixes = near.into_iter().flat_map(|message| message.fixes.iter().map(move |fix| (message, fix)));
    let choice = |(message, fix): (&super::messages::Message, &super::messages::Fix)| Choice {
        label: fix.title.replace('`', ""),
        kind: "fix",
        detail: String::new(),
        documentation: message.diagnostic.message.clone(),
        change: fix.change.clone(),
    };
    let choices: Vec<_> = fixes.map(choice).collect();
    editor.text.list = (!choices.is_empty()).then(|| List::new("quick fixes", choices, caret));
}
