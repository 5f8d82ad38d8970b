//! Vertices of a result that stand in no file, as a program has them in memory.

use std::borrow::Cow;

use crate::Coordinate;
use crate::read::matching::matched::Matched;
use crate::read::matching::refusal::ResultError;
use crate::read::matching::written::{Precision, Written};
use crate::read::matching::{Matching, added};

/// Vertices of a result that stand in no file, numbered from 0.
///
/// ```
/// use sweep_cdt_formats::{Listed, Matched, Matching, Precision};
///
/// let input = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
/// let points = [[0.0, 1.0], [0.0, 0.0], [1.0, 0.0]];
/// let listed = Listed { points: &points, precision: Precision::Digits, is_soup: false };
/// let (matched, places) = listed.places(Matching::new(), &input)?;
/// assert_eq!((matched, places), (Matched::Equal, Some(vec![2, 0, 1])));
/// # Ok::<(), sweep_cdt_formats::ResultError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Listed<'a, S> {
    /// The vertices.
    pub points: &'a [[S; 2]],
    /// How precise their coordinates are. Digits are those of the shortest text of a double.
    pub precision: Precision,
    /// Whether they are the corners of triangles that are coordinates, and have no numbers.
    pub is_soup: bool,
}

impl<S: Coordinate> Listed<'_, S> {
    /// How they match the vertices of an input, and for each of them its place there, unless it is that of its number.
    ///
    /// # Errors
    /// See [`ResultError`]. The name of the file is empty.
    pub fn places(
        &self,
        matching: Matching,
        input: &[[S; 2]],
    ) -> Result<(Matched, Option<Vec<usize>>), ResultError> {
        matching.places(self, self.is_soup, self.points, input, 0)
    }

    /// The points that an input lacks, as [`added_points`](crate::added_points) has them.
    ///
    /// # Errors
    /// See [`ResultError`]. The name of the file is empty.
    pub fn added(&self, input: &[[S; 2]]) -> Result<Vec<[S; 2]>, ResultError> {
        added(self, self.points, input)
    }
}

impl<S: Coordinate> Written for Listed<'_, S> {
    fn text(&self, vertex: usize, axis: usize) -> Cow<'_, str> {
        format!("{:e}", self.points[vertex][axis].approx()).into()
    }

    fn decimals(&self, vertex: usize, axis: usize) -> Option<usize> {
        let text = self.points[vertex][axis].approx().to_string();
        let decimals = text.split_once('.').map_or("", |(_, decimals)| decimals);
        (self.precision == Precision::Digits).then_some(decimals.len())
    }

    fn precision(&self) -> Precision {
        self.precision
    }
}
