//! A planar straight-line graph as it stands in a file: the graph, and what else the file says of it.

use sweep_cdt::Pslg;
use sweep_cdt::scalar::Scalar;

use crate::doubts::{Conflicts, Voids};
use crate::order::{order, sorted};
use crate::{CoordinateSystem, Layer, Numbering, Polygons, Properties, Remark};

/// A graph, all in the order of its file, and what the file says beyond it.
#[derive(Clone, Debug, PartialEq)]
pub struct GraphFile<S> {
    /// The vertices, the edges, and the seeds of holes and regions.
    pub graph: Pslg<S>,
    /// Further columns of the vertices: heights, for instance.
    pub columns: Vec<Column>,
    /// The greatest area that the file allows for a triangle of each region, infinite where it names none; empty, if it
    /// names none at all. They count where a mesh is refined: see [`GraphFile::without_areas`].
    pub region_areas: Vec<f64>,
    /// For each edge the edge of the file that it is a piece of, in order, where edges were
    /// [split](sweep_cdt::crossings::split) at their crossings. Empty, if they are those of the file.
    pub pieces_of: Vec<usize>,
    /// The marker of each edge, 0 where it has none; empty, if no edge has one. Markers of vertices are the column
    /// [`Column::MARKER`].
    pub edge_markers: Vec<i64>,
    /// Whose border each edge is.
    pub polygons: Polygons,
    /// The feature of each edge, counted from 1 as in [`Polygons::features`], 0 where it has none; empty, if the format has
    /// no features.
    pub edge_features: Vec<u32>,
    /// How many features there are; 0, if the format has none.
    pub features: usize,
    /// The properties of the features that have polygons: see [`GraphFile::without_properties`].
    pub properties: Properties,
    /// The faces of a mesh. They are no part of the graph: see [`GraphFile::with_faces`].
    pub faces: Faces,
    /// The coordinate system, if the file names one.
    pub system: Option<CoordinateSystem>,
    /// How many positions of the file are equal to a vertex before them, where it has positions and no vertices.
    pub merged: usize,
    /// What the reader has to say.
    pub remarks: Vec<Remark>,
    /// The numbers that the file gives to all of them.
    pub numbering: Numbering,
    /// The files that were put together ([`GraphFile::of_layers`]); empty, if it is one file.
    pub layers: Vec<Layer>,
}

/// Numbers that go with the vertices of a [`GraphFile`] and change nothing: one for each.
///
/// ```
/// use sweep_cdt_formats::{Format, Input, Source, read};
///
/// let bytes = b"2 2 1 0\n1 0 0 812.5\n2 1 0.5 790\n".to_vec();
/// let source = Source::new("hill.node", bytes);
/// let Input::Doubles(file) = read(Format::Node, &source, None)? else {
///     unreachable!("no fraction in the file")
/// };
/// assert_eq!(file.columns[0].name, "z");
/// assert_eq!(file.columns[0].values, [812.5, 790.0]);
/// # Ok::<(), sweep_cdt_formats::ReadError>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Column {
    /// The name in the file; `z` are the heights.
    pub name: String,
    /// The number of each vertex; NaN where it is missing.
    pub values: Vec<f64>,
}

impl PartialEq for Column {
    /// Equal columns have the same name and values; missing numbers are equal.
    fn eq(&self, other: &Column) -> bool {
        let is_same = |(x, y): (&f64, &f64)| x == y || x.is_nan() && y.is_nan();
        self.name == other.name
            && self.values.len() == other.values.len()
            && self.values.iter().zip(&other.values).all(is_same)
    }
}

impl Column {
    /// The name of the heights.
    pub const HEIGHT: &str = "z";
    /// The name of the markers of vertices, which are whole numbers, as Triangle and Gmsh have them.
    pub const MARKER: &str = "marker";

    /// The column of these heights.
    pub fn heights(values: Vec<f64>) -> Column {
        Column {
            name: Column::HEIGHT.to_owned(),
            values,
        }
    }

    /// How many vertices have no number.
    pub fn missing(&self) -> usize {
        self.values.iter().filter(|value| value.is_nan()).count()
    }

    /// The column of so many vertices, each with the first number that is given for it, and the first vertex with two.
    #[must_use]
    pub fn gathered(
        &self,
        vertices: usize,
        values: impl Iterator<Item = (usize, f64)>,
    ) -> (Column, Option<Remark>) {
        let mut gathered = vec![f64::NAN; vertices];
        let mut conflicts = Conflicts::new(vertices);
        for (vertex, value) in values.filter(|(_, value)| !value.is_nan()) {
            let kept = &mut gathered[vertex];
            if kept.is_nan() {
                *kept = value;
            } else if (*kept - value).abs() > 0.0 {
                conflicts.add(vertex, [*kept, value]);
            }
        }
        let column = Column {
            name: self.name.clone(),
            values: gathered,
        };
        let conflict = conflicts.remark(&column.name);
        (column, conflict)
    }

    /// The number of a vertex, NaN where there is none.
    pub(crate) fn of(&self, vertex: usize) -> f64 {
        self.values.get(vertex).copied().unwrap_or(f64::NAN)
    }
}

/// The faces of a mesh, corners as positions of vertices: all that the file names, even where there is no such vertex.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Faces {
    /// The triangles.
    pub triangles: Vec<[usize; 3]>,
    /// The faces of more corners.
    pub others: Vec<Vec<usize>>,
}

impl Faces {
    /// How many there are.
    pub fn len(&self) -> usize {
        self.triangles.len() + self.others.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The corners of each face.
    pub fn iter(&self) -> impl Iterator<Item = &[usize]> {
        let triangles = self.triangles.iter().map(|face| &face[..]);
        triangles.chain(self.others.iter().map(Vec::as_slice))
    }
}

impl<S> From<Pslg<S>> for GraphFile<S> {
    /// The graph of a file that counts from 0 and has no columns.
    fn from(graph: Pslg<S>) -> GraphFile<S> {
        GraphFile {
            graph,
            columns: Vec::new(),
            region_areas: Vec::new(),
            pieces_of: Vec::new(),
            edge_markers: Vec::new(),
            polygons: Polygons::default(),
            edge_features: Vec::new(),
            features: 0,
            properties: Properties::default(),
            faces: Faces::default(),
            system: None,
            merged: 0,
            remarks: Vec::new(),
            numbering: Numbering::default(),
            layers: Vec::new(),
        }
    }
}

impl<S> Default for GraphFile<S> {
    fn default() -> GraphFile<S> {
        Pslg::default().into()
    }
}

impl<S> GraphFile<S> {
    /// The columns that are neither heights nor markers.
    pub(crate) fn other_columns(&self) -> impl Iterator<Item = &Column> {
        let columns = self.columns.iter();
        columns.filter(|column| ![Column::HEIGHT, Column::MARKER].contains(&&column.name[..]))
    }

    /// The markers of the vertices, if there are any, and all are whole numbers; missing ones are 0.
    pub fn vertex_markers(&self) -> Option<Vec<i64>> {
        let mut columns = self.columns.iter();
        let column = columns.find(|column| column.name == Column::MARKER)?;
        let markers = (0..self.graph.points.len()).map(|v| whole(column.of(v)));
        markers.collect()
    }

    /// The heights, if there are any.
    pub fn heights(&self) -> Option<&Column> {
        let mut columns = self.columns.iter();
        columns.find(|column| column.name == Column::HEIGHT)
    }

    /// The vertices that equal one before them, each with the first such vertex.
    ///
    /// ```
    /// use sweep_cdt::Pslg;
    /// use sweep_cdt_formats::GraphFile;
    ///
    /// let points = vec![[0.0, 0.0], [1.0, 0.0], [-0.0, 0.0]];
    /// let file = GraphFile::from(Pslg { points, ..Pslg::default() });
    /// assert_eq!(file.duplicates(), [[2, 0]]);
    /// ```
    pub fn duplicates(&self) -> Vec<[usize; 2]>
    where
        S: Scalar,
    {
        let points = &self.graph.points;
        let sorted = sorted(points);
        let is_equal = |(near, v): &([f64; 2], usize), (next, w): &([f64; 2], usize)| {
            order((near, &points[*v]), (next, &points[*w])).is_eq()
        };
        let runs = sorted.chunk_by(is_equal);
        let others = runs.flat_map(|run| run[1..].iter().map(move |&(_, v)| [v, run[0].1]));
        others.collect()
    }

    /// The file, where equal vertices share their numbers in columns: each that misses one takes that of an equal vertex.
    /// `duplicates` are those of its [`Triangulation`](sweep_cdt::Triangulation::duplicates). Two vertices of one place
    /// that have different numbers keep them, and a remark names the first ones. Markers are not shared. `None`, if
    /// nothing changes.
    ///
    /// ```
    /// use sweep_cdt::Pslg;
    /// use sweep_cdt_formats::{Column, GraphFile};
    ///
    /// let graph = Pslg { points: vec![[0, 0], [1, 0], [0, 0]], ..Pslg::default() };
    /// let heights = Column { name: Column::HEIGHT.to_owned(), values: vec![f64::NAN, 2.0, 7.0] };
    /// let file = GraphFile { columns: vec![heights], ..graph.into() };
    /// let shared = file.sharing(&[[2, 0]]).unwrap();
    /// assert_eq!(shared.columns[0].values, [7.0, 2.0, 7.0]);
    /// ```
    pub fn sharing(&self, duplicates: &[[usize; 2]]) -> Option<GraphFile<S>>
    where
        S: Clone,
    {
        if duplicates.is_empty() || self.columns.is_empty() {
            return None;
        }
        let mut shared = self.clone();
        let is_shared = |column: &&mut Column| column.name != Column::MARKER;
        for column in shared.columns.iter_mut().filter(is_shared) {
            column.values.resize(self.graph.points.len(), f64::NAN);
            let same = duplicates
                .iter()
                .flat_map(|&[v, first]| [(first, first), (first, v)]);
            let values = same.map(|(first, v)| (first, column.of(v)));
            let (gathered, conflict) = column.gathered(column.values.len(), values);
            for &[v, first] in duplicates {
                for vertex in [v, first] {
                    if column.values[vertex].is_nan() {
                        column.values[vertex] = gathered.values[first];
                    }
                }
            }
            shared.remarks.extend(conflict);
        }
        (shared.columns != self.columns || shared.remarks.len() > self.remarks.len())
            .then_some(shared)
    }

    /// The graph with the sides of all faces for edges, and each face as a polygon.
    ///
    /// # Errors
    /// The first corner that is no vertex, as a position.
    ///
    /// ```
    /// use sweep_cdt_formats::{Format, Input, Source, read};
    ///
    /// // An L, as one face of six corners.
    /// let text = "v 0 0\nv 4 0\nv 4 1\nv 1 1\nv 1 4\nv 0 4\nf 1 2 3 4 5 6\n";
    /// let Input::Doubles(file) = read(Format::Obj, &Source::new("l.obj", text), None)? else {
    ///     unreachable!("no fraction in the file")
    /// };
    /// assert!(file.graph.edges.is_empty());
    /// let file = file.with_faces().unwrap();
    /// let result = sweep_cdt::triangulate(&file.graph.points, &file.graph.edges)?;
    /// assert_eq!(file.polygons.interior(&result)?.inside().len(), 4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn with_faces(mut self) -> Result<GraphFile<S>, usize> {
        let (faces, edges) = (std::mem::take(&mut self.faces), &mut self.graph.edges);
        self.features = self.features.max(faces.len());
        let polygons = &mut self.polygons;
        polygons.ring_of.resize(edges.len(), None);
        for (feature, face) in (1..).zip(faces.iter()) {
            if let Some(&corner) = face.iter().find(|&&v| v >= self.graph.points.len()) {
                return Err(corner);
            }
            polygons.begin(feature);
            let ring = polygons.add_ring(false);
            edges.extend(face.windows(2).map(|pair| [pair[0], pair[1]]));
            edges.extend(face.last().map(|&last| [last, face[0]]));
            polygons.ring_of.resize(edges.len(), Some(ring));
        }
        if !self.edge_markers.is_empty() {
            self.edge_markers.resize(edges.len(), 0);
        }
        Ok(self)
    }

    /// The file without the faces of a mesh, and a remark on them.
    #[must_use]
    pub fn without_faces(mut self) -> GraphFile<S> {
        let count = std::mem::take(&mut self.faces).len();
        self.remarks
            .extend((count > 0).then_some(Remark::Faces { count }));
        self
    }

    /// The file without the properties of its features, and remarks on them: for what has no triangles to give them to.
    #[must_use]
    pub fn without_properties(mut self) -> GraphFile<S> {
        let ignored = std::mem::take(&mut self.properties).ignored();
        let is_ignored = |remark: &Remark| matches!(remark, Remark::Ignored { .. });
        // Remarks of one kind stay together.
        let place = self.remarks.iter().rposition(is_ignored);
        let place = place.map_or(self.remarks.len(), |place| place + 1);
        self.remarks.splice(place..place, ignored);
        self
    }

    /// The file without the greatest areas of its regions, and a remark on them.
    #[must_use]
    pub fn without_areas(mut self) -> GraphFile<S> {
        let areas = std::mem::take(&mut self.region_areas);
        let count = areas.iter().filter(|area| area.is_finite()).count();
        let remark = || Remark::ignored(count, "area of a region", "areas of regions");
        self.remarks.extend((count > 0).then(remark));
        self
    }

    /// The file where this number in a column of the vertices means that there is none, and a remark on how many do.
    /// Markers keep theirs.
    ///
    /// ```
    /// use sweep_cdt_formats::{Column, GraphFile};
    ///
    /// let columns = vec![Column::heights(vec![7.0, -9999.0])];
    /// let file = GraphFile::<f64> { columns, ..GraphFile::default() }.without_value(-9999.0);
    /// assert_eq!(file.heights().unwrap().missing(), 1);
    /// assert_eq!(file.remarks[0].to_string(), "1 number is -9999 and counted as missing");
    /// ```
    #[must_use]
    pub fn without_value(mut self, value: f64) -> GraphFile<S> {
        let columns = self.columns.iter_mut();
        let numbers = columns.filter(|column| column.name != Column::MARKER);
        let numbers = numbers.flat_map(|column| &mut column.values);
        let means_none = numbers.filter(|number| (**number - value).abs() == 0.0);
        let count = means_none.map(|number| *number = f64::NAN).count();
        let remark = Remark::NoValue { value, count };
        let has_columns = !self.columns.is_empty();
        self.remarks.extend(has_columns.then_some(remark));
        self
    }

    /// The file, and remarks on the numbers among its heights that programs often write where there is none ([`Voids`]).
    ///
    /// ```
    /// use sweep_cdt_formats::{Column, GraphFile};
    ///
    /// let columns = vec![Column::heights(vec![7.0, -9999.0])];
    /// let file = GraphFile::<f64> { columns, ..GraphFile::default() }.with_voids_said();
    /// assert_eq!(file.remarks[0].to_string(), "1 height is -9999, which often means that there is none");
    /// ```
    #[must_use]
    pub fn with_voids_said(mut self) -> GraphFile<S> {
        let heights = self.heights().map_or(&[][..], |column| &column.values);
        let mut voids = Voids::default();
        heights.iter().for_each(|&height| voids.add(height));
        self.remarks.extend(voids.remarks());
        self
    }
}

/// A number as a marker, if it is a whole one that doubles hold exactly; missing ones are 0.
#[expect(
    clippy::cast_possible_truncation,
    reason = "only whole numbers are cast"
)]
pub(crate) fn whole(number: f64) -> Option<i64> {
    const LARGEST: f64 = (1_u64 << 53) as f64;
    let is_whole = number.fract() == 0.0 && number.abs() <= LARGEST;
    (is_whole || number.is_nan()).then_some(number as i64)
}

/// Pairs of vertices, sorted, with the lower vertex of each pair first.
pub fn sorted_pairs(pairs: impl Iterator<Item = [usize; 2]>) -> Vec<[usize; 2]> {
    let mut sorted: Vec<[usize; 2]> = pairs.map(|[a, b]| [a.min(b), a.max(b)]).collect();
    sorted.sort_unstable();
    sorted
}
