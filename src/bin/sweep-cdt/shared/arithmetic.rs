//! The arithmetic of a run.

use clap::ValueEnum;
use sweep_cdt::Error;
use sweep_cdt::formats::{Coordinate, Graph, Input};
use sweep_cdt::scalar::Scalar;

use super::failure::Failure;
use super::rationals::{self, exact};

/// Arguments that select the arithmetic.
#[derive(clap::Args)]
pub(crate) struct ScalarArgs {
    /// Arithmetic [default: rational if the input has fractions, otherwise f64]
    ///
    /// Both are exact and give the same triangles. If the input has a fraction (`p/q`), every number
    /// means what it says: 0.1 is one tenth. Otherwise every number is read as the nearest double. f64
    /// refuses fractions.
    #[arg(long, value_enum)]
    scalar: Option<Kind>,
}

#[derive(Clone, Copy, ValueEnum)]
enum Kind {
    /// Doubles
    F64,
    /// Fractions of whole numbers of any size; slower
    Rational,
}

/// What a subcommand does with its input, in any arithmetic.
pub(crate) trait Job {
    /// Does it. `points` are those of `graph`, in the arithmetic called `scalar`.
    fn run<S: Coordinate, T: Scalar + Sync>(
        self,
        graph: &Graph<S>,
        points: &[[T; 2]],
        scalar: &'static str,
    ) -> Result<(), Failure>;
}

impl ScalarArgs {
    /// Does a job with the input called `name`.
    pub(crate) fn apply(&self, name: &str, input: &Input, job: impl Job) -> Result<(), Failure> {
        let rational = matches!(self.scalar, Some(Kind::Rational));
        match input {
            Input::Doubles(graph) => {
                refuse_non_finite(name, graph)?;
                if rational {
                    let points: Vec<_> = graph.points.iter().map(|p| p.map(exact)).collect();
                    job.run(graph, &points, "rational")
                } else {
                    job.run(graph, &graph.points, "f64")
                }
            }
            Input::Rationals(_) if matches!(self.scalar, Some(Kind::F64)) => Err(Failure::Error(
                format!("{name}: has fractions, which --scalar f64 refuses"),
            )),
            Input::Rationals(graph) => {
                job.run(graph, &rationals::points(&graph.points), "rational")
            }
        }
    }
}

fn refuse_non_finite(name: &str, graph: &Graph<f64>) -> Result<(), Failure> {
    let is_finite = |point: &[f64; 2]| point.iter().all(|x| x.is_finite());
    match graph.points.iter().position(|point| !is_finite(point)) {
        None => Ok(()),
        Some(vertex) => {
            let error = graph.as_numbered(Error::NonFiniteCoordinate { vertex });
            Err(Failure::Error(format!("{name}: {error}")))
        }
    }
}
