//! A result in a form that can be compared.

use std::collections::BTreeMap;

use sweep_cdt::Triangulation;

use super::links::check_links;

/// A result in a form that does not depend on how it was found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Answer {
    /// Each with its lowest vertex first; sorted.
    pub triangles: Vec<[usize; 3]>,
    /// The constrained sides, lower vertex first; sorted.
    pub constrained: Vec<[usize; 2]>,
    /// The vertices on the hull, counter-clockwise from the leftmost, upper one.
    pub hull: Vec<usize>,
    /// For each point the lowest index of an equal one.
    pub representatives: Vec<usize>,
    /// For each edge the vertices along it.
    pub chains: Vec<Vec<usize>>,
}

/// What the crate found for `points` points and `edges` edges, its links checked on the way.
pub fn found(result: &Triangulation, points: usize, edges: usize) -> Answer {
    check_links(result);
    let mut constrained: Vec<_> = result.constrained_edges().map(sorted).collect();
    constrained.sort_unstable();
    let representatives: Vec<usize> = (0..points).map(|v| result.representative(v)).collect();
    let duplicates: BTreeMap<_, _> = result.duplicates().map(|[v, of]| (v, of)).collect();
    for (v, &of) in representatives.iter().enumerate() {
        assert_eq!(
            of != v,
            duplicates.contains_key(&v),
            "point {v} is listed as a duplicate or not"
        );
        assert_eq!(
            of,
            *duplicates.get(&v).unwrap_or(&v),
            "representative of point {v}"
        );
    }
    Answer {
        triangles: result.canonical_triangles(),
        constrained,
        hull: result.hull().collect(),
        representatives,
        chains: (0..edges).map(|e| result.edge_chain(e).collect()).collect(),
    }
}

/// The triangles as [`Triangulation::canonical_triangles`] lists those of a result.
pub fn canonical(result: &Triangulation, triangles: &[[usize; 3]]) -> Vec<[usize; 3]> {
    let mut list: Vec<[usize; 3]> = triangles
        .iter()
        .map(|corners| lowest_first(corners.map(|v| result.representative(v))))
        .collect();
    list.sort_unstable();
    list
}

fn lowest_first([a, b, c]: [usize; 3]) -> [usize; 3] {
    match a.min(b).min(c) {
        least if least == a => [a, b, c],
        least if least == b => [b, c, a],
        _ => [c, a, b],
    }
}

/// The lower of two first.
pub fn sorted([a, b]: [usize; 2]) -> [usize; 2] {
    [a.min(b), a.max(b)]
}
