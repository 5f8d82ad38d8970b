//! Where each triangle of a domain stands in the canonical list.

use crate::domain::Domain;

/// For each triangle, if it is inside, its place in the canonical list of the domain, and which of its vertices comes
/// first there.
pub(super) fn places(domain: &Domain<'_>, canonical: &[[usize; 3]]) -> Vec<Option<(usize, usize)>> {
    let result = domain.triangulation();
    let mut places = vec![None; result.len()];
    for t in domain.inside() {
        let corners = result.triangle(t);
        let first = (0..3)
            .min_by_key(|&i| corners[i])
            .expect("a triangle has corners");
        let listed = [0, 1, 2].map(|i| corners[(first + i) % 3]);
        let place = canonical.binary_search(&listed);
        places[t] = Some((place.expect("every triangle inside is listed"), first));
    }
    places
}
