//! Printing expressions, with no more parentheses than they need.

use super::Printer;
use crate::operator::UNARY_TIGHTNESS;
use crate::tree::{Argument, BinaryOperator, Element, Expression, ExpressionKind, Parameter};

/// How tight an expression is: what stands around it may bind no tighter. Operators are one above their tightness.
const LOOSE: u8 = 0;
/// Above the `?` of a conditional.
const OPERATOR: u8 = 1;
/// Above calls, indices and members.
const APPLIED: u8 = 20;

impl Printer {
    pub(super) fn expression(&mut self, expression: &Expression) {
        self.tight(expression, LOOSE);
    }

    /// Prints an expression as an operand of what binds that tight.
    fn tight(&mut self, expression: &Expression, needed: u8) {
        if self.overflows {
            return;
        }
        if tightness(&expression.kind) < needed {
            self.write("(");
            self.kind(&expression.kind);
            self.write(")");
        } else {
            self.kind(&expression.kind);
        }
    }

    fn kind(&mut self, kind: &ExpressionKind) {
        match kind {
            ExpressionKind::Undef | ExpressionKind::Error => self.write("undef"),
            ExpressionKind::Bool(value) => self.write(if *value { "true" } else { "false" }),
            ExpressionKind::Number(value) => self.write(&number(*value)),
            ExpressionKind::String(value) => self.string(value),
            ExpressionKind::Name(name) => self.write(name),
            ExpressionKind::Range { start, step, end } => {
                self.write("[");
                self.expression(start);
                for part in step.iter().chain([end]) {
                    self.write(":");
                    self.expression(part);
                }
                self.write("]");
            }
            ExpressionKind::List(elements) => self.list("[", elements, "]", Self::element),
            ExpressionKind::Unary(operator, operand) => {
                self.write(operator.sign());
                self.tight(operand, tightness(kind));
            }
            ExpressionKind::Binary(operator, left, right) => self.binary(*operator, left, right),
            ExpressionKind::Conditional { condition, yes, no } => self.conditional(condition, yes, no),
            ExpressionKind::Index(list, index) => {
                self.tight(list, APPLIED);
                self.write("[");
                self.expression(index);
                self.write("]");
            }
            ExpressionKind::Member(list, member) => {
                self.tight(list, APPLIED);
                // A name may begin with a digit, and a point before one would begin a number.
                let begins_number = member.node.starts_with(|first: char| first.is_ascii_digit());
                self.write(if begins_number { ". " } else { "." });
                self.write(&member.node);
            }
            ExpressionKind::Call(function, arguments) => {
                self.tight(function, APPLIED);
                self.arguments(arguments);
            }
            ExpressionKind::Function(function) => {
                self.write("function ");
                self.parameters(&function.parameters);
                self.body(Some(&function.body));
            }
            ExpressionKind::Let(bindings, body) => self.keyword("let ", bindings, Some(body)),
            ExpressionKind::Assert(arguments, body) => self.keyword("assert", arguments, body.as_ref()),
            ExpressionKind::Echo(arguments, body) => self.keyword("echo", arguments, body.as_ref()),
        }
    }

    fn keyword(&mut self, keyword: &str, arguments: &[Argument], body: Option<&Expression>) {
        self.write(keyword);
        self.arguments(arguments);
        self.body(body);
    }

    /// Prints what stands behind `let (…)` and the like.
    fn body(&mut self, body: Option<&Expression>) {
        if let Some(body) = body {
            self.break_before("", |printer| printer.expression(body));
        }
    }

    /// Prints a blank, a sign and what follows, or begins another line if that does not fit.
    fn break_before(&mut self, sign: &str, print: impl Fn(&mut Self)) {
        let print = |printer: &mut Self| {
            printer.write(sign);
            print(printer);
        };
        self.on_one_line_or(
            |printer| {
                printer.write(" ");
                print(printer);
            },
            |printer| {
                printer.indentation += 1;
                printer.line_break();
                print(printer);
                printer.indentation -= 1;
            },
        );
    }

    fn binary(&mut self, operator: BinaryOperator, left: &Expression, right: &Expression) {
        let own = OPERATOR + operator.tightness();
        let (left_needs, right_needs) = match operator {
            BinaryOperator::Power => (APPLIED, OPERATOR + UNARY_TIGHTNESS),
            _ => (own, own + 1),
        };
        self.tight(left, left_needs);
        let sign = if operator == BinaryOperator::Power { "^".to_owned() } else { format!(" {} ", operator.sign()) };
        self.write(&sign);
        self.tight(right, right_needs);
    }

    fn conditional(&mut self, condition: &Expression, yes: &Expression, no: &Expression) {
        self.tight(condition, OPERATOR);
        self.break_before("? ", |printer| printer.expression(yes));
        self.break_before(": ", |printer| printer.expression(no));
    }

    fn string(&mut self, value: &str) {
        self.write("\"");
        let mut buffer = [0; 4];
        for character in value.chars() {
            match character {
                '"' => self.write("\\\""),
                '\\' => self.write("\\\\"),
                '\n' => self.write("\\n"),
                '\t' => self.write("\\t"),
                '\r' => self.write("\\r"),
                '\x01'..'\x20' | '\x7f' => self.write(&format!("\\x{:02x}", character as u32)),
                _ => self.write(character.encode_utf8(&mut buffer)),
            }
        }
        self.write("\"");
    }

    pub(super) fn arguments(&mut self, arguments: &[Argument]) {
        self.list("(", arguments, ")", |printer, argument| {
            if let Some(name) = &argument.name {
                printer.write(&name.node);
                printer.write(" = ");
            }
            printer.expression(&argument.value);
        });
    }

    pub(super) fn parameters(&mut self, parameters: &[Parameter]) {
        self.list("(", parameters, ")", |printer, parameter| {
            printer.write(&parameter.name.node);
            if let Some(default) = &parameter.default {
                printer.write(" = ");
                printer.expression(default);
            }
        });
    }

    fn element(&mut self, element: &Element) {
        if self.overflows {
            return;
        }
        match element {
            Element::Value(value) => self.expression(value),
            Element::Each(body, _) => {
                self.write("each ");
                self.element(body);
            }
            Element::For(bindings, body, _) => {
                self.write("for ");
                self.arguments(bindings);
                self.break_before("", |printer| printer.element(body));
            }
            Element::Loop { start, condition, next, body, .. } => {
                self.list("for (", start, "; ", Self::binding);
                self.expression(condition);
                self.list("; ", next, ")", Self::binding);
                self.break_before("", |printer| printer.element(body));
            }
            Element::If(condition, yes, no, _) => self.if_element(condition, yes, no.as_deref()),
            Element::Let(bindings, body, _) => {
                self.write("let ");
                self.arguments(bindings);
                self.break_before("", |printer| printer.element(body));
            }
        }
    }

    fn binding(&mut self, argument: &Argument) {
        if let Some(name) = &argument.name {
            self.write(&name.node);
            self.write(" = ");
        }
        self.expression(&argument.value);
    }

    fn if_element(&mut self, condition: &Expression, yes: &Element, no: Option<&Element>) {
        self.write("if (");
        self.expression(condition);
        self.write(")");
        let open = no.is_some() && ends_in_open_if(yes);
        self.break_before(if open { "(" } else { "" }, |printer| printer.element(yes));
        self.write(if open { ")" } else { "" });
        if let Some(no) = no {
            self.break_before("else ", |printer| printer.element(no));
        }
    }
}

/// Whether an `else` behind an element would become part of it.
fn ends_in_open_if(element: &Element) -> bool {
    match element {
        Element::Value(_) => false,
        Element::If(_, _, None, _) => true,
        Element::Each(body, _)
        | Element::For(_, body, _)
        | Element::Let(_, body, _)
        | Element::Loop { body, .. }
        | Element::If(_, _, Some(body), _) => ends_in_open_if(body),
    }
}

fn tightness(kind: &ExpressionKind) -> u8 {
    match kind {
        ExpressionKind::Conditional { .. }
        | ExpressionKind::Function(_)
        | ExpressionKind::Let(..)
        | ExpressionKind::Assert(..)
        | ExpressionKind::Echo(..) => LOOSE,
        ExpressionKind::Binary(operator, ..) => OPERATOR + operator.tightness(),
        ExpressionKind::Unary(..) => OPERATOR + UNARY_TIGHTNESS,
        // A dot behind a number would become part of it.
        ExpressionKind::Number(_) => APPLIED - 1,
        _ => APPLIED,
    }
}

/// A number in the fewest digits that read as the same number.
pub(super) fn number(value: f64) -> String {
    if value.is_infinite() {
        return if value > 0.0 { "1e999" } else { "-1e999" }.to_owned();
    }
    let digits = format!("{value:?}");
    digits.strip_suffix(".0").map_or(digits.clone(), str::to_owned)
}
