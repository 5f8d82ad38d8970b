//! Domains that the caller bounds.

use sweep_cdt::triangulate;
use sweep_cdt::verify::{Verifier, Violation};
use sweep_cdt_testing::{Random, boundary};

/// A square ring around a hole.
pub(crate) const POINTS: [[f64; 2]; 8] = [
    [0.0, 0.0],
    [9.0, 0.0],
    [9.0, 9.0],
    [0.0, 9.0],
    [3.0, 3.0],
    [6.0, 3.0],
    [6.0, 6.0],
    [3.0, 6.0],
];
pub(crate) const RING: [[usize; 3]; 8] = [
    [0, 5, 4],
    [0, 1, 5],
    [1, 6, 5],
    [1, 2, 6],
    [2, 7, 6],
    [2, 3, 7],
    [3, 4, 7],
    [3, 0, 4],
];

#[test]
fn points_in_the_domain_must_be_used() {
    let chains = [vec![0, 1, 2, 3], vec![4, 7, 6, 5]];
    let verifier = Verifier::new().boundary(&chains);
    for x in -1..=10 {
        for y in -1..=10 {
            let outer = (0..=9).contains(&x) && (0..=9).contains(&y);
            let hole = (4..6).contains(&x) && (4..6).contains(&y);
            let mut points = POINTS.to_vec();
            points.push([x, y].map(f64::from));
            let is_used = POINTS.contains(&points[8]);
            let expected = if outer && !hole && !is_used {
                vec![Violation::UnusedPoint { vertex: 8 }]
            } else {
                Vec::new()
            };
            let result = verifier.verify(&points, &[], &RING);
            let found = result.map_or_else(|violations| violations.list, |_| Vec::new());
            assert_eq!(found, expected, "{x} {y}");
        }
    }
}

#[test]
fn a_side_is_declared_once() {
    let chains = [vec![0, 1, 2, 3], vec![4, 7, 6, 5], vec![0, 1, 2, 3]];
    let verifier = Verifier::new().boundary(&chains);
    let list = verifier.verify(&POINTS, &[], &RING).unwrap_err().list;
    let missing = [[0, 1], [1, 2], [2, 3], [3, 0]].map(|side| Violation::MissingBoundary { side });
    assert_eq!(list, missing);
}

/// Whether a point is in a triangle or on its border.
fn holds(corners: [[i64; 2]; 3], p: [i64; 2]) -> bool {
    (0..3).all(|i| {
        let ([ax, ay], [bx, by]) = (corners[i], corners[(i + 1) % 3]);
        (bx - ax) * (p[1] - ay) >= (by - ay) * (p[0] - ax)
    })
}

#[test]
fn any_set_of_triangles_is_a_domain() {
    let mut random = Random::new(12);
    let mut found = 0;
    for _ in 0..2000 {
        let mut at = || [random.below(7) as i64, random.below(7) as i64];
        let mut points: Vec<[i64; 2]> = (0..12).map(|_| at()).collect();
        let others: Vec<[i64; 2]> = (0..12).map(|_| at()).collect();
        let Ok(result) = triangulate(&points, &[]) else {
            unreachable!("there are no edges")
        };
        let triangles: Vec<[usize; 3]> = result.triangles().collect();
        let chosen = triangles.into_iter().filter(|_| random.below(3) > 0);
        let chosen: Vec<[usize; 3]> = chosen.collect();
        points.extend(others);
        let is_needed = |&v: &usize| {
            let is_used = |t: &[usize; 3]| t.iter().any(|&w| points[w] == points[v]);
            let is_first = !points[..v].contains(&points[v]);
            let holds = |t: &[usize; 3]| holds(t.map(|w| points[w]), points[v]);
            is_first && chosen.iter().any(holds) && !chosen.iter().any(is_used)
        };
        let needed = (0..points.len()).filter(is_needed);
        let expected: Vec<_> = needed
            .map(|vertex| Violation::UnusedPoint { vertex })
            .collect();
        found += expected.len();
        let chains = boundary(&chosen);
        let verdict = Verifier::new()
            .boundary(&chains)
            .verify(&points, &[], &chosen);
        let list = verdict.map_or_else(|violations| violations.list, |_| Vec::new());
        assert_eq!(list, expected, "{points:?} {chosen:?} {chains:?}");
    }
    assert!(found > 1000, "{found}");
}

#[test]
fn chains_may_run_any_way() {
    let chains = [vec![0, 1, 2, 3], vec![4, 7, 6, 5]];
    for turned in 0..4 {
        let mut chains = chains.clone();
        for (i, chain) in chains.iter_mut().enumerate() {
            if turned >> i & 1 == 1 {
                chain.reverse();
            }
        }
        let verifier = Verifier::new().boundary(&chains);
        assert!(verifier.verify(&POINTS, &[], &RING).is_ok(), "{chains:?}");
        // The hole filled, and a triangle missing.
        let filled = [&RING[..], &[[4, 5, 6], [4, 6, 7]]].concat();
        let list = verifier.verify(&POINTS, &[], &filled).unwrap_err().list;
        assert_eq!(list.len(), 4, "{list:?}");
        let list = verifier.verify(&POINTS, &[], &RING[1..]).unwrap_err().list;
        assert_eq!(list.len(), 3, "{list:?}");
    }
}

#[test]
fn a_seam_is_no_tangle() {
    let mut points = vec![[0, 0], [4, 0], [2, 0], [2, 3], [2, -3]];
    let triangles = [[0, 1, 3], [0, 4, 2], [2, 4, 1]];
    let chains = [vec![0, 4, 1, 3], vec![0, 1, 2]];
    let verifier = Verifier::new().boundary(&chains);
    assert!(verifier.verify(&points, &[], &triangles).is_ok());
    points.extend([[1, 0], [3, 0], [5, 0], [2, 1], [2, -4]]);
    let list = verifier.verify(&points, &[], &triangles).unwrap_err().list;
    assert_eq!(
        list,
        [5, 6, 8].map(|vertex| Violation::UnusedPoint { vertex })
    );
}

#[test]
fn what_covers_itself_is_no_domain() {
    // A pentagram about a hub: its triangles cover the middle twice, and its sides cross.
    let points = [[0, 0], [10, 0], [3, 9], [-8, 6], [-8, -6], [3, -9]];
    let triangles = [1, 2, 3, 4, 5].map(|v| [0, v, (v + 1) % 5 + 1]);
    assert_tangled(&points, &triangles, &[vec![1, 3, 5, 2, 4]]);

    // One triangle within another.
    let points = [[0, 0], [9, 0], [0, 9], [1, 1], [3, 1], [1, 3]];
    let triangles = [[0, 1, 2], [3, 4, 5]];
    assert_tangled(&points, &triangles, &triangles.map(|t| t.to_vec()));
    assert_tangled(&points, &triangles, &[vec![0, 1, 2], vec![3, 5, 4]]);
}

fn assert_tangled(points: &[[i64; 2]], triangles: &[[usize; 3]], chains: &[Vec<usize>]) {
    let verifier = Verifier::new().boundary(chains);
    let list = verifier.verify(points, &[], triangles).unwrap_err().list;
    assert_eq!(list.len(), 1);
    assert_eq!(list[0].name(), "tangled-boundary");
}

#[test]
fn many_points_beside_many_sides_are_located() {
    // A comb of teeth, and a point in each gap between them.
    const TEETH: usize = 30_000;
    let mut points = vec![[0, 0], [2 * TEETH as i64, 0]];
    let teeth = (0..TEETH as i64).rev();
    points.extend(teeth.flat_map(|i| [[2 * i + 1, 100], [2 * i, 1]]));
    let outline: Vec<usize> = (0..points.len()).collect();
    let edges: Vec<[usize; 2]> = (0..points.len())
        .map(|v| [v, (v + 1) % points.len()])
        .collect();
    let all = triangulate(&points, &edges).unwrap();
    let is_below = |t: &[usize; 3]| {
        // The gaps are triangles above a tooth's foot.
        let [a, b, c] = t.map(|v| points[v][1]);
        a.min(b).min(c) == 0 || [a, b, c].iter().filter(|&&y| y == 1).count() > 1
    };
    let triangles: Vec<[usize; 3]> = all.triangles().filter(is_below).collect();
    let unused = (0..TEETH as i64 - 1).map(|i| [2 * i + 2, 50]);
    points.extend(unused);
    let chains = [outline];
    let verdict = Verifier::new()
        .boundary(&chains)
        .verify(&points, &edges, &triangles);
    assert!(verdict.is_ok(), "{}", verdict.unwrap_err());
}

#[test]
fn a_declared_side_does_not_bend_at_an_added_point() {
    let square = [vec![0, 1, 2, 3]];
    let triangles = [[1, 2, 4], [2, 3, 4], [3, 0, 4]];
    for y in [-1, 0, 1] {
        let points = [[0, 0], [4, 0], [4, 4], [0, 4], [2, y]];
        let verifier = Verifier::new().boundary(&square).added_from(4);
        let verdict = verifier.verify(&points, &[], &triangles);
        assert_eq!(verdict.is_ok(), y == 0, "{y}: {verdict:?}");
    }
}
