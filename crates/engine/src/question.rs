//! A question to the verifier: do these triangles tile the hull of an input, or its interior by a rule?
//!
//! The interior comes from a triangulation of the input, which is proven right before anything is concluded from it. Its
//! boundary and the edges in it are what the verifier then asks of the triangles.
//!
//! Cost: that of the verifier; of a domain other than the hull also that of triangulating the input and verifying that.

use sweep_cdt::interior::InteriorError;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::verify::{Level, Regions, Report, Verifier, Violations};
use sweep_cdt::{Error, Triangulation};
use sweep_cdt_formats::{Coordinate, Numbering, locate_seeds};

use crate::inside::{Input, Inside};
use crate::wanted::Wanted;

/// The answer of the verifier.
pub type Answer = Result<Report, Violations>;

/// How a front end runs the library: on which threads, and what it shows or asks meanwhile.
pub trait Runner<T> {
    /// Triangulates.
    ///
    /// # Errors
    /// Those of the library.
    fn triangulate(&self, points: &[[T; 2]], edges: &[[usize; 2]]) -> Result<Triangulation, Error>;

    /// Verifies.
    ///
    /// # Errors
    /// The violations.
    fn verify(
        &self,
        verifier: Verifier<'_>,
        points: &[[T; 2]],
        edges: &[[usize; 2]],
        triangles: &[[usize; 3]],
    ) -> Answer;
}

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
    /// How the library is run.
    pub runner: &'a dyn Runner<T>,
}

/// The verdict on triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// They are right.
    Correct,
    /// They are wrong, but no violation is deeper than what counts as rounding.
    WithinMaxDepth,
    /// They are wrong.
    Wrong,
}

impl Verdict {
    /// The name in records.
    pub fn name(self) -> &'static str {
        match self {
            Verdict::Correct => "correct",
            Verdict::WithinMaxDepth => "within-max-depth",
            Verdict::Wrong => "wrong",
        }
    }
}

/// The counts of a report, by the names that they have in records.
pub fn counts(report: &Report) -> [(&'static str, usize); 11] {
    [
        ("points", report.points),
        ("distinct_points", report.distinct_points),
        ("edges", report.edges),
        ("triangles", report.triangles),
        ("boundary_sides", report.boundary_sides),
        ("constrained_sides", report.constrained_sides),
        ("free_sides", report.free_sides),
        ("cocircular_sides", report.cocircular_sides),
        ("uncanonical_sides", report.uncanonical_sides),
        ("added_points", report.added_points),
        ("split_edges", report.split_edges),
    ]
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
        let Err(violations) = answer else {
            return Verdict::Correct;
        };
        let depth = violations.depth();
        let is_within =
            depth.is_some_and(|depth| self.max_depth.is_some_and(|max| depth.get() <= max));
        match is_within {
            true => Verdict::WithinMaxDepth,
            false => Verdict::Wrong,
        }
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
        let verifier = self.verifier();
        self.runner
            .verify(verifier, self.points, edges, self.triangles)
    }

    /// The triangulation of the hull of the input's own points, proven right.
    pub(crate) fn hull(&self) -> Result<Triangulation, Error> {
        let own = self.added_from.unwrap_or(self.points.len());
        let (points, edges) = (&self.points[..own], self.input.edges);
        let hull = self.runner.triangulate(points, edges)?;
        let triangles: Vec<[usize; 3]> = hull.triangles().collect();
        let proof = self
            .runner
            .verify(Verifier::new(), points, edges, &triangles);
        assert!(proof.is_ok(), "the triangulation of the input is right");
        Ok(hull)
    }

    /// The answer within a domain, with the attributes of regions where its rule has them.
    pub(crate) fn within(&self, wanted: &Wanted) -> Answer {
        let Input {
            points, regions, ..
        } = *self.input;
        let verifier = self.verifier().boundary(&wanted.boundary);
        let verify = |verifier| {
            self.runner
                .verify(verifier, self.points, &wanted.edges, self.triangles)
        };
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
                let regions = Regions {
                    attributes,
                    seeds: &seeds,
                };
                verify(verifier.regions(regions))
            }
        };
        wanted.of_input(answer, self.input.edges.len())
    }
}
