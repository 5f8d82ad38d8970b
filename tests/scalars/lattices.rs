//! Points on lattices of each width, whose signs the filter leaves open: what the verifier says of a few of them,
//! against plain determinants.

use std::collections::BTreeMap;

use sweep_cdt::verify::{Violation, verify};

use super::*;

/// The width of the lattice of a round, from 4 to 2^47 units.
fn width(round: usize) -> usize {
    1 << (2 + round % 46)
}

/// Eighths, far from zero where the lattice is narrow.
fn placed(points: Points, width: usize) -> Points {
    let origin = if width <= 4096 { 1e9 } else { 0.0 };
    points.map(|p| p.map(|x| origin + x / 8.0))
}

/// Rectangles with one corner off by at most one unit in x and in y.
#[test]
fn circles_on_lattices_of_each_width_are_decided() {
    let random = &mut Random::new(1);
    let mut counts = BTreeMap::new();
    for round in 0..8000 {
        let width = width(round);
        let mut range = || {
            let low = random.below(width - 3);
            [low, low + 3 + random.below(width - 3 - low)].map(|x| x as f64)
        };
        let ([left, right], [low, high]) = (range(), range());
        let corner = [
            left + random.pick(&[0.0, 1.0]),
            high + random.pick(&[0.0, 0.0, 1.0, -1.0]),
        ];
        let points = [[left, low], [right, low], [right, high], corner];
        let points = placed(points, width);
        let [_, expected, _] = reference(&exact(&points));
        let found = match verify(&points, &[], &[[0, 1, 2], [0, 2, 3]]) {
            Ok(report) if report.cocircular_sides == 1 => Ordering::Equal,
            Ok(_) => Ordering::Less,
            Err(wrong) => {
                assert!(matches!(wrong.list[..], [Violation::NotDelaunay { .. }]));
                Ordering::Greater
            }
        };
        assert_eq!(found, expected, "{points:?}");
        *counts.entry(found).or_insert(0) += 1;
    }
    assert!(
        counts.len() == 3 && counts.values().all(|&count| count > 1000),
        "{counts:?}"
    );
}

/// Three points at even distances, of which the last is off by at most one unit.
#[test]
fn turns_on_lattices_of_each_width_are_decided() {
    let random = &mut Random::new(2);
    let mut counts = BTreeMap::new();
    for round in 0..8000 {
        let width = width(round);
        let [x, y, dx, dy] = [(); 4].map(|()| random.below(width / 3 + 1) as f64);
        let off = random.below(3) as f64 - 1.0;
        let last = [x + 2.0 * dx, y + 2.0 * dy + off];
        let points = placed([[x, y], [x + dx, y + dy], last, last], width);
        let [expected, _, _] = reference(&exact(&points));
        let found = match verify(&points[..3], &[], &[[0, 1, 2]]) {
            Ok(_) => Ordering::Greater,
            Err(wrong) if matches!(wrong.list[0], Violation::FlatTriangle { .. }) => {
                Ordering::Equal
            }
            Err(_) => Ordering::Less,
        };
        assert_eq!(found, expected, "{points:?}");
        *counts.entry(found).or_insert(0) += 1;
    }
    assert!(
        counts.len() == 3 && counts.values().all(|&count| count > 1000),
        "{counts:?}"
    );
}
