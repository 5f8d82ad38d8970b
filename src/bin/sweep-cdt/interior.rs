//! The interior of an input, which a result may fill in place of the convex hull.
//!
//! It comes from a triangulation of the input, which is proven right before anything is concluded from it. Its boundary
//! and the edges in it are what the verifier then asks of the result.

use sweep_cdt::formats::Coordinate;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::verify::{Verifier, Violation};
use sweep_cdt::{Triangulation, triangulate};

use crate::shared::arithmetic::Given;
use crate::shared::failure::Failure;
use crate::shared::inside::Inside;
use crate::shared::verification::{self, Answer};

/// What a result must fill.
struct Interior {
    boundary: Vec<Vec<usize>>,
    /// How many triangles fill it.
    triangles: usize,
    is_hull: bool,
    /// The edges in it; of an edge that is in it in part, these parts.
    edges: Vec<[usize; 2]>,
    /// For each of them the input edge that it is, or is a part of.
    numbers: Vec<usize>,
}

/// Verifies that triangles fill the interior by a rule.
pub(crate) fn verify<S: Coordinate, T: Scalar + Sync>(
    rule: Inside,
    given: &Given<'_, S, T>,
    verifier: Verifier<'_>,
    triangles: &[[usize; 3]],
) -> Result<Answer, Failure> {
    let interior = Interior::of(rule, given, &proven(given)?)?;
    Ok(interior.verify(given, verifier, triangles))
}

/// A rule by which triangles that do not fill the hull fill the interior, if there is one.
pub(crate) fn fitting<S: Coordinate, T: Scalar + Sync>(
    given: &Given<'_, S, T>,
    verifier: Verifier<'_>,
    triangles: &[[usize; 3]],
) -> Option<Inside> {
    let mut rules = [Inside::Holes, Inside::EvenOdd, Inside::Nonzero];
    if given.graph.holes.is_empty() {
        rules.rotate_left(1);
    }
    let hull = proven(given).ok()?;
    rules.into_iter().find(|&rule| {
        Interior::of(rule, given, &hull).is_ok_and(|interior| {
            let is_other = !interior.is_hull && interior.triangles == triangles.len();
            is_other && interior.verify(given, verifier, triangles).is_ok()
        })
    })
}

/// The triangulation of the hull.
fn proven<S: Coordinate, T: Scalar + Sync>(
    given: &Given<'_, S, T>,
) -> Result<Triangulation, Failure> {
    let (points, edges) = (given.points, &given.graph.edges);
    let hull = triangulate(points, edges).map_err(|error| given.refused(error))?;
    let triangles: Vec<[usize; 3]> = hull.triangles().collect();
    match verification::verify(Verifier::new(), points, edges, &triangles) {
        Ok(_) => Ok(hull),
        Err(violations) => Err(given.failure(violations)),
    }
}

impl Interior {
    fn of<S: Coordinate, T>(
        rule: Inside,
        given: &Given<'_, S, T>,
        hull: &Triangulation,
    ) -> Result<Interior, Failure> {
        let graph = given.graph;
        let domain = rule.domain(graph, hull);
        let domain = domain.map_err(|error| given.failure(graph.domain_as_numbered(error)))?;
        let sorted = |[a, b]: [usize; 2]| [a.min(b), a.max(b)];
        let mut sides: Vec<[usize; 2]> = domain.constrained_edges().map(sorted).collect();
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
        Ok(Interior {
            boundary: domain.boundary(),
            triangles: domain.inside().len(),
            is_hull: domain.inside().len() == hull.len(),
            edges,
            numbers,
        })
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
                    if let Violation::MissingEdge { edge, .. } = violation {
                        *edge = self.numbers[*edge];
                    }
                }
                &mut *violations.report
            }
        };
        report.edges = given.graph.edges.len();
        answer
    }
}
