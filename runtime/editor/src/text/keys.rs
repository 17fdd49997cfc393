//! Which keys do what.

use egui::{Event, Key, KeyboardShortcut, Modifiers, Ui};

use super::commands::Command;

const NONE: Modifiers = Modifiers::NONE;
const SHIFT: Modifiers = Modifiers::SHIFT;
const ALT: Modifiers = Modifiers::ALT;
const CTRL: Modifiers = Modifiers::COMMAND;
const CTRL_SHIFT: Modifiers = Modifiers { shift: true, ..Modifiers::COMMAND };
const ALT_SHIFT: Modifiers = Modifiers { shift: true, ..Modifiers::ALT };

/// What holds wherever the keyboard's focus is.
const ANYWHERE: &[(Modifiers, Key, Command)] = &[
    (CTRL, Key::F, Command::Find),
    (CTRL, Key::H, Command::Replace),
    (NONE, Key::F3, Command::FindNext),
    (SHIFT, Key::F3, Command::FindPrevious),
    (CTRL, Key::G, Command::GoToLine),
    (CTRL, Key::Tab, Command::NextTab),
    (CTRL_SHIFT, Key::Tab, Command::PreviousTab),
    (CTRL, Key::PageDown, Command::NextTab),
    (CTRL, Key::PageUp, Command::PreviousTab),
    (CTRL_SHIFT, Key::I, Command::Format),
    (CTRL_SHIFT, Key::F, Command::Format),
    (ALT_SHIFT, Key::F, Command::Format),
];

/// What holds unless another field is being written in.
const NOT_IN_FIELDS: &[(Modifiers, Key, Command)] = &[
    (CTRL, Key::Z, Command::Undo),
    (CTRL_SHIFT, Key::Z, Command::Redo),
    (CTRL, Key::Y, Command::Redo),
    (NONE, Key::F12, Command::Definition),
    (ALT, Key::ArrowLeft, Command::Back),
];

/// What holds while the text is being written.
const IN_TEXT: &[(Modifiers, Key, Command)] = &[
    (CTRL, Key::Slash, Command::ToggleComment),
    (CTRL_SHIFT, Key::Slash, Command::ToggleComment),
    (NONE, Key::Tab, Command::Indent),
    (SHIFT, Key::Tab, Command::Unindent),
    (NONE, Key::Enter, Command::NewLine),
    (SHIFT, Key::Enter, Command::NewLine),
    (NONE, Key::Backspace, Command::Backspace),
    (CTRL, Key::D, Command::Duplicate),
    (ALT_SHIFT, Key::ArrowDown, Command::Duplicate),
    (CTRL_SHIFT, Key::K, Command::DeleteLines),
    (ALT, Key::ArrowUp, Command::MoveUp),
    (ALT, Key::ArrowDown, Command::MoveDown),
    (CTRL, Key::Space, Command::Complete),
    (CTRL, Key::Period, Command::QuickFix),
    (ALT, Key::Enter, Command::QuickFix),
];

/// Keys that mean something to text fields by themselves.
const EDITING: [Key; 12] = [
    Key::ArrowLeft,
    Key::ArrowRight,
    Key::ArrowUp,
    Key::ArrowDown,
    Key::Home,
    Key::End,
    Key::PageUp,
    Key::PageDown,
    Key::Backspace,
    Key::Delete,
    Key::Enter,
    Key::Escape,
];

/// Where the keyboard's focus is.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Focus {
    Text,
    /// A field of a bar, panel or dialog.
    Field,
    Nothing,
}

/// The first key for something.
pub(super) fn shortcut(command: Command) -> Option<KeyboardShortcut> {
    let mut rows = [ANYWHERE, NOT_IN_FIELDS, IN_TEXT].into_iter().flatten();
    rows.find(|row| row.2 == command).map(|(modifiers, key, _)| KeyboardShortcut::new(*modifiers, *key))
}

/// A key that means something to the page.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Pressed {
    Command(Command),
    /// A letter of the text, or several.
    Letter(String),
}

/// Takes what means something from what happened, in its order. What comes after something that only the text field can do,
/// such as moving the caret, has to wait until that is done: it is put aside, and happens in the next frame.
pub(super) fn take(ui: &Ui, focus: Focus, aside: &mut Vec<Event>) -> Vec<Pressed> {
    let mut pressed = Vec::new();
    let mut is_blocked = false;
    ui.input_mut(|input| {
        // Some systems write the letter of a key that is pressed together with Alt.
        let is_altered = input.modifiers.alt && !input.modifiers.ctrl;
        let happened = std::mem::take(aside).into_iter().chain(std::mem::take(&mut input.events));
        for event in happened {
            let taken = taken(&event, focus);
            if is_blocked && (taken.is_some() || is_for_field(&event)) {
                aside.push(event);
                continue;
            }
            match taken {
                Some(Pressed::Letter(_)) if is_altered && matches!(pressed.last(), Some(Pressed::Command(_))) => {}
                Some(taken) => pressed.push(taken),
                None => {
                    is_blocked |= focus == Focus::Text && is_for_field(&event);
                    input.events.push(event);
                }
            }
        }
    });
    if !aside.is_empty() {
        ui.ctx().request_repaint();
    }
    pressed
}

fn taken(event: &Event, focus: Focus) -> Option<Pressed> {
    match event {
        Event::Key { key, pressed: true, modifiers, .. } => meant(*key, *modifiers, focus).map(Pressed::Command),
        Event::Text(text) if focus == Focus::Text && !matches!(text.as_str(), "" | "\n" | "\r") => {
            Some(Pressed::Letter(text.clone()))
        }
        _ => None,
    }
}

/// Whether the text field does something about it that is not ours. A letter's key does nothing: the letter comes behind it.
fn is_for_field(event: &Event) -> bool {
    match event {
        Event::Key { key, pressed: true, modifiers, .. } => {
            modifiers.ctrl || modifiers.command || modifiers.alt || EDITING.contains(key)
        }
        Event::Paste(_) | Event::Cut | Event::Ime(_) => true,
        _ => false,
    }
}

fn meant(key: Key, modifiers: Modifiers, focus: Focus) -> Option<Command> {
    let tables =
        [Some(ANYWHERE), (focus != Focus::Field).then_some(NOT_IN_FIELDS), (focus == Focus::Text).then_some(IN_TEXT)];
    let mut rows = tables.into_iter().flatten().flatten();
    rows.find(|(pattern, other, _)| key == *other && modifiers.matches_exact(*pattern)).map(|row| row.2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_means_one_thing() {
        let all = [ANYWHERE, NOT_IN_FIELDS, IN_TEXT].concat();
        for (at, (modifiers, key, _)) in all.iter().enumerate() {
            assert!(!all[..at].iter().any(|(other, same, _)| (other, same) == (modifiers, key)), "{key:?}");
        }
    }

    #[test]
    fn other_fields_keep_their_own_undo() {
        let ctrl = Modifiers { ctrl: true, command: true, ..Modifiers::NONE };
        assert_eq!(meant(Key::Z, ctrl, Focus::Text), Some(Command::Undo));
        assert_eq!(meant(Key::Z, ctrl | Modifiers::SHIFT, Focus::Nothing), Some(Command::Redo));
        assert_eq!(meant(Key::Z, ctrl, Focus::Field), None);
        assert_eq!(meant(Key::F, ctrl, Focus::Field), Some(Command::Find));
        assert_eq!(meant(Key::Tab, Modifiers::NONE, Focus::Nothing), None);
    }
}
