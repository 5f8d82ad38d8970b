//! All programs on one data set, in turn and each in a process, the judgement of their answers, and what
//! follows from it.

use std::io::{Read, Seek};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use sweep_cdt::verify::{Verifier, Violation};
use sweep_cdt_testing::{Input, binary};

use crate::data::{Aim, DataSet, Kind, Of};
use crate::programs::{OURS, OURS_INSIDE, OURS_KEPT, Program};

/// How it is measured.
pub(crate) struct Settings<'a> {
    pub(crate) rounds: usize,
    /// How often a process triangulates a data set.
    pub(crate) calls: usize,
    /// How long a process may take.
    pub(crate) limit: Duration,
    /// For the files that the processes exchange.
    pub(crate) folder: &'a Path,
}

/// A data set and the measurements of all programs that take it.
pub(crate) struct Row {
    pub(crate) name: String,
    pub(crate) family: String,
    pub(crate) kind: Kind,
    /// Points and edges of one input.
    pub(crate) size: [usize; 2],
    pub(crate) inputs: usize,
    pub(crate) cells: Vec<Cell>,
    pub(crate) aim: Option<Aim>,
}

/// The measurements of one program on one data set.
pub(crate) struct Cell {
    pub(crate) program: &'static str,
    pub(crate) is_exact: bool,
    pub(crate) outcome: Result<Outcome, Failure>,
}

/// Which calls of the processes count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Calls {
    /// The first ones, which get their memory from the system.
    First,
    /// The last ones, which may have memory that earlier ones had; this crate keeps it in a `Session`.
    Last,
}

/// The time and memory of a program for a point.
#[derive(Clone, Copy)]
pub(crate) struct Outcome {
    pub(crate) verdict: Verdict,
    first: Time,
    last: Time,
    /// Bytes beyond the input in first calls, the median.
    pub(crate) bytes: Option<f64>,
}

/// Nanoseconds: median, least and most.
pub(crate) type Time = [f64; 3];

impl Outcome {
    pub(crate) fn time(&self, calls: Calls) -> Time {
        match calls {
            Calls::First => self.first,
            Calls::Last => self.last,
        }
    }
}

/// Runs all programs in turn, as often as there are rounds.
pub(crate) fn row(set: DataSet, programs: &[Program], settings: &Settings) -> Row {
    let input = settings.folder.join("input");
    let answer = settings.folder.join("answer");
    let (inputs, points) = (set.inputs.len(), set.points());
    binary::write_inputs(&input, &set.inputs).expect("a file for the data set");
    let programs: Vec<&Program> = programs
        .iter()
        .filter(|program| program.kinds.contains(&set.kind))
        .collect();

    let mut verdicts = Vec::new();
    let mut samples: Vec<Result<Vec<Sample>, Failure>> = vec![Ok(Vec::new()); programs.len()];
    for round in 0..settings.rounds {
        for (program, samples) in programs.iter().zip(&mut samples) {
            let answer = (round == 0).then_some(answer.as_path());
            // One that has failed is not asked again.
            if let Ok(list) = samples {
                let lines = run(&program.command, &input, answer, settings);
                match lines.and_then(|lines| sample(&lines, inputs).ok_or(Failure::Crash)) {
                    Ok(sample) => list.push(sample),
                    Err(failure) => *samples = Err(failure),
                }
            }
            if let Some(answer) = answer {
                let is_inside = program.is_inside && set.kind == Kind::Polygons;
                let verdict = |_| {
                    let triangles = binary::read_answer(answer, inputs);
                    judge(&set.inputs, &triangles.expect("an answer"), is_inside)
                };
                verdicts.push(samples.as_ref().ok().map(verdict));
            }
        }
    }
    let cells = programs.iter().zip(samples).zip(verdicts);
    let cells = cells.map(|((program, samples), verdict)| Cell {
        program: program.name,
        is_exact: program.is_exact,
        outcome: samples.map(|samples| {
            let verdict = verdict.expect("an answer of the first round");
            outcome(&samples, verdict, points, inputs)
        }),
    });
    Row {
        cells: cells.collect(),
        size: [points / inputs, set.edges() / inputs],
        inputs,
        name: set.name,
        family: set.family,
        kind: set.kind,
        aim: set.aim,
    }
}

/// The time for a point, and the memory where there is one input: small ones say nothing of it.
fn outcome(samples: &[Sample], verdict: Verdict, points: usize, inputs: usize) -> Outcome {
    let sorted = |numbers: &mut dyn Iterator<Item = f64>| {
        let mut numbers: Vec<f64> = numbers.map(|number| number / points as f64).collect();
        numbers.sort_by(f64::total_cmp);
        numbers
    };
    let time = |of: &dyn Fn(&Sample) -> f64| {
        let times = sorted(&mut samples.iter().map(of));
        [times[times.len() / 2], times[0], times[times.len() - 1]]
    };
    let bytes = sorted(&mut samples.iter().filter_map(|sample| sample.bytes));
    Outcome {
        verdict,
        first: time(&|sample| sample.first),
        last: time(&|sample| sample.last),
        bytes: bytes.get(bytes.len() / 2).copied().filter(|_| inputs == 1),
    }
}

impl Row {
    /// The outcome of a program, if its answer is the constrained Delaunay triangulation.
    pub(crate) fn right(&self, program: &str) -> Option<Outcome> {
        self.rights()
            .find(|(cell, _)| cell.program == program)
            .map(|(_, outcome)| outcome)
    }

    /// The measurement of this crate: of polygons the inside alone; otherwise in memory that is kept where there are many
    /// inputs or last calls count.
    pub(crate) fn ours(&self, calls: Calls) -> Option<&Cell> {
        let is_kept = self.inputs > 1 || calls == Calls::Last;
        let name = match (self.kind, is_kept) {
            (Kind::Polygons, _) => OURS_INSIDE,
            (_, true) => OURS_KEPT,
            (_, false) => OURS,
        };
        self.cells.iter().find(|cell| cell.program == name)
    }

    /// The programs with right answers.
    fn rights(&self) -> impl Iterator<Item = (&Cell, Outcome)> {
        let rights = self
            .cells
            .iter()
            .filter_map(|cell| Some((cell, cell.outcome.ok()?)));
        rights.filter(|(_, outcome)| outcome.verdict == Verdict::Delaunay)
    }

    /// The fastest other program with a right answer; exact ones only if that is wanted.
    pub(crate) fn best(&self, is_exact: bool, calls: Calls) -> Option<(&Cell, Outcome)> {
        self.rights()
            .filter(|(cell, _)| !is_ours(cell) && (cell.is_exact || !is_exact))
            .min_by(|(_, a), (_, b)| a.time(calls)[0].total_cmp(&b.time(calls)[0]))
    }

    /// The time that this crate should need.
    pub(crate) fn aim(&self, calls: Calls) -> Option<f64> {
        let aim = self.aim?;
        let other = match aim.of {
            Of::Program(name) => self.right(name)?,
            Of::Exact => self.best(true, calls)?.1,
        };
        Some(aim.share * other.time(calls)[0])
    }
}

/// Whether a cell is one of this crate.
fn is_ours(cell: &Cell) -> bool {
    [OURS, OURS_KEPT, OURS_INSIDE].contains(&cell.program)
}

/// An answer, as the verifier judges it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Verdict {
    /// The constrained Delaunay triangulation of the input.
    Delaunay,
    /// A triangulation with all edges whose other sides are not all Delaunay.
    Triangulation,
    /// Neither.
    Wrong,
}

/// The worst verdict on the answers to these inputs. `is_inside`: they cover the polygon that the points
/// bound in their order, and not the hull.
fn judge(inputs: &[Input], answers: &[Vec<[usize; 3]>], is_inside: bool) -> Verdict {
    let verdicts = inputs
        .iter()
        .zip(answers)
        .map(|(input, triangles)| judge_one(input, triangles, is_inside));
    verdicts.max().expect("an input")
}

fn judge_one(input: &Input, triangles: &[[usize; 3]], is_inside: bool) -> Verdict {
    let ring = [(0..input.points.len()).collect()];
    let verifier = Verifier::new().accept_clockwise(true).limit(usize::MAX);
    let verifier = if is_inside {
        verifier.boundary(&ring)
    } else {
        verifier
    };
    match verifier.verify_parallel(&input.points, &input.edges, triangles) {
        Ok(_) => Verdict::Delaunay,
        Err(violations) => {
            let is_delaunay = |violation| matches!(violation, &Violation::NotDelaunay { .. });
            if violations.list.iter().all(is_delaunay) {
                Verdict::Triangulation
            } else {
                Verdict::Wrong
            }
        }
    }
}

/// The output of a process: nanoseconds of the first and of the last call, for all inputs together, and bytes beyond
/// the first one.
#[derive(Clone, Copy, Debug)]
struct Sample {
    first: f64,
    last: f64,
    bytes: Option<f64>,
}

/// Why there is no sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Failure {
    /// The process ended in any other way than by printing its time.
    Crash,
    /// The process was stopped.
    TooLong,
}

/// The output of a command that runs on a data set in a process, with a file for the answer if it is wanted.
fn run(
    command: &[String],
    input: &Path,
    answer: Option<&Path>,
    settings: &Settings,
) -> Result<String, Failure> {
    // A file takes any number of lines; a pipe that nobody reads does not.
    let mut printed = tempfile::tempfile().expect("a file for what is printed");
    let stdout = printed.try_clone().expect("the same file");
    let mut child = Command::new(&command[0])
        .args(&command[1..])
        .arg(input)
        .arg(settings.calls.to_string())
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
        if start.elapsed() > settings.limit {
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
    if status.success() {
        Ok(text)
    } else {
        Err(Failure::Crash)
    }
}

/// The sample in these lines: so many inputs, once or more often, each with nanoseconds and perhaps bytes.
fn sample(lines: &str, inputs: usize) -> Option<Sample> {
    let mut bytes = None;
    let mut times = Vec::new();
    for line in lines.lines() {
        let mut words = line.split_whitespace().map(str::parse::<f64>);
        times.push(words.next()?.ok()?);
        bytes = bytes.or_else(|| words.next()?.ok());
    }
    let last = times.len().checked_sub(inputs)?;
    Some(Sample {
        first: times[..inputs].iter().sum(),
        last: times[last..].iter().sum(),
        bytes,
    })
}
