//! The scene as the code of a shader.
//!
//! Practice: the code is made off the window's thread, once for each revision; only lines in sight are laid out. A line belongs to
//! what is selected if the selection is among the expressions around the one that the line stands for.

mod highlight;

use std::collections::{HashMap, HashSet};

use chiaro_compiler::shader::{Listing, listing};
use chiaro_compiler::syntax::Span;
use chiaro_compiler::{SolidId, compile};
use egui::{ScrollArea, Shape, TextStyle, Ui};

use crate::app::Editor;
use crate::dialogs::export::Export;
use crate::studio::{BufferWorld, Program};
use crate::worker::Job;

/// The code of a revision.
#[derive(Default)]
pub(crate) struct ShaderText {
    revision: Option<u64>,
    making: Option<Job<Result<Listing, String>>>,
    text: String,
    /// Where its lines start.
    lines: Vec<usize>,
    /// The lines that stand for expressions.
    spans: Vec<(usize, Span)>,
    /// The lines that belong to the selection, for which they were looked up.
    marked: HashSet<usize>,
    marked_for: Option<(u64, Option<SolidId>)>,
    trouble: Option<String>,
}

/// Shows it.
pub(crate) fn show(editor: &mut Editor, ui: &mut Ui) {
    refresh(editor, ui);
    mark(editor);
    let shader = &editor.panels.shader;
    if let Some(trouble) = &shader.trouble {
        ui.colored_label(ui.visuals().error_fg_color, trouble);
        return;
    }
    if shader.text.is_empty() {
        ui.weak("There is no scene yet.");
        return;
    }
    let mut saves = false;
    ui.horizontal(|ui| {
        ui.label(format!("WGSL, {} lines, {:.1} kB", shader.lines.len(), shader.text.len() as f64 / 1e3));
        if ui.button("Copy").clicked() {
            ui.ctx().copy_text(shader.text.clone());
        }
        saves = ui.button("Save…").clicked();
    });
    let height = ui.text_style_height(&TextStyle::Monospace);
    ScrollArea::both().auto_shrink(false).show_rows(ui, height, shader.lines.len(), |ui, rows| {
        for row in rows {
            let job = highlight::line(ui, shader.line(row));
            let behind = ui.painter().add(Shape::Noop);
            let rect = ui.add(egui::Label::new(job).extend()).rect;
            if shader.marked.contains(&row) {
                let line = rect.with_max_x(rect.right().max(ui.clip_rect().right()));
                ui.painter().set(behind, Shape::rect_filled(line, 2.0, ui.visuals().selection.bg_fill));
            }
        }
    });
    if saves {
        editor.dialogs.export = Some(Export::of_shader(editor));
    }
}

/// Makes the code of a new scene.
fn refresh(editor: &mut Editor, ui: &Ui) {
    let shader = &mut editor.panels.shader;
    if let Some(made) = shader.making.as_mut().and_then(Job::poll) {
        shader.making = None;
        match made.and_then(|made| made) {
            Ok(listing) => shader.take(listing),
            Err(trouble) => shader.trouble = Some(trouble),
        }
    }
    let Some(shown) = &editor.session.shown else { return };
    if shader.revision != Some(shown.revision) && shader.making.is_none() {
        shader.revision = Some(shown.revision);
        let program = editor.session.program();
        shader.making = Job::start(ui.ctx(), move |_| code(program)).ok();
    }
}

/// Finds the lines that what is selected became.
fn mark(editor: &mut Editor) {
    let shader = &mut editor.panels.shader;
    let selection = editor.viewport.selection.as_ref();
    let selected = selection.and_then(|selection| selection.origin()).map(|origin| origin.solid);
    let Some(revision) = shader.revision.filter(|_| shader.making.is_none()) else { return };
    if shader.marked_for == Some((revision, selected)) {
        return;
    }
    shader.marked_for = Some((revision, selected));
    shader.marked.clear();
    let (Some(selection), Some(selected)) = (selection, selected) else { return };
    let provenance = &selection.provenance;
    let is_in = |solid: &SolidId| provenance.chain(*solid).iter().any(|origin| origin.solid == selected);
    let mut known: HashMap<Span, bool> = HashMap::new();
    for (line, span) in &shader.spans {
        // Unions that nobody wrote are no expression's.
        let is_part = |span: &Span| {
            provenance.expression_at(span.file, span.start) == Some(*span)
                && provenance.nodes_at(span.file, span.start).iter().any(is_in)
        };
        if *known.entry(*span).or_insert_with_key(is_part) {
            shader.marked.insert(*line);
        }
    }
}

/// The code of a program as it stands, without numbers that are live only because they were edited.
pub(crate) fn code(program: Program) -> Result<Listing, String> {
    let world = BufferWorld::new(program.buffers);
    let scene = compile(&world, &program.main, &program.options).scene.ok_or("the scene has errors")?;
    listing(&scene.graph).map_err(|error| error.message)
}

impl ShaderText {
    fn take(&mut self, Listing { text, lines }: Listing) {
        let starts = text.match_indices('\n').map(|(at, _)| at + 1).filter(|at| *at < text.len());
        self.lines = std::iter::once(0).chain(starts).collect();
        (self.text, self.spans, self.trouble, self.marked_for) = (text, lines, None, None);
    }

    fn line(&self, index: usize) -> &str {
        let end = self.lines.get(index + 1).map_or(self.text.len(), |next| *next);
        self.text[self.lines[index]..end].trim_end_matches('\n')
    }
}

#[cfg(test)]
impl ShaderText {
    pub(super) fn text(&self) -> &str {
        &self.text
    }

    /// The lines that are marked.
    pub(super) fn marked(&self) -> Vec<&str> {
        let mut rows: Vec<usize> = self.marked.iter().copied().collect();
        rows.sort_unstable();
        rows.into_iter().map(|row| self.line(row)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_has_its_lines() {
        let mut shader = ShaderText::default();
        shader.take(Listing { text: "fn a() {\n\n}\n".to_owned(), lines: Vec::new() });
        let lines: Vec<_> = (0..shader.lines.len()).map(|row| shader.line(row)).collect();
        assert_eq!(lines, ["fn a() {", "", "}"]);
    }
}
