//! The point nearest to a place.
//!
//! The search begins in the triangle of the place and spreads across sides that are not farther than the nearest vertex
//! found so far.
//!
//! **Why it is right.** The hull and the disk around the place, up to the nearest vertex found, are convex. The straight
//! way in both from that vertex to a nearer one would lead through triangles whose sides are not farther; so all of them
//! were looked at. Edges do not matter. **Cost.** The triangles that the disk touches, with the walk to the place: a few
//! where triangles are Delaunay.

use std::cmp::Ordering;
use std::collections::HashSet;

use sweep_cdt::crossings::Exact;

use crate::locate::Place;
use crate::measure::{compare_distances, is_farther};
use crate::mesh::NONE;
use crate::triangulation::DynamicTriangulation;

impl<S: Exact> DynamicTriangulation<S> {
    /// The point nearest to a place, by exact signs; of several the one with the lowest number. `None`, if there is no
    /// point, or if the place is not finite.
    ///
    /// ```
    /// use sweep_cdt_edit::DynamicTriangulation;
    ///
    /// let mut shops = DynamicTriangulation::new();
    /// for shop in [[0.0, 0.0], [8.0, 0.0], [8.0, 6.0]] {
    ///     shops.insert(shop)?;
    /// }
    /// assert_eq!(shops.nearest(&[9.0, 2.0]), Some(1));
    /// // As far from all three.
    /// assert_eq!(shops.nearest(&[4.0, 3.0]), Some(0));
    /// # Ok::<(), sweep_cdt_edit::EditError>(())
    /// ```
    pub fn nearest(&self, place: &[S; 2]) -> Option<usize> {
        if !place.iter().all(S::is_finite) {
            return None;
        }
        let mesh = &self.mesh;
        let nearer = |&v: &u32, &w: &u32| self.compare_to(place, [v, w]);
        if mesh.len() == 0 {
            let nearest = self.points.vertices().min_by(nearer);
            return nearest.map(|v| self.points.name(v));
        }
        let start = match self.find(place) {
            Place::Vertex(v) => return Some(self.points.name(v)),
            Place::Side(side) | Place::Beyond(side) => side / 3,
            Place::Triangle(t) => t,
        };
        let corners = mesh.triangle(start).expect("a triangle").into_iter();
        let mut nearest = corners.min_by(nearer).expect("a corner");
        let (mut seen, mut waiting) = (HashSet::from([start]), vec![start]);
        while let Some(t) = waiting.pop() {
            for side in 3 * t..3 * t + 3 {
                let across = mesh.twin(side);
                if across == NONE || seen.contains(&(across / 3)) {
                    continue;
                }
                let ends = mesh.ends(side).map(|v| self.points.place(v));
                if !is_farther(place, ends, self.points.place(nearest)) {
                    seen.insert(across / 3);
                    waiting.push(across / 3);
                    let apex = mesh.apex(across);
                    if self.compare_to(place, [apex, nearest]).is_lt() {
                        nearest = apex;
                    }
                }
            }
        }
        Some(self.points.name(nearest))
    }

    /// The order of two vertices by distance, and then by name.
    fn compare_to(&self, place: &[S; 2], [v, w]: [u32; 2]) -> Ordering {
        let order = compare_distances(place, [v, w].map(|v| self.points.place(v)));
        order.then_with(|| self.points.name(v).cmp(&self.points.name(w)))
    }
}
