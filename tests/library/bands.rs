//! The sweep in bands: the same result as on one thread, whatever the number of bands.
//!
//! Each result is compared with that of one thread and verified. That bands were swept at all, and not one
//! thread after all, shows in the numbers of the triangles, which are others then.

use num_bigint::BigInt;
use num_rational::BigRational;
use sweep_cdt::front::SkipList;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::{
    Algorithm, Bands, Error, Heuristics, Stats, Triangulation, Triangulator, triangulate,
};
use sweep_cdt_testing::data::{self, Hard};
use sweep_cdt_testing::families;
use sweep_cdt_testing::generators::medium;
use sweep_cdt_testing::oracle::{Answer, check_links, found};
use sweep_cdt_testing::runs::{ALGORITHMS, convert};
use sweep_cdt_testing::{Input, Random, counted};

const BANDS: [usize; 4] = [2, 3, 4, 5];

/// Panics unless these points and edges have the same result in bands, or the same error. Returns whether
/// bands were swept, in all cases.
fn agrees<S: Scalar + Sync>(
    triangulator: &Triangulator,
    points: &[[S; 2]],
    edges: &[[usize; 2]],
) -> bool {
    let answer = |result: &Triangulation| found(result, points.len(), edges.len());
    let one = triangulator.triangulate(points, edges);
    let expected: Result<Answer, Error> = one.as_ref().map(answer).map_err(|error| *error);
    BANDS.iter().all(|&bands| {
        let all = triangulator.triangulate_parallel(points, edges, Bands::new().count(bands));
        let result = all.as_ref().map(answer).map_err(|error| *error);
        assert_eq!(result, expected, "{bands} bands (right: one thread)");
        let (Ok(one), Ok(all)) = (&one, &all) else {
            return false;
        };
        check_links(all);
        let report = all.with_points(points).verify(edges).expect("right");
        assert!(report.is_canonical());
        !all.triangles().eq(one.triangles())
    })
}

fn are_swept(Input { points, edges }: &Input) -> bool {
    agrees(&Triangulator::new(), points, edges)
}

/// Points on a small grid, so that many are equal or on one line, and edges that do not cross, if any are
/// left. With `dense` edges many pass through vertices and some cross.
fn lattice(random: &mut Random, dense: bool) -> Input {
    let side = 3 + random.below(7);
    let count = 2 + random.below(3 * side * side);
    let coordinate = |random: &mut Random| random.below(side) as f64;
    let points: Vec<[f64; 2]> = (0..count)
        .map(|_| [coordinate(random), coordinate(random)])
        .collect();
    let most = if dense { 6 } else { 3 };
    let edges = (0..random.below(most))
        .map(|_| [random.below(count), random.below(count)])
        .collect();
    Input { points, edges }
}

#[test]
fn every_family() {
    for family in families::all() {
        for (n, order) in [(100, false), (1000, true), (5000, true)] {
            let mut input = (family.member)(n);
            if order {
                input = families::scattered(&input);
            }
            println!("{}, {n}: {}", family.name, are_swept(&input));
        }
    }
}

#[test]
fn inputs_that_broke_other_programs() {
    for hard in Hard::own() {
        println!("{}: {}", hard.name, are_swept(&hard.input));
    }
}

#[test]
fn contours_in_bands() {
    let input = data::contours();
    assert!(are_swept(&input), "one thread did it all");
}

/// More edges than a thread sorts out at a time, each through a vertex and partly over the next one.
#[test]
fn many_edges_through_vertices() {
    let (columns, rows) = (200, 202);
    let vertex = |at: usize| [at % columns, at / columns].map(|x| x as f64);
    let points = (0..columns * rows).map(vertex).collect();
    let edges = (0..columns * (rows - 2)).map(|at| [at, at + 2 * columns]);
    let edges = edges.collect();
    assert!(are_swept(&Input { points, edges }), "one thread did it all");
}

#[test]
fn lattices() {
    let mut swept = 0;
    for seed in 0..600 {
        let input = lattice(&mut Random::new(seed), seed % 2 == 0);
        println!("{seed}: {input:?}");
        swept += usize::from(are_swept(&input));
    }
    assert!(swept > 100, "{swept} of 600");
}

#[test]
fn other_scalars() {
    for seed in 0..60 {
        let random = &mut Random::new(seed);
        let Input { points, edges } = if seed % 2 == 0 {
            lattice(random, true)
        } else {
            medium(random)
        };
        let third = BigRational::new(BigInt::from(1), BigInt::from(3));
        // The same doubles, but for the last of them: heights that only rationals tell apart.
        let tiny = BigRational::new(BigInt::from(1), BigInt::from(10).pow(40));
        let rationals: Vec<[BigRational; 2]> = convert::<BigRational>(&points)
            .expect("finite")
            .into_iter()
            .map(|point| point.map(|x| x * &tiny + &third))
            .collect();
        let triangulator = Triangulator::new();
        agrees(&triangulator, &rationals, &edges);
        if let Some(integers) = convert::<i64>(&points) {
            agrees(&triangulator, &integers, &edges);
        }
    }
}

#[test]
fn other_settings() {
    for seed in 0..40 {
        let random = &mut Random::new(seed);
        let Input { points, edges } = medium(random);
        let others = ALGORITHMS.iter().map(|&(_, algorithm)| algorithm);
        for algorithm in [Algorithm::Sweep].into_iter().chain(others) {
            let triangulator = Triangulator::new()
                .algorithm(algorithm)
                .heuristics(random.pick(&[Heuristics::PAPER, Heuristics::OFF]));
            agrees(&triangulator, &points, &edges);
        }
    }
}

/// A grid with edges from its lower to its upper rows: through vertices, along each other, equal, crossing
/// the gaps between all bands, and with sides of the result that no band knows.
#[test]
fn edges_from_band_to_band() {
    const SIDE: usize = 40;
    let at = |x: usize, y: usize| x * SIDE + y;
    let points: Vec<[f64; 2]> = (0..SIDE * SIDE)
        .map(|i| [(i / SIDE) as f64, (i % SIDE) as f64])
        .collect();
    let top = SIDE - 1;
    let mut edges: Vec<[usize; 2]> = (0..SIDE).map(|x| [at(x, 0), at(x, top)]).collect();
    edges.extend((0..SIDE).map(|x| [at(x, top), at(x, 3)]));
    edges.push([at(0, 0), at(0, top)]);
    edges.extend((5..20).map(|y| [at(3, y), at(4, y)]));
    assert!(are_swept(&Input { points, edges }), "one thread did it all");
}

/// Two edges that cross: both in one band, one in a band and one from band to band, both from band to band.
#[test]
fn crossing_edges() {
    let mut random = Random::new(1);
    let mut points = random.points(400);
    for [a, b] in [
        [[0.1, 0.1], [0.2, 0.2]],
        [[0.1, 0.2], [0.2, 0.1]],
        [[0.5, 0.05], [0.6, 0.95]],
        [[0.5, 0.15], [0.6, 0.15]],
        [[0.6, 0.04], [0.5, 0.96]],
    ] {
        points.extend([a, b]);
    }
    let edges: Vec<[usize; 2]> = (0..5).map(|e| [400 + 2 * e, 401 + 2 * e]).collect();
    for pair in [[0, 1], [2, 3], [2, 4]] {
        let edges = pair.map(|e| edges[e]);
        let error = Triangulator::new().triangulate(&points, &edges);
        assert!(matches!(error, Err(Error::CrossingEdges { .. })));
        assert!(!agrees(&Triangulator::new(), &points, &edges));
    }
    agrees(&Triangulator::new(), &points, &edges);
}

/// Points on a line, on two lines, all equal, few: bands of one vertex, of none, without triangles.
#[test]
fn bands_without_triangles() {
    let line = |dx: f64, dy: f64| -> Vec<[f64; 2]> {
        let at = |i: i32| [dx * f64::from(i), dy * f64::from(i)];
        (0..50).map(at).collect()
    };
    let rows = |heights: &[f64]| -> Vec<[f64; 2]> {
        let row = |&y: &f64| (0..20).map(move |i| [f64::from(i), y]);
        heights.iter().flat_map(row).collect()
    };
    let mut single = rows(&[0.0, 1.0]);
    single.extend([[5.0, -7.0], [3.0, 9.0]]);
    let inputs = [
        line(0.0, 1.0),
        line(1.0, 0.0),
        line(1.0, 1.0),
        line(-1.0, 1.0),
        rows(&[0.0, 1.0]),
        rows(&[0.0, 1.0, 2.0, 3.0, 4.0]),
        single,
        vec![[1.0, 2.0]; 30],
        vec![[0.0, 0.0], [1.0, 2.0]],
        vec![[0.0, 0.0], [1.0, 2.0], [-1.0, 3.0], [5.0, 5.0]],
        Vec::new(),
    ];
    for points in inputs {
        for edges in [vec![], vec![[0, points.len().saturating_sub(1)]]] {
            if edges.is_empty() || !points.is_empty() {
                println!("{points:?} {edges:?}");
                are_swept(&Input {
                    points: points.clone(),
                    edges,
                });
            }
        }
    }
}

#[test]
fn refused_inputs() {
    let mut random = Random::new(3);
    let mut points = random.points(100);
    let triangulator = Triangulator::new();
    agrees(&triangulator, &points, &[[0, 1], [2, 100], [101, 3]]);
    let bands = || Bands::new().count(3);
    let error = triangulator.triangulate_parallel(&points, &[[7, 100]], bands());
    assert_eq!(
        error.err(),
        Some(Error::EdgeOutOfRange {
            edge: 0,
            vertex: 100
        })
    );
    points[40][1] = f64::NAN;
    let error = triangulator.triangulate_parallel(&points, &[], bands());
    assert_eq!(error.err(), Some(Error::NonFiniteCoordinate { vertex: 40 }));
}

/// The counters of all bands, and what of them survives, are those of the whole result.
#[test]
fn statistics() {
    let points = Random::new(4).points(2000);
    let contours = data::contours();
    let inputs = [
        (points.clone(), vec![]),
        (points.clone(), vec![[0, 1]]),
        (contours.points, contours.edges),
    ];
    for (points, edges) in &inputs {
        let one = counted(&Triangulator::new(), points, edges);
        let one = one.expect("valid");
        for bands in BANDS {
            let mut stats = Stats::default();
            let bands_with_stats = Bands::new().count(bands).stats(&mut stats);
            let all = Triangulator::new().triangulate_parallel(points, edges, bands_with_stats);
            let all = all.expect("valid");
            assert!(
                !all.triangles().eq(one.triangulation.triangles()),
                "one sweep"
            );
            assert_eq!(
                all.canonical_triangles(),
                one.triangulation.canonical_triangles()
            );
            assert_eq!((stats.triangles, stats.edges), (all.len(), edges.len()));
            let (counters, of_one) = (stats.counters, one.stats.counters);
            assert_eq!(counters.survived.sum(), all.len() as u64);
            // The first vertex of each band joins no front.
            let firsts = bands as u64 - 1;
            assert_eq!(counters.point_events + firsts, of_one.point_events);
            assert!(counters.made.divide_and_conquer > 0, "gaps are closed");
            assert!(counters.longest_front <= of_one.longest_front);
            assert!(stats.memory > 0 && !stats.is_divided);
        }
    }
    // One band is one sweep. What is refused without statistics is refused with them.
    let triangulator = Triangulator::new();
    let mut stats = Stats::default();
    let one = Bands::new().count(1).stats(&mut stats);
    let one = triangulator.triangulate_parallel(&points, &[], one);
    let whole = counted(&triangulator, &points, &[]).expect("valid");
    one.expect("valid");
    assert_eq!(stats.counters, whole.stats.counters);
    let bands = Bands::new().count(3).stats(&mut stats);
    let wrong = triangulator.triangulate_parallel(&points, &[[7, 2000]], bands);
    assert!(wrong.is_err());
}

/// Each band has its structure, which the caller reads afterwards; there are no more bands than structures.
#[test]
fn structures_come_back() {
    let points = Random::new(5).points(3000);
    let mut fronts: Vec<_> = (0..3).map(|_| SkipList::counting()).collect();
    let bands = Bands::new().count(5).fronts(&mut fronts);
    let all = Triangulator::new().triangulate_parallel(&points, &[], bands);
    let one = triangulate(&points, &[]).expect("valid");
    let expected = one.canonical_triangles();
    assert!(all.expect("valid").canonical_triangles() == expected);
    for front in &fronts {
        // Nearly all of a third of the points join the front of the band.
        assert!((900..3000).contains(&front.work().updates), "{front:?}");
    }
}
