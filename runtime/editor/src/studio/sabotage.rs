//! What goes wrong when tests want it to.

use std::sync::Mutex;

use chiaro_render::Error;

/// A mishap of the drawing thread.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mishap {
    /// The device is lost.
    Loss,
    /// The code panics.
    Panic,
}

/// The mishaps to come.
#[derive(Debug, Default)]
pub(crate) struct Sabotage(Mutex<Vec<Mishap>>);

impl Sabotage {
    /// Lets these happen, one each time that something is drawn.
    pub(crate) fn plan(&self, mishaps: &[Mishap]) {
        super::lock(&self.0).extend(mishaps);
    }

    /// Whether all of them happened.
    pub(crate) fn is_done(&self) -> bool {
        super::lock(&self.0).is_empty()
    }

    /// Lets the next mishap happen, if one is planned.
    pub(super) fn work(&self) -> Result<(), Error> {
        let next = super::lock(&self.0).pop();
        match next {
            Some(Mishap::Loss) => Err(Error::Lost("it was unplugged".to_owned())),
            Some(Mishap::Panic) => panic!("a planned mistake"),
            None => Ok(()),
        }
    }
}
