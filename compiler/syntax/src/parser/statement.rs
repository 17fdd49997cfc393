//! Statements: definitions, assignments, and modules instantiated.

use std::sync::Arc;

use super::Parser;
use crate::diagnostic::Diagnostic;
use crate::source::{Span, Spanned};
use crate::token::TokenKind;
use crate::tree::{
    Argument, Assignment, FunctionDefinition, FunctionLiteral, Instance, Modifiers, ModuleDefinition, Name, Statement,
};

impl Parser<'_> {
    /// Reads the whole file.
    pub(super) fn program(&mut self) -> Vec<Statement> {
        let mut statements = Vec::new();
        loop {
            self.statements(&mut statements);
            if self.at(TokenKind::End) {
                return statements;
            }
            self.unmatched_brace();
            self.bump();
        }
    }

    /// Reads statements up to a `}` or the end.
    fn statements(&mut self, statements: &mut Vec<Statement>) {
        while !matches!(self.token.kind, TokenKind::End | TokenKind::CloseBrace) {
            let token = self.token;
            let statement = self.nested(Self::statement).flatten();
            statements.extend(statement);
            if self.token == token && !self.stopped {
                self.bump();
            }
        }
    }

    /// Reads `{ … }`.
    fn block(&mut self) -> Vec<Statement> {
        let opener = self.bump();
        let mut statements = Vec::new();
        self.statements(&mut statements);
        if !self.eat(TokenKind::CloseBrace) {
            self.unclosed_block(opener);
        }
        statements.shrink_to_fit();
        statements
    }

    fn statement(&mut self) -> Option<Statement> {
        match self.token.kind {
            TokenKind::Semicolon | TokenKind::UnclosedPath => {
                self.bump();
                None
            }
            TokenKind::Use => self.use_statement(),
            TokenKind::Include => Some(Statement::Include(self.path())),
            TokenKind::OpenBrace => Some(Statement::Block(self.block())),
            TokenKind::Module => self.module_definition(),
            TokenKind::Function => self.function_definition(),
            TokenKind::Name if self.ahead.kind == TokenKind::Assign => Some(self.assignment()),
            _ if self.at_instance() => self.instance().map(Statement::Instance),
            _ => {
                self.no_statement();
                None
            }
        }
    }

    #[inline(never)]
    fn no_statement(&mut self) {
        let error = self.unexpected("a statement");
        let error = match self.token.kind {
            TokenKind::Else => {
                let error = Diagnostic::error(self.span(self.token), "`else` without an `if`");
                self.error(error.with_hint("only one statement or one `{ … }` may stand between `if (…)` and `else`"));
                self.bump();
                return;
            }
            kind if kind.begins_expression() => error.with_hint("a value stands behind a name: `size = 10;`"),
            _ => error,
        };
        self.error(error);
        self.bump();
        self.skip_statement();
    }

    /// Reads `use <…>`, which takes effect only at the top of a file's nesting.
    fn use_statement(&mut self) -> Option<Statement> {
        if self.depth > 1 {
            let error = Diagnostic::error(self.span(self.token), "`use` stands outside of all braces");
            self.error(error);
        }
        Some(Statement::Use(self.path()))
    }

    /// Reads the path of a `use` or `include`.
    fn path(&mut self) -> Spanned<Name> {
        let token = self.bump();
        let word = &self.text[token.range()];
        let inside = word.split_once('<').map_or(word, |(_, path)| path.trim_end_matches('>'));
        Spanned::new(self.intern(inside.trim()), self.span(token))
    }

    fn assignment(&mut self) -> Statement {
        let name = self.bump_name();
        self.bump();
        let value = self.expression();
        self.semicolon("this assignment");
        let span = self.span_from(name.span.start);
        Statement::Assignment(Assignment { name, value, span, customizer: None })
    }

    fn module_definition(&mut self) -> Option<Statement> {
        let start = self.bump().start;
        let name = self.defined_name("module")?;
        let parameters = self.parameters();
        let body = match self.token.kind {
            TokenKind::OpenBrace => self.block(),
            TokenKind::End | TokenKind::CloseBrace => {
                self.missing(&format!("body of the module `{}`", name.node), "a body stands in braces: `{ … }`");
                Vec::new()
            }
            _ => self.nested(Self::statement).flatten().into_iter().collect(),
        };
        let span = self.span_from(start);
        Some(Statement::Module(Arc::new(ModuleDefinition { name, parameters, body, span })))
    }

    fn function_definition(&mut self) -> Option<Statement> {
        let start = self.bump().start;
        let name = self.defined_name("function")?;
        let parameters = self.parameters();
        if !self.eat(TokenKind::Assign) {
            self.expected_but("`=`", "a function is written `function name(x) = value;`");
            self.skip_statement();
            if self.at(TokenKind::OpenBrace) {
                self.skip_braces();
            }
            return None;
        }
        let body = self.expression();
        self.semicolon("this function");
        let function = Arc::new(FunctionLiteral { parameters, body });
        Some(Statement::Function(Arc::new(FunctionDefinition { name, function, span: self.span_from(start) })))
    }

    /// Reads the name of what is defined. If there is none, the header is skipped.
    fn defined_name(&mut self, what: &str) -> Option<Spanned<Name>> {
        let name = self.eat_name();
        if name.is_none() {
            self.expected(&format!("the name of a {what}"));
            self.skip_statement();
        }
        name
    }

    /// Whether a module is instantiated here.
    fn at_instance(&self) -> bool {
        let kind = self.token.kind;
        kind.names_module() || kind == TokenKind::If || modifier(kind).is_some()
    }

    fn instance(&mut self) -> Option<Instance> {
        let start = self.token.start;
        let mut modifiers = Modifiers::default();
        while let Some(set) = modifier(self.token.kind) {
            set(&mut modifiers);
            self.bump();
        }
        if self.at(TokenKind::If) {
            return Some(self.if_instance(start, modifiers));
        }
        if !self.token.kind.names_module() {
            self.expected("a module to be modified, such as `cube(1)`");
            return None;
        }
        let name = self.bump_name();
        let arguments = self.instance_arguments(&name)?;
        let head = self.span_from(name.span.start);
        let children = self.children(head);
        Some(Instance {
            modifiers,
            name,
            arguments,
            children,
            otherwise: Vec::new(),
            span: self.span_from(start),
            head,
        })
    }

    /// Reads an instance's arguments. Where it seems that only the parentheses are missing, there are none.
    fn instance_arguments(&mut self, name: &Spanned<Name>) -> Option<Vec<Argument>> {
        if self.at(TokenKind::OpenParenthesis) {
            return Some(self.arguments());
        }
        if matches!(self.token.kind, TokenKind::OpenBrace | TokenKind::Semicolon) {
            let error = Diagnostic::error(self.gap(), format!("missing `()` behind `{}`", name.node))
                .with_hint("arguments stand in parentheses, even if there are none");
            self.error(error.with_suggestion(self.gap(), "()"));
            return Some(Vec::new());
        }
        match self.instance_hint(&name.node) {
            Some(hint) => self.expected_but("`(` or `=`", hint),
            None => self.expected("`(` or `=`"),
        }
        self.skip_statement();
        None
    }

    /// What the user may have meant by the next token, which stands behind a name but can't.
    fn instance_hint(&self, name: &str) -> Option<&'static str> {
        match (name, self.token.kind) {
            ("use", _) => Some("write `use <file>`"),
            ("include", _) => Some("write `include <file>`"),
            ("for", _) => Some("write `for (i = [0:9]) …`"),
            ("var" | "let" | "const" | "auto" | "int" | "float" | "double" | "local", TokenKind::Name) => {
                Some("a variable needs no keyword: `size = 10;`")
            }
            ("return", _) => Some("a function is one expression: `function name(x) = value;`"),
            ("def" | "fn" | "func", TokenKind::Name) => Some("a function is written `function name(x) = value;`"),
            (_, TokenKind::Equal) => Some("`=` gives a variable its value"),
            (_, TokenKind::Dot | TokenKind::OpenBracket) => Some("the parts of a variable can't be changed"),
            (_, TokenKind::Plus | TokenKind::Minus | TokenKind::Star | TokenKind::Slash) => {
                Some("a variable has one value, which can't be changed step by step")
            }
            _ => None,
        }
    }

    fn if_instance(&mut self, start: u32, modifiers: Modifiers) -> Instance {
        let name = self.bump_name();
        let value = self.condition();
        let head = self.span_from(name.span.start);
        let children = self.children(head);
        let otherwise = if self.at(TokenKind::Else) {
            let keyword = self.bump();
            self.children(self.span(keyword))
        } else {
            Vec::new()
        };
        let arguments = vec![Argument { name: None, value }];
        Instance { modifiers, name, arguments, children, otherwise, span: self.span_from(start), head }
    }

    /// Reads what an instance is applied to: `;`, `{ … }` or one instance. `head` is what stands before it.
    fn children(&mut self, head: Span) -> Vec<Statement> {
        match self.token.kind {
            TokenKind::Semicolon => {
                self.bump();
                Vec::new()
            }
            TokenKind::OpenBrace => self.block(),
            TokenKind::Name if self.ahead.kind == TokenKind::Assign => {
                self.no_child("an assignment is no child of this; put both in braces", head);
                Vec::new()
            }
            _ if self.at_instance() => {
                let child = self.nested(Self::instance).flatten();
                child.map(Statement::Instance).into_iter().collect()
            }
            _ => {
                self.no_children(head);
                Vec::new()
            }
        }
    }

    #[inline(never)]
    fn no_children(&mut self, head: Span) {
        match self.token.kind {
            TokenKind::End | TokenKind::CloseBrace => {
                let text = self.shown_head(head);
                let message = format!("missing `;` behind `{text}`");
                let error = Diagnostic::error(self.gap(), message).with_hint("`;` ends a statement");
                self.error(error.with_suggestion(self.gap(), ";"));
            }
            _ if self.at_statement() => self.no_child("a definition is no child of this", head),
            _ => {
                let error = self.unexpected("`;`, `{` or a module");
                self.error(self.with_statement_hint(error));
                self.skip_statement();
            }
        }
    }

    /// Reports a statement that can't be a child: on a line of its own it is a statement, and a `;` is missing.
    #[inline(never)]
    fn no_child(&mut self, message: &str, head: Span) {
        let error = if self.at_line_start() {
            let text = self.shown_head(head);
            Diagnostic::error(self.gap(), format!("missing `;` behind `{text}`")).with_suggestion(self.gap(), ";")
        } else {
            self.unexpected("`;`, `{` or a module").with_hint(message)
        };
        self.error(error);
    }

    /// The text of an instance's head, short enough for a message.
    fn shown_head(&self, head: Span) -> String {
        let text = &self.text[head.range()];
        match text.find('(') {
            Some(end) if text.len() > 40 => format!("{}(…)", &text[..end]),
            _ => text.split_whitespace().collect::<Vec<_>>().join(" "),
        }
    }
}

/// What a modifier character sets.
fn modifier(kind: TokenKind) -> Option<fn(&mut Modifiers)> {
    Some(match kind {
        TokenKind::Star => |modifiers: &mut Modifiers| modifiers.disable = true,
        TokenKind::Bang => |modifiers: &mut Modifiers| modifiers.root = true,
        TokenKind::Hash => |modifiers: &mut Modifiers| modifiers.highlight = true,
        TokenKind::Percent => |modifiers: &mut Modifiers| modifiers.background = true,
        _ => return None,
    })
}
