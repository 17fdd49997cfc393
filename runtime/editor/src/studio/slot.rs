//! A place for the newest request.

use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

/// Holds at most one value: putting another one in forgets the one before.
#[derive(Debug)]
pub(crate) struct Slot<T> {
    contents: Mutex<Contents<T>>,
    changed: Condvar,
}

#[derive(Debug)]
struct Contents<T> {
    value: Option<T>,
    closed: bool,
}

impl<T> Slot<T> {
    pub(crate) fn new() -> Self {
        Self { contents: Mutex::new(Contents { value: None, closed: false }), changed: Condvar::new() }
    }

    /// Puts in a value, in the place of any that nobody took.
    pub(crate) fn put(&self, value: T) {
        self.lock().value = Some(value);
        self.changed.notify_all();
    }

    /// Changes what is there, or puts something in.
    pub(crate) fn update(&self, change: impl FnOnce(&mut Option<T>)) {
        change(&mut self.lock().value);
        self.changed.notify_all();
    }

    /// The value, if there is one now.
    pub(crate) fn try_take(&self) -> Option<T> {
        self.lock().value.take()
    }

    /// Waits for a value. None if the slot was closed.
    pub(crate) fn take(&self) -> Option<T> {
        let waiting = |contents: &mut Contents<T>| contents.value.is_none() && !contents.closed;
        let guard = self.changed.wait_while(self.lock(), waiting);
        guard.unwrap_or_else(PoisonError::into_inner).value.take()
    }

    /// Wakes whoever waits: nothing will come any more.
    pub(crate) fn close(&self) {
        let mut contents = self.lock();
        contents.closed = true;
        contents.value = None;
        drop(contents);
        self.changed.notify_all();
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.lock().value.is_none()
    }

    pub(crate) fn is_closed(&self) -> bool {
        self.lock().closed
    }

    fn lock(&self) -> MutexGuard<'_, Contents<T>> {
        self.contents.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_newest_value_is_kept() {
        let slot = Slot::new();
        slot.put(1);
        slot.put(2);
        assert_eq!(slot.take(), Some(2));
        assert_eq!(slot.try_take(), None);
        slot.put(3);
        slot.close();
        assert_eq!(slot.take(), None);
    }
}
