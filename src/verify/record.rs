//! What the checks record: counts, how signs were decided, and violations.

use super::findings::Findings;
use super::level::Level;
use super::report::{Report, Violations};
use super::signs::Tally;
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
