//! Random rings, and what must be around their triangles, by the definitions: in whole numbers, without any code of the
//! crate.

use sweep_cdt_testing::Random;

/// A point with whole coordinates.
pub(crate) type Point = [i64; 2];

/// How many edges run along the segment between two points, by geometry.
fn edges_along(points: &[Point], edges: &[[usize; 2]], [p, q]: [Point; 2]) -> usize {
    let is_on = |[a, b]: [Point; 2], r: Point| {
        let cross = (b[0] - a[0]) * (r[1] - a[1]) - (b[1] - a[1]) * (r[0] - a[0]);
        let between =
            |axis: usize| (a[axis].min(b[axis])..=a[axis].max(b[axis])).contains(&r[axis]);
        cross == 0 && between(0) && between(1)
    };
    let ends = edges.iter().map(|edge| edge.map(|v| points[v]));
    ends.filter(|&edge| is_on(edge, p) && is_on(edge, q))
        .count()
}

/// For each triangle the least number of sides with an odd number of edges between it and the outside: lowered
/// until nothing changes.
pub(crate) fn layers(points: &[Point], edges: &[[usize; 2]], triangles: &[[usize; 3]]) -> Vec<i32> {
    let sides = |t: usize| {
        let corners = triangles[t].map(|v| points[v]);
        [0, 1, 2].map(|i| [corners[i], corners[(i + 1) % 3]])
    };
    let reversed = |[p, q]: [Point; 2]| [q, p];
    let cost = |side| i32::from(edges_along(points, edges, side) % 2 == 1);
    let all: Vec<[[Point; 2]; 3]> = (0..triangles.len()).map(sides).collect();
    let across = |side| all.iter().position(|sides| sides.contains(&reversed(side)));
    let links: Vec<(usize, Option<usize>, i32)> = (0..all.len())
        .flat_map(|t| all[t].map(|side| (t, across(side), cost(side))))
        .collect();
    let mut layers = vec![i32::MAX; all.len()];
    loop {
        let before = layers.clone();
        for &(t, across, cost) in &links {
            let beyond = across.map_or(0, |u| layers[u]);
            layers[t] = layers[t].min(beyond.saturating_add(cost));
        }
        if layers == before {
            return layers;
        }
    }
}

/// For each triangle the first one in the same face, and whether the face reaches the border of the hull where there
/// is no edge.
pub(crate) fn faces(
    points: &[Point],
    edges: &[[usize; 2]],
    triangles: &[[usize; 3]],
) -> Vec<(usize, bool)> {
    let corners = |t: &[usize; 3]| t.map(|v| points[v]);
    let sides = |t: &[usize; 3]| {
        let corners = corners(t);
        [0, 1, 2].map(|i| [corners[i], corners[(i + 1) % 3]])
    };
    let all: Vec<[[Point; 2]; 3]> = triangles.iter().map(sides).collect();
    let mut faces: Vec<(usize, bool)> = (0..all.len()).map(|t| (t, false)).collect();
    for (t, sides) in all.iter().enumerate() {
        for &[p, q] in sides {
            if edges_along(points, edges, [p, q]) > 0 {
                continue;
            }
            let across = all.iter().position(|sides| sides.contains(&[q, p]));
            let (one, open) = faces[t];
            let (other, also_open) = across.map_or((one, true), |u| faces[u]);
            let joined = (one.min(other), open || also_open);
            for face in &mut faces {
                if face.0 == one || face.0 == other {
                    *face = joined;
                }
            }
        }
    }
    faces
}

/// Whether a triangle holds a point, its border included.
pub(crate) fn holds(points: &[Point], triangle: [usize; 3], p: Point) -> bool {
    let corners = triangle.map(|v| points[v]);
    (0..3).all(|i| {
        let ([ax, ay], [bx, by]) = (corners[i], corners[(i + 1) % 3]);
        (bx - ax) * (p[1] - ay) >= (by - ay) * (p[0] - ax)
    })
}

/// Whether a point lies on an edge.
pub(crate) fn is_on_edge(points: &[Point], edges: &[[usize; 2]], p: Point) -> bool {
    edges_along(points, edges, [p, p]) > 0
}

/// Rings of points, as edges.
#[derive(Debug)]
pub(crate) struct Rings {
    pub(crate) points: Vec<Point>,
    pub(crate) edges: Vec<[usize; 2]>,
}

/// Random rings that touch, overlap, nest, repeat and go through themselves, but do not cross between vertices.
///
/// The rings' corners have even coordinates, and the edges run in the eight directions of a compass. So they cross
/// where both coordinates are whole, and there is a point.
pub(crate) fn rings(random: &mut Random) -> Rings {
    let size = 3 + random.below(3);
    let points = lattice(random, size);
    let mut edges = Vec::new();
    let mut last: Vec<[usize; 2]> = Vec::new();
    for _ in 0..1 + random.below(4) {
        let ring = match random.below(7) {
            // The one before, once more or reversed.
            0 => last.clone(),
            1 => last.iter().map(|&[a, b]| [b, a]).collect(),
            _ => ring(random, &points, size),
        };
        edges.extend(&ring);
        last = ring;
    }
    random.shuffle(&mut edges);
    Rings { points, edges }
}

/// All points of a lattice with so many even coordinates, some of them twice, in any order.
pub(crate) fn lattice(random: &mut Random, size: usize) -> Vec<Point> {
    let side = 2 * size as i64 - 1;
    let mut points: Vec<Point> = (0..side * side).map(|i| [i % side, i / side]).collect();
    for _ in 0..random.below(4) {
        points.push(random.pick(&points));
    }
    random.shuffle(&mut points);
    points
}

/// A random ring on a lattice.
pub(crate) fn ring(random: &mut Random, points: &[Point], size: usize) -> Vec<[usize; 2]> {
    let corners = match random.below(5) {
        0 => rectangle(random, size),
        1 | 2 => frame(random, size),
        _ => walk(random, size),
    };
    closed(points, &corners, random)
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
