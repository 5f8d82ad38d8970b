//! `suite`: a program, asked the inputs of the suite of conformance that it claims to answer.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use sweep_cdt_testing::judge::{Fault, Outcome, Row, json};
use sweep_cdt_testing::suite;

use crate::claims::{ClaimArgs, ProgramArgs};

/// Asks the inputs of the suite of conformance that the program claims to answer, and prints a table by kind
#[derive(clap::Args)]
pub(crate) struct Suite {
    #[command(flatten)]
    claims: ClaimArgs,
    /// Another file of cases than the one of this version
    #[arg(long, value_name = "FILE")]
    cases: Option<PathBuf>,
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
        let cases = match &self.cases {
            None => suite::read(CASES)?,
            Some(file) => {
                let name = file.display();
                let text = fs::read_to_string(file).map_err(|error| format!("{name}: {error}"))?;
                suite::read(&text).map_err(|error| format!("{name}: {error}"))?
            }
        };
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
            match case.fault(&claims, &question, &outcome) {
                Some(fault) => {
                    row.wrong += 1;
                    wrong.push((case, question, outcome, fault));
                }
                None if matches!(outcome, Outcome::Refused(_)) => row.refused += 1,
                None => row.right += 1,
            }
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
    let line = |kind: &str,
                Row {
                    right,
                    refused,
                    wrong,
                }: Row,
                skipped: u64| {
        let asked = right + refused + wrong;
        println!("{kind:<24} {asked:>7} {right:>7} {refused:>7} {wrong:>7} {skipped:>9}");
    };
    println!(
        "{:<24} {:>7} {:>7} {:>7} {:>7} {:>9}",
        "kind", "asked", "right", "refused", "wrong", "not asked"
    );
    let (mut all, mut not_asked) = (Row::default(), 0);
    for (kind, (row, skipped)) in kinds {
        // Of kinds that are none for the program the sum says enough.
        if row.right + row.refused + row.wrong > 0 {
            line(kind, *row, *skipped);
        }
        all.right += row.right;
        all.refused += row.refused;
        all.wrong += row.wrong;
        not_asked += skipped;
    }
    line("all", all, not_asked);
}
