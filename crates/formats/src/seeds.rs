//! Seeds of regions in triangles that were read, which have no neighbours and so allow no walk: the seeds are sorted by
//! x, and each triangle is compared with the seeds between its leftmost and rightmost corners, by exact signs.

use std::cmp::Ordering;

use sweep_cdt::scalar::{Scalar, orient2d};

/// For each seed the first triangle that holds it, in any list that covers no place twice. Two triangles hold a seed on
/// their side, several one at their corner; `None` is outside of all.
///
/// Cost: O((n + k) log k) for n triangles and k seeds, and one comparison for each triangle and seed that have an x in
/// common. Triangles may run either way. A triangle with a corner that is no index of a point holds nothing.
///
/// ```
/// use sweep_cdt_formats::locate_seeds;
///
/// let points = [[0, 0], [4, 0], [4, 4], [0, 4]];
/// let triangles = [[0, 1, 2], [0, 2, 3]];
/// assert_eq!(locate_seeds(&points, &triangles, &[[3, 1], [1, 3], [5, 5]]), [Some(0), Some(1), None]);
/// ```
pub fn locate_seeds<S: Scalar>(
    points: &[[S; 2]],
    triangles: &[[usize; 3]],
    seeds: &[[S; 2]],
) -> Vec<Option<usize>> {
    let mut order: Vec<usize> = (0..seeds.len()).collect();
    order.sort_by(|&a, &b| seeds[a][0].compare(&seeds[b][0]));
    let mut found = vec![None; seeds.len()];
    for (t, corners) in triangles.iter().enumerate() {
        let [Some(a), Some(b), Some(c)] = corners.map(|v| points.get(v)) else {
            continue;
        };
        let triangle = [a, b, c];
        let is_before = |seed: &usize, corner: &[S; 2]| seeds[*seed][0].compare(&corner[0]).is_lt();
        let is_behind = |seed: &usize, corner: &[S; 2]| seeds[*seed][0].compare(&corner[0]).is_gt();
        let from = order.partition_point(|seed| triangle.iter().all(|p| is_before(seed, p)));
        let to = order.partition_point(|seed| !triangle.iter().all(|p| is_behind(seed, p)));
        for &seed in &order[from..to] {
            if found[seed].is_none() && holds(triangle, &seeds[seed]) {
                found[seed] = Some(t);
            }
        }
    }
    found
}

/// Whether a triangle holds a point: inside, on a side or at a corner.
fn holds<S: Scalar>([a, b, c]: [&[S; 2]; 3], point: &[S; 2]) -> bool {
    let turns = [[a, b], [b, c], [c, a]].map(|[from, to]| orient2d(from, to, point));
    !(turns.contains(&Ordering::Less) && turns.contains(&Ordering::Greater))
}
