//! Lists, their comprehensions, and ranges.

use super::Parser;
use crate::token::TokenKind;
use crate::tree::{Element, Expression, ExpressionKind};

impl Parser<'_> {
    /// Reads `[ … ]`.
    pub(super) fn list_or_range(&mut self) -> ExpressionKind {
        let opener = self.open();
        let mut elements = Vec::new();
        self.skip_commas();
        while !matches!(self.token.kind, TokenKind::CloseBracket | TokenKind::End) {
            let element = self.element();
            match element {
                Element::Value(start) if elements.is_empty() && self.eat(TokenKind::Colon) => {
                    let range = self.range_from(start);
                    self.close(opener, "`]`");
                    return range;
                }
                element => elements.push(element),
            }
            if !self.next_item(opener) {
                break;
            }
        }
        self.close(opener, "`,` or `]`");
        elements.shrink_to_fit();
        ExpressionKind::List(elements)
    }

    /// Reads the rest of a range, behind its first `:`.
    fn range_from(&mut self, start: Expression) -> ExpressionKind {
        let second = self.expression();
        if self.eat(TokenKind::Colon) {
            ExpressionKind::Range { start, step: Some(second), end: self.expression() }
        } else {
            ExpressionKind::Range { start, step: None, end: second }
        }
    }

    fn element(&mut self) -> Element {
        self.nested(Self::any_element).unwrap_or_else(|| Element::Value(self.nothing()))
    }

    fn any_element(&mut self) -> Element {
        match self.token.kind {
            TokenKind::For => self.for_element(),
            TokenKind::If => self.if_element(),
            TokenKind::Let => self.let_element(),
            TokenKind::Each => {
                let start = self.bump().start;
                let body = self.boxed_element();
                Element::Each(body, self.span_from(start))
            }
            TokenKind::OpenParenthesis => self.parenthesised_element(),
            _ => Element::Value(self.expression()),
        }
    }

    fn boxed_element(&mut self) -> Box<Element> {
        Box::new(self.element())
    }

    fn for_element(&mut self) -> Element {
        let keyword = self.bump().start;
        if !self.at(TokenKind::OpenParenthesis) {
            self.expected_but("`(`", "write `for (i = [0:9]) …`");
            return Element::Value(self.nothing());
        }
        let opener = self.open();
        let start = self.argument_list(opener);
        if !self.eat(TokenKind::Semicolon) {
            self.close(opener, "`,` or `)`");
            let body = self.boxed_element();
            return Element::For(start, body, self.span_from(keyword));
        }
        let condition = self.expression();
        let next = if self.eat(TokenKind::Semicolon) {
            self.argument_list(opener)
        } else {
            self.expected_but("`;`", "write `for (first values; condition; next values) …`");
            Vec::new()
        };
        self.close(opener, "`,` or `)`");
        let body = self.boxed_element();
        Element::Loop { start, condition, next, body, span: self.span_from(keyword) }
    }

    fn if_element(&mut self) -> Element {
        let start = self.bump().start;
        let condition = self.condition();
        let yes = self.boxed_element();
        let no = self.eat(TokenKind::Else).then(|| self.boxed_element());
        Element::If(condition, yes, no, self.span_from(start))
    }

    /// Reads `let (…) element`, which is an expression where the element is.
    fn let_element(&mut self) -> Element {
        let start = self.bump().start;
        let bindings = self.arguments();
        let body = self.element();
        let span = self.span_from(start);
        match body {
            Element::Value(body) => Element::Value(Expression::new(ExpressionKind::Let(bindings, body), span)),
            body => Element::Let(bindings, Box::new(body), span),
        }
    }

    /// Reads `( element )`, or an expression that begins with a parenthesis.
    fn parenthesised_element(&mut self) -> Element {
        let deepest_before = self.begin_chain();
        let opener = self.open();
        let inside = self.element();
        self.close(opener, "`)`");
        let element = match inside {
            Element::Value(inside) => {
                let operand = Expression { span: self.span_from(opener.start), ..inside };
                Element::Value(self.conditional(Some(operand)))
            }
            comprehension => comprehension,
        };
        self.end_chain(deepest_before);
        element
    }

    /// Reads `( condition )`. Parentheses that are missing are reported.
    pub(super) fn condition(&mut self) -> Expression {
        if !self.at(TokenKind::OpenParenthesis) {
            self.expected_but("`(`", "a condition stands in parentheses: `if (a > b) …`");
            return if self.token.kind.begins_expression() { self.expression() } else { self.nothing() };
        }
        let opener = self.open();
        let condition = self.expression();
        self.close(opener, "`)`");
        condition
    }
}
