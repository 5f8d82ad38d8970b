//! Which triangles are inside: the rules by the names of the command.

use pyo3::prelude::*;
use sweep_cdt::Triangulation;
use sweep_cdt::interior::{FillRule, Interior, InteriorError};
use sweep_cdt::scalar::Scalar;

use crate::errors::refused;
use crate::input::Graph;

/// A rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Rule {
    Hull,
    Polygons,
    EvenOdd,
    NonZero,
    Positive,
    Negative,
    AtLeast(u32),
    Holes,
    HullWithoutHoles,
}

impl Rule {
    /// The rule of a name.
    pub(crate) fn named(name: &str) -> PyResult<Rule> {
        let times = name.strip_prefix("at-least-");
        Ok(match name {
            "hull" => Rule::Hull,
            "polygons" => Rule::Polygons,
            "even-odd" => Rule::EvenOdd,
            "nonzero" => Rule::NonZero,
            "positive" => Rule::Positive,
            "negative" => Rule::Negative,
            "holes" => Rule::Holes,
            "hull-without-holes" => Rule::HullWithoutHoles,
            _ => match times.and_then(|times| times.parse().ok()) {
                Some(times) if times > 0 => Rule::AtLeast(times),
                _ => {
                    return Err(refused(format!(
                        "there is no rule {name:?}: it is hull, polygons, even-odd, nonzero, positive, negative, \
                         at-least-K with K from 1 on, holes, or hull-without-holes"
                    )));
                }
            },
        })
    }

    /// The rule, if edges are all that it asks for.
    pub(crate) fn of_edges(self) -> Option<FillRule> {
        match self {
            Rule::Hull => Some(FillRule::Hull),
            Rule::EvenOdd => Some(FillRule::EvenOdd),
            Rule::NonZero => Some(FillRule::NonZero),
            Rule::Positive => Some(FillRule::Positive),
            Rule::Negative => Some(FillRule::Negative),
            Rule::AtLeast(times) => Some(FillRule::AtLeast(times)),
            Rule::Polygons | Rule::Holes | Rule::HullWithoutHoles => None,
        }
    }

    /// The interior of a triangulation of a graph.
    pub(crate) fn interior<'a, S: Scalar>(
        self,
        graph: &'a Graph<'_, S>,
        result: &'a Triangulation,
    ) -> Result<Interior<'a>, InteriorError> {
        if let Some(rule) = self.of_edges() {
            return result.interior(rule);
        }
        if self == Rule::Polygons {
            return result.interior_of_polygons(&graph.rings, &graph.ring_of);
        }
        let result = result.with_points(graph.points);
        if self == Rule::Holes {
            result.interior_of_seeds(graph.holes, graph.regions)
        } else {
            result.hull_without_holes(graph.holes, graph.regions)
        }
    }
}
