//! A result taken apart: in a form that can be compared, with a test whether its parts agree with each other.
//! Of any set of triangles: the boundary.

use std::collections::{BTreeMap, HashMap, HashSet};

use sweep_cdt::Triangulation;

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

/// The answer of the crate for `points` points and `edges` edges, its links checked on the way.
pub fn found(result: &Triangulation, points: usize, edges: usize) -> Answer {
    check_links(result);
    let mut constrained: Vec<_> = result.constrained_sides().map(sorted).collect();
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

/// The corners in their order, the lowest number first.
pub fn lowest_first([a, b, c]: [usize; 3]) -> [usize; 3] {
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

/// The closed chains of the sides of triangles that have no triangle on their right.
pub fn boundary(triangles: &[[usize; 3]]) -> Vec<Vec<usize>> {
    let sides = |t: &[usize; 3]| [0, 1, 2].map(|i| [t[i], t[(i + 1) % 3]]);
    let all: HashSet<[usize; 2]> = triangles.iter().flat_map(sides).collect();
    let is_open = |&[a, b]: &[usize; 2]| !all.contains(&[b, a]);
    let mut open: Vec<[usize; 2]> = triangles.iter().flat_map(sides).filter(is_open).collect();
    let mut chains = Vec::new();
    while let Some([first, mut at]) = open.pop() {
        let mut chain = vec![first];
        while at != first {
            chain.push(at);
            let next = open.iter().position(|side| side[0] == at);
            at = open.swap_remove(next.expect("as many sides end at a vertex as start there"))[1];
        }
        chains.push(chain);
    }
    chains
}
