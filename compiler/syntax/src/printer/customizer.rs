//! Printing Customizer comments.

use super::Printer;
use super::expression::number;
use crate::customizer::{HIDDEN, is_literal, is_number};
use crate::tree::{Assignment, Customizer, Domain};

impl Printer {
    /// Prints the comments above an assignment at the top level: those that make it a parameter, or prevent that.
    pub(super) fn comments_above(&mut self, assignment: &Assignment) {
        if self.brace_seen || !is_literal(&assignment.value) {
            return;
        }
        match &assignment.customizer {
            None => self.open_group(HIDDEN),
            Some(customizer) => {
                if let Some(group) = &customizer.group {
                    self.open_group(group);
                }
                if let Some(description) = &customizer.description {
                    self.write(&format!("// {description}"));
                    self.line_break();
                }
            }
        }
    }

    fn open_group(&mut self, group: &str) {
        if self.group.as_deref() != Some(group) {
            self.blank_line();
            self.write(&format!("/* [{group}] */"));
            self.line_break();
            self.group = Some(group.to_owned());
        }
    }

    /// Prints the comment behind an assignment.
    pub(super) fn comment_behind(&mut self, customizer: &Customizer) {
        let domain = match &customizer.domain {
            Domain::Any => return,
            Domain::Step(step) => number(*step),
            Domain::Range { min, step: None, max } => format!("[{}:{}]", number(*min), number(*max)),
            Domain::Range { min, step: Some(step), max } => {
                format!("[{}:{}:{}]", number(*min), number(*step), number(*max))
            }
            Domain::Choices(choices) => {
                let is_single = choices.len() == 1;
                let choices: Vec<_> = choices.iter().map(|choice| shown_choice(choice, is_single)).collect();
                format!("[{}]", choices.join(", "))
            }
        };
        self.write(&format!(" // {domain}"));
    }
}

/// A choice as its comment has it. A single number is quoted, since it would be a range.
fn shown_choice((value, label): &(String, Option<String>), is_single: bool) -> String {
    let value = match is_single && is_number(value) {
        true => format!("\"{value}\""),
        false => quoted_if(value, &[',', ':', ']']),
    };
    match label {
        Some(label) => format!("{value}:{}", quoted_if(label, &[',', ']'])),
        None => value,
    }
}

/// A text in quotes if it has blanks at its ends or any of the characters `ends`.
fn quoted_if(text: &str, ends: &[char]) -> String {
    if text.contains(ends) || text.trim() != text { format!("\"{text}\"") } else { text.to_owned() }
}
