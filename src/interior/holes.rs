//! Holes and regions by seed points, as in Triangle's `.poly`.
//!
//! The edges cut the hull into faces. A face is not inside if it has the seed of a hole, or if it reaches the border of
//! the hull where no edge runs: the outside comes in there, unless the hull is kept. Chains need not be closed: dangling
//! edges part nothing.
//!
//! A seed must tell in which face it lies, so it must not lie on an edge or a vertex. [`WithPoints::locate_all`] finds it
//! by exact signs. Cost: O(n) for n triangles, and the location of each seed. Faces take 8 bytes a triangle.

use alloc::vec;
use alloc::vec::Vec;

use super::error::{InteriorError, Seed};
use super::labels::Interior;
use crate::scalar::Scalar;
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
    /// [`InteriorError`], if a seed is not in one face, or the seed of a region is not inside.
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
    /// [`InteriorError`], if a seed is not in one face, or the seed of a region is in a hole.
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
        let result = self.result;
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
                Seed::Region(region) => region_of_face[face] = Some(region),
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
            let mut ends = result.side(triangle, side);
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
