//! What is kept from one session to the next.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

/// How many files the list of recent ones has.
const MOST_RECENT: usize = 12;
/// The least and the greatest size of the text, in points.
const TEXT_SIZES: [f32; 2] = [8.0, 40.0];

/// What the user chose, and where they were.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct Settings {
    pub(crate) theme: Theme,
    /// Files opened lately, the newest first.
    pub(crate) recent: Vec<PathBuf>,
    /// The files that were open.
    pub(crate) open: Vec<PathBuf>,
    /// The one of them that was drawn.
    pub(crate) drawn: Option<PathBuf>,
    pub(crate) panel: Panel,
    pub(crate) shows_panel: bool,
    /// In points.
    pub(crate) text_size: f32,
    pub(crate) samples: u32,
}

/// Light or dark.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum Theme {
    /// As the system's windows are.
    #[default]
    System,
    Light,
    Dark,
}

/// What the panel at the right shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum Panel {
    #[default]
    Parameters,
    Solids,
    Messages,
    Shader,
    Timings,
}

impl Panel {
    /// All of them, in the order of their tabs.
    pub(crate) const ALL: [Panel; 5] =
        [Panel::Parameters, Panel::Solids, Panel::Messages, Panel::Shader, Panel::Timings];

    /// As its tab says.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Panel::Parameters => "Parameters",
            Panel::Solids => "Solids",
            Panel::Messages => "Messages",
            Panel::Shader => "Shader",
            Panel::Timings => "Timings",
        }
    }
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            theme: Theme::System,
            recent: Vec::new(),
            open: Vec::new(),
            drawn: None,
            panel: Panel::Parameters,
            shows_panel: true,
            text_size: 14.0,
            samples: 64,
        }
    }
}

impl Settings {
    /// Makes the text larger or smaller, by points.
    pub(crate) fn scale_text(&mut self, by: f32) {
        self.text_size = (self.text_size + by).clamp(TEXT_SIZES[0], TEXT_SIZES[1]);
    }

    /// Remembers that a file was opened.
    pub(crate) fn opened(&mut self, path: &Path) {
        self.recent.retain(|recent| recent != path);
        self.recent.insert(0, path.to_owned());
        self.recent.truncate(MOST_RECENT);
    }
}
