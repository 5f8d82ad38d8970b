//! The part of the hull that is inside, and results that fill this interior in place of the hull.
//!
//! The interior comes from a triangulation of the input, which is proven right before anything is concluded from
//! it. Its boundary and the edges in it are what the verifier then asks of the result.

use std::fmt;

use sweep_cdt::interior::{FillRule, Interior, InteriorError};
use sweep_cdt::scalar::Scalar;
use sweep_cdt::verify::{Verifier, Violation};
use sweep_cdt::{Triangulation, triangulate};
use sweep_cdt_formats::{Coordinate, GraphFile, Triangles, locate_seeds};

use super::arithmetic::Given;
use super::failure::Failure;
use super::places::located_interior;
use super::verification::{self, Answer};

/// Arguments that choose the rule.
#[derive(clap::Args)]
pub(crate) struct InsideArgs {
    /// Which triangles are inside; no others are written [default: holes for a file with holes, polygons for one with
    /// polygons, otherwise hull]
    ///
    /// hull: all of the convex hull.
    ///
    /// polygons: what the outlines of polygons cover, each without its own holes, whichever way rings run. Lines bound
    /// nothing. For .geojson and .wkt, and for meshes with --faces.
    ///
    /// even-odd: what a path from outside enters by crossing an odd number of edges; one given twice is crossed twice.
    ///
    /// nonzero: what the edges go round, more often in one direction than in the other. positive: more often
    /// counter-clockwise. negative: more often clockwise. at-least-K: at least K times, in one direction. Each edge
    /// runs from its first vertex to its second. For these rules and for even-odd, the edges must be closed rings.
    ///
    /// holes: what is not reached without crossing an edge, neither from outside nor from the seed of a hole.
    ///
    /// hull-without-holes: what is not reached from the seed of a hole (-c of Triangle). By this rule and by holes,
    /// triangles have the attributes of the file's regions.
    #[arg(long, value_name = "RULE", value_parser = Inside::named)]
    inside: Option<Inside>,
}

/// The rules.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Inside {
    Hull,
    Polygons,
    EvenOdd,
    Nonzero,
    Positive,
    Negative,
    AtLeast(u32),
    Holes,
    HullWithoutHoles,
}

/// The names on the command line of the rules that need no number.
const NAMES: [(Inside, &str); 8] = [
    (Inside::Hull, "hull"),
    (Inside::Polygons, "polygons"),
    (Inside::EvenOdd, "even-odd"),
    (Inside::Nonzero, "nonzero"),
    (Inside::Positive, "positive"),
    (Inside::Negative, "negative"),
    (Inside::Holes, "holes"),
    (Inside::HullWithoutHoles, "hull-without-holes"),
];
/// The beginning of the name of the others.
const AT_LEAST: &str = "at-least-";

impl fmt::Display for Inside {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Inside::AtLeast(times) => write!(f, "{AT_LEAST}{times}"),
            rule => {
                let name = NAMES.iter().find(|(named, _)| named == rule);
                f.write_str(name.map_or("", |(_, name)| name))
            }
        }
    }
}

impl Inside {
    /// The rule of a name.
    pub(crate) fn named(name: &str) -> Result<Inside, String> {
        if let Some((rule, _)) = NAMES.iter().find(|(_, known)| *known == name) {
            return Ok(*rule);
        }
        let times = name
            .strip_prefix(AT_LEAST)
            .and_then(|times| times.parse().ok());
        let times = times.filter(|&times| times > 0);
        times.map(Inside::AtLeast).ok_or_else(|| {
            let known: Vec<&str> = NAMES.iter().map(|(_, name)| *name).collect();
            format!(
                "it is one of {}, and {AT_LEAST}K with a whole number K from 1 on",
                known.join(", ")
            )
        })
    }

    /// The domain of a file's graph. The rule [`Inside::Polygons`] needs polygons ([`Inside::suits`]).
    pub(crate) fn domain<'a, S: Coordinate>(
        self,
        file: &'a GraphFile<S>,
        result: &'a Triangulation,
    ) -> Result<Interior<'a>, InteriorError> {
        let graph = &file.graph;
        match self {
            Inside::Hull => result.interior(FillRule::Hull),
            Inside::Polygons => file.polygons.interior(result),
            Inside::EvenOdd => result.interior(FillRule::EvenOdd),
            Inside::Nonzero => result.interior(FillRule::NonZero),
            Inside::Positive => result.interior(FillRule::Positive),
            Inside::Negative => result.interior(FillRule::Negative),
            Inside::AtLeast(times) => result.interior(FillRule::AtLeast(times)),
            Inside::Holes | Inside::HullWithoutHoles => {
                let seeds = graph.regions.iter().map(|region| region.seed.clone());
                let regions: Vec<[S; 2]> = seeds.collect();
                let result = result.with_points(&graph.points);
                if self == Inside::Holes {
                    result.interior_of_seeds(&graph.holes, &regions)
                } else {
                    result.hull_without_holes(&graph.holes, &regions)
                }
            }
        }
    }

    /// The rule for a file where none is asked for.
    pub(crate) fn of<S>(file: &GraphFile<S>) -> Inside {
        if !file.graph.holes.is_empty() {
            Inside::Holes
        } else if !file.polygons.is_empty() {
            Inside::Polygons
        } else {
            Inside::Hull
        }
    }

    /// Refuses a rule that a file says nothing about; `name` is what messages call it.
    pub(crate) fn suits<S>(self, name: &str, file: &GraphFile<S>) -> Result<(), Failure> {
        if self == Inside::Polygons && file.polygons.is_empty() {
            return Err(Failure::Error(format!(
                "{name}: there are no polygons, which .geojson and .wkt have, and meshes with --faces; the rule even-odd \
                 takes edges that are closed rings"
            )));
        }
        Ok(())
    }
}

impl InsideArgs {
    /// The rule for a file, and why it is this one, in words.
    pub(crate) fn rule<S>(&self, file: &GraphFile<S>) -> (Inside, String) {
        let count = |number: usize, one: &str, many: &str| match number {
            1 => format!("1 {one}"),
            number => format!("{number} {many}"),
        };
        let (holes, polygons) = (file.graph.holes.len(), file.polygons.features.len());
        match (self.inside, Inside::of(file)) {
            (Some(rule), _) => (rule, "as --inside says".to_owned()),
            (None, Inside::Holes) => {
                let holes = count(holes, "hole", "holes");
                let why = format!("as the file has {holes}; --inside hull keeps all");
                (Inside::Holes, why)
            }
            (None, Inside::Polygons) => {
                let polygons = count(polygons, "polygon", "polygons");
                let why = format!("as the file has {polygons}; --inside hull keeps all");
                (Inside::Polygons, why)
            }
            (None, rule) => {
                let why = "as the file has no holes and no polygons; --inside holes keeps what edges enclose";
                (rule, why.to_owned())
            }
        }
    }

    /// The domain, unless it is the hull. `name` is what messages call the input.
    pub(crate) fn domain<'a, S: Coordinate>(
        &self,
        name: &str,
        file: &'a GraphFile<S>,
        result: &'a Triangulation,
    ) -> Result<Option<Interior<'a>>, Failure> {
        let (rule, _) = self.rule(file);
        rule.suits(name, file)?;
        let domain = match rule {
            Inside::Hull => return Ok(None),
            rule => rule.domain(file, result),
        };
        let refused = |error| {
            let way_out = match self.inside {
                None => " (--inside hull keeps all triangles)",
                Some(_) => "",
            };
            let error = located_interior(file, error);
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
pub(crate) fn answer<S: Coordinate, T: Scalar + Sync>(
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

/// The answers by all rules by which the triangles may be right; the one that was asked for is the first. Fails where the
/// input has no triangulation.
pub(crate) fn answers<S: Coordinate, T: Scalar + Sync>(
    given: &Given<'_, S, T>,
    own: usize,
    verifier: Verifier<'_>,
    triangles: &Triangles,
    asked: Inside,
) -> Result<Vec<(Inside, Answer)>, Failure> {
    let mut rules = vec![Inside::Hull];
    if !given.file.polygons.is_empty() {
        rules.push(Inside::Polygons);
    }
    if given.file.graph.holes.is_empty() {
        rules.extend([Inside::EvenOdd, Inside::Nonzero, Inside::Holes]);
    } else {
        rules.extend([
            Inside::Holes,
            Inside::HullWithoutHoles,
            Inside::EvenOdd,
            Inside::Nonzero,
        ]);
    }
    rules.retain(|&rule| rule != asked);
    rules.insert(0, asked);
    let hull = proven(given, own)?;
    let count = triangles.list.len();
    let is_possible =
        |interior: &Wanted| count > 0 && (given.points.len() > own || interior.triangles == count);
    let answer = |rule: Inside| match rule {
        Inside::Hull => Some((rule, in_hull(given, verifier, triangles))),
        rule => {
            let interior = Wanted::of(rule, given, &hull).ok().filter(is_possible)?;
            Some((rule, interior.answer(rule, given, verifier, triangles)))
        }
    };
    Ok(rules.into_iter().filter_map(answer).collect())
}

fn in_hull<S: Coordinate, T: Scalar + Sync>(
    given: &Given<'_, S, T>,
    verifier: Verifier<'_>,
    triangles: &Triangles,
) -> Answer {
    let edges = &given.file.graph.edges;
    verification::verify(verifier, given.points, edges, &triangles.list)
}

/// The triangulation of the hull of the first `own` points.
fn proven<S: Coordinate, T: Scalar + Sync>(
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
        rule.suits(given.name, file)?;
        let domain = rule.domain(file, hull);
        let domain = domain.map_err(|error| given.failure(located_interior(file, error)))?;
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
    fn answer<S: Coordinate, T: Scalar + Sync>(
        &self,
        rule: Inside,
        given: &Given<'_, S, T>,
        verifier: Verifier<'_>,
        triangles: &Triangles,
    ) -> Answer {
        let list = &triangles.list;
        let regions = &given.file.graph.regions;
        let (Some(attributes), Inside::Holes | Inside::HullWithoutHoles, false) =
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
        self.verify(given, verifier.regions(attributes, &seeds), list)
    }

    fn verify<S, T: Scalar + Sync>(
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
                    if let Violation::MissingEdge { edge, .. } | Violation::BentEdge { edge, .. } =
                        violation
                    {
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
