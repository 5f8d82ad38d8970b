//! `ask`: one question, from a file, and what is wrong with the answers.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use sweep_cdt_testing::judge::json;

use crate::claims::{ClaimArgs, ProgramArgs};

/// Asks the question of a file, as findings have it, and says what is wrong with the answer
#[derive(clap::Args)]
pub(crate) struct Ask {
    /// The question: a line of JSON
    question: PathBuf,
    /// Ask so many times, and start the program anew each time: for a program that decides by chance
    #[arg(long, value_name = "TIMES", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..))]
    repeat: u32,
    #[command(flatten)]
    claims: ClaimArgs,
    #[command(flatten)]
    program: ProgramArgs,
}

impl Ask {
    pub(crate) fn run(self) -> Result<bool, String> {
        let name = self.question.display();
        let text =
            fs::read_to_string(&self.question).map_err(|error| format!("{name}: {error}"))?;
        let value = serde_json::from_str(&text).map_err(|error| format!("{name}: {error}"))?;
        let question = json::read_question(&value).map_err(|error| format!("{name}: {error}"))?;
        let claims = self.claims.claims();
        // How often each answer came, and what is wrong with it.
        let mut answers = BTreeMap::new();
        for _ in 0..self.repeat {
            let outcome = self.program.start()?.ask(&question);
            let answer = answers.entry(json::answer_line(&outcome).to_string());
            answer
                .or_insert_with(|| (0, claims.fault(&question, &outcome)))
                .0 += 1;
        }
        for (line, (times, fault)) in &answers {
            println!("{line}");
            if self.repeat > 1 {
                print!("{times} of {}: ", self.repeat);
            }
            match fault {
                Some(fault) => println!("{}: {}", fault.name, fault.what),
                None => println!("right"),
            }
        }
        Ok(answers.values().all(|(_, fault)| fault.is_none()))
    }
}
