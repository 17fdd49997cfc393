//! Function literals as text, fully bracketed as OpenSCAD writes them.

use chiaro_syntax::tree::{Argument, Element, Expression, ExpressionKind, FunctionLiteral, Parameter, UnaryOperator};

use super::{operators, text};

/// Appends a function literal.
pub(super) fn function(function: &FunctionLiteral, text: &mut String) {
    text.push_str("function(");
    separated(text, &function.parameters, parameter);
    text.push_str(") ");
    expression(&function.body, text);
}

fn parameter(parameter: &Parameter, text: &mut String) {
    text.push_str(&parameter.name.node);
    if let Some(default) = &parameter.default {
        text.push_str(" = ");
        expression(default, text);
    }
}

fn expression(e: &Expression, text: &mut String) {
    match &*e.kind {
        ExpressionKind::Undef | ExpressionKind::Error => text.push_str("undef"),
        ExpressionKind::Bool(value) => text.push_str(if *value { "true" } else { "false" }),
        ExpressionKind::Number(value) => text.push_str(&text::number(*value)),
        ExpressionKind::String(value) => {
            text.push('"');
            text.push_str(value);
            text.push('"');
        }
        ExpressionKind::Name(name) => text.push_str(name),
        ExpressionKind::Range { start, step, end } => {
            text.push('[');
            expression(start, text);
            for part in step.iter().chain([end]) {
                text.push_str(" : ");
                expression(part, text);
            }
            text.push(']');
        }
        ExpressionKind::List(elements) => {
            text.push('[');
            separated(text, elements, element);
            text.push(']');
        }
        ExpressionKind::Unary(UnaryOperator::Plus, operand) => expression(operand, text),
        ExpressionKind::Unary(operator, operand) => {
            text.push_str(operators::unary_sign(*operator));
            expression(operand, text);
        }
        ExpressionKind::Binary(operator, a, b) => {
            joined(text, "(", a, &format!(" {} ", operators::sign(*operator)), b, ")");
        }
        ExpressionKind::Conditional { condition, yes, no } => {
            joined(text, "(", condition, " ? ", yes, " : ");
            expression(no, text);
            text.push(')');
        }
        ExpressionKind::Index(list, index) => joined(text, "", list, "[", index, "]"),
        ExpressionKind::Member(value, name) => {
            expression(value, text);
            text.push('.');
            text.push_str(&name.node);
        }
        ExpressionKind::Call(callee, values) => call(callee, values, text),
        ExpressionKind::Function(literal) => function(literal, text),
        ExpressionKind::Let(bindings, body) => clause("let(", bindings, Some(body), text),
        ExpressionKind::Assert(values, body) => clause("assert(", values, body.as_ref(), text),
        ExpressionKind::Echo(values, body) => clause("echo(", values, body.as_ref(), text),
    }
}

fn call(callee: &Expression, values: &[Argument], text: &mut String) {
    match &*callee.kind {
        ExpressionKind::Name(name) => text.push_str(name),
        _ => {
            text.push('(');
            expression(callee, text);
            text.push(')');
        }
    }
    text.push('(');
    separated(text, values, argument);
    text.push(')');
}

fn joined(text: &mut String, before: &str, a: &Expression, between: &str, b: &Expression, after: &str) {
    text.push_str(before);
    expression(a, text);
    text.push_str(between);
    expression(b, text);
    text.push_str(after);
}

fn clause(head: &str, values: &[Argument], body: Option<&Expression>, text: &mut String) {
    text.push_str(head);
    separated(text, values, argument);
    text.push(')');
    if let Some(body) = body {
        text.push(' ');
        expression(body, text);
    }
}

fn argument(argument: &Argument, text: &mut String) {
    if let Some(name) = &argument.name {
        text.push_str(&name.node);
        text.push_str(" = ");
    }
    expression(&argument.value, text);
}

fn element(e: &Element, text: &mut String) {
    match e {
        Element::Value(value) => expression(value, text),
        Element::Each(inner, _) => bracketed("each (", inner, text),
        Element::For(bindings, body, _) => {
            text.push_str("for(");
            separated(text, bindings, argument);
            bracketed(") (", body, text);
        }
        Element::Loop { start, condition, next, body, .. } => {
            text.push_str("for(");
            separated(text, start, argument);
            text.push(';');
            expression(condition, text);
            text.push(';');
            separated(text, next, argument);
            text.push_str(") ");
            element(body, text);
        }
        Element::If(condition, yes, no, _) => {
            text.push_str("if(");
            expression(condition, text);
            bracketed(") (", yes, text);
            if let Some(no) = no {
                bracketed(" else (", no, text);
            }
        }
        Element::Let(bindings, body, _) => {
            text.push_str("let(");
            separated(text, bindings, argument);
            bracketed(") (", body, text);
        }
    }
}

fn bracketed(before: &str, body: &Element, text: &mut String) {
    text.push_str(before);
    element(body, text);
    text.push(')');
}

fn separated<T>(text: &mut String, items: &[T], write: impl Fn(&T, &mut String)) {
    for (at, item) in items.iter().enumerate() {
        if at > 0 {
            text.push_str(", ");
        }
        write(item, text);
    }
}
