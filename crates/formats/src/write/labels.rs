//! What is said of triangles and of sides beside their corners: regions or features, and markers.

use std::collections::HashMap;

use sweep_cdt::Triangulation;
use sweep_cdt::interior::Interior;

use crate::GraphFile;

/// A number for each triangle of a list.
pub(super) struct Labels {
    /// `region` or `feature`.
    pub(super) name: &'static str,
    pub(super) values: Vec<f64>,
}

impl Labels {
    /// The region of each triangle in the canonical list of an interior, or the feature whose polygon covers it; 0
    /// where there is none. `None`, if the interior has neither.
    pub(super) fn of<S>(
        file: &GraphFile<S>,
        interior: &Interior<'_>,
        canonical: &[[usize; 3]],
    ) -> Option<Labels> {
        let label = |t: usize| {
            if interior.is_of_polygons() {
                let feature = file.polygons.feature(interior, t)?;
                Some(feature as f64)
            } else {
                let region = file.graph.regions.get(interior.region(t)?)?;
                Some(region.attribute)
            }
        };
        if !interior.has_regions() {
            return None;
        }
        let mut values = vec![0.0; canonical.len()];
        for (t, place) in places(interior, canonical).into_iter().enumerate() {
            if let (Some((place, _)), Some(label)) = (place, label(t)) {
                values[place] = label;
            }
        }
        Some(Labels {
            name: if interior.is_of_polygons() {
                "feature"
            } else {
                "region"
            },
            values,
        })
    }
}

/// The markers of sides: of several edges along a side the first with a marker counts. Nothing, if
/// no edge has one.
pub(super) fn markers<S>(
    file: &GraphFile<S>,
    interior: &Interior<'_>,
    sides: &[[usize; 2]],
) -> Vec<i64> {
    if file.edge_markers.is_empty() {
        return Vec::new();
    }
    let marked = file.edge_markers.iter().enumerate();
    let marked = marked
        .filter(|(_, marker)| **marker != 0)
        .map(|(edge, _)| edge);
    let edges = edges_along(interior.triangulation(), marked, sides);
    let marker = |edge: Option<usize>| edge.map_or(0, |edge| file.edge_markers[edge]);
    edges.into_iter().map(marker).collect()
}

/// For each side, with its ends in any order, the first of these edges that runs along it.
///
/// ```
/// use sweep_cdt_formats::edges_along;
///
/// let points = [[0.0, 0.0], [2.0, 0.0], [4.0, 0.0], [0.0, 3.0]];
/// let result = sweep_cdt::triangulate(&points, &[[1, 2], [2, 0]])?;
/// assert_eq!(edges_along(&result, 0..2, &[[0, 1], [2, 1], [0, 3]]), [Some(1), Some(0), None]);
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
pub fn edges_along(
    result: &Triangulation,
    edges: impl IntoIterator<Item = usize>,
    sides: &[[usize; 2]],
) -> Vec<Option<usize>> {
    let sorted = |[a, b]: [usize; 2]| [a.min(b), a.max(b)];
    let places = sides.iter().enumerate();
    let places: HashMap<_, _> = places.map(|(place, &side)| (sorted(side), place)).collect();
    let mut found = vec![None; sides.len()];
    for edge in edges {
        let chain = result.edge_chain(edge);
        for (a, b) in chain.clone().zip(chain.skip(1)) {
            if let Some(&place) = places.get(&sorted([a, b])) {
                found[place].get_or_insert(edge);
            }
        }
    }
    found
}

/// For each triangle, if it is inside, its place in the canonical list of the domain, and which of its vertices comes
/// first there.
pub(super) fn places(
    interior: &Interior<'_>,
    canonical: &[[usize; 3]],
) -> Vec<Option<(usize, usize)>> {
    let result = interior.triangulation();
    let mut places = vec![None; result.len()];
    for t in interior.inside() {
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
