//! Lists, and how many values they hold.

use std::cell::Cell;
use std::ops::Deref;
use std::rc::Rc;

use super::Value;

/// What a list takes beside its values, counted in values.
const OVERHEAD: u64 = 2;

thread_local! {
    /// How many values the lists of this thread hold. Lists never leave their thread.
    static HELD: Cell<u64> = const { Cell::new(0) };
}

/// How many values the lists there are hold, those in the making included: what bounds the memory of a program.
pub(crate) fn held() -> u64 {
    HELD.get()
}

/// A list of values.
#[derive(Clone, Debug)]
pub(crate) struct List(Rc<Elements>);

/// The values of a list, which grows until it becomes a [`List`].
#[derive(Debug)]
pub(crate) struct Elements {
    values: Vec<Value>,
    depth: u32,
    weight: u64,
}

impl Elements {
    /// None yet, with room for so many.
    pub(crate) fn with_capacity(count: usize) -> Self {
        HELD.set(HELD.get() + OVERHEAD);
        Self { values: Vec::with_capacity(count), depth: 1, weight: 1 }
    }

    /// Appends a value.
    pub(crate) fn push(&mut self, value: Value) {
        HELD.set(HELD.get() + 1);
        self.depth = self.depth.max(1 + value.depth());
        self.weight = self.weight.saturating_add(value.weight());
        self.values.push(value);
    }

    /// How many elements there are.
    pub(crate) fn len(&self) -> usize {
        self.values.len()
    }

    /// How many values there are on all levels, itself included.
    pub(crate) fn weight(&self) -> u64 {
        self.weight
    }
}

impl Drop for Elements {
    fn drop(&mut self) {
        HELD.set(HELD.get().saturating_sub(self.values.len() as u64 + OVERHEAD));
    }
}

impl List {
    /// How many levels of lists there are, itself included. It is limited, so that lists can be walked by recursion.
    pub(crate) fn depth(&self) -> u32 {
        self.0.depth
    }

    /// How many values there are on all levels; shared ones count each time, since they are visited each time.
    pub(crate) fn weight(&self) -> u64 {
        self.0.weight
    }
}

impl From<Elements> for List {
    fn from(elements: Elements) -> Self {
        Self(Rc::new(elements))
    }
}

impl From<Vec<Value>> for List {
    fn from(values: Vec<Value>) -> Self {
        let mut elements = Elements::with_capacity(values.len());
        values.into_iter().for_each(|value| elements.push(value));
        elements.into()
    }
}

impl Deref for List {
    type Target = [Value];

    fn deref(&self) -> &[Value] {
        &self.0.values
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_lists_hold_is_counted_until_they_are_dropped() {
        let before = held();
        let inner = Value::list(vec![Value::number(1.0); 10]);
        let outer = Value::list(vec![inner.clone(), inner]);
        assert_eq!((outer.weight(), outer.depth()), (23, 2));
        assert_eq!(held() - before, 12 + 2 * OVERHEAD);
        drop(outer);
        assert_eq!(held(), before);
    }
}
