//! The verifier against a naive one, on small triangulations some of which random changes have broken.

use sweep_cdt::triangulate;
use sweep_cdt::verify::verify;
use sweep_cdt_testing::Random;
use sweep_cdt_testing::oracle::is_exactly_right;

type Point = [i64; 2];

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
