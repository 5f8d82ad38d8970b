//! What must be inside, by the definitions: a ray from the middle of each triangle, in whole numbers, without
//! any code of the crate.

/// A point with whole coordinates.
pub(crate) type Point = [i64; 2];

/// How often a ray to the right of a triangle's centroid crosses the edges, and how often the edges go round it
/// counter-clockwise.
pub(crate) fn cast(points: &[Point], edges: &[[usize; 2]], triangle: [usize; 3]) -> (u32, i32) {
    // Three times as large, the centroid has whole coordinates.
    let sum = |axis: usize| triangle.iter().map(|&v| points[v][axis]).sum::<i64>();
    let [x, y] = [sum(0), sum(1)];
    let (mut crossed, mut winding) = (0, 0);
    for edge in edges {
        let [[ax, ay], [bx, by]] = edge.map(|v| points[v].map(|coordinate| 3 * coordinate));
        // An end on the height of the ray counts as above it.
        let direction = match (ay < y, by < y) {
            (true, false) => 1,
            (false, true) => -1,
            _ => continue,
        };
        // The edge crosses the ray if the centroid is left of it as it goes up.
        let turn = (bx - ax) * (y - ay) - (by - ay) * (x - ax);
        if turn * i64::from(direction) > 0 {
            crossed += 1;
            winding += direction;
        }
    }
    (crossed, winding)
}

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
