//! What the checks record: counts, how signs were decided, and violations.

use super::findings::Findings;
use super::report::{Report, Violations};
use super::signs::Tally;

/// The answer as it is being made.
#[derive(Debug)]
pub(super) struct Record {
    pub(super) report: Report,
    pub(super) tally: Tally,
    pub(super) findings: Findings,
}

impl Record {
    /// Nothing is checked yet. At most `limit` violations will be listed.
    pub(super) fn new(limit: usize) -> Record {
        Record {
            report: Report::default(),
            tally: Tally::default(),
            findings: Findings::new(limit),
        }
    }

    /// The answer to the caller.
    pub(super) fn answer(self) -> Result<Report, Violations> {
        let report = Report {
            filtered: self.tally.filtered,
            exact: self.tally.exact,
            ..self.report
        };
        if self.findings.is_empty() {
            return Ok(report);
        }
        Err(Violations {
            list: self.findings.list,
            found: self.findings.found,
            report: Box::new(report),
        })
    }
}
