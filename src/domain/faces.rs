//! Faces: what is left in one piece of the hull when it is cut along all edges.
//!
//! Cost: O(n), and 8 bytes a triangle.

use crate::Triangulation;

/// For each triangle the number of its face, and how many faces there are.
pub(super) fn faces(result: &Triangulation) -> (Vec<usize>, usize) {
    const NONE: usize = usize::MAX;
    let mut faces = vec![NONE; result.len()];
    let (mut count, mut waiting) = (0, Vec::new());
    for first in 0..result.len() {
        if faces[first] != NONE {
            continue;
        }
        faces[first] = count;
        waiting.push(first);
        while let Some(t) = waiting.pop() {
            for side in 0..3 {
                if let Some(neighbor) = result.neighbor(t, side)
                    && !result.is_constrained(t, side)
                    && faces[neighbor] == NONE
                {
                    faces[neighbor] = count;
                    waiting.push(neighbor);
                }
            }
        }
        count += 1;
    }
    (faces, count)
}
