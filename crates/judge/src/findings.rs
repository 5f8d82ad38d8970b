//! Findings as files: a folder for each, to be read by people and to be asked again.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use sweep_cdt_testing::Input;
use sweep_cdt_testing::judge::{Finding, Wrong, json};

/// What all findings of a campaign have in common.
pub(crate) struct About {
    pub(crate) program: String,
    pub(crate) version: String,
    pub(crate) claims: String,
    pub(crate) seed: u64,
}

/// Writes a folder for each finding; the folder of all is returned.
pub(crate) fn write(output: &Path, about: &About, findings: &[Finding]) -> io::Result<PathBuf> {
    let folder = made(output)?;
    for finding in findings {
        let Wrong {
            question,
            outcome,
            fault,
        } = &finding.least;
        let own = folder.join(format!("{}-{}", fault.name, finding.execution));
        fs::create_dir_all(&own)?;
        let file = |name: &str, text: String| fs::write(own.join(name), text + "\n");
        file("question.json", json::question_line(question))?;
        file("first_question.json", json::question_line(&finding.first))?;
        file("answer.json", json::answer_line(outcome))?;
        if let Some(right) = &finding.right {
            file("right.json", json::answer_line(&Ok(right.clone()).into()))?;
        }
        file("report.txt", report(about, finding))?;
    }
    Ok(folder)
}

/// A folder of this name, or of this name with a number, that is not there yet.
fn made(output: &Path) -> io::Result<PathBuf> {
    let mut number = 1;
    loop {
        let mut name = output.as_os_str().to_owned();
        if number > 1 {
            name.push(format!("-{number}"));
        }
        let folder = PathBuf::from(name);
        if let Some(parent) = folder.parent() {
            fs::create_dir_all(parent)?;
        }
        match fs::create_dir(&folder) {
            Ok(()) => return Ok(folder),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => number += 1,
            Err(error) => return Err(error),
        }
    }
}

fn report(about: &About, finding: &Finding) -> String {
    let About {
        program,
        version,
        claims,
        seed,
    } = about;
    let Wrong {
        question, fault, ..
    } = &finding.least;
    let row = Input {
        points: question.points.clone(),
        edges: question.all_edges(),
    };
    format!(
        "{}: {}\n\nprogram: {program}, {version}\nclaims: {claims}\nseed {seed}, question {}\n\n\
         Ask again: sweep-cdt-judge ask question.json {claims} -- {program}\n\n\
         Points and all edges, as a row of tests/library/cases/table.rs:\n{row}",
        fault.name, fault.what, finding.execution
    )
}
