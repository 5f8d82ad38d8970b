//! The part of the hull that is inside, and results that fill this interior in place of the hull.
//!
//! The interior comes from a triangulation of the input, which is proven right before anything is concluded from
//! it. Its boundary and the edges in it are what the verifier then asks of the result.

use clap::ValueEnum;
use sweep_cdt::interior::{FillRule, Interior, InteriorError, locate_seeds};
use sweep_cdt::scalar::Measure;
use sweep_cdt::verify::{Regions, Verifier, Violation};
use sweep_cdt::{Pslg, Triangulation, triangulate};
use sweep_cdt_formats::{Coordinate, GraphFile, Triangles};

use super::arithmetic::Given;
use super::failure::Failure;
use super::verification::{self, Answer};

/// Arguments that choose the rule.
#[derive(clap::Args)]
pub(crate) struct InsideArgs {
    /// Which triangles are inside; no others are written [default: holes for a .poly with holes, otherwise
    /// hull]
    #[arg(long, value_enum, value_name = "RULE")]
    inside: Option<Inside>,
}

/// The rules.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Inside {
    /// All of the convex hull
    Hull,
    /// What a path from outside enters by crossing an odd number of edges; one given twice is crossed
    /// twice. The edges must be closed rings
    EvenOdd,
    /// What the edges go round, more often in one direction than in the other; each runs from its first
    /// vertex to its second. The edges must be closed rings
    Nonzero,
    /// What is not reached without crossing an edge, neither from outside nor from the point of a hole in
    /// the .poly. Triangles have the attributes of its regions
    Holes,
}

impl Inside {
    /// The name in messages and on the command line.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Inside::Hull => "hull",
            Inside::EvenOdd => "even-odd",
            Inside::Nonzero => "nonzero",
            Inside::Holes => "holes",
        }
    }

    /// The domain of a graph.
    pub(crate) fn domain<'a, S: Coordinate>(
        self,
        graph: &'a Pslg<S>,
        result: &'a Triangulation,
    ) -> Result<Interior<'a>, InteriorError> {
        match self {
            Inside::Hull => result.interior(FillRule::Hull),
            Inside::EvenOdd => result.interior(FillRule::EvenOdd),
            Inside::Nonzero => result.interior(FillRule::NonZero(&graph.edges)),
            Inside::Holes => {
                let seeds = graph.regions.iter().map(|region| region.seed.clone());
                let regions: Vec<[S; 2]> = seeds.collect();
                result
                    .with_points(&graph.points)
                    .interior_of_seeds(&graph.holes, &regions)
            }
        }
    }
}

impl InsideArgs {
    /// The rule for a graph.
    pub(crate) fn rule<S>(&self, graph: &Pslg<S>) -> Inside {
        self.inside.unwrap_or(if graph.holes.is_empty() {
            Inside::Hull
        } else {
            Inside::Holes
        })
    }

    /// The domain, unless it is the hull. `name` is what messages call the input.
    pub(crate) fn domain<'a, S: Coordinate>(
        &self,
        name: &str,
        file: &'a GraphFile<S>,
        result: &'a Triangulation,
    ) -> Result<Option<Interior<'a>>, Failure> {
        let domain = match self.rule(&file.graph) {
            Inside::Hull => return Ok(None),
            rule => rule.domain(&file.graph, result),
        };
        let refused = |error| {
            let way_out = match self.inside {
                None => " (--inside hull keeps all triangles)",
                Some(_) => "",
            };
            let error = file.interior_as_numbered(error);
            Failure::Error(format!("{name}: {error}{way_out}"))
        };
        domain.map(Some).map_err(refused)
    }
}

/// The domain that a result must fill.
struct Wanted {
    boundary: Vec<Vec<usize>>,
    /// How many triangles fill it.
    triangles: usize,
    /// The edges in it; of an edge that is in it in part, these parts.
    edges: Vec<[usize; 2]>,
    /// For each of them the input edge that it is, or is a part of.
    numbers: Vec<usize>,
}

/// Verifies that triangles fill the hull, or the interior by a rule, and that they have the attributes of its regions, if
/// the result has any. The first `own` points are the input's, the others added.
pub(crate) fn answer<S: Coordinate, T: Measure + Sync>(
    rule: Inside,
    given: &Given<'_, S, T>,
    own: usize,
    verifier: Verifier<'_>,
    triangles: &Triangles,
) -> Result<Answer, Failure> {
    match rule {
        Inside::Hull => Ok(in_hull(given, verifier, triangles)),
        rule => {
            let interior = Wanted::of(rule, given, &proven(given, own)?)?;
            Ok(interior.answer(rule, given, verifier, triangles))
        }
    }
}

/// The answers by all rules by which the triangles may be right; the one that was asked for is the first.
pub(crate) fn answers<S: Coordinate, T: Measure + Sync>(
    given: &Given<'_, S, T>,
    own: usize,
    verifier: Verifier<'_>,
    triangles: &Triangles,
    asked: Inside,
) -> Vec<(Inside, Answer)> {
    let mut rules = [
        Inside::Hull,
        Inside::EvenOdd,
        Inside::Nonzero,
        Inside::Holes,
    ];
    if !given.file.graph.holes.is_empty() {
        rules[1..].rotate_right(1);
    }
    rules.sort_by_key(|&rule| rule != asked);
    let Ok(hull) = proven(given, own) else {
        return Vec::new();
    };
    let is_possible =
        |interior: &Wanted| given.points.len() > own || interior.triangles == triangles.list.len();
    let answer = |rule: Inside| match rule {
        Inside::Hull => Some((rule, in_hull(given, verifier, triangles))),
        rule => {
            let interior = Wanted::of(rule, given, &hull).ok().filter(is_possible)?;
            Some((rule, interior.answer(rule, given, verifier, triangles)))
        }
    };
    rules.into_iter().filter_map(answer).collect()
}

fn in_hull<S: Coordinate, T: Measure + Sync>(
    given: &Given<'_, S, T>,
    verifier: Verifier<'_>,
    triangles: &Triangles,
) -> Answer {
    let edges = &given.file.graph.edges;
    verification::verify(verifier, given.points, edges, &triangles.list)
}

/// The triangulation of the hull of the first `own` points.
fn proven<S: Coordinate, T: Measure + Sync>(
    given: &Given<'_, S, T>,
    own: usize,
) -> Result<Triangulation, Failure> {
    let (points, edges) = (&given.points[..own], &given.file.graph.edges);
    let hull = triangulate(points, edges).map_err(|error| given.refused(error))?;
    let triangles: Vec<[usize; 3]> = hull.triangles().collect();
    match verification::verify(Verifier::new(), points, edges, &triangles) {
        Ok(_) => Ok(hull),
        Err(violations) => Err(given.failure(violations)),
    }
}

impl Wanted {
    fn of<S: Coordinate, T>(
        rule: Inside,
        given: &Given<'_, S, T>,
        hull: &Triangulation,
    ) -> Result<Wanted, Failure> {
        let (file, graph) = (given.file, &given.file.graph);
        let domain = rule.domain(graph, hull);
        let domain = domain.map_err(|error| given.failure(file.interior_as_numbered(error)))?;
        let sorted = |[a, b]: [usize; 2]| [a.min(b), a.max(b)];
        let mut sides: Vec<[usize; 2]> = domain.constrained_sides().map(sorted).collect();
        sides.sort_unstable();
        let is_in = |side: &[usize; 2]| sides.binary_search(&sorted(*side)).is_ok();
        let mut edges = Vec::new();
        for (number, &edge) in graph.edges.iter().enumerate() {
            let chain = hull.edge_chain(number);
            let parts: Vec<[usize; 2]> = chain
                .clone()
                .zip(chain.skip(1))
                .map(|(a, b)| [a, b])
                .collect();
            if parts.iter().all(is_in) {
                edges.push((edge, number));
            } else {
                edges.extend(parts.into_iter().filter(is_in).map(|part| (part, number)));
            }
        }
        let (edges, numbers) = edges.into_iter().unzip();
        Ok(Wanted {
            boundary: domain.boundary(),
            triangles: domain.inside().len(),
            edges,
            numbers,
        })
    }

    /// The answer, with the attributes of regions where the rule has them.
    fn answer<S: Coordinate, T: Measure + Sync>(
        &self,
        rule: Inside,
        given: &Given<'_, S, T>,
        verifier: Verifier<'_>,
        triangles: &Triangles,
    ) -> Answer {
        let list = &triangles.list;
        let regions = &given.file.graph.regions;
        let (Some(attributes), Inside::Holes, false) =
            (&triangles.attributes, rule, regions.is_empty())
        else {
            return self.verify(given, verifier, list);
        };
        let seeds: Vec<[S; 2]> = regions.iter().map(|region| region.seed.clone()).collect();
        let places = locate_seeds(&given.file.graph.points, list, &seeds).into_iter();
        let seeds = places.zip(regions);
        let seeds: Vec<(usize, f64)> = seeds
            .filter_map(|(place, region)| Some((place?, region.attribute)))
            .collect();
        let regions = Regions {
            attributes,
            seeds: &seeds,
        };
        self.verify(given, verifier.regions(regions), list)
    }

    fn verify<S, T: Measure + Sync>(
        &self,
        given: &Given<'_, S, T>,
        verifier: Verifier<'_>,
        triangles: &[[usize; 3]],
    ) -> Answer {
        let verifier = verifier.boundary(&self.boundary);
        let mut answer = verification::verify(verifier, given.points, &self.edges, triangles);
        let report = match &mut answer {
            Ok(report) => report,
            Err(violations) => {
                for violation in &mut violations.list {
                    if let Violation::MissingEdge { edge, .. } = violation {
                        *edge = self.numbers[*edge];
                    }
                }
                &mut *violations.report
            }
        };
        report.edges = given.file.graph.edges.len();
        answer
    }
}
