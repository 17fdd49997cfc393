//! The state of an evaluation: budgets, the calls under way, and what there is to tell.

use std::collections::hash_map::Entry;
use std::hash::BuildHasher;
use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::Ordering;

use chiaro_solid::{PlacedLight, Scalar, Solid};
use chiaro_syntax::tree::{Name, Statement};
use chiaro_syntax::{Diagnostic, Severity, Sources, Span};
use rustc_hash::{FxBuildHasher, FxHashMap, FxHashSet};

use crate::functions::{self, BuiltIn, Random};
use crate::geometry::{Aside, Demotion, Stop};
use crate::live::Live;
use crate::load::{FileIndex, Library};
use crate::options::{Limits, Options};
use crate::plan::{Plan, plan};
use crate::scope::{Mark, PlanId, Scope, Slot, Specials, WellKnown};
use crate::settings::Settings;
use crate::value::{Trouble, Value, held};

/// More captured scopes than this are looked through for garbage.
const FIRST_SWEEP: usize = 10_000;
/// More scopes than this can't be in use by function literals at one time.
const MOST_CAPTURED: usize = 1_000_000;
/// How many places one message is shown for.
const MOST_REPEATED: usize = 100;
/// For how many different things one place is shown.
const MOST_AT_ONE_PLACE: usize = 100;
/// So many bytes of text are written in the time of one step.
const BYTES_PER_STEP: u64 = 64;
/// How many of the calls under way an error shows.
const SHOWN_CALLS: usize = 6;

/// Why an expression has no value, or an instance no solid.
#[derive(Debug)]
pub(crate) enum Halt {
    /// There is an error, which has been reported. What does not depend on this is evaluated nevertheless.
    Reported,
    /// A live number has to be known; the evaluation starts again.
    Demote(Box<Demotion>),
    /// A limit is exceeded, which has been reported; the evaluation ends.
    Abort,
}

/// What most steps of the evaluation answer.
pub(crate) type Result<T> = std::result::Result<T, Halt>;

/// An evaluation under way.
pub(crate) struct Evaluator<'t> {
    pub(crate) library: &'t Library,
    pub(crate) sources: &'t Sources,
    pub(crate) options: &'t Options,
    pub(crate) settings: Settings,
    pub(crate) specials: Specials,
    pub(crate) names: WellKnown,
    pub(crate) live: Live<'t>,
    pub(crate) random: Random,
    pub(crate) functions: FxHashMap<Name, BuiltIn>,
    /// The children that instances of user modules were given.
    pub(crate) children: Vec<Children<'t>>,
    /// Whether all that counts of the solids being built is their convex hull.
    pub(crate) only_hull: bool,
    /// Whether what groups make below the instance under way is to stay apart, as operands of that one.
    pub(crate) every: bool,
    /// The calls of functions and instances of modules under way, the innermost last.
    pub(crate) calls: Vec<Call>,
    /// The names of the user modules whose instances are under way.
    pub(crate) modules: Vec<Name>,
    /// How many calls there were when evaluating each of the branches under way began that a live number chooses.
    pub(crate) undecided: Vec<(usize, Scalar)>,
    /// The first instance marked by `!`.
    pub(crate) root: Option<Root>,
    /// What the instance under way has put aside so far; in the end, what the scene has beside its solids.
    pub(crate) aside: Aside,
    pub(crate) instances: u64,
    /// Where live numbers would have to be known.
    pub(crate) demotions: Vec<Demotion>,
    pub(crate) diagnostics: Vec<Diagnostic>,
    pub(crate) echoes: Vec<Diagnostic>,
    pub(crate) units: FxHashMap<FileIndex, Unit>,
    plans: Vec<Rc<Plan<'t>>>,
    plan_ids: FxHashMap<*const Statement, PlanId>,
    said: FxHashSet<(Option<Span>, u64)>,
    /// How often each message was said, wherever.
    repeated: FxHashMap<u64, usize>,
    /// How much was said of each place.
    crowded: FxHashMap<Option<Span>, usize>,
    captured: Vec<Rc<Scope>>,
    sweep_at: usize,
    steps: u64,
    /// How many bytes of text may still be made.
    text_bytes: u64,
    nesting: u32,
    solids: u64,
    /// How many bytes may still be echoed.
    echo_bytes: usize,
}

/// A file whose functions and modules are used: its top-level scope, and its top-level variables that follow the
/// calls.
#[derive(Clone)]
pub(crate) struct Unit {
    pub(crate) scope: Rc<Scope>,
    pub(crate) specials: Rc<Vec<(Name, Slot)>>,
}

/// What stands in the braces behind an instance of a user module.
#[derive(Clone)]
pub(crate) struct Children<'t> {
    pub(crate) statements: &'t [Statement],
    /// The scope around them.
    pub(crate) scope: Rc<Scope>,
    /// The variables that follow the calls, where they stand.
    pub(crate) specials: Mark,
}

/// What an instance marked by `!` comes to: all that the scene shows.
pub(crate) struct Root {
    /// Its place in the order of instances.
    pub(crate) order: u64,
    pub(crate) solid: Arc<Solid>,
    pub(crate) lights: Vec<PlacedLight>,
}

/// A call under way.
pub(crate) struct Call {
    /// The function's or module's name.
    pub(crate) name: Name,
    /// Where it is called.
    pub(crate) site: Span,
    /// The address of its definition, which tells whether it calls itself.
    pub(crate) definition: *const (),
}

impl<'t> Evaluator<'t> {
    /// An evaluation about to begin.
    pub(crate) fn new(library: &'t Library, sources: &'t Sources, options: &'t Options, live: Live<'t>) -> Self {
        Self {
            library,
            sources,
            options,
            settings: Settings { facets: options.facets },
            specials: Specials::default(),
            names: WellKnown::default(),
            live,
            random: Random::default(),
            functions: functions::by_name(),
            children: Vec::new(),
            only_hull: false,
            every: false,
            calls: Vec::new(),
            modules: Vec::new(),
            undecided: Vec::new(),
            root: None,
            aside: Aside::default(),
            instances: 0,
            demotions: Vec::new(),
            diagnostics: Vec::new(),
            echoes: Vec::new(),
            units: FxHashMap::default(),
            plans: vec![Rc::new(Plan::default())],
            plan_ids: FxHashMap::default(),
            said: FxHashSet::default(),
            repeated: FxHashMap::default(),
            crowded: FxHashMap::default(),
            captured: Vec::new(),
            sweep_at: FIRST_SWEEP,
            steps: options.limits.steps,
            text_bytes: options.limits.text_bytes,
            nesting: 0,
            solids: options.limits.solids,
            echo_bytes: options.limits.echo_bytes,
        }
    }

    /// The plan of a block, made when it is first asked for.
    pub(crate) fn plan_id(&mut self, statements: &'t [Statement]) -> PlanId {
        if statements.is_empty() {
            return 0;
        }
        match self.plan_ids.entry(statements.as_ptr()) {
            Entry::Occupied(entry) => *entry.get(),
            Entry::Vacant(entry) => {
                let limit = self.options.limits.statements;
                let plan = plan(self.library, self.sources, statements, limit, &mut self.diagnostics);
                self.plans.push(Rc::new(plan));
                *entry.insert(self.plans.len() - 1)
            }
        }
    }

    /// The plan of that number.
    pub(crate) fn plan(&self, id: PlanId) -> Rc<Plan<'t>> {
        self.plans[id].clone()
    }

    /// Counts some steps of work.
    pub(crate) fn charge(&mut self, steps: u64, span: Span) -> Result<()> {
        if self.options.cancelled.as_ref().is_some_and(|cancelled| cancelled.load(Ordering::Relaxed)) {
            return Err(self.abort(Diagnostic::error(span, "evaluating the scene was stopped")));
        }
        match self.steps.checked_sub(steps) {
            Some(left) => {
                self.steps = left;
                Ok(())
            }
            None => {
                let message = "evaluating the scene takes too long";
                let label = format!("{} million steps were done here", self.options.limits.steps / 1_000_000);
                Err(self.abort(Diagnostic::error(span, message).with_label(label)))
            }
        }
    }

    /// Counts one more level of nesting, which [`leave`](Self::leave) takes back.
    pub(crate) fn enter(&mut self, span: Span) -> Result<()> {
        self.charge(1, span)?;
        if self.nesting >= self.options.limits.nesting {
            return Err(self.endless_recursion(span));
        }
        self.nesting += 1;
        Ok(())
    }

    /// Leaves a level of nesting.
    pub(crate) fn leave(&mut self) {
        self.nesting -= 1;
    }

    fn endless_recursion(&mut self, span: Span) -> Halt {
        let Some(call) = self.calls.last() else {
            return self.abort(Diagnostic::error(span, "the scene is nested too deeply"));
        };
        let (name, site) = (call.name.clone(), call.site);
        let calls = self.calls.iter().filter(|call| call.name == name).count();
        let message = format!("the recursion of `{name}` goes too deep");
        let error = Diagnostic::error(site, message)
            .with_label(format!("{calls} calls of `{name}` are under way here"))
            .with_hint("a recursive definition needs a condition under which it does not call itself");
        self.abort(error)
    }

    /// Counts one more solid.
    pub(crate) fn count_solid(&mut self, span: Span) -> Result<()> {
        match self.solids.checked_sub(1) {
            Some(left) => {
                self.solids = left;
                Ok(())
            }
            None => {
                let message = format!("the scene has more than {} solids", self.options.limits.solids);
                Err(self.abort(Diagnostic::error(span, message)))
            }
        }
    }

    /// A new list, if it is within the limits.
    pub(crate) fn list(&mut self, values: Vec<Value>, span: Span) -> Result<Value> {
        self.charge(values.len() as u64, span)?;
        self.limited(Value::list(values), span)
    }

    /// The value, unless it is too large.
    pub(crate) fn limited(&mut self, value: Value, span: Span) -> Result<Value> {
        if let Value::List(list) = &value {
            self.check_lists(list.len(), list.weight(), span)?;
            let most = self.options.limits.list_depth;
            if list.depth() > most {
                let message = format!("this list has more than {most} levels of lists in it");
                return Err(self.abort(Diagnostic::error(span, message)));
            }
        }
        Ok(value)
    }

    /// Makes sure that a list with so many elements, which hold so many values, and all lists together are within the
    /// limits.
    pub(crate) fn check_lists(&mut self, length: usize, values: u64, span: Span) -> Result<()> {
        let Limits { list_length, list_values, held_values, .. } = self.options.limits;
        let message = if length > list_length {
            format!("this list has more than {list_length} elements")
        } else if values > list_values {
            format!("this list has more than {list_values} values")
        } else if held() > held_values {
            format!("the lists of the scene hold more than {} million values", held_values / 1_000_000)
        } else {
            return Ok(());
        };
        Err(self.abort(Diagnostic::error(span, message)))
    }

    /// A new text, if it and all texts together are within the limits. Those made before count, even if they are gone.
    pub(crate) fn text(&mut self, text: String, span: Span) -> Result<Value> {
        self.check_text(text.len(), span)?;
        self.charge(text.len() as u64 / BYTES_PER_STEP, span)?;
        match self.text_bytes.checked_sub(text.len() as u64) {
            Some(left) => self.text_bytes = left,
            None => {
                let most = self.options.limits.text_bytes / 1_000_000;
                let message = format!("the scene makes more than {most} million bytes of text");
                return Err(self.abort(Diagnostic::error(span, message)));
            }
        }
        Ok(Value::string(text))
    }

    /// Makes sure that one text of so many bytes is within the limits.
    pub(crate) fn check_text(&mut self, bytes: usize, span: Span) -> Result<()> {
        let most = self.options.limits.string_bytes;
        if bytes <= most {
            return Ok(());
        }
        Err(self.abort(Diagnostic::error(span, format!("this text is longer than {most} bytes"))))
    }

    /// Keeps a scope that a function literal refers to, so that it is dropped from here and never by way of a long
    /// chain of function literals, and so that cycles of them are broken at the end.
    pub(crate) fn capture(&mut self, scope: &Rc<Scope>, span: Span) -> Result<()> {
        if !scope.capture() {
            return Ok(());
        }
        self.captured.push(scope.clone());
        if self.captured.len() >= self.sweep_at {
            self.captured.retain(|scope| Rc::strong_count(scope) > 1);
            self.sweep_at = FIRST_SWEEP.max(2 * self.captured.len());
        }
        if self.captured.len() > MOST_CAPTURED {
            return Err(self.abort(Diagnostic::error(span, "the scene has too many function literals")));
        }
        Ok(())
    }

    /// Says a value can't be computed: a warning and `undef`, or a demotion.
    pub(crate) fn or_undef(&mut self, result: std::result::Result<Value, Trouble>, span: Span) -> Result<Value> {
        match result {
            Ok(value) => Ok(value),
            Err(Trouble::Undefined(message)) => {
                self.warn(Diagnostic::warning(span, message).with_label("this is undef"));
                Ok(Value::Undef)
            }
            Err(Trouble::Demote(number, reason)) => Err(Halt::Demote(Live::demotion(number, span, reason))),
        }
    }

    /// Reports an error, with the calls that led there.
    pub(crate) fn error(&mut self, error: Diagnostic) -> Halt {
        let error = self.with_calls(error);
        self.say(error);
        Halt::Reported
    }

    /// Reports that a limit is exceeded.
    pub(crate) fn abort(&mut self, error: Diagnostic) -> Halt {
        self.error(error);
        Halt::Abort
    }

    /// Reports a warning.
    pub(crate) fn warn(&mut self, warning: Diagnostic) {
        let warning = self.with_calls(warning);
        self.say(warning);
    }

    /// Goes on behind a statement that came to nothing. After a demotion that serves to find more of them: the whole
    /// evaluation starts again after it.
    pub(crate) fn set_aside(&mut self, halt: Halt) -> Result<()> {
        match halt {
            Halt::Reported => Ok(()),
            Halt::Demote(demotion) => {
                self.demotions.push(*demotion);
                Ok(())
            }
            Halt::Abort => Err(Halt::Abort),
        }
    }

    /// Takes in why a built-in module made no solid.
    pub(crate) fn stopped(&mut self, stop: Stop) -> Halt {
        match stop {
            Stop::Error(error) => self.error(*error),
            Stop::Demote(demotion) => Halt::Demote(demotion),
        }
    }

    /// Adds a diagnostic, unless it was said of this place before, or of very many places.
    pub(crate) fn say(&mut self, diagnostic: Diagnostic) {
        let message = FxBuildHasher.hash_one(&diagnostic.message);
        if !self.said.insert((diagnostic.span, message)) {
            return;
        }
        let repeated = self.repeated.entry(message).or_default();
        *repeated += 1;
        let crowded = self.crowded.entry(diagnostic.span).or_default();
        *crowded += 1;
        if *crowded > MOST_AT_ONE_PLACE && diagnostic.severity != Severity::Error {
            if *crowded == MOST_AT_ONE_PLACE + 1 {
                let message = "there is more to tell of this place than is shown";
                self.diagnostics.push(Diagnostic { message: message.to_owned(), ..diagnostic });
            }
        } else if *repeated <= MOST_REPEATED {
            self.diagnostics.push(diagnostic);
        } else if *repeated == MOST_REPEATED + 1 {
            let message = format!("this was found in more places than are shown: {}", diagnostic.message);
            self.diagnostics.push(Diagnostic { message, ..diagnostic });
        }
    }

    /// Adds a line of output, unless there are too many or too long ones.
    pub(crate) fn echo(&mut self, span: Span, text: String) {
        let most = self.options.limits.echoes;
        if self.echoes.len() > most {
            return;
        }
        let message = match self.echo_bytes.checked_sub(text.len()) {
            _ if self.echoes.len() == most => format!("the scene echoes more than {most} lines"),
            Some(left) => {
                self.echo_bytes = left;
                format!("ECHO: {text}")
            }
            None => {
                let most = self.options.limits.echo_bytes;
                format!("this line is left out: the scene echoes more than {most} bytes")
            }
        };
        self.echoes.push(Diagnostic::note(span, message));
    }

    fn with_calls(&self, mut diagnostic: Diagnostic) -> Diagnostic {
        let mut shown = 0;
        let mut previous = diagnostic.span;
        for call in self.calls.iter().rev() {
            if shown == SHOWN_CALLS {
                break;
            }
            if previous != Some(call.site) {
                diagnostic = diagnostic.with_related(call.site, format!("in this call of `{}`", call.name));
                shown += 1;
            }
            previous = Some(call.site);
        }
        diagnostic
    }
}

impl Drop for Evaluator<'_> {
    /// Function literals and the scopes they are stored in refer to each other. And scopes go before those around
    /// them, which are older, so that no long chain of them is dropped by recursion.
    fn drop(&mut self) {
        for scope in &self.captured {
            scope.clear();
        }
        while self.captured.pop().is_some() {}
    }
}
