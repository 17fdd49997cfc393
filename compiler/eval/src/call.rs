//! Calls: which function a name means, and how arguments meet parameters.

use std::rc::Rc;
use std::sync::Arc;

use chiaro_solid::Scalar;
use chiaro_syntax::tree::{self, Expression, ExpressionKind, FunctionLiteral, Name, Parameter};
use chiaro_syntax::{Diagnostic, Span, Spanned};

use crate::evaluator::{Evaluator, Halt, Result, Unit};
use crate::functions::{self, BuiltIn, Invocation};
use crate::geometry::Argument;
use crate::live::Live;
use crate::scope::{Scope, Slot, Specials};
use crate::suggest;
use crate::value::{Value, text};

/// The most characters of an assertion's message that are shown.
const LONGEST_MESSAGE: usize = 1_000;

/// What is called.
pub(crate) enum Callee {
    User(UserFunction),
    BuiltIn(BuiltIn),
    /// A value that is no function, which has been reported. The call is undef.
    NoFunction,
}

/// A function of the scene's.
pub(crate) struct UserFunction {
    function: Arc<FunctionLiteral>,
    /// The scope it is defined in.
    scope: Rc<Scope>,
    /// What it is called by.
    name: Name,
    /// The file it comes from, if that is used.
    unit: Option<Unit>,
}

/// A call whose arguments are known.
pub(crate) struct Bound {
    pub(crate) function: Arc<FunctionLiteral>,
    /// The parameters' scope.
    pub(crate) scope: Rc<Scope>,
    pub(crate) name: Name,
    /// The call.
    pub(crate) site: Span,
}

impl<'t> Evaluator<'t> {
    /// The function that an expression in front of arguments means.
    pub(crate) fn callee(&mut self, callee: &Expression, scope: &Rc<Scope>) -> Result<Callee> {
        let value = if let ExpressionKind::Name(name) = &*callee.kind {
            if let Some(user) = self.user_function(name, scope)? {
                return Ok(Callee::User(user));
            }
            if let Some(built_in) = self.functions.get(name) {
                return Ok(Callee::BuiltIn(*built_in));
            }
            match self.known_variable(name, callee.span, scope)? {
                Some(value) => value,
                None => return Err(self.unknown_function(name, callee.span, scope)),
            }
        } else {
            self.expression(callee, scope)?
        };
        match value {
            Value::Function(closure) => Ok(Callee::User(UserFunction {
                function: closure.function.clone(),
                scope: closure.scope.clone(),
                name: "function".into(),
                unit: None,
            })),
            other => {
                let message = format!("this is {}, which can't be called", other.described());
                self.warn(Diagnostic::warning(callee.span, message).with_label("the call is undef"));
                Ok(Callee::NoFunction)
            }
        }
    }

    /// The function of that name: the nearest definition, or variable that holds a function.
    fn user_function(&mut self, name: &Name, scope: &Rc<Scope>) -> Result<Option<UserFunction>> {
        let found = |function: &Arc<FunctionLiteral>, scope: &Rc<Scope>, unit| {
            let (function, scope, name) = (function.clone(), scope.clone(), name.clone());
            Ok(Some(UserFunction { function, scope, name, unit }))
        };
        if Specials::is_special(name) {
            return match self.specials.get(name) {
                Some(Some(Value::Function(closure))) => found(&closure.function, &closure.scope, None),
                _ => Ok(None),
            };
        }
        let mut next = Some(scope);
        while let Some(scope) = next {
            if let Some(plan) = scope.plan.map(|id| self.plan(id)) {
                if let Some(function) = plan.functions.get(name) {
                    return found(function, scope, None);
                }
                for file in plan.uses.iter().rev() {
                    let used = self.used_plan(*file);
                    if let Some(function) = used.functions.get(name) {
                        let unit = self.unit(*file)?;
                        return found(function, &unit.scope.clone(), Some(unit));
                    }
                }
            }
            match scope.local(name) {
                Some(Some(Value::Function(closure))) => return found(&closure.function, &closure.scope, None),
                Some(None) => return Err(Halt::Reported),
                _ => {}
            }
            next = scope.parent.as_ref();
        }
        Ok(None)
    }

    fn unknown_function(&mut self, name: &Name, span: Span, scope: &Rc<Scope>) -> Halt {
        if functions::UNSUPPORTED.contains(&&**name) {
            return self.error(Diagnostic::error(span, format!("`{name}` is not supported yet")));
        }
        let mut known: Vec<Name> = scope.chain().flat_map(Scope::names).collect();
        known.extend(functions::names().map(Name::from));
        for id in scope.chain().filter_map(|scope| scope.plan) {
            let plan = self.plan(id);
            let used: Vec<_> = plan.uses.iter().map(|file| self.used_plan(*file)).collect();
            let functions = plan.functions.keys().chain(used.iter().flat_map(|plan| plan.functions.keys()));
            known.extend(functions.map(|name| (*name).clone()));
        }
        let error = Diagnostic::error(span, format!("there is no function `{name}`"));
        self.error(suggest::with_nearest(error, span, name, known.iter().map(|name| &**name)))
    }

    /// Evaluates arguments and binds them to a function's parameters.
    pub(crate) fn bind_call(
        &mut self,
        user: UserFunction,
        arguments: &[tree::Argument],
        site: Span,
        scope: &Rc<Scope>,
    ) -> Result<Bound> {
        let UserFunction { function, scope: defining, name, unit } = user;
        let arguments = self.arguments(arguments, scope)?;
        self.set_specials(unit);
        let scope = self.bind(&name, &function.parameters, arguments, &defining)?;
        Ok(Bound { function, scope: Rc::new(scope), name, site })
    }

    /// Calls a built-in function.
    pub(crate) fn built_in(
        &mut self,
        function: BuiltIn,
        arguments: &[tree::Argument],
        span: Span,
        scope: &Rc<Scope>,
    ) -> Result<Value> {
        let arguments = if function.takes_unknown_names {
            self.arguments_if_known(arguments, scope)?
        } else {
            self.arguments(arguments, scope)?
        };
        (function.call)(self, &Invocation { name: function.name, arguments, span })
    }

    /// The values of arguments.
    pub(crate) fn arguments(&mut self, arguments: &[tree::Argument], scope: &Rc<Scope>) -> Result<Vec<Argument>> {
        let mut values = Vec::with_capacity(arguments.len());
        for argument in arguments {
            let value = self.expression(&argument.value, scope)?;
            values.push(Argument { name: argument.name.clone(), value, span: argument.value.span });
        }
        Ok(values)
    }

    /// The values of arguments, where names of no variable are undef.
    fn arguments_if_known(&mut self, arguments: &[tree::Argument], scope: &Rc<Scope>) -> Result<Vec<Argument>> {
        let mut values = Vec::with_capacity(arguments.len());
        for argument in arguments {
            let span = argument.value.span;
            let value = match &*argument.value.kind {
                ExpressionKind::Name(name) => self.known_variable(name, span, scope)?.unwrap_or(Value::Undef),
                _ => self.expression(&argument.value, scope)?,
            };
            values.push(Argument { name: None, value, span });
        }
        Ok(values)
    }

    /// Sets the variables that follow the calls to what the top level of a used file says, where no caller has set
    /// them.
    pub(crate) fn set_specials(&mut self, unit: Option<Unit>) {
        for (name, slot) in unit.iter().flat_map(|unit| unit.specials.iter()) {
            self.specials.set_if_open(name, slot);
        }
    }

    /// A scope in which the parameters stand for the arguments. Those that follow the calls are set too; the caller
    /// takes them back.
    pub(crate) fn bind(
        &mut self,
        callee: &str,
        parameters: &[Parameter],
        arguments: Vec<Argument>,
        defining: &Rc<Scope>,
    ) -> Result<Scope> {
        let values = self.matched(callee, parameters, arguments);
        let mut missing = Vec::new();
        for parameter in parameters {
            if !values.iter().any(|(name, _)| *name == parameter.name.node) {
                let value = match &parameter.default {
                    Some(default) => self.expression(default, defining)?,
                    None => Value::Undef,
                };
                missing.push((parameter.name.node.clone(), Some(value)));
            }
        }
        let scope = Scope::within(defining);
        for (name, slot) in values.into_iter().chain(missing) {
            if Specials::is_special(&name) {
                self.specials.set(name, slot);
            } else {
                scope.set(name, slot);
            }
        }
        Ok(scope)
    }

    /// The arguments by their parameters' names.
    fn matched(&mut self, callee: &str, parameters: &[Parameter], arguments: Vec<Argument>) -> Vec<(Name, Slot)> {
        let mut values: Vec<(Name, Slot)> = Vec::with_capacity(parameters.len());
        let mut unnamed = parameters.iter().map(|parameter| &parameter.name.node);
        let mut is_full = false;
        for Argument { name, value, span } in arguments {
            if let Some(Spanned { node: name, span: place }) = name {
                if let Some(given) = values.iter_mut().find(|(given, _)| *given == name) {
                    self.warn(Diagnostic::warning(place, format!("`{name}` is given a value twice; this one counts")));
                    given.1 = Some(value);
                    continue;
                }
                let is_parameter = parameters.iter().any(|parameter| parameter.name.node == name);
                if !is_parameter && !Specials::is_special(&name) {
                    let known = parameters.iter().map(|parameter| &*parameter.name.node);
                    let warning = Diagnostic::warning(place, format!("`{callee}` has no parameter `{name}`"));
                    self.warn(suggest::with_nearest(warning, place, &name, known));
                }
                values.push((name, Some(value)));
            } else if let Some(name) = unnamed.find(|name| !values.iter().any(|(given, _)| given == *name)) {
                values.push((name.clone(), Some(value)));
            } else if !is_full {
                is_full = true;
                let message = format!("`{callee}` takes no more than {} unnamed arguments", parameters.len());
                self.warn(Diagnostic::warning(span, message));
            }
        }
        values
    }

    /// Checks an assertion.
    pub(crate) fn assert(&mut self, arguments: &[tree::Argument], span: Span, scope: &Rc<Scope>) -> Result<()> {
        let is =
            |argument: &&tree::Argument, wanted: &str| argument.name.as_ref().is_none_or(|name| &*name.node == wanted);
        let Some(condition) = arguments.iter().find(|argument| is(argument, "condition")) else {
            return Err(self.error(Diagnostic::error(span, "an assertion needs a condition")));
        };
        match self.expression(&condition.value, scope)?.truth() {
            Value::Bool(true) => return Ok(()),
            Value::Condition(live) => {
                return Err(Halt::Demote(Live::demotion(live, condition.value.span, "an assertion")));
            }
            _ => {}
        }
        let others = arguments.iter().filter(|argument| !std::ptr::eq(*argument, condition));
        let message = others.into_iter().find(|argument| is(argument, "message"));
        let message = match message {
            Some(message) => {
                let value = self.expression(&message.value, scope)?;
                let said = text::plain(&value, LONGEST_MESSAGE).unwrap_or_else(|_| "(a live number)".into());
                let shown: String = said.chars().take(LONGEST_MESSAGE).collect();
                if shown.len() < said.len() { format!(": {shown}…") } else { format!(": {shown}") }
            }
            None => String::new(),
        };
        let written = self.sources.text(condition.value.span).to_string();
        let error = Diagnostic::error(condition.value.span, format!("the assertion `{written}` fails{message}"));
        Err(self.error(error))
    }

    /// Writes the arguments of an `echo`.
    pub(crate) fn echo_arguments(&mut self, arguments: &[tree::Argument], span: Span, scope: &Rc<Scope>) -> Result<()> {
        if let Some((_, number)) = self.undecided.last() {
            return Err(Halt::Demote(Live::demotion(number.clone(), span, "whether something is echoed")));
        }
        let limit = self.options.limits.string_bytes;
        let mut line = String::new();
        for argument in self.arguments(arguments, scope)? {
            self.charge(argument.value.weight(), argument.span)?;
            if !line.is_empty() {
                line.push_str(", ");
            }
            if let Some(name) = &argument.name {
                line.push_str(&format!("{} = ", name.node));
            }
            match text::quoted(&argument.value, limit) {
                Ok(written) => line.push_str(&written),
                Err(trouble) => {
                    self.or_undef(Err(trouble), argument.span)?;
                }
            }
        }
        self.echo(span, line);
        Ok(())
    }

    /// The constant number that a value is; a live one is demoted for that reason.
    pub(crate) fn constant(&mut self, value: &Value, span: Span, reason: &'static str) -> Result<Option<f64>> {
        match value {
            Value::Number(Scalar::Constant(number)) => Ok(Some(*number)),
            Value::Number(live) => Err(Halt::Demote(Live::demotion(live.clone(), span, reason))),
            _ => Ok(None),
        }
    }
}
