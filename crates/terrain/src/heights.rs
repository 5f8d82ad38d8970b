//! Heights of points on a surface: what is interpolated ([`crate::interpolate`]) where they lie ([`crate::places`]).

use num_traits::{One, Zero};
use sweep_cdt::crossings::Exact;

use crate::interpolate::{along, at_share, within};
use crate::places::{Place, Places};
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
        self.heights_of(&Places::new(self.points, self.interior, points, None))
    }

    /// The heights as of [`heights_at`](Surface::heights_at), and for a point outside that of the nearest place on the
    /// border, if that is at most so far away, in the units of the points.
    #[must_use]
    pub fn heights_within(&self, points: &[[S; 2]], distance: f64) -> Vec<Option<f64>> {
        self.heights_of(&Places::new(
            self.points,
            self.interior,
            points,
            Some(distance),
        ))
    }

    /// The heights at places that are known: for several surfaces over one domain, which finds them once.
    #[must_use]
    pub fn heights_of(&self, places: &Places<'_, S>) -> Vec<Option<f64>> {
        let known = |v: usize| Some(self.heights[v]).filter(|height| !height.is_nan());
        let both = |[a, b]: [usize; 2]| Some([known(a)?, known(b)?]);
        let height = |(point, place): (&[S; 2], &Place)| match place {
            Place::Outside => None,
            Place::Vertex(v) => known(*v),
            Place::Side(ends) => {
                let heights = both(*ends)?;
                Some(along(point, ends.map(|v| &self.points[v]), heights))
            }
            Place::Triangle(t) => self.triangle(*t).map(|corners| {
                let heights = corners.map(|v| self.heights[v]);
                within(point, corners.map(|v| &self.points[v]), heights)
            }),
            Place::Near(near) if near.share.is_zero() => known(near.ends[0]),
            Place::Near(near) if near.share.is_one() => known(near.ends[1]),
            Place::Near(near) => Some(at_share(&near.share, both(near.ends)?)),
        };
        places
            .points
            .iter()
            .zip(&places.found)
            .map(height)
            .collect()
    }
}
