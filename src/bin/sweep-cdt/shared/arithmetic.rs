//! The arithmetic of a run.

use clap::ValueEnum;
use sweep_cdt::formats::{Coordinate, Graph, Input, exact};
use sweep_cdt::{Error, Scalar};

use super::failure::Failure;

/// Arguments that select the arithmetic.
#[derive(clap::Args)]
pub(crate) struct ScalarArgs {
    /// Arithmetic; by default rational where the input has fractions, else f64
    ///
    /// Both are exact. In an input with a fraction (`p/q`) all numbers are taken as written: 0.1 is
    /// one tenth. In any other input each number is the double nearest to it, for both kinds of
    /// arithmetic, so that they give the same triangles. f64 refuses fractions.
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

/// What is done with an input, in whatever arithmetic.
pub(crate) trait Job {
    /// Does it: `points` are those of `graph` in the arithmetic of this name.
    fn run<S: Coordinate, T: Scalar + Sync>(
        self,
        graph: &Graph<S>,
        points: &[[T; 2]],
        scalar: &'static str,
    ) -> Result<(), Failure>;
}

impl ScalarArgs {
    /// Does a job with the input of this name.
    pub(crate) fn apply(&self, name: &str, input: &Input, job: impl Job) -> Result<(), Failure> {
        let rational = matches!(self.scalar, Some(Kind::Rational));
        match input {
            Input::Doubles(graph) => {
                refuse_non_finite(name, graph)?;
                if rational {
                    job.run(graph, &exact_points(&graph.points), "rational")
                } else {
                    job.run(graph, &graph.points, "f64")
                }
            }
            Input::Rationals(_) if matches!(self.scalar, Some(Kind::F64)) => Err(Failure::Error(
                format!("{name}: has fractions, which --scalar f64 refuses"),
            )),
            Input::Rationals(graph) => job.run(graph, &graph.points, "rational"),
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

/// The exact values of doubles.
fn exact_points(points: &[[f64; 2]]) -> Vec<[sweep_cdt::formats::Rational; 2]> {
    let value = |x| exact(x).expect("others were refused");
    points.iter().map(|point| point.map(value)).collect()
}
