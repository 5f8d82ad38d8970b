//! The boundary of any set of triangles.

use std::collections::HashSet;

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
