//! Points, lines and polygons as lists of coordinates, as `GeoJSON` and WKT have them.
//!
//! There are no numbers of vertices. An input takes the points, and the sides of lines and rings for edges; a ring that
//! is not closed is closed. Equal points become one vertex ([`read`](crate::read())). Which ring is whose hole goes along
//! ([`Polygons`]). A result takes the polygons, which must be triangles, and nothing else; its corners are found in the input by their coordinates.

pub(super) mod geojson;
pub(super) mod wkt;

use std::ops::Range;

use crate::read::content::{Corners, Edges, Labels, Syntax, Vertices};
use crate::read::mesh::no_triangle;
use crate::read::remarks::Remarks;
use crate::read::source::{ReadError, Source};
use crate::{CoordinateSystem, Polygons, Properties, Remark};

/// The contents of a file.
pub(super) struct Shapes<'a> {
    source: &'a Source,
    syntax: Syntax,
    coordinates: Vec<[&'a [u8]; 2]>,
    heights: Vec<Option<&'a [u8]>>,
    /// Parts, each with its feature and positions.
    parts: Vec<(Part, usize, Range<usize>)>,
    /// How many features have begun.
    features: usize,
    pub(super) properties: Properties,
    pub(super) system: Option<CoordinateSystem>,
    pub(super) remarks: Remarks,
}

/// The geometry that some positions make together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    Points,
    Line,
    /// The border of a polygon.
    Ring,
    /// The border of a hole in the polygon before.
    Hole,
}

impl<'a> Shapes<'a> {
    pub(super) fn new(source: &'a Source, syntax: Syntax) -> Shapes<'a> {
        Shapes {
            source,
            syntax,
            coordinates: Vec::new(),
            heights: Vec::new(),
            parts: Vec::new(),
            features: 0,
            properties: Properties::default(),
            system: None,
            remarks: Remarks::default(),
        }
    }

    /// Begins a feature: a geometry with what belongs to it.
    pub(super) fn begin_feature(&mut self) {
        self.features += 1;
    }

    /// How many positions there are.
    pub(super) fn len(&self) -> usize {
        self.coordinates.len()
    }

    /// Gives the positions from `first` on this height: those that have none, or all. Returns whether there are any.
    pub(super) fn raise(&mut self, first: usize, height: &'a [u8], is_for_all: bool) -> bool {
        let heights = self.heights[first..].iter_mut();
        let raised = heights.filter(|height| is_for_all || height.is_none());
        raised.map(|missing| *missing = Some(height)).count() > 0
    }

    /// Whether the positions from `first` on have this height already, all of them.
    pub(super) fn is_raised(&self, first: usize, height: &[u8]) -> bool {
        let value = |text: &[u8]| Syntax::Json.value::<f64>(text).ok();
        let is_it = |there: &[u8]| there == height || value(there) == value(height);
        let mut heights = self.heights[first..].iter();
        heights.all(|there| there.is_some_and(is_it))
    }

    /// Adds a position.
    pub(super) fn push(&mut self, point: [&'a [u8]; 2], height: Option<&'a [u8]>) {
        self.coordinates.push(point);
        self.heights.push(height);
    }

    /// Ends a part: it has the positions since the part before.
    pub(super) fn end(&mut self, part: Part) {
        let first = self.parts.last().map_or(0, |(.., range)| range.end);
        self.parts
            .push((part, self.features, first..self.coordinates.len()));
    }

    /// Adds the remark on sides of lines and rings that span more than 180 degrees, if there are any.
    pub(super) fn say_wide_sides(&mut self) {
        let value = |piece| self.syntax.value::<f64>(piece).unwrap_or(f64::NAN);
        let places = self.coordinates.iter().map(|place| place.map(value));
        let places: Vec<[f64; 2]> = places.collect();
        let parts = self.parts.iter();
        let parts = parts.filter(|(part, ..)| *part != Part::Points);
        let sides = parts.flat_map(|(.., range)| sides(range));
        if let Some(wide) = Remark::half_of_the_globe(&places, sides) {
            self.remarks.add(wide);
        }
    }

    /// All positions as vertices, and the sides of lines and rings.
    pub(super) fn into_graph(self) -> Edges<'a> {
        let (mut edges, mut polygons) = (Vec::new(), Polygons::default());
        let mut edge_features = Vec::new();
        for (part, feature, range) in &self.parts {
            let ring = match part {
                Part::Points => continue,
                Part::Line => None,
                Part::Ring => {
                    polygons.begin(*feature);
                    Some(polygons.add_ring(false))
                }
                Part::Hole => Some(polygons.add_ring(true)),
            };
            edges.extend(sides(range));
            let is_open = || self.is_apart(range.start, range.end - 1);
            if *part != Part::Line && !range.is_empty() && is_open() {
                edges.push([range.end - 1, range.start]);
            }
            polygons.ring_of.resize(edges.len(), ring);
            let feature = u32::try_from(*feature).unwrap_or(u32::MAX);
            edge_features.resize(edges.len(), feature);
        }
        if polygons.is_empty() {
            polygons.ring_of.clear();
        }
        let vertices = Vertices {
            syntax: self.syntax,
            ..Vertices::plain(self.source, self.coordinates, 0)
        };
        Edges {
            polygons,
            edge_features,
            features: self.features,
            properties: self.properties,
            system: self.system,
            remarks: self.remarks,
            ..Edges::without_seeds(vertices.with_heights(&self.heights), edges, 0)
        }
    }

    /// The polygons, each with its own three corners.
    pub(super) fn into_triangles(self) -> Result<Corners<'a>, ReadError> {
        let mut corners = Vec::new();
        let rings = self.parts.iter();
        for (part, _, range) in rings.filter(|(part, ..)| matches!(part, Part::Ring | Part::Hole)) {
            let mut ring = range.clone();
            if ring.len() > 1 && !self.is_apart(ring.start, ring.end - 1) {
                ring.end -= 1;
            }
            if ring.is_empty() {
                continue;
            }
            let error = |message: String| {
                let (line, _) = self.source.position(self.coordinates[ring.start][0]);
                self.source.error_in_line(line, message)
            };
            if *part == Part::Hole {
                return Err(error(
                    "the polygon has a hole, and only triangles are read".to_owned(),
                ));
            }
            if ring.len() != 3 {
                return Err(error(no_triangle(ring.len())));
            }
            corners.extend_from_slice(&self.coordinates[ring]);
        }
        let triangles = (0..corners.len() / 3).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]);
        Ok(Corners {
            triangles: triangles.collect(),
            first: 0,
            first_vertex: 0,
            vertices: Some(Vertices {
                syntax: self.syntax,
                ..Vertices::plain(self.source, corners, 0)
            }),
            is_soup: true,
            labels: Labels::Nothing,
        })
    }

    /// Whether two positions differ. Numbers may be written in several ways.
    fn is_apart(&self, v: usize, w: usize) -> bool {
        let value = |piece| self.syntax.value::<f64>(piece);
        let differs = |axis: usize| {
            let [one, other] = [v, w].map(|v| self.coordinates[v][axis]);
            one != other && (value(one).is_err() || value(one) != value(other))
        };
        differs(0) || differs(1)
    }
}

/// The sides of a line or a ring, by its first to its last position.
fn sides(range: &Range<usize>) -> impl Iterator<Item = [usize; 2]> {
    range.clone().skip(1).map(|v| [v - 1, v])
}
