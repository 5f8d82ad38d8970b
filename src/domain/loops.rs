//! The boundary of a set of triangles, as closed chains with the set on their left.
//!
//! From the end of a side the chain goes on along the next side of the same triangle. If the triangle across that
//! side is in the set, it is the turn of that one, and so on around the vertex.
//!
//! ```text
//!           \  t2 /
//!       next \   / t1        From side a-v of t0 around v, through t1 and t2, which are in the set: the
//!             \ /            chain goes on along the last side of t2.
//!      ------- v -------
//!             /  t0
//!            a
//! ```
//!
//! Where the set meets itself in a vertex only, the chain so stays with the triangles that are connected. A chain
//! may pass a vertex more than once, but no side. What is returned depends on the set alone: each chain begins
//! with its lowest side, and they are sorted by it.
//!
//! Cost: O(b log b) for b sides, the scan of all triangles, and of those around each vertex of the boundary.

use crate::Triangulation;

/// The closed chains around the triangles that are inside.
pub(super) fn loops(result: &Triangulation, is_inside: impl Fn(usize) -> bool) -> Vec<Vec<usize>> {
    let is_beyond = |t: usize, side| result.neighbor(t, side).is_none_or(|t| !is_inside(t));
    let mut borders: Vec<([usize; 2], usize)> = (0..result.len())
        .filter(|&t| is_inside(t))
        .flat_map(|t| [0, 1, 2].map(|side| (t, side)))
        .filter(|&(t, side)| is_beyond(t, side))
        .map(|(t, side)| (ends(result, t, side), t))
        .collect();
    borders.sort_unstable();

    let mut is_passed = vec![false; borders.len()];
    let mut loops = Vec::new();
    for first in 0..borders.len() {
        let (mut at, mut chain) = (first, Vec::new());
        while !is_passed[at] {
            is_passed[at] = true;
            let ([from, vertex], mut t) = borders[at];
            chain.push(from);
            let mut side = leaving(result, t, vertex);
            while !is_beyond(t, side) {
                t = result.neighbor(t, side).expect("it is inside");
                side = leaving(result, t, vertex);
            }
            let next = borders.binary_search(&(ends(result, t, side), t));
            at = next.expect("all sides of the boundary are listed");
        }
        if !chain.is_empty() {
            loops.push(chain);
        }
    }
    loops
}

/// The vertices of a side, with its triangle on the left.
pub(super) fn ends(result: &Triangulation, t: usize, side: usize) -> [usize; 2] {
    let corners = result.triangle(t);
    [corners[(side + 1) % 3], corners[(side + 2) % 3]]
}

/// The side of a triangle that starts at this corner of it.
fn leaving(result: &Triangulation, t: usize, vertex: usize) -> usize {
    let corner = result.triangle(t).iter().position(|&v| v == vertex);
    (corner.expect("the triangle has the vertex") + 2) % 3
}
