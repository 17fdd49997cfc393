//! Misspelt names in a text with syntax errors.
//!
//! Theory: what can't be read may define anything, so that most of what the evaluation of such a
//! text has to say would be wrong once the text is mended. But a name is misspelt all the same if a
//! known one is like it, and if it is defined nowhere: if every place where it is written was read,
//! and read as a use of it. What stands on one line with a syntax error may have been meant
//! otherwise.

use chiaro_syntax::tree::{Argument, Element, Expression, ExpressionKind, Name, Parameter, Statement};
use chiaro_syntax::{Diagnostic, Dialect, FileId, Sources, Span, TokenKind, tokens};
use rustc_hash::{FxHashMap, FxHashSet};

use crate::load::Library;

/// The reports about names that are misspelt however the syntax errors are mended.
pub(crate) fn certain(
    reports: Vec<Diagnostic>,
    library: &Library,
    sources: &Sources,
    syntax_errors: &[Diagnostic],
) -> Vec<Diagnostic> {
    let line = |span: Span| (span.file, sources.get(span.file).line_column(span.start).0);
    let broken: FxHashSet<(FileId, usize)> =
        syntax_errors.iter().filter_map(|error| error.span).flat_map(|span| lines(sources, span)).collect();
    let candidates: Vec<(&str, Diagnostic)> = reports
        .into_iter()
        .filter_map(|report| Some((misspelt(sources, &report)?, report)))
        .filter(|(_, report)| report.span.is_some_and(|span| !broken.contains(&line(span))))
        .collect();
    let mut uses: FxHashMap<&str, Places> = candidates.iter().map(|(name, _)| (*name, Places::default())).collect();
    for loaded in &library.files {
        let source = sources.get(loaded.id);
        for token in tokens(&source.text, Dialect::of_file(&source.name)) {
            if token.kind == TokenKind::Name
                && let Some(places) = uses.get_mut(&source.text[token.range()])
            {
                places.written += 1;
            }
        }
        statements(&loaded.tree.statements, &mut uses);
    }
    let is_certain = |name: &str| uses.get(name).is_some_and(|places| places.written == places.used);
    candidates.into_iter().filter(|(name, _)| is_certain(name)).map(|(_, report)| report).collect()
}

/// The name that a report is about, if there is one that was meant instead.
fn misspelt<'s>(sources: &'s Sources, report: &Diagnostic) -> Option<&'s str> {
    let span = report.span?;
    report.suggestion.as_ref().filter(|suggestion| suggestion.span == span)?;
    let text = sources.text(span);
    text.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '$')).then_some(text)
}

/// The lines that a span is on.
fn lines(sources: &Sources, span: Span) -> impl Iterator<Item = (FileId, usize)> {
    let line = |offset| sources.get(span.file).line_column(offset).0;
    (line(span.start)..=line(span.end)).map(move |line| (span.file, line))
}

/// How often a name is written, and how often it was read as a use.
#[derive(Default)]
struct Places {
    written: usize,
    used: usize,
}

/// The names that are looked for.
type Uses<'n> = FxHashMap<&'n str, Places>;

fn used(name: &Name, uses: &mut Uses) {
    if let Some(places) = uses.get_mut(&**name) {
        places.used += 1;
    }
}

fn statements(all: &[Statement], uses: &mut Uses) {
    for statement in all {
        match statement {
            Statement::Use(_) | Statement::Include(_) => {}
            Statement::Assignment(assignment) => expression(&assignment.value, uses),
            Statement::Module(module) => {
                parameters(&module.parameters, uses);
                statements(&module.body, uses);
            }
            Statement::Function(definition) => {
                parameters(&definition.function.parameters, uses);
                expression(&definition.function.body, uses);
            }
            Statement::Instance(instance) => {
                used(&instance.name.node, uses);
                let defines = matches!(&*instance.name.node, "for" | "intersection_for" | "let" | "assign");
                arguments(&instance.arguments, defines, uses);
                statements(&instance.children, uses);
                statements(&instance.otherwise, uses);
            }
            Statement::Block(block) => statements(block, uses),
        }
    }
}

fn parameters(all: &[Parameter], uses: &mut Uses) {
    all.iter().filter_map(|parameter| parameter.default.as_ref()).for_each(|default| expression(default, uses));
}

/// Arguments, whose names are uses unless they define something.
fn arguments(all: &[Argument], defines: bool, uses: &mut Uses) {
    for argument in all {
        if let Some(name) = argument.name.as_ref().filter(|_| !defines) {
            used(&name.node, uses);
        }
        expression(&argument.value, uses);
    }
}

fn expression(whole: &Expression, uses: &mut Uses) {
    match &*whole.kind {
        ExpressionKind::Undef
        | ExpressionKind::Bool(_)
        | ExpressionKind::Number(_)
        | ExpressionKind::String(_)
        | ExpressionKind::Error => {}
        ExpressionKind::Name(name) => used(name, uses),
        ExpressionKind::Range { start, step, end } => {
            [Some(start), step.as_ref(), Some(end)].into_iter().flatten().for_each(|part| expression(part, uses));
        }
        ExpressionKind::List(elements) => elements.iter().for_each(|part| element(part, uses)),
        ExpressionKind::Unary(_, operand) => expression(operand, uses),
        ExpressionKind::Binary(_, a, b) | ExpressionKind::Index(a, b) => {
            expression(a, uses);
            expression(b, uses);
        }
        ExpressionKind::Conditional { condition, yes, no } => {
            [condition, yes, no].into_iter().for_each(|part| expression(part, uses));
        }
        ExpressionKind::Member(list, name) => {
            expression(list, uses);
            used(&name.node, uses);
        }
        ExpressionKind::Call(callee, passed) => {
            expression(callee, uses);
            arguments(passed, false, uses);
        }
        ExpressionKind::Function(function) => {
            parameters(&function.parameters, uses);
            expression(&function.body, uses);
        }
        ExpressionKind::Let(bindings, body) => {
            arguments(bindings, true, uses);
            expression(body, uses);
        }
        ExpressionKind::Assert(passed, body) | ExpressionKind::Echo(passed, body) => {
            arguments(passed, false, uses);
            body.iter().for_each(|body| expression(body, uses));
        }
    }
}

fn element(whole: &Element, uses: &mut Uses) {
    match whole {
        Element::Value(value) => expression(value, uses),
        Element::Each(list, _) => element(list, uses),
        Element::For(bindings, body, _) | Element::Let(bindings, body, _) => {
            arguments(bindings, true, uses);
            element(body, uses);
        }
        Element::Loop { start, condition, next, body, .. } => {
            arguments(start, true, uses);
            expression(condition, uses);
            arguments(next, true, uses);
            element(body, uses);
        }
        Element::If(condition, yes, no, _) => {
            expression(condition, uses);
            element(yes, uses);
            no.iter().for_each(|no| element(no, uses));
        }
    }
}
