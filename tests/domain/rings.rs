//! Random rings that touch, overlap, nest, repeat and go through themselves, but do not cross between vertices.

use sweep_cdt_testing::Random;

use super::oracle::Point;

/// Rings of points, as edges.
#[derive(Debug)]
pub(crate) struct Rings {
    pub(crate) points: Vec<Point>,
    pub(crate) edges: Vec<[usize; 2]>,
}

/// Random rings.
///
/// Their corners have even coordinates, and their edges run in the eight directions of a compass. So they cross
/// where both coordinates are whole, and there is a point.
pub(crate) fn rings(random: &mut Random) -> Rings {
    let size = 3 + random.below(3);
    let side = 2 * size as i64 - 1;
    let mut points: Vec<Point> = (0..side * side).map(|i| [i % side, i / side]).collect();
    // Some twice.
    for _ in 0..random.below(4) {
        points.push(random.pick(&points));
    }
    random.shuffle(&mut points);
    let mut edges = Vec::new();
    let mut last: Vec<[usize; 2]> = Vec::new();
    for _ in 0..1 + random.below(4) {
        let ring = match random.below(7) {
            // The one before, once more or reversed.
            0 => last.clone(),
            1 => last.iter().map(|&[a, b]| [b, a]).collect(),
            2 => closed(&points, &rectangle(random, size), random),
            3 | 4 => closed(&points, &frame(random, size), random),
            _ => closed(&points, &walk(random, size), random),
        };
        edges.extend(&ring);
        last = ring;
    }
    random.shuffle(&mut edges);
    Rings { points, edges }
}

fn rectangle(random: &mut Random, size: usize) -> Vec<Point> {
    let mut at = || 2 * random.below(size) as i64;
    let [left, right, low, high] = [at(), at(), at(), at()];
    vec![[left, low], [right, low], [right, high], [left, high]]
}

/// A square around the middle.
fn frame(random: &mut Random, size: usize) -> Vec<Point> {
    let low = 2 * random.below(size / 2) as i64;
    let high = 2 * (size as i64 - 1) - low;
    vec![[low, low], [high, low], [high, high], [low, high]]
}

/// A walk of straight pieces, and the way back along a row and a column.
fn walk(random: &mut Random, size: usize) -> Vec<Point> {
    let mut coordinate = || random.below(size) as i64;
    let first = [coordinate(), coordinate()];
    let mut corners = vec![first];
    let mut at = first;
    for _ in 0..2 + random.below(5) {
        let step = [random.below(3) as i64 - 1, random.below(3) as i64 - 1];
        for _ in 0..1 + random.below(3) {
            let to = [at[0] + step[0], at[1] + step[1]];
            if to
                .iter()
                .all(|coordinate| (0..size as i64).contains(coordinate))
            {
                at = to;
            }
        }
        corners.push(at);
    }
    corners.push([at[0], first[1]]);
    corners.into_iter().map(|p| p.map(|x| 2 * x)).collect()
}

/// The edges of a ring, each end at one of the points that are there.
fn closed(points: &[Point], corners: &[Point], random: &mut Random) -> Vec<[usize; 2]> {
    let mut vertex = |p: &Point| {
        let all: Vec<usize> = (0..points.len()).filter(|&v| points[v] == *p).collect();
        random.pick(&all)
    };
    let ends = (0..corners.len()).map(|i| [corners[i], corners[(i + 1) % corners.len()]]);
    ends.map(|[p, q]| [vertex(&p), vertex(&q)]).collect()
}
