//! Many questions to one program, and what came of them.

use std::collections::BTreeMap;
use std::fmt;
use std::ops::AddAssign;

use super::ask;
use super::claims::{Asked, Claims};
use super::made::question;
use super::outcome::Outcome;
use super::question::Question;
use super::right::Right;
use super::shrink::{Wrong, least};
use sweep_cdt_generate::Random;

/// What is asked, and how much of what is found is kept.
#[derive(Clone, Debug)]
pub struct Campaign {
    /// The claims of the program.
    pub claims: Claims,
    /// So many questions are asked.
    pub executions: u64,
    /// The seed of the questions: the same seed, the same questions.
    pub seed: u64,
    /// So many findings of each name are made small and kept.
    pub kept: u64,
}

/// What came of the questions.
#[derive(Clone, Debug, Default)]
pub struct Summary {
    /// So many questions were made.
    pub executions: u64,
    /// So many of them may not be asked.
    pub left_out: u64,
    /// What came of each kind of question.
    pub kinds: BTreeMap<&'static str, Row>,
    /// How often each fault was found.
    pub faults: BTreeMap<&'static str, u64>,
    /// The first ones of each name, each with a small question.
    pub findings: Vec<Finding>,
}

/// What came of the questions of a kind.
#[derive(Clone, Copy, Debug, Default)]
pub struct Row {
    /// So many answers were right.
    pub right: u64,
    /// So many questions were refused, as the program may.
    pub refused: u64,
    /// So many answers were wrong, or did not come.
    pub wrong: u64,
}

impl Row {
    /// Counts what came of a question.
    pub fn count(&mut self, outcome: &Outcome, is_wrong: bool) {
        match outcome {
            _ if is_wrong => self.wrong += 1,
            Outcome::Refused(_) => self.refused += 1,
            _ => self.right += 1,
        }
    }

    /// So many questions were asked.
    pub fn asked(&self) -> u64 {
        self.right + self.refused + self.wrong
    }
}

impl AddAssign for Row {
    fn add_assign(&mut self, other: Row) {
        self.right += other.right;
        self.refused += other.refused;
        self.wrong += other.wrong;
    }
}

/// A fault, with a small question that has it.
#[derive(Clone, Debug)]
pub struct Finding {
    /// The small question, its answer, and what is wrong with it.
    pub least: Wrong,
    /// The right triangles; nothing where there are none, or where points come and go.
    pub right: Option<Vec<[usize; 3]>>,
    /// The number of the question that was asked first.
    pub execution: u64,
    /// The question that was asked first.
    pub first: Question,
}

impl Campaign {
    /// The question of this number, and its kind.
    pub fn question(&self, execution: u64) -> (&'static str, Option<Question>) {
        let mut random = Random::new(self.seed ^ Random::new(execution).bits());
        // Few points as a rule: most faults need no more, and small questions are judged soon.
        let is_small = !random.one_in(4);
        let more = if is_small {
            10 + random.below(40)
        } else {
            40 + random.below(200)
        };
        let mut bytes = random.bytes(12 + more);
        if is_small && [Asked::Points, Asked::Edges].contains(&self.claims.asked) {
            // The number of points of a shape.
            bytes[11] = 3 + bytes[11] % 10;
        }
        question(&self.claims, &bytes)
    }

    /// Asks all questions. `progress` sees what came of them after each.
    ///
    /// # Panics
    /// If the oracle finds this crate wrong, or two judges disagree.
    pub fn run(
        &self,
        program: &mut dyn FnMut(&Question) -> Outcome,
        progress: &mut dyn FnMut(&Summary),
    ) -> Summary {
        let mut summary = Summary::default();
        for execution in 0..self.executions {
            let (kind, question) = self.question(execution);
            summary.executions += 1;
            match question {
                Some(question) => self.ask(execution, kind, question, program, &mut summary),
                None => summary.left_out += 1,
            }
            progress(&summary);
        }
        summary
    }

    fn ask(
        &self,
        execution: u64,
        kind: &'static str,
        question: Question,
        program: &mut dyn FnMut(&Question) -> Outcome,
        summary: &mut Summary,
    ) {
        let outcome = program(&question);
        let fault = self.claims.fault(&question, &outcome);
        let row = summary.kinds.entry(kind).or_default();
        row.count(&outcome, fault.is_some());
        let Some(fault) = fault else { return };
        let count = summary.faults.entry(fault.name).or_default();
        *count += 1;
        if *count <= self.kept {
            let first = question.clone();
            let wrong = Wrong {
                question,
                outcome,
                fault,
            };
            let least = least(&self.claims, wrong, program);
            let right = (least.question.operations.is_empty())
                .then(|| Right::of(&least.question).ok())
                .flatten()
                .map(|right| right.inside);
            if summary
                .findings
                .iter()
                .any(|found| found.least.question == least.question)
            {
                return;
            }
            summary.findings.push(Finding {
                least,
                right,
                execution,
                first,
            });
        }
    }
}

/// Asks a program of this process: see [`Campaign`]. At most three findings of each name are kept.
pub fn campaign<O: Into<Outcome>>(
    claims: &Claims,
    executions: u64,
    seed: u64,
    mut program: impl FnMut(&Question) -> O,
) -> Summary {
    let campaign = Campaign {
        claims: claims.clone(),
        executions,
        seed,
        kept: 3,
    };
    campaign.run(&mut |question| ask(question, &mut program), &mut |_| {})
}

/// A table by kinds of questions, the faults, and the findings.
impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "{:<14} {:>9} {:>9} {:>9} {:>9}",
            "kind", "asked", "right", "refused", "wrong"
        )?;
        let mut all = Row::default();
        let line = |f: &mut fmt::Formatter<'_>, kind: &str, row: &Row| {
            let Row {
                right,
                refused,
                wrong,
            } = row;
            let asked = row.asked();
            writeln!(
                f,
                "{kind:<14} {asked:>9} {right:>9} {refused:>9} {wrong:>9}"
            )
        };
        for (kind, row) in &self.kinds {
            line(f, kind, row)?;
            all += *row;
        }
        line(f, "all", &all)?;
        writeln!(
            f,
            "{} questions made, {} of them left out",
            self.executions, self.left_out
        )?;
        for (name, count) in &self.faults {
            writeln!(f, "{name}: {count}")?;
        }
        for finding in &self.findings {
            let Wrong {
                question, fault, ..
            } = &finding.least;
            writeln!(
                f,
                "\n{} (question {}): {}",
                fault.name, finding.execution, fault.what
            )?;
            writeln!(f, "{}", super::json::question_line(question))?;
        }
        Ok(())
    }
}
