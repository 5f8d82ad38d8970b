//! The verifier against a naive one, on small triangulations that chance has broken, or has not.

use sweep_cdt::{triangulate, verify};

type Point = [i64; 2];

struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as usize) % n
    }
}

fn turn(a: Point, b: Point, c: Point) -> i64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

fn is_between(a: Point, v: Point, b: Point) -> bool {
    turn(a, b, v) == 0 && v != a && v != b && a.min(b) < v && v < a.max(b)
}

/// Whether d is inside the circle through the counter-clockwise triangle a, b, c.
fn is_inside(t: [Point; 3], d: Point) -> bool {
    let [a, b, c] = t.map(|p| [p[0] - d[0], p[1] - d[1]]);
    let lift = |p: Point| p[0] * p[0] + p[1] * p[1];
    let cross = |p: Point, q: Point| p[0] * q[1] - p[1] * q[0];
    lift(a) * cross(b, c) + lift(b) * cross(c, a) + lift(c) * cross(a, b) > 0
}

/// Triangles with no common inner point: a side of one separates them.
fn are_disjoint(t: [Point; 3], u: [Point; 3]) -> bool {
    let separates = |t: [Point; 3], u: [Point; 3]| {
        (0..3).any(|i| u.iter().all(|&v| turn(t[i], t[(i + 1) % 3], v) <= 0))
    };
    separates(t, u) || separates(u, t)
}

/// Twice the area of the convex hull, summed by its sides.
fn hull_area(points: &[Point]) -> i64 {
    let mut area = 0;
    let mut distinct = points.to_vec();
    distinct.sort_unstable();
    distinct.dedup();
    let points = &distinct;
    for &a in points {
        for &b in points {
            let is_side = a != b
                && points
                    .iter()
                    .all(|&v| turn(a, b, v) > 0 || v == a || v == b || is_between(a, v, b));
            if is_side {
                area += a[0] * b[1] - a[1] * b[0];
            }
        }
    }
    area
}

/// By definition, as far as that is short: the triangles are disjoint, fill the hull, have no point
/// inside or within a side; edges are made of sides; sides that are not are Delaunay.
fn is_right(points: &[Point], edges: &[[usize; 2]], triangles: &[[usize; 3]]) -> bool {
    let corners: Vec<[Point; 3]> = triangles.iter().map(|t| t.map(|v| points[v])).collect();
    let area: i64 = corners.iter().map(|&[a, b, c]| turn(a, b, c)).sum();
    let sides = |t: [Point; 3]| (0..3).map(move |i| [t[i], t[(i + 1) % 3]]);
    let all_sides: Vec<[Point; 2]> = corners.iter().copied().flat_map(sides).collect();
    let is_piece = |[p, q]: [Point; 2]| {
        let on = |[a, b]: [Point; 2], v| v == a || v == b || is_between(a, v, b);
        edges
            .iter()
            .any(|e| [p, q].iter().all(|&v| on(e.map(|v| points[v]), v)))
    };
    corners.iter().all(|&[a, b, c]| turn(a, b, c) > 0)
        && area == hull_area(points)
        && (0..corners.len()).all(|i| (0..i).all(|j| are_disjoint(corners[i], corners[j])))
        && (area == 0
            || points
                .iter()
                .all(|p| corners.iter().flatten().any(|c| c == p)))
        && all_sides
            .iter()
            .all(|&[a, b]| points.iter().all(|&v| !is_between(a, v, b)))
        && (area == 0
            || edges.iter().all(|&[a, b]| {
                let mut on: Vec<Point> = points
                    .iter()
                    .copied()
                    .filter(|&v| is_between(points[a], v, points[b]))
                    .collect();
                on.extend([points[a], points[b]]);
                on.sort_unstable();
                on.dedup();
                on.windows(2)
                    .all(|w| all_sides.contains(&[w[0], w[1]]) || all_sides.contains(&[w[1], w[0]]))
            }))
        && corners.iter().all(|&t| {
            corners.iter().all(|&u| {
                let shared = sides(t).find(|&[a, b]| sides(u).any(|side| side == [b, a]));
                shared.is_none_or(|side| is_piece(side) || u.iter().all(|&v| !is_inside(t, v)))
            })
        })
}

/// One random change; often it makes the triangulation wrong.
fn spoil(random: &mut Random, points: &mut Vec<Point>, triangles: &mut Vec<[usize; 3]>) {
    let (n, count) = (points.len(), triangles.len().max(1));
    let t = random.below(count);
    match (random.below(8), triangles.get_mut(t)) {
        (0, Some(triangle)) => triangle[random.below(3)] = random.below(n),
        (1, Some(_)) => drop(triangles.swap_remove(t)),
        (2, Some(triangle)) => triangle.rotate_left(1),
        (3, Some(triangle)) => triangle.swap(0, 1),
        (4, _) => points.push([random.below(4) as i64, random.below(4) as i64]),
        (5, _) => points[random.below(n)] = [random.below(4) as i64, random.below(4) as i64],
        (6, Some(_)) => {
            // Flips a side, if it has triangles on both sides.
            let [a, b, c] = triangles[t];
            let across = triangles
                .iter()
                .position(|u| (0..3).any(|i| [u[i], u[(i + 1) % 3]] == [b, a]));
            if let Some(u) = across {
                let d = triangles[u]
                    .into_iter()
                    .find(|v| ![a, b].contains(v))
                    .unwrap_or(a);
                (triangles[t], triangles[u]) = ([c, a, d], [d, b, c]);
            }
        }
        _ => triangles.push([0, 1, 2].map(|_| random.below(n))),
    }
}

#[test]
fn agrees_with_the_naive_one() {
    let mut random = Random(3);
    let mut right = 0;
    for _ in 0..20_000 {
        let n = 3 + random.below(6);
        let mut points: Vec<Point> = (0..n)
            .map(|_| [random.below(4) as i64, random.below(4) as i64])
            .collect();
        let edges: Vec<[usize; 2]> = (0..random.below(3))
            .map(|_| [random.below(n), random.below(n)])
            .collect();
        let Ok(result) = triangulate(&points, &edges) else {
            continue;
        };
        let mut triangles: Vec<[usize; 3]> = result.triangles().collect();
        for _ in 0..random.below(4) {
            spoil(&mut random, &mut points, &mut triangles);
        }
        let expected = is_right(&points, &edges, &triangles);
        right += usize::from(expected);
        let verdict = verify(&points, &edges, &triangles);
        assert_eq!(
            verdict.is_ok(),
            expected,
            "{points:?} {edges:?} {triangles:?} {verdict:?}"
        );
    }
    assert!(
        (5000..15_000).contains(&right),
        "{right} of 20000 were right"
    );
}

/// Nothing at all makes the verifier panic.
#[test]
fn garbage() {
    let mut random = Random(4);
    let palette = [
        0.0,
        -0.0,
        1.0,
        2.0,
        1e300,
        -1e308,
        5e-324,
        f64::NAN,
        f64::INFINITY,
        0.5,
    ];
    for _ in 0..20_000 {
        let n = random.below(7);
        let points: Vec<[f64; 2]> = (0..n)
            .map(|_| [palette[random.below(10)], palette[random.below(10)]])
            .collect();
        let mut index = || match random.below(40) {
            0 => usize::MAX,
            1 => n,
            v => v % n.max(1),
        };
        let triangles: Vec<[usize; 3]> = (0..9).map(|_| [index(), index(), index()]).collect();
        let edges: Vec<[usize; 2]> = (0..4).map(|_| [index(), index()]).collect();
        let kept = random.below(10);
        let _ = verify(&points, &edges, &triangles[..kept]);
    }
}
