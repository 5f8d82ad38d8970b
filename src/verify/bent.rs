//! Chains of sides that run beside a straight line: added points whose coordinates were rounded lie beside the edge that
//! they split. The verifier takes such a chain for the edge, and reports how far it is off.
//!
//! The line from a vertex on an edge passes through a strip of triangles. Each side that it crosses has an end on the
//! left and one on the right, and the next one shares an end with it. So a choice of one end of each is a chain of sides.
//!
//! ```text
//!        l1 ------- l2          at, r1, r2, to: the chain. The edge runs from at to the right, through the
//!       /  \  .-'' /  \         sides r1-l1, r1-l2, r2-l2. Between the chain and the edge there is no vertex,
//!     at ...\'..../....to       since all those of the strip are left or right of the edge.
//!       \ .-'\   / .-'
//!        r1 --- r2
//! ```
//!
//! Why it is enough that no vertex of the input is between a chain and its edge, that chains go forward, and that two
//! share an added point only where their edges cross or overlap: then all edges can be moved to their chains at once,
//! without passing a vertex or each other. So the chains lie among the vertices, and the edges among each other, as in
//! the input. The chain chosen is one whose farthest vertex is nearest. All its vertices between are added points: the
//! input's own vertices are where they are. Depths choose a chain; what is asked of it is decided by exact signs.
//! Cost: O(s) depths for a strip of s triangles, and the pairs of edges that cross at an added point beside them.

use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Ordering;

use super::sides::Sides;
use super::soup::Soup;
use crate::scalar::Scalar;

/// A chain of sides beside a line.
#[derive(Debug)]
pub(super) struct Bend {
    /// The vertices of the chain. The first and the last are on the line, and all between are added points.
    pub(super) vertices: Vec<u32>,
    /// The vertex that is farthest from the line, and how far, in units of the length of the edge.
    pub(super) farthest: (u32, f64),
}

impl Bend {
    /// The chain, if it goes forward along the line from `a` to `b` and its vertices can be measured.
    ///
    /// From v to w it goes forward if a-v-w and v-w-b both turn by less than a right angle: the sum of the two scalar
    /// products is that of v-w and a-b less the square of v-w.
    pub(super) fn of<S: Scalar>(
        soup: &Soup<'_, S>,
        [a, b]: [u32; 2],
        vertices: Vec<u32>,
    ) -> Option<Bend> {
        let goes_on = |turn: [u32; 3]| {
            turn[0] == turn[1] || turn[1] == turn[2] || soup.height(turn).is_some()
        };
        let goes_forward = |side: &[u32]| {
            let [v, w] = [side[0], side[1]];
            goes_on([a, v, w]) && goes_on([v, w, b])
        };
        if !vertices.windows(2).all(goes_forward) {
            return None;
        }
        let mut farthest = (a, 0.0);
        for &v in &vertices[1..vertices.len() - 1] {
            let distance = soup.height([a, v, b])?.abs();
            if distance > farthest.1 {
                farthest = (v, distance);
            }
        }
        Some(Bend { vertices, farthest })
    }
}

/// The chain beside the line from `a` to `b`, from a vertex `at` on it up to the next one on it. The line leaves `at`
/// between two neighbours, `right` and `left` of it.
pub(super) fn beside<S: Scalar>(
    soup: &Soup<'_, S>,
    sides: &Sides,
    [a, b]: [u32; 2],
    at: u32,
    [mut right, mut left]: [u32; 2],
) -> Option<Bend> {
    let turn = |vertices| soup.turn(vertices);
    if sides.apex(soup, at, right) != Some(left) {
        return None;
    }
    // The distance of a vertex that a chain may pass.
    let distance = |v: u32| {
        let is_added = soup.is_added(v);
        let height = || soup.height([a, v, b]);
        let height = is_added.then(height).flatten();
        height.map_or(f64::INFINITY, f64::abs)
    };
    // The ends of the sides that the line crosses, each with its distance; on every side the nearer one will do.
    let mut crossed = Vec::new();
    let mut ends = [right, left].map(|v| (v, distance(v)));
    let mut most = 0.0_f64;
    let to = loop {
        crossed.push(ends);
        most = most.max(ends[0].1.min(ends[1].1));
        if most.is_infinite() || turn([right, left, b]).is_ge() {
            return None;
        }
        let next = sides.apex(soup, left, right)?;
        match turn([a, b, next]) {
            Ordering::Greater => (left, ends[1]) = (next, (next, distance(next))),
            Ordering::Less => (right, ends[0]) = (next, (next, distance(next))),
            Ordering::Equal => break next,
        }
    };
    // The chain stays at a vertex as long as it can, so that it passes none twice.
    let mut vertices = vec![at];
    for [right, left] in crossed {
        let last = vertices[vertices.len() - 1];
        if last != right.0 && last != left.0 {
            vertices.push(if right.1 < left.1 { right.0 } else { left.0 });
        }
    }
    vertices.push(to);
    Bend::of(soup, [a, b], vertices)
}

/// Whether a chain is straight.
pub(super) fn is_straight<S: Scalar>(soup: &Soup<'_, S>, chain: &[u32]) -> bool {
    let order = |side: &[u32]| soup.order(side[0], side[1]);
    let turn = |turn: &[u32]| soup.turn([turn[0], turn[1], turn[2]]);
    chain
        .windows(3)
        .all(|three| turn(three).is_eq() && order(&three[..2]) == order(&three[1..]))
}

/// A vertex between the line from `c` to `d` and a chain on the boundary, of which `c` and `d` are the ends, or on the line
/// and not on the chain. Where the chain is right of the line, triangles are between; all those at its vertices there
/// must reach the line, and then they cover all of what is between. Where it is left, there are no triangles, and
/// vertices there are in none.
pub(super) fn between<S: Scalar>(
    soup: &Soup<'_, S>,
    sides: &Sides,
    [c, d]: [u32; 2],
    chain: &[u32],
) -> Option<u32> {
    let turn = |v| soup.turn([c, d, v]);
    let mut own = chain.to_vec();
    own.sort_unstable();
    let is_between = |v: u32| {
        let is_beyond = || soup.order(c, v) != soup.order(v, d);
        own.binary_search(&v).is_err()
            && match turn(v) {
                Ordering::Greater => false,
                Ordering::Equal => !is_beyond(),
                Ordering::Less => true,
            }
    };
    chain.windows(2).skip(1).find_map(|side| {
        let [v, mut last] = [side[0], side[1]];
        if turn(v).is_ge() {
            return None;
        }
        while let Some(next) = sides.apex(soup, v, last) {
            if is_between(next) {
                return Some(next);
            }
            last = next;
        }
        None
    })
}

/// A vertex that the line of an edge passes, on it or beside it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pass {
    pub(super) vertex: u32,
    /// The ends of the edge, or of the side of the boundary.
    pub(super) line: [u32; 2],
    /// The number of the edge; none of a side of the boundary.
    pub(super) edge: Option<usize>,
    pub(super) is_beside: bool,
}

/// The edges that share an added point beside one of them with another line that they neither cross nor overlap, with the
/// point.
pub(super) fn pinched<S: Scalar>(soup: &Soup<'_, S>, mut passes: Vec<Pass>) -> Vec<(usize, u32)> {
    let turn = |[a, b]: [u32; 2], v| soup.turn([a, b, v]);
    let cross = |one: [u32; 2], other: [u32; 2]| {
        let apart = |one, [c, d]: [u32; 2]| {
            let turns = [turn(one, c), turn(one, d)];
            (turns[0] == turns[1].reverse()).then_some(turns[0])
        };
        let [of_one, of_other] = [apart(one, other), apart(other, one)];
        of_one.is_some()
            && of_other.is_some()
            && of_one.map(Ordering::is_eq) == of_other.map(Ordering::is_eq)
    };
    passes.sort_by_key(|pass| pass.vertex);
    let mut found = Vec::new();
    for group in passes.chunk_by(|one, other| one.vertex == other.vertex) {
        if !group.iter().any(|pass| pass.is_beside) {
            continue;
        }
        // The first pair that does not cross ends the search, so it takes as long as there are crossings.
        let pairs = (1..group.len()).flat_map(|i| (0..i).map(move |j| [&group[i], &group[j]]));
        let apart = pairs
            .filter(|[one, other]| one.edge.or(other.edge).is_some())
            .find(|[one, other]| !cross(one.line, other.line));
        let edge = apart.and_then(|[one, other]| one.edge.or(other.edge));
        found.extend(edge.map(|edge| (edge, group[0].vertex)));
    }
    found
}
