//! The panel at the right: parameters, solids, messages, shader, timings.

pub(crate) mod messages;
mod parameters;
pub(crate) mod shader;
mod solids;
pub(crate) mod time;
mod timings;

#[cfg(test)]
pub(crate) use timings::resident;

use std::time::Duration;

use chiaro_compiler::syntax::Severity;
use egui::{RichText, Ui};

use crate::app::Editor;
use crate::settings::Panel;

/// What the panels remember.
#[derive(Default)]
pub(crate) struct Panels {
    parameters: parameters::Parameters,
    solids: solids::Solids,
    shader: shader::ShaderText,
    timings: timings::History,
}

/// Shows the panel that is chosen.
pub(crate) fn show(editor: &mut Editor, ui: &mut Ui) {
    ui.add_space(2.0);
    ui.horizontal_wrapped(|ui| {
        // All of them fit into one line of the panel as it is at first, even if there are hundreds of messages.
        ui.spacing_mut().item_spacing.x = 1.0;
        ui.spacing_mut().button_padding.x = 6.0;
        for panel in Panel::ALL {
            let name = name(editor, ui, panel);
            ui.selectable_value(&mut editor.settings.panel, panel, name);
        }
    });
    ui.separator();
    match editor.settings.panel {
        Panel::Parameters => parameters::show(editor, ui),
        Panel::Solids => solids::show(editor, ui),
        Panel::Messages => messages::show(editor, ui),
        Panel::Shader => shader::show(editor, ui),
        Panel::Timings => timings::show(editor, ui),
    }
}

/// Keeps up with what happens, whether the panels are shown or not: the window's last frame took so long.
pub(crate) fn follow(editor: &mut Editor, frame: Option<Duration>) {
    editor.panels.timings.note(editor.viewport.timings);
    frame.into_iter().for_each(|took| editor.panels.timings.note_window(took));
    parameters::follow(editor);
}

/// The tab's name. That of the messages counts what is wrong.
fn name(editor: &Editor, ui: &Ui, panel: Panel) -> RichText {
    let [errors, warnings] = messages::counts(editor);
    let (count, severity) = if errors > 0 { (errors, Severity::Error) } else { (warnings, Severity::Warning) };
    match panel {
        Panel::Messages if count > 0 => {
            RichText::new(format!("{} {count}", panel.name())).color(messages::color(ui.visuals(), severity))
        }
        _ => RichText::new(panel.name()),
    }
}

#[cfg(test)]
impl Panels {
    /// Whether the tree of solids has such a node.
    pub(crate) fn lists(&self, what: &str) -> bool {
        self.solids.lists(what)
    }

    /// The code in the shader panel.
    pub(crate) fn shader_text(&self) -> &str {
        self.shader.text()
    }

    /// Shows it in another language.
    pub(crate) fn set_language(&mut self, language: chiaro_compiler::export::Language) {
        self.shader.set_language(language);
    }

    /// The lines of it that are marked.
    pub(crate) fn marked_lines(&self) -> Vec<&str> {
        self.shader.marked()
    }
}
