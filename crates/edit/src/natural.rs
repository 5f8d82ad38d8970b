//! Natural neighbours: whose cells a new point's cell would take from, and how much (Sibson 1981).
//!
//! ```text
//!       v---w           The triangles whose circles hold the place go; its cell would have a corner for each side of
//!      / \ /|           their border, the centre of the circle through the side and the place. What the cell takes from
//!     u---x-+ place     v lies between two such corners, next to each other around v, and the old Voronoi vertices of v
//!                       in between: the centres of the triangles at v that go.
//! ```
//!
//! **Why it is right.** The areas are those of the definition, in fractions, so they add up to one exactly; each weight is
//! rounded once. **Cost.** Some microseconds for each triangle whose circle holds the place.

use std::collections::{BTreeMap, BTreeSet};

use num_rational::BigRational;
use sweep_cdt::crossings::Exact;
use sweep_cdt::scalar::in_circle;

use crate::locate::Place;
use crate::measure::{center, doubled_area, exactly};
use crate::mesh::{NONE, next};
use crate::triangulation::DynamicTriangulation;
use crate::voronoi::VoronoiError;

impl<S: Exact> DynamicTriangulation<S> {
    /// The natural neighbours of a place, by number, each with its weight: the part of the cell of the place that would be
    /// taken from its cell. The weights add up to 1, and the place is the mean of its neighbours with these weights, but
    /// for rounding. At a point, the point has weight 1; on the hull both ends of the side share it. Empty outside of the
    /// hull, and if there are no triangles.
    ///
    /// ```
    /// use sweep_cdt_edit::DynamicTriangulation;
    ///
    /// let mut square = DynamicTriangulation::new();
    /// for corner in [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]] {
    ///     square.insert(corner)?;
    /// }
    /// let heights = [1.0, 1.0, 3.0, 3.0];
    /// let weights = square.natural_neighbors(&[2.0, 2.0])?;
    /// assert_eq!(weights, [(0, 0.25), (1, 0.25), (2, 0.25), (3, 0.25)]);
    /// let height: f64 = weights.iter().map(|&(point, weight)| weight * heights[point]).sum();
    /// assert_eq!(height, 2.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`VoronoiError::Edge`], if there is an edge: natural neighbours are those of points alone.
    pub fn natural_neighbors(&self, place: &[S; 2]) -> Result<Vec<(usize, S)>, VoronoiError> {
        if let Some((edge, _)) = self.edges().next() {
            return Err(VoronoiError::Edge { edge });
        }
        if self.mesh.len() == 0 || !place.iter().all(S::is_finite) {
            return Ok(Vec::new());
        }
        let one = || BigRational::from_integer(1.into());
        let areas = match self.find(place) {
            Place::Vertex(v) => BTreeMap::from([(v, one())]),
            Place::Beyond(_) => BTreeMap::new(),
            Place::Side(side) if self.mesh.twin(side) == NONE => self.on_the_hull(place, side),
            Place::Side(side) => self.taken(place, side / 3),
            Place::Triangle(t) => self.taken(place, t),
        };
        let total: BigRational = areas.values().sum();
        let weighted = areas.into_iter().map(|(v, area)| {
            let weight = S::nearest(&(area / &total));
            (self.points.name(v), weight)
        });
        let mut weights: Vec<_> = weighted.collect();
        weights.sort_unstable_by_key(|&(point, _)| point);
        Ok(weights)
    }

    /// On a side of the hull the cells are without bounds, and the limit of their parts is linear.
    fn on_the_hull(&self, place: &[S; 2], side: u32) -> BTreeMap<u32, BigRational> {
        let ends = self.mesh.ends(side);
        let [a, b] = ends.map(|v| exactly(self.points.place(v)));
        let place = exactly(place);
        // Along the axis on which the ends differ, as far as from the other end.
        let axis = usize::from(a[0] == b[0]);
        let part = (&place[axis] - &a[axis]) / (&b[axis] - &a[axis]);
        let rest = BigRational::from_integer(1.into()) - &part;
        BTreeMap::from([(ends[0], rest), (ends[1], part)])
    }

    /// Twice the area that the cell of a place in this triangle takes from each vertex.
    fn taken(&self, place: &[S; 2], start: u32) -> BTreeMap<u32, BigRational> {
        let mesh = &self.mesh;
        let corners = |t: u32| {
            mesh.triangle(t)
                .expect("a triangle")
                .map(|v| self.points.place(v))
        };
        let (mut going, mut waiting) = (BTreeSet::from([start]), vec![start]);
        let mut border = Vec::new();
        while let Some(t) = waiting.pop() {
            for side in 3 * t..3 * t + 3 {
                let across = mesh.twin(side);
                if across != NONE && !going.contains(&(across / 3)) {
                    let [a, b, c] = corners(across / 3);
                    if in_circle(a, b, c, place).is_gt() {
                        going.insert(across / 3);
                        waiting.push(across / 3);
                    }
                }
            }
        }
        for &t in &going {
            let is_kept =
                |side: u32| mesh.twin(side) == NONE || !going.contains(&(mesh.twin(side) / 3));
            border.extend((3 * t..3 * t + 3).filter(|&side| is_kept(side)));
        }
        // The corners of the new cell, by the vertices at which the sides of the border end.
        let own = |side: u32| {
            let [a, b] = mesh.ends(side).map(|v| self.points.place(v));
            center([a, b, place]).expect("the place lies to the left of the border")
        };
        let ended: BTreeMap<u32, _> = border
            .iter()
            .map(|&side| (mesh.ends(side)[1], own(side)))
            .collect();
        let part = |&side: &u32| {
            let v = mesh.ends(side)[0];
            let mut part = vec![ended[&v].clone(), own(side)];
            let mut corner = next(side);
            while corner != NONE && going.contains(&(corner / 3)) {
                part.push(center(corners(corner / 3)).expect("a triangle turns left"));
                corner = mesh.turned_left(corner);
            }
            (v, doubled_area(&part))
        };
        border.iter().map(part).collect()
    }
}
