//! How the sweep is observed: counters, clocks and events, which cost nothing when nobody observes.

use crate::recorder::{Phase, Recorder};
use crate::stats::Counters;
use crate::trace::Event;

/// Receives what the sweep did; `()` receives nothing and compiles to nothing.
pub(crate) trait Probe {
    /// Whether events are received.
    const EVENTS: bool = false;
    /// Whether anything is recorded.
    const RECORDS: bool = true;

    /// A part of the algorithm (section 3.2) begins.
    fn begin(&mut self, _phase: Phase) {}

    /// Adds to the counters.
    #[inline(always)]
    fn count(&mut self, _add: impl FnOnce(&mut Counters)) {}

    /// Records what is more than a number.
    #[inline(always)]
    fn record(&mut self, _record: impl FnOnce(&mut Recorder)) {}

    /// One step.
    #[inline(always)]
    fn event(&mut self, _event: Event) {}
}

impl Probe for () {
    const RECORDS: bool = false;
}

impl Probe for Recorder {
    fn begin(&mut self, phase: Phase) {
        self.clock(phase);
    }

    #[inline(always)]
    fn count(&mut self, add: impl FnOnce(&mut Counters)) {
        add(&mut self.stats.counters);
    }

    #[inline(always)]
    fn record(&mut self, record: impl FnOnce(&mut Recorder)) {
        record(self);
    }
}

/// Records statistics and passes events on to a closure.
#[derive(Debug)]
pub(crate) struct Observer<E> {
    pub(crate) recorder: Recorder,
    pub(crate) observer: E,
}

impl<E: FnMut(Event)> Probe for Observer<E> {
    const EVENTS: bool = true;

    fn begin(&mut self, phase: Phase) {
        self.recorder.begin(phase);
    }

    fn count(&mut self, add: impl FnOnce(&mut Counters)) {
        self.recorder.count(add);
    }

    fn record(&mut self, record: impl FnOnce(&mut Recorder)) {
        self.recorder.record(record);
    }

    fn event(&mut self, event: Event) {
        (self.observer)(event);
    }
}
