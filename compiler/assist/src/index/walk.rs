//! The walk along the tree that finds the names.

use std::ops::Range;

use chiaro_syntax::tree::{
    Argument, Element, Expression, ExpressionKind, File, FunctionLiteral, Instance, Name, Parameter, Statement,
};
use chiaro_syntax::{Span, Spanned, Token};
use rustc_hash::FxHashMap;

use crate::tokens;

use super::{Definition, Index, Link, Namespace, Occurrence, Role, Scope, What};

/// The names of a file.
pub(super) fn walk(text: &str, file: &File) -> Index {
    let everything = Scope { range: 0..text.len(), parent: None, names: FxHashMap::default() };
    let index = Index { definitions: Vec::new(), occurrences: Vec::new(), links: Vec::new(), scopes: vec![everything] };
    let mut walk = Walk { text, last_token_end: text.trim_end().len(), index };
    walk.block(&file.statements, 0);
    walk.index
}

struct Walk<'a> {
    text: &'a str,
    /// Where the text ends but for white space.
    last_token_end: usize,
    index: Index,
}

impl Walk<'_> {
    /// A scope within another. What is still being written reaches to the end of the text.
    fn scope(&mut self, range: Range<usize>, parent: usize) -> usize {
        let end = if range.end >= self.last_token_end { self.text.len() } else { range.end };
        let scope = Scope { range: range.start..end, parent: Some(parent), names: FxHashMap::default() };
        self.index.scopes.push(scope);
        self.index.scopes.len() - 1
    }

    /// Makes a definition known in a scope, unless there is one by that name; then it is another mention of that.
    fn define(&mut self, definition: Definition, scope: usize) -> usize {
        let namespace = definition.what.namespace();
        let (name, range) = (definition.name.clone(), definition.name_range.clone());
        let next = self.index.definitions.len();
        let id = *self.index.scopes[scope].names.entry((namespace, name.clone())).or_insert(next);
        if id == next {
            self.index.definitions.push(definition);
        }
        self.index.occurrences.push(Occurrence { range, name, role: Role::Of(namespace), definition: Some(id) });
        id
    }

    fn variable(&mut self, name: &Spanned<Name>, value: &Expression, what: What, scope: usize) -> usize {
        let span = name.span.to(value.span).range();
        let definition = Definition {
            name: name.node.clone(),
            what,
            name_range: name.span.range(),
            span,
            value: Some(value.span.range()),
            parameters: Vec::new(),
            is_global: scope == 0,
        };
        self.define(definition, scope)
    }

    fn mention(&mut self, name: &Name, span: Span, namespace: Namespace, scope: usize) -> Option<usize> {
        let definition = self.index.lookup(scope, namespace, name);
        let range = self.without_parentheses(name, span.range());
        let occurrence = Occurrence { range, name: name.clone(), role: Role::Of(namespace), definition };
        self.index.occurrences.push(occurrence);
        definition
    }

    /// Where a name stands in an expression that is nothing but the name: parentheses are part of its span.
    fn without_parentheses(&self, name: &Name, span: Range<usize>) -> Range<usize> {
        let inside = self.text.get(span.clone()).unwrap_or_default();
        if inside.len() == name.len() {
            return span;
        }
        let is_name = |token: &Token| inside[token.range()] == **name;
        let found = tokens(inside).into_iter().find(is_name).map(Token::range);
        found.map_or(span.clone(), |found| span.start + found.start..span.start + found.end)
    }

    /// The statements of a scope: all definitions hold everywhere in it.
    fn block(&mut self, statements: &[Statement], scope: usize) {
        let mut inner = Vec::new();
        self.declare(statements, scope, &mut inner);
        let mut inner = inner.into_iter();
        self.statements(statements, scope, &mut inner);
    }

    /// Makes the definitions known, and collects the scopes of their parameters in the order of the text.
    fn declare(&mut self, statements: &[Statement], scope: usize, inner: &mut Vec<usize>) {
        for statement in statements {
            match statement {
                Statement::Assignment(assignment) => {
                    self.variable(&assignment.name, &assignment.value, What::Variable, scope);
                }
                Statement::Module(module) => {
                    inner.push(self.callable(&module.name, module.span, &module.parameters, What::Module, scope));
                }
                Statement::Function(function) => {
                    let parameters = &function.function.parameters;
                    inner.push(self.callable(&function.name, function.span, parameters, What::Function, scope));
                }
                Statement::Block(block) => self.declare(block, scope, inner),
                Statement::Use(path) | Statement::Include(path) => {
                    let is_include = matches!(statement, Statement::Include(_));
                    self.index.links.push(Link { path: path.node.clone(), range: path.span.range(), is_include });
                }
                Statement::Instance(_) => {}
            }
        }
    }

    /// Defines a module or function, and answers the scope of its parameters.
    fn callable(
        &mut self,
        name: &Spanned<Name>,
        span: Span,
        parameters: &[Parameter],
        what: What,
        scope: usize,
    ) -> usize {
        let definition = Definition {
            name: name.node.clone(),
            what,
            name_range: name.span.range(),
            span: span.range(),
            value: None,
            parameters: Vec::new(),
            is_global: scope == 0,
        };
        let id = self.define(definition.clone(), scope);
        let inner = self.scope(span.range(), scope);
        let parameters = self.parameters(parameters, inner);
        // Of several definitions by one name the last one counts.
        self.index.definitions[id] = Definition { parameters, ..definition };
        inner
    }

    fn parameters(&mut self, parameters: &[Parameter], scope: usize) -> Vec<usize> {
        let define = |parameter: &Parameter| {
            let span = match &parameter.default {
                Some(default) => parameter.name.span.to(default.span),
                None => parameter.name.span,
            };
            let definition = Definition {
                name: parameter.name.node.clone(),
                what: What::Parameter,
                name_range: parameter.name.span.range(),
                span: span.range(),
                value: parameter.default.as_ref().map(|default| default.span.range()),
                parameters: Vec::new(),
                is_global: false,
            };
            self.define(definition, scope)
        };
        parameters.iter().map(define).collect()
    }

    /// The values and instances of a scope. `inner` are the scopes that [`Walk::declare`] has collected.
    fn statements(&mut self, statements: &[Statement], scope: usize, inner: &mut impl Iterator<Item = usize>) {
        for statement in statements {
            match statement {
                Statement::Assignment(assignment) => self.expression(&assignment.value, scope),
                Statement::Module(module) => {
                    self.defaults(&module.parameters, scope);
                    let inner = inner.next().unwrap_or(scope);
                    self.block(&module.body, inner);
                }
                Statement::Function(function) => {
                    self.defaults(&function.function.parameters, scope);
                    let inner = inner.next().unwrap_or(scope);
                    self.expression(&function.function.body, inner);
                }
                Statement::Block(block) => self.statements(block, scope, inner),
                Statement::Instance(instance) => self.instance(instance, scope),
                Statement::Use(_) | Statement::Include(_) => {}
            }
        }
    }

    fn defaults(&mut self, parameters: &[Parameter], scope: usize) {
        for default in parameters.iter().filter_map(|parameter| parameter.default.as_ref()) {
            self.expression(default, scope);
        }
    }

    fn instance(&mut self, instance: &Instance, scope: usize) {
        let name = &instance.name;
        let inner = match &*name.node {
            "for" | "intersection_for" | "let" | "assign" => self.bindings(&instance.arguments, scope, instance.span),
            "if" | "echo" | "assert" => {
                self.arguments(&instance.arguments, None, scope);
                scope
            }
            _ => {
                let module = self.mention(&name.node, name.span, Namespace::Module, scope);
                let callee = Callee { name: &name.node, namespace: Namespace::Module, definition: module };
                self.arguments(&instance.arguments, Some(callee), scope);
                scope
            }
        };
        for children in [&instance.children, &instance.otherwise] {
            if !children.is_empty() {
                let inner = self.scope(instance.head.end as usize..instance.span.end as usize, inner);
                self.block(children, inner);
            }
        }
    }

    /// `name = value, …` where each value sees the names before it. Answers the scope of what follows.
    fn bindings(&mut self, bindings: &[Argument], scope: usize, around: Span) -> usize {
        let mut inner = scope;
        for binding in bindings {
            self.expression(&binding.value, inner);
            if let Some(name) = &binding.name {
                inner = self.scope(binding.value.span.end as usize..around.end as usize, inner);
                self.variable(name, &binding.value, What::Variable, inner);
            }
        }
        inner
    }

    fn arguments(&mut self, arguments: &[Argument], callee: Option<Callee>, scope: usize) {
        for argument in arguments {
            if let Some(name) = &argument.name {
                self.argument_name(name, callee.as_ref(), scope);
            }
            self.expression(&argument.value, scope);
        }
    }

    fn argument_name(&mut self, name: &Spanned<Name>, callee: Option<&Callee>, scope: usize) {
        let parameters = callee.and_then(|callee| callee.definition).map(|id| &self.index.definitions[id].parameters);
        let is_meant = |id: &&usize| self.index.definitions[**id].name == name.node;
        let parameter = parameters.and_then(|parameters| parameters.iter().find(is_meant).copied());
        match callee {
            Some(callee) if parameter.is_some() || !name.node.starts_with('$') => {
                let role = Role::Argument { callee: callee.name.clone(), of: callee.namespace };
                let (range, name) = (name.span.range(), name.node.clone());
                self.index.occurrences.push(Occurrence { range, name, role, definition: parameter });
            }
            _ => {
                self.mention(&name.node, name.span, Namespace::Variable, scope);
            }
        }
    }

    fn expression(&mut self, expression: &Expression, scope: usize) {
        match &*expression.kind {
            ExpressionKind::Name(name) => {
                self.mention(name, expression.span, Namespace::Variable, scope);
            }
            ExpressionKind::Range { start, step, end } => {
                for part in [start].into_iter().chain(step).chain([end]) {
                    self.expression(part, scope);
                }
            }
            ExpressionKind::List(elements) => elements.iter().for_each(|element| self.element(element, scope)),
            ExpressionKind::Unary(_, operand) | ExpressionKind::Member(operand, _) => self.expression(operand, scope),
            ExpressionKind::Binary(_, a, b) | ExpressionKind::Index(a, b) => {
                self.expression(a, scope);
                self.expression(b, scope);
            }
            ExpressionKind::Conditional { condition, yes, no } => {
                for part in [condition, yes, no] {
                    self.expression(part, scope);
                }
            }
            ExpressionKind::Call(callee, arguments) => self.call(callee, arguments, scope),
            ExpressionKind::Function(function) => self.function_literal(function, expression.span, scope),
            ExpressionKind::Let(bindings, body) => {
                let inner = self.bindings(bindings, scope, expression.span);
                self.expression(body, inner);
            }
            ExpressionKind::Assert(arguments, body) | ExpressionKind::Echo(arguments, body) => {
                self.arguments(arguments, None, scope);
                body.iter().for_each(|body| self.expression(body, scope));
            }
            ExpressionKind::Undef
            | ExpressionKind::Bool(_)
            | ExpressionKind::Number(_)
            | ExpressionKind::String(_)
            | ExpressionKind::Error => {}
        }
    }

    fn call(&mut self, callee: &Expression, arguments: &[Argument], scope: usize) {
        match &*callee.kind {
            ExpressionKind::Name(name) => {
                let definition = self.mention(name, callee.span, Namespace::Function, scope);
                let callee = Callee { name, namespace: Namespace::Function, definition };
                self.arguments(arguments, Some(callee), scope);
            }
            _ => {
                self.expression(callee, scope);
                self.arguments(arguments, None, scope);
            }
        }
    }

    fn function_literal(&mut self, function: &FunctionLiteral, span: Span, scope: usize) {
        self.defaults(&function.parameters, scope);
        let inner = self.scope(span.range(), scope);
        self.parameters(&function.parameters, inner);
        self.expression(&function.body, inner);
    }

    fn element(&mut self, element: &Element, scope: usize) {
        match element {
            Element::Value(value) => self.expression(value, scope),
            Element::Each(body, _) => self.element(body, scope),
            Element::For(bindings, body, span) | Element::Let(bindings, body, span) => {
                let inner = self.bindings(bindings, scope, *span);
                self.element(body, inner);
            }
            Element::Loop { start, condition, next, body, span } => {
                let inner = self.bindings(start, scope, *span);
                self.expression(condition, inner);
                self.arguments(next, None, inner);
                self.element(body, inner);
            }
            Element::If(condition, yes, no, _) => {
                self.expression(condition, scope);
                self.element(yes, scope);
                no.iter().for_each(|no| self.element(no, scope));
            }
        }
    }
}

/// What is called.
struct Callee<'a> {
    name: &'a Name,
    namespace: Namespace,
    /// Its definition, if that is the text's own.
    definition: Option<usize>,
}
