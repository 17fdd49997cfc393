//! The scene's parameters, as its Customizer comments describe them, and writing their values back.

use std::ops::Range;

use chiaro_syntax::tree::{Assignment, Customizer, Domain, Element, Expression, ExpressionKind, File, Statement};
use chiaro_syntax::{Dialect, FileId, parse};

use crate::edit::Edit;
use crate::literals::literal_number;
use crate::numbers::NumberLiteral;

/// The group of parameters above which no `/* [Name] */` stands.
const UNNAMED: &str = "Parameters";

/// Parameters that belong together.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// What stands in the brackets of `/* [Name] */`; "Parameters" where nothing does.
    pub name: String,
    /// The parameters, in the order of the text.
    pub parameters: Vec<Parameter>,
}

/// A variable that is meant to be changed.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Its name.
    pub name: String,
    /// The comment line above it.
    pub description: Option<String>,
    /// How it is changed.
    pub control: Control,
    /// Where its value stands.
    pub range: Range<usize>,
    /// Its value as the text has it.
    pub value: String,
}

/// How a parameter is changed.
#[derive(Clone, Debug, PartialEq)]
pub enum Control {
    /// A number between bounds.
    Slider {
        /// The value.
        value: f64,
        /// The least value.
        min: f64,
        /// The greatest value.
        max: f64,
        /// The distance of neighbouring values, if the comment says it.
        step: Option<f64>,
    },
    /// A number without bounds.
    SpinBox {
        /// The value.
        value: f64,
        /// The distance of neighbouring values, if the comment says it.
        step: Option<f64>,
    },
    /// `true` or `false`.
    CheckBox {
        /// The value.
        value: bool,
    },
    /// One of several values.
    Menu {
        /// The values.
        choices: Vec<Choice>,
        /// Which one it is, if it is one of them.
        chosen: Option<usize>,
    },
    /// A text.
    Text {
        /// The text, without quotes or escapes.
        value: String,
        /// The most characters, if the comment says it.
        max_length: Option<usize>,
    },
    /// A list of numbers.
    Vector {
        /// Where the numbers stand, and their values.
        components: Vec<NumberLiteral>,
        /// The least and the greatest value of each, if the comment says it.
        bounds: Option<(f64, f64)>,
        /// The distance of neighbouring values, if the comment says it.
        step: Option<f64>,
    },
    /// Any other literal, to be changed as text of the program.
    Expression,
}

/// A value to choose.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// The value as text of the program, quoted if it is a text.
    pub value: String,
    /// What to show for it.
    pub label: String,
}

/// The parameters of a scene, in the groups and the order in which they occur. Of a variable that is assigned twice, the
/// last value counts.
pub fn parameters(text: &str) -> Vec<Group> {
    let (file, _) = parse(FileId(0), text, Dialect::Dump);
    let mut groups: Vec<Group> = Vec::new();
    for assignment in customizable(&file) {
        let Some(customizer) = assignment.customizer.as_deref() else { continue };
        let name = customizer.group.as_deref().unwrap_or(UNNAMED);
        let parameter = parameter(text, assignment, customizer);
        match groups.iter_mut().find(|group| group.name == name) {
            Some(group) => group.parameters.push(parameter),
            None => groups.push(Group { name: name.to_owned(), parameters: vec![parameter] }),
        }
    }
    groups
}

/// The edit that gives a parameter another value, which is text of the program: `12.5`, `"abc"`, `[1, 2]`. None, if
/// there is no such parameter.
pub fn set_parameter(text: &str, name: &str, value: &str) -> Option<Edit> {
    let (file, _) = parse(FileId(0), text, Dialect::Dump);
    let assignment = customizable(&file).into_iter().find(|assignment| *assignment.name.node == *name)?;
    Some(Edit { range: assignment.value.span.range(), text: value.to_owned() })
}

/// The assignments that have Customizer comments, the last one of each variable.
fn customizable(file: &File) -> Vec<&Assignment> {
    let mut found: Vec<&Assignment> = Vec::new();
    for statement in &file.statements {
        let Statement::Assignment(assignment) = statement else { continue };
        let before = found.iter_mut().find(|before| before.name.node == assignment.name.node);
        match (before, &assignment.customizer) {
            (Some(before), _) => *before = assignment,
            (None, Some(_)) => found.push(assignment),
            (None, None) => {}
        }
    }
    found.retain(|assignment| assignment.customizer.is_some());
    found
}

fn parameter(text: &str, assignment: &Assignment, customizer: &Customizer) -> Parameter {
    let range = assignment.value.span.range();
    Parameter {
        name: assignment.name.node.to_string(),
        description: customizer.description.clone(),
        control: control(text, &assignment.value, &customizer.domain),
        value: text[range.clone()].to_owned(),
        range,
    }
}

fn control(text: &str, value: &Expression, domain: &Domain) -> Control {
    let step = match domain {
        Domain::Range { step, .. } => *step,
        Domain::Step(step) => Some(*step),
        Domain::Choices(_) | Domain::Any => None,
    };
    if let Domain::Choices(choices) = domain {
        return menu(text, value, choices);
    }
    if let Some(number) = literal_number(text, value) {
        return match domain {
            Domain::Range { min, max, .. } => Control::Slider { value: number.value, min: *min, max: *max, step },
            _ => Control::SpinBox { value: number.value, step },
        };
    }
    match &*value.kind {
        ExpressionKind::Bool(value) => Control::CheckBox { value: *value },
        ExpressionKind::String(value) => {
            let max_length = match domain {
                Domain::Range { max, .. } => Some(*max),
                _ => step,
            };
            let max_length = max_length.filter(|length| *length >= 0.0).map(|length| length as usize);
            Control::Text { value: value.to_string(), max_length }
        }
        ExpressionKind::List(elements) => match components(text, elements) {
            Some(components) => {
                let bounds = match domain {
                    Domain::Range { min, max, .. } => Some((*min, *max)),
                    _ => None,
                };
                Control::Vector { components, bounds, step }
            }
            None => Control::Expression,
        },
        _ => Control::Expression,
    }
}

/// The numbers of a list that has nothing else.
fn components(text: &str, elements: &[Element]) -> Option<Vec<NumberLiteral>> {
    let number = |element: &Element| match element {
        Element::Value(value) => literal_number(text, value),
        _ => None,
    };
    elements.iter().map(number).collect::<Option<Vec<_>>>().filter(|numbers| !numbers.is_empty())
}

fn menu(text: &str, value: &Expression, choices: &[(String, Option<String>)]) -> Control {
    let is_text = matches!(*value.kind, ExpressionKind::String(_));
    let choices: Vec<Choice> = choices
        .iter()
        .map(|(value, label)| Choice {
            value: if is_text { quoted(value) } else { value.clone() },
            label: label.clone().unwrap_or_else(|| value.clone()),
        })
        .collect();
    let is_chosen = |choice: &Choice| match &*value.kind {
        ExpressionKind::String(value) => choice.value == quoted(value),
        _ => {
            let number = literal_number(text, value).map(|number| number.value);
            choice.value == text[value.span.range()] || number.is_some() && choice.value.parse().ok() == number
        }
    };
    let chosen = choices.iter().position(is_chosen);
    Control::Menu { choices, chosen }
}

/// A text as the program writes it.
fn quoted(value: &str) -> String {
    format!("\"{}\"", value.replace('\\', "\\\\").replace('"', "\\\"").replace('\n', "\\n"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::edit::apply;

    const TEXT: &str = "// How wide\nwidth = 12.5; // [1:0.5:30]\ncount = -3; // 2\nopen = true;\n\
        /* [Look] */\nkind = \"a\"; // [a:First, b]\nsize = 20; // [10:Small, 20:Large]\n\
        label = \"x\\\"y\"; // 8\nat = [1, -2]; // [-9:9]\nrows = [[1]];\n/* [Hidden] */ secret = 1;\n";

    fn found(name: &str) -> Parameter {
        let all = parameters(TEXT).into_iter().flat_map(|group| group.parameters);
        all.into_iter().find(|parameter| parameter.name == name).expect("a parameter")
    }

    #[test]
    fn parameters_stand_in_their_groups() {
        let groups: Vec<_> = parameters(TEXT)
            .into_iter()
            .map(|group| (group.name, group.parameters.into_iter().map(|parameter| parameter.name).collect::<Vec<_>>()))
            .collect();
        let names = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>();
        assert_eq!(
            groups,
            [
                ("Parameters".to_owned(), names(&["width", "count", "open"])),
                ("Look".to_owned(), names(&["kind", "size", "label", "at", "rows"]))
            ]
        );
    }

    #[test]
    fn values_and_comments_choose_the_control() {
        let width = found("width");
        assert_eq!(width.description.as_deref(), Some("How wide"));
        assert_eq!(&TEXT[width.range], "12.5");
        assert_eq!(width.control, Control::Slider { value: 12.5, min: 1.0, max: 30.0, step: Some(0.5) });
        assert_eq!(found("count").control, Control::SpinBox { value: -3.0, step: Some(2.0) });
        assert_eq!(found("open").control, Control::CheckBox { value: true });
        assert_eq!(found("label").control, Control::Text { value: "x\"y".to_owned(), max_length: Some(8) });
        assert_eq!(found("rows").control, Control::Expression);
        let Control::Vector { components, bounds, step } = found("at").control else { panic!("a vector") };
        let components: Vec<_> = components.into_iter().map(|number| (&TEXT[number.range], number.value)).collect();
        assert_eq!((components, bounds, step), (vec![("1", 1.0), ("-2", -2.0)], Some((-9.0, 9.0)), None));
    }

    #[test]
    fn menus_offer_program_text() {
        let choice = |value: &str, label: &str| Choice { value: value.to_owned(), label: label.to_owned() };
        let choices = vec![choice("\"a\"", "First"), choice("\"b\"", "b")];
        assert_eq!(found("kind").control, Control::Menu { choices, chosen: Some(0) });
        let choices = vec![choice("10", "Small"), choice("20", "Large")];
        assert_eq!(found("size").control, Control::Menu { choices, chosen: Some(1) });
    }

    #[test]
    fn values_are_written_back() {
        let edit = set_parameter("a = 1; // [5]\nb = a;\n", "a", "2.5").expect("an edit");
        assert_eq!(apply("a = 1; // [5]\nb = a;\n", &[edit]), "a = 2.5; // [5]\nb = a;\n");
        assert_eq!(set_parameter("b = a;", "b", "1"), None);
    }

    #[test]
    fn of_two_assignments_the_last_one_counts() {
        let edit = set_parameter("a = 1;\na = 2;\n", "a", "3").expect("an edit");
        assert_eq!(apply("a = 1;\na = 2;\n", &[edit]), "a = 1;\na = 3;\n");
    }
}
