//! Sorting in external memory against sorting in memory: `order.rs` for the order, `formats.rs` and `ply.rs` for the readers
//! of files (`clouds.rs` with the feature `las`), `chained.rs` for several inputs, `faults.rs` for what can go wrong, and
//! `headers.rs` for files whose headers say too much.

mod chained;
#[cfg(feature = "las")]
mod clouds;
mod faults;
mod formats;
#[cfg(target_os = "linux")]
mod headers;
mod order;
mod ply;

use std::collections::BTreeMap;
use std::path::Path;

use sweep_cdt_formats::ReadError;
use sweep_cdt_stream::external::{Error, Input, Sorting, Summary, SweepOrder};

/// Points and edges in memory.
#[derive(Clone, Debug, Default)]
struct Made {
    points: Vec<[f64; 2]>,
    edges: Vec<[u64; 2]>,
    taken: [usize; 2],
}

impl Made {
    fn new(points: Vec<[f64; 2]>, edges: Vec<[u64; 2]>) -> Made {
        Made {
            points,
            edges,
            taken: [0, 0],
        }
    }
}

/// The next elements, some at a time.
fn next<T: Clone>(all: &[T], taken: &mut usize, some: &mut Vec<T>) {
    let end = (*taken + 97).min(all.len());
    some.extend_from_slice(&all[*taken..end]);
    *taken = end;
}

impl Input for Made {
    fn name(&self) -> &str {
        "made"
    }

    fn next_points(&mut self, points: &mut Vec<[f64; 2]>) -> Result<(), ReadError> {
        next(&self.points, &mut self.taken[0], points);
        Ok(())
    }

    fn next_edges(&mut self, edges: &mut Vec<[u64; 2]>) -> Result<(), ReadError> {
        next(&self.edges, &mut self.taken[1], edges);
        Ok(())
    }
}

/// A vertex that owns its edges.
type Vertex = (u64, [f64; 2], Vec<(u64, [f64; 2])>);

fn take(mut order: SweepOrder) -> Result<Vec<Vertex>, Error> {
    let mut vertices = Vec::new();
    while let Some(vertex) = order.next_vertex()? {
        vertices.push((vertex.number, vertex.point, vertex.upper.to_vec()));
    }
    assert_eq!(order.next_vertex()?, None);
    Ok(vertices)
}

/// The order by a plain sort in memory, and how many edges have no length.
fn expected(points: &[[f64; 2]], edges: &[[u64; 2]]) -> (Vec<Vertex>, u64) {
    let mut order: Vec<usize> = (0..points.len()).collect();
    let place = |point: usize| (points[point][1], points[point][0]);
    order.sort_by(|&a, &b| {
        place(a)
            .partial_cmp(&place(b))
            .expect("no NaN")
            .then(a.cmp(&b))
    });
    // The rank of a place, by its first point.
    let mut ranks = vec![0; points.len()];
    for (rank, pair) in order.windows(2).enumerate() {
        let is_same = place(pair[0]) == place(pair[1]);
        ranks[pair[1]] = if is_same { ranks[pair[0]] } else { rank + 1 };
    }
    let mut upper: BTreeMap<usize, Vec<(u64, [f64; 2])>> = BTreeMap::new();
    let mut without_length = 0;
    for (edge, ends) in (0..).zip(edges) {
        let [a, b] = ends.map(|end| ranks[usize::try_from(end).expect("small")]);
        if a == b {
            without_length += 1;
            continue;
        }
        let there = points[order[a.max(b)]].map(|coordinate| coordinate + 0.0);
        upper.entry(a.min(b)).or_default().push((edge, there));
    }
    let vertex = |(rank, &point): (usize, &usize)| {
        let place = points[point].map(|coordinate| coordinate + 0.0);
        (point as u64, place, upper.remove(&rank).unwrap_or_default())
    };
    let vertices = order.iter().enumerate().map(vertex).collect();
    (vertices, without_length)
}

/// How many edges have begun and not ended, where these are most.
fn most_open(vertices: &[Vertex]) -> u64 {
    let sides = vertices.iter().flat_map(|(_, _, upper)| upper);
    let mut ends: Vec<[f64; 2]> = sides.map(|&(_, [x, y])| [y, x]).collect();
    ends.sort_by(|a, b| a.partial_cmp(b).expect("no NaN"));
    let mut ends = ends.into_iter().peekable();
    let (mut open, mut most) = (0, 0);
    for &(_, [x, y], ref upper) in vertices {
        while ends.next_if(|end| *end <= [y, x]).is_some() {
            open -= 1;
        }
        open += upper.len() as u64;
        most = most.max(open);
    }
    most
}

/// Sorts in so much memory, and compares with sorting in memory. Returns what was said beforehand.
fn check(points: &[[f64; 2]], edges: &[[u64; 2]], memory: u64, folder: &Path) -> Summary {
    let mut input = Made::new(points.to_vec(), edges.to_vec());
    let order = Sorting::new(memory, folder)
        .sort(&mut input)
        .expect("no fault");
    let summary = order.summary();
    let (expected, without_length) = expected(points, edges);
    assert_eq!(summary.points, points.len() as u64);
    assert_eq!(summary.edges_without_length, without_length);
    assert_eq!(summary.edges + without_length, edges.len() as u64);
    for (axis, &interval) in [summary.x, summary.y].iter().enumerate() {
        let coordinates = points.iter().map(|point| point[axis]);
        let first = coordinates.clone().fold(f64::INFINITY, f64::min);
        let last = coordinates.fold(f64::NEG_INFINITY, f64::max);
        assert_eq!((first, last), interval.into());
    }
    let vertices = take(order).expect("no fault");
    assert_eq!(vertices.len(), expected.len());
    let passing = most_open(&vertices)..=summary.edges;
    assert!(
        passing.contains(&summary.open_edges),
        "{passing:?}, {summary:?}"
    );
    for (vertex, expected) in vertices.iter().zip(&expected) {
        assert_eq!(vertex, expected);
        // -0.0 and 0.0 are equal for `assert_eq`.
        assert!(
            vertex
                .1
                .iter()
                .all(|value| value.to_bits() != (-0.0_f64).to_bits())
        );
    }
    summary
}

/// Numbers that look random (xorshift).
struct Random(u64);

impl Random {
    fn below(&mut self, end: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 16) % end
    }

    /// From 0 to 1.
    fn share(&mut self) -> f64 {
        self.below(1 << 40) as f64 / (1_u64 << 40) as f64
    }
}
