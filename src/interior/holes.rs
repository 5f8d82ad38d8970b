//! Holes and regions by seed points, as in Triangle's `.poly`.
//!
//! The edges cut the hull into faces. A face is not inside if it has the seed of a hole, or if it reaches the border of
//! the hull where no edge runs: the outside comes in there, unless the hull is kept. Chains need not be closed: dangling
//! edges part nothing.
//!
//! A seed must tell in which face it lies, so it must not lie on an edge or a vertex. The walk of
//! [`WithPoints::locate_all`] finds it by exact signs. A list of triangles without neighbours allows no walk
//! ([`locate_seeds`]): the seeds are sorted by x, and each triangle is compared with the seeds between its leftmost and
//! rightmost corners. Cost: O(n) for n triangles, and the location of each seed. Faces take 8 bytes a triangle.

use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Ordering;

use super::error::{InteriorError, Seed};
use super::labels::{self, Interior};
use crate::ids::narrow;
use crate::scalar::{Scalar, orient2d};
use crate::triangulation::Triangulation;
use crate::triangulation::locate::Location;
use crate::triangulation::with_points::WithPoints;

impl<'a, S: Scalar> WithPoints<'a, S> {
    /// The interior by seed points of holes and regions. Each of these points `[x, y]` stands for the *face* that it
    /// lies in: all that can be reached from it without crossing an edge.
    ///
    /// Faces with a hole are not inside, nor is what the outside reaches without crossing an edge. Of the others, those
    /// with a region have its index, [`Interior::region`]; of several in a face the last counts, as in Triangle.
    ///
    /// # Errors
    /// [`InteriorError`], if a seed is not in one face, the seed of a region is not inside, or a vertex has no point.
    ///
    /// ```
    /// // A square with a square hole, in which there is an island.
    /// let square = |a, b| [[a, a], [b, a], [b, b], [a, b]];
    /// let points = [square(0, 9), square(2, 7), square(4, 5)].concat();
    /// let ring = |v: usize| [[v, v + 1], [v + 1, v + 2], [v + 2, v + 3], [v + 3, v]];
    /// let edges = [ring(0), ring(4), ring(8)].concat();
    /// let result = sweep_cdt::triangulate(&points, &edges)?;
    /// let domain = result.with_points(&points).interior_of_seeds(&[[3, 3]], &[[1, 1]])?;
    /// assert_eq!(domain.inside().len(), 10);
    /// assert_eq!(domain.inside().filter(|&t| domain.region(t) == Some(0)).count(), 8);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn interior_of_seeds(
        &self,
        holes: &[[S; 2]],
        regions: &[[S; 2]],
    ) -> Result<Interior<'a>, InteriorError> {
        self.without_holes(holes, regions, true)
    }

    /// The hull without its holes, as [`interior_of_seeds`](Self::interior_of_seeds) but that nothing comes in from
    /// outside: Triangle's option `-c` with holes.
    ///
    /// # Errors
    /// [`InteriorError`], if a seed is not in one face, the seed of a region is in a hole, or a vertex has no point.
    ///
    /// ```
    /// // A box without a lid, and a square hole in it.
    /// let points = [[0, 0], [9, 0], [9, 9], [0, 9], [2, 2], [4, 2], [4, 4], [2, 4]];
    /// let edges = [[3, 0], [0, 1], [1, 2], [4, 5], [5, 6], [6, 7], [7, 4]];
    /// let result = sweep_cdt::triangulate(&points, &edges)?;
    /// let result = result.with_points(&points);
    /// assert_eq!(result.interior_of_seeds(&[[3, 3]], &[])?.inside().len(), 0);
    /// assert_eq!(result.hull_without_holes(&[[3, 3]], &[])?.inside().len(), 8);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn hull_without_holes(
        &self,
        holes: &[[S; 2]],
        regions: &[[S; 2]],
    ) -> Result<Interior<'a>, InteriorError> {
        self.without_holes(holes, regions, false)
    }

    /// The faces without holes, and without those that gaps open, if these count.
    fn without_holes(
        &self,
        holes: &[[S; 2]],
        regions: &[[S; 2]],
        is_open: bool,
    ) -> Result<Interior<'a>, InteriorError> {
        let (result, points) = (self.result, self.points);
        let mut corners = result.triangles().flatten();
        if let Some(vertex) = corners.find(|&vertex| vertex >= points.len()) {
            return Err(InteriorError::MissingPoint { vertex });
        }
        let seeds: Vec<&[S; 2]> = holes.iter().chain(regions).collect();
        let names = (0..holes.len()).map(Seed::Hole);
        let names: Vec<Seed> = names.chain((0..regions.len()).map(Seed::Region)).collect();
        let is_finite = |seed: &[S; 2]| seed.iter().all(S::is_finite);
        if let Some(at) = seeds.iter().position(|seed| !is_finite(seed)) {
            return Err(InteriorError::SeedNotFinite { seed: names[at] });
        }

        let (faces, count) = faces(result);
        let mut is_outside = vec![false; count];
        for (t, &face) in faces.iter().enumerate() {
            let is_gap =
                |side| result.neighbor(t, side).is_none() && !result.is_constrained(t, side);
            is_outside[face] |= is_open && (0..3).any(is_gap);
        }
        let mut region_of_face = vec![None; count];
        // Holes come first.
        let places = [holes, regions]
            .map(|seeds| self.locate_all(seeds))
            .concat();
        for (&name, place) in names.iter().zip(places) {
            let face = faces[triangle_of(result, name, place)?];
            match name {
                Seed::Hole(_) => is_outside[face] = true,
                Seed::Region(region) if is_outside[face] => {
                    return Err(InteriorError::RegionOutside { region });
                }
                Seed::Region(region) => region_of_face[face] = Some(narrow(region)),
            }
        }
        let depths = faces.iter().map(|&face| i32::from(!is_outside[face]));
        let interior = Interior::new(result, depths.collect(), |depth| depth == 1);
        if regions.is_empty() {
            return Ok(interior);
        }
        Ok(interior.with_regions(faces.iter().map(|&face| region_of_face[face]).collect()))
    }
}

/// The triangle of a seed with this location, if the seed is in one face.
fn triangle_of(
    result: &Triangulation,
    seed: Seed,
    location: Location,
) -> Result<usize, InteriorError> {
    match location {
        Location::Outside => Err(InteriorError::SeedOutside { seed }),
        Location::Vertex(vertex) => Err(InteriorError::SeedOnVertex { seed, vertex }),
        Location::Side { triangle, side } if result.is_constrained(triangle, side) => {
            let mut ends = labels::ends(result, triangle, side);
            ends.sort_unstable();
            Err(InteriorError::SeedOnEdge { seed, ends })
        }
        Location::Side { triangle, .. } | Location::Triangle(triangle) => Ok(triangle),
    }
}

/// For each triangle the number of its face, and how many faces there are: pieces of the hull cut along all edges.
pub(super) fn faces(result: &Triangulation) -> (Vec<usize>, usize) {
    const NONE: usize = usize::MAX;
    let mut faces = vec![NONE; result.len()];
    let (mut count, mut waiting) = (0, Vec::new());
    for first in 0..result.len() {
        if faces[first] != NONE {
            continue;
        }
        faces[first] = count;
        waiting.push(first);
        while let Some(t) = waiting.pop() {
            for side in 0..3 {
                if let Some(neighbor) = result.neighbor(t, side)
                    && !result.is_constrained(t, side)
                    && faces[neighbor] == NONE
                {
                    faces[neighbor] = count;
                    waiting.push(neighbor);
                }
            }
        }
        count += 1;
    }
    (faces, count)
}

/// For each seed the first triangle that holds it, in any list that covers no place twice. Two triangles hold a seed on
/// their side, several one at their corner; `None` is outside of all.
///
/// Cost: O((n + k) log k) for n triangles and k seeds, and one comparison for each triangle and seed that have an x in
/// common. Triangles may run either way. A triangle with a corner that is no index of a point holds nothing.
///
/// ```
/// use sweep_cdt::interior::locate_seeds;
///
/// let points = [[0, 0], [4, 0], [4, 4], [0, 4]];
/// let triangles = [[0, 1, 2], [0, 2, 3]];
/// assert_eq!(locate_seeds(&points, &triangles, &[[3, 1], [1, 3], [5, 5]]), [Some(0), Some(1), None]);
/// ```
pub fn locate_seeds<S: Scalar>(
    points: &[[S; 2]],
    triangles: &[[usize; 3]],
    seeds: &[[S; 2]],
) -> Vec<Option<usize>> {
    let mut order: Vec<usize> = (0..seeds.len()).collect();
    order.sort_by(|&a, &b| seeds[a][0].compare(&seeds[b][0]));
    let mut found = vec![None; seeds.len()];
    for (t, corners) in triangles.iter().enumerate() {
        let [Some(a), Some(b), Some(c)] = corners.map(|v| points.get(v)) else {
            continue;
        };
        let triangle = [a, b, c];
        let is_before = |seed: &usize, corner: &[S; 2]| seeds[*seed][0].compare(&corner[0]).is_lt();
        let is_behind = |seed: &usize, corner: &[S; 2]| seeds[*seed][0].compare(&corner[0]).is_gt();
        let from = order.partition_point(|seed| triangle.iter().all(|p| is_before(seed, p)));
        let to = order.partition_point(|seed| !triangle.iter().all(|p| is_behind(seed, p)));
        for &seed in &order[from..to] {
            if found[seed].is_none() && holds(triangle, &seeds[seed]) {
                found[seed] = Some(t);
            }
        }
    }
    found
}

/// Whether a triangle holds a point: inside, on a side or at a corner.
fn holds<S: Scalar>([a, b, c]: [&[S; 2]; 3], point: &[S; 2]) -> bool {
    let turns = [[a, b], [b, c], [c, a]].map(|[from, to]| orient2d(from, to, point));
    !(turns.contains(&Ordering::Less) && turns.contains(&Ordering::Greater))
}
