//! The edges of an input.

use arbitrary::{Result, Unstructured};
use robust::{Coord, orient2d};

use super::bytes::EDGES;

/// How edges join the points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pattern {
    /// Not at all, beyond what belongs to the shape.
    None,
    /// Any two, as the bytes say; many cross, overlap, or have no length.
    Pairs,
    /// All from one point: many edge events at once, or at one lower end.
    Fan,
    /// In the order of the points: a path, and a closed one.
    Path,
    /// A closed path in the order of the points.
    Ring,
    /// From left to right, then over ever more points at once: overlaps on a line, chords over a comb.
    Chords,
    /// The first with the last in sweep order, the second with the last but one: long nested edges.
    Nested,
    /// Short and long ones: each point with the one before, and some with a far one.
    Mixed,
}

impl Pattern {
    /// Each of them.
    pub const ALL: [Pattern; 8] = [
        Pattern::None,
        Pattern::Pairs,
        Pattern::Fan,
        Pattern::Path,
        Pattern::Ring,
        Pattern::Chords,
        Pattern::Nested,
        Pattern::Mixed,
    ];
}

/// Edges in this pattern, from the bytes that are left.
pub(super) fn read(
    pattern: Pattern,
    points: &[[f64; 2]],
    bytes: &mut Unstructured<'_>,
) -> Result<Vec<[usize; 2]>> {
    let n = points.len();
    if n == 0 {
        return Ok(Vec::new());
    }
    let mut by_x: Vec<usize> = (0..n).collect();
    by_x.sort_by(|&v, &w| {
        points[v][0]
            .total_cmp(&points[w][0])
            .then(points[v][1].total_cmp(&points[w][1]))
    });
    let mut by_y: Vec<usize> = (0..n).collect();
    by_y.sort_by(|&v, &w| {
        points[v][1]
            .total_cmp(&points[w][1])
            .then(points[v][0].total_cmp(&points[w][0]))
    });
    let hub = usize::from(bytes.arbitrary::<u8>()?) % n;
    let mut edges = Vec::new();
    while edges.len() < EDGES && !bytes.is_empty() {
        let i = edges.len();
        let place = usize::from(bytes.arbitrary::<u8>()?);
        edges.push(match pattern {
            Pattern::None => break,
            Pattern::Pairs => [place % n, usize::from(bytes.arbitrary::<u8>()?) % n],
            Pattern::Fan => [hub, place % n],
            Pattern::Path => [i % n, (i + 1).min(n - 1)],
            Pattern::Ring => [i % n, (i + 1) % n],
            Pattern::Chords => {
                let reach = 1 + place / 64 * (place / 64);
                [by_x[place % n], by_x[(place % n + reach).min(n - 1)]]
            }
            Pattern::Nested => [by_y[place % n], by_y[n - 1 - place % n]],
            Pattern::Mixed if place < 64 => [hub, place % n],
            Pattern::Mixed => [place % n, (place + 1) % n],
        });
    }
    Ok(edges)
}

/// Drops the later edge of each two that cross outside of the points.
///
/// The adaptive predicates are wrong only where products underflow or overflow. That may drop an edge too
/// many or too few, which does no harm here.
pub fn drop_crossings(points: &[[f64; 2]], edges: &mut Vec<[usize; 2]>) {
    let turn = |a: usize, b: usize, c: usize| {
        let [a, b, c] = [a, b, c].map(|v| Coord {
            x: points[v][0],
            y: points[v][1],
        });
        orient2d(a, b, c)
    };
    let are_apart = |x: f64, y: f64| (x > 0.0 && y < 0.0) || (x < 0.0 && y > 0.0);
    let cross = |[a, b]: [usize; 2], [c, d]: [usize; 2]| {
        are_apart(turn(a, b, c), turn(a, b, d))
            && are_apart(turn(c, d, a), turn(c, d, b))
            && !(0..points.len()).any(|v| turn(a, b, v) == 0.0 && turn(c, d, v) == 0.0)
    };
    let mut kept: Vec<[usize; 2]> = Vec::with_capacity(edges.len());
    for &edge in edges.iter() {
        if !kept.iter().any(|&other| cross(edge, other)) {
            kept.push(edge);
        }
    }
    *edges = kept;
}
