//! Vertices without a height, where others have one: what stands in its place.

use std::fmt;
use std::str::FromStr;

use sweep_cdt::crossings::Exact;
use sweep_cdt::interior::Interior;
use sweep_cdt::{Error, Pslg, triangulate};
use sweep_cdt_formats::{Column, Coordinate, GraphFile, Remark};
use sweep_cdt_terrain::Surface;

/// What stands in place of a missing height.
///
/// ```
/// use sweep_cdt::Pslg;
/// use sweep_cdt_engine::Missing;
/// use sweep_cdt_formats::{Column, GraphFile};
///
/// let points = vec![[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [1.0, 1.0]];
/// let columns = vec![Column::heights(vec![1.0, 5.0, 9.0, f64::NAN])];
/// let mut file = GraphFile { columns, ..Pslg { points, ..Pslg::default() }.into() };
/// let remark = Missing::Interpolate.fill(&mut file)?;
/// assert_eq!(file.columns[0].values[3], 4.0);
/// assert_eq!(remark.unwrap().to_string(), "1 height is interpolated");
/// assert_eq!("-7.5".parse(), Ok(Missing::Value(-7.5)));
/// # Ok::<(), sweep_cdt_engine::MissingError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Missing {
    /// Every vertex without a height gets this one.
    Value(f64),
    /// The height in the triangulation of the vertices that have heights, with the edges between them; outside of their
    /// hull there is none.
    Interpolate,
    /// Nothing: such a file is refused.
    Refuse,
}

/// Why heights are not filled in. Vertices are positions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MissingError {
    /// A vertex has no height.
    Refused {
        /// The first one.
        vertex: usize,
        /// How many others have none.
        others: usize,
    },
    /// The vertices with heights have no triangulation.
    NotTriangulated(Error),
}

impl fmt::Display for MissingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            MissingError::Refused { vertex, others } => {
                write!(
                    f,
                    "vertex {vertex} has no height, and {others} others have none"
                )
            }
            MissingError::NotTriangulated(error) => {
                write!(f, "heights cannot be interpolated: {error}")
            }
        }
    }
}

impl std::error::Error for MissingError {}

impl FromStr for Missing {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Missing, &'static str> {
        match text {
            "interpolate" => Ok(Missing::Interpolate),
            "refuse" => Ok(Missing::Refuse),
            _ => {
                let value = text.parse().ok().filter(|value: &f64| value.is_finite());
                value
                    .map(Missing::Value)
                    .ok_or("it is a number, interpolate or refuse")
            }
        }
    }
}

impl Missing {
    /// Gives a file these heights. Returns the remark on those that are interpolated. A vertex that equals one with a height
    /// has that height.
    ///
    /// # Errors
    /// [`MissingError`]; then nothing has changed.
    pub fn fill<S: Coordinate>(
        self,
        file: &mut GraphFile<S>,
    ) -> Result<Option<Remark>, MissingError> {
        let vertices = file.graph.points.len();
        let mut columns = file.columns.iter();
        let Some(at) = columns.position(|column| column.name == Column::HEIGHT) else {
            return Ok(None);
        };
        let mut heights = file.columns[at].values.clone();
        heights.resize(vertices, f64::NAN);
        if !heights.iter().any(|height| height.is_nan()) {
            return Ok(None);
        }
        if let Some(shared) = file.sharing(&file.duplicates()) {
            heights.clone_from(&shared.columns[at].values);
        }
        let missing: Vec<usize> = (0..vertices).filter(|&v| heights[v].is_nan()).collect();
        let Some(&vertex) = missing.first() else {
            return Ok(None);
        };
        let mut remark = None;
        match self {
            Missing::Refuse => {
                let others = missing.len() - 1;
                return Err(MissingError::Refused { vertex, others });
            }
            Missing::Value(value) => missing.iter().for_each(|&v| heights[v] = value),
            Missing::Interpolate => {
                let places = missing.iter().map(|&v| file.graph.points[v].clone());
                let found = interpolated(&file.graph, &heights, &places.collect::<Vec<_>>())?;
                for (&v, height) in missing.iter().zip(&found) {
                    heights[v] = height.unwrap_or(f64::NAN);
                }
                let outside = found.iter().filter(|height| height.is_none()).count();
                let heights = missing.len() - outside;
                remark = Some(Remark::Interpolated { heights, outside });
            }
        }
        file.columns[at].values = heights;
        Ok(remark)
    }
}

/// The heights of places in the triangulation of the vertices that have heights.
fn interpolated<S: Exact>(
    graph: &Pslg<S>,
    heights: &[f64],
    places: &[[S; 2]],
) -> Result<Vec<Option<f64>>, MissingError> {
    let known: Vec<usize> = (0..graph.points.len())
        .filter(|&v| !heights[v].is_nan())
        .collect();
    let place = |v: usize| known.binary_search(&v).ok();
    let edge = |(number, &[a, b]): (usize, &[usize; 2])| Some((number, [place(a)?, place(b)?]));
    let points: Vec<[S; 2]> = known.iter().map(|&v| graph.points[v].clone()).collect();
    let edges = graph.edges.iter().enumerate().filter_map(edge);
    let (numbers, edges): (Vec<usize>, Vec<[usize; 2]>) = edges.unzip();
    let result = triangulate(&points, &edges);
    let result = result.map_err(|error| {
        MissingError::NotTriangulated(error.renumbered(|v| known[v], |edge| numbers[edge]))
    })?;
    let whole = Interior::whole(&result);
    let known: Vec<f64> = known.iter().map(|&v| heights[v]).collect();
    Ok(Surface::new(&points, &whole, &known).heights_at(places))
}
