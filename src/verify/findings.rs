//! Violations as they are found.

use super::violation::Violation;

/// The first violations, and how many there are.
#[derive(Debug)]
pub(super) struct Findings {
    limit: usize,
    pub(super) list: Vec<Violation>,
    pub(super) found: usize,
}

impl Findings {
    pub(super) fn new(limit: usize) -> Findings {
        Findings {
            limit,
            list: Vec::new(),
            found: 0,
        }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.found == 0
    }

    /// How many are listed at most.
    pub(super) fn limit(&self) -> usize {
        self.limit
    }

    pub(super) fn add(&mut self, violation: Violation) {
        self.found += 1;
        if self.list.len() < self.limit {
            self.list.push(violation);
        }
    }

    pub(super) fn append(&mut self, later: Findings) {
        self.found += later.found;
        let room = self.limit - self.list.len();
        self.list.extend(later.list.into_iter().take(room));
    }
}
