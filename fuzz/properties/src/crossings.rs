//! All edges that cross are listed, and split at their crossings they have a right triangulation.
//!
//! The judge is [`arrangement`], which tries every pair of edges in fractions and shares no code with the crate. The
//! triangulations of the pieces are tested by the verifier and by the oracle's local tests.

use num_rational::BigRational;
use sweep_cdt::crossings::{Crossing, Effort, Split, crossings, crossings_with, split};
use sweep_cdt::scalar::Scalar;
use sweep_cdt::{Error, Triangulation};
use sweep_cdt_testing::oracle::arrangement::{self, Exact, fractions, is_nearest};
use sweep_cdt_testing::oracle::{Graph, check_answer, found};
use sweep_cdt_testing::tuned::triangulate;
use sweep_cdt_testing::{Input, with_integers};

/// So many edges are listed: each may cross all others.
const LISTED: usize = 16;
/// So many edges are split: the judge tries everything.
const EDGES: usize = 10;
/// So many edges are split where fractions have hundreds of digits.
const FAR_EDGES: usize = 4;

/// The outcome of a split in doubles.
#[derive(Clone, Copy, Debug, Default)]
pub struct Rounded {
    /// How many pairs of edges cross.
    pub crossings: usize,
    /// How many rounds it took.
    pub rounds: usize,
    /// By how many units in the last place an edge moved at most.
    pub displacement: f64,
}

/// Panics unless the edges that cross in this input, all of whose coordinates are finite, are listed.
pub fn judge_listed(Input { points, edges }: &Input) {
    let edges = &edges[..edges.len().min(LISTED)];
    let mut tried = with_integers!(points, |exact| Graph::new(&exact, edges).crossings());
    tried.sort_unstable();
    // Small inputs are searched as if they were large, too.
    for patience in [0, Effort::default().patience] {
        let effort = &mut Effort {
            patience,
            ..Effort::default()
        };
        let found = crossings_with(points, edges, effort).expect("a valid input");
        let found: Vec<[usize; 2]> = found.iter().map(|crossing| crossing.edges).collect();
        assert_eq!(found, tried, "crossings listed (left) and tried");
    }
}

/// Panics unless the crossings of this input, all of whose coordinates are finite, are right, and its edges are split
/// rightly, exactly and rounded.
pub fn judge(input: &Input) -> Rounded {
    let points = &input.points;
    let most = if are_far(points) { FAR_EDGES } else { EDGES };
    let edges = &input.edges[..input.edges.len().min(most)];
    let exact = fractions(points);
    let crossing = arrangement::crossings(&exact, edges);
    let in_doubles = crossings(points, edges).expect("a valid input");
    let in_fractions = crossings(&exact, edges).expect("a valid input");
    let listed = |found: &Crossing<f64>| (found.edges, found.point());
    let in_doubles_listed: Vec<_> = in_doubles.iter().map(listed).collect();
    assert_eq!(
        in_doubles_listed, crossing,
        "crossings listed (left) and tried"
    );
    let listed = |found: &Crossing<BigRational>| (found.edges, found.point_rounded());
    let in_fractions: Vec<_> = in_fractions.iter().map(listed).collect();
    assert_eq!(
        in_fractions, crossing,
        "crossings in fractions (left) and tried"
    );
    for found in &in_doubles {
        let (near, nearest) = (found.point_f64(), found.point_rounded());
        assert_eq!(near, nearest, "the nearest doubles");
        for (near, exact) in near.into_iter().zip(&found.point()) {
            assert!(is_nearest(near, exact), "{near} is not nearest to {exact}");
        }
    }
    let refused = matches!(triangulate(points, edges), Err(Error::CrossingEdges { .. }));
    assert_eq!(
        refused,
        !crossing.is_empty(),
        "edges that cross are refused"
    );

    judge_exact(&exact, edges, &crossing);
    let split = split(points, edges).expect("few rounds");
    judge_rounded(&exact, edges, &crossing, &split);
    Rounded {
        crossings: crossing.len(),
        rounds: split.rounds,
        displacement: split.displacement,
    }
}

/// Whether coordinates are of very different sizes, so that fractions have hundreds of digits.
fn are_far(points: &[[f64; 2]]) -> bool {
    let sizes = points.iter().flatten().filter(|x| **x != 0.0);
    let sizes = sizes.map(|x| x.abs().log2());
    let (least, most) = sizes.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), size| {
        (least.min(size), most.max(size))
    });
    most - least > 200.0
}

/// Splits in fractions: the vertices along each edge are all points and crossings on it.
fn judge_exact(points: &[Exact], edges: &[[usize; 2]], crossing: &[([usize; 2], Exact)]) {
    let split = split(points, edges).expect("a valid input");
    let result = triangulated(&split, &split.points, points, edges);
    assert_eq!(split.rounds, usize::from(!crossing.is_empty()), "rounds");
    assert_eq!(split.displacement, 0.0, "a fraction moves");
    let mut expected: Vec<Exact> = crossing.iter().map(|(_, point)| point.clone()).collect();
    expected.sort();
    expected.dedup();
    let mut added = split.points[points.len()..].to_vec();
    added.sort();
    assert_eq!(added, expected, "new vertices (left)");
    let chains = arrangement::chains(points, edges);
    for (e, expected) in chains.into_iter().enumerate() {
        let chain = split.chain(e, &result).into_iter();
        let chain: Vec<Exact> = chain.map(|v| split.points[v].clone()).collect();
        assert_eq!(chain, expected, "the vertices along edge {e} (left)");
    }
}

/// Judges edges split in doubles: no pieces cross, each edge goes through its rounded crossings, and moves as little
/// as is said.
fn judge_rounded(
    points: &[Exact],
    edges: &[[usize; 2]],
    crossing: &[([usize; 2], Exact)],
    split: &Split<f64>,
) {
    let exact = fractions(&split.points);
    let result = triangulated(split, &exact, points, edges);
    let left = arrangement::crossings(&exact, &split.edges);
    assert!(left.is_empty(), "pieces that cross: {left:?}");
    for (pair, at) in crossing {
        for &edge in pair {
            let chain = split.chain(edge, &result).into_iter();
            let mut chain = chain.map(|v| split.points[v]);
            let is_nearest = |[x, y]: [f64; 2]| is_nearest(x, &at[0]) && is_nearest(y, &at[1]);
            assert!(chain.any(is_nearest), "edge {edge} is not split at {at:?}");
        }
    }
    let mut moves = Vec::new();
    for (e, edge) in edges.iter().enumerate() {
        let ends = edge.map(|v| &points[v]);
        let units = [0, 1].map(|i| {
            let [a, b] = edge.map(|v| split.points[v][i].abs());
            arrangement::unit(a.max(b))
        });
        for v in split.edges[split.pieces(e)].as_flattened() {
            moves.push(arrangement::distance(&exact[*v], ends, &units));
        }
    }
    let displacement = moves.iter().max().map_or(0.0, Scalar::approx);
    assert_eq!(
        split.displacement, displacement,
        "displacement (right: tried)"
    );
    assert!(2.0 * displacement <= split.rounds as f64, "moved too far");
}

/// The triangulation of the pieces, which the verifier and the oracle accept, and in which each edge runs from its
/// first end to its second.
fn triangulated<S: Scalar>(
    split: &Split<S>,
    exact: &[Exact],
    points: &[Exact],
    edges: &[[usize; 2]],
) -> Triangulation {
    assert_eq!(&exact[..points.len()], points, "the points are kept");
    let result = triangulate(&split.points, &split.edges).expect("no pieces cross");
    let report = result.with_points(&split.points).verify(&split.edges);
    assert!(report.expect("a right result").is_canonical());
    let answer = found(&result, exact.len(), split.edges.len());
    with_integers!(exact, |exact| check_answer(&exact, &split.edges, &answer));
    assert_eq!(split.edges.len(), split.pieces_of.len());
    for (e, edge) in edges.iter().enumerate() {
        let chain = split.chain(e, &result);
        let ends = edge.map(|v| result.representative(v));
        assert_eq!([chain.first(), chain.last()], ends.each_ref().map(Some));
        for pair in chain.windows(2) {
            let near = split.pieces(e).any(|piece| {
                let part: Vec<usize> = result.edge_chain(piece).collect();
                part.windows(2)
                    .any(|side| side == pair || side == [pair[1], pair[0]])
            });
            assert!(near, "{pair:?} of the chain of edge {e} is no side");
        }
    }
    result
}
