//! Holes and regions by seed points, as in Triangle's `.poly`.
//!
//! The edges cut the hull into faces. Those with the seed of a hole are not inside, nor are those that reach the
//! border of the hull where no edge runs along it, since the outside comes in there. All others are.
//! EdgeChains need not be closed: an edge that dangles separates nothing.
//!
//! A seed must tell in which face it lies. So it must not lie on an edge, nor on a vertex. Where it lies is found by
//! exact signs. The seeds are sorted by x. Each triangle is compared with those between its leftmost and its
//! rightmost corner. A walk from triangle to triangle would look at fewer, but in a triangulation that is
//! constrained it may go round in circles.
//!
//! Cost: O((n + k) log k) for n triangles and k seeds, and one comparison for each triangle and seed that have an x
//! in common: few seeds, or seeds that are spread, take little more. Faces take 8 bytes a triangle.

use std::cmp::Ordering;

use super::error::{InteriorError, Seed};
use super::labels::{self, Interior};
use crate::Triangulation;
use crate::ids::narrow;
use crate::scalar::{Scalar, filtered_orient2d};

impl Triangulation {
    /// What of the hull is inside, by seed points of holes. `points` are those that were triangulated; `holes` and
    /// `regions` are points `[x, y]`, each standing for the *face* that it lies in: all that can be reached from
    /// it without crossing an edge.
    ///
    /// Faces with a hole are not inside, nor is what the outside reaches without crossing an edge. Of the others,
    /// those with a region have its index, [`Interior::region`]; of several regions in one face the last one counts.
    /// This is what Triangle does with a `.poly`.
    ///
    /// # Errors
    /// [`InteriorError`], if a seed is not in one face, or that of a region not inside, or if `points` are too few.
    ///
    /// ```
    /// // A square with a square hole, in which there is an island.
    /// let square = |a, b| [[a, a], [b, a], [b, b], [a, b]];
    /// let points = [square(0, 9), square(2, 7), square(4, 5)].concat();
    /// let ring = |v: usize| [[v, v + 1], [v + 1, v + 2], [v + 2, v + 3], [v + 3, v]];
    /// let edges = [ring(0), ring(4), ring(8)].concat();
    /// let result = sweep_cdt::triangulate(&points, &edges)?;
    /// let domain = result.interior_of_seeds(&points, &[[3, 3]], &[[1, 1]])?;
    /// assert_eq!(domain.inside().len(), 10);
    /// assert_eq!(domain.inside().filter(|&t| domain.region(t) == Some(0)).count(), 8);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn interior_of_seeds<S: Scalar>(
        &self,
        points: &[[S; 2]],
        holes: &[[S; 2]],
        regions: &[[S; 2]],
    ) -> Result<Interior<'_>, InteriorError> {
        let mut corners = self.triangles().flatten();
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

        let (faces, count) = faces(self);
        let mut is_outside = vec![false; count];
        for (t, &face) in faces.iter().enumerate() {
            let is_gap = |side| self.neighbor(t, side).is_none() && !self.is_constrained(t, side);
            is_outside[face] |= (0..3).any(is_gap);
        }
        let mut region_of_face = vec![None; count];
        // Holes come first.
        for (place, &seed) in locate(self.triangles(), points, &seeds)
            .into_iter()
            .zip(&names)
        {
            let face = faces[self.triangle_of(seed, place)?];
            match seed {
                Seed::Hole(_) => is_outside[face] = true,
                Seed::Region(region) if is_outside[face] => {
                    return Err(InteriorError::RegionOutside { region });
                }
                Seed::Region(region) => region_of_face[face] = Some(narrow(region)),
            }
        }
        let depths = faces.iter().map(|&face| i32::from(!is_outside[face]));
        let interior = Interior::new(self, depths.collect(), |depth| depth == 1);
        if regions.is_empty() {
            return Ok(interior);
        }
        Ok(interior.with_regions(faces.iter().map(|&face| region_of_face[face]).collect()))
    }

    /// The triangle of a seed, if it is in one face.
    fn triangle_of(&self, seed: Seed, place: Option<Place>) -> Result<usize, InteriorError> {
        match place {
            None => Err(InteriorError::SeedOutside { seed }),
            Some(Place::OnVertex(vertex, _)) => Err(InteriorError::SeedOnVertex { seed, vertex }),
            Some(Place::OnSide(t, side)) if self.is_constrained(t, side) => {
                let mut ends = labels::ends(self, t, side);
                ends.sort_unstable();
                Err(InteriorError::SeedOnEdge { seed, ends })
            }
            Some(Place::OnSide(t, _) | Place::In(t)) => Ok(t),
        }
    }
}

/// For each triangle the number of its face, and how many faces there are. A face is what is left in one piece of the
/// hull when it is cut along all edges.
fn faces(result: &Triangulation) -> (Vec<usize>, usize) {
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

/// Where a point lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Place {
    /// Inside a triangle.
    In(usize),
    /// Inside a side of a triangle.
    OnSide(usize, usize),
    /// A corner of a triangle.
    OnVertex(usize, usize),
}

/// For each seed a triangle that holds it, of any list that covers no place twice: the first one of two where it lies on
/// a side, and of several where it is a corner. `None` is outside of all.
///
/// Cost: see [`Triangulation::interior_of_seeds`]. Triangles may run either way. Those with a corner that is no index of a
/// point hold nothing.
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
    let seeds: Vec<&[S; 2]> = seeds.iter().collect();
    let places = locate(triangles.iter().copied(), points, &seeds).into_iter();
    places
        .map(|place| match place? {
            Place::In(t) | Place::OnSide(t, _) | Place::OnVertex(_, t) => Some(t),
        })
        .collect()
}

/// The places of points; `None` is outside of the hull.
fn locate<S: Scalar>(
    triangles: impl Iterator<Item = [usize; 3]>,
    points: &[[S; 2]],
    seeds: &[&[S; 2]],
) -> Vec<Option<Place>> {
    let mut order: Vec<usize> = (0..seeds.len()).collect();
    order.sort_by(|&a, &b| seeds[a][0].compare(&seeds[b][0]));
    let mut places = vec![None; seeds.len()];
    for (t, corners) in triangles.enumerate() {
        let [Some(a), Some(b), Some(c)] = corners.map(|v| points.get(v)) else {
            continue;
        };
        let triangle = [a, b, c];
        let is_before = |seed: &usize, corner: &[S; 2]| seeds[*seed][0].compare(&corner[0]).is_lt();
        let is_behind = |seed: &usize, corner: &[S; 2]| seeds[*seed][0].compare(&corner[0]).is_gt();
        let from = order.partition_point(|seed| triangle.iter().all(|p| is_before(seed, p)));
        let to = order.partition_point(|seed| !triangle.iter().all(|p| is_behind(seed, p)));
        for &seed in &order[from..to] {
            if places[seed].is_none() {
                places[seed] = place(triangle, seeds[seed]).map(|place| match place {
                    (Some(corner), _) => Place::OnVertex(corners[corner], t),
                    (None, Some(side)) => Place::OnSide(t, side),
                    (None, None) => Place::In(t),
                });
            }
        }
    }
    places
}

/// Whether a triangle holds a point, and at which corner or else on which side that is.
fn place<S: Scalar>(
    triangle: [&[S; 2]; 3],
    point: &[S; 2],
) -> Option<(Option<usize>, Option<usize>)> {
    let turn = |i: usize| filtered_orient2d(triangle[(i + 1) % 3], triangle[(i + 2) % 3], point);
    let turns = [turn(0), turn(1), turn(2)];
    if turns.contains(&Ordering::Less) && turns.contains(&Ordering::Greater) {
        return None;
    }
    // On two sides it is where they meet, opposite the third one.
    let corner = (0..3).find(|&i| turns[(i + 1) % 3].is_eq() && turns[(i + 2) % 3].is_eq());
    Some((corner, turns.iter().position(|turn| turn.is_eq())))
}
