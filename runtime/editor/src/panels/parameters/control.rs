//! How one parameter is changed.

use chiaro_assist::{Choice, Control, Parameter};
use egui::{ComboBox, DragValue, Slider, TextEdit, Ui};

/// The width of the number beside a slider, in points.
const NUMBER: f32 = 52.0;
/// Digits of a number that a slider was moved to.
const DIGITS: i32 = 6;

/// Shows the control for a value, which is text of the program. The new value, if the user changed it; perhaps it is no value
/// yet.
pub(super) fn show(ui: &mut Ui, parameter: &Parameter, value: &str) -> Option<String> {
    let name = parameter.name.as_str();
    match &parameter.control {
        Control::Slider { value: own, min, max, step } => slider(ui, name, first(value, *own), [*min, *max], *step),
        Control::SpinBox { value: own, step } => {
            let mut number = first(value, *own);
            let speed = step.unwrap_or_else(|| (number.abs() * 0.01).max(0.01));
            let changed = named(ui, name, |ui| ui.add(field(&mut number, speed)));
            changed.then(|| self::number(stepped(number, 0.0, *step)))
        }
        Control::CheckBox { .. } => {
            let mut is_on = value == "true";
            named(ui, name, |ui| ui.checkbox(&mut is_on, "")).then(|| is_on.to_string())
        }
        Control::Menu { choices, .. } => menu(ui, name, choices, value),
        Control::Text { max_length, .. } => {
            let mut text = unquoted(value);
            let limit = max_length.unwrap_or(usize::MAX);
            let width = ui.available_width();
            let edit = |ui: &mut Ui| ui.add(TextEdit::singleline(&mut text).char_limit(limit).desired_width(width));
            named(ui, name, edit).then(|| quoted(&text))
        }
        Control::Vector { components, bounds, step } => {
            let own: Vec<f64> = components.iter().map(|component| component.value).collect();
            let values = numbers(value).filter(|values| values.len() == own.len()).unwrap_or(own);
            vector_fields(ui, name, values, *bounds, *step)
        }
        Control::Expression => {
            let mut text = value.to_owned();
            let width = ui.available_width();
            let edit = |ui: &mut Ui| ui.add(TextEdit::singleline(&mut text).code_editor().desired_width(width));
            named(ui, name, edit).then_some(text)
        }
    }
}

/// Whether the text is a whole value: half of one, as it is being written, is not.
pub(super) fn is_value(parameter: &Parameter, text: &str) -> bool {
    match parameter.control {
        Control::Expression => chiaro_assist::parameters(&format!("x = {text}; // x"))
            .first()
            .is_some_and(|group| group.parameters.len() == 1 && group.parameters[0].value == text.trim()),
        _ => true,
    }
}

/// A number as the program writes it.
pub(super) fn number(value: f64) -> String {
    let value = if value == 0.0 { 0.0 } else { value };
    format!("{value}")
}

/// A list of numbers as the program writes it.
pub(super) fn vector(values: &[f64]) -> String {
    let values: Vec<String> = values.iter().map(|value| number(*value)).collect();
    format!("[{}]", values.join(", "))
}

/// The numbers of a number or a list of numbers.
pub(super) fn numbers(value: &str) -> Option<Vec<f64>> {
    let inside = value.trim();
    let inside = inside.strip_prefix('[').and_then(|inside| inside.strip_suffix(']')).unwrap_or(inside);
    inside.split(',').map(|number| number.trim().parse().ok()).collect()
}

fn first(value: &str, own: f64) -> f64 {
    numbers(value).and_then(|numbers| numbers.first().copied()).unwrap_or(own)
}

/// Adds a widget that has the parameter's name. Whether it changed something.
fn named(ui: &mut Ui, name: &str, add: impl FnOnce(&mut Ui) -> egui::Response) -> bool {
    let response = add(ui);
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_label(name.to_owned()));
    response.changed()
}

fn slider(ui: &mut Ui, name: &str, mut value: f64, [min, max]: [f64; 2], step: Option<f64>) -> Option<String> {
    let changed = ui.horizontal(|ui| {
        ui.spacing_mut().slider_width = (ui.available_width() - NUMBER - ui.spacing().item_spacing.x).max(40.0);
        let mut slider = Slider::new(&mut value, min..=max).clamping(egui::SliderClamping::Edits).show_value(false);
        if let Some(step) = step {
            slider = slider.step_by(step);
        }
        let is_dragged = named(ui, name, |ui| ui.add(slider));
        let speed = step.unwrap_or(0.002 * (max - min));
        let field = field(&mut value, speed).range(min..=max).clamp_existing_to_range(false);
        let size = [NUMBER, ui.spacing().interact_size.y];
        let is_typed = named(ui, &format!("{name} as a number"), |ui| ui.add_sized(size, field));
        is_dragged || is_typed
    });
    changed.inner.then(|| number(if step.is_some() { stepped(value, min, step) } else { rounded(value, max - min) }))
}

/// A field for a number, which is shown as the program writes it.
fn field(value: &mut f64, speed: f64) -> DragValue<'_> {
    let formatted = |value: f64, _| number(rounded(value, value.abs().max(1.0)));
    DragValue::new(value).speed(speed).custom_formatter(formatted)
}

/// The nearest value that is a number of steps from the least one, without the noise of adding them up.
fn stepped(value: f64, min: f64, step: Option<f64>) -> f64 {
    match step {
        Some(step) if step > 0.0 => rounded(min + ((value - min) / step).round() * step, step),
        _ => rounded(value, value.abs().max(1.0)),
    }
}

/// With some digits behind the first one of a range.
fn rounded(value: f64, range: f64) -> f64 {
    let scale = 10_f64.powi(DIGITS - 1 - range.abs().max(f64::MIN_POSITIVE).log10().floor() as i32);
    let rounded = (value * scale).round() / scale;
    if rounded.is_finite() { rounded } else { value }
}

fn menu(ui: &mut Ui, name: &str, choices: &[Choice], value: &str) -> Option<String> {
    let number = |text: &str| text.parse::<f64>().ok();
    let is_chosen =
        |choice: &Choice| choice.value == value || number(value).is_some() && number(&choice.value) == number(value);
    let chosen = choices.iter().find(|choice| is_chosen(choice));
    let mut next = None;
    let shown = chosen.map_or(value, |choice| choice.label.as_str());
    let width = ui.available_width() - 8.0;
    let combo = ComboBox::from_id_salt(name).selected_text(shown).width(width).show_ui(ui, |ui| {
        for choice in choices {
            if ui.selectable_label(is_chosen(choice), &choice.label).clicked() {
                next = Some(choice.value.clone());
            }
        }
    });
    ui.ctx().accesskit_node_builder(combo.response.id, |node| node.set_label(name.to_owned()));
    next.filter(|next| next != value)
}

fn vector_fields(
    ui: &mut Ui,
    name: &str,
    mut values: Vec<f64>,
    bounds: Option<(f64, f64)>,
    step: Option<f64>,
) -> Option<String> {
    let mut is_changed = false;
    let range = bounds.map_or(f64::NEG_INFINITY..=f64::INFINITY, |(min, max)| min..=max);
    ui.horizontal_wrapped(|ui| {
        for (index, value) in values.iter_mut().enumerate() {
            let speed = step.unwrap_or_else(|| (value.abs() * 0.01).max(0.01));
            let drag = field(value, speed).range(range.clone());
            let axis = ["x", "y", "z"].get(index).map_or_else(|| index.to_string(), |axis| (*axis).to_owned());
            if named(ui, &format!("{name} {axis}"), |ui| ui.add(drag)) {
                *value = stepped(*value, bounds.map_or(0.0, |(min, _)| min), step);
                is_changed = true;
            }
        }
    });
    is_changed.then(|| vector(&values))
}

/// A text without its quotes and escapes.
fn unquoted(value: &str) -> String {
    let inside = value.trim().strip_prefix('"').and_then(|inside| inside.strip_suffix('"')).unwrap_or(value);
    let mut text = String::new();
    let mut letters = inside.chars();
    while let Some(letter) = letters.next() {
        match (letter, letter == '\\') {
            (_, true) => match letters.next() {
                Some('n') => text.push('\n'),
                Some('t') => text.push('\t'),
                Some(other) => text.push(other),
                None => {}
            },
            (letter, false) => text.push(letter),
        }
    }
    text
}

/// A text as the program writes it.
fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\"").replace('\n', "\\n"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_leave_no_noise() {
        assert_eq!(number(stepped(1.3000001, 1.0, Some(0.1))), "1.3");
        assert_eq!(number(stepped(0.7, 0.0, Some(0.5))), "0.5");
        assert_eq!(number(rounded(12.345678912, 30.0)), "12.3457");
        assert_eq!(number(-0.0), "0");
    }

    #[test]
    fn texts_keep_their_quotes() {
        for text in ["", "plain", "a \"b\" \\ c", "two\nlines"] {
            assert_eq!(unquoted(&quoted(text)), text);
        }
    }

    #[test]
    fn lists_are_read_as_they_are_written() {
        assert_eq!(numbers(&vector(&[1.0, -2.5])), Some(vec![1.0, -2.5]));
        assert_eq!(numbers("[1, a]"), None);
    }
}
