//! Depths spread from the hull inwards, from triangle to triangle.
//!
//! The hull is connected, so every triangle is reached. A triangle is expanded once: O(n), and the search for
//! the flow of each constrained side.

use crate::Triangulation;

/// For each triangle the least number of walls between it and the outside; a wall is a side.
///
/// Layer after layer: all that is reached without another wall comes before what lies behind one.
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
        std::mem::swap(&mut now, &mut next);
        depth += 1;
    }
    complete(depths)
}

/// For each triangle the sum of the steps on a path to it from outside, where `step` is what is added on the way
/// into a triangle through one of its sides. The sum must not depend on the path.
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

/// The triangles on the hull, each with its side there.
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
