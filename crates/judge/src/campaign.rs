//! `campaign`: many questions, a table, and a folder for each finding.

use std::path::PathBuf;
use std::time::{Duration, Instant};

use sweep_cdt_testing::judge;

use crate::claims::{ClaimArgs, ProgramArgs};
use crate::findings;

/// Asks many questions within the program's claims, and makes those small whose answers are wrong
///
/// Each finding gets a folder with the question (question.json), the answer (answer.json), the right triangles
/// (right.json), and what is wrong (report.txt).
#[derive(clap::Args)]
pub(crate) struct Campaign {
    #[command(flatten)]
    claims: ClaimArgs,
    /// So many questions are asked
    #[arg(long, value_name = "N", default_value_t = 10_000)]
    executions: u64,
    /// Seed of the random questions
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// So many findings of each name are made small and kept
    #[arg(long, value_name = "N", default_value_t = 3)]
    keep: u64,
    /// The folder for findings; where there is one, a number is added
    #[arg(long, value_name = "FOLDER", default_value = "findings")]
    output: PathBuf,
    #[command(flatten)]
    program: ProgramArgs,
}

/// A line of progress is written so often.
const PAUSE: Duration = Duration::from_secs(2);

impl Campaign {
    pub(crate) fn run(self) -> Result<bool, String> {
        let claims = self.claims.claims();
        let mut program = self.program.start()?;
        program.greet(&claims)?;
        let campaign = judge::Campaign {
            claims,
            executions: self.executions,
            seed: self.seed,
            kept: self.keep,
        };
        let mut last = Instant::now();
        let summary = campaign.run(&mut |question| program.ask(question), &mut |summary| {
            if last.elapsed() > PAUSE {
                last = Instant::now();
                let wrong: u64 = summary.faults.values().sum();
                eprintln!(
                    "{} of {} questions, {wrong} wrong answers",
                    summary.executions, self.executions
                );
            }
        });
        println!("program: {}, {}", program.command(), program.version());
        println!("claims: {}", campaign.claims);
        println!("seed: {}\n", campaign.seed);
        print!("{summary}");
        if summary.findings.is_empty() {
            return Ok(summary.faults.is_empty());
        }
        let about = findings::About {
            program: program.command(),
            version: program.version().to_owned(),
            claims: campaign.claims.to_string(),
            seed: campaign.seed,
        };
        let folder = findings::write(&self.output, &about, &summary.findings).map_err(|error| {
            format!(
                "cannot write findings to {}: {error}",
                self.output.display()
            )
        })?;
        println!("\nfindings: {}", folder.display());
        Ok(false)
    }
}
