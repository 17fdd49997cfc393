//! The strings that OpenSCAD writes raw into its dumps.
//!
//! A dump's `text` node says `text = "a"b", size = 10, …` for a text with a quotation mark: nothing is escaped.
//! Such strings are told from those of hand-written scenes by the arguments that a dump always puts behind them.

use nom::bytes::complete::{tag, take_till1};
use nom::combinator::recognize;
use nom::{IResult, Parser as _};

use crate::token::TokenKind;

/// What follows the text's closing quote in a dump.
const BEHIND_TEXT: &str = "\", size = ";
/// What follows the font's closing quote in a dump.
const BEHIND_FONT: &str = "\", direction = \"";
/// What ends every node without children in a dump.
const END_OF_NODE: &str = ");\n";

/// Which tokens of a `text(text = "` have been seen.
#[derive(Clone, Copy, Default, PartialEq)]
enum Progress {
    #[default]
    Nothing,
    Module,
    Opened,
    /// Behind `text` as an argument.
    Named,
    /// Behind `text =`: the next string may be raw.
    Expected,
    /// Behind a raw text, up to the node's end: its font is raw too.
    InNode,
    Font,
    FontExpected,
}

/// Finds the strings of a dump that are raw.
#[derive(Default)]
pub(super) struct RawStrings {
    progress: Progress,
    text_end: Occurrence,
    font_end: Occurrence,
    node_end: Occurrence,
}

impl RawStrings {
    /// Takes note of a token. To be called for each one.
    pub(super) fn see(&mut self, word: &str, kind: TokenKind) {
        self.progress = match (self.progress, kind) {
            (Progress::Expected | Progress::InNode | Progress::FontExpected, TokenKind::RawString) => Progress::InNode,
            (Progress::InNode, TokenKind::CloseParenthesis) => Progress::Nothing,
            (Progress::InNode, TokenKind::Name) if word == "font" => Progress::Font,
            (Progress::Font, TokenKind::Assign) => Progress::FontExpected,
            (Progress::InNode | Progress::Font | Progress::FontExpected, _) => Progress::InNode,
            (Progress::Opened, TokenKind::Name) if word == "text" => Progress::Named,
            (_, TokenKind::Name) if word == "text" => Progress::Module,
            (Progress::Module, TokenKind::OpenParenthesis) => Progress::Opened,
            (Progress::Named, TokenKind::Assign) => Progress::Expected,
            _ => Progress::Nothing,
        };
    }

    /// The length, quotes included, of the raw string at `start` of `text`, if there is one.
    pub(super) fn length(&mut self, text: &str, start: usize) -> Option<usize> {
        let (end, marker) = match self.progress {
            Progress::Expected => (&mut self.text_end, BEHIND_TEXT),
            Progress::FontExpected => (&mut self.font_end, BEHIND_FONT),
            _ => return None,
        };
        let closing = end.at_or_after(start + 1, text, marker);
        let behind = closing + marker.len();
        if closing >= self.node_end.at_or_after(start, text, END_OF_NODE) {
            return None;
        }
        let is_raw = self.progress == Progress::FontExpected || dumped_arguments(text.get(behind..)?).is_ok();
        is_raw.then_some(closing + 1 - start)
    }
}

/// What a dump writes behind `size = `.
fn dumped_arguments(text: &str) -> IResult<&str, &str> {
    let number = || take_till1(|character| ",)\n".contains(character));
    recognize((number(), tag(", spacing = "), number(), tag(", font = \""))).parse(text)
}

/// The next place of a fixed text. Asked for ever later places, it searches the whole text once.
#[derive(Default)]
struct Occurrence {
    known: Option<usize>,
}

impl Occurrence {
    /// The first occurrence of `pattern` at or behind `from`; the length of the text if there is none.
    fn at_or_after(&mut self, from: usize, text: &str, pattern: &str) -> usize {
        match self.known {
            Some(place) if place >= from => place,
            _ => {
                let place = text.get(from..).and_then(|rest| rest.find(pattern)).map_or(text.len(), |at| from + at);
                *self.known.insert(place)
            }
        }
    }
}
