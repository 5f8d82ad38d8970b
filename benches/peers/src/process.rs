//! One process of one program on one data set.

use std::io::{Read, Seek};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// What a process printed: nanoseconds for all inputs together, and bytes beyond the first one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sample {
    pub(crate) nanoseconds: f64,
    pub(crate) bytes: Option<f64>,
}

/// Why there is no sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Failure {
    /// It ended in any other way than by printing its time.
    Crash,
    /// It was stopped.
    TooLong,
}

/// Runs a command on a data set, with a file for the answer if it is wanted.
pub(crate) fn run(
    command: &[String],
    input: &Path,
    answer: Option<&Path>,
    limit: Duration,
) -> Result<Sample, Failure> {
    // A file takes any number of lines; a pipe that nobody reads does not.
    let mut printed = tempfile::tempfile().expect("a file for what is printed");
    let stdout = printed.try_clone().expect("the same file");
    let mut child = Command::new(&command[0])
        .args(&command[1..])
        .arg(input)
        .args(answer)
        .stdin(Stdio::null())
        .stdout(stdout)
        .stderr(Stdio::null())
        .spawn()
        .map_err(|_| Failure::Crash)?;
    let start = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait().expect("a process") {
            break status;
        }
        if start.elapsed() > limit {
            child.kill().expect("a process");
            child.wait().expect("a process");
            return Err(Failure::TooLong);
        }
        std::thread::sleep(Duration::from_millis(2));
    };
    let mut text = String::new();
    printed.rewind().expect("a file");
    if printed.read_to_string(&mut text).is_err() {
        return Err(Failure::Crash);
    }
    match (status.success(), sample(&text)) {
        (true, Some(sample)) => Ok(sample),
        _ => Err(Failure::Crash),
    }
}

/// Nanoseconds and bytes of each line: the sum of the former and the first of the latter.
fn sample(text: &str) -> Option<Sample> {
    let mut sample = Sample {
        nanoseconds: 0.0,
        bytes: None,
    };
    for (i, line) in text.lines().enumerate() {
        let mut words = line.split_whitespace().map(str::parse::<f64>);
        sample.nanoseconds += words.next()?.ok()?;
        if i == 0 {
            sample.bytes = words.next().and_then(Result::ok);
        }
    }
    (sample.nanoseconds > 0.0).then_some(sample)
}
