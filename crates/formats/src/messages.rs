//! What messages call the vertices, edges and seeds of a file: by its own numbers, and with its name where it is a layer.

use std::ops::Range;

use sweep_cdt::Error;
use sweep_cdt::crossings::SplitError;
use sweep_cdt::interior::{InteriorError, Seed};

use crate::{Coordinate, GraphFile, Layer, Numbering, Remark};

impl<S> GraphFile<S> {
    /// An error with its vertices and edges numbered as in the file.
    ///
    /// ```
    /// use sweep_cdt::Error;
    /// use sweep_cdt_formats::{GraphFile, Numbering};
    ///
    /// let file = GraphFile::<f64> { numbering: Numbering::FROM_ONE, ..GraphFile::default() };
    /// let error = file.as_numbered(Error::CrossingEdges { edges: [0, 1] });
    /// assert_eq!(error.to_string(), "edges 1 and 2 cross");
    /// ```
    pub fn as_numbered(&self, error: Error) -> Error {
        let first = self.numbering;
        error.renumbered(
            |vertex| vertex.saturating_add(first.vertex),
            |edge| edge.saturating_add(first.edge),
        )
    }

    /// A remark in words, with its vertex numbered as in the file, and the place of the vertex.
    ///
    /// ```
    /// use sweep_cdt::Pslg;
    /// use sweep_cdt_formats::{GraphFile, Remark};
    ///
    /// let file = GraphFile::from(Pslg { points: vec![[1.5, 2.0]], ..Pslg::default() });
    /// let column = "z".to_owned();
    /// let remark = Remark::Conflict { column, vertex: 0, values: [7.0, 30.0], count: 1 };
    /// let words = "vertex 0 at (1.5, 2) has two numbers for z, 7 and 30: 7 counts";
    /// assert_eq!(file.in_words(&remark), words);
    /// ```
    pub fn in_words(&self, remark: &Remark) -> String
    where
        S: Coordinate,
    {
        remark.words(|vertex| self.vertex_in_words(vertex))
    }

    /// A vertex by its number, with the name of its layer, if there are any, and its place.
    pub fn vertex_in_words(&self, vertex: usize) -> String
    where
        S: Coordinate,
    {
        let number = || format!("vertex {}", vertex.saturating_add(self.numbering.vertex));
        let name = self.vertex_of_layer(vertex).unwrap_or_else(number);
        match self.graph.points.get(vertex) {
            Some([x, y]) => format!("{name} at ({}, {})", x.text(), y.text()),
            None => name,
        }
    }

    /// A vertex by its number in its layer, with the name of that; `None`, if it is of no layer.
    pub fn vertex_of_layer(&self, vertex: usize) -> Option<String> {
        self.of_layer("vertex", vertex, |layer| {
            (&layer.vertices, layer.numbering.vertex)
        })
    }

    /// A seed by its number in its layer, with the name of that; `None`, if it is of no layer.
    pub fn seed_of_layer(&self, seed: Seed) -> Option<String> {
        match seed {
            Seed::Hole(hole) => {
                self.of_layer("hole", hole, |layer| (&layer.holes, layer.numbering.hole))
            }
            Seed::Region(region) => self.of_layer("region", region, |layer| {
                (&layer.regions, layer.numbering.region)
            }),
        }
    }

    /// Something by its number in its layer, with the name of that. `numbers` has the positions of all such things of a
    /// layer, and the number of the first one.
    fn of_layer(
        &self,
        kind: &str,
        position: usize,
        numbers: impl Fn(&Layer) -> (&Range<usize>, usize),
    ) -> Option<String> {
        self.layers.iter().find_map(|layer| {
            let (positions, first) = numbers(layer);
            let number = position.checked_sub(positions.start)? + first;
            let is_there = positions.contains(&position);
            is_there.then(|| format!("{kind} {number} of {}", layer.name))
        })
    }

    /// The part of the map that an edge is of, in words: its feature, and whether it is a hole or a line; of a layer
    /// without features the edge by its number. `None`, if there are neither features nor layers.
    ///
    /// ```
    /// use sweep_cdt_formats::{Format, Input, Source, read};
    ///
    /// let text = "POINT (5 5) POLYGON ((0 0, 4 0, 0 4, 0 0), (1 1, 2 1, 1 2, 1 1)) LINESTRING (0 0, 9 9)";
    /// let Input::Doubles(file) = read(Format::Wkt, &Source::new("a.wkt", text), None)? else {
    ///     unreachable!("no fraction in the file")
    /// };
    /// let parts = [0, 3, 6].map(|edge| file.part_of(edge).unwrap());
    /// assert_eq!(parts, ["the outline of feature 2", "hole 1 of feature 2", "a line of feature 3"]);
    /// # Ok::<(), sweep_cdt_formats::ReadError>(())
    /// ```
    pub fn part_of(&self, edge: usize) -> Option<String> {
        let of_file = self.pieces_of.get(edge).copied().unwrap_or(edge);
        let mut layers = self.layers.iter();
        let layer = layers.find(|layer| layer.edges.contains(&of_file));
        let part = match (self.edge_features.get(edge), layer) {
            (Some(&feature), _) if feature > 0 => {
                let before = layer.map_or(0, |layer| layer.features.start);
                self.part_of_feature(edge, (feature as usize).saturating_sub(before))
            }
            (_, Some(layer)) => {
                let number = of_file - layer.edges.start + layer.numbering.edge;
                format!("edge {number}")
            }
            (_, None) => return None,
        };
        Some(match layer {
            Some(layer) => format!("{part} of {}", layer.name),
            None => part,
        })
    }

    /// The part of a feature of this number that an edge is of.
    fn part_of_feature(&self, edge: usize, feature: usize) -> String {
        let ring = self.polygons.ring_of.get(edge).copied().flatten();
        let Some(ring) = ring else {
            return format!("a line of feature {feature}");
        };
        // The rings of a polygon follow each other, the outline first.
        let rings = &self.polygons.rings;
        let outline = rings.partition_point(|other| other.polygon < rings[ring].polygon);
        match ring.saturating_sub(outline) {
            0 => format!("the outline of feature {feature}"),
            hole => format!("hole {hole} of feature {feature}"),
        }
    }

    /// An error of [`split`](sweep_cdt::crossings::split) or [`crossings`](sweep_cdt::crossings::crossings()) with
    /// vertices and edges numbered as in the file.
    pub fn split_as_numbered(&self, error: SplitError) -> SplitError {
        let Numbering { vertex, edge, .. } = self.numbering;
        error.renumbered(|v| v.saturating_add(vertex), |e| e.saturating_add(edge))
    }

    /// An error of a domain with its vertices, edges, holes and regions numbered as in the file.
    ///
    /// ```
    /// use sweep_cdt::interior::{InteriorError, Seed};
    /// use sweep_cdt_formats::{GraphFile, Numbering};
    ///
    /// let file = GraphFile::<f64> { numbering: Numbering::FROM_ONE, ..GraphFile::default() };
    /// let error = InteriorError::SeedOutside { seed: Seed::Hole(0) };
    /// let error = file.interior_as_numbered(error);
    /// assert_eq!(error.to_string(), "the seed of hole 1 lies outside of the hull");
    /// ```
    pub fn interior_as_numbered(&self, error: InteriorError) -> InteriorError {
        let first = self.numbering;
        error.renumbered(
            |vertex| vertex.saturating_add(first.vertex),
            |edge| edge.saturating_add(first.edge),
            |hole| hole.saturating_add(first.hole),
            |region| region.saturating_add(first.region),
        )
    }
}
