//! Every structured input gives the right triangulation or the right error. Where edges cross, all that cross are
//! listed, and split where they do they have a right triangulation ([`crossings`]).
//!
//! Three judges: the verifier of the crate, which shares the signs of `src/scalar` (filter and exact
//! predicates) with the sweep and nothing else; [`check`], which shares no code with the crate and tests
//! sides one by one in integers; and for small inputs [`verdict`], which builds the answer from its
//! definition.

use sweep_cdt::Error;
use sweep_cdt_testing::tuned::triangulate;

use crate::{crossings, reached, share};
use sweep_cdt_testing::oracle::{check, crosses, verdict};
use sweep_cdt_testing::{Input, generators};

/// Up to this many points the answer is built from its definition.
const BY_DEFINITION: usize = 6;
/// One in so many inputs has its edges split where they cross.
const SPLIT: u64 = 4;

/// The property for the input that the bytes stand for.
pub fn test(bytes: &[u8]) {
    let input = generators::input(bytes);
    reached::sample(&input);
    judge_share(&input, bytes);
}

/// Panics unless the result is right for this input, all of whose coordinates are finite. The bytes that it comes from
/// choose whether crossings are judged in all ways.
pub(crate) fn judge_share(input: &Input, bytes: &[u8]) {
    if share::is_chosen(bytes, SPLIT) {
        judge(input, |input| {
            crossings::judge(input);
        });
    } else {
        judge(input, crossings::judge_listed);
    }
}

fn judge(input: &Input, judge_crossings: impl Fn(&Input)) {
    let Input { points, edges } = input;
    let outcome = triangulate(points, edges);
    let answer = match &outcome {
        Ok(result) => {
            let report = result
                .with_points(points)
                .verify(edges)
                .expect("the verifier accepts the result");
            assert!(
                report.is_canonical(),
                "the verifier finds the result canonical"
            );
            Some(check(points, edges, result))
        }
        Err(Error::CrossingEdges { edges: pair }) => {
            assert!(crosses(points, edges, *pair), "{pair:?} do not cross");
            judge_crossings(input);
            None
        }
        Err(error) => panic!("no reason for: {error}"),
    };
    if points.len() <= BY_DEFINITION {
        assert_eq!(verdict(points, edges).ok(), answer, "the definition (left)");
    }
}
