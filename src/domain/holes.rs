//! Holes and regions by seed points, as in Triangle's `.poly`.
//!
//! The edges cut the hull into faces. Those with the seed of a hole are not inside, nor are those that reach the
//! border of the hull where no edge runs along it, since the outside comes in there. All others are.
//! Chains need not be closed: an edge that dangles separates nothing.
//!
//! A seed must tell in which face it lies. So it must not lie on an edge, nor on a vertex.
//!
//! Cost: O(n), and that of finding the seeds (`locate`).

use super::error::DomainError;
use super::faces::faces;
use super::labels::Domain;
use super::locate::{Place, locate};
use super::loops;
use super::seed::Seed;
use crate::Triangulation;
use crate::ids::narrow;
use crate::scalar::Scalar;

impl Triangulation {
    /// What of the hull is inside, by seed points of holes. `points` are those that were triangulated; `holes` and
    /// `regions` are points `[x, y]`, each standing for the *face* that it lies in: all that can be reached from
    /// it without crossing an edge.
    ///
    /// Faces with a hole are not inside, nor is what the outside reaches without crossing an edge. Of the others,
    /// those with a region have its index, [`Domain::region`]; of several regions in one face the last one counts.
    /// This is what Triangle does with a `.poly`.
    ///
    /// # Errors
    /// [`DomainError`], if a seed is not in one face, or that of a region not inside, or if `points` are too few.
    ///
    /// ```
    /// // A square with a square hole, in which there is an island.
    /// let square = |a, b| [[a, a], [b, a], [b, b], [a, b]];
    /// let points = [square(0, 9), square(2, 7), square(4, 5)].concat();
    /// let ring = |v: usize| [[v, v + 1], [v + 1, v + 2], [v + 2, v + 3], [v + 3, v]];
    /// let edges = [ring(0), ring(4), ring(8)].concat();
    /// let result = sweep_cdt::triangulate(&points, &edges)?;
    /// let domain = result.domain_of_seeds(&points, &[[3, 3]], &[[1, 1]])?;
    /// assert_eq!(domain.inside().len(), 10);
    /// assert_eq!(domain.inside().filter(|&t| domain.region(t) == Some(0)).count(), 8);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn domain_of_seeds<S: Scalar>(
        &self,
        points: &[[S; 2]],
        holes: &[[S; 2]],
        regions: &[[S; 2]],
    ) -> Result<Domain<'_>, DomainError> {
        let mut corners = self.triangles().flatten();
        if let Some(vertex) = corners.find(|&vertex| vertex >= points.len()) {
            return Err(DomainError::MissingPoint { vertex });
        }
        let seeds: Vec<&[S; 2]> = holes.iter().chain(regions).collect();
        let names = (0..holes.len()).map(Seed::Hole);
        let names: Vec<Seed> = names.chain((0..regions.len()).map(Seed::Region)).collect();
        let is_finite = |seed: &[S; 2]| seed.iter().all(S::is_finite);
        if let Some(at) = seeds.iter().position(|seed| !is_finite(seed)) {
            return Err(DomainError::SeedNotFinite { seed: names[at] });
        }

        let (faces, count) = faces(self);
        let mut is_outside = vec![false; count];
        for (t, &face) in faces.iter().enumerate() {
            let is_gap = |side| self.neighbor(t, side).is_none() && !self.is_constrained(t, side);
            is_outside[face] |= (0..3).any(is_gap);
        }
        let mut region_of_face = vec![None; count];
        // Holes come first.
        for (place, &seed) in locate(self, points, &seeds).into_iter().zip(&names) {
            let face = faces[self.triangle_of(seed, place)?];
            match seed {
                Seed::Hole(_) => is_outside[face] = true,
                Seed::Region(region) if is_outside[face] => {
                    return Err(DomainError::RegionOutside { region });
                }
                Seed::Region(region) => region_of_face[face] = Some(narrow(region)),
            }
        }
        let depths = faces.iter().map(|&face| i32::from(!is_outside[face]));
        let domain = Domain::new(self, depths.collect(), |depth| depth == 1);
        if regions.is_empty() {
            return Ok(domain);
        }
        Ok(domain.with_regions(faces.iter().map(|&face| region_of_face[face]).collect()))
    }

    /// The triangle of a seed, if it is in one face.
    fn triangle_of(&self, seed: Seed, place: Option<Place>) -> Result<usize, DomainError> {
        match place {
            None => Err(DomainError::SeedOutside { seed }),
            Some(Place::OnVertex(vertex)) => Err(DomainError::SeedOnVertex { seed, vertex }),
            Some(Place::OnSide(t, side)) if self.is_constrained(t, side) => {
                let mut ends = loops::ends(self, t, side);
                ends.sort_unstable();
                Err(DomainError::SeedOnEdge { seed, ends })
            }
            Some(Place::OnSide(t, _) | Place::In(t)) => Ok(t),
        }
    }
}
