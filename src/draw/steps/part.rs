//! The steps that a page or a sheet shows, out of all steps of a run.

use std::ops::RangeInclusive;

use super::scene::Scene;
use crate::trace::Event;

/// Some steps that follow one another.
#[derive(Debug)]
pub(super) struct Part<'a> {
    /// The number of the first one, counted from 1.
    pub(super) first: usize,
    pub(super) events: &'a [Event],
    /// The scene before the first one.
    pub(super) before: Scene,
    /// How many steps were asked for, if there is no limit.
    pub(super) wanted: usize,
}

impl<'a> Part<'a> {
    /// The steps with these numbers, as far as they exist, and at most `most` of them.
    pub(super) fn new(all: &'a [Event], steps: &RangeInclusive<usize>, most: usize) -> Part<'a> {
        let start = steps.start().saturating_sub(1).min(all.len());
        let end = (*steps.end()).min(all.len()).max(start);
        let mut before = Scene::new();
        for event in &all[..start] {
            before.advance(event);
        }
        Part {
            first: start + 1,
            events: &all[start..end.min(start.saturating_add(most))],
            before,
            wanted: end - start,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Part;
    use crate::trace::Event;

    #[test]
    fn steps_that_do_not_exist_are_left_out() {
        let all = [Event::Finalization; 5];
        let part = |steps, most| {
            let part = Part::new(&all, &steps, most);
            [part.first, part.events.len(), part.wanted]
        };
        assert_eq!(part(1..=usize::MAX, 10), [1, 5, 5]);
        assert_eq!(part(2..=4, 10), [2, 3, 3]);
        assert_eq!(part(2..=4, 2), [2, 2, 3]);
        assert_eq!(part(0..=1, 10), [1, 1, 1]);
        assert_eq!(part(9..=12, 10), [6, 0, 0]);
        assert_eq!(part(4..=9, usize::MAX), [4, 2, 2]);
    }
}
