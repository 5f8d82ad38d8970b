//! Whose border an edge is: the rings of polygons in a file, and what they cover together.

use sweep_cdt::Triangulation;
use sweep_cdt::interior::{Interior, InteriorError, Ring};

/// The polygons of a file. Edges of no ring are lines, which bound nothing.
///
/// ```
/// use sweep_cdt_formats::{Format, Input, Source, read};
///
/// let text = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 2 2, 1 1)) LINESTRING (3 1, 3 3)";
/// let Input::Doubles(file) = read(Format::Wkt, &Source::new("one.wkt", text), None)? else {
///     unreachable!("no fraction in the file")
/// };
/// let polygons = &file.polygons;
/// assert_eq!(polygons.rings.iter().map(|ring| ring.is_hole).collect::<Vec<_>>(), [false, true]);
/// assert_eq!(polygons.ring_of[4..], [Some(1), Some(1), Some(1), None]);
///
/// let result = sweep_cdt::triangulate(&file.graph.points, &file.graph.edges)?;
/// assert!(polygons.interior(&result)?.inside().len() < result.len());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Polygons {
    /// The outlines and holes.
    pub rings: Vec<Ring>,
    /// For each edge of the file its ring, as a position in `rings`; empty, if there are no rings.
    pub ring_of: Vec<Option<usize>>,
    /// For each polygon the feature that it belongs to, counted from 1, so that 0 can stand for none: a feature of `GeoJSON`, a geometry of WKT, a face
    /// of a mesh.
    pub features: Vec<usize>,
}

impl Polygons {
    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.rings.is_empty()
    }

    /// What the polygons cover: each its outline without its holes, however rings run.
    ///
    /// # Errors
    /// Errors of [`Triangulation::interior_of_polygons`]; there must be polygons, if there are edges.
    pub fn interior<'a>(&self, result: &'a Triangulation) -> Result<Interior<'a>, InteriorError> {
        result.interior_of_polygons(&self.rings, &self.ring_of)
    }

    /// The feature of the lowest polygon that covers a triangle of [`interior`](Self::interior).
    pub fn feature(&self, interior: &Interior<'_>, t: usize) -> Option<usize> {
        self.features.get(interior.region(t)?).copied()
    }

    /// Begins a polygon of a feature.
    pub(crate) fn begin(&mut self, feature: usize) {
        self.features.push(feature);
    }

    /// Adds a ring of the last polygon. Returns its position.
    pub(crate) fn add_ring(&mut self, is_hole: bool) -> usize {
        let polygon = self.features.len().saturating_sub(1);
        self.rings.push(Ring { polygon, is_hole });
        self.rings.len() - 1
    }

    /// The polygons, where edges are pieces of those before, and perhaps others that follow, of so many in all.
    pub(crate) fn of_pieces(&self, pieces_of: &[usize], edges: usize) -> Polygons {
        let mut pieces = self.clone();
        if !self.is_empty() {
            let ring_of = pieces_of.iter().map(|&edge| self.ring_of[edge]);
            pieces.ring_of = ring_of.collect();
            pieces.ring_of.resize(edges, None);
        }
        pieces
    }
}
