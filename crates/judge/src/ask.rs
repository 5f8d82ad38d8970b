//! `ask`: one question, from a file, and what is wrong with the answer.

use std::fs;
use std::path::PathBuf;

use sweep_cdt_testing::judge::json;

use crate::claims::{ClaimArgs, ProgramArgs};

/// Asks the question of a file, as findings have it, and says what is wrong with the answer
#[derive(clap::Args)]
pub(crate) struct Ask {
    /// The question: a line of JSON
    question: PathBuf,
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
        let outcome = self.program.start()?.ask(&question);
        println!("{}", json::answer_line(&outcome));
        let fault = self.claims.claims().fault(&question, &outcome);
        match &fault {
            Some(fault) => println!("{}: {}", fault.name, fault.what),
            None => println!("right"),
        }
        Ok(fault.is_none())
    }
}
