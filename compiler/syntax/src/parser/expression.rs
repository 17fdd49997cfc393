//! Expressions.
//!
//! A function with a parameter `first` takes up an expression whose first operand has been read already: behind
//! `[(` only the text behind `)` tells whether there was a list comprehension or an operand.

use std::sync::Arc;

use super::Parser;
use crate::source::Span;
use crate::token::{Token, TokenKind};
use crate::tree::{Argument, BinaryOperator, Expression, ExpressionKind, FunctionLiteral, Parameter, UnaryOperator};

impl Parser<'_> {
    /// Reads an expression. If there is none, that is reported and nothing is read.
    pub(super) fn expression(&mut self) -> Expression {
        self.nested(Self::any_expression).unwrap_or_else(|| self.nothing())
    }

    fn any_expression(&mut self) -> Expression {
        match self.token.kind {
            TokenKind::Function => self.function_literal(),
            TokenKind::Let => self.let_expression(),
            TokenKind::Assert => self.check(ExpressionKind::Assert),
            TokenKind::Echo => self.check(ExpressionKind::Echo),
            _ => self.conditional(None),
        }
    }

    /// An expression that stands for what could not be read, at the next token.
    pub(super) fn nothing(&self) -> Expression {
        let start = self.token.start;
        Expression::new(ExpressionKind::Error, Span { file: self.file, start, end: start })
    }

    fn function_literal(&mut self) -> Expression {
        let start = self.bump().start;
        let parameters = self.parameters();
        let body = self.expression();
        let kind = ExpressionKind::Function(Arc::new(FunctionLiteral { parameters, body }));
        Expression::new(kind, self.span_from(start))
    }

    fn let_expression(&mut self) -> Expression {
        let start = self.bump().start;
        let bindings = self.arguments();
        let body = self.expression();
        Expression::new(ExpressionKind::Let(bindings, body), self.span_from(start))
    }

    /// `assert (…) body` or `echo (…) body`, where the body may be left out.
    fn check(&mut self, kind: fn(Vec<Argument>, Option<Expression>) -> ExpressionKind) -> Expression {
        let start = self.bump().start;
        let arguments = self.arguments();
        let body = self.token.kind.begins_expression().then(|| self.expression());
        Expression::new(kind(arguments, body), self.span_from(start))
    }

    /// Reads a `?:` or what binds tighter.
    pub(super) fn conditional(&mut self, first: Option<Expression>) -> Expression {
        let deepest_before = if first.is_some() { self.deepest } else { self.begin_chain() };
        let mut condition = self.binary(0, first);
        if self.at(TokenKind::Question) && self.deepen_chain() {
            self.bump();
            let yes = self.expression();
            let no = if self.eat(TokenKind::Colon) {
                self.expression()
            } else {
                self.expected_but("`:`", "write `condition ? one value : another`");
                self.nothing()
            };
            let span = condition.span.to(self.gap());
            condition = Expression::new(ExpressionKind::Conditional { condition, yes, no }, span);
        }
        self.end_chain(deepest_before);
        condition
    }

    /// Reads operators that bind at least as tight as `tightness`, by precedence climbing.
    fn binary(&mut self, tightness: u8, first: Option<Expression>) -> Expression {
        let deepest_before = if first.is_some() { self.deepest } else { self.begin_chain() };
        let mut left = self.unary(first);
        while let Some(operator) = binary_operator(self.token.kind)
            && operator.tightness() >= tightness
            && self.deepen_chain()
        {
            self.bump();
            let right = self.nested(|parser| parser.binary(operator.tightness() + 1, None));
            let right = right.unwrap_or_else(|| self.nothing());
            left = binary(operator, left, right);
        }
        self.end_chain(deepest_before);
        left
    }

    fn unary(&mut self, first: Option<Expression>) -> Expression {
        let operator = match self.token.kind {
            _ if first.is_some() => return self.power(first),
            TokenKind::Minus => UnaryOperator::Negate,
            TokenKind::Plus => UnaryOperator::Plus,
            TokenKind::Bang => UnaryOperator::Not,
            TokenKind::Tilde => UnaryOperator::BitNot,
            _ => return self.power(None),
        };
        let start = self.bump().start;
        let operand = self.nested(|parser| parser.unary(None)).unwrap_or_else(|| self.nothing());
        Expression::new(ExpressionKind::Unary(operator, operand), self.span_from(start))
    }

    /// Reads `base ^ exponent`, which binds tighter than a sign in front and looser than one behind.
    fn power(&mut self, first: Option<Expression>) -> Expression {
        let deepest_before = if first.is_some() { self.deepest } else { self.begin_chain() };
        let mut base = self.applied(first);
        if self.at(TokenKind::Caret) && self.deepen_chain() {
            self.bump();
            let exponent = self.nested(|parser| parser.unary(None)).unwrap_or_else(|| self.nothing());
            base = binary(BinaryOperator::Power, base, exponent);
        }
        self.end_chain(deepest_before);
        base
    }

    /// Reads an operand with the calls, indices and members behind it.
    fn applied(&mut self, first: Option<Expression>) -> Expression {
        let mut base = first.unwrap_or_else(|| self.operand());
        loop {
            let is_applied =
                matches!(self.token.kind, TokenKind::OpenParenthesis | TokenKind::OpenBracket | TokenKind::Dot);
            if !is_applied || !self.deepen_chain() {
                return base;
            }
            let start = base.span;
            let kind = match self.token.kind {
                TokenKind::OpenParenthesis => ExpressionKind::Call(base, self.arguments()),
                TokenKind::OpenBracket => {
                    let opener = self.open();
                    let index = self.expression();
                    self.close(opener, "`]`");
                    ExpressionKind::Index(base, index)
                }
                _ => {
                    self.bump();
                    let Some(member) = self.eat_name() else {
                        self.expected("the name of a member, such as `x`");
                        return base;
                    };
                    ExpressionKind::Member(base, member)
                }
            };
            base = Expression::new(kind, start.to(self.gap()));
        }
    }

    fn operand(&mut self) -> Expression {
        let start = self.token.start;
        let kind = match self.token.kind {
            TokenKind::Number => self.number(),
            TokenKind::String | TokenKind::RawString | TokenKind::UnclosedString => self.string(),
            TokenKind::Name => ExpressionKind::Name(self.bump_name().node),
            TokenKind::True | TokenKind::False => ExpressionKind::Bool(self.bump().kind == TokenKind::True),
            TokenKind::Undef => {
                self.bump();
                ExpressionKind::Undef
            }
            TokenKind::OpenBracket => self.list_or_range(),
            TokenKind::OpenParenthesis => return self.parenthesised(),
            _ => return self.no_operand(),
        };
        Expression::new(kind, self.span_from(start))
    }

    /// Reads `( … )`. The brackets are no node, but part of the span.
    fn parenthesised(&mut self) -> Expression {
        let opener = self.open();
        let inside = self.expression();
        self.close(opener, "`)`");
        Expression { span: self.span_from(opener.start), ..inside }
    }

    /// Reports what stands where an operand should.
    #[inline(never)]
    fn no_operand(&mut self) -> Expression {
        let error = self.unexpected("an expression");
        let word = &self.text[self.token.range()];
        let start = self.token.start;
        match self.token.kind {
            TokenKind::Function | TokenKind::Let | TokenKind::Assert | TokenKind::Echo => {
                self.error(error.with_hint(format!("an operand that begins with `{word}` stands in parentheses")));
                return self.expression();
            }
            TokenKind::OpenBrace => {
                self.error(error.with_hint("a list stands in brackets: `[1, 2]`"));
                self.skip_braces();
            }
            TokenKind::If => {
                self.error(error.with_hint("an expression chooses with `condition ? one value : another`"));
                self.skip_in_brackets(&[TokenKind::Comma]);
            }
            TokenKind::For | TokenKind::Each => {
                let hint = format!("in expressions, `{word}` stands in a list: `[for (i = [0:9]) i]`");
                self.error(error.with_hint(hint));
                self.skip_in_brackets(&[TokenKind::Comma]);
            }
            _ => self.error(error),
        }
        let end = self.previous_end.max(start);
        Expression::new(ExpressionKind::Error, Span { file: self.file, start, end })
    }

    /// Reads `( name = value, value, … )`. If there is no `(`, that is reported and nothing is read.
    pub(super) fn arguments(&mut self) -> Vec<Argument> {
        if !self.at(TokenKind::OpenParenthesis) {
            self.expected("`(`");
            return Vec::new();
        }
        let opener = self.open();
        let arguments = self.argument_list(opener);
        self.close(opener, "`,` or `)`");
        arguments
    }

    /// Reads arguments up to the `)` of `opener`, or a `;`.
    pub(super) fn argument_list(&mut self, opener: Token) -> Vec<Argument> {
        let mut arguments = Vec::new();
        self.skip_commas();
        while !matches!(self.token.kind, TokenKind::CloseParenthesis | TokenKind::Semicolon | TokenKind::End) {
            arguments.push(self.argument());
            if !self.next_item(opener) {
                break;
            }
        }
        arguments
    }

    fn argument(&mut self) -> Argument {
        let is_named = self.at(TokenKind::Name) && self.ahead.kind == TokenKind::Assign;
        let name = is_named.then(|| {
            let name = self.bump_name();
            self.bump();
            name
        });
        Argument { name, value: self.expression() }
    }

    /// Reads `( name, name = default, … )`. If there is no `(`, that is reported and nothing is read.
    pub(super) fn parameters(&mut self) -> Vec<Parameter> {
        let mut parameters = Vec::new();
        if !self.at(TokenKind::OpenParenthesis) {
            self.expected_but("`(`", "parameters stand in parentheses, even if there are none");
            return parameters;
        }
        let opener = self.open();
        self.skip_commas();
        while !matches!(self.token.kind, TokenKind::CloseParenthesis | TokenKind::End) {
            if let Some(name) = self.eat_name() {
                let default = self.eat(TokenKind::Assign).then(|| self.expression());
                parameters.push(Parameter { name, default });
            } else {
                self.expected("the name of a parameter");
            }
            if !self.next_item(opener) {
                break;
            }
        }
        self.close(opener, "`,` or `)`");
        parameters
    }
}

fn binary(operator: BinaryOperator, left: Expression, right: Expression) -> Expression {
    let span = left.span.to(right.span);
    Expression::new(ExpressionKind::Binary(operator, left, right), span)
}

/// The operator that a token is. `^` is not among them, since it binds tighter than signs do.
fn binary_operator(kind: TokenKind) -> Option<BinaryOperator> {
    Some(match kind {
        TokenKind::BarBar => BinaryOperator::Or,
        TokenKind::AmpersandAmpersand => BinaryOperator::And,
        TokenKind::Equal => BinaryOperator::Equal,
        TokenKind::NotEqual => BinaryOperator::NotEqual,
        TokenKind::Greater => BinaryOperator::Greater,
        TokenKind::GreaterEqual => BinaryOperator::GreaterEqual,
        TokenKind::Less => BinaryOperator::Less,
        TokenKind::LessEqual => BinaryOperator::LessEqual,
        TokenKind::Bar => BinaryOperator::BitOr,
        TokenKind::Ampersand => BinaryOperator::BitAnd,
        TokenKind::ShiftLeft => BinaryOperator::ShiftLeft,
        TokenKind::ShiftRight => BinaryOperator::ShiftRight,
        TokenKind::Plus => BinaryOperator::Add,
        TokenKind::Minus => BinaryOperator::Subtract,
        TokenKind::Star => BinaryOperator::Multiply,
        TokenKind::Slash => BinaryOperator::Divide,
        TokenKind::Percent => BinaryOperator::Modulo,
        _ => return None,
    })
}
