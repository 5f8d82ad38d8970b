//! The boundary: one closed convex chain that winds once, or the chains that the caller gave.
//!
//! Why winding is counted right: a chain that never turns right nor back turns by less than half a
//! turn at each vertex, so it cannot skip the half of all directions that ascend in the order (x, y).
//! Each full turn therefore enters that half once.

use std::cmp::Ordering;

use super::findings::Findings;
use super::input::Mesh;
use super::report::Violation;
use super::signs::Tally;
use crate::scalar::Scalar;

/// Checks that the open sides are one convex chain that winds once. There are triangles, all turn left, and
/// none has a side in common with another on the same side of it; so some sides are open: across a side
/// with two triangles as many of them cover the plane, and far away none does.
pub(super) fn check_hull<S: Scalar>(
    mesh: &Mesh<'_, S>,
    boundary: &[u32],
    tally: &mut Tally,
    findings: &mut Findings,
) {
    let mut open: Vec<[u32; 2]> = boundary.iter().map(|&side| mesh.side(side)).collect();
    open.sort_unstable();
    let pinched = open
        .windows(2)
        .filter(|w| w[0][0] == w[1][0])
        .map(|w| w[0][0]);
    let mut pinched: Vec<u32> = pinched.collect();
    pinched.dedup();
    for &v in &pinched {
        findings.add(Violation::PinchedBoundary {
            vertex: mesh.signs.name(v),
        });
    }
    if !pinched.is_empty() {
        return;
    }
    let mut chains = chains(&open);
    let lowest = |chain: &Vec<u32>| {
        chain
            .iter()
            .copied()
            .min_by(|&a, &b| mesh.signs.order(a, b))
    };
    let outer = (0..chains.len()).min_by(|&i, &j| {
        let least = |k: usize| lowest(&chains[k]).expect("no chain is empty");
        mesh.signs.order(least(i), least(j))
    });
    let outer = chains.swap_remove(outer.expect("triangles that turn left have a boundary"));
    for chain in &chains {
        let side = [chain[0], chain[1 % chain.len()]].map(|v| mesh.signs.name(v));
        findings.add(Violation::ExtraBoundary {
            side,
            sides: chain.len(),
        });
    }
    check_convex(mesh, &outer, tally, findings);
}

/// The closed chains of sides, given by start, of which each vertex starts at most one. As many sides end
/// in a vertex as start there, because each triangle's do, so that each chain goes on until it is closed.
fn chains(sides: &[[u32; 2]]) -> Vec<Vec<u32>> {
    let mut visited = vec![false; sides.len()];
    let mut result = Vec::new();
    for first in 0..sides.len() {
        let (mut at, mut chain) = (first, Vec::new());
        while !visited[at] {
            visited[at] = true;
            chain.push(sides[at][0]);
            let end = sides[at][1];
            at = sides.partition_point(|side| side[0] < end);
        }
        if !chain.is_empty() {
            result.push(chain);
        }
    }
    result
}

fn check_convex<S: Scalar>(
    mesh: &Mesh<'_, S>,
    chain: &[u32],
    tally: &mut Tally,
    findings: &mut Findings,
) {
    let at = |i: usize| chain[i % chain.len()];
    let (mut times, mut convex) = (0, true);
    for i in 0..chain.len() {
        let vertices @ [a, b, c] = [at(i), at(i + 1), at(i + 2)];
        let ascends = [mesh.signs.order(a, b), mesh.signs.order(b, c)].map(Ordering::is_lt);
        let goes_on = match mesh.signs.orient2d(vertices, tally) {
            Ordering::Greater => true,
            Ordering::Equal => ascends[0] == ascends[1],
            Ordering::Less => false,
        };
        if !goes_on {
            convex = false;
            let vertices = vertices.map(|v| mesh.signs.name(v));
            findings.add(Violation::ConcaveBoundary { vertices });
        }
        times += usize::from(ascends == [false, true]);
    }
    if convex && times != 1 {
        findings.add(Violation::WindingBoundary { times });
    }
}

/// Checks that the open sides are exactly those of the caller's chains, given by rank.
pub(super) fn check_declared<S: Scalar>(
    mesh: &Mesh<'_, S>,
    boundary: &[u32],
    declared: &[[u32; 2]],
    findings: &mut Findings,
) {
    let mut open: Vec<([u32; 2], u32)> = boundary
        .iter()
        .map(|&side| (mesh.side(side), side / 3))
        .collect();
    let mut declared = declared.to_vec();
    open.sort_unstable();
    declared.sort_unstable();
    for &(side, triangle) in &open {
        if declared.binary_search(&side).is_err() {
            let side = side.map(|v| mesh.signs.name(v));
            findings.add(Violation::UndeclaredBoundary {
                side,
                triangle: triangle as usize,
            });
        }
    }
    for (i, side) in declared.iter().enumerate() {
        let again = i > 0 && declared[i - 1] == *side;
        if again || open.binary_search_by_key(side, |open| open.0).is_err() {
            findings.add(Violation::MissingBoundary {
                side: side.map(|v| mesh.signs.name(v)),
            });
        }
    }
}

/// Whether the vertex lies inside the domain that the declared sides bound, or on its boundary: whether
/// they wind round it.
pub(super) fn is_inside<S: Scalar>(
    mesh: &Mesh<'_, S>,
    declared: &[[u32; 2]],
    v: u32,
    tally: &mut Tally,
) -> bool {
    let mut winding = 0;
    for &[a, b] in declared {
        let [below_a, below_b] = [a, b].map(|end| mesh.signs.order(end, v).is_lt());
        if below_a == below_b {
            continue;
        }
        // The side passes v in the order (x, y), on the side that the turn tells.
        match (mesh.signs.orient2d([a, b, v], tally), below_a) {
            (Ordering::Equal, _) => return true,
            (Ordering::Greater, true) => winding += 1,
            (Ordering::Less, false) => winding -= 1,
            _ => {}
        }
    }
    winding != 0
}
