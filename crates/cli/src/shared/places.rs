//! Faults of an input with the place where they are, in its own coordinates.
//!
//! A number of an edge says little to somebody who drew a map. Why the place is right: it is the exact common point of
//! the two edges, as the nearest doubles. Cost: that of one crossing, once.

use num_rational::BigRational;
use sweep_cdt::Error;
use sweep_cdt::crossings::crossings;
use sweep_cdt::interior::{InteriorError, Seed};
use sweep_cdt_formats::{Coordinate, GraphFile};

/// The fault in words, with vertices and edges numbered as in the file, and where it is.
pub(crate) fn located<S: Coordinate>(file: &GraphFile<S>, error: Error) -> String {
    let numbered = file.as_numbered(error);
    let place = match error {
        Error::CrossingEdges { edges } => crossing(file, edges),
        _ => None,
    };
    let parts = match error {
        Error::CrossingEdges { edges } => parts(file, edges),
        _ => String::new(),
    };
    match place {
        Some([x, y]) => format!("{numbered} near ({}, {}){parts}", x.text(), y.text()),
        None => format!("{numbered}{parts}"),
    }
}

/// What keeps a rule from telling the inside, in words, numbered as in the file, and where it is.
pub(crate) fn located_interior<S: Coordinate>(file: &GraphFile<S>, error: InteriorError) -> String {
    if let InteriorError::Refused { error } = error {
        return located(file, error);
    }
    let graph = &file.graph;
    let (place, layer) = match error {
        InteriorError::OpenAtVertex { vertex } => {
            (graph.points.get(vertex), file.vertex_of_layer(vertex))
        }
        InteriorError::SeedOutside { seed }
        | InteriorError::SeedOnVertex { seed, .. }
        | InteriorError::SeedOnEdge { seed, .. } => of_seed(file, seed),
        InteriorError::RegionOutside { region } => of_seed(file, Seed::Region(region)),
        _ => (None, None),
    };
    let layer = layer.map_or(String::new(), |layer| format!(", {layer}"));
    let numbered = file.interior_as_numbered(error);
    match place {
        Some([x, y]) => format!("{numbered}, at ({}, {}){layer}", x.text(), y.text()),
        None => numbered.to_string(),
    }
}

/// The place of a seed, and its name in its layer, if there are layers.
fn of_seed<S>(file: &GraphFile<S>, seed: Seed) -> (Option<&[S; 2]>, Option<String>) {
    let graph = &file.graph;
    let place = match seed {
        Seed::Hole(hole) => graph.holes.get(hole),
        Seed::Region(region) => graph.regions.get(region).map(|region| &region.seed),
    };
    (place, file.seed_of_layer(seed))
}

/// The parts of the map that two edges are of, where the file has features or layers.
pub(crate) fn parts<S>(file: &GraphFile<S>, edges: [usize; 2]) -> String {
    match edges.map(|edge| file.part_of(edge)) {
        [Some(one), Some(other)] if one == other => format!(", both of {one}"),
        [Some(one), Some(other)] => format!(", {one} and {other}"),
        _ => String::new(),
    }
}

/// Where two edges cross.
fn crossing<S: Coordinate>(file: &GraphFile<S>, edges: [usize; 2]) -> Option<[f64; 2]> {
    let mut ends = Vec::with_capacity(4);
    for edge in edges {
        for &vertex in file.graph.edges.get(edge)? {
            let exact = |x: &S| match x.is_finite() && S::APPROX_IS_EXACT {
                true => BigRational::from_float(x.approx()),
                false => BigRational::from_text(&x.text()).ok(),
            };
            let [x, y] = file.graph.points.get(vertex)?;
            ends.push([exact(x)?, exact(y)?]);
        }
    }
    let found = crossings(&ends, &[[0, 1], [2, 3]]).ok()?;
    found.first().map(|crossing| crossing.point_f64())
}
