//! Scenes of modules and literals, for the tests of this folder: the language without all that is not geometry.

use std::sync::Arc;

use chiaro_solid::{ParameterId, Scalar, Solid, print};
use chiaro_syntax::tree::{Element, Expression, ExpressionKind, Instance, Statement, UnaryOperator};
use chiaro_syntax::{Diagnostic, Dialect, FileId, parse};
use chiaro_vocabulary::Interval;

use super::{Argument, Aside, Call, Facets, Stop, build, union_of};
use crate::settings::Settings;
use crate::value::Value;

/// The solid that a scene comes to, printed, or why there is none; and its warnings. In scenes, `size` is a live
/// number from 1 to 5 and `signed` one from -5 to 5.
pub(super) fn evaluate(text: &str, facets: Facets) -> (String, Vec<String>) {
    let (file, diagnostics) = parse(FileId(0), text, Dialect::Program);
    assert!(diagnostics.is_empty(), "{diagnostics:?}");
    let mut warnings = Vec::new();
    let settings = Settings { facets };
    let result = match children(&file.statements, &settings, &mut warnings) {
        Ok(children) => {
            let everything = chiaro_syntax::Span::new(FileId(0), 0..text.len());
            print(&union_of(children, everything, &mut warnings))
        }
        Err(Stop::Error(diagnostic)) => format!("error: {}\n", diagnostic.message),
        Err(Stop::Demote(demotion)) => format!("demote: {}\n", demotion.reason),
    };
    (result, warnings.into_iter().map(|warning| warning.message).collect())
}

/// What a scene without warnings comes to.
pub(super) fn solid(text: &str) -> String {
    let (solid, warnings) = evaluate(text, Facets::Auto);
    assert!(warnings.is_empty(), "{text}: {warnings:?}");
    solid
}

/// The first warning of a scene.
pub(super) fn warning(text: &str) -> String {
    evaluate(text, Facets::Auto).1.into_iter().next().unwrap_or_default()
}

fn children(
    statements: &[Statement],
    settings: &Settings,
    warnings: &mut Vec<Diagnostic>,
) -> Result<Vec<Arc<Solid>>, Stop> {
    let instances = statements.iter().map(|statement| match statement {
        Statement::Instance(instance) => instance,
        other => panic!("{other:?}"),
    });
    instances.map(|instance| instantiate(instance, settings, warnings)).collect()
}

fn instantiate(instance: &Instance, settings: &Settings, warnings: &mut Vec<Diagnostic>) -> Result<Arc<Solid>, Stop> {
    let children = children(&instance.children, settings, warnings)?;
    let argument = |argument: &chiaro_syntax::tree::Argument| Argument {
        name: argument.name.clone(),
        value: value(&argument.value),
        span: argument.value.span,
    };
    let arguments: Vec<Argument> = instance.arguments.iter().map(argument).collect();
    let number = arguments.iter().find(|argument| argument.name.as_ref().is_some_and(|name| &*name.node == "$fn"));
    let sides = number.map_or(Value::Undef, |argument| argument.value.clone());
    let only_hull = false;
    let mut aside = Aside::default();
    let (name, head) = (&*instance.name.node, instance.head);
    let call = Call { name, head, arguments, sides, only_hull, children, only_child: None, aside: &mut aside };
    build(call, settings, warnings).unwrap_or_else(|| panic!("there is no module `{}`", instance.name.node))
}

fn value(expression: &Expression) -> Value {
    match &*expression.kind {
        ExpressionKind::Undef => Value::Undef,
        ExpressionKind::Bool(truth) => Value::Bool(*truth),
        ExpressionKind::Number(number) => Value::Number(Scalar::from(*number)),
        ExpressionKind::String(text) => Value::String(text.clone()),
        ExpressionKind::Name(name) if &**name == "size" => live(0, 1.0),
        ExpressionKind::Name(name) if &**name == "signed" => live(1, -5.0),
        ExpressionKind::Name(name) if &**name == "inf" => Value::Number(Scalar::from(f64::INFINITY)),
        ExpressionKind::Unary(UnaryOperator::Negate, operand) => match value(operand) {
            Value::Number(number) => Value::Number(-number),
            other => panic!("{other:?}"),
        },
        ExpressionKind::List(elements) => {
            let element = |element: &Element| match element {
                Element::Value(expression) => value(expression),
                other => panic!("{other:?}"),
            };
            Value::List(elements.iter().map(element).collect::<Vec<_>>().into())
        }
        other => panic!("{other:?}"),
    }
}

fn live(id: u32, least: f64) -> Value {
    Value::Number(Scalar::parameter(ParameterId(id), Interval::new(least, 5.0)))
}
