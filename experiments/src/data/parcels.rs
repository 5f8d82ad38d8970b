//! Parcels of land (the paper's figure 16a): bent boundaries between corners where four parcels meet.
//!
//! The corners are a lattice, each moved a little. Further vertices on the boundaries make the ratio of edges
//! to points that of the paper's set a. All moves are so small that no two boundaries cross.

use sweep_cdt_testing::{Input, Random};

/// Points and edges of the paper's set a (table 1).
const PAPER: [usize; 2] = [23_262, 28_155];
/// How far a corner and a vertex on a boundary are moved, at most, in widths of a parcel.
const CORNER: f64 = 0.15;
const BEND: f64 = 0.02;

pub(super) fn parcels(n: usize, random: &mut Random) -> Input {
    let [paper_points, paper_edges] = PAPER;
    let more = paper_edges - paper_points;
    let side = (n * more / paper_points).isqrt().max(2);
    let mut moved = |x: f64, by: f64| x + by * (2.0 * random.unit() - 1.0);
    let mut input = Input::default();
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
