//! Live numbers: which parameters stay symbolic, and which ones had to become structural.

use std::sync::Arc;

use chiaro_solid::{LiveParameter, ParameterId, Scalar};
use chiaro_syntax::tree::{Assignment, Customizer, Domain};
use chiaro_syntax::{Diagnostic, FileId, Span};
use chiaro_vocabulary::Interval;

use crate::geometry::Demotion;
use crate::options::{LiveLiteral, Options};
use crate::value::Value;

/// What the names of parameters begin with that are numbers in the text; no variable's name does.
const LITERAL: char = '@';
/// More parameters than this have one note for all of them.
const MOST_NOTES: usize = 3;
/// For how many of them a note for all shows where they decide.
const MOST_PLACES: usize = 6;
/// The scene's own file.
const MAIN_FILE: FileId = FileId(0);

/// A parameter that may be live: a variable's name, and which component of it.
type Key = (Arc<str>, Option<usize>);

/// The live parameters of one evaluation.
pub(crate) struct Live<'t> {
    structural: &'t Structural,
    /// Whether all of them are taken as structural.
    frozen: bool,
    /// The parameters, in the order of their ids.
    pub(crate) parameters: Vec<LiveParameter>,
    literals: Literals<'t>,
    time: Option<Scalar>,
    default_time: f64,
}

/// The numbers in the text that are live.
struct Literals<'t> {
    wanted: &'t [LiveLiteral],
    /// Those that were met so far, by where they start: a loop meets its literals many times.
    met: Vec<(u32, Scalar)>,
}

/// The parameters that are known to decide the structure of the scene, with the notes that say where.
#[derive(Default)]
pub(crate) struct Structural {
    keys: Vec<Key>,
    /// One for each of them that has a name, with that.
    notes: Vec<(String, Diagnostic)>,
}

impl Structural {
    /// Makes the parameters in some numbers structural, and if there are any, perhaps all others too. Answers whether
    /// there are any.
    pub(crate) fn demote(&mut self, demotions: &[Demotion], parameters: &[LiveParameter], all: bool) -> bool {
        let before = self.keys.len();
        for demotion in demotions {
            demotion.number.visit_parameters(&mut |ParameterId(id)| {
                let Some(parameter) = parameters.get(id as usize) else { return };
                self.add(parameter, demotion);
            });
        }
        if let Some(last) = demotions.last().filter(|_| all) {
            parameters.iter().for_each(|parameter| self.add(parameter, last));
        }
        self.keys.len() > before
    }

    /// What there is to say about them: a note for each, or one for all if they are many.
    pub(crate) fn notes(self) -> Vec<Diagnostic> {
        if self.notes.len() <= MOST_NOTES {
            return self.notes.into_iter().map(|(_, note)| note).collect();
        }
        let names: Vec<String> = self.notes.iter().map(|(name, _)| format!("`{name}`")).collect();
        let message =
            format!("{} decide the structure of the scene, so that changing them recompiles", names.join(", "));
        let places = self.notes.into_iter().filter_map(|(name, note)| Some((name, note.span?, note.label?)));
        let places: Vec<_> = places.take(MOST_PLACES).collect();
        let first = places.first().map(|(_, place, _)| *place);
        let note = Diagnostic::note(first, message);
        vec![
            places
                .into_iter()
                .fold(note, |note, (name, place, reason)| note.with_related(place, format!("`{name}`: {reason}"))),
        ]
    }

    fn add(&mut self, parameter: &LiveParameter, demotion: &Demotion) {
        let key = (parameter.name.clone(), parameter.component);
        if !self.keys.contains(&key) {
            if !parameter.name.starts_with(LITERAL) {
                self.notes.push(note(parameter, demotion));
            }
            self.keys.push(key);
        }
    }
}

fn note(parameter: &LiveParameter, demotion: &Demotion) -> (String, Diagnostic) {
    let name = match parameter.component {
        Some(component) => format!("{}[{component}]", parameter.name),
        None => parameter.name.to_string(),
    };
    let note = if demotion.number.is_finite() {
        let message = format!("`{name}` decides the structure of the scene here, so that changing it recompiles");
        Diagnostic::note(demotion.span, message).with_label(demotion.reason)
    } else {
        let Interval { min, max } = parameter.range;
        let message =
            format!("changing `{name}` recompiles, because this may not be a finite number for all its values");
        Diagnostic::note(demotion.span, message)
            .with_label(format!("with `{name}` anywhere from {min} to {max}"))
            .with_hint("a smaller range, or a limit such as `min`, `max` or `? :` around what fails, keeps it live")
    };
    let note = match parameter.span {
        Some(span) => note.with_related(span, "the parameter"),
        None => note,
    };
    (name, note)
}

impl<'t> Live<'t> {
    /// No parameters yet.
    pub(crate) fn new(structural: &'t Structural, options: &'t Options) -> Self {
        let literals = Literals { wanted: &options.live_literals, met: Vec::new() };
        let frozen = options.frozen;
        Self { structural, frozen, parameters: Vec::new(), literals, time: None, default_time: 0.0 }
    }

    /// What a top-level variable stands for: its value, with numbers replaced by live parameters if its Customizer
    /// comment gives them a range.
    pub(crate) fn assigned(&mut self, assignment: &Assignment, value: Value) -> Value {
        let Some(customizer) = assignment.customizer.as_deref() else { return value };
        let Domain::Range { min, step, max } = customizer.domain else { return value };
        if !(min.is_finite() && max.is_finite()) {
            return value;
        }
        let range = Slider { assignment, customizer, range: Interval::new(min, max), step };
        match &value {
            Value::Number(number) => Value::Number(self.parameter(&range, number, None)),
            Value::List(list) if list.iter().all(|value| matches!(value, Value::Number(_))) => {
                let numbers = list.iter().enumerate().map(|(component, value)| match value {
                    Value::Number(number) => Value::Number(self.parameter(&range, number, Some(component))),
                    other => other.clone(),
                });
                Value::list(numbers.collect())
            }
            _ => value,
        }
    }

    /// What a number in the text stands for: a live parameter, if the caller wants that of it.
    pub(crate) fn literal(&mut self, number: f64, span: Span) -> Scalar {
        let is_it = |literal: &&LiveLiteral| literal.start == span.start as usize && span.file == MAIN_FILE;
        let Some(literal) = self.literals.wanted.iter().find(is_it) else {
            return Scalar::Constant(number);
        };
        if let Some((_, scalar)) = self.literals.met.iter().find(|(start, _)| *start == span.start) {
            return scalar.clone();
        }
        let name: Arc<str> = format!("{LITERAL}{}", span.start).into();
        if !number.is_finite() || self.is_structural(&name, None) {
            return Scalar::Constant(number);
        }
        let scalar = self.add(LiveParameter {
            name,
            default: number,
            range: literal.range.hull(Interval::point(number)),
            step: None,
            description: None,
            group: None,
            component: None,
            span: Some(span),
        });
        self.literals.met.push((span.start, scalar.clone()));
        scalar
    }

    fn parameter(&mut self, slider: &Slider, number: &Scalar, component: Option<usize>) -> Scalar {
        let name = &slider.assignment.name.node;
        let default = match number.constant() {
            Some(default) if default.is_finite() && !self.is_structural(name, component) => default,
            _ => return number.clone(),
        };
        self.add(LiveParameter {
            name: name.clone().into(),
            default,
            range: slider.range.hull(Interval::point(default)),
            step: slider.step,
            description: slider.customizer.description.clone(),
            group: slider.customizer.group.clone(),
            component,
            span: Some(slider.assignment.span),
        })
    }

    /// Sets what `$t` is until it is moved.
    pub(crate) fn set_time(&mut self, time: f64) {
        if time.is_finite() {
            self.default_time = time;
        }
    }

    /// `$t`: the time, from 0 to 1.
    pub(crate) fn time(&mut self) -> Scalar {
        if self.is_structural("$t", None) {
            return Scalar::Constant(self.default_time);
        }
        if let Some(time) = &self.time {
            return time.clone();
        }
        let time = self.add(LiveParameter {
            name: "$t".into(),
            default: self.default_time,
            range: Interval::new(0.0, 1.0).hull(Interval::point(self.default_time)),
            step: None,
            description: None,
            group: None,
            component: None,
            span: None,
        });
        self.time = Some(time.clone());
        time
    }

    fn is_structural(&self, name: &str, component: Option<usize>) -> bool {
        self.frozen || self.structural.keys.iter().any(|(other, at)| &**other == name && *at == component)
    }

    fn add(&mut self, parameter: LiveParameter) -> Scalar {
        let scalar = Scalar::parameter(ParameterId(self.parameters.len() as u32), parameter.range);
        self.parameters.push(parameter);
        scalar
    }

    /// A demotion of that number.
    pub(crate) fn demotion(number: Scalar, span: Span, reason: &'static str) -> Box<Demotion> {
        Box::new(Demotion { number, span, reason })
    }
}

/// What a Customizer comment says of an assignment.
struct Slider<'a> {
    assignment: &'a Assignment,
    customizer: &'a Customizer,
    range: Interval,
    step: Option<f64>,
}
