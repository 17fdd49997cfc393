//! The numbers behind a shape: which arguments of a call are written out somewhere, and so can be dragged.

use std::ops::Range;

use chiaro_syntax::tree::{Argument, Element, Expression, ExpressionKind, File, Instance, Statement, UnaryOperator};
use chiaro_syntax::{Dialect, FileId, Token, TokenKind, parse};

use crate::index::{Index, Namespace, Role, What};
use crate::numbers::{NumberLiteral, numbers, value};
use crate::{manual, tokens};

/// An argument of a call.
#[derive(Clone, Debug, PartialEq)]
pub struct CallArgument {
    /// The parameter it is for, if that is known: the name in front of it, or the parameter that its position means.
    pub parameter: Option<String>,
    /// Whether the name stands in front of it.
    pub named: bool,
    /// Where the value stands.
    pub range: Range<usize>,
    /// What the value is.
    pub value: Literal,
}

/// What an argument's value is, as the text has it.
#[derive(Clone, Debug, PartialEq)]
pub enum Literal {
    /// A number that can be changed in the text: where it is used, or where a variable is set to it.
    Number(NumberLiteral),
    /// A list whose elements are written one by one.
    List(Vec<Literal>),
    /// A text, a truth value or `undef`.
    Other,
    /// A value that comes about by computing, and why it can't be changed here.
    Computed(String),
}

/// The arguments of the module's instance whose name and arguments, or whole text, `span` is: the innermost one that
/// begins there. None, if no instance begins there.
pub fn literals_of_call(text: &str, span: Range<usize>) -> Option<Vec<CallArgument>> {
    let (file, _) = parse(FileId(0), text, Dialect::Dump);
    let instance = find(&file, &span)?;
    let index = Index::of_tree(text, &file);
    let names = parameters(&index, instance);
    let mut unnamed = names.iter().filter(|name| !instance.arguments.iter().any(|argument| is_for(argument, name)));
    let arguments = instance.arguments.iter().map(|argument| CallArgument {
        parameter: match &argument.name {
            Some(name) => Some(name.node.to_string()),
            None => unnamed.next().cloned(),
        },
        named: argument.name.is_some(),
        range: argument.value.span.range(),
        value: literal(text, &index, &argument.value),
    });
    Some(arguments.collect())
}

fn is_for(argument: &Argument, parameter: &str) -> bool {
    argument.name.as_ref().is_some_and(|name| *name.node == *parameter)
}

/// The instance whose head, or whole text, begins where the span does; the best fit if there are several.
fn find<'a>(file: &'a File, span: &Range<usize>) -> Option<&'a Instance> {
    let mut best: Option<&Instance> = None;
    visit(&file.statements, &mut |instance| {
        let fits = instance.head.start as usize == span.start || instance.span.start as usize == span.start;
        let distance = |instance: &Instance| (instance.head.end as usize).abs_diff(span.end);
        if fits && best.is_none_or(|best| distance(instance) < distance(best)) {
            best = Some(instance);
        }
    });
    best
}

/// Shows every instance of some statements.
fn visit<'a>(statements: &'a [Statement], show: &mut impl FnMut(&'a Instance)) {
    for statement in statements {
        match statement {
            Statement::Instance(instance) => {
                show(instance);
                visit(&instance.children, show);
                visit(&instance.otherwise, show);
            }
            Statement::Module(module) => visit(&module.body, show),
            Statement::Block(block) => visit(block, show),
            _ => {}
        }
    }
}

/// The names of the parameters that arguments without a name go to, in order.
fn parameters(index: &Index, instance: &Instance) -> Vec<String> {
    let is_name = |occurrence: &&crate::index::Occurrence| {
        occurrence.range == instance.name.span.range() && occurrence.role == Role::Of(Namespace::Module)
    };
    let own = index.occurrences.iter().find(is_name).and_then(|occurrence| occurrence.definition);
    match own.map(|own| &index.definitions[own].parameters) {
        Some(parameters) => parameters.iter().map(|id| index.definitions[*id].name.to_string()).collect(),
        None => {
            let entry = manual::module(&instance.name.node);
            let parameters = entry.iter().flat_map(|entry| entry.parameters.iter());
            parameters.filter(|parameter| parameter.positional).map(|parameter| parameter.name.to_owned()).collect()
        }
    }
}

fn literal(text: &str, index: &Index, expression: &Expression) -> Literal {
    if let Some(number) = literal_number(text, expression).or_else(|| number_of_variable(text, index, expression)) {
        return Literal::Number(number);
    }
    match &*expression.kind {
        ExpressionKind::Undef | ExpressionKind::Bool(_) | ExpressionKind::String(_) => Literal::Other,
        ExpressionKind::List(elements) if elements.iter().all(|element| matches!(element, Element::Value(_))) => {
            let values = elements.iter().filter_map(|element| match element {
                Element::Value(value) => Some(literal(text, index, value)),
                _ => None,
            });
            Literal::List(values.collect())
        }
        _ => Literal::Computed(reason(text, expression)),
    }
}

/// The number that a variable of the text is set to, if the expression is its name.
fn number_of_variable(text: &str, index: &Index, expression: &Expression) -> Option<NumberLiteral> {
    let ExpressionKind::Name(_) = &*expression.kind else { return None };
    let occurrence = index.occurrences.iter().find(|occurrence| occurrence.range == expression.span.range())?;
    let definition = &index.definitions[occurrence.definition?];
    let value = definition.value.clone().filter(|_| definition.what == What::Variable)?;
    numbers(text).into_iter().find(|number| number.range == value)
}

/// Why a value can't be changed where it is used.
fn reason(text: &str, expression: &Expression) -> String {
    let inside = text.get(expression.span.range()).unwrap_or_default();
    let tokens = tokens(inside);
    let is_variable = |(at, token): &(usize, &Token)| {
        let next = tokens[at + 1..].iter().find(|token| !token.kind.is_comment()).map(|token| token.kind);
        token.kind == TokenKind::Name && !matches!(next, Some(TokenKind::OpenParenthesis | TokenKind::Assign))
    };
    let mut names: Vec<&str> = Vec::new();
    for (_, token) in tokens.iter().enumerate().filter(is_variable) {
        let name = &inside[token.range()];
        if !names.contains(&name) {
            names.push(name);
        }
    }
    match names[..] {
        [] => "computed here".to_owned(),
        [name] => format!("computed from `{name}`"),
        [first, second] => format!("computed from `{first}` and `{second}`"),
        [first, ..] => format!("computed from `{first}` and {} others", names.len() - 1),
    }
}

/// The number that an expression is, if it is written out, perhaps in parentheses.
pub(crate) fn literal_number(text: &str, expression: &Expression) -> Option<NumberLiteral> {
    let negative = match &*expression.kind {
        ExpressionKind::Number(_) => false,
        ExpressionKind::Unary(UnaryOperator::Negate, operand) if matches!(*operand.kind, ExpressionKind::Number(_)) => {
            true
        }
        _ => return None,
    };
    let span = expression.span.range();
    let inside = text.get(span.clone())?;
    let tokens = tokens(inside);
    let number = tokens.iter().find(|token| token.kind == TokenKind::Number)?;
    let sign = tokens.windows(2).find(|pair| pair[0].kind == TokenKind::Minus && pair[1] == *number);
    if negative != sign.is_some() {
        return None;
    }
    let start = sign.map_or(number.start, |pair| pair[0].start) as usize;
    let magnitude = value(&inside[number.range()]);
    let value = if negative { -magnitude } else { magnitude };
    Some(NumberLiteral { range: span.start + start..span.start + number.end as usize, value, negative })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Parameter and value of each argument of the first instance of `module`.
    fn arguments(text: &str, module: &str) -> Vec<(String, String)> {
        let start = text.find(module).expect("the module");
        let arguments = literals_of_call(text, start..start + module.len()).expect("an instance");
        let shown = |argument: CallArgument| (argument.parameter.unwrap_or_default(), show(text, &argument.value));
        arguments.into_iter().map(shown).collect()
    }

    fn show(text: &str, literal: &Literal) -> String {
        match literal {
            Literal::Number(number) => format!("{} = {}", &text[number.range.clone()], number.value),
            Literal::List(list) => {
                format!("[{}]", list.iter().map(|literal| show(text, literal)).collect::<Vec<_>>().join(", "))
            }
            Literal::Other => "other".to_owned(),
            Literal::Computed(why) => why.clone(),
        }
    }

    fn pair(parameter: &str, value: &str) -> (String, String) {
        (parameter.to_owned(), value.to_owned())
    }

    #[test]
    fn numbers_are_found_in_lists_and_parentheses() {
        assert_eq!(
            arguments("translate([10, -0.5, (3)]) cube(1);", "translate"),
            [pair("v", "[10 = 10, -0.5 = -0.5, 3 = 3]")]
        );
        assert_eq!(arguments("union() { sphere(r = -(4)); }", "sphere"), [pair("r", "computed here")]);
    }

    #[test]
    fn what_is_computed_says_from_what() {
        let text = "a = 2 + 1; cube([a, 2, 2 * a + b], center = true, r = sin(30));";
        assert_eq!(
            arguments(text, "cube"),
            [
                pair("size", "[computed from `a`, 2 = 2, computed from `a` and `b`]"),
                pair("center", "other"),
                pair("r", "computed here"),
            ]
        );
    }

    #[test]
    fn the_number_behind_a_variable_is_where_it_is_set() {
        let text = "a = -2; cube([a, 1, c]); module leg(h = 3) { b = 7; cylinder(h, b); } for (i = [0:2]) sphere(i);";
        assert_eq!(arguments(text, "cube"), [pair("size", "[-2 = -2, 1 = 1, computed from `c`]")]);
        assert_eq!(arguments(text, "cylinder"), [pair("h", "computed from `h`"), pair("r1", "7 = 7")]);
        assert_eq!(arguments(text, "sphere"), [pair("r", "computed from `i`")]);
    }

    #[test]
    fn positions_mean_the_parameters_that_are_not_named() {
        assert_eq!(
            arguments("cylinder(20, r1 = 3, 2);", "cylinder"),
            [pair("h", "20 = 20"), pair("r1", "3 = 3"), pair("r2", "2 = 2"),]
        );
        let text = "module wall(l, h = 2) cube([l, 1, h]); wall(3, 4); rest();";
        let start = text.rfind("wall").expect("the call");
        let found = literals_of_call(text, start..start + 10).expect("an instance");
        assert_eq!(found[1].parameter.as_deref(), Some("h"));
        assert_eq!(literals_of_call(text, 1..3), None);
    }
}
