//! How the sweep is looked on from outside: counters and events that cost nothing when nobody looks.

use std::fmt;

use crate::stats::Counters;
use crate::trace::Event;

/// Receives what the sweep did; `()` receives nothing and compiles to nothing.
pub(crate) trait Probe {
    /// Whether events are received.
    const EVENTS: bool = false;

    /// Adds to the counters.
    #[inline(always)]
    fn count(&mut self, _add: impl FnOnce(&mut Counters)) {}

    /// One step.
    #[inline(always)]
    fn event(&mut self, _event: Event) {}
}

impl Probe for () {}

impl Probe for Counters {
    #[inline(always)]
    fn count(&mut self, add: impl FnOnce(&mut Counters)) {
        add(self);
    }
}

/// Passes events on to a closure.
pub(crate) struct Observer<E>(pub(crate) E);

impl<E> fmt::Debug for Observer<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Observer")
    }
}

impl<E: FnMut(Event)> Probe for Observer<E> {
    const EVENTS: bool = true;

    fn event(&mut self, event: Event) {
        (self.0)(event);
    }
}
