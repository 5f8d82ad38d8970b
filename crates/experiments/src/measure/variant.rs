//! A variant: one way to triangulate an input, which a cell compares with others by what it counts, by the
//! processor's time, and by a fingerprint of the result.

use std::error::Error;
use std::fmt;
use std::time::{Duration, Instant};

use sweep_cdt::{Algorithm, Heuristics, Stats, Triangulation, Triangulator, Watch};
use sweep_cdt_testing::counted::Counted;
use sweep_cdt_testing::runs::{Sample, convert};
use sweep_cdt_testing::{Input, counted, watched};

use super::row::{Row, Turn};
use super::watched::Watched;
use crate::contestant::Contestant;
use crate::fronts::Structure;

type Result<T> = std::result::Result<T, Box<dyn Error>>;
type Count = dyn Fn(&Input, &mut Row) -> Result<()>;
type Time = dyn Fn(&Input) -> Result<Turn>;

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
    /// The structure that counts, and the one that is timed; its time does not grow with the length of the front.
    pub(super) fn new(
        name: &str,
        count: impl Fn(&Input, &mut Row) -> Result<()> + 'static,
        time: impl Fn(&Input) -> Result<Turn> + 'static,
    ) -> Variant {
        Variant {
            name: name.to_owned(),
            is_linear: false,
            count: Box::new(count),
            time: Box::new(time),
        }
    }

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
        let variant = Variant::new(
            name,
            move |input, row| {
                let triangulator = Triangulator::new()
                    .algorithm(algorithm)
                    .heuristics(heuristics);
                let mut front = Watched::new(counted.front().clone());
                let run = watched(
                    &triangulator,
                    &input.points,
                    &input.edges,
                    Watch::new().front(&mut front),
                )?;
                row.see(front.seen);
                row.work(front.structure.work());
                take_over(&run, row);
                Ok(())
            },
            move |input| timed(|| Ok(runs.run(input, algorithm, heuristics)?)),
        );
        Variant {
            is_linear: contestant.is_linear(),
            ..variant
        }
    }

    /// A scalar that can hold the coordinates, with the default structure.
    pub(crate) fn scalar<S: Sample + 'static>(name: &str) -> Variant {
        let points =
            |input: &Input| convert::<S>(&input.points).expect("the scalar holds the coordinates");
        let run =
            |points: &[[S; 2]], input: &Input| counted(&Triangulator::new(), points, &input.edges);
        Variant::new(
            name,
            move |input, row| {
                take_over(&run(&points(input), input)?, row);
                Ok(())
            },
            move |input| {
                let points = points(input);
                timed(|| Ok(run(&points, input)?.stats))
            },
        )
    }

    /// Triangulates once, and writes all counts into the row.
    pub(super) fn count(&self, input: &Input, row: &mut Row) -> Result<()> {
        (self.count)(input, row)
    }

    /// Triangulates once, for the times.
    pub(crate) fn time(&self, input: &Input) -> Result<Turn> {
        (self.time)(input)
    }
}

/// A turn: a run with the time that it took.
fn timed(run: impl FnOnce() -> Result<Stats>) -> Result<Turn> {
    let (clock, start) = (Instant::now(), processor());
    let stats = run()?;
    let taken = processor().zip(start).map(|(end, start)| end - start);
    let ms = |time: Duration| (1e7 * time.as_secs_f64()).round() / 1e4;
    Ok(Turn {
        initialization_ms: ms(stats.initialization),
        sweeping_ms: ms(stats.sweeping),
        finalization_ms: ms(stats.finalization),
        clock_ms: ms(clock.elapsed()),
        processor_ms: taken.map(ms),
        ..Turn::default()
    })
}

fn take_over(run: &Counted, row: &mut Row) {
    row.count(&run.stats);
    row.result = format!("{:016x}", fingerprint(&run.triangulation));
}

/// The processor's time of this thread so far; `None` where the system does not tell. Unlike the time on the
/// clock it does not count what other programs take of a shared machine.
#[cfg(unix)]
fn processor() -> Option<Duration> {
    use rustix::time::{ClockId, clock_gettime};

    Duration::try_from(clock_gettime(ClockId::ThreadCPUTime)).ok()
}

/// The processor's time of this thread so far; `None` where the system does not tell.
#[cfg(not(unix))]
fn processor() -> Option<Duration> {
    None
}

/// A number that tells results apart: equal for equal sets of triangles, in whatever order they are listed. It
/// is the sum over the triangles of a hash of their vertices, the smallest first.
fn fingerprint(result: &Triangulation) -> u64 {
    let hash = |triangle: [usize; 3]| {
        let smallest = (0..3).min_by_key(|&i| triangle[i]).expect("three");
        (0..3).fold(0, |hash: u64, i| {
            let vertex = triangle[(smallest + i) % 3] as u64 + 1;
            let hash = (hash ^ vertex).wrapping_mul(0x9e37_79b9_7f4a_7c15);
            hash ^ (hash >> 29)
        })
    };
    result
        .triangles()
        .fold(0, |sum, triangle| sum.wrapping_add(hash(triangle)))
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
            time: Box::new(|_| Ok(Turn::default())),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::fingerprint;

    #[test]
    fn results_differ_and_orders_do_not() {
        let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]];
        let of = |edges: &[[usize; 2]]| {
            fingerprint(&sweep_cdt::triangulate(&square, edges).expect("no edges cross"))
        };
        assert_eq!(of(&[[0, 2]]), of(&[[2, 0], [0, 1]]));
        assert_ne!(of(&[[0, 2]]), of(&[[1, 3]]));
    }

    #[cfg(unix)]
    #[test]
    fn sleep_is_not_counted_and_work_is() {
        use std::thread::sleep;
        use std::time::Duration;

        use super::processor;

        let now = || processor().expect("a clock");
        let start = now();
        sleep(Duration::from_millis(50));
        assert!(now() - start < Duration::from_millis(25));
        while now() - start < Duration::from_millis(30) {}
    }
}
