//! Expressions: from syntax to values.

use std::rc::Rc;

use chiaro_solid::Scalar;
use chiaro_solid::scalar::Function;
use chiaro_syntax::tree::{Argument, BinaryOperator, Expression, ExpressionKind, Name};
use chiaro_syntax::{Diagnostic, Dialect, Span};

use crate::call::{Bound, Callee};
use crate::evaluator::{Call, Evaluator, Halt, Result};
use crate::live::Live;
use crate::scope::{Scope, Specials};
use crate::suggest;
use crate::value::operators::{self, condition};
use crate::value::{Closure, Elements, Range, Value};

/// So many scopes are looked through in the time of one step.
const SCOPES_PER_STEP: u64 = 8;

/// What the end of an expression is.
enum Tail {
    Value(Value),
    /// A call of a function, whose value is the expression's. It is not nested in the call it ends.
    Call(Bound),
}

impl<'t> Evaluator<'t> {
    /// The value of an expression.
    pub(crate) fn expression(&mut self, e: &Expression, scope: &Rc<Scope>) -> Result<Value> {
        // Literals are most of a dump, and need neither stack nor steps.
        match &*e.kind {
            ExpressionKind::Number(number) => return Ok(Value::Number(self.live.literal(*number, e.span))),
            ExpressionKind::String(text) => return Ok(Value::String(text.clone())),
            ExpressionKind::Bool(value) => return Ok(Value::Bool(*value)),
            ExpressionKind::Undef => return Ok(Value::Undef),
            ExpressionKind::Error => return Err(Halt::Reported),
            _ => {}
        }
        self.enter(e.span)?;
        let value = self.compound(e, scope);
        self.leave();
        value
    }

    fn compound(&mut self, e: &Expression, scope: &Rc<Scope>) -> Result<Value> {
        match &*e.kind {
            ExpressionKind::Name(name) => self.variable(name, e.span, scope),
            ExpressionKind::Range { start, step, end } => self.range(start, step.as_ref(), end, e.span, scope),
            ExpressionKind::List(elements) => {
                let mut values = Elements::with_capacity(elements.len());
                self.elements(elements, scope, &mut values)?;
                self.limited(Value::List(values.into()), e.span)
            }
            ExpressionKind::Unary(operator, operand) => {
                let operand = self.expression(operand, scope)?;
                self.charge(operand.weight(), e.span)?;
                self.or_undef(operators::unary(*operator, &operand), e.span)
            }
            ExpressionKind::Binary(operator, a, b) => self.binary(*operator, a, b, e.span, scope),
            ExpressionKind::Index(list, index) => self.index(list, index, scope),
            ExpressionKind::Member(value, name) => {
                let value = self.expression(value, scope)?;
                let member = member(&value, &name.node);
                if let (None, Value::List(_)) = (&member, &value) {
                    self.warn(no_component(&name.node, name.span));
                }
                Ok(member.unwrap_or(Value::Undef))
            }
            ExpressionKind::Function(function) => {
                self.capture(scope, e.span)?;
                Ok(Value::Function(Rc::new(Closure { function: function.clone(), scope: scope.clone() })))
            }
            _ => self.reduced(e, scope),
        }
    }

    /// The value of an expression that can end in a call.
    fn reduced(&mut self, e: &Expression, scope: &Rc<Scope>) -> Result<Value> {
        let (mark, calls) = (self.specials.mark(), self.calls.len());
        let value = match self.tail(e, scope.clone()) {
            Ok(Tail::Value(value)) => Ok(value),
            Ok(Tail::Call(bound)) => self.run(bound),
            Err(halt) => Err(halt),
        };
        self.calls.truncate(calls);
        self.specials.restore(mark);
        value
    }

    /// Calls a function, and the functions in whose calls that ends, one after the other.
    fn run(&mut self, mut bound: Bound) -> Result<Value> {
        let depth = self.calls.len();
        for _ in 0..=self.options.limits.rounds {
            self.calls.truncate(depth);
            self.begin_call(&bound)?;
            match self.tail(&bound.function.body, bound.scope)? {
                Tail::Value(value) => return Ok(value),
                Tail::Call(next) => bound = next,
            }
        }
        let message = format!("`{}` calls itself more than {} times", bound.name, self.options.limits.rounds);
        Err(self.abort(Diagnostic::error(bound.site, message)))
    }

    fn begin_call(&mut self, bound: &Bound) -> Result<()> {
        let definition = std::sync::Arc::as_ptr(&bound.function).cast();
        // Where a live number decides whether a function calls itself, both ways would be gone forever.
        if let Some((height, number)) = self.undecided.last()
            && self.calls[..*height].iter().any(|call| call.definition == definition)
        {
            return Err(Halt::Demote(Live::demotion(number.clone(), bound.site, "the depth of a recursion")));
        }
        self.calls.push(Call { name: bound.name.clone(), site: bound.site, definition });
        Ok(())
    }

    /// Evaluates an expression up to the call that it ends in, if it does.
    fn tail(&mut self, mut e: &Expression, mut scope: Rc<Scope>) -> Result<Tail> {
        loop {
            self.charge(1, e.span)?;
            match &*e.kind {
                ExpressionKind::Conditional { condition, yes, no } => {
                    match self.expression(condition, &scope)?.truth() {
                        Value::Condition(number) => {
                            return self.selected(number, yes, no, e.span, &scope).map(Tail::Value);
                        }
                        truth => e = if truth.is_true() { yes } else { no },
                    }
                }
                ExpressionKind::Let(bindings, body) => {
                    scope = self.bound_in_turn(bindings, &scope)?;
                    e = body;
                }
                ExpressionKind::Assert(arguments, body) => {
                    self.assert(arguments, e.span, &scope)?;
                    let Some(body) = body else { return Ok(Tail::Value(Value::Undef)) };
                    e = body;
                }
                ExpressionKind::Echo(arguments, body) => {
                    self.echo_arguments(arguments, e.span, &scope)?;
                    let Some(body) = body else { return Ok(Tail::Value(Value::Undef)) };
                    e = body;
                }
                ExpressionKind::Call(callee, arguments) => match self.callee(callee, &scope)? {
                    Callee::User(user) => {
                        return self.bind_call(user, arguments, e.span, &scope).map(Tail::Call);
                    }
                    Callee::BuiltIn(function) => {
                        return self.built_in(function, arguments, e.span, &scope).map(Tail::Value);
                    }
                    Callee::NoFunction => return Ok(Tail::Value(Value::Undef)),
                },
                _ => return self.expression(e, &scope).map(Tail::Value),
            }
        }
    }

    /// Both branches, of which a live number chooses.
    fn selected(
        &mut self,
        number: Scalar,
        yes: &Expression,
        no: &Expression,
        span: Span,
        scope: &Rc<Scope>,
    ) -> Result<Value> {
        self.undecided.push((self.calls.len(), number.clone()));
        let yes = self.expression(yes, scope);
        let no = if yes.is_ok() { self.expression(no, scope) } else { Err(Halt::Reported) };
        self.undecided.pop();
        let demotion = || Halt::Demote(Live::demotion(number.clone(), span, "which of two values is taken"));
        match (yes, no) {
            (Ok(yes), Ok(no)) => select(&number, &yes, &no).ok_or_else(demotion),
            (Err(Halt::Demote(other)), _) | (_, Err(Halt::Demote(other))) => Err(Halt::Demote(other)),
            // What is wrong in one branch is of no matter if the other is taken.
            _ => Err(demotion()),
        }
    }

    /// The value of a variable.
    pub(crate) fn variable(&mut self, name: &Name, span: Span, scope: &Rc<Scope>) -> Result<Value> {
        match self.known_variable(name, span, scope)? {
            Some(value) => Ok(value),
            None if name.starts_with('$') => {
                let warning = Diagnostic::warning(span, format!("nothing sets `{name}`, so this is undef"));
                let known = self.specials.names().map(|name| &**name);
                let warning = suggest::with_nearest(warning, span, name, known);
                self.warn(warning);
                Ok(Value::Undef)
            }
            None => Err(self.unknown_variable(name, span, scope)),
        }
    }

    /// The value of a variable, if there is one of that name.
    pub(crate) fn known_variable(&mut self, name: &Name, span: Span, scope: &Rc<Scope>) -> Result<Option<Value>> {
        let slot = if Specials::is_special(name) {
            self.specials.get(name).cloned()
        } else {
            let (slot, scopes) = scope.lookup(name);
            self.charge(u64::from(scopes) / SCOPES_PER_STEP, span)?;
            slot
        };
        match slot {
            Some(Some(value)) => return Ok(Some(value)),
            Some(None) => return Err(Halt::Reported),
            None => {}
        }
        let is_dump = || Dialect::of_file(&self.sources.get(span.file).name) == Dialect::Dump;
        Ok(match &**name {
            "$t" => Some(Value::Number(self.live.time())),
            "PI" => Some(Value::number(std::f64::consts::PI)),
            "inf" if is_dump() => Some(Value::number(f64::INFINITY)),
            "nan" if is_dump() => Some(Value::number(f64::NAN)),
            _ => None,
        })
    }

    fn unknown_variable(&mut self, name: &str, span: Span, scope: &Rc<Scope>) -> Halt {
        let mut error = Diagnostic::error(span, format!("there is no variable `{name}`"));
        let plans = scope.chain().filter_map(|scope| scope.plan).map(|id| self.plan(id));
        let later = plans.flat_map(|plan| {
            plan.assignments.iter().map(|a| (a.first.name.node.clone(), a.first.span)).collect::<Vec<_>>()
        });
        if let Some((_, place)) = later.into_iter().find(|(later, _)| **later == *name) {
            let refers_to_itself = place.file == span.file && place.start <= span.start && span.end <= place.end;
            error = if refers_to_itself {
                error.with_hint("a variable has one value, which cannot come from itself")
            } else {
                error
                    .with_related(place, "it is assigned only here")
                    .with_hint("assignments run in the order of the text: move this one up")
            };
        } else {
            let known: Vec<Name> = scope.chain().flat_map(Scope::names).collect();
            error = suggest::with_nearest(error, span, name, known.iter().map(|name| &**name).chain(["PI"]));
        }
        self.error(error)
    }

    fn binary(
        &mut self,
        operator: BinaryOperator,
        a: &Expression,
        b: &Expression,
        span: Span,
        scope: &Rc<Scope>,
    ) -> Result<Value> {
        if matches!(operator, BinaryOperator::And | BinaryOperator::Or) {
            return self.logical(operator == BinaryOperator::And, a, b, span, scope);
        }
        let a = self.expression(a, scope)?;
        let b = self.expression(b, scope)?;
        self.charge(work(operator, &a, &b), span)?;
        let value = operators::binary(operator, &a, &b);
        let value = self.or_undef(value, span)?;
        self.limited(value, span)
    }

    /// `a && b` or `a || b`. The second operand is only looked at if the first does not decide.
    fn logical(
        &mut self,
        is_and: bool,
        a: &Expression,
        b: &Expression,
        span: Span,
        scope: &Rc<Scope>,
    ) -> Result<Value> {
        let number = match self.expression(a, scope)?.truth() {
            Value::Condition(number) => number,
            truth if truth.is_true() != is_and => return Ok(truth),
            _ => return Ok(self.expression(b, scope)?.truth()),
        };
        self.undecided.push((self.calls.len(), number.clone()));
        let b = self.expression(b, scope);
        self.undecided.pop();
        let (yes, no) = match b {
            Ok(b) if is_and => (b.truth(), Value::Bool(false)),
            Ok(b) => (Value::Bool(true), b.truth()),
            Err(Halt::Demote(other)) => return Err(Halt::Demote(other)),
            Err(_) => return Err(Halt::Demote(Live::demotion(number, span, "whether the other operand counts"))),
        };
        let demotion = || Halt::Demote(Live::demotion(number.clone(), span, "whether the other operand counts"));
        select(&number, &yes, &no).ok_or_else(demotion)
    }

    fn range(
        &mut self,
        start: &Expression,
        step: Option<&Expression>,
        end: &Expression,
        span: Span,
        scope: &Rc<Scope>,
    ) -> Result<Value> {
        let mut numbers = [0.0, 1.0, 0.0];
        for (number, part) in numbers.iter_mut().zip([Some(start), step, Some(end)]) {
            let Some(part) = part else { continue };
            match self.expression(part, scope)? {
                Value::Number(Scalar::Constant(value)) => *number = value,
                Value::Number(live) => return Err(Halt::Demote(Live::demotion(live, part.span, "a range's bound"))),
                other => {
                    let message = format!("a range needs numbers, but this is {}", other.described());
                    self.warn(Diagnostic::warning(part.span, message).with_related(span, "the range is undef"));
                    return Ok(Value::Undef);
                }
            }
        }
        let [start, step, end] = numbers;
        Ok(Value::Range(Range { start, step, end }))
    }

    fn index(&mut self, list: &Expression, index: &Expression, scope: &Rc<Scope>) -> Result<Value> {
        let list = self.expression(list, scope)?;
        let at = match self.expression(index, scope)? {
            Value::Number(Scalar::Constant(at)) => at,
            Value::Number(live) => return Err(Halt::Demote(Live::demotion(live, index.span, "a list's index"))),
            _ => return Ok(Value::Undef),
        };
        if !at.is_finite() || at <= -1.0 {
            return Ok(Value::Undef);
        }
        let at = at as usize;
        Ok(match &list {
            Value::List(values) => values.get(at).cloned().unwrap_or(Value::Undef),
            Value::Range(range) => {
                [range.start, range.step, range.end].get(at).map_or(Value::Undef, |number| Value::number(*number))
            }
            Value::String(text) => {
                self.charge(text.len() as u64 / 64, index.span)?;
                let ascii = || text.as_bytes().get(at).map(|byte| char::from(*byte));
                let character = if text.is_ascii() { ascii() } else { text.chars().nth(at) };
                character.map_or(Value::Undef, |character| Value::string(character.to_string()))
            }
            _ => Value::Undef,
        })
    }

    /// A scope with these variables, each of which sees those before it.
    pub(crate) fn bound_in_turn(&mut self, bindings: &[Argument], scope: &Rc<Scope>) -> Result<Rc<Scope>> {
        let inner = Rc::new(Scope::within(scope));
        for binding in bindings {
            let value = self.expression(&binding.value, &inner)?;
            let Some(name) = &binding.name else {
                self.warn(Diagnostic::warning(binding.value.span, "this value gets no name"));
                continue;
            };
            let mut earlier = bindings.iter().map_while(|b| (!std::ptr::eq(b, binding)).then_some(b));
            if earlier.any(|other| other.name.as_ref().is_some_and(|other| other.node == name.node)) {
                let message = format!("`{}` has a value here already, which stays", name.node);
                self.warn(Diagnostic::warning(name.span, message));
            } else if Specials::is_special(&name.node) {
                self.specials.set(name.node.clone(), Some(value));
            } else {
                inner.set(name.node.clone(), Some(value));
            }
        }
        Ok(inner)
    }
}

/// How many steps an operator takes.
fn work(operator: BinaryOperator, a: &Value, b: &Value) -> u64 {
    match (a, b) {
        (Value::List(x), Value::List(y)) if operator == BinaryOperator::Multiply => {
            let columns = match y.first() {
                Some(Value::List(row)) => row.len() as u64,
                _ => 1,
            };
            x.weight().saturating_mul(columns).saturating_add(y.weight())
        }
        (Value::List(_), Value::List(_)) => a.weight().min(b.weight()),
        (Value::List(list), _) | (_, Value::List(list)) => list.weight(),
        _ => 1,
    }
}

/// `value.name`, if a value of that kind has such a member.
fn member(value: &Value, name: &str) -> Option<Value> {
    match value {
        Value::List(values) => {
            let places = components(name)?;
            let component = |at: &usize| values.get(*at).cloned().unwrap_or(Value::Undef);
            Some(match places.as_slice() {
                [only] => component(only),
                several => Value::list(several.iter().map(component).collect()),
            })
        }
        Value::Range(range) => match name {
            "begin" => Some(Value::number(range.start)),
            "step" => Some(Value::number(range.step)),
            "end" => Some(Value::number(range.end)),
            _ => None,
        },
        _ => None,
    }
}

/// The places in a list that a swizzle names: one to four letters, all of places or all of colours.
fn components(name: &str) -> Option<Vec<usize>> {
    const MOST_LETTERS: usize = 4;
    let named = |letters: &str| name.chars().map(|letter| letters.find(letter)).collect::<Option<Vec<_>>>();
    let places = named("xyzw").or_else(|| named("rgba"))?;
    (1..=MOST_LETTERS).contains(&places.len()).then_some(places)
}

fn no_component(name: &str, span: Span) -> Diagnostic {
    Diagnostic::warning(span, format!("a list has no `{name}`, so that this is undef"))
        .with_hint("components are `x`, `y`, `z`, `w` or `r`, `g`, `b`, `a`; several at once make a list, as in `v.xy`")
}

/// The value that a live number chooses, if that can be left open: numbers, truth values, and lists of them.
fn select(number: &Scalar, yes: &Value, no: &Value) -> Option<Value> {
    let choose = |yes: &Scalar, no: &Scalar| {
        if yes == no {
            return yes.clone();
        }
        Scalar::apply(Function::Select, vec![number.clone(), yes.clone(), no.clone()])
    };
    let as_number = |value: &Value| match value {
        Value::Bool(value) => Some(Scalar::from(f64::from(u8::from(*value)))),
        Value::Condition(number) => Some(number.clone()),
        _ => None,
    };
    match (yes, no) {
        (Value::Number(yes), Value::Number(no)) => Some(Value::Number(choose(yes, no))),
        (Value::List(yes), Value::List(no)) if yes.len() == no.len() => {
            let values = yes.iter().zip(no.iter()).map(|(yes, no)| select(number, yes, no));
            values.collect::<Option<Vec<_>>>().map(Value::list)
        }
        (Value::String(yes), Value::String(no)) if yes == no => Some(Value::String(yes.clone())),
        (Value::Undef, Value::Undef) => Some(Value::Undef),
        _ => Some(condition(choose(&as_number(yes)?, &as_number(no)?))),
    }
}
