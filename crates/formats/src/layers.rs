//! Layers: files that are put together to one graph, as contour lines, a border and breaklines make one terrain.
//!
//! Vertices, edges and seeds of each file follow those of the files before it, and so do their markers, polygons and
//! features. Columns of one name are one column, in which the vertices of a file without it have no number. Equal points
//! stay vertices of their own, each with its row: a triangulation takes them for one, and
//! [`GraphFile::sharing`] has them share their numbers.

use std::ops::Range;

use sweep_cdt::interior::Ring;

use crate::{Column, CoordinateSystem, GraphFile, Layer, ReadError, Remark};

impl<S> GraphFile<S> {
    /// Files as they were read, put together, each with its name in messages. They are numbered as the first one is.
    /// Faces of meshes are left out with a remark; [`GraphFile::with_faces`] comes before. A file without a coordinate
    /// system has that of the others.
    ///
    /// ```
    /// use sweep_cdt_formats::{Format, GraphFile, Input, Source, read};
    ///
    /// let file = |name: &str, text: &str| match read(Format::Wkt, &Source::new(name, text), None) {
    ///     Ok(Input::Doubles(file)) => (name.to_owned(), file),
    ///     _ => unreachable!("the file is right and has no fraction"),
    /// };
    /// let lines = file("lines.wkt", "LINESTRING Z (1 1 7, 2 1 7)");
    /// let border = file("border.wkt", "POINT (5 5) POLYGON ((0 0, 4 0, 0 4, 0 0))");
    /// let whole = GraphFile::of_layers(vec![lines, border])?;
    /// assert_eq!(whole.graph.edges, [[0, 1], [3, 4], [4, 5], [5, 3]]);
    /// assert_eq!(whole.heights().unwrap().missing(), 4);
    /// let parts = [0, 1].map(|edge| whole.part_of(edge).unwrap());
    /// assert_eq!(parts, ["a line of feature 1 of lines.wkt", "the outline of feature 2 of border.wkt"]);
    /// # Ok::<(), sweep_cdt_formats::ReadError>(())
    /// ```
    ///
    /// # Errors
    /// Two files have different coordinate systems.
    pub fn of_layers(files: Vec<(String, GraphFile<S>)>) -> Result<GraphFile<S>, ReadError> {
        let systems = files.iter();
        let system =
            CoordinateSystem::of_all(systems.map(|(name, file)| (&name[..], file.system.clone())))?;
        let mut whole = GraphFile {
            system,
            ..GraphFile::default()
        };
        for (name, file) in files {
            whole.add(name, file.without_faces());
        }
        // Formats without names take the first column for heights.
        let columns = &mut whole.columns;
        columns.sort_by_key(|column| column.name != Column::HEIGHT);
        Ok(whole)
    }

    /// Adds a file behind all others.
    fn add(&mut self, name: String, file: GraphFile<S>) {
        let layer = Layer {
            name,
            numbering: file.numbering,
            vertices: behind(&self.graph.points, &file.graph.points),
            edges: behind(&self.graph.edges, &file.graph.edges),
            holes: behind(&self.graph.holes, &file.graph.holes),
            regions: behind(&self.graph.regions, &file.graph.regions),
            features: self.features..self.features + file.features,
        };
        if self.layers.is_empty() {
            self.numbering = file.numbering;
        }
        let vertices = &layer.vertices;
        let shifted = |v: usize| v + vertices.start;
        for Column { name, values } in file.columns {
            // A file may have columns of one name. One that is full to the end of the layer has its values already.
            let is_it = |own: &Column| own.name == name && own.values.len() <= vertices.start;
            let place = self.columns.iter().position(is_it);
            let place = place.unwrap_or_else(|| {
                let values = Vec::new();
                self.columns.push(Column { name, values });
                self.columns.len() - 1
            });
            join(&mut self.columns[place].values, values, vertices, f64::NAN);
        }
        for column in &mut self.columns {
            column.values.resize(vertices.end, f64::NAN);
        }
        join(
            &mut self.region_areas,
            file.region_areas,
            &layer.regions,
            f64::INFINITY,
        );
        join(&mut self.edge_markers, file.edge_markers, &layer.edges, 0);
        let before = layer.features.start;
        let before_edges = u32::try_from(before).unwrap_or(u32::MAX);
        let feature = |feature: u32| match feature {
            0 => 0,
            feature => feature.saturating_add(before_edges),
        };
        let features = file.edge_features.into_iter().map(feature);
        join(&mut self.edge_features, features, &layer.edges, 0);
        let own = &mut self.polygons;
        let (polygons, rings) = (own.features.len(), own.rings.len());
        let ring_of = file.polygons.ring_of.into_iter();
        let ring_of = ring_of.map(|ring| ring.map(|ring| ring + rings));
        join(&mut own.ring_of, ring_of, &layer.edges, None);
        own.rings
            .extend(file.polygons.rings.into_iter().map(|ring| Ring {
                polygon: ring.polygon + polygons,
                ..ring
            }));
        let features = file.polygons.features.into_iter();
        own.features
            .extend(features.map(|feature| feature + before));
        self.properties.add(file.properties, before);
        self.remarks
            .extend(file.remarks.into_iter().map(|mut remark| {
                if let Remark::Conflict { vertex, .. } = &mut remark {
                    *vertex = shifted(*vertex);
                }
                remark
            }));
        let edges = file.graph.edges.into_iter();
        self.graph.edges.extend(edges.map(|edge| edge.map(shifted)));
        self.graph.points.extend(file.graph.points);
        self.graph.holes.extend(file.graph.holes);
        self.graph.regions.extend(file.graph.regions);
        self.features = layer.features.end;
        self.merged += file.merged;
        self.layers.push(layer);
    }
}

/// The positions of a list behind another one.
fn behind<T>(before: &[T], list: &[T]) -> Range<usize> {
    before.len()..before.len() + list.len()
}

/// Adds the values of a layer, which are for these positions. A list without any value is empty; otherwise `none` stands
/// for those that are missing.
fn join<T: Clone>(
    whole: &mut Vec<T>,
    values: impl IntoIterator<Item = T>,
    positions: &Range<usize>,
    none: T,
) {
    let mut values = values.into_iter().peekable();
    if !whole.is_empty() || values.peek().is_some() {
        whole.resize(positions.start, none.clone());
        whole.extend(values);
        whole.resize(positions.end, none);
    }
}
