//! The menu bar and the keyboard's short cuts.

use std::path::PathBuf;

use egui::{Button, Context, Event, Key, Ui};

use crate::app::Editor;
use crate::command::Command;
use crate::gallery::EXAMPLES;
use crate::settings::{Panel, Theme};
use crate::viewport;

/// Shows the bar.
pub(crate) fn show(editor: &mut Editor, ui: &mut Ui) {
    egui::MenuBar::new().ui(ui, |ui| {
        ui.menu_button("File", |ui| file(editor, ui));
        ui.menu_button("Edit", |ui| {
            use crate::text::Command::{Back, Definition, Find, Format, GoToLine, Redo, Replace, ToggleComment, Undo};
            for group in [&[Undo, Redo][..], &[Find, Replace], &[GoToLine, Definition, Back], &[ToggleComment, Format]]
            {
                if group[0] != Undo {
                    ui.separator();
                }
                items(editor, ui, &group.iter().copied().map(Command::Text).collect::<Vec<_>>());
            }
        });
        ui.menu_button("View", |ui| view(editor, ui));
        ui.menu_button("Help", |ui| items(editor, ui, &[Command::Keys]));
    });
}

/// Does what the keys ask for, but for those of the text, which sees to them itself.
pub(crate) fn shortcuts(editor: &mut Editor, context: &Context) {
    if editor.dialogs.is_blocking() {
        return;
    }
    if !editor.text.is_behind() {
        for command in std::mem::take(&mut editor.postponed) {
            run(editor, context, command);
        }
    }
    // Of short cuts that differ by a modifier, the one with more of them is looked for first.
    let is_own = |command: &Command| !matches!(command, Command::Text(_));
    let own = Command::ALL.into_iter().filter(is_own);
    let mut commands: Vec<_> = own.filter_map(|command| Some((command, command.shortcut()?))).collect();
    commands.sort_by_key(|(_, shortcut)| {
        let modifiers = shortcut.modifiers;
        std::cmp::Reverse(u8::from(modifiers.shift) + u8::from(modifiers.alt) + u8::from(modifiers.command))
    });
    for (command, shortcut) in commands {
        let is_allowed = !editor.only_picture || matches!(command, Command::Quit | Command::FrameAll | Command::Play);
        let is_late = context.input(|input| follows_text(&input.events, shortcut.logical_key));
        if !is_allowed || !context.input_mut(|input| input.consume_shortcut(&shortcut)) {
            continue;
        }
        if is_late || editor.text.is_behind() {
            editor.postponed.push(command);
            context.request_repaint();
        } else {
            run(editor, context, command);
        }
    }
}

fn run(editor: &mut Editor, context: &Context, command: Command) {
    if command.is_possible(editor) {
        command.run(editor, context);
    }
}

/// Whether something was typed before a key was pressed, in a frame that sees both: then that is to be in the text first.
fn follows_text(events: &[Event], shortcut: Key) -> bool {
    let is_pressed = |event: &Event| matches!(event, Event::Key { key, pressed: true, .. } if *key == shortcut);
    let before = events.iter().position(is_pressed).map_or(&[][..], |at| &events[..at]);
    before.iter().any(|event| matches!(event, Event::Text(_) | Event::Paste(_)))
}

fn items(editor: &mut Editor, ui: &mut Ui, commands: &[Command]) {
    for command in commands {
        let mut button = Button::new(command.name());
        if let Some(shortcut) = command.shortcut() {
            button = button.shortcut_text(ui.ctx().format_shortcut(&shortcut));
        }
        if ui.add_enabled(command.is_possible(editor), button).clicked() {
            command.run(editor, ui.ctx());
        }
    }
}

fn file(editor: &mut Editor, ui: &mut Ui) {
    items(editor, ui, &[Command::New, Command::Open]);
    ui.menu_button("Open recent", |ui| {
        let recent: Vec<PathBuf> = editor.settings.recent.clone();
        if recent.is_empty() {
            ui.weak("nothing yet");
        }
        for path in recent {
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            if ui.button(name).on_hover_text(path.display().to_string()).clicked() {
                editor.open(&path);
            }
        }
    });
    ui.menu_button("Examples", |ui| {
        egui::ScrollArea::vertical().max_height(480.0).show(ui, |ui| {
            for example in EXAMPLES {
                if ui.button(example.title()).on_hover_text(example.description()).clicked() {
                    editor.open_example(example);
                }
            }
        });
    });
    ui.separator();
    items(editor, ui, &[Command::Save, Command::SaveAs, Command::SaveAll]);
    ui.separator();
    items(editor, ui, &[Command::Export, Command::Screenshot, Command::Record]);
    ui.separator();
    items(editor, ui, &[Command::Close, Command::Quit]);
}

fn view(editor: &mut Editor, ui: &mut Ui) {
    ui.menu_button("Look from", |ui| viewport::views(editor, ui));
    ui.menu_button("Show", |ui| viewport::looks(editor, ui));
    items(editor, ui, &[Command::FrameAll, Command::FrameSelection, Command::Play]);
    ui.separator();
    ui.checkbox(&mut editor.settings.shows_panel, "Panels");
    ui.menu_button("Panel", |ui| {
        for panel in Panel::ALL {
            let is_shown = editor.settings.shows_panel && editor.settings.panel == panel;
            if ui.radio(is_shown, panel.name()).clicked() {
                editor.show_panel(panel);
            }
        }
    });
    ui.separator();
    ui.menu_button("Theme", |ui| {
        for (theme, name) in [(Theme::System, "System"), (Theme::Light, "Light"), (Theme::Dark, "Dark")] {
            ui.radio_value(&mut editor.settings.theme, theme, name);
        }
    });
    items(editor, ui, &[Command::LargerText, Command::SmallerText]);
}
