//! The verifier's judgement of an answer.

use sweep_cdt::verify::{Verifier, Violation};
use sweep_cdt_testing::Input;

/// What an answer is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Verdict {
    /// The constrained Delaunay triangulation of the input.
    Delaunay,
    /// A triangulation with all edges whose other sides are not all Delaunay.
    Triangulation,
    /// Neither.
    Wrong,
}

/// The worst verdict on the answers to these inputs. `is_inside`: they cover the polygon that the points
/// bound in their order, and not the hull.
pub(crate) fn judge(inputs: &[Input], answers: &[Vec<[usize; 3]>], is_inside: bool) -> Verdict {
    let verdicts = inputs
        .iter()
        .zip(answers)
        .map(|(input, triangles)| one(input, triangles, is_inside));
    verdicts.max().expect("an input")
}

fn one(input: &Input, triangles: &[[usize; 3]], is_inside: bool) -> Verdict {
    let ring = [(0..input.points.len()).collect()];
    let verifier = Verifier::new().accept_clockwise(true).limit(usize::MAX);
    let verifier = if is_inside {
        verifier.boundary(&ring)
    } else {
        verifier
    };
    match verifier.verify_parallel(&input.points, &input.edges, triangles) {
        Ok(_) => Verdict::Delaunay,
        Err(violations) => {
            let is_delaunay = |violation| matches!(violation, &Violation::NotDelaunay { .. });
            if violations.list.iter().all(is_delaunay) {
                Verdict::Triangulation
            } else {
                Verdict::Wrong
            }
        }
    }
}
