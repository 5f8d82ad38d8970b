//! The right answer to a question, and what is wrong with a program's answer.
//!
//! Right answers come from this crate, and the oracle passes each of them. An answer of a program is judged twice, by
//! the verifier and by the oracle's [`Region`], which must agree.

use std::collections::BTreeSet;
use std::fmt;

use sweep_cdt::interior::{FillRule, Interior, InteriorError, Ring};
use sweep_cdt::verify::{Verifier, Violation, Violations};
use sweep_cdt::{Error, Triangulation, triangulate};

use super::outcome::{Fault, Outcome};
use super::question::Question;
use crate::generators::ring_sides;
use crate::oracle::{Domain, Region, canonical, check, crosses, sorted};
use crate::with_integers;

/// The right answer to a question without operations.
#[derive(Clone, Debug, PartialEq)]
pub struct Right {
    /// The canonical triangles in the domain, each with its lowest vertex first; sorted.
    pub inside: Vec<[usize; 3]>,
    /// The other canonical triangles of the hull.
    pub outside: Vec<[usize; 3]>,
}

/// Why a question has no answer.
#[derive(Clone, Debug, PartialEq)]
pub enum Hopeless {
    /// Two edges cross at a point that is none of the input; sides of rings are numbered after the edges.
    Crossing([usize; 2]),
    /// The edges are no closed rings, of which the domain asks.
    Open,
}

impl fmt::Display for Hopeless {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Hopeless::Crossing([e, other]) => write!(f, "edges {e} and {other} cross"),
            Hopeless::Open => f.write_str("the edges are no closed rings"),
        }
    }
}

impl Right {
    /// The right answer, which the oracle has passed.
    ///
    /// # Errors
    /// [`Hopeless`], if there is none.
    ///
    /// # Panics
    /// If the oracle finds this crate wrong.
    pub fn of(question: &Question) -> Result<Right, Hopeless> {
        let (points, edges) = (&question.points, question.all_edges());
        let result = match triangulate(points, &edges) {
            Ok(result) => result,
            Err(Error::CrossingEdges { edges: pair, .. }) => {
                assert!(crosses(points, &edges, pair), "{pair:?} do not cross");
                return Err(Hopeless::Crossing(pair));
            }
            Err(error) => panic!("{error}, for a question that is sound"),
        };
        let answer = check(points, &edges, &result);
        let interior = question.interior(&result).map_err(|_| Hopeless::Open)?;
        let is_inside: BTreeSet<[usize; 3]> = interior.canonical_triangles().into_iter().collect();
        let holds = |t: [usize; 3]| with_rays(question, &edges, t);
        let all = canonical(&result, &answer.triangles);
        for &t in &all {
            assert_eq!(
                is_inside.contains(&t),
                holds(t),
                "{t:?} in {:?}",
                question.domain
            );
        }
        let (inside, outside) = all.into_iter().partition(|t| is_inside.contains(t));
        Ok(Right { inside, outside })
    }

    /// What is wrong with what came of a question without operations, if anything is. What has no triangles may be
    /// refused.
    ///
    /// # Panics
    /// If the verifier and the oracle disagree.
    pub fn fault(&self, question: &Question, outcome: &Outcome) -> Option<Fault> {
        self.judged(question, outcome, Right::violation)
    }

    /// [`fault`](Right::fault) by the verifier alone, which takes a fraction of the time.
    pub fn fault_by_verifier(&self, question: &Question, outcome: &Outcome) -> Option<Fault> {
        self.judged(question, outcome, |right, question, triangles| {
            let edges = question.all_edges();
            right.verify(question, &edges, triangles).err()
        })
    }

    fn judged(
        &self,
        question: &Question,
        outcome: &Outcome,
        judge: impl FnOnce(&Right, &Question, &[[usize; 3]]) -> Option<Fault>,
    ) -> Option<Fault> {
        match outcome {
            Outcome::Failed(fault) => Some(fault.clone()),
            Outcome::Triangles(triangles) => judge(self, question, triangles),
            Outcome::After(_) => Some(Fault::new("unreadable", "there are no operations")),
            Outcome::Refused(reason) => {
                let what = format!("the program says: {reason}");
                (!self.inside.is_empty()).then(|| Fault::new("refused", what))
            }
        }
    }

    fn violation(&self, question: &Question, triangles: &[[usize; 3]]) -> Option<Fault> {
        let points = &question.points;
        let edges = question.all_edges();
        let verdict = self.verify(question, &edges, triangles);
        let exist = triangles.as_flattened().iter().all(|&v| v < points.len());
        let is_right = exist
            && with_integers!(points, |exact| {
                let region = Region {
                    points: &exact,
                    edges: &edges,
                    inside: &self.inside,
                    outside: &self.outside,
                };
                region.is_filled_by(triangles, question.level)
            });
        assert_eq!(
            verdict.is_ok(),
            is_right,
            "{verdict:?} of {triangles:?} for\n{question:?}"
        );
        verdict.err()
    }

    fn verify(
        &self,
        question: &Question,
        edges: &[[usize; 2]],
        triangles: &[[usize; 3]],
    ) -> Result<(), Fault> {
        let points = &question.points;
        if self.inside.is_empty() && !self.outside.is_empty() {
            // There is no boundary to declare.
            let what = "the domain is empty, and there are triangles";
            return match triangles {
                [] => Ok(()),
                _ => Err(Fault::new("outside", what)),
            };
        }
        let verifier = Verifier::new().accept_clockwise(true).level(question.level);
        let (verdict, numbers): (Result<_, Violations>, Vec<usize>) = match question.domain {
            Domain::Hull => {
                let verdict = verifier.verify(points, edges, triangles);
                (verdict, (0..edges.len()).collect())
            }
            _ => {
                let sides = |t: &[usize; 3]| [0, 1, 2].map(|i| sorted([t[i], t[(i + 1) % 3]]));
                let is_in: BTreeSet<[usize; 2]> = self.inside.iter().flat_map(sides).collect();
                let result = triangulate(points, edges).expect("there is a right answer");
                let interior = question.interior(&result).expect("as above");
                let mut parts = Vec::new();
                for number in 0..edges.len() {
                    let chain: Vec<usize> = result.edge_chain(number).collect();
                    let pieces = chain.windows(2).map(|pair| [pair[0], pair[1]]);
                    parts.extend(
                        pieces
                            .filter(|&piece| is_in.contains(&sorted(piece)))
                            .map(|piece| (piece, number)),
                    );
                }
                let (parts, numbers): (Vec<[usize; 2]>, _) = parts.into_iter().unzip();
                let boundary = interior.boundary();
                let verdict = verifier
                    .boundary(&boundary)
                    .verify(points, &parts, triangles);
                (verdict, numbers)
            }
        };
        verdict.map(|_| ()).map_err(|violations| {
            let mut first = violations.list[0];
            if let Violation::MissingEdge { edge, .. } | Violation::BentEdge { edge, .. } =
                &mut first
            {
                *edge = numbers[*edge];
            }
            Fault::of(&first, points)
        })
    }
}

/// What is wrong with the answer to a question, if anything is. A program may refuse what has no right answer, and what
/// has no triangles.
///
/// # Panics
/// If two judges disagree.
pub(super) fn fault(question: &Question, outcome: &Outcome) -> Option<Fault> {
    let steps = question.operations.len();
    match outcome {
        Outcome::Failed(fault) => Some(fault.clone()),
        _ if steps == 0 => match (Right::of(question), outcome) {
            (Ok(right), _) => right.fault(question, outcome),
            (Err(_), Outcome::Refused(_)) => None,
            (Err(hopeless), _) => Some(Fault::new("answered", hopeless.to_string())),
        },
        Outcome::After(states) if states.len() == steps => {
            let mut states = (1..).zip(states);
            states.find_map(|(steps, triangles)| fault_after(question, steps, triangles))
        }
        Outcome::After(states) => {
            let what = format!(
                "{} lists of triangles after {steps} operations",
                states.len()
            );
            Some(Fault::new("unreadable", what))
        }
        Outcome::Triangles(triangles) => fault_after(question, steps, triangles),
        Outcome::Refused(_) => of_points(&question.after(steps), outcome),
    }
}

/// What is wrong with the triangles after so many operations.
fn fault_after(question: &Question, steps: usize, triangles: &[[usize; 3]]) -> Option<Fault> {
    let present = question.present(steps);
    let place = |v: &usize| present.binary_search(v).map_err(|_| *v);
    let corners = triangles.as_flattened().iter().map(place);
    let corners: Vec<usize> = match corners.collect() {
        Ok(corners) => corners,
        Err(v) => {
            let what = format!("after {steps} operations point {v} is not there, and is a corner");
            return Some(Fault::new("triangle-out-of-range", what));
        }
    };
    let triangles = Outcome::Triangles(corners.as_chunks().0.to_vec());
    let Fault { name, what } = of_points(&question.after(steps), &triangles)?;
    let what = format!(
        "after {steps} operations, with the points {present:?} as vertices 0, 1, ...: {what}"
    );
    Some(Fault::new(name, what))
}

/// What is wrong with the answer to a question about points alone.
fn of_points(question: &Question, outcome: &Outcome) -> Option<Fault> {
    let right = Right::of(question).expect("points alone have a triangulation");
    right.fault(question, outcome)
}

impl Question {
    /// The domain by the rules of this crate, in the triangulation with all edges.
    ///
    /// # Errors
    /// [`InteriorError`], if the edges are no closed rings, of which the domain asks.
    pub fn interior<'a>(&self, result: &'a Triangulation) -> Result<Interior<'a>, InteriorError> {
        match self.domain {
            Domain::Hull => result.interior(FillRule::Hull),
            Domain::EvenOdd => result.interior(FillRule::EvenOdd),
            Domain::NonZero => result.interior(FillRule::NonZero),
            Domain::Polygons => {
                let numbered = self.polygons.iter().zip(0..);
                let rings = numbered.flat_map(|(rings, polygon)| {
                    (0..rings.len()).map(move |at| Ring {
                        polygon,
                        is_hole: at > 0,
                    })
                });
                let mut ring_of = vec![None; self.edges.len()];
                for (number, ring) in self.rings().enumerate() {
                    ring_of.extend(ring.iter().map(|_| Some(number)));
                }
                let rings: Vec<Ring> = rings.collect();
                result.interior_of_polygons(&rings, &ring_of)
            }
        }
    }
}

/// Whether a triangle is in the domain by the oracle.
fn with_rays(question: &Question, edges: &[[usize; 2]], triangle: [usize; 3]) -> bool {
    let sides = |rings: &Vec<Vec<usize>>| rings.iter().map(|r| ring_sides(r).collect()).collect();
    let polygons: Vec<Vec<Vec<[usize; 2]>>> = question.polygons.iter().map(sides).collect();
    with_integers!(&question.points, |exact| question
        .domain
        .holds(&exact, edges, &polygons, triangle))
}
