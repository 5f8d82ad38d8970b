//! The arithmetic of a run. Rationals are GMP's with the feature `rug`, pure Rust ones otherwise; files are read as
//! pure Rust ones in both cases, and converted once.

use std::borrow::Cow;
use std::fmt::Display;

use clap::ValueEnum;
use num_rational::BigRational;
#[cfg(not(feature = "rug"))]
use num_rational::BigRational as Rational;
#[cfg(feature = "rug")]
use rug::Rational;
use sweep_cdt::crossings::Exact;
use sweep_cdt::interior::{InteriorError, Seed};
use sweep_cdt::memory::of_triangulation;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::{Error, Pslg, Region};
use sweep_cdt_formats::{Coordinate, GraphFile, Input};

use super::failure::Failure;
use super::places::located;
use super::resources::has_room;

/// Arguments that select the arithmetic.
#[derive(clap::Args)]
pub(crate) struct ScalarArgs {
    /// Arithmetic [default: rational if the input has fractions, otherwise f64]
    ///
    /// Both are exact and give the same triangles. If the input has a fraction (`p/q`), every number
    /// means what it says: 0.1 is one tenth. Otherwise every number is read as the nearest double. f64
    /// refuses fractions. Numerators, denominators and decimals have at most 10,000 digits, and exponents
    /// are from -400 to 400; a number that is no double, such as 1e400, needs a fraction somewhere in the
    /// file. Time and memory grow with the digits.
    #[arg(long, value_enum)]
    scalar: Option<Kind>,
}

#[derive(Clone, Copy, ValueEnum)]
enum Kind {
    /// Doubles
    F64,
    /// Fractions of whole numbers with up to 10,000 digits; slower
    Rational,
}

/// The work of a subcommand on its input, in any arithmetic.
pub(crate) trait Job {
    /// Does it.
    fn run<S: Coordinate, T: Scalar + Sync>(self, given: Given<'_, S, T>) -> Result<(), Failure>;
}

/// An input in the arithmetic of a run.
pub(crate) struct Given<'a, S, T> {
    /// The name of the input in messages.
    pub(crate) name: &'a str,
    pub(crate) file: &'a GraphFile<S>,
    /// The points of its graph, in this arithmetic.
    pub(crate) points: &'a [[T; 2]],
    /// The name of the arithmetic.
    pub(crate) scalar: &'static str,
}

impl<S: Coordinate, T> Given<'_, S, T> {
    /// The fault of the input, vertices and edges numbered as in its file, and where it is.
    pub(crate) fn refused(&self, error: Error) -> Failure {
        self.failure(located(self.file, error))
    }

    /// A failure that has to do with the input.
    pub(crate) fn failure(&self, error: impl Display) -> Failure {
        Failure::Error(format!("{}: {error}", self.name))
    }
}

impl ScalarArgs {
    /// Does a job with the input called `name`.
    pub(crate) fn apply(&self, name: &str, input: &Input, job: impl Job) -> Result<(), Failure> {
        let rational = matches!(self.scalar, Some(Kind::Rational));
        match input {
            Input::Doubles(file) => {
                refuse_non_finite(name, file)?;
                refuse_without_memory(name, file)?;
                if rational {
                    let points: Vec<_> = file.graph.points.iter().map(|p| p.map(exact)).collect();
                    job.run(given(name, file, &points, "rational"))
                } else {
                    job.run(given(name, file, &file.graph.points, "f64"))
                }
            }
            Input::Rationals(_) if matches!(self.scalar, Some(Kind::F64)) => {
                Err(has_fractions(name))
            }
            Input::Rationals(file) => {
                refuse_without_memory(name, file)?;
                let points = rational_points(&file.graph.points);
                job.run(given(name, file, &points, "rational"))
            }
        }
    }

    /// The input called `name`, as rationals if these are asked for.
    pub(crate) fn convert(&self, name: &str, input: Input) -> Result<Input, Failure> {
        match (input, self.scalar) {
            (Input::Doubles(file), Some(Kind::Rational)) => {
                Ok(Input::Rationals(as_rationals(name, Input::Doubles(file))?))
            }
            (Input::Rationals(_), Some(Kind::F64)) => Err(has_fractions(name)),
            (input, _) => Ok(input),
        }
    }
}

fn has_fractions(name: &str) -> Failure {
    Failure::Error(format!("{name}: has fractions, which --scalar f64 refuses"))
}

/// The input called `name`, with the exact values of its doubles, which must be finite.
pub(crate) fn as_rationals(name: &str, input: Input) -> Result<GraphFile<BigRational>, Failure> {
    let file = match input {
        Input::Rationals(file) => return Ok(file),
        Input::Doubles(file) => file,
    };
    refuse_non_finite(name, &file)?;
    let graph = &file.graph;
    let seeds = (0..).map(Seed::Hole).zip(&graph.holes);
    let regions = graph.regions.iter().map(|region| &region.seed);
    let seeds = seeds.chain((0..).map(Seed::Region).zip(regions));
    let is_wrong = |(_, seed): &(Seed, &[f64; 2])| !seed.iter().all(|x| x.is_finite());
    if let Some((seed, _)) = seeds.into_iter().find(is_wrong) {
        let error = file.interior_as_numbered(InteriorError::SeedNotFinite { seed });
        return Err(Failure::Error(format!("{name}: {error}")));
    }
    let rational = |point: &[f64; 2]| point.map(|x| x.to_fraction());
    let region = |region: &Region<f64>| Region {
        seed: rational(&region.seed),
        attribute: region.attribute,
    };
    Ok(GraphFile {
        graph: Pslg {
            points: graph.points.iter().map(rational).collect(),
            holes: graph.holes.iter().map(rational).collect(),
            regions: graph.regions.iter().map(region).collect(),
            edges: file.graph.edges,
        },
        columns: file.columns,
        region_areas: file.region_areas,
        pieces_of: file.pieces_of,
        edge_markers: file.edge_markers,
        polygons: file.polygons,
        edge_features: file.edge_features,
        features: file.features,
        properties: file.properties,
        faces: file.faces,
        system: file.system,
        merged: file.merged,
        remarks: file.remarks,
        numbering: file.numbering,
        layers: file.layers,
    })
}

fn refuse_without_memory<S>(
    name: &str,
    GraphFile { graph, .. }: &GraphFile<S>,
) -> Result<(), Failure> {
    let bytes = of_triangulation(graph.points.len(), graph.edges.len()) as u64;
    if has_room(bytes) {
        return Ok(());
    }
    let megabytes = bytes.div_ceil(1_000_000);
    let message = format!("{name}: out of memory: it takes some {megabytes} MB more");
    Err(Failure::Error(message))
}

fn given<'a, S, T>(
    name: &'a str,
    file: &'a GraphFile<S>,
    points: &'a [[T; 2]],
    scalar: &'static str,
) -> Given<'a, S, T> {
    Given {
        name,
        file,
        points,
        scalar,
    }
}

/// Refuses a file called `name` with a point that is not finite.
pub(crate) fn refuse_non_finite(name: &str, file: &GraphFile<f64>) -> Result<(), Failure> {
    let is_finite = |point: &[f64; 2]| point.iter().all(|x| x.is_finite());
    match file.graph.points.iter().position(|point| !is_finite(point)) {
        None => Ok(()),
        Some(vertex) => {
            let error = file.as_numbered(Error::NonFiniteCoordinate { vertex });
            Err(Failure::Error(format!("{name}: {error}")))
        }
    }
}

/// The exact value of a finite double.
fn exact(value: f64) -> Rational {
    #[cfg(not(feature = "rug"))]
    let exact = Rational::from_float(value);
    #[cfg(feature = "rug")]
    let exact = Rational::from_f64(value);
    exact.expect("others were refused")
}

/// The points of a file.
#[cfg(not(feature = "rug"))]
fn rational_points(points: &[[BigRational; 2]]) -> Cow<'_, [[Rational; 2]]> {
    Cow::Borrowed(points)
}

/// The points of a file.
#[cfg(feature = "rug")]
fn rational_points(points: &[[BigRational; 2]]) -> Cow<'_, [[Rational; 2]]> {
    use num_bigint::{BigInt, Sign};
    use rug::{Integer, integer::Order};

    let integer = |number: &BigInt| {
        let (sign, digits) = number.to_u64_digits();
        let size = Integer::from_digits(&digits, Order::Lsf);
        if sign == Sign::Minus { -size } else { size }
    };
    let rational = |x: &BigRational| Rational::from((integer(x.numer()), integer(x.denom())));
    points
        .iter()
        .map(|point| point.each_ref().map(rational))
        .collect()
}
