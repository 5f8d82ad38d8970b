//! A place in a run: the step at which a vertex or an edge comes, or a step by its number.

use std::fmt;
use std::str::FromStr;

use sweep_cdt::trace::{Event, Vertex, Why};

/// The place that `--around` names.
#[derive(Clone, Copy)]
pub(crate) enum Around {
    Vertex(usize),
    Edge(usize),
    Step(usize),
}

impl FromStr for Around {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Around, Self::Err> {
        let found = match text.split_once(':') {
            Some(("vertex", number)) => number.parse().ok().map(Around::Vertex),
            Some(("edge", number)) => number.parse().ok().map(Around::Edge),
            Some(("step", number)) => number.parse().ok().map(Around::Step),
            _ => None,
        };
        found.ok_or("it must be vertex:N, edge:N or step:N")
    }
}

impl fmt::Display for Around {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Around::Vertex(vertex) => write!(f, "vertex {vertex}"),
            Around::Edge(edge) => write!(f, "edge {edge}"),
            Around::Step(step) => write!(f, "step {step}"),
        }
    }
}

impl Around {
    /// The number of the step among all events, if there is one.
    pub(crate) fn step(self, events: &[Event]) -> Option<usize> {
        let is_here = |event: &Event| match (self, *event) {
            (Around::Vertex(wanted), Event::Point { vertex, .. }) => {
                vertex == Vertex::Input(wanted)
            }
            (Around::Vertex(wanted), Event::Triangle { vertices, why }) => {
                why == Why::First && vertices[0] == Vertex::Input(wanted)
            }
            (Around::Edge(wanted), Event::Edge { edge, .. }) => edge == wanted,
            _ => false,
        };
        match self {
            Around::Step(step) => (1..=events.len()).contains(&step).then_some(step),
            _ => events.iter().position(is_here).map(|at| at + 1),
        }
    }
}
