//! A triangulation with heights: the surface that is flat in each triangle.
//!
//! A triangle belongs to the surface if it is inside and all its corners have heights. Equal points are one vertex, the
//! first of them; if that has no height, it takes the first that another of them has.

use sweep_cdt::interior::Interior;

/// A terrain: the triangles inside a domain of a triangulation, and a height for each vertex.
///
/// ```
/// use sweep_cdt::interior::Interior;
/// use sweep_cdt_terrain::Surface;
///
/// let points = [[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [2.0, 2.0]];
/// let result = sweep_cdt::triangulate(&points, &[[0, 3]])?;
/// let whole = Interior::whole(&result);
/// let surface = Surface::new(&points, &whole, &[0.0, 1.0, f64::NAN, 2.0]);
/// assert_eq!(surface.missing(), 1);
/// assert_eq!(surface.range(), Some([0.0, 2.0]));
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
#[derive(Debug)]
pub struct Surface<'a, S> {
    pub(crate) points: &'a [[S; 2]],
    pub(crate) interior: &'a Interior<'a>,
    /// The height of each vertex, NaN where it is missing.
    pub(crate) heights: Vec<f64>,
}

impl<'a, S> Surface<'a, S> {
    /// The surface over `interior`, which is a domain of a triangulation of `points`. A height that is not finite, or
    /// not given, is missing.
    #[must_use]
    pub fn new(
        points: &'a [[S; 2]],
        interior: &'a Interior<'a>,
        heights: &[f64],
    ) -> Surface<'a, S> {
        let known = |v: usize| heights.get(v).copied().filter(|height| height.is_finite());
        let height = |v| known(v).unwrap_or(f64::NAN);
        let mut heights: Vec<f64> = (0..points.len()).map(height).collect();
        for [duplicate, first] in interior.triangulation().duplicates() {
            if heights[first].is_nan() {
                heights[first] = heights[duplicate];
            }
        }
        Surface {
            points,
            interior,
            heights,
        }
    }

    /// How many triangles inside have a corner without a height.
    #[must_use]
    pub fn missing(&self) -> usize {
        let inside = self.interior.inside();
        inside.filter(|&t| self.triangle(t).is_none()).count()
    }

    /// The lowest and the highest height of the triangles, if there are any.
    #[must_use]
    pub fn range(&self) -> Option<[f64; 2]> {
        let triangles = self.triangles();
        let heights = triangles.flat_map(|(_, corners)| corners.map(|v| self.heights[v]));
        heights.fold(None, |range, height| {
            let [low, high] = range.unwrap_or([height; 2]);
            Some([low.min(height), high.max(height)])
        })
    }

    /// The corners of a triangle of the triangulation, if it belongs to the surface.
    pub(crate) fn triangle(&self, t: usize) -> Option<[usize; 3]> {
        let corners = self.interior.triangulation().triangle(t);
        let is_known = corners.iter().all(|&v| !self.heights[v].is_nan());
        (is_known && self.interior.is_inside(t)).then_some(corners)
    }

    /// The triangles of the surface, with their corners.
    pub(crate) fn triangles(&self) -> impl Iterator<Item = (usize, [usize; 3])> {
        let inside = self.interior.inside();
        inside.filter_map(|t| Some((t, self.triangle(t)?)))
    }

    /// The triangle of the surface across a side, opposite this corner.
    pub(crate) fn across(&self, t: usize, side: usize) -> Option<usize> {
        let across = self.interior.triangulation().neighbor(t, side)?;
        self.triangle(across).map(|_| across)
    }
}
