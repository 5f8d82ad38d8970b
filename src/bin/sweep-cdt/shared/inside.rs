//! What of the hull is inside.

use clap::ValueEnum;
use sweep_cdt::Triangulation;
use sweep_cdt::domain::{Domain, DomainError, Rule};
use sweep_cdt::formats::{Coordinate, Graph};

use super::failure::Failure;

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
    /// What messages and the command line call it.
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
        graph: &Graph<S>,
        result: &'a Triangulation,
    ) -> Result<Domain<'a>, DomainError> {
        match self {
            Inside::Hull => result.domain(Rule::Hull),
            Inside::EvenOdd => result.domain(Rule::EvenOdd),
            Inside::Nonzero => result.domain(Rule::NonZero(&graph.edges)),
            Inside::Holes => {
                let seeds = graph.regions.iter().map(|region| region.seed.clone());
                let regions: Vec<[S; 2]> = seeds.collect();
                result.domain_of_seeds(&graph.points, &graph.holes, &regions)
            }
        }
    }
}

impl InsideArgs {
    /// The rule for a graph.
    pub(crate) fn rule<S>(&self, graph: &Graph<S>) -> Inside {
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
        graph: &Graph<S>,
        result: &'a Triangulation,
    ) -> Result<Option<Domain<'a>>, Failure> {
        let domain = match self.rule(graph) {
            Inside::Hull => return Ok(None),
            rule => rule.domain(graph, result),
        };
        let refused = |error| {
            let way_out = match self.inside {
                None => " (--inside hull keeps all triangles)",
                Some(_) => "",
            };
            let error = graph.domain_as_numbered(error);
            Failure::Error(format!("{name}: {error}{way_out}"))
        };
        domain.map(Some).map_err(refused)
    }
}
