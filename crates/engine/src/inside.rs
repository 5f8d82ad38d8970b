//! Rules for what of the hull is inside, by name.
//!
//! A rule of edges is one of the library's [`FillRule`]s. The others ask for more than edges: for the rings of polygons,
//! or for the seeds of holes and regions.

use std::fmt;
use std::str::FromStr;

use sweep_cdt::interior::{FillRule, Interior, InteriorError, Ring};
use sweep_cdt::{Region, Triangulation};
use sweep_cdt_formats::{Coordinate, GraphFile};

use crate::settings::UnknownName;

/// An input, borrowed: points and edges, and what bounds an interior.
#[derive(Clone, Debug)]
pub struct Input<'a, S> {
    /// The points.
    pub points: &'a [[S; 2]],
    /// The edges.
    pub edges: &'a [[usize; 2]],
    /// The seeds of holes.
    pub holes: &'a [[S; 2]],
    /// The seeds of regions, and their attributes.
    pub regions: &'a [Region<S>],
    /// The rings of polygons.
    pub rings: &'a [Ring],
    /// For each edge its ring; empty, if there are no rings.
    pub ring_of: &'a [Option<usize>],
}

impl<'a, S> Input<'a, S> {
    /// Points and nothing else.
    pub fn of(points: &'a [[S; 2]]) -> Input<'a, S> {
        Input {
            points,
            edges: &[],
            holes: &[],
            regions: &[],
            rings: &[],
            ring_of: &[],
        }
    }
}

impl<'a, S> From<&'a GraphFile<S>> for Input<'a, S> {
    fn from(file: &'a GraphFile<S>) -> Input<'a, S> {
        Input {
            points: &file.graph.points,
            edges: &file.graph.edges,
            holes: &file.graph.holes,
            regions: &file.graph.regions,
            rings: &file.polygons.rings,
            ring_of: &file.polygons.ring_of,
        }
    }
}

/// A rule for what is inside.
///
/// ```
/// use sweep_cdt::interior::FillRule;
/// use sweep_cdt_engine::Inside;
///
/// assert_eq!("at-least-2".parse(), Ok(Inside::Edges(FillRule::AtLeast(2))));
/// assert_eq!(Inside::HullWithoutHoles.to_string(), "hull-without-holes");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Inside {
    /// What edges say: the hull, even-odd, or how often they go round.
    Edges(FillRule),
    /// What the outlines of polygons cover, each without its own holes.
    Polygons,
    /// What is not reached without crossing an edge, neither from outside nor from the seed of a hole.
    Holes,
    /// What is not reached from the seed of a hole.
    HullWithoutHoles,
}

/// The names of the rules that need no number.
const NAMES: [(&str, Inside); 8] = [
    ("hull", Inside::HULL),
    ("polygons", Inside::Polygons),
    ("even-odd", Inside::EVEN_ODD),
    ("nonzero", Inside::NONZERO),
    ("positive", Inside::Edges(FillRule::Positive)),
    ("negative", Inside::Edges(FillRule::Negative)),
    ("holes", Inside::Holes),
    ("hull-without-holes", Inside::HullWithoutHoles),
];
/// The beginning of the name of the others.
const AT_LEAST: &str = "at-least-";

impl Inside {
    /// All of the hull.
    pub const HULL: Inside = Inside::Edges(FillRule::Hull);
    pub(crate) const EVEN_ODD: Inside = Inside::Edges(FillRule::EvenOdd);
    pub(crate) const NONZERO: Inside = Inside::Edges(FillRule::NonZero);

    /// The names of the rules that need no number.
    pub fn names() -> impl Iterator<Item = &'static str> {
        NAMES.into_iter().map(|(name, _)| name)
    }

    /// The rule where none is asked for, for an input that may have polygons, and seeds that count: those of holes, and
    /// where a mesh is refined those of regions with greatest areas.
    pub fn default_of(has_seeds: bool, has_polygons: bool) -> Inside {
        match (has_seeds, has_polygons) {
            (true, _) => Inside::Holes,
            (false, true) => Inside::Polygons,
            (false, false) => Inside::HULL,
        }
    }

    /// Whether triangles have the attributes of regions by this rule.
    pub fn has_regions(self) -> bool {
        matches!(self, Inside::Holes | Inside::HullWithoutHoles)
    }

    /// The interior of `result`, which is a triangulation of the input.
    ///
    /// # Errors
    /// Those of the library, where the input does not tell what is inside. Of an input with edges that has no polygons the
    /// rule [`Inside::Polygons`] gives an [`InteriorError::UnknownRing`].
    pub fn interior<'a, S: Coordinate>(
        self,
        input: &Input<'a, S>,
        result: &'a Triangulation,
    ) -> Result<Interior<'a>, InteriorError> {
        let seeds = || input.regions.iter().map(|region| region.seed.clone());
        let seeds = || seeds().collect::<Vec<[S; 2]>>();
        let with_points = || result.with_points(input.points);
        match self {
            Inside::Edges(rule) => result.interior(rule),
            Inside::Polygons => result.interior_of_polygons(input.rings, input.ring_of),
            Inside::Holes => with_points().interior_of_seeds(input.holes, &seeds()),
            Inside::HullWithoutHoles => with_points().hull_without_holes(input.holes, &seeds()),
        }
    }
}

impl fmt::Display for Inside {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Inside::Edges(FillRule::AtLeast(times)) = self {
            return write!(f, "{AT_LEAST}{times}");
        }
        let name = NAMES.iter().find(|(_, rule)| rule == self);
        f.write_str(name.map_or("", |(name, _)| name))
    }
}

impl FromStr for Inside {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Inside, UnknownName> {
        if let Some((_, rule)) = NAMES.iter().find(|(known, _)| *known == name) {
            return Ok(*rule);
        }
        let times = name.strip_prefix(AT_LEAST);
        let times = times.and_then(|times| times.parse().ok());
        match times {
            Some(times) if times > 0 => Ok(Inside::Edges(FillRule::AtLeast(times))),
            _ => {
                let with_number = "at-least-K with K from 1 on";
                let known = Inside::names().chain([with_number]);
                Err(UnknownName::new("rule", name, known))
            }
        }
    }
}
