//! A question to the verifier: do these triangles tile the hull of an input, or its interior by a rule?
//!
//! The interior comes from a triangulation of the input, which is proven right before anything is concluded from it. Its
//! boundary and the edges in it are what the verifier then asks of the triangles.
//!
//! Cost: that of the verifier; of a domain other than the hull also that of triangulating the input and verifying that.

use sweep_cdt::interior::InteriorError;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::verify::{Level, Verifier};
use sweep_cdt::{Error, Triangulation};
use sweep_cdt_formats::{Coordinate, Numbering, locate_seeds};

use crate::inside::{Input, Inside};
use crate::verdict::{Answer, Verdict};
use crate::wanted::Wanted;

/// Triangulates points and edges, on the threads and with the progress of a front end.
pub type Triangulate<'a, T> = dyn Fn(&[[T; 2]], &[[usize; 2]]) -> Result<Triangulation, Error> + 'a;
/// Verifies triangles of points and edges, likewise.
pub type Verify<'a, T> =
    dyn Fn(Verifier<'_>, &[[T; 2]], &[[usize; 2]], &[[usize; 3]]) -> Answer + 'a;

/// Triangles, the input that they are verified against, and what is asked of them.
#[expect(
    missing_debug_implementations,
    reason = "it holds what runs the library"
)]
pub struct Question<'a, S, T> {
    /// The input. Points that the triangles may add come after its own.
    pub input: &'a Input<'a, S>,
    /// The points of the input in the arithmetic of the verification.
    pub points: &'a [[T; 2]],
    /// How many points are the input's own, if there may be others.
    pub added_from: Option<usize>,
    /// How the input counts.
    pub numbering: Numbering,
    /// The corners of the triangles, as positions in the points.
    pub triangles: &'a [[usize; 3]],
    /// The number of the first triangle.
    pub first_triangle: usize,
    /// The numbers of corners that are no points: corner `points.len() + i` has the number `strangers[i]`. A corner beyond
    /// these is its own number.
    pub strangers: &'a [usize],
    /// The attribute of each triangle's region, if triangles have them.
    pub attributes: Option<&'a [f64]>,
    /// What the triangles must tile.
    pub domain: Inside,
    /// What they must reach.
    pub level: Level,
    /// How deep violations may be that count as rounding.
    pub max_depth: Option<f64>,
    /// How many violations are listed.
    pub limit: usize,
    /// How the library triangulates.
    pub triangulate: &'a Triangulate<'a, T>,
    /// How it verifies.
    pub verify: &'a Verify<'a, T>,
}

impl<S: Coordinate, T: Scalar> Question<'_, S, T> {
    /// The answer.
    ///
    /// # Errors
    /// The input has no triangulation, or does not tell what is inside; not where the domain is the hull.
    ///
    /// # Panics
    /// The library's triangulation of the input is wrong: a bug.
    pub fn answer(&self) -> Result<Answer, InteriorError> {
        if self.domain == Inside::HULL {
            return Ok(self.in_hull());
        }
        let hull = self.hull()?;
        let wanted = Wanted::new(self.domain, self.input, &hull)?;
        Ok(self.within(&wanted))
    }

    /// The verdict of an answer.
    pub fn verdict(&self, answer: &Answer) -> Verdict {
        Verdict::of(answer, self.max_depth)
    }

    /// The question with other triangles, another domain, another limit.
    pub(crate) fn but<'b>(
        &'b self,
        triangles: &'b [[usize; 3]],
        domain: Inside,
        limit: usize,
    ) -> Question<'b, S, T> {
        Question {
            triangles,
            domain,
            limit,
            ..*self
        }
    }

    fn verifier(&self) -> Verifier<'_> {
        let verifier = Verifier::new()
            .accept_clockwise(true)
            .level(self.level)
            .all_depths(self.max_depth.is_some())
            .limit(self.limit);
        match self.added_from {
            Some(own) => verifier.added_from(own),
            None => verifier,
        }
    }

    pub(crate) fn in_hull(&self) -> Answer {
        let edges = self.input.edges;
        (self.verify)(self.verifier(), self.points, edges, self.triangles)
    }

    /// The triangulation of the hull of the input's own points, proven right.
    pub(crate) fn hull(&self) -> Result<Triangulation, Error> {
        let own = self.added_from.unwrap_or(self.points.len());
        let (points, edges) = (&self.points[..own], self.input.edges);
        let hull = (self.triangulate)(points, edges)?;
        let triangles: Vec<[usize; 3]> = hull.triangles().collect();
        let proof = (self.verify)(Verifier::new(), points, edges, &triangles);
        assert!(proof.is_ok(), "the triangulation of the input is right");
        Ok(hull)
    }

    /// The answer within a domain, with the attributes of regions where its rule has them.
    pub(crate) fn within(&self, wanted: &Wanted) -> Answer {
        let Input {
            points, regions, ..
        } = *self.input;
        let verifier = self.verifier().boundary(&wanted.boundary);
        let verify = |verifier| (self.verify)(verifier, self.points, &wanted.edges, self.triangles);
        let attributes = self.attributes.filter(|_| self.domain.has_regions());
        let answer = match attributes.filter(|_| !regions.is_empty()) {
            None => verify(verifier),
            Some(attributes) => {
                let seeds: Vec<[S; 2]> = regions.iter().map(|region| region.seed.clone()).collect();
                let places = locate_seeds(points, self.triangles, &seeds).into_iter();
                let seeds = places
                    .zip(regions)
                    .filter_map(|(place, region)| Some((place?, region.attribute)));
                let seeds: Vec<(usize, f64)> = seeds.collect();
                verify(verifier.regions(attributes, &seeds))
            }
        };
        wanted.of_input(answer, self.input.edges.len())
    }
}
