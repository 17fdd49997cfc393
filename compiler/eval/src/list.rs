//! The elements of lists, comprehensions among them, and the loops over values that they share with modules.

use std::rc::Rc;

use chiaro_syntax::tree::{Argument, Element, Expression, Name};
use chiaro_syntax::{Diagnostic, Span};

use crate::evaluator::{Evaluator, Halt, Result};
use crate::live::Live;
use crate::scope::{Scope, Specials};
use crate::value::{Elements, List, Range, Value};

impl<'t> Evaluator<'t> {
    /// Appends the values of a list's elements.
    pub(crate) fn elements(&mut self, elements: &[Element], scope: &Rc<Scope>, values: &mut Elements) -> Result<()> {
        elements.iter().try_for_each(|element| self.element(element, scope, values))
    }

    fn element(&mut self, element: &Element, scope: &Rc<Scope>, values: &mut Elements) -> Result<()> {
        if let Element::Value(value) = element {
            let value = self.expression(value, scope)?;
            return self.push(value, values, element_span(element));
        }
        self.enter(element_span(element))?;
        let mark = self.specials.mark();
        let result = self.comprehension(element, scope, values);
        self.specials.restore(mark);
        self.leave();
        result
    }

    fn comprehension(&mut self, element: &Element, scope: &Rc<Scope>, values: &mut Elements) -> Result<()> {
        match element {
            Element::Value(_) => Ok(()),
            Element::Each(inner, span) => {
                let mut lists = Elements::with_capacity(1);
                self.element(inner, scope, &mut lists)?;
                List::from(lists).iter().try_for_each(|list| self.spread(list.clone(), *span, values))
            }
            Element::For(bindings, body, span) => {
                self.for_each(bindings, scope, *span, &mut |evaluator, scope| evaluator.element(body, scope, values))
            }
            Element::Loop { start, condition, next, body, span } => {
                let start = self.bound_in_turn(start, scope)?;
                self.loop_while(&start, condition, next, body, *span, values)
            }
            Element::If(condition, yes, no, _) => {
                let truth = self.decided(condition, scope, "whether a list has an element")?;
                match (truth, no) {
                    (true, _) => self.element(yes, scope, values),
                    (false, Some(no)) => self.element(no, scope, values),
                    (false, None) => Ok(()),
                }
            }
            Element::Let(bindings, body, _) => {
                let scope = self.bound_in_turn(bindings, scope)?;
                self.element(body, &scope, values)
            }
        }
    }

    /// `for (start; condition; next) body`
    fn loop_while(
        &mut self,
        start: &Rc<Scope>,
        condition: &Expression,
        next: &[Argument],
        body: &Element,
        span: Span,
        values: &mut Elements,
    ) -> Result<()> {
        let mut round = start.clone();
        for _ in 0..=self.options.limits.rounds {
            if !self.decided(condition, &round, "how often a loop runs")? {
                return Ok(());
            }
            self.element(body, &round, values)?;
            // The next round's variables see this one's while they are computed, but are no part of its scope, so
            // that scopes do not pile up.
            let computed = self.bound_in_turn(next, &round)?;
            round = Rc::new(computed.copied_into(start));
        }
        Err(self.too_many_rounds(span))
    }

    /// Runs `body` for every combination of the variables' values.
    pub(crate) fn for_each(
        &mut self,
        bindings: &[Argument],
        scope: &Rc<Scope>,
        span: Span,
        body: &mut dyn FnMut(&mut Self, &Rc<Scope>) -> Result<()>,
    ) -> Result<()> {
        let Some((binding, inner)) = bindings.split_first() else { return body(self, scope) };
        let value = self.expression(&binding.value, scope)?;
        let Some(name) = binding.name.as_ref().map(|name| name.node.clone()) else {
            let error = Diagnostic::error(binding.value.span, "a loop needs a variable: `for (i = …)`");
            return Err(self.error(error));
        };
        let mut round = |evaluator: &mut Self, value: Value| {
            evaluator.charge(1, span)?;
            let scope = evaluator.with_variable(&name, value, scope);
            let mark = evaluator.specials.mark();
            let result = evaluator.for_each(inner, &scope, span, body);
            evaluator.specials.restore(mark);
            result
        };
        match value {
            Value::Range(range) => {
                let mut numbers = self.listed(&range, binding.value.span)?;
                numbers.try_for_each(|number| round(self, Value::number(number)))
            }
            Value::List(list) => list.iter().try_for_each(|value| round(self, value.clone())),
            Value::String(text) => text.chars().try_for_each(|c| round(self, Value::string(c.to_string()))),
            Value::Undef => Ok(()),
            other => round(self, other),
        }
    }

    fn with_variable(&mut self, name: &Name, value: Value, scope: &Rc<Scope>) -> Rc<Scope> {
        if Specials::is_special(name) {
            self.specials.set(name.clone(), Some(value));
            return scope.clone();
        }
        let inner = Scope::within(scope);
        inner.set(name.clone(), Some(value));
        Rc::new(inner)
    }

    /// The numbers of a range. Of one that never ends there are none, as in OpenSCAD, with a warning.
    pub(crate) fn listed(&mut self, range: &Range, span: Span) -> Result<impl Iterator<Item = f64> + use<>> {
        let limit = self.options.limits.rounds;
        let count = range.len();
        if range.is_endless() {
            let message = match range.step {
                0.0 => "the step of this range is zero, so that it never ends",
                _ => "this range never ends",
            };
            self.warn(Diagnostic::warning(span, message).with_label("none of its numbers is used"));
        } else if count > limit {
            return Err(self.error(Diagnostic::error(span, format!("this range has more than {limit} numbers"))));
        }
        let range = if range.is_endless() { Range::EMPTY } else { *range };
        self.charge(u64::from(range.len()), span)?;
        Ok(range.iter())
    }

    /// Whether a condition is true; a live one is demoted for that reason.
    pub(crate) fn decided(&mut self, condition: &Expression, scope: &Rc<Scope>, reason: &'static str) -> Result<bool> {
        match self.expression(condition, scope)?.truth() {
            Value::Condition(number) => Err(Halt::Demote(Live::demotion(number, condition.span, reason))),
            truth => Ok(truth.is_true()),
        }
    }

    /// Appends what a value that follows `each` holds.
    fn spread(&mut self, value: Value, span: Span, values: &mut Elements) -> Result<()> {
        match value {
            Value::Undef => Ok(()),
            Value::List(list) => list.iter().try_for_each(|value| self.push(value.clone(), values, span)),
            Value::Range(range) => {
                let mut numbers = self.listed(&range, span)?;
                numbers.try_for_each(|number| self.push(Value::number(number), values, span))
            }
            Value::String(text) => text.chars().try_for_each(|c| self.push(Value::string(c.to_string()), values, span)),
            other => self.push(other, values, span),
        }
    }

    /// Appends a value to a list in the making, if that is within the limits.
    pub(crate) fn push(&mut self, value: Value, values: &mut Elements, span: Span) -> Result<()> {
        self.charge(1, span)?;
        values.push(value);
        self.check_lists(values.len(), values.weight(), span)
    }

    fn too_many_rounds(&mut self, span: Span) -> Halt {
        let message = format!("this loop runs more than {} times", self.options.limits.rounds);
        self.error(Diagnostic::error(span, message))
    }
}

fn element_span(element: &Element) -> Span {
    match element {
        Element::Value(value) => value.span,
        Element::Each(_, span) | Element::For(_, _, span) | Element::If(_, _, _, span) | Element::Let(_, _, span) => {
            *span
        }
        Element::Loop { span, .. } => *span,
    }
}
