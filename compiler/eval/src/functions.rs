//! The built-in functions.

mod lists;
mod math;
mod random;
mod search;
mod strings;
mod types;

pub(crate) use random::Random;

use chiaro_solid::Scalar;
use chiaro_syntax::tree::Name;
use chiaro_syntax::{Diagnostic, Span};
use rustc_hash::FxHashMap;

use crate::evaluator::{Evaluator, Halt, Result};
use crate::geometry::Argument;
use crate::live::Live;
use crate::value::{List, Value};

/// A built-in function.
#[derive(Clone, Copy)]
pub(crate) struct BuiltIn {
    /// Its name.
    pub(crate) name: &'static str,
    /// Whether an argument may be a name that stands for nothing, which is undef then.
    pub(crate) takes_unknown_names: bool,
    /// What it does.
    pub(crate) call: fn(&mut Evaluator, &Invocation) -> Result<Value>,
}

/// A call of a built-in function. Arguments count by their order, even if they are named.
pub(crate) struct Invocation {
    pub(crate) name: &'static str,
    pub(crate) arguments: Vec<Argument>,
    /// The whole call.
    pub(crate) span: Span,
}

/// All built-in functions, in the order of their names.
fn table() -> impl Iterator<Item = &'static BuiltIn> {
    [math::TABLE, lists::TABLE, search::TABLE, strings::TABLE, random::TABLE, types::TABLE].into_iter().flatten()
}

/// The functions of OpenSCAD's that there are not, or not yet.
pub(crate) const UNSUPPORTED: [&str; 7] =
    ["dxf_cross", "dxf_dim", "fontmetrics", "has_key", "import", "object", "textmetrics"];

/// All built-in functions by name.
pub(crate) fn by_name() -> FxHashMap<Name, BuiltIn> {
    table().map(|function| (function.name.into(), *function)).collect()
}

/// The names of all built-in functions.
pub(crate) fn names() -> impl Iterator<Item = &'static str> {
    table().map(|function| function.name)
}

/// A row of a table.
const fn row(name: &'static str, call: fn(&mut Evaluator, &Invocation) -> Result<Value>) -> BuiltIn {
    BuiltIn { name, takes_unknown_names: false, call }
}

impl Invocation {
    /// The argument of that number.
    fn value(&self, at: usize) -> Option<&Value> {
        self.arguments.get(at).map(|argument| &argument.value)
    }

    /// The place of that argument.
    fn span(&self, at: usize) -> Span {
        self.arguments.get(at).map_or(self.span, |argument| argument.span)
    }

    /// Makes sure that there are as many arguments; else warns, and the value is undef.
    fn counts(&self, evaluator: &mut Evaluator, least: usize, most: usize) -> bool {
        let given = self.arguments.len();
        if (least..=most).contains(&given) {
            return true;
        }
        let wanted = if least == most { format!("{least}") } else { format!("{least} to {most}") };
        let message = format!("`{}` takes {wanted} arguments, not {given}", self.name);
        evaluator.warn(Diagnostic::warning(self.span, message).with_label("this is undef"));
        false
    }

    /// Says that an argument is not what the function takes.
    fn refuse(&self, evaluator: &mut Evaluator, at: usize, wanted: &str) {
        let found = match self.value(at) {
            Some(Value::List(_)) => "this list",
            Some(value) => value.described(),
            None => "nothing",
        };
        let message = format!("`{}` takes {wanted} here, not {found}", self.name);
        evaluator.warn(Diagnostic::warning(self.span(at), message).with_related(self.span, "the call is undef"));
    }

    /// The number at that place; else a warning.
    fn number(&self, evaluator: &mut Evaluator, at: usize) -> Option<Scalar> {
        match self.value(at) {
            Some(Value::Number(number)) => Some(number.clone()),
            _ => {
                self.refuse(evaluator, at, "a number");
                None
            }
        }
    }

    /// The list at that place; else a warning.
    fn list(&self, evaluator: &mut Evaluator, at: usize) -> Option<List> {
        match self.value(at) {
            Some(Value::List(list)) => Some(list.clone()),
            _ => {
                self.refuse(evaluator, at, "a list");
                None
            }
        }
    }

    /// The constant number at that place; a live one is demoted for that reason.
    fn constant(&self, evaluator: &mut Evaluator, at: usize, reason: &'static str) -> Result<Option<f64>> {
        match self.number(evaluator, at) {
            Some(Scalar::Constant(number)) => Ok(Some(number)),
            Some(live) => Err(self.demotion(live, at, reason)),
            None => Ok(None),
        }
    }

    fn demotion(&self, number: Scalar, at: usize, reason: &'static str) -> Halt {
        Halt::Demote(Live::demotion(number, self.span(at), reason))
    }
}
