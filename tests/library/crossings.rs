//! Edges that cross, in many families: little is looked at for each edge and pair, and all pairs are found.

use sweep_cdt::crossings::{Effort, SplitError, crossings_with, split, split_with};
use sweep_cdt_testing::families::{self, Crossed};
use sweep_cdt_testing::oracle::arrangement;
use sweep_cdt_testing::{Input, Random};

/// Boxes and edges that listing and splitting look at, for each edge and pair.
fn looked_at(family: &Crossed, count: usize) -> [f64; 2] {
    let Input { points, edges } = family.of_edges(count);
    let mut listing = Effort::default();
    let pairs = crossings_with(&points, &edges, &mut listing).expect("a valid input");
    assert!(!family.is_crossed || !pairs.is_empty());
    let mut splitting = Effort::default();
    split_with(&points, &edges, &mut splitting).expect("a valid input");
    [listing, splitting].map(|effort| {
        let looked = effort.visited + effort.swept + effort.separated;
        looked as f64 / (edges.len() + pairs.len()) as f64
    })
}

/// No more is looked at than a constant for each edge and pair, whether boxes find the pairs or separations do. A search
/// that looked at each pair of edges would look at a thousand. How this grows up to 512,000 edges counts
/// `cargo bench -p sweep-cdt-benches --bench crossings`.
#[test]
#[ignore = "14 seconds: `.ci/nightly` runs it"]
fn little_is_looked_at_for_each_edge_and_pair() {
    let mut families = 0;
    for family in families::crossed() {
        for count in [250, 2000] {
            let [listing, splitting] = looked_at(&family, count);
            println!("{} {count}: {listing:.1} {splitting:.1}", family.name());
            assert!(listing < 40.0, "{} {count}: {listing}", family.name());
            assert!(splitting < 200.0, "{} {count}: {splitting}", family.name());
        }
        families += 1;
    }
    assert!(families >= 120, "{families} families");
}

/// Boxes, the sweep line and separations by themselves, against every pair in fractions.
#[test]
fn all_pairs_of_small_members_are_found() {
    for family in families::crossed() {
        let Input { points, edges } = family.of_edges(60);
        let exact = arrangement::fractions(&points);
        let expected = arrangement::crossings(&exact, &edges);
        for patience in [0, 1, 16, usize::MAX] {
            let effort = &mut Effort {
                patience,
                ..Effort::default()
            };
            let found = crossings_with(&points, &edges, effort).expect("a valid input");
            let found: Vec<_> = found.iter().map(|one| (one.edges, one.point())).collect();
            assert_eq!(found, expected, "{}, patience {patience}", family.name());
        }
    }
}

/// Edges far apart and far longer than all of them are wide, found by review: no two boxes meet, and each pair of parts
/// of a tree of boxes did.
#[test]
fn upright_edges_look_at_each_other_no_more() {
    let [few, many] = [1000, 16_000].map(|n: u32| {
        let ends = |i: u32| [[f64::from(i), 0.0], [f64::from(i), 1e7 + f64::from(i % 7)]];
        let points: Vec<[f64; 2]> = (0..n).flat_map(ends).collect();
        let edges: Vec<[usize; 2]> = (0..points.len()).step_by(2).map(|v| [v, v + 1]).collect();
        let mut effort = Effort::default();
        assert_eq!(crossings_with(&points, &edges, &mut effort), Ok(Vec::new()));
        effort.visited as f64 / f64::from(n)
    });
    assert!(many < 2.0 * few, "{few} {many} for each edge");
}

/// An edge that is bent where it crosses another goes on through the point that it passed, which is no end of an edge. So
/// edges that meet at a point still do: near zero, where doubles are dense, they would all cross each other otherwise.
#[test]
fn a_bent_edge_still_passes_a_point_on_it() {
    let points = [
        [-3.0, -1.0],
        [3.0, 1.0],
        [-2.0, 0.0],
        [-1.0, -1.0],
        [0.0, 0.0],
    ];
    let edges = [[0, 1], [2, 3]];
    let split = split(&points, &edges).expect("a valid input");
    assert_eq!(split.edges, [[0, 5], [5, 4], [4, 1], [2, 5], [5, 3]]);
}

/// A hatch, whose boxes all meet, with some edges across it.
fn hatch(random: &mut Random) -> Input {
    let lines = 2 + random.below(90);
    let top = lines as f64;
    let ends = (0..lines)
        .map(|i| i as f64)
        .map(|x| [[x, 0.0], [x + top, top]]);
    let mut edges: Vec<[usize; 2]> = (0..lines).map(|i| [2 * i, 2 * i + 1]).collect();
    let points = ends.flatten().collect();
    for _ in 0..random.below(12) {
        edges.push([(); 2].map(|()| random.below(2 * lines)));
    }
    Input { points, edges }
}

/// Points on few places, zeros of both signs among their coordinates, with edges between them: they overlap, pass through
/// vertices and cross there.
fn on_few_places(random: &mut Random) -> Input {
    let (count, places) = (4 + random.below(30), 2 + random.below(9));
    let mut coordinate = || random.pick(&[1.0, -1.0]) * random.below(places) as f64;
    let points = (0..count).map(|_| [coordinate(), coordinate()]).collect();
    let edges = 0..2 + random.below(14);
    let edges = edges
        .map(|_| [(); 2].map(|()| random.below(count)))
        .collect();
    Input { points, edges }
}

/// Edges that meet at vertices inside them: lines through the points of a grid, or through some centres.
fn through_vertices(random: &mut Random) -> Input {
    let mut points = Vec::new();
    let mut edges = Vec::new();
    let mut edge = |points: &mut Vec<[f64; 2]>, ends: [[f64; 2]; 2]| {
        edges.push([points.len(), points.len() + 1]);
        points.extend(ends);
    };
    if random.below(2) == 0 {
        let [columns, rows] = [(); 2].map(|()| 2 + random.below(15));
        let grid = (0..columns * rows).map(|i| [i % columns, i / columns]);
        points.extend(grid.map(|place| place.map(|x| x as f64)));
        for x in (0..columns).map(|x| x as f64) {
            edge(&mut points, [[x, -1.0], [x, rows as f64]]);
        }
        for y in (0..rows).map(|y| y as f64) {
            edge(&mut points, [[-1.0, y], [columns as f64, y]]);
        }
    } else {
        for _ in 0..=random.below(3) {
            let [x, y] = [(); 2].map(|()| random.below(20) as f64);
            points.push([x, y]);
            for _ in 0..=random.below(20) {
                let [dx, dy] = [
                    random.below(99) as f64 - 49.0,
                    1.0 + random.below(50) as f64,
                ];
                edge(&mut points, [[x - dx, y - dy], [x + dx, y + dy]]);
            }
        }
    }
    Input { points, edges }
}

/// Random edges, searched as if they were many. More crossings than may be listed are an error.
#[test]
fn every_pair_is_found_once_or_there_are_too_many() {
    const LIMIT: usize = 100;
    let random = &mut Random::new(1);
    let (mut some, mut too_many) = (0, 0);
    for round in 0..1500 {
        let Input { points, edges } = match round % 6 {
            0 | 3 => hatch(random),
            1 | 4 => through_vertices(random),
            _ => on_few_places(random),
        };
        let exact = arrangement::fractions(&points);
        let expected = arrangement::crossings(&exact, &edges);
        let effort = &mut Effort {
            patience: round % 2,
            limit: LIMIT,
            ..Effort::default()
        };
        match crossings_with(&points, &edges, effort) {
            Ok(found) => {
                let found: Vec<_> = found.iter().map(|one| (one.edges, one.point())).collect();
                assert_eq!(found, expected, "{points:?} {edges:?}");
                some += usize::from(!found.is_empty());
            }
            Err(error) => {
                assert_eq!(error, SplitError::TooManyCrossings { limit: LIMIT });
                assert!(expected.len() > LIMIT, "{points:?} {edges:?}");
                too_many += 1;
            }
        }
    }
    let counts = format!("{some} with crossings, {too_many} with too many");
    assert!(some > 500 && too_many > 5, "{counts}");
}
