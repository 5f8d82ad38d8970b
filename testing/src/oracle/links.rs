//! Whether the parts of a result agree with each other.

use std::collections::HashMap;

use sweep_cdt::Triangulation;

/// Whether neighbours know each other and agree on what is constrained.
pub fn check_links(result: &Triangulation) {
    let by_side: HashMap<[usize; 2], usize> = result
        .triangles()
        .enumerate()
        .flat_map(|(t, corners)| [0, 1, 2].map(|side| (ends(corners, side), t)))
        .collect();
    assert_eq!(result.is_empty(), result.triangles().next().is_none());
    assert_eq!(
        by_side.len(),
        3 * result.len(),
        "a side is used twice in one direction"
    );
    for (t, corners) in result.triangles().enumerate() {
        assert_eq!(corners, result.triangle(t));
        for (side, neighbor) in result.neighbors(t).into_iter().enumerate() {
            let [a, b] = ends(corners, side);
            assert_eq!(neighbor, result.neighbor(t, side));
            assert_eq!(
                neighbor,
                by_side.get(&[b, a]).copied(),
                "across [{a}, {b}] of triangle {t}"
            );
            if let Some(u) = neighbor {
                let back = (0..3)
                    .find(|&i| ends(result.triangle(u), i) == [b, a])
                    .expect("by_side");
                assert_eq!(
                    result.is_constrained(t, side),
                    result.is_constrained(u, back),
                    "the two triangles at [{a}, {b}] do not agree on whether it is constrained"
                );
            }
        }
    }
}

/// The side opposite corner `side`, the triangle to its left.
pub(super) fn ends(corners: [usize; 3], side: usize) -> [usize; 2] {
    [corners[(side + 1) % 3], corners[(side + 2) % 3]]
}
