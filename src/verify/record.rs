//! What the checks record: counts, how signs were decided, and violations.

use super::report::{Level, Report, Violations};
use super::soup::Tally;
use super::violation::Violation;

/// The answer as it is being made.
#[derive(Debug)]
pub(super) struct Record {
    pub(super) report: Report,
    pub(super) tally: Tally,
    pub(super) findings: Findings,
}

impl Record {
    /// Nothing is checked yet. At most `limit` violations of the level asked for, or those before it, will be listed.
    pub(super) fn new(limit: usize, asked: Level) -> Record {
        Record {
            report: Report::default(),
            tally: Tally::default(),
            findings: Findings::new(limit, asked),
        }
    }

    /// The answer to the caller.
    pub(super) fn answer(mut self) -> Result<Report, Violations> {
        if !self.report.is_canonical() {
            let sides = self.report.uncanonical_sides;
            self.findings.add(Violation::NotCanonical { sides });
        }
        let report = Report {
            filtered: self.tally.filtered,
            exact: self.tally.exact,
            level: self.findings.reached(),
            ..self.report
        };
        if self.findings.is_empty() {
            return Ok(report);
        }
        Err(Violations {
            asked: self.findings.asked(),
            list: self.findings.list,
            found: self.findings.found,
            report: Box::new(report),
        })
    }
}

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
