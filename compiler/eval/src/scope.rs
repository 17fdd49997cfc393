//! Scopes: what names stand for.
//!
//! Scopes nest lexically. Variables whose names begin with `$` are in none of them: they follow the calls, so that
//! [`Specials`] keeps them on a stack.

use std::cell::{Cell, RefCell};
use std::fmt;
use std::rc::Rc;

use chiaro_syntax::tree::Name;
use rustc_hash::FxHashMap;

use crate::value::Value;

/// The number of a block's [`Plan`](crate::plan::Plan).
pub(crate) type PlanId = usize;

/// What is known of a variable: its value, or nothing if computing it failed, which has been reported then.
pub(crate) type Slot = Option<Value>;

/// More variables than this get an index by name.
const LINEAR_SEARCH: usize = 12;

/// One level of names.
pub(crate) struct Scope {
    /// The scope around it.
    pub(crate) parent: Option<Rc<Scope>>,
    /// The block with the functions and modules defined here, if there may be any.
    pub(crate) plan: Option<PlanId>,
    /// Which of the evaluator's children `children()` stands for here, if a module's body begins here.
    pub(crate) children: Option<usize>,
    variables: RefCell<Variables>,
    /// Whether a function literal refers to it, so that the evaluator keeps it in its list of such scopes.
    is_captured: Cell<bool>,
}

#[derive(Clone, Default)]
struct Variables {
    entries: Vec<(Name, Slot)>,
    index: FxHashMap<Name, usize>,
}

impl Scope {
    /// An empty scope in another.
    pub(crate) fn within(parent: &Rc<Scope>) -> Scope {
        Scope { parent: Some(parent.clone()), ..Scope::outermost(None) }
    }

    /// An empty scope in no other, for the file with that plan.
    pub(crate) fn outermost(plan: Option<PlanId>) -> Scope {
        let variables = RefCell::default();
        Scope { parent: None, plan, children: None, variables, is_captured: Cell::new(false) }
    }

    /// The scope of the block with that plan.
    pub(crate) fn of_block(self, plan: PlanId) -> Scope {
        Scope { plan: Some(plan), ..self }
    }

    /// The scope of a module's body, whose instance was given these children.
    pub(crate) fn with_children(self, children: usize) -> Scope {
        Scope { children: Some(children), ..self }
    }

    /// Sets a variable of this very scope.
    pub(crate) fn set(&self, name: Name, slot: Slot) {
        self.variables.borrow_mut().set(name, slot);
    }

    /// The variable of this very scope.
    pub(crate) fn local(&self, name: &Name) -> Option<Slot> {
        let variables = self.variables.borrow();
        variables.position(name).map(|at| variables.entries[at].1.clone())
    }

    /// The variable in this scope or the nearest one around it, and how many scopes were looked through.
    pub(crate) fn lookup(&self, name: &Name) -> (Option<Slot>, u32) {
        let mut looked_through = 0;
        let slot = self.chain().find_map(|scope| {
            looked_through += 1;
            scope.local(name)
        });
        (slot, looked_through)
    }

    /// This scope and those around it, from the inside out.
    pub(crate) fn chain(&self) -> impl Iterator<Item = &Scope> {
        std::iter::successors(Some(self), |scope| scope.parent.as_deref())
    }

    /// The names of the variables of this very scope.
    pub(crate) fn names(&self) -> Vec<Name> {
        self.variables.borrow().entries.iter().map(|(name, _)| name.clone()).collect()
    }

    /// Marks it as captured. Answers whether it was not so before.
    pub(crate) fn capture(&self) -> bool {
        !self.is_captured.replace(true)
    }

    /// A scope with the same variables within another.
    pub(crate) fn copied_into(&self, parent: &Rc<Scope>) -> Scope {
        Scope { variables: self.variables.clone(), ..Scope::within(parent) }
    }

    /// Forgets all variables, which breaks cycles of scopes and the function literals in them.
    pub(crate) fn clear(&self) {
        drop(self.variables.take());
    }
}

impl fmt::Debug for Scope {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.names()).finish()
    }
}

impl Variables {
    fn position(&self, name: &Name) -> Option<usize> {
        if self.entries.len() > LINEAR_SEARCH {
            self.index.get(name).copied()
        } else {
            self.entries.iter().position(|(entry, _)| entry == name)
        }
    }

    fn set(&mut self, name: Name, slot: Slot) {
        if let Some(at) = self.position(&name) {
            self.entries[at].1 = slot;
            return;
        }
        self.entries.push((name.clone(), slot));
        if self.entries.len() == LINEAR_SEARCH + 1 {
            self.index = self.entries.iter().enumerate().map(|(at, (name, _))| (name.clone(), at)).collect();
        } else if self.entries.len() > LINEAR_SEARCH {
            self.index.insert(name, self.entries.len() - 1);
        }
    }
}

/// The names of the variables that the evaluator itself sets and asks for again and again.
pub(crate) struct WellKnown {
    /// `$fn`, the number of sides of curves.
    pub(crate) sides: Name,
    /// `$children`, the number of a module's children.
    pub(crate) children: Name,
    /// `$parent_modules`, the number of modules whose instances are under way.
    pub(crate) parent_modules: Name,
}

impl Default for WellKnown {
    fn default() -> Self {
        Self { sides: "$fn".into(), children: "$children".into(), parent_modules: "$parent_modules".into() }
    }
}

/// The variables that follow the calls: each name with its values, the current one last.
#[derive(Default)]
pub(crate) struct Specials {
    values: FxHashMap<Name, Vec<Slot>>,
    set: Vec<Name>,
    /// What used files whose calls are under way say, where no caller sets anything; that of the outermost call first.
    fallbacks: Vec<(Name, Slot)>,
    /// What the language itself sets, where nothing in the scene does.
    defaults: FxHashMap<Name, Slot>,
}

/// A state of [`Specials`].
#[derive(Clone, Copy)]
pub(crate) struct Mark {
    set: usize,
    fallbacks: usize,
}

impl Specials {
    /// Whether that name is of such a variable. The number of a module's children is known only in the module.
    pub(crate) fn is_special(name: &str) -> bool {
        name.as_bytes().first() == Some(&b'$') && name != "$children"
    }

    /// The current value.
    pub(crate) fn get(&self, name: &Name) -> Option<&Slot> {
        let fallback = || self.fallbacks.iter().find(|(other, _)| other == name).map(|(_, slot)| slot);
        let set = self.values.get(name).and_then(|values| values.last());
        set.or_else(fallback).or_else(|| self.defaults.get(name))
    }

    /// Sets the value that the language gives a variable, below all that scenes set.
    pub(crate) fn set_default(&mut self, name: Name, value: Value) {
        self.defaults.insert(name, Some(value));
    }

    /// Sets a value that counts where nothing else is set, until [`restore`](Self::restore) is called with an earlier
    /// mark.
    pub(crate) fn set_if_open(&mut self, name: &Name, slot: &Slot) {
        if !self.fallbacks.iter().any(|(other, _)| other == name) {
            self.fallbacks.push((name.clone(), slot.clone()));
        }
    }

    /// Takes away what [`set_if_open`](Self::set_if_open) has set since that mark, to be [shown](Self::show) again.
    pub(crate) fn hide(&mut self, mark: Mark) -> Vec<(Name, Slot)> {
        self.fallbacks.split_off(mark.fallbacks.min(self.fallbacks.len()))
    }

    /// Brings back what was hidden.
    pub(crate) fn show(&mut self, mut hidden: Vec<(Name, Slot)>) {
        self.fallbacks.append(&mut hidden);
    }

    /// Sets a value, until [`restore`](Self::restore) is called with an earlier mark.
    pub(crate) fn set(&mut self, name: Name, slot: Slot) {
        self.values.entry(name.clone()).or_default().push(slot);
        self.set.push(name);
    }

    /// The current state, to be restored later.
    pub(crate) fn mark(&self) -> Mark {
        Mark { set: self.set.len(), fallbacks: self.fallbacks.len() }
    }

    /// Takes back everything that was set since that mark.
    pub(crate) fn restore(&mut self, mark: Mark) {
        self.fallbacks.truncate(mark.fallbacks);
        while self.set.len() > mark.set {
            if let Some(values) = self.set.pop().and_then(|name| self.values.get_mut(&name)) {
                values.pop();
            }
        }
    }

    /// All names that have been set, some of them twice.
    pub(crate) fn names(&self) -> impl Iterator<Item = &Name> {
        self.values.keys().chain(self.defaults.keys())
    }
}
