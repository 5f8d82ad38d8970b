//! Is this the canonical triangulation? Tests for results of any size.
//!
//! If all triangles turn left, no side is used twice in one direction, and the sides used in one
//! direction only are exactly the border of the convex hull, once around, then the triangles tile the
//! hull. If each edge is a chain of sides, these are marked and no others, and every other inner side
//! passes the local test, then it is the constrained Delaunay triangulation; the rule for four vertices
//! on a circle makes it the canonical one.

use std::cmp::Ordering::{Equal, Greater, Less};
use std::collections::{BTreeSet, HashMap};

use sweep_cdt::Triangulation;

use super::answer::{Answer, ends, found, sorted};
use super::graph::representatives;
use super::numbers::{Number, Point, in_circle, lowering, orient, sweep};
use crate::with_integers;

/// Panics, saying what is wrong, unless `result` is what it must be. Returns the answer.
pub fn check(points: &[[f64; 2]], edges: &[[usize; 2]], result: &Triangulation) -> Answer {
    let answer = found(result, points.len(), edges.len());
    check_found(points, edges, &answer);
    answer
}

/// Checks an answer that is found already.
pub fn check_found(points: &[[f64; 2]], edges: &[[usize; 2]], answer: &Answer) {
    with_integers!(points, |exact| check_answer(&exact, edges, answer));
}

/// Panics, saying what is wrong, unless this answer is what it must be.
pub fn check_answer<N: Number>(points: &[Point<N>], edges: &[[usize; 2]], answer: &Answer) {
    assert_eq!(answer.representatives, representatives(points));
    let vertices: Vec<usize> = (0..points.len())
        .filter(|&v| answer.representatives[v] == v)
        .collect();
    check_chains(points, edges, answer);
    if vertices
        .iter()
        .skip(2)
        .all(|&v| turn(points, vertices[0], vertices[1], v) == Equal)
    {
        assert!(
            answer.triangles.is_empty() && answer.hull.is_empty(),
            "flat, but has triangles"
        );
        return;
    }
    let apexes = apexes(&answer.triangles);
    for &[a, b, c] in &answer.triangles {
        assert_eq!(
            turn(points, a, b, c),
            Greater,
            "triangle [{a}, {b}, {c}] does not turn left"
        );
    }
    check_tiling(points, &vertices, answer, &apexes);
    let pieces = pieces(answer);
    for &[a, b] in &pieces {
        let is_side = apexes.contains_key(&[a, b]) || apexes.contains_key(&[b, a]);
        assert!(is_side, "the piece [{a}, {b}] of an edge is no side");
    }
    assert_eq!(
        answer.constrained,
        Vec::from_iter(pieces.clone()),
        "the constrained sides"
    );
    for (&[a, b], &c) in &apexes {
        let Some(&d) = apexes.get(&[b, a]) else {
            continue;
        };
        if a < b && !pieces.contains(&[a, b]) {
            check_side(points, [a, b], c, d);
        }
    }
}

fn turn<N: Number>(points: &[Point<N>], a: usize, b: usize, c: usize) -> std::cmp::Ordering {
    orient(&points[a], &points[b], &points[c])
}

/// For each side, with its triangle to the left, the corner opposite.
fn apexes(triangles: &[[usize; 3]]) -> HashMap<[usize; 2], usize> {
    let mut apexes = HashMap::new();
    for &corners in triangles {
        for side in 0..3 {
            let [a, b] = ends(corners, side);
            let before = apexes.insert([a, b], corners[side]);
            assert_eq!(
                before, None,
                "side [{a}, {b}] is used twice in one direction"
            );
        }
    }
    apexes
}

/// Whether the triangles tile the convex hull and use every vertex.
fn check_tiling<N: Number>(
    points: &[Point<N>],
    vertices: &[usize],
    answer: &Answer,
    apexes: &HashMap<[usize; 2], usize>,
) {
    let hull = convex_hull(points, vertices);
    assert_eq!(answer.hull, hull, "the hull");
    let around = |i: usize| [hull[i], hull[(i + 1) % hull.len()]];
    let expected: BTreeSet<[usize; 2]> = (0..hull.len()).map(around).collect();
    let border: BTreeSet<[usize; 2]> = apexes
        .keys()
        .copied()
        .filter(|&[a, b]| !apexes.contains_key(&[b, a]))
        .collect();
    assert_eq!(
        border, expected,
        "the sides without a neighbour are not the hull's"
    );
    assert_eq!(
        answer.triangles.len(),
        2 * vertices.len() - 2 - hull.len(),
        "number of triangles"
    );
    let used: BTreeSet<usize> = answer.triangles.iter().flatten().copied().collect();
    assert_eq!(Vec::from_iter(used), vertices, "the vertices used");
}

/// The convex hull with the vertices on its straight stretches, counter-clockwise, from the leftmost
/// and upper one: two chains, below and above, by Andrew's scan.
fn convex_hull<N: Number>(points: &[Point<N>], vertices: &[usize]) -> Vec<usize> {
    let mut order = vertices.to_vec();
    order.sort_by(|&v, &w| lowering(&points[v], &points[w]));
    let scan = |order: &mut dyn Iterator<Item = usize>| {
        let mut chain: Vec<usize> = Vec::new();
        for v in order {
            while let [.., a, b] = chain[..]
                && turn(points, a, b, v) == Less
            {
                chain.pop();
            }
            chain.push(v);
        }
        chain.pop();
        chain
    };
    let mut hull = scan(&mut order.iter().copied());
    hull.extend(scan(&mut order.iter().rev().copied()));
    hull
}

/// Whether each edge's chain leads along it from its first to its second end.
fn check_chains<N: Number>(points: &[Point<N>], edges: &[[usize; 2]], answer: &Answer) {
    for (e, &edge) in edges.iter().enumerate() {
        let [a, b] = edge.map(|v| answer.representatives[v]);
        let chain = &answer.chains[e];
        assert_eq!(
            (chain.first(), chain.last()),
            (Some(&a), Some(&b)),
            "ends of edge {e}"
        );
        assert_eq!(a == b, chain.len() == 1, "edge {e} has a length or none");
        let way = sweep(&points[a], &points[b]);
        for pair in chain.windows(2) {
            assert_eq!(
                turn(points, a, b, pair[1]),
                Equal,
                "chain of edge {e} bends"
            );
            let step = sweep(&points[pair[0]], &points[pair[1]]);
            assert_eq!(step, way, "chain of edge {e} turns back");
        }
    }
}

fn pieces(answer: &Answer) -> BTreeSet<[usize; 2]> {
    let pairs = answer.chains.iter().flat_map(|chain| chain.windows(2));
    pairs.map(|pair| sorted([pair[0], pair[1]])).collect()
}

/// The local test of an inner side that is free to be flipped, and the rule for ties.
fn check_side<N: Number>(points: &[Point<N>], [a, b]: [usize; 2], c: usize, d: usize) {
    match in_circle(&points[a], &points[b], &points[c], &points[d]) {
        Greater => panic!("side [{a}, {b}] is not Delaunay: {d} lies inside the circle with {c}"),
        Equal => {
            let least = [a, b, c, d]
                .into_iter()
                .min_by(|&v, &w| lowering(&points[v], &points[w]));
            let kept = least == Some(a) || least == Some(b);
            assert!(
                kept,
                "side [{a}, {b}], cocircular with {c} and {d}, is not the canonical one"
            );
        }
        Less => {}
    }
}

/// The sides that no choice among cocircular triangles can change: constrained ones, the hull's, and
/// those that are strictly Delaunay. Lower vertex first.
pub fn firm_sides(points: &[[f64; 2]], answer: &Answer) -> BTreeSet<[usize; 2]> {
    with_integers!(points, |exact| firm(&exact, answer))
}

fn firm<N: Number>(points: &[Point<N>], answer: &Answer) -> BTreeSet<[usize; 2]> {
    let apexes = apexes(&answer.triangles);
    let pieces = pieces(answer);
    let is_firm = |&(&[a, b], &c): &(&[usize; 2], &usize)| match apexes.get(&[b, a]) {
        Some(&d) => {
            pieces.contains(&sorted([a, b]))
                || in_circle(&points[a], &points[b], &points[c], &points[d]) != Equal
        }
        None => true,
    };
    apexes
        .iter()
        .filter(is_firm)
        .map(|(&side, _)| sorted(side))
        .collect()
}
