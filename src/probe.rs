//! How the sweep is looked on from outside: counters that cost nothing when nobody looks.

use crate::stats::Counters;

/// Receives what the sweep did; `()` receives nothing and compiles to nothing.
pub(crate) trait Probe {
    /// Adds to the counters.
    fn count(&mut self, add: impl FnOnce(&mut Counters));
}

impl Probe for () {
    #[inline(always)]
    fn count(&mut self, _: impl FnOnce(&mut Counters)) {}
}

impl Probe for Counters {
    #[inline(always)]
    fn count(&mut self, add: impl FnOnce(&mut Counters)) {
        add(self);
    }
}
