//! The printer: a tree back to text, well formatted.
//!
//! Reading what it prints gives the same tree again, up to places in the text.

use crate::tree::File;

mod customizer;
mod expression;
mod statement;

/// The width that lines are broken at where they can be, in characters.
const WIDTH: usize = 100;

/// The deepest indentation, which bounds the length of what is printed for trees that are very deep.
const MAX_INDENTATION: usize = 16;

/// Prints a file. Of comments, those that say what values a parameter may take are printed.
pub fn print(file: &File) -> String {
    let mut printer = Printer::default();
    printer.file(&file.statements);
    printer.text
}

/// What has been printed so far.
#[derive(Default)]
struct Printer {
    text: String,
    /// Where the current line begins.
    line_start: usize,
    indentation: usize,
    /// Where the text has to end while something is tried on one line.
    limit: Option<usize>,
    /// Whether that has failed.
    overflows: bool,
    /// Whether a `{` has been printed. No assignment behind one is a parameter.
    brace_seen: bool,
    /// The Customizer group that has been opened.
    group: Option<String>,
}

impl Printer {
    fn write(&mut self, text: &str) {
        match self.limit {
            Some(limit) if self.text.len() + text.len() > limit => self.overflows = true,
            _ => self.text.push_str(text),
        }
    }

    fn line_break(&mut self) {
        self.text.push('\n');
        self.line_start = self.text.len();
        for _ in 0..self.indentation.min(MAX_INDENTATION) {
            self.text.push_str("    ");
        }
    }

    /// Leaves a line blank, unless there is nothing above or a blank line already. The current line is empty.
    fn blank_line(&mut self) {
        if !self.text.is_empty() && !self.text.ends_with("\n\n") {
            self.line_break();
        }
    }

    /// Prints on one line what fits on one, or else the other way.
    fn on_one_line_or(&mut self, on_one_line: impl FnOnce(&mut Self), otherwise: impl FnOnce(&mut Self)) {
        if self.limit.is_some() {
            on_one_line(self);
            return;
        }
        let start = self.text.len();
        self.limit = Some(self.line_start + WIDTH);
        on_one_line(self);
        self.limit = None;
        if std::mem::take(&mut self.overflows) {
            self.text.truncate(start);
            otherwise(self);
        }
    }

    /// Prints items with commas between, on one line if they fit, or else each on its own.
    fn list<T>(&mut self, open: &str, items: &[T], close: &str, print: impl Fn(&mut Self, &T)) {
        self.write(open);
        self.on_one_line_or(
            |printer| {
                for (index, item) in items.iter().enumerate() {
                    if printer.overflows {
                        return;
                    }
                    printer.write(if index > 0 { ", " } else { "" });
                    print(printer, item);
                }
                printer.write(close);
            },
            |printer| {
                printer.indentation += 1;
                for (index, item) in items.iter().enumerate() {
                    printer.line_break();
                    print(printer, item);
                    printer.write(if index + 1 < items.len() { "," } else { "" });
                }
                printer.indentation -= 1;
                printer.line_break();
                printer.write(close);
            },
        );
    }
}

#[cfg(test)]
mod tests;
