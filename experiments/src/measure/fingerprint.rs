//! A number that tells results apart: equal for equal sets of triangles, in whatever order they are listed.

use sweep_cdt::Triangulation;

/// The sum over the triangles of a hash of their vertices, the smallest first.
pub(super) fn fingerprint(result: &Triangulation) -> u64 {
    let hash = |triangle: [usize; 3]| {
        let smallest = (0..3).min_by_key(|&i| triangle[i]).expect("three");
        (0..3).fold(0, |hash: u64, i| {
            let vertex = triangle[(smallest + i) % 3] as u64 + 1;
            let hash = (hash ^ vertex).wrapping_mul(0x9e37_79b9_7f4a_7c15);
            hash ^ (hash >> 29)
        })
    };
    result
        .triangles()
        .fold(0, |sum, triangle| sum.wrapping_add(hash(triangle)))
}

#[cfg(test)]
mod tests {
    use super::fingerprint;

    #[test]
    fn results_differ_and_orders_do_not() {
        let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]];
        let of = |edges: &[[usize; 2]]| {
            fingerprint(&sweep_cdt::triangulate(&square, edges).expect("no edges cross"))
        };
        assert_eq!(of(&[[0, 2]]), of(&[[2, 0], [0, 1]]));
        assert_ne!(of(&[[0, 2]]), of(&[[1, 3]]));
    }
}
