//! How the sweep is observed: counters, clocks and events, which cost nothing when nobody observes. The sweep is
//! compiled twice, whatever the scalar: with `()`, and with an [`Observer`] for counted runs, with or without events.

use core::fmt;

use crate::observe::recorder::{Phase, Recorder};
use crate::observe::stats::Counters;
use crate::trace::Event;

/// Receives the counts and events of the sweep; `()` receives nothing and compiles to nothing.
pub(crate) trait Probe {
    /// Whether anything is recorded, and events may be received.
    const RECORDS: bool;

    #[inline(always)]
    fn wants_events(&self) -> bool {
        false
    }

    /// A part of the algorithm (section 3.2) begins.
    fn begin(&mut self, _phase: Phase) {}

    #[inline(always)]
    fn count(&mut self, _add: impl FnOnce(&mut Counters)) {}

    /// Records more than a count.
    #[inline(always)]
    fn record(&mut self, _record: impl FnOnce(&mut Recorder)) {}

    #[inline(always)]
    fn event(&mut self, _event: Event) {}
}

impl Probe for () {
    const RECORDS: bool = false;
}

/// Records statistics, and passes events on if somebody wants them.
#[derive(Default)]
pub(crate) struct Observer<'o> {
    pub(crate) recorder: Recorder,
    pub(crate) events: Option<&'o mut dyn FnMut(Event)>,
}

impl<'o> Observer<'o> {
    pub(crate) fn of(events: Option<&'o mut dyn FnMut(Event)>) -> Self {
        Observer {
            recorder: Recorder::default(),
            events,
        }
    }
}

impl Probe for Observer<'_> {
    const RECORDS: bool = true;

    #[inline(always)]
    fn wants_events(&self) -> bool {
        self.events.is_some()
    }

    fn begin(&mut self, phase: Phase) {
        self.recorder.clock(phase);
    }

    #[inline(always)]
    fn count(&mut self, add: impl FnOnce(&mut Counters)) {
        add(&mut self.recorder.stats.counters);
    }

    #[inline(always)]
    fn record(&mut self, record: impl FnOnce(&mut Recorder)) {
        record(&mut self.recorder);
    }

    fn event(&mut self, event: Event) {
        if let Some(take) = &mut self.events {
            take(event);
        }
    }
}

impl fmt::Debug for Observer<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Observer")
            .field("recorder", &self.recorder)
            .field("wants_events", &self.events.is_some())
            .finish()
    }
}
