//! Violations as they are found.

use super::level::Level;
use super::violation::Violation;

/// The first violations that matter, how many there are, and what level all of them leave.
#[derive(Clone, Debug)]
pub(super) struct Findings {
    limit: usize,
    /// What is asked for. What breaks a higher level only is no violation.
    asked: Level,
    /// The lowest level that is not reached.
    broken: Option<Level>,
    pub(super) list: Vec<Violation>,
    pub(super) found: usize,
}

impl Findings {
    pub(super) fn new(limit: usize, asked: Level) -> Findings {
        Findings {
            limit,
            asked,
            broken: None,
            list: Vec::new(),
            found: 0,
        }
    }

    /// Nothing found, with the same limit and the same level asked for.
    pub(super) fn emptied(&self) -> Findings {
        Findings::new(self.limit, self.asked)
    }

    pub(super) fn is_empty(&self) -> bool {
        self.found == 0
    }

    /// The level asked for.
    pub(super) fn asked(&self) -> Level {
        self.asked
    }

    /// The highest level reached.
    pub(super) fn reached(&self) -> Option<Level> {
        self.broken.map_or(Some(Level::Canonical), Level::below)
    }

    pub(super) fn add(&mut self, violation: Violation) {
        let level = violation.level();
        self.breaks(Some(level));
        if level > self.asked {
            return;
        }
        self.found += 1;
        if self.list.len() < self.limit {
            self.list.push(violation);
        }
    }

    pub(super) fn append(&mut self, later: Findings) {
        self.breaks(later.broken);
        self.found += later.found;
        let room = self.limit - self.list.len();
        self.list.extend(later.list.into_iter().take(room));
    }

    fn breaks(&mut self, level: Option<Level>) {
        self.broken = self.broken.into_iter().chain(level).min();
    }
}
