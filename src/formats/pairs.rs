//! Lists of sides and edges.

/// Pairs of vertices, sorted, with the lower vertex of each pair first.
pub(crate) fn sorted_pairs(pairs: impl Iterator<Item = [usize; 2]>) -> Vec<[usize; 2]> {
    let mut sorted: Vec<[usize; 2]> = pairs.map(|[a, b]| [a.min(b), a.max(b)]).collect();
    sorted.sort_unstable();
    sorted
}
