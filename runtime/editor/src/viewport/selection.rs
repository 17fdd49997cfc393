//! The selected solids: picture and text are one.

use std::sync::Arc;

use chiaro_compiler::syntax::Span;
use chiaro_compiler::{Origin, Provenance, SolidId};

use crate::app::Editor;
use crate::studio::Outlined;

/// The solids that an expression made.
#[derive(Clone)]
pub(crate) struct Selection {
    pub(crate) provenance: Arc<Provenance>,
    pub(crate) solids: Vec<SolidId>,
    /// The expression and those around it, the innermost first.
    pub(crate) chain: Vec<Origin>,
    /// Which of the chain is selected.
    pub(crate) at: usize,
}

impl Selection {
    pub(super) fn outlined(&self) -> Outlined {
        Outlined { provenance: self.provenance.clone(), solids: self.solids.clone() }
    }

    /// The selected expression.
    pub(crate) fn origin(&self) -> Option<&Origin> {
        self.chain.get(self.at)
    }
}

impl Editor {
    /// Selects a solid that its expression made, and shows the expression in the text.
    pub(crate) fn select(&mut self, chain: Vec<Origin>, at: usize) {
        let Some(provenance) = self.session.shown.as_ref().and_then(|shown| shown.provenance.clone()) else { return };
        let Some(origin) = chain.get(at) else { return };
        self.reveal_span(origin.span);
        self.viewport.selection = Some(Selection { provenance, solids: vec![origin.solid], chain, at });
    }

    /// Puts the caret where an expression of the scene in the picture is written, if its text is open and still that.
    fn reveal_span(&mut self, span: Span) {
        let Some(shown) = &self.session.shown else { return };
        let file = shown.sources.get(span.file);
        let (name, text) = (file.name.clone(), file.text.clone());
        let found = self.session.documents().iter().position(|open| open.name() == name && *open.text == *text);
        if let Some(index) = found {
            self.session.activate(index);
            self.reveal(span.range());
        }
    }
}

/// Selects what the expression at the caret made, when the caret moved.
pub(super) fn follow_caret(editor: &mut Editor) {
    let document = editor.session.active();
    let caret = (document.id, document.caret, document.text.len());
    let Some(shown) = &editor.session.shown else { return };
    let Some(provenance) = &shown.provenance else { return };
    let moment = (caret, shown.revision);
    if editor.viewport.followed == Some(moment) {
        return;
    }
    let is_known = editor.viewport.selection.as_ref().is_some_and(|selection| {
        Arc::ptr_eq(&selection.provenance, provenance)
            && selection.origin().is_some_and(|origin| origin.span.start as usize == document.caret)
    });
    editor.viewport.followed = Some(moment);
    if is_known {
        return;
    }
    let name = document.name();
    let file = shown.sources.iter().find(|(_, file)| file.name == name && *file.text == *document.text);
    let Some((file, _)) = file else {
        editor.viewport.selection = None;
        return;
    };
    let offset = document.caret as u32;
    let solids = match provenance.expression_at(file, offset) {
        // A caret in blank space means nothing.
        Some(span) if span.start <= offset && offset <= span.end => provenance.nodes_at(file, offset),
        _ => Vec::new(),
    };
    editor.viewport.selection = match solids.first() {
        Some(first) => {
            let chain = provenance.chain(*first);
            Some(Selection { provenance: provenance.clone(), solids, chain, at: 0 })
        }
        None => None,
    };
}
