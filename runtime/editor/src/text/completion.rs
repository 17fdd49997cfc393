//! What could be written at the caret.

use std::path::Path;

use chiaro_assist::{Completion, CompletionKind, Completions, complete_in};
use egui::{Rect, Ui};

use super::edits::Change;
use super::popup::{Answer, Choice, List};
use crate::app::Editor;
use crate::document::DocumentId;

/// The list's name.
const NAME: &str = "completions";
/// In a text of more bytes, nothing is offered before it is asked for.
const MOST_UNASKED: usize = 1 << 20;

/// Offers what could be written at the caret.
pub(super) fn ask(editor: &mut Editor) {
    let document = editor.session.active();
    let found = complete_in(&editor.world(), &document.name(), &document.text, document.caret);
    let choices = choices(editor, found);
    let at = editor.session.active().caret;
    editor.text.list = (!choices.is_empty()).then(|| List::new(NAME, choices, at));
}

/// Keeps the list with what is being written.
pub(super) fn follow(editor: &mut Editor, was_typed: bool) {
    let document = editor.session.active();
    let word = word_before(&document.text, document.caret);
    let begins = word.starts_with(|letter: char| letter.is_alphabetic() || matches!(letter, '$' | '_'));
    let is_open = editor.text.list.as_ref().is_some_and(|list| list.name == NAME);
    let is_asked = is_open || document.text.len() < MOST_UNASKED;
    if was_typed && begins && is_asked || is_open && begins {
        ask(editor);
    } else {
        editor.text.list = None;
    }
}

/// Takes the keys that are the list's.
pub(super) fn take_keys(editor: &mut Editor, ui: &Ui) {
    let Some(list) = &mut editor.text.list else { return };
    match list.take_keys(ui) {
        Answer::Stays => {}
        Answer::Closed => editor.text.list = None,
        Answer::Taken(change) => take(editor, &change),
    }
}

/// Shows the list at its place; it closes when the caret goes elsewhere.
pub(super) fn show(editor: &mut Editor, ui: &Ui, caret: Rect, has_focus: bool) {
    let pointer = ui.input(|input| input.pointer.interact_pos());
    let at = editor.session.active().caret;
    let Some(list) = &mut editor.text.list else { return };
    if list.at != at || !has_focus && !list.is_under(pointer) {
        editor.text.list = None;
        return;
    }
    if let Some(change) = list.show(ui, caret) {
        take(editor, &change);
    }
}

fn take(editor: &mut Editor, change: &Change) {
    editor.text.list = None;
    editor.text.wants_focus = true;
    editor.change(change);
    editor.text.written_along = WrittenAlong::of(change, editor.session.active().id);
}

/// What a completion wrote behind its word, such as a bracket. Whoever types it all the same means
/// that one.
pub(super) struct WrittenAlong {
    document: DocumentId,
    /// Where the completion left the caret.
    caret: usize,
    letter: char,
    /// Where the caret is once the letter is typed.
    behind: usize,
}

impl WrittenAlong {
    fn of(change: &Change, document: DocumentId) -> Option<Self> {
        let [edit] = &change.edits[..] else { return None };
        let along = edit.text.trim_start_matches(is_of_word).trim_start();
        let letter = along.chars().next()?;
        let next = along[letter.len_utf8()..].trim_start();
        Some(Self { document, caret: change.caret, letter, behind: edit.range.start + edit.text.len() - next.len() })
    }

    /// Whether it is as it was when the completion was taken.
    fn is_fresh(&self, editor: &Editor) -> bool {
        let document = editor.session.active();
        document.id == self.document && [document.anchor, document.caret] == [self.caret; 2]
    }
}

/// Whether what is typed stands there already, because the completion that was just taken wrote it.
/// Then the caret goes behind it.
pub(super) fn is_typed_over(editor: &mut Editor, typed: &str) -> bool {
    let Some(along) = editor.text.written_along.take().filter(|along| along.is_fresh(editor)) else { return false };
    let is_typed_over = typed.chars().eq([along.letter]);
    if is_typed_over {
        editor.session.active_mut().place_caret(along.behind);
    }
    is_typed_over
}

/// Forgets what a completion wrote as soon as the caret went elsewhere.
pub(super) fn forget_written(editor: &mut Editor) {
    let is_fresh = editor.text.written_along.as_ref().is_some_and(|along| along.is_fresh(editor));
    if !is_fresh {
        editor.text.written_along = None;
    }
}

fn choices(editor: &Editor, found: Completions) -> Vec<Choice> {
    let replaces = found.replaces.clone();
    let written = |insert: String, caret: usize| {
        let mut change = Change::replacement(replaces.clone(), insert);
        let caret = replaces.start + caret.min(change.caret - replaces.start);
        (change.anchor, change.caret) = (caret, caret);
        change
    };
    if let Some(path) = &found.path {
        let folder = editor.session.active().path.as_deref().and_then(Path::parent);
        return folder
            .map_or(Vec::new(), |folder| files(folder, path))
            .into_iter()
            .map(|name| Choice {
                change: written(name.clone(), name.len()),
                label: name,
                kind: "file",
                detail: String::new(),
                documentation: String::new(),
            })
            .collect();
    }
    let choice = |item: Completion| Choice {
        kind: kind(item.kind),
        change: written(item.insert, item.caret),
        label: item.label,
        detail: item.detail,
        documentation: item.documentation,
    };
    found.items.into_iter().map(choice).collect()
}

fn kind(kind: CompletionKind) -> &'static str {
    match kind {
        CompletionKind::Module => "module",
        CompletionKind::Function => "function",
        CompletionKind::Variable => "variable",
        CompletionKind::Parameter => "parameter",
        CompletionKind::Keyword => "keyword",
        CompletionKind::Color => "colour",
        CompletionKind::Value => "value",
    }
}

/// The scenes and folders that a path which is being written could mean.
fn files(folder: &Path, written: &str) -> Vec<String> {
    let (above, begun) = written.rsplit_once('/').map_or(("", written), |(above, begun)| (above, begun));
    let Ok(entries) = std::fs::read_dir(folder.join(above)) else { return Vec::new() };
    let named = |entry: std::fs::DirEntry| {
        let name = entry.file_name().into_string().ok()?;
        let is_folder = entry.file_type().is_ok_and(|kind| kind.is_dir());
        let is_scene = name.ends_with(".scad") || name.ends_with(".csg");
        let fits = name.to_lowercase().starts_with(&begun.to_lowercase()) && !name.starts_with('.');
        let prefix = if above.is_empty() { String::new() } else { format!("{above}/") };
        (fits && (is_folder || is_scene)).then(|| format!("{prefix}{name}{}", if is_folder { "/" } else { "" }))
    };
    let mut names: Vec<_> = entries.flatten().filter_map(named).collect();
    names.sort();
    names
}

/// The part of a word that stands before a place.
fn word_before(text: &str, at: usize) -> &str {
    let before = &text[..at];
    &before[before.trim_end_matches(is_of_word).len()..]
}

fn is_of_word(letter: char) -> bool {
    letter.is_alphanumeric() || matches!(letter, '_' | '$')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_end_at_the_caret() {
        assert_eq!(word_before("a = $fn + cu", 12), "cu");
        assert_eq!(word_before("a = $fn", 7), "$fn");
        assert_eq!(word_before("cube(", 5), "");
    }

    #[test]
    fn paths_are_completed_with_scenes_and_folders() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir(folder.path().join("parts")).unwrap();
        for name in ["plate.scad", "picture.png", "parts/pin.csg"] {
            std::fs::write(folder.path().join(name), "").unwrap();
        }
        assert_eq!(files(folder.path(), "p"), ["parts/", "plate.scad"]);
        assert_eq!(files(folder.path(), "parts/"), ["parts/pin.csg"]);
        assert!(files(folder.path(), "none/").is_empty());
    }
}
