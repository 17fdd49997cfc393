//! The scene as the code of a shader.
//!
//! Practice: the code is made off the window's thread, once for each revision; only lines in sight are laid out.

mod highlight;

use chiaro_compiler::compile;
use egui::{ScrollArea, TextStyle, Ui};

use crate::app::Editor;
use crate::dialogs::export::Export;
use crate::studio::{BufferWorld, Program};
use crate::worker::Job;

/// The code of a revision.
#[derive(Default)]
pub(crate) struct ShaderText {
    revision: Option<u64>,
    making: Option<Job<Result<String, String>>>,
    text: String,
    /// Where its lines start.
    lines: Vec<usize>,
    trouble: Option<String>,
}

/// Shows it.
pub(crate) fn show(editor: &mut Editor, ui: &mut Ui) {
    refresh(editor, ui);
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
            ui.add(egui::Label::new(job).extend());
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
            Ok(text) => shader.take(text),
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

/// The code of a program as it stands, without numbers that are live only because they were edited.
pub(crate) fn code(program: Program) -> Result<String, String> {
    let world = BufferWorld::new(program.buffers);
    let scene = compile(&world, &program.main, &program.options).scene.ok_or("the scene has errors")?;
    chiaro_compiler::shader::wgsl(&scene.graph).map_err(|error| error.message)
}

impl ShaderText {
    fn take(&mut self, text: String) {
        let starts = text.match_indices('\n').map(|(at, _)| at + 1).filter(|at| *at < text.len());
        self.lines = std::iter::once(0).chain(starts).collect();
        (self.text, self.trouble) = (text, None);
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
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_has_its_lines() {
        let mut shader = ShaderText::default();
        shader.take("fn a() {\n\n}\n".to_owned());
        let lines: Vec<_> = (0..shader.lines.len()).map(|row| shader.line(row)).collect();
        assert_eq!(lines, ["fn a() {", "", "}"]);
    }
}
