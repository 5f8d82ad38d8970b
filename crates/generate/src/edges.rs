//! Points with edges: of simple kinds, rough closed outlines, and parcels of land.

use super::random::Random;
use sweep_cdt::Pslg;

use super::points::{direction, numbers};

pub(super) fn comb(n: usize, _: &mut Random) -> Pslg<f64> {
    let height = n as f64;
    let point = |i: f64| [i, if i % 4.0 < 2.0 { height } else { i / height }];
    Pslg {
        points: numbers(n).map(point).collect(),
        edges: (1..n).map(|i| [i - 1, i]).collect(),
        ..Pslg::default()
    }
}

/// How many edges a fan has.
const SPOKES: usize = 100;

pub(super) fn fans(n: usize, random: &mut Random) -> Pslg<f64> {
    let mut input = Pslg::default();
    for fan in numbers(n.div_ceil(SPOKES + 1)) {
        let hub = input.points.len();
        let left = fan * SPOKES as f64;
        let height = SPOKES as f64;
        input.points.push([left + height / 2.0, height]);
        for spoke in numbers(SPOKES) {
            input.edges.push([hub, input.points.len()]);
            input.points.push([left + spoke, random.unit()]);
        }
    }
    input
}

pub(super) fn asterisk(n: usize, random: &mut Random) -> Pslg<f64> {
    // Opposite ends are exact mirror images, so that every edge passes through the centre.
    let mut ends: Vec<[f64; 2]> = (0..n / 2)
        .map(|_| [random.integer(1 << 20), random.integer(1 << 20)])
        .collect();
    let half = ends.len();
    ends.extend_from_within(..);
    for end in &mut ends[half..] {
        *end = end.map(|x| -x);
    }
    ends.push([0.0, 0.0]);
    Pslg {
        points: ends,
        edges: (0..half).map(|i| [i, i + half]).collect(),
        ..Pslg::default()
    }
}

pub(super) fn segments(n: usize, random: &mut Random) -> Pslg<f64> {
    // One within each cell of a lattice.
    let side = (n / 2).isqrt().max(1);
    let mut input = Pslg::default();
    for y in numbers(side) {
        for x in numbers(side) {
            let first = input.points.len();
            input.edges.push([first, first + 1]);
            for _ in 0..2 {
                input.points.push([x + random.unit(), y + random.unit()]);
            }
        }
    }
    input
}

/// How many vertices an outline has: four times a power of two makes the displacement simple.
const VERTICES: usize = 256;

/// Rough closed outlines, like those of islands: each in a cell of a lattice, seen whole from its middle, so
/// that no two edges cross.
pub(super) fn outlines(n: usize, random: &mut Random) -> Pslg<f64> {
    let count = n.div_ceil(VERTICES);
    let side = count.isqrt().max(1);
    let mut input = Pslg::default();
    for cell in 0..count {
        let centre = [cell % side, cell / side].map(|x| x as f64);
        let first = input.points.len();
        for (i, radius) in radii(random).into_iter().enumerate() {
            let quarter = VERTICES / 4;
            let [x, y] = direction(i / quarter, (i % quarter) as f64 / quarter as f64);
            input
                .points
                .push([centre[0] + radius * x, centre[1] + radius * y]);
            input.edges.push([first + i, first + (i + 1) % VERTICES]);
        }
    }
    input
}

/// Distances from the middle, by displacing middles of ever shorter arcs by ever less.
fn radii(random: &mut Random) -> Vec<f64> {
    let mut radii = vec![0.3; VERTICES];
    let (mut arc, mut by) = (VERTICES, 0.15);
    while arc > 1 {
        for start in (0..VERTICES).step_by(arc) {
            let mean = (radii[start] + radii[(start + arc) % VERTICES]) / 2.0;
            let radius = mean + by * (random.unit() - 0.5);
            radii[start + arc / 2] = radius.clamp(0.1, 0.49);
        }
        (arc, by) = (arc / 2, by * 0.6);
    }
    radii
}

/// Points and edges of the paper's set a (table 1).
const PAPER: [usize; 2] = [23_262, 28_155];
/// How far a corner and a vertex on a boundary are moved, at most, in widths of a parcel.
const CORNER: f64 = 0.15;
const BEND: f64 = 0.02;

/// Parcels of land (the paper's figure 16a): bent boundaries between corners where four parcels meet.
///
/// The corners are a lattice, each moved a little. Further vertices on the boundaries make the ratio of edges
/// to points that of the paper's set a. All moves are so small that no two boundaries cross.
pub(super) fn parcels(n: usize, random: &mut Random) -> Pslg<f64> {
    let [paper_points, paper_edges] = PAPER;
    let more = paper_edges - paper_points;
    let side = (n * more / paper_points).isqrt().max(2);
    let mut moved = |x: f64, by: f64| x + by * (2.0 * random.unit() - 1.0);
    let mut input = Pslg::default();
    for corner in 0..side * side {
        let place = [corner % side, corner / side].map(|x| x as f64);
        input.points.push(place.map(|x| moved(x, CORNER)));
    }
    let right = (0..side * side).filter(|corner| corner % side + 1 < side);
    let up = 0..side * (side - 1);
    let boundaries: Vec<[usize; 2]> = right
        .map(|corner| [corner, corner + 1])
        .chain(up.map(|corner| [corner, corner + side]))
        .collect();

    // With `bends` more points and edges, edges are to points as the paper has it.
    let bends = (boundaries.len() * paper_points).saturating_sub(side * side * paper_edges) / more;
    for (i, &[from, to]) in boundaries.iter().enumerate() {
        let here = bends * (i + 1) / boundaries.len() - bends * i / boundaries.len();
        let [a, b] = [from, to].map(|end| input.points[end]);
        let mut last = from;
        for bend in 1..=here {
            let part = bend as f64 / (here + 1) as f64;
            let place = [0, 1].map(|axis| moved(a[axis] + part * (b[axis] - a[axis]), BEND));
            input.edges.push([last, input.points.len()]);
            last = input.points.len();
            input.points.push(place);
        }
        input.edges.push([last, to]);
    }
    input
}
