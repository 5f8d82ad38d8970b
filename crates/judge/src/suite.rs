//! `suite`: a program, asked the inputs of the suite of conformance that it claims to answer.

use std::collections::BTreeMap;

use sweep_cdt_testing::judge::{Fault, Row, json};
use sweep_cdt_testing::suite;

use crate::claims::{ClaimArgs, ProgramArgs};

/// Asks the inputs of the suite of conformance that the program claims to answer, and prints a table by kind
#[derive(clap::Args)]
pub(crate) struct Suite {
    #[command(flatten)]
    claims: ClaimArgs,
    /// Asks the cases alone that have this in their names
    #[arg(long, value_name = "WORD", default_value = "")]
    only: String,
    /// Prints all wrong answers, each with its question
    #[arg(long)]
    explain: bool,
    #[command(flatten)]
    program: ProgramArgs,
}

/// So many wrong answers are listed without --explain.
const SHOWN: usize = 20;

/// The suite of this version.
const CASES: &str = include_str!("../../../tests/conformance/cases.jsonl");

impl Suite {
    pub(crate) fn run(self) -> Result<bool, String> {
        let cases = suite::read(CASES)?;
        let claims = self.claims.claims();
        let mut program = self.program.start()?;
        program.greet(&claims)?;
        let mut kinds: BTreeMap<&str, (Row, u64)> = BTreeMap::new();
        let mut wrong = Vec::new();
        for case in cases.iter().filter(|case| case.name.contains(&self.only)) {
            let (row, skipped) = kinds.entry(&case.kind).or_default();
            let Some(question) = case.question_within(&claims) else {
                *skipped += 1;
                continue;
            };
            let outcome = program.ask(&question);
            let fault = case.fault(&claims, &question, &outcome);
            row.count(&outcome, fault.is_some());
            wrong.extend(fault.map(|fault| (case, question, outcome, fault)));
        }
        println!("suite: version {}, {} cases", suite::VERSION, cases.len());
        println!("program: {}, {}", program.command(), program.version());
        println!("claims: {claims}\n");
        print_table(&kinds);
        let shown = if self.explain { wrong.len() } else { SHOWN };
        for (case, question, outcome, Fault { name, what }) in wrong.iter().take(shown) {
            if self.explain {
                let (question, answer) =
                    (json::question_line(question), json::answer_line(outcome));
                println!("{}: {name}: {what}\n  {question}\n  {answer}", case.name);
            } else {
                // What a program said before it crashed has many lines.
                println!(
                    "{}: {name}: {}",
                    case.name,
                    what.lines().next().unwrap_or_default()
                );
            }
        }
        if wrong.len() > shown {
            println!(
                "{} more: --explain prints all, with their questions",
                wrong.len() - shown
            );
        }
        Ok(wrong.is_empty())
    }
}

fn print_table(kinds: &BTreeMap<&str, (Row, u64)>) {
    println!(
        "{:<24} {:>7} {:>7} {:>7} {:>7} {:>9}",
        "kind", "asked", "right", "refused", "wrong", "not asked"
    );
    let line = |kind: &str, row: &Row, not_asked: u64| {
        let Row {
            right,
            refused,
            wrong,
        } = row;
        let asked = row.asked();
        println!("{kind:<24} {asked:>7} {right:>7} {refused:>7} {wrong:>7} {not_asked:>9}");
    };
    let (mut all, mut none) = (Row::default(), 0);
    for (kind, (row, not_asked)) in kinds {
        // Of kinds that are none for the program the sum says enough.
        if row.asked() > 0 {
            line(kind, row, *not_asked);
        }
        all += *row;
        none += not_asked;
    }
    line("all", &all, none);
}
