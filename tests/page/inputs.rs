//! What the pages are made of.

use sweep_cdt::formats::Graph;

/// Scattered points and a few edges among them, one of which pierces many triangles and one of which
/// crosses the front.
pub(crate) fn scattered() -> Graph<f64> {
    let points = vec![
        [1.0, 0.6],
        [4.1, 0.0],
        [7.6, 0.9],
        [10.4, 0.3],
        [13.2, 1.2],
        [2.6, 2.0],
        [5.8, 2.3],
        [8.9, 2.6],
        [11.7, 2.9],
        [0.3, 3.3],
        [3.9, 3.7],
        [6.9, 4.1],
        [14.1, 3.8],
        [9.8, 4.7],
        [1.9, 5.0],
        [5.1, 5.6],
        [12.4, 5.5],
        [7.8, 6.2],
        [3.3, 6.9],
        [10.6, 7.0],
        [0.8, 7.3],
        [13.6, 7.5],
        [6.0, 7.9],
        [8.8, 8.4],
        [2.3, 8.7],
        [11.9, 8.9],
    ];
    let edges = vec![[20, 4], [24, 23], [9, 2], [21, 16], [25, 17]];
    Graph {
        points,
        edges,
        ..Graph::default()
    }
}

/// Many points, at places that look random and always are the same.
pub(crate) fn many(count: u32) -> Graph<f64> {
    let at = |i: u32, step: f64| (f64::from(i) * step).fract();
    let point = |i| [at(i, 0.618_033_988_749_895), at(i, 0.754_877_666_246_693)];
    Graph {
        points: (1..=count).map(point).collect(),
        ..Graph::default()
    }
}
