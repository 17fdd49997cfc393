//! Customizer comments: which values a scene's parameters may take.
//!
//! The comments are no part of the grammar. They belong to assignments by the line they stand on, so they are found
//! by a second walk along the tokens, as far as the first `{`.

use crate::lexer::Lexer;
use crate::parser::Dialect;
use crate::token::{Token, TokenKind};
use crate::tree::{Assignment, Customizer, Domain, Element, Expression, ExpressionKind, Statement, UnaryOperator};

mod domain;

pub(crate) use domain::is_number;

/// The group whose parameters are not shown.
pub(crate) const HIDDEN: &str = "Hidden";

/// Fills in the Customizer comments of a file's statements, which are those of `text`.
pub(crate) fn attach(text: &str, statements: &mut [Statement]) {
    let mut walk = Walk::new(text);
    for statement in statements {
        let Statement::Assignment(assignment) = statement else { continue };
        if !walk.to(assignment.span.end) {
            return;
        }
        if is_literal(&assignment.value) && walk.group.as_deref() != Some(HIDDEN) {
            assignment.customizer = Some(Box::new(walk.customizer(assignment)));
        }
    }
}

/// Whether an expression is a literal, or a list of literals.
pub(crate) fn is_literal(expression: &Expression) -> bool {
    match &*expression.kind {
        ExpressionKind::Bool(_) | ExpressionKind::Number(_) | ExpressionKind::String(_) => true,
        ExpressionKind::Unary(UnaryOperator::Negate, operand) => matches!(*operand.kind, ExpressionKind::Number(_)),
        ExpressionKind::List(elements) => {
            elements.iter().all(|element| matches!(element, Element::Value(value) if is_literal(value)))
        }
        _ => false,
    }
}

/// A walk along the tokens, comments included.
struct Walk<'a> {
    text: &'a str,
    lexer: Lexer<'a>,
    /// The token to be walked over next.
    token: Token,
    /// The group of what is walked over.
    group: Option<String>,
    /// The last comment that has its line for itself.
    comment: Option<Token>,
    /// Where the last token ends.
    previous_end: usize,
}

impl<'a> Walk<'a> {
    fn new(text: &'a str) -> Self {
        // Where strings end can differ in dumps, but a dump has no assignments.
        let mut lexer = Lexer::new(text, Dialect::Program);
        let token = lexer.next();
        Self { text, lexer, token, group: None, comment: None, previous_end: 0 }
    }

    /// Walks up to `end`, unless there is a `{` before. Answers whether it got there.
    fn to(&mut self, end: u32) -> bool {
        while self.token.start < end {
            match self.token.kind {
                TokenKind::OpenBrace | TokenKind::End => return false,
                TokenKind::LineComment if self.begins_line(self.token.range().start) => self.comment = Some(self.token),
                TokenKind::BlockComment => {
                    if let Some(group) = group(&self.text[self.token.range()]) {
                        self.group = Some(group);
                    }
                }
                _ => {}
            }
            self.previous_end = self.token.range().end;
            self.token = self.lexer.next();
        }
        true
    }

    /// What the comments around an assignment say, which has just been walked over.
    fn customizer(&self, assignment: &Assignment) -> Customizer {
        let span = assignment.span.range();
        // A comment may also stand between the assignment's own lines.
        let before = self.comment.filter(|comment| comment.range().end <= span.start);
        let description = before.and_then(|comment| {
            let is_above = is_line_break(&self.text[comment.range().end..span.start]);
            let text = self.text[comment.range()].trim_start_matches('/').trim();
            (is_above && !text.is_empty()).then(|| text.to_owned())
        });
        let is_behind = self.token.kind == TokenKind::LineComment
            && !self.text[self.previous_end..self.token.range().start].contains('\n');
        let comment = if is_behind { &self.text[self.token.range()] } else { "" };
        let domain = domain::read(comment.trim_start_matches('/')).unwrap_or(Domain::Any);
        Customizer { domain, description, group: self.group.clone() }
    }

    /// Whether only white space stands before `place` on its line.
    fn begins_line(&self, place: usize) -> bool {
        self.previous_end == 0 || self.text[self.previous_end..place].contains('\n')
    }
}

/// Whether a text is one line break and perhaps spaces.
fn is_line_break(text: &str) -> bool {
    text.trim().is_empty() && text.matches('\n').count() == 1
}

/// The group that a block comment opens: `/* [Name] */` on one line. Several names become one.
fn group(comment: &str) -> Option<String> {
    if comment.contains('\n') {
        return None;
    }
    let names = comment.split('[').skip(1).filter_map(|part| part.split_once(']')).map(|(name, _)| name.trim());
    let names: Vec<_> = names.filter(|name| !name.is_empty()).collect();
    (!names.is_empty()).then(|| names.join("-"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::FileId;

    /// Name, domain, description and group of each parameter.
    fn parameters(text: &str) -> Vec<(String, Domain, Option<String>, Option<String>)> {
        let (file, diagnostics) = crate::parse(FileId(0), text, Dialect::Program);
        assert_eq!(diagnostics, []);
        let assignments = file.statements.into_iter().filter_map(|statement| match statement {
            Statement::Assignment(assignment) => Some(assignment),
            _ => None,
        });
        let parameters = assignments.filter_map(|assignment| Some((assignment.name.node, assignment.customizer?)));
        parameters
            .map(|(name, customizer)| (name.to_string(), customizer.domain, customizer.description, customizer.group))
            .collect()
    }

    fn domain(comment: &str) -> Domain {
        parameters(&format!("a = 1; {comment}")).remove(0).1
    }

    fn choice(value: &str, label: Option<&str>) -> (String, Option<String>) {
        (value.to_owned(), label.map(str::to_owned))
    }

    #[test]
    fn comments_give_the_domain() {
        assert_eq!(domain("// [1:0.5:30]"), Domain::Range { min: 1.0, step: Some(0.5), max: 30.0 });
        assert_eq!(domain("//[-1:30] mm"), Domain::Range { min: -1.0, step: None, max: 30.0 });
        assert_eq!(domain("// [30]"), Domain::Range { min: 0.0, step: None, max: 30.0 });
        assert_eq!(domain("// .5"), Domain::Step(0.5));
        assert_eq!(
            domain("// [10:Small, 20 : Very large]"),
            Domain::Choices(vec![choice("10", Some("Small")), choice("20", Some("Very large")),])
        );
        assert_eq!(domain("// [\"a,b\":A, c]"), Domain::Choices(vec![choice("a,b", Some("A")), choice("c", None)]));
        for comment in ["// [", "// []", "// any number", "\n// [1:2]", "/* [1:2] */", ""] {
            assert_eq!(domain(comment), Domain::Any, "{comment}");
        }
    }

    #[test]
    fn lines_above_give_description_and_group() {
        let text = "// none\n\na = 1;\n/* [Size] */\n// Its width\nb = [1, -2]; // [9]\n/* text\n [no] */ c = \"x\";";
        let size = Some("Size".to_owned());
        assert_eq!(
            parameters(text),
            [
                ("a".to_owned(), Domain::Any, None, None),
                (
                    "b".to_owned(),
                    Domain::Range { min: 0.0, step: None, max: 9.0 },
                    Some("Its width".to_owned()),
                    size.clone()
                ),
                ("c".to_owned(), Domain::Any, None, size),
            ]
        );
    }

    #[test]
    fn hidden_groups_computed_values_and_what_is_behind_a_brace_are_no_parameters() {
        let text = "a = 1 + 1; /* [Hidden] */ b = 2; /* [Shown] */ c = 3; module m() { d = 4; } e = 5;";
        let names: Vec<_> = parameters(text).into_iter().map(|parameter| parameter.0).collect();
        assert_eq!(names, ["c"]);
    }

    #[test]
    fn a_comment_inside_an_assignment_describes_nothing() {
        let parameters = parameters("size = [\n// width and height\n3, 4];\n");
        assert_eq!(parameters, [("size".to_owned(), Domain::Any, None, None)]);
    }
}
