//! The table of runs: every scalar with every front and every setting of the heuristics, and every scalar
//! with the other algorithms, in bands, and in memory that all inputs before it have used.
//!
//! A new front is a variant of [`AnyFront`], a new scalar one line in [`all`] and a [`Sample`] that says how
//! it is made of a double.

use std::cell::RefCell;

#[cfg(feature = "runs")]
use num_bigint::BigInt;
#[cfg(feature = "runs")]
use num_rational::{BigRational, Ratio};
use sweep_cdt::{Algorithm, Error, Heuristics, Session, Triangulator, Tuning};
#[cfg(feature = "runs")]
use sweep_cdt_generate::Random;

use crate::Input;
use crate::any_front::AnyFront;
use crate::fronts::{Choice, triangulate};
use crate::oracle::{Answer, Verdict, found};
pub use crate::samples::{Archetype, Sample, convert};
#[cfg(feature = "runs")]
use crate::streams::{Streaming, banded, streamed};
use crate::tuned::is_small;

/// The outcome of a run.
pub type Outcome = Result<Answer, Error>;
type Call = fn(&Input, &Choice) -> Option<Outcome>;

/// One way to triangulate.
#[derive(Clone, Debug)]
pub struct Run {
    /// Scalar, front and heuristics, or scalar and algorithm, bands or memory.
    pub name: String,
    choice: Choice,
    call: Call,
}

impl Run {
    /// The outcome, or `None` if the scalar cannot hold a coordinate.
    pub fn outcome(&self, input: &Input) -> Option<Outcome> {
        (self.call)(input, &self.choice)
    }
}

const HEURISTICS: &[(&str, Heuristics)] = &[
    ("fast", Heuristics::FAST),
    ("paper", Heuristics::PAPER),
    ("off", Heuristics::OFF),
];

/// The algorithms beside the sweep, with their names.
pub const ALGORITHMS: &[(&str, Algorithm)] = &[
    ("divide and conquer", Algorithm::DivideAndConquer),
    ("the paper's order", Algorithm::Paper),
    #[cfg(feature = "comparison")]
    ("incremental", Algorithm::Incremental),
    #[cfg(feature = "comparison")]
    ("fortune", Algorithm::Fortune),
    #[cfg(feature = "comparison")]
    ("sweep of 2005", Algorithm::Sweep2005),
];

/// All runs; the first is the one that callers get who choose nothing.
///
/// The compiler makes the conversions and predicates of nine scalars here, so this is a feature.
#[cfg(feature = "runs")]
pub fn all() -> Vec<Run> {
    let mut runs = with::<f64>("f64");
    runs.extend(with::<f32>("f32"));
    runs.extend(with::<i32>("i32"));
    runs.extend(with::<i64>("i64"));
    runs.extend(with::<i128>("i128"));
    runs.extend(with::<Ratio<i64>>("Ratio<i64>"));
    runs.extend(with::<BigInt>("BigInt"));
    runs.extend(with::<BigRational>("BigRational"));
    runs.extend(with::<Archetype>("archetype"));
    runs.extend(in_windows());
    runs
}

/// The runs of streams: scalars that can be cloned, with windows of several sizes, and with bands that are joined.
#[cfg(feature = "runs")]
fn in_windows() -> Vec<Run> {
    let mut runs = windows_of::<f64>("f64");
    runs.extend(windows_of::<f32>("f32"));
    runs.extend(windows_of::<i32>("i32"));
    runs.extend(windows_of::<i64>("i64"));
    runs.extend(windows_of::<i128>("i128"));
    runs.extend(windows_of::<Ratio<i64>>("Ratio<i64>"));
    runs.extend(windows_of::<BigInt>("BigInt"));
    runs.extend(windows_of::<BigRational>("BigRational"));
    runs
}

#[cfg(feature = "runs")]
fn windows_of<S: Sample + Clone>(scalar: &str) -> Vec<Run> {
    let mut runs = Vec::new();
    for window in [1, 2, 7] {
        runs.push(Run {
            name: format!("bands of {scalar}, of {window}, joined"),
            choice: Choice {
                window,
                ..Choice::default()
            },
            call: |input, choice| {
                let random = &mut Random::new(input.points.len() as u64);
                banded::<S>(input, choice.window, random, |rest| rest)
            },
        });
    }
    for (front, window) in AnyFront::all().into_iter().zip(WINDOWS.into_iter().cycle()) {
        runs.push(Run {
            name: format!("stream of {scalar}, {}, windows of {window}", front.name()),
            choice: Choice {
                front,
                window,
                ..Choice::default()
            },
            call: call_in_windows::<S>,
        });
    }
    runs
}

/// So many new vertices a window of a stream has.
#[cfg(feature = "runs")]
const WINDOWS: [usize; 4] = [1, 2, 7, 1000];

#[cfg(feature = "runs")]
fn call_in_windows<S: Sample + Clone>(input: &Input, choice: &Choice) -> Option<Outcome> {
    let way = Streaming {
        window: choice.window,
        is_range_known: input.points.len().is_multiple_of(2),
        front: choice.front.clone(),
    };
    streamed::<S>(input, &way)
}

/// The runs with one scalar.
pub fn with<S: Sample>(scalar: &str) -> Vec<Run> {
    let mut runs = Vec::new();
    for front in AnyFront::all() {
        for &(setting, heuristics) in HEURISTICS {
            runs.push(Run {
                name: format!("{scalar}, {}, {setting}", front.name()),
                choice: Choice {
                    front: front.clone(),
                    heuristics,
                    ..Choice::default()
                },
                call: call::<S>,
            });
        }
    }
    for &(name, algorithm) in ALGORITHMS {
        runs.push(Run {
            name: format!("{scalar}, {name}"),
            choice: Choice {
                algorithm,
                ..Choice::default()
            },
            call: call::<S>,
        });
    }
    #[cfg(feature = "comparison")]
    {
        let mut obtuse = Heuristics::PAPER;
        obtuse.corners = sweep_cdt::Corners::AllUpTo(8);
        runs.push(Run {
            name: format!("{scalar}, obtuse corners"),
            choice: Choice {
                heuristics: obtuse,
                ..Choice::default()
            },
            call: call::<S>,
        });
    }
    runs.push(Run {
        name: format!("{scalar}, memory kept"),
        choice: Choice::default(),
        call: call_in_kept_memory::<S>,
    });
    #[cfg(feature = "parallel")]
    for bands in 2..=5 {
        runs.push(Run {
            name: format!("{scalar}, {bands} bands"),
            choice: Choice {
                bands,
                ..Choice::default()
            },
            call: call::<S>,
        });
    }
    runs
}

fn call<S: Sample>(input: &Input, choice: &Choice) -> Option<Outcome> {
    let points = convert::<S>(&input.points)?;
    let result = triangulate(&points, &input.edges, choice);
    Some(result.map(|result| found(&result, points.len(), input.edges.len())))
}

thread_local! {
    /// The memory that runs of this thread keep, whatever their scalar, for each set of thresholds.
    static SESSIONS: RefCell<[Session; 2]> = RefCell::new(
        [&Tuning::REAL, &Tuning::SMALL].map(|tuning| Triangulator::new().tuning(tuning).session())
    );
}

fn call_in_kept_memory<S: Sample>(input: &Input, _: &Choice) -> Option<Outcome> {
    let points = convert::<S>(&input.points)?;
    let set = usize::from(is_small(&points, &input.edges));
    Some(SESSIONS.with_borrow_mut(|sessions| {
        let result = sessions[set].triangulate(&points, &input.edges)?;
        Ok(found(result, points.len(), input.edges.len()))
    }))
}

/// Panics unless every run returns what the verdict says.
pub fn assert_agree(input: &Input, verdict: &Verdict, runs: &[Run]) {
    for run in runs {
        let Some(outcome) = run.outcome(input) else {
            continue;
        };
        match (verdict, &outcome) {
            (Ok(expected), Ok(answer)) => {
                assert_eq!(answer, expected, "{} (right: oracle)", run.name);
            }
            (Err(crossings), Err(Error::CrossingEdges { edges })) => assert!(
                crossings.contains(edges),
                "{}: {edges:?} are said to cross, but only {crossings:?} do",
                run.name
            ),
            _ => panic!("{}: {outcome:?}, but the oracle says {verdict:?}", run.name),
        }
    }
}
