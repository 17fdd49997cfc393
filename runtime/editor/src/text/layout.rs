//! The text laid out in rows and colours.
//!
//! Theory: what is written on a page of text is the same from frame to frame, and after an edit all but a line or two is.
//! Practice: rows are laid out one by one and kept by what is written in them, in which colours. The page is put together
//! anew only if the text changed. Lines are not wrapped; but a line of more letters than any window shows, as dumps have
//! them, is broken into rows, so that what is out of sight costs nothing.

use std::collections::HashMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::ops::Range;
use std::sync::Arc;

use chiaro_assist::{Highlight, Kind, highlight};
use egui::text::{CCursor, LayoutJob, LayoutSection, TextFormat};
use egui::{Color32, FontId, Galley, Pos2, Rect, Ui, Vec2, pos2};

use super::colors;

/// The most letters of a row, in bytes.
const MOST_IN_ROW: usize = 600;

/// So many bytes can be read through at every frame.
const SMALL: usize = 200_000;

/// A text of more bytes is not coloured: laying out a row takes as long as it has colours, and all rows are.
const MOST_COLORED: usize = 300_000;

/// A text as it is laid out.
pub(crate) struct Layout {
    text: String,
    /// Grows when the text changes.
    version: u64,
    look: Option<Look>,
    /// A letter, whose galley changes when egui forgets what it drew.
    probe: Option<Arc<Galley>>,
    galley: Arc<Galley>,
    rows: Vec<Row>,
    lines: usize,
    /// The rows by what is in them.
    known: HashMap<u64, Arc<Galley>>,
}

impl Default for Layout {
    fn default() -> Self {
        Self {
            text: String::new(),
            version: 0,
            look: None,
            probe: None,
            galley: Arc::new(Galley::concat(Arc::default(), &[], 1.0)),
            rows: Vec::new(),
            lines: 0,
            known: HashMap::new(),
        }
    }
}

#[derive(Clone, PartialEq)]
struct Look {
    font: FontId,
    is_dark: bool,
    pixels_per_point: f32,
}

/// Where a row begins.
#[derive(Clone, Copy, Debug)]
struct Row {
    byte: usize,
    letter: usize,
    line: usize,
}

impl Layout {
    /// The text in rows and colours.
    pub(super) fn update(&mut self, ui: &Ui, text: &str, font: &FontId) -> Arc<Galley> {
        let look =
            Look { font: font.clone(), is_dark: ui.visuals().dark_mode, pixels_per_point: ui.pixels_per_point() };
        let probe = ui.fonts_mut(|fonts| fonts.layout_no_wrap("0".to_owned(), font.clone(), Color32::WHITE));
        let is_new_atlas = self.probe.as_ref().is_none_or(|before| !Arc::ptr_eq(before, &probe));
        self.probe = Some(probe);
        if is_new_atlas || self.look.as_ref() != Some(&look) {
            self.known.clear();
        } else if self.text == text {
            return self.galley.clone();
        }
        if self.text != text {
            self.version += 1;
            text.clone_into(&mut self.text);
        }
        self.lay_out(ui, &look);
        self.look = Some(look);
        self.galley.clone()
    }

    fn lay_out(&mut self, ui: &Ui, look: &Look) {
        let highlights = if self.text.len() <= MOST_COLORED { highlight(&self.text) } else { Vec::new() };
        let mut writer =
            Writer { ui, look, highlights: &highlights, next: 0, before: &self.known, after: HashMap::new() };
        let (mut rows, mut galleys, mut is_end) = (Vec::new(), Vec::new(), Vec::new());
        let (mut byte, mut letter) = (0, 0);
        let mut line_count = 0;
        for (line, content) in self.text.split('\n').enumerate() {
            for piece in pieces(content) {
                rows.push(Row { byte, letter, line });
                galleys.push(writer.row(piece, byte));
                is_end.push(false);
                byte += piece.len();
                letter += piece.chars().count();
            }
            if let Some(last) = is_end.last_mut() {
                *last = true;
            }
            byte += 1;
            letter += 1;
            line_count = line + 1;
        }
        self.known = writer.after;
        // A galley whose text has no sections would count as empty.
        let job = LayoutJob::simple(self.text.clone(), look.font.clone(), Color32::WHITE, f32::INFINITY);
        let job = Arc::new(job);
        let mut galley = Galley::concat(job, &galleys, look.pixels_per_point);
        let last = galley.rows.len().saturating_sub(1);
        for (at, row) in galley.rows.iter_mut().enumerate() {
            row.ends_with_newline = at < last && is_end[at];
        }
        (self.rows, self.galley, self.lines) = (rows, Arc::new(galley), line_count);
    }

    pub(super) fn version(&self) -> u64 {
        self.version
    }

    /// Whether the text is short enough to be read through at every frame.
    pub(super) fn is_small(&self) -> bool {
        self.text.len() < SMALL
    }

    pub(super) fn line_count(&self) -> usize {
        self.lines
    }

    /// The line of a byte, counted from 0.
    pub(super) fn line_of(&self, byte: usize) -> usize {
        self.rows.get(self.row_of(byte)).map_or(0, |row| row.line)
    }

    /// The bytes of a line, without its end.
    pub(super) fn line(&self, line: usize) -> Range<usize> {
        let first = self.rows.partition_point(|row| row.line < line);
        let start = self.rows.get(first).map_or(self.text.len(), |row| row.byte);
        let next = self.rows.partition_point(|row| row.line <= line);
        let end = self.rows.get(next).map_or(self.text.len(), |row| row.byte - 1);
        start..end.max(start)
    }

    /// Where the lines are that cross a part of the page: number, top and bottom.
    pub(super) fn lines_between(&self, top: f32, bottom: f32) -> impl Iterator<Item = (usize, Rect)> {
        let rows = &self.galley.rows;
        let first = rows.partition_point(|row| row.max_y() < top);
        let crossing = rows[first..].iter().zip(&self.rows[first..]).enumerate();
        let crossing = crossing.take_while(move |(_, (row, _))| row.min_y() <= bottom);
        let starts = crossing.filter(move |(at, (_, row))| {
            let before = (first + at).checked_sub(1).map(|before| self.rows[before].line);
            before != Some(row.line)
        });
        starts.map(|(_, (placed, row))| (row.line, placed.rect()))
    }

    /// The caret at a byte, as egui counts it.
    pub(super) fn cursor(&self, byte: usize) -> CCursor {
        let Some(row) = self.rows.get(self.row_of(byte)) else { return CCursor::default() };
        let before = self.text.get(row.byte..byte).map_or(0, |before| before.chars().count());
        CCursor { index: (row.letter + before).into(), prefer_next_row: true }
    }

    /// The byte of a caret.
    pub(super) fn byte(&self, cursor: CCursor) -> usize {
        let letter = cursor.index.0;
        let row = self.rows.partition_point(|row| row.letter <= letter).saturating_sub(1);
        let Some(row) = self.rows.get(row) else { return 0 };
        let mut rest = self.text[row.byte..].char_indices();
        rest.nth(letter - row.letter).map_or(self.text.len(), |(at, _)| row.byte + at)
    }

    /// The byte of the letter at a place of the page, if there is one.
    pub(super) fn byte_at(&self, place: Vec2) -> Option<usize> {
        let at = self.galley.rows.partition_point(|row| row.max_y() <= place.y);
        let (placed, row) = (self.galley.rows.get(at)?, self.rows.get(at)?);
        if place.y < placed.min_y() || !(0.0..placed.size.x).contains(&place.x) {
            return None;
        }
        let column = placed.glyphs.iter().position(|glyph| place.x < glyph.max_x())?;
        self.text[row.byte..].char_indices().nth(column).map(|(at, _)| row.byte + at)
    }

    /// The place of the caret at a byte.
    pub(super) fn caret(&self, byte: usize) -> Rect {
        let at = self.row_of(byte);
        let Some(placed) = self.galley.rows.get(at) else { return Rect::ZERO };
        let x = self.x(at, byte);
        Rect::from_min_max(pos2(x, placed.min_y()), pos2(x, placed.max_y()))
    }

    /// The rectangles of a range, one for each row, as far as they cross the part of the page between two heights.
    pub(super) fn rects(&self, range: &Range<usize>, top: f32, bottom: f32) -> Vec<Rect> {
        let visible =
            |at: usize| self.galley.rows.get(at).is_some_and(|row| row.max_y() >= top && row.min_y() <= bottom);
        let first_visible = self.galley.rows.partition_point(|row| row.max_y() < top);
        let (first, last) = (self.row_of(range.start).max(first_visible), self.row_of(range.end));
        (first..=last).take_while(|at| visible(*at)).map(|at| self.part_of_row(at, range)).collect()
    }

    /// The part of a row that is in a range.
    fn part_of_row(&self, at: usize, range: &Range<usize>) -> Rect {
        let placed = &self.galley.rows[at];
        let left = if range.start <= self.rows[at].byte { 0.0 } else { self.x(at, range.start) };
        let goes_on = self.rows.get(at + 1).is_some_and(|next| next.byte <= range.end);
        let right = if goes_on { placed.size.x } else { self.x(at, range.end) };
        Rect::from_min_max(Pos2::new(left, placed.min_y()), Pos2::new(right.max(left), placed.max_y()))
    }

    fn x(&self, row: usize, byte: usize) -> f32 {
        let column = self.text.get(self.rows[row].byte..byte).map_or(0, |before| before.chars().count());
        self.galley.rows[row].x_offset(column.into())
    }

    fn row_of(&self, byte: usize) -> usize {
        self.rows.partition_point(|row| row.byte <= byte).saturating_sub(1)
    }
}

/// A line's rows: all of it, unless it is very long.
fn pieces(line: &str) -> impl Iterator<Item = &str> {
    let mut rest = Some(line);
    std::iter::from_fn(move || {
        let line = rest?;
        if line.len() <= MOST_IN_ROW {
            rest = None;
            return Some(line);
        }
        let most = (0..=MOST_IN_ROW).rev().find(|at| line.is_char_boundary(*at))?;
        let (piece, after) = line.split_at(line[..most].rfind(' ').map_or(most, |space| space + 1));
        rest = Some(after);
        Some(piece)
    })
}

/// Lays out rows from the first to the last.
struct Writer<'a> {
    ui: &'a Ui,
    look: &'a Look,
    highlights: &'a [Highlight],
    /// The first highlight that reaches beyond the rows that are written.
    next: usize,
    before: &'a HashMap<u64, Arc<Galley>>,
    after: HashMap<u64, Arc<Galley>>,
}

impl Writer<'_> {
    /// The row of a text that begins at a byte.
    fn row(&mut self, text: &str, start: usize) -> Arc<Galley> {
        let parts = self.parts(text, start);
        let mut hasher = DefaultHasher::new();
        (text, &parts).hash(&mut hasher);
        let key = hasher.finish();
        let known = self.after.get(&key).or_else(|| self.before.get(&key)).cloned();
        let galley = known.unwrap_or_else(|| self.written(text, &parts));
        self.after.insert(key, galley.clone());
        galley
    }

    /// The row's parts: where each ends, and what it is.
    fn parts(&mut self, text: &str, start: usize) -> Vec<(usize, Option<Kind>)> {
        let end = start + text.len();
        while self.highlights.get(self.next).is_some_and(|highlight| highlight.range.end <= start) {
            self.next += 1;
        }
        let mut parts = Vec::new();
        let mut done = start;
        for highlight in self.highlights[self.next..].iter().take_while(|highlight| highlight.range.start < end) {
            if highlight.range.start > done {
                parts.push((highlight.range.start - start, None));
            }
            done = highlight.range.end.min(end);
            parts.push((done - start, Some(highlight.kind)));
        }
        if done < end || parts.is_empty() {
            parts.push((text.len(), None));
        }
        parts
    }

    fn written(&self, text: &str, parts: &[(usize, Option<Kind>)]) -> Arc<Galley> {
        let mut job = LayoutJob { text: text.to_owned(), keep_trailing_whitespace: true, ..LayoutJob::default() };
        job.wrap.max_width = f32::INFINITY;
        job.break_on_newline = false;
        let mut start = 0;
        for (end, kind) in parts {
            let color = colors::of_kind(kind.unwrap_or(Kind::Variable), self.look.is_dark);
            let mut format = TextFormat::simple(self.look.font.clone(), color);
            format.italics = *kind == Some(Kind::Comment);
            job.sections.push(LayoutSection { leading_space: 0.0, byte_range: start.into()..(*end).into(), format });
            start = *end;
        }
        self.ui.fonts_mut(|fonts| fonts.layout_job(job))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_very_long_lines_are_broken() {
        assert_eq!(pieces("").collect::<Vec<_>>(), [""]);
        assert_eq!(pieces("cube(1);").collect::<Vec<_>>(), ["cube(1);"]);
        let long = "[1, 2, é] ".repeat(1000);
        assert!(pieces(&long).all(|piece| piece.len() <= MOST_IN_ROW));
        assert_eq!(pieces(&long).collect::<String>(), long);
        let solid = "é".repeat(1000);
        assert_eq!(pieces(&solid).collect::<String>(), solid);
    }

    /// Runs a closure with a page.
    fn on_page(text: &str, look: impl Fn(&Layout)) {
        egui::__run_test_ui(|ui| {
            let mut layout = Layout::default();
            layout.update(ui, text, &FontId::monospace(14.0));
            look(&layout);
        });
    }

    #[test]
    fn bytes_and_carets_correspond() {
        let text = format!("a = \"é\";\n\n/* two\nlines */ cube({});\n", "1234 + ".repeat(200));
        on_page(&text, |layout| {
            for (at, _) in text.char_indices() {
                assert_eq!(layout.byte(layout.cursor(at)), at, "{at}");
            }
            assert_eq!(layout.byte(layout.cursor(text.len())), text.len());
            assert_eq!(layout.line_count(), 5);
            assert_eq!((layout.line(0), layout.line(1), layout.line(4)), (0..9, 10..10, text.len()..text.len()));
            assert_eq!((layout.line_of(10), layout.line_of(20), layout.line_of(text.len())), (1, 3, 4));
        });
    }

    #[test]
    fn letters_are_found_where_they_are() {
        on_page("cube(10);\n  sphere(é);", |layout| {
            let place = |byte: usize| layout.caret(byte).center().to_vec2() + Vec2::new(1.0, 0.0);
            for byte in [0, 5, 8, 12, 19, 21] {
                assert_eq!(layout.byte_at(place(byte)), Some(byte));
            }
            assert_eq!(layout.byte_at(Vec2::new(500.0, 3.0)), None);
            assert_eq!(layout.byte_at(Vec2::new(3.0, 500.0)), None);
            assert_eq!(layout.rects(&(5..14), 0.0, 1000.0).len(), 2);
        });
    }
}
