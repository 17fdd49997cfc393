//! What one can ask the editor to do by a menu or by a key.

use egui::{Context, Key, KeyboardShortcut, Modifiers, ViewportCommand};

use crate::app::Editor;
use crate::dialogs::export::Export;
use crate::dialogs::record::Record;
use crate::document::UNTITLED;
use crate::settings::Panel;
use crate::text::Command as TextCommand;

/// A thing to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Command {
    New,
    Open,
    Save,
    SaveAs,
    SaveAll,
    Close,
    Export,
    Screenshot,
    Record,
    Quit,
    Text(TextCommand),
    FrameAll,
    FrameSelection,
    Play,
    TogglePanel,
    LargerText,
    SmallerText,
    Keys,
}

const CTRL: Modifiers = Modifiers::COMMAND;
const CTRL_SHIFT: Modifiers = Modifiers { shift: true, ..Modifiers::COMMAND };

impl Command {
    /// All of them, in the order of the menus.
    pub(crate) const ALL: [Command; 26] = [
        Command::New,
        Command::Open,
        Command::Save,
        Command::SaveAs,
        Command::SaveAll,
        Command::Close,
        Command::Export,
        Command::Screenshot,
        Command::Record,
        Command::Quit,
        Command::Text(TextCommand::Undo),
        Command::Text(TextCommand::Redo),
        Command::Text(TextCommand::Find),
        Command::Text(TextCommand::Replace),
        Command::Text(TextCommand::GoToLine),
        Command::Text(TextCommand::Definition),
        Command::Text(TextCommand::Back),
        Command::Text(TextCommand::ToggleComment),
        Command::Text(TextCommand::Format),
        Command::FrameAll,
        Command::FrameSelection,
        Command::Play,
        Command::TogglePanel,
        Command::LargerText,
        Command::SmallerText,
        Command::Keys,
    ];

    /// As the menus name it. Three dots promise a question.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Command::New => "New",
            Command::Open => "Open…",
            Command::Save => "Save",
            Command::SaveAs => "Save as…",
            Command::SaveAll => "Save all",
            Command::Close => "Close",
            Command::Export => "Export…",
            Command::Screenshot => "Screenshot…",
            Command::Record => "Record…",
            Command::Quit => "Quit",
            Command::Text(command) => command.name(),
            Command::FrameAll => "Frame all",
            Command::FrameSelection => "Frame selection",
            Command::Play => "Play or pause $t",
            Command::TogglePanel => "Panels",
            Command::LargerText => "Larger text",
            Command::SmallerText => "Smaller text",
            Command::Keys => "Keys",
        }
    }

    /// The key for it.
    pub(crate) fn shortcut(self) -> Option<KeyboardShortcut> {
        let shortcut = |modifiers, key| Some(KeyboardShortcut::new(modifiers, key));
        match self {
            Command::New => shortcut(CTRL, Key::N),
            Command::Open => shortcut(CTRL, Key::O),
            Command::Save => shortcut(CTRL, Key::S),
            Command::SaveAs => shortcut(CTRL_SHIFT, Key::S),
            Command::SaveAll => shortcut(CTRL | Modifiers::ALT, Key::S),
            Command::Close => shortcut(CTRL, Key::W),
            Command::Export => shortcut(CTRL, Key::E),
            Command::Screenshot => shortcut(CTRL_SHIFT, Key::E),
            Command::Record => shortcut(CTRL_SHIFT, Key::R),
            Command::Quit => shortcut(CTRL, Key::Q),
            Command::Text(command) => command.shortcut(),
            Command::FrameAll => shortcut(Modifiers::NONE, Key::F6),
            Command::FrameSelection => shortcut(Modifiers::NONE, Key::F7),
            Command::Play => shortcut(Modifiers::NONE, Key::F5),
            Command::TogglePanel => shortcut(CTRL, Key::B),
            Command::LargerText => shortcut(CTRL, Key::Plus),
            Command::SmallerText => shortcut(CTRL, Key::Minus),
            Command::Keys => shortcut(Modifiers::NONE, Key::F1),
        }
    }

    /// Whether it can be done now.
    pub(crate) fn is_possible(self, editor: &Editor) -> bool {
        let session = &editor.session;
        match self {
            Command::Text(TextCommand::Undo) => session.active().history.can_undo(),
            Command::Text(TextCommand::Redo) => session.active().history.can_redo(),
            Command::SaveAll => session.documents().iter().any(|document| document.is_modified()),
            Command::Export | Command::Screenshot | Command::Record => session.shown.is_some(),
            Command::FrameSelection => editor.viewport.selection.is_some(),
            _ => true,
        }
    }

    /// Does it.
    pub(crate) fn run(self, editor: &mut Editor, context: &Context) {
        match self {
            Command::New => {
                editor.gallery.is_left = true;
                editor.session.open_text(UNTITLED, String::new());
                editor.text.wants_focus = true;
            }
            Command::Open => editor.dialogs.files.choose_to_open(context),
            Command::Save => editor.save_active(context, false),
            Command::SaveAs => editor.save_active(context, true),
            Command::SaveAll => editor.save_all(context),
            Command::Close => editor.ask_to_close(editor.session.active_index()),
            Command::Export => editor.dialogs.open(Export::of_scene(editor)),
            Command::Screenshot => editor.dialogs.open(Export::of_picture(editor)),
            Command::Record => editor.dialogs.open(Record::new(editor)),
            Command::Quit => {
                if editor.may_quit() {
                    context.send_viewport_cmd(ViewportCommand::Close);
                }
            }
            Command::Text(command) => editor.text_command(command),
            Command::FrameAll => editor.viewport.frame_all(),
            Command::FrameSelection => crate::viewport::frame_selection(editor),
            Command::Play => editor.clock.toggle(),
            Command::TogglePanel => editor.settings.shows_panel = !editor.settings.shows_panel,
            Command::LargerText => editor.settings.scale_text(1.0),
            Command::SmallerText => editor.settings.scale_text(-1.0),
            Command::Keys => editor.dialogs.shows_keys = true,
        }
    }
}

impl Editor {
    /// Shows one of the panels at the right.
    pub(crate) fn show_panel(&mut self, panel: Panel) {
        (self.settings.panel, self.settings.shows_panel) = (panel, true);
    }
}
