//! `cases`: makes the suite of conformance. The same program makes the same bytes.
//!
//! A kind has a function that makes an input of random numbers, and says what must be special about it and what must
//! not. Of the inputs that are so, each once, the first ones are taken. The answers are the oracle's, by definition.

mod found;
mod inputs;
mod kind;
mod kinds;

use std::fs;
use std::path::PathBuf;

use sweep_cdt_testing::suite::{Case, header};

use found::found;
use kind::made;
use kinds::KINDS;

/// The licence of what is made here.
const OWN: &str = "MIT OR Apache-2.0";

/// Makes the suite of conformance and writes it to standard output; in a clone of the repository, of whose test data it
/// takes some
#[derive(clap::Args)]
pub(crate) struct Cases {
    /// Writes the cases to a file
    #[arg(long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl Cases {
    pub(crate) fn run(self) -> Result<bool, String> {
        let mut lines = Vec::new();
        for kind in KINDS {
            for (at, question) in made(kind).into_iter().enumerate() {
                let name = format!("{}/{at}", kind.name);
                let source = format!("made: {}", kind.about);
                lines.push(Case::new(name, question, source, OWN.to_owned()).line());
            }
        }
        for found in found() {
            lines.push(Case::new(found.name, found.question, found.source, found.licence).line());
        }
        let text = format!("{}\n{}\n", header(lines.len()), lines.join("\n"));
        match self.output {
            None => print!("{text}"),
            Some(file) => {
                fs::write(&file, text).map_err(|error| format!("{}: {error}", file.display()))?;
            }
        }
        Ok(true)
    }
}
