//! What stands around the caret: the brackets it is at, other places of its name, the call under way.

use std::ops::Range;

use chiaro_assist::{CallHint, brackets, call_hint, references};

use crate::app::Editor;
use crate::document::DocumentId;

/// Texts of more bytes are not read through whenever the caret moves.
const SMALL: usize = 200_000;

/// What was found around the caret.
#[derive(Default)]
pub(super) struct Around {
    /// For which text, in which version, and for which caret.
    of: Option<(DocumentId, u64, usize)>,
    pub(super) brackets: Vec<Range<usize>>,
    pub(super) references: Vec<Range<usize>>,
    pub(super) call: Option<CallHint>,
}

/// Looks around the caret again, if it moved or the text changed.
pub(super) fn update(editor: &mut Editor) {
    let document = editor.session.active();
    let of = Some((document.id, editor.text.layout.version(), document.caret));
    if editor.text.around.of == of {
        return;
    }
    let (text, caret) = (&document.text, document.caret);
    let mut around = Around { of, ..Default::default() };
    if text.len() <= SMALL && document.anchor == caret {
        around.brackets = brackets(text, caret).into_iter().flatten().collect();
        around.references = references(text, caret);
        around.call = call_hint(text, caret);
    }
    editor.text.around = around;
}
