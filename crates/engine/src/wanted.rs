//! What triangles must fill within a domain: its boundary, and the edges in it.

use sweep_cdt::Triangulation;
use sweep_cdt::interior::InteriorError;
use sweep_cdt::verify::Violation;
use sweep_cdt_formats::Coordinate;

use crate::inside::{Input, Inside};
use crate::verdict::Answer;

/// The domain that triangles must fill.
pub(crate) struct Wanted {
    pub(crate) boundary: Vec<Vec<usize>>,
    /// How many triangles of the input's own points fill it.
    pub(crate) triangles: usize,
    /// The edges in it; of an edge that is in it in part, these parts.
    pub(crate) edges: Vec<[usize; 2]>,
    /// For each of them the input edge that it is, or is a part of.
    numbers: Vec<usize>,
}

impl Wanted {
    /// The domain by a rule, from a triangulation of the input's hull.
    pub(crate) fn new<S: Coordinate>(
        rule: Inside,
        input: &Input<'_, S>,
        hull: &Triangulation,
    ) -> Result<Wanted, InteriorError> {
        let domain = rule.interior(input, hull)?;
        let sorted = |[a, b]: [usize; 2]| [a.min(b), a.max(b)];
        let mut sides: Vec<[usize; 2]> = domain.constrained_sides().map(sorted).collect();
        sides.sort_unstable();
        let is_in = |side: &[usize; 2]| sides.binary_search(&sorted(*side)).is_ok();
        let (mut edges, mut numbers) = (Vec::new(), Vec::new());
        for (number, &edge) in input.edges.iter().enumerate() {
            let chain = hull.edge_chain(number);
            let mut parts = chain.clone().zip(chain.skip(1)).map(|(a, b)| [a, b]);
            if parts.clone().all(|part| is_in(&part)) {
                edges.push(edge);
            } else {
                edges.extend(parts.by_ref().filter(is_in));
            }
            numbers.resize(edges.len(), number);
        }
        Ok(Wanted {
            boundary: domain.boundary(),
            triangles: domain.inside().len(),
            edges,
            numbers,
        })
    }

    /// An answer about these edges as one about those of the input, of which there are `count`.
    pub(crate) fn of_input(&self, mut answer: Answer, count: usize) -> Answer {
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
        report.edges = count;
        answer
    }
}
