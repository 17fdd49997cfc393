//! The scene as the code of a shader.
//!
//! Practice: the code is made off the window's thread, once for each revision and language; only lines in sight are laid out. A line belongs to
//! what is selected if the selection is among the expressions around the one that the line stands for.

mod highlight;

use std::collections::{HashMap, HashSet};

use chiaro_compiler::export::{Language, listing};
use chiaro_compiler::shader::Listing;
use chiaro_compiler::syntax::Span;
use chiaro_compiler::{ModuleNames, SolidId, compile};
use egui::{ComboBox, ScrollArea, Shape, TextStyle, Ui};

use crate::app::Editor;
use crate::dialogs::export::Export;
use crate::studio::{BufferWorld, Program};
use crate::worker::Job;

/// The languages to choose from. (Those of GLSL differ in nothing that is shown.)
const LANGUAGES: [(Language, &str); 4] =
    [(Language::Wgsl, "WGSL"), (Language::Glsl330, "GLSL"), (Language::Hlsl, "HLSL"), (Language::Metal, "Metal")];

/// The code of a revision.
pub(crate) struct ShaderText {
    /// The revision and the language that it is of.
    of: Option<(u64, Language)>,
    language: Language,
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
    ui.horizontal_wrapped(|ui| {
        language_choice(ui, &mut editor.panels.shader.language);
        let shader = &editor.panels.shader;
        if ui.button("Copy").clicked() {
            ui.ctx().copy_text(shader.text.clone());
        }
        saves = ui.button("Save…").clicked();
        ui.weak(format!("{} lines, {:.1} kB", shader.lines.len(), shader.text.len() as f64 / 1e3));
    });
    let shader = &editor.panels.shader;
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
        let language = editor.panels.shader.language;
        editor.dialogs.open(Export::of_shader(editor, language));
    }
}

fn language_choice(ui: &mut Ui, chosen: &mut Language) {
    let name = |language| LANGUAGES.iter().find(|(own, _)| *own == language).map_or("", |(_, name)| name);
    let combo = ComboBox::from_id_salt("language").selected_text(name(*chosen)).width(70.0).show_ui(ui, |ui| {
        for (language, name) in LANGUAGES {
            ui.selectable_value(chosen, language, name);
        }
    });
    ui.ctx().accesskit_node_builder(combo.response.id, |node| node.set_label("Language"));
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
    let (wanted, language) = (Some((shown.revision, shader.language)), shader.language);
    if shader.of != wanted && shader.making.is_none() {
        shader.of = wanted;
        let program = editor.session.program();
        shader.making = Job::start(ui.ctx(), move |_| code(program, language)).ok();
    }
}

/// Finds the lines that what is selected became.
fn mark(editor: &mut Editor) {
    let shader = &mut editor.panels.shader;
    let selection = editor.viewport.selection.as_ref();
    let selected = selection.and_then(|selection| selection.origin()).map(|origin| origin.solid);
    let Some((revision, _)) = shader.of.filter(|_| shader.making.is_none()) else { return };
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
fn code(program: Program, language: Language) -> Result<Listing, String> {
    let world = BufferWorld::new(program.buffers);
    let compilation = compile(&world, &program.main, &program.options);
    let scene = compilation.scene.ok_or("the scene has errors")?;
    let names = ModuleNames::new(&compilation.sources);
    let listing = listing(&scene.graph, &scene.parameters, &|span| names.of(span), language);
    listing.map_err(|error| error.message)
}

impl Default for ShaderText {
    fn default() -> Self {
        Self {
            of: None,
            language: Language::Wgsl,
            making: None,
            text: String::new(),
            lines: Vec::new(),
            spans: Vec::new(),
            marked: HashSet::new(),
            marked_for: None,
            trouble: None,
        }
    }
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

    pub(super) fn set_language(&mut self, language: Language) {
        self.language = language;
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
