//! A variant: one way to triangulate an input, which a cell compares with others.

use std::fmt;

use sweep_cdt::{Algorithm, Error, Heuristics, Run, Stats, Triangulator};
use sweep_cdt_testing::Input;
use sweep_cdt_testing::runs::{Sample, convert};

use super::clock::processor;
use super::fingerprint::fingerprint;
use super::row::{Row, Timed};
use crate::contestant::Contestant;
use crate::fronts::{Structure, Watched};

type Count = dyn Fn(&Input, &mut Row) -> Result<(), Error>;
type Time = dyn Fn(&Input) -> Result<Timed, Error>;

/// One way to triangulate.
pub(crate) struct Variant {
    pub(crate) name: String,
    /// Whether its time grows with points times the length of the front.
    pub(crate) is_linear: bool,
    count: Box<Count>,
    time: Box<Time>,
}

impl fmt::Debug for Variant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Variant").field(&self.name).finish()
    }
}

impl Variant {
    /// A structure, with the default algorithm and heuristics.
    pub(crate) fn structure(contestant: &Contestant) -> Variant {
        Variant::sweep(
            contestant.name(),
            contestant,
            Algorithm::default(),
            Heuristics::default(),
        )
    }

    /// A structure, an algorithm and a setting of the heuristics.
    pub(crate) fn sweep(
        name: &str,
        contestant: &Contestant,
        algorithm: Algorithm,
        heuristics: Heuristics,
    ) -> Variant {
        let (counted, runs) = (contestant.clone(), contestant.clone());
        Variant {
            name: name.to_owned(),
            is_linear: contestant.is_linear(),
            count: Box::new(move |input, row| {
                let run = Triangulator::new()
                    .front(Watched::new(counted.front().clone()))
                    .algorithm(algorithm)
                    .heuristics(heuristics)
                    .triangulate_with_stats(&input.points, &input.edges)?;
                row.see(run.front.seen);
                row.work(run.front.structure.work());
                take_over(&run, row);
                Ok(())
            }),
            time: Box::new(move |input| timed(|| runs.run(input, algorithm, heuristics))),
        }
    }

    /// A scalar that can hold the coordinates, with the default structure.
    pub(crate) fn scalar<S: Sample + 'static>(name: &str) -> Variant {
        let points =
            |input: &Input| convert::<S>(&input.points).expect("the scalar holds the coordinates");
        let run = |points: &[[S; 2]], input: &Input| {
            Triangulator::new().triangulate_with_stats(points, &input.edges)
        };
        Variant {
            name: name.to_owned(),
            is_linear: false,
            count: Box::new(move |input, row| {
                take_over(&run(&points(input), input)?, row);
                Ok(())
            }),
            time: Box::new(move |input| {
                let points = points(input);
                timed(|| Ok(run(&points, input)?.stats))
            }),
        }
    }

    /// Triangulates once, and writes all counts into the row.
    pub(super) fn count(&self, input: &Input, row: &mut Row) -> Result<(), Error> {
        (self.count)(input, row)
    }

    /// Triangulates once, for the times.
    pub(super) fn time(&self, input: &Input) -> Result<Timed, Error> {
        (self.time)(input)
    }
}

/// A run with the processor's time that it took.
fn timed(run: impl FnOnce() -> Result<Stats, Error>) -> Result<Timed, Error> {
    let start = processor();
    let stats = run()?;
    let taken = processor().zip(start).map(|(end, start)| end - start);
    Ok(Timed {
        stats,
        processor: taken,
    })
}

fn take_over<F>(run: &Run<F>, row: &mut Row) {
    row.count(&run.stats);
    row.result = format!("{:016x}", fingerprint(&run.triangulation));
}

#[cfg(test)]
impl Variant {
    /// One that says it has found this result, on a front of this mean length.
    pub(super) fn pretended(result: &'static str, front_mean: f64, is_linear: bool) -> Variant {
        Variant {
            name: result.to_owned(),
            is_linear,
            count: Box::new(move |_, row| {
                row.points = 1_000_000;
                row.front_mean = front_mean;
                row.result = result.to_owned();
                Ok(())
            }),
            time: Box::new(|_| Ok(Timed::default())),
        }
    }
}
