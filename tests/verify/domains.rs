//! Domains that the caller bounds.

use sweep_cdt::verify::{Verifier, Violation};

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
