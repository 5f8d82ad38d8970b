//! Reading a result of any program: its triangles, and which vertices of the input they name.

use std::collections::HashSet;

use crate::read::content::{Corners, Labels, Vertices};
use crate::read::matching::matched::Matched;
use crate::read::matching::refusal::ResultError;
use crate::read::matching::{self, Matching};
use crate::read::numpy::Arrays;
use crate::read::shapes::{geojson, wkt};
use crate::read::source::{ReadError, Source};
use crate::read::vtu::Unpacked;
use crate::read::{json, obj, off, triangle};
use crate::read::{msh, ply, stl, vtk};
use crate::{Coordinate, CoordinateError, Format, GraphFile};
use sweep_cdt::Pslg;
use sweep_cdt::verify::{Offenders, Violation};

/// Reads a file, and makes something of its triangles.
fn read_triangles<T>(
    format: Format,
    source: &Source,
    node: Option<&Source>,
    make: impl FnOnce(Corners<'_>) -> Result<T, ResultError>,
) -> Result<T, ResultError> {
    let corners = match format {
        Format::Ele => triangle::read_ele(source, node)?,
        Format::Json => match json::read_triangles(source) {
            Err(_) if geojson::is_in(source) => geojson::read(source)?.into_triangles()?,
            corners => corners?,
        },
        Format::Obj => obj::read(source)?.into_triangles()?,
        Format::Off => off::read(source)?.into_triangles()?,
        Format::Ply => ply::read(source)?.into_triangles()?,
        Format::Vtk => vtk::read(source)?.into_triangles()?,
        Format::Vtu | Format::Vtp => {
            let unpacked = Unpacked::of(source)?;
            return make(unpacked.mesh()?.into_triangles()?);
        }
        Format::Msh => msh::read(source)?.into_triangles()?,
        Format::Stl => stl::read(source)?,
        Format::Geojson => geojson::read(source)?.into_triangles()?,
        Format::Wkt => wkt::read(source)?.into_triangles()?,
        Format::Npy => return make(Arrays::of_triangles(source)?.triangles()?),
        Format::Npz => return make(Arrays::of_archive(source)?.triangles()?),
        _ => {
            let error = ReadError::of_file(&source.name, format.lacks("triangulation"));
            return Err(error.into());
        }
    };
    make(corners)
}

/// Triangles of a file, by vertices of the input.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Triangles {
    /// The corners, as positions in the input's points. Those that are no vertices of the input follow:
    /// `points.len() + i` stands for `strangers[i]`.
    pub list: Vec<[usize; 3]>,
    /// The file's number of the first triangle.
    pub first: usize,
    /// The file's numbers of corners that are no vertices of the input.
    pub strangers: Vec<usize>,
    /// How vertices were matched with those of the input.
    pub matched: Matched,
    /// The attribute of each triangle's region, where the file has them: in a `.ele` the first attribute. NaN stands
    /// for a region that the input lacks.
    pub attributes: Option<Vec<f64>>,
}

/// Reads a triangulation of `input` in one of [`Format::RESULTS`]; `node` is the `.node` beside a `.ele`.
///
/// Vertices are matched as [`Matching::new`] does it: by coordinates, if every vertex of the file is one of
/// the input, exactly; by number, if the file has no coordinates, or as many vertices as the input, and each
/// coordinate is that of the input rounded to 6 or more digits. All else is refused. Corners may be
/// out of range: the verifier reports them.
///
/// ```
/// use sweep_cdt::Pslg;
/// use sweep_cdt_formats::{Format, Matched, Source, read_result};
///
/// let points = vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
/// let input = Pslg { points, ..Pslg::default() }.into();
/// let bytes = b"v 0 1 0\nv 0 0 0\nv 1 0 0\nf 1 2 3".to_vec();
/// let source = Source::new("example", bytes);
/// let triangles = read_result(Format::Obj, &source, None, &input)?;
/// assert_eq!(triangles.list, [[2, 0, 1]]);
/// assert_eq!(triangles.matched, Matched::Equal);
/// # Ok::<(), sweep_cdt_formats::ResultError>(())
/// ```
///
/// # Errors
/// See [`ResultError`].
pub fn read_result<S: Coordinate>(
    format: Format,
    source: &Source,
    node: Option<&Source>,
    input: &GraphFile<S>,
) -> Result<Triangles, ResultError> {
    Matching::new().read(format, source, node, input)
}

impl Matching {
    /// Reads a triangulation of `input`; `node` is the `.node` beside a `.ele`.
    ///
    /// ```
    /// use sweep_cdt::Pslg;
    /// use sweep_cdt_formats::{Format, Matched, Matching, Source};
    ///
    /// let points = vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    /// let input = Pslg { points, ..Pslg::default() }.into();
    /// let bytes = b"v 0.25 0\nv 1 0\nv 0 1\nf 1 2 3".to_vec();
    /// let source = Source::new("example", bytes);
    /// let matching = Matching::new().tolerance(0.5);
    /// let triangles = matching.read(Format::Obj, &source, None, &input)?;
    /// assert_eq!(triangles.matched, Matched::Near { difference: 0.25 });
    /// # Ok::<(), sweep_cdt_formats::ResultError>(())
    /// ```
    ///
    /// # Errors
    /// See [`ResultError`].
    pub fn read<S: Coordinate>(
        self,
        format: Format,
        source: &Source,
        node: Option<&Source>,
        input: &GraphFile<S>,
    ) -> Result<Triangles, ResultError> {
        read_triangles(format, source, node, |corners| {
            let (matched, places) = match &corners.vertices {
                Some(vertices) => {
                    let points = points_of(vertices)?;
                    let own = &input.graph.points;
                    let first = input.numbering.vertex;
                    self.places(vertices, corners.is_soup, &points, own, first)?
                }
                None => (Matched::Unplaced, None),
            };
            let places = places.as_deref();
            Ok(by_input_vertices(corners, matched, places, &input.graph))
        })
    }
}

/// The vertices of a triangulation that `input` lacks, in the order of the file; none, if it has no coordinates.
///
/// With them among its points the input has all vertices of the file, and [`read_result`] matches them by coordinates;
/// [`Verifier::added_from`](sweep_cdt::verify::Verifier::added_from) allows for them.
///
/// ```
/// use sweep_cdt::Pslg;
/// use sweep_cdt_formats::{Format, Source, added_points};
///
/// let points = vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
/// let input = Pslg { points, ..Pslg::default() }.into();
/// let bytes = b"v 0 1\nv 0 0\nv 1 0\nv 0.5 0.5\nf 1 2 4\nf 2 3 4".to_vec();
/// let source = Source::new("example", bytes);
/// assert_eq!(added_points(Format::Obj, &source, None, &input)?, [[0.5, 0.5]]);
/// # Ok::<(), sweep_cdt_formats::ResultError>(())
/// ```
///
/// # Errors
/// See [`ResultError`].
pub fn added_points<S: Coordinate>(
    format: Format,
    source: &Source,
    node: Option<&Source>,
    input: &GraphFile<S>,
) -> Result<Vec<[S; 2]>, ResultError> {
    read_triangles(format, source, node, |corners| match corners.vertices {
        Some(vertices) => matching::added(&vertices, &points_of(&vertices)?, &input.graph.points),
        None => Ok(Vec::new()),
    })
}

/// The vertices of a file, in the type of the input's.
fn points_of<S: Coordinate>(vertices: &Vertices<'_>) -> Result<Vec<[S; 2]>, ReadError> {
    vertices.points().map_err(|(why, error)| match why {
        CoordinateError::Fraction => ReadError::of_file(
            &vertices.source.name,
            "has fractions, and the input is read as doubles (--scalar rational reads both exactly)",
        ),
        _ => error,
    })
}

/// The triangles by vertices of the input; `places` has those of the file's vertices, unless each stands in
/// the place of its number.
fn by_input_vertices<S>(
    corners: Corners<'_>,
    matched: Matched,
    places: Option<&[usize]>,
    input: &Pslg<S>,
) -> Triangles {
    let count = input.points.len();
    // A corner becomes a position in the input; one that has none becomes a stranger.
    let mut strangers = Vec::new();
    let mut vertex = |number: usize| {
        let listed = number.checked_sub(corners.first_vertex);
        let place = listed.and_then(|at| match places {
            Some(places) => places.get(at).copied(),
            None => Some(at).filter(|&at| at < count),
        });
        place.unwrap_or_else(|| {
            strangers.push(number);
            count + strangers.len() - 1
        })
    };
    let attribute = |position: Option<usize>| match position {
        Some(region) => (input.regions.get(region)).map_or(f64::NAN, |region| region.attribute),
        None => 0.0,
    };
    let attributes = match corners.labels {
        Labels::Nothing => None,
        Labels::Attributes(attributes) => Some(attributes),
        Labels::Positions(positions) => Some(positions.into_iter().map(attribute).collect()),
    };
    let triangles = corners.triangles.into_iter();
    Triangles {
        list: triangles
            .map(|triangle| triangle.map(&mut vertex))
            .collect(),
        first: corners.first,
        strangers,
        matched,
        attributes,
    }
}

impl Triangles {
    /// The vertices of the input that a violation is about: those that it names, then the corners of its
    /// triangles and the ends of its edges, each once.
    pub fn vertices_of<S>(&self, input: &Pslg<S>, violation: Violation) -> Vec<usize> {
        let Offenders {
            mut vertices,
            edges,
            triangles,
            ..
        } = violation.offenders();
        vertices.extend(triangles.into_iter().flat_map(|t| self.list[t]));
        vertices.extend(edges.into_iter().flat_map(|e| input.edges[e]));
        let mut seen = HashSet::new();
        vertices.retain(|&v| v < input.points.len() && seen.insert(v));
        vertices
    }

    /// A violation with all things numbered as in their files.
    pub fn as_numbered<S>(&self, input: &GraphFile<S>, violation: Violation) -> Violation {
        let names_end = matches!(violation, Violation::EdgeOutOfRange { .. });
        let vertex_number = |vertex: usize| {
            let stranger = vertex
                .checked_sub(input.graph.points.len())
                .filter(|_| !names_end);
            stranger.map_or(vertex.saturating_add(input.numbering.vertex), |at| {
                self.strangers[at]
            })
        };
        violation.renumbered(
            vertex_number,
            |edge| edge + input.numbering.edge,
            |triangle| triangle + self.first,
        )
    }
}
