//! Small triangulations, some of which random changes have broken: what each reaches, in whole numbers, and what
//! the verifier says to each level asked for; the verifier against a naive one.

use std::collections::BTreeSet;

use sweep_cdt::verify::{Level, Verifier, verify};
use sweep_cdt::{Triangulation, triangulate};
use sweep_cdt_testing::Random;
use sweep_cdt_testing::oracle::is_exactly_right;

type Point = [i64; 2];

const LEVELS: [Level; 4] = [
    Level::Tiling,
    Level::Constrained,
    Level::Delaunay,
    Level::Canonical,
];

fn turn([ax, ay]: Point, [bx, by]: Point, [cx, cy]: Point) -> i64 {
    (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
}

/// Positive if the last point is in the circle of the others, which turn left.
fn in_circle(corners: [Point; 3], [x, y]: Point) -> i64 {
    let [[ax, ay], [bx, by], [cx, cy]] = corners.map(|[px, py]| [px - x, py - y]);
    let lift = |x: i64, y: i64| x * x + y * y;
    lift(ax, ay) * (bx * cy - by * cx) - lift(bx, by) * (ax * cy - ay * cx)
        + lift(cx, cy) * (ax * by - ay * bx)
}

/// The triangle on the other side of side `a`-`b`, and its third corner.
fn across(triangles: &[[usize; 3]], [a, b]: [usize; 2]) -> Option<(usize, usize)> {
    triangles.iter().enumerate().find_map(|(u, corners)| {
        let i = (0..3).find(|&i| [corners[i], corners[(i + 1) % 3]] == [b, a])?;
        Some((u, corners[(i + 2) % 3]))
    })
}

/// Swaps the diagonal of two triangles, if they are convex together.
fn flip(points: &[Point], triangles: &mut [[usize; 3]], t: usize) {
    let [a, b, c] = triangles[t];
    if let Some((u, d)) = across(triangles, [a, b]) {
        let is_left = |v: usize, w: usize, x: usize| turn(points[v], points[w], points[x]) > 0;
        if is_left(c, a, d) && is_left(d, b, c) {
            (triangles[t], triangles[u]) = ([c, a, d], [d, b, c]);
        }
    }
}

/// The level of triangles that tile the hull as those of the result do.
fn reached(
    points: &[Point],
    edges: usize,
    result: &Triangulation,
    triangles: &[[usize; 3]],
) -> Level {
    let sides: BTreeSet<[usize; 2]> = triangles
        .iter()
        .flat_map(|t| [0, 1, 2].map(|i| [t[i], t[(i + 1) % 3]]))
        .collect();
    let mut fixed = BTreeSet::new();
    for edge in 0..edges {
        let chain: Vec<usize> = result.edge_chain(edge).collect();
        for side in chain.windows(2) {
            fixed.extend([[side[0], side[1]], [side[1], side[0]]]);
        }
    }
    let is_there = |&[a, b]: &[usize; 2]| sides.contains(&[a, b]) || sides.contains(&[b, a]);
    if !fixed.iter().all(is_there) {
        return Level::Tiling;
    }
    let is_legal = |&[a, b, c]: &[usize; 3]| {
        [[a, b], [b, c], [c, a]].into_iter().all(|side| {
            let beyond = across(triangles, side).filter(|_| !fixed.contains(&side));
            let corners = [a, b, c].map(|v| points[v]);
            beyond.is_none_or(|(_, d)| in_circle(corners, points[d]) <= 0)
        })
    };
    if !triangles.iter().all(is_legal) {
        return Level::Constrained;
    }
    let first = |t: &[usize; 3]| {
        let least = (0..3).min_by_key(|&i| t[i]).expect("three corners");
        [0, 1, 2].map(|i| t[(least + i) % 3])
    };
    let found: BTreeSet<[usize; 3]> = triangles.iter().map(first).collect();
    let canonical = result.canonical_triangles().into_iter().collect();
    if found == canonical {
        Level::Canonical
    } else {
        Level::Delaunay
    }
}

#[test]
fn the_verifier_names_the_highest_level() {
    let mut random = Random::new(8);
    let mut counts = [0; 5];
    for _ in 0..10_000 {
        let n = 4 + random.below(6);
        let mut coordinate = || random.below(5) as i64;
        let points: Vec<Point> = (0..n).map(|_| [coordinate(), coordinate()]).collect();
        let edges: Vec<[usize; 2]> = (0..random.below(4))
            .map(|_| [random.below(n), random.below(n)])
            .collect();
        let Ok(result) = triangulate(&points, &edges) else {
            continue;
        };
        let mut triangles: Vec<[usize; 3]> = result.triangles().collect();
        if triangles.is_empty() {
            continue;
        }
        for _ in 0..random.below(4) {
            let t = random.below(triangles.len());
            triangles[t].rotate_left(random.below(3));
            flip(&points, &mut triangles, t);
        }
        let expected = if random.one_in(10) {
            triangles.swap_remove(random.below(triangles.len()));
            None
        } else {
            Some(reached(&points, edges.len(), &result, &triangles))
        };
        counts[expected.map_or(0, |level| 1 + level as usize)] += 1;
        for asked in LEVELS {
            let verdict = Verifier::new()
                .level(asked)
                .verify(&points, &edges, &triangles);
            let what = || format!("{asked:?}: {points:?} {edges:?} {triangles:?} {verdict:?}");
            assert_eq!(verdict.is_ok(), expected >= Some(asked), "{}", what());
            let level = match &verdict {
                Ok(report) => report.level,
                Err(violations) => {
                    let is_asked = |found: Level| found <= asked;
                    assert!(
                        violations.list.iter().all(|v| is_asked(v.level())),
                        "{}",
                        what()
                    );
                    assert_eq!(violations.asked, asked);
                    violations.report.level
                }
            };
            assert_eq!(level, expected, "{}", what());
        }
    }
    println!("{counts:?}");
    assert!(counts.iter().all(|&count| count > 100), "{counts:?}");
}

#[test]
fn edges_out_of_range_break_no_tiling() {
    let points = [[0, 0], [1, 0], [0, 1]];
    let verifier = Verifier::new().level(Level::Tiling);
    let report = verifier.verify(&points, &[[0, 7]], &[[0, 1, 2]]).unwrap();
    assert_eq!(report.level, Some(Level::Tiling));
    // A point that is not used breaks it, whatever was found before.
    let points = [[0, 0], [1, 0], [0, 1], [3, 3]];
    let violations = verifier
        .verify(&points, &[[0, 7]], &[[0, 1, 2]])
        .unwrap_err();
    assert_eq!((violations.found, violations.report.level), (1, None));
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
    let mut random = Random::new(3);
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
        let expected = is_exactly_right(&points, &edges, &triangles);
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

/// No input makes the verifier panic.
#[test]
fn garbage() {
    let mut random = Random::new(4);
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
