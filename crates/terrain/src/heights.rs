//! Heights of points on a surface: where each point lies, and what is interpolated there.
//!
//! Where points lie is decided exactly, all at once (`WithPoints::locate_all`); heights are interpolated in
//! [`crate::interpolate`]. Cost: that of locating, O((n + m) log(n + m)) for n triangles and m points, whatever they are.

use sweep_cdt::Location;
use sweep_cdt::crossings::Exact;

use crate::interpolate::{along, within};
use crate::surface::Surface;

impl<S: Exact> Surface<'_, S> {
    /// The height at each of these points: at a vertex its height, on a side that of the two ends in proportion, in a
    /// triangle that of its corners. `None` outside of the surface, at a point whose coordinates are not finite, and
    /// where a height that counts is missing.
    ///
    /// A height differs from the exact one by less than 1e-11 of the difference between the heights that it comes from,
    /// and its own rounding.
    ///
    /// ```
    /// use sweep_cdt::interior::Interior;
    /// use sweep_cdt_terrain::Surface;
    ///
    /// let points = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]];
    /// let result = sweep_cdt::triangulate(&points, &[])?;
    /// let whole = Interior::whole(&result);
    /// let surface = Surface::new(&points, &whole, &[1.0, 5.0, 9.0]);
    /// let found = surface.heights_at(&[[1.0, 1.0], [2.0, 0.0], [0.0, 4.0], [4.0, 4.0]]);
    /// assert_eq!(found, [Some(4.0), Some(3.0), Some(9.0), None]);
    /// # Ok::<(), sweep_cdt::Error>(())
    /// ```
    #[must_use]
    pub fn heights_at(&self, points: &[[S; 2]]) -> Vec<Option<f64>> {
        let result = self.interior.triangulation();
        let places = result.with_points(self.points).locate_all(points);
        self.heights_of(points, &places)
    }

    /// The heights of points whose places are known: for several surfaces over one triangulation, which locates them once.
    #[must_use]
    pub fn heights_of(&self, points: &[[S; 2]], places: &[Location]) -> Vec<Option<f64>> {
        let result = self.interior.triangulation();
        let is_inside = self.vertices_inside();
        let height = |(point, place): (&[S; 2], &Location)| match *place {
            Location::Outside => None,
            Location::Vertex(v) => Some(self.heights[v]).filter(|x| is_inside[v] && !x.is_nan()),
            Location::Side { triangle: t, side } => {
                let across = result.neighbor(t, side);
                let is_inside = |t: usize| self.interior.is_inside(t);
                let corners = result.triangle(t);
                let ends = [1, 2].map(|i| corners[(side + i) % 3]);
                let heights = ends.map(|v| self.heights[v]);
                let is_known = !heights.iter().any(|x| x.is_nan());
                (is_known && (is_inside(t) || across.is_some_and(is_inside)))
                    .then(|| along(point, ends.map(|v| &self.points[v]), heights))
            }
            Location::Triangle(t) => self.triangle(t).map(|corners| {
                let heights = corners.map(|v| self.heights[v]);
                within(point, corners.map(|v| &self.points[v]), heights)
            }),
        };
        points.iter().zip(places).map(height).collect()
    }

    /// Whether each vertex is a corner of a triangle inside.
    fn vertices_inside(&self) -> Vec<bool> {
        let mut is_inside = vec![false; self.points.len()];
        for corners in self.interior.triangles() {
            corners.into_iter().for_each(|v| is_inside[v] = true);
        }
        is_inside
    }
}
