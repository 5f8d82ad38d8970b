//! The flow of the edges along each side, and what it makes of each triangle.
//!
//! Every edge is a chain of sides, and counts as a *flow* of +1 along each in its direction. The flow of a side is the
//! sum over all edges. For the winding number the flow is what crossing the side changes. For crossing parity the flow
//! is odd where the number of edges on the side is odd, whatever their directions.
//!
//! The edges form closed chains if no flow starts or ends at a vertex: as much comes as goes. (For parity: the two
//! differ by an even number.) Then the sum over the sides that a closed path crosses is zero (even), because that holds
//! for a path around one vertex, and every path is a sum of these. So the path to a triangle makes no difference.
//!
//! Depths spread from the hull inwards, from triangle to triangle; the hull is connected, so every triangle is reached.
//! Cost: O(m log m), where m is the sum of the lengths of all chains; equal edges are walked once. Depths take O(n), as
//! each triangle is expanded once, and the search for the flow of each constrained side.

use super::error::InteriorError;
use crate::Triangulation;
use crate::ids::narrow;
use alloc::vec;
use alloc::vec::Vec;

#[derive(Debug)]
pub(super) struct Flow {
    /// Sides, lower vertex first, with the flow from there to the other one; sorted, none twice.
    sides: Vec<([u32; 2], i32)>,
    /// `(vertex, flow)`: the flow out of a vertex less that into it; sorted, no vertex twice, none zero.
    sources: Vec<(u32, i32)>,
}

impl Flow {
    /// The flow of all edges.
    pub(super) fn new(result: &Triangulation) -> Flow {
        let sorted = |&edge: &usize| {
            let [a, b] = result.chains.ends(edge);
            [a.min(b), a.max(b)]
        };
        let mut edges: Vec<usize> = (0..result.chains.len()).collect();
        edges.sort_unstable_by_key(sorted);
        let (mut sides, mut sources) = (Vec::new(), Vec::new());
        for equal in edges.chunk_by(|a, b| sorted(a) == sorted(b)) {
            // The flow from the first end of one of them to its second.
            let [first, last] = result.chains.ends(equal[0]);
            let runs_along = |&edge: &usize| result.chains.ends(edge)[0] == first;
            let steps = equal
                .iter()
                .map(|edge| if runs_along(edge) { 1 } else { -1 });
            let flow: i32 = steps.sum();
            if flow == 0 || first == last {
                continue;
            }
            sources.extend([(first, flow), (last, -flow)]);
            let chain = result.chains.chain(equal[0]);
            for (from, to) in chain.clone().zip(chain.skip(1)) {
                sides.push(if from < to {
                    ([from, to], flow)
                } else {
                    ([to, from], -flow)
                });
            }
        }
        Flow {
            sides: summed(sides),
            sources: summed(sources),
        }
    }

    pub(super) fn of_side(&self, [from, to]: [usize; 2]) -> i32 {
        let [a, b] = [narrow(from), narrow(to)];
        let side = [a.min(b), a.max(b)];
        let found = self.sides.binary_search_by_key(&side, |&(side, _)| side);
        let flow = found.map_or(0, |at| self.sides[at].1);
        if a < b { flow } else { -flow }
    }

    /// An error if `counts` holds for the flow that starts or ends at a vertex.
    pub(super) fn expect_closed(&self, counts: impl Fn(i32) -> bool) -> Result<(), InteriorError> {
        match self.sources.iter().find(|&&(_, flow)| counts(flow)) {
            Some(&(vertex, _)) => Err(InteriorError::OpenAtVertex {
                vertex: vertex as usize,
            }),
            None => Ok(()),
        }
    }
}

/// The sum for each key, where it is not zero.
fn summed<K: Copy + Ord>(mut list: Vec<(K, i32)>) -> Vec<(K, i32)> {
    list.sort_unstable();
    let sums = list.chunk_by(|a, b| a.0 == b.0).map(|same| {
        let sum = same.iter().map(|&(_, flow)| flow).sum();
        (same[0].0, sum)
    });
    sums.filter(|&(_, flow)| flow != 0).collect()
}

/// For each triangle the least number of walls (sides) between it and the outside. Layer after layer: all triangles
/// reached without another wall come before those behind one.
pub(super) fn layers(result: &Triangulation, is_wall: impl Fn(usize, usize) -> bool) -> Vec<i32> {
    let mut depths: Vec<Option<i32>> = vec![None; result.len()];
    let (mut now, mut next) = (Vec::new(), Vec::new());
    for [t, side] in hull(result) {
        let layer = if is_wall(t, side) {
            &mut next
        } else {
            &mut now
        };
        layer.push(t);
    }
    let mut depth = 0;
    while !(now.is_empty() && next.is_empty()) {
        while let Some(t) = now.pop() {
            if depths[t].is_some() {
                continue;
            }
            depths[t] = Some(depth);
            for side in 0..3 {
                if let Some(neighbor) = result.neighbor(t, side) {
                    let layer = if is_wall(t, side) {
                        &mut next
                    } else {
                        &mut now
                    };
                    layer.push(neighbor);
                }
            }
        }
        core::mem::swap(&mut now, &mut next);
        depth += 1;
    }
    complete(depths)
}

/// For each triangle the sum of the steps on a path to it from outside; `step` is added on the way into a triangle
/// through one of its sides. The sum must not depend on the path.
pub(super) fn sums(result: &Triangulation, step: impl Fn(usize, usize) -> i32) -> Vec<i32> {
    let mut depths: Vec<Option<i32>> = vec![None; result.len()];
    let mut waiting: Vec<(usize, i32)> = hull(result).map(|[t, side]| (t, step(t, side))).collect();
    while let Some((t, depth)) = waiting.pop() {
        if depths[t].is_some() {
            continue;
        }
        depths[t] = Some(depth);
        for side in 0..3 {
            if let Some(neighbor) = result.neighbor(t, side) {
                waiting.push((neighbor, depth - step(t, side)));
            }
        }
    }
    complete(depths)
}

fn hull(result: &Triangulation) -> impl Iterator<Item = [usize; 2]> + '_ {
    let sides = (0..result.len()).flat_map(|t| [0, 1, 2].map(|side| [t, side]));
    sides.filter(|&[t, side]| result.neighbor(t, side).is_none())
}

fn complete(depths: Vec<Option<i32>>) -> Vec<i32> {
    let depths = depths.into_iter();
    depths
        .map(|depth| depth.expect("the triangles are connected"))
        .collect()
}
