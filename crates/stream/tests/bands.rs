//! Bands: joined in any order, what they pass on is the result in memory.

use sweep_cdt::{Error, Triangulator, triangulate};
use sweep_cdt_stream::{Cut, Final, Rest, RestError, StreamError, settle_all};
use sweep_cdt_testing::data::Hard;
use sweep_cdt_testing::generators::{medium, small};
use sweep_cdt_testing::oracle::{crosses, found};
use sweep_cdt_testing::streams::{banded, settled, written_and_read};
use sweep_cdt_testing::{Input, Random, families};

/// Tries bands of up to so many vertices, joined in several orders.
fn assert_as_in_memory(input: &Input, sizes: &[usize], random: &mut Random) {
    let Input { points, edges } = input;
    let memory = triangulate(points, edges);
    for &most in sizes {
        let name = || format!("bands of {most}: {input:?}");
        let outcomes = [
            banded(input, most, random, written_and_read),
            settled::<f64>(input, most, random),
        ];
        for outcome in outcomes {
            match (&memory, outcome) {
                (Ok(result), Some(Ok(answer))) => {
                    let expected = found(result, points.len(), edges.len());
                    assert_eq!(answer, expected, "{}", name());
                }
                (Err(_), Some(Err(Error::CrossingEdges { edges: pair }))) => {
                    assert!(crosses(points, edges, pair), "{pair:?}, {}", name());
                }
                (Err(_), None) => {}
                (memory, bands) => panic!("{memory:?}, but {bands:?}, {}", name()),
            }
        }
    }
}

#[test]
fn small_inputs_are_as_in_memory() {
    for seed in 0..2000 {
        let random = &mut Random::new(seed);
        assert_as_in_memory(&small(random), &[1, 2, 7], random);
    }
}

#[test]
fn medium_inputs_are_as_in_memory() {
    for seed in 0..30 {
        let random = &mut Random::new(seed);
        assert_as_in_memory(&medium(random), &[7, 100, 1000], random);
    }
}

#[test]
fn hard_inputs_are_as_in_memory() {
    for hard in Hard::own() {
        let sizes: &[usize] = match hard.input.points.len() {
            0..100 => &[1, 2, 7],
            100..3000 => &[100, 1000],
            _ => &[10_000],
        };
        assert_as_in_memory(&hard.input, sizes, &mut Random::new(1));
    }
}

/// The families that attack promises about time: most of them keep much alive, or have many edges at one vertex.
#[test]
fn families_are_as_in_memory() {
    for family in families::all().chain(families::slanted()) {
        let input = (family.member)(200);
        assert_as_in_memory(&input, &[1, 16, 100], &mut Random::new(1));
    }
}

/// Vertices in their order, numbered by it.
fn band(cut: &Cut<f64>, first: usize, points: &[[f64; 2]]) -> Rest<f64> {
    let vertices = (first as u64..).zip(points.iter().copied());
    let band = cut.band(first as u64, vertices, [], |_| ());
    band.expect("points in order")
}

/// Of evenly spread points one and a half times the root of their number is alive in a stream: here at both ends.
#[test]
fn few_vertices_of_even_points_are_left() {
    let mut points = Random::new(1).points(40_000);
    points.sort_by(|a, b| a[1].total_cmp(&b[1]));
    let cut = Cut {
        vertices: 40_000,
        between: [0.0, 1.0],
    };
    let mut session = Triangulator::new().session();
    let mut triangles = 0;
    let mut out = |found| triangles += u64::from(matches!(found, Final::Triangle { .. }));
    let mut all: Option<Rest<f64>> = None;
    for (at, points) in points.chunks(10_000).enumerate() {
        let rest = band(&cut, at * 10_000, points);
        let rest = rest.settle(&mut session, &mut out).expect("no edges");
        let sides = if at == 0 || at == 3 { 1 } else { 2 };
        assert!(rest.vertices() < sides * 400, "{at}: {}", rest.vertices());
        let joined = match all {
            None => rest,
            Some(below) => below.followed_by(rest).expect("neighbours"),
        };
        let joined = joined.settle(&mut session, &mut out).expect("no edges");
        assert!(joined.vertices() < 400, "{at}: {}", joined.vertices());
        all = Some(joined);
    }
    assert!(all.is_some_and(|all| all.is_complete() && all.vertices() == 0));
    let memory = triangulate(&points, &[]).expect("points");
    assert_eq!(triangles, memory.len() as u64);
}

#[test]
fn a_band_names_what_is_wrong_with_it() {
    let cut = Cut {
        vertices: 9,
        between: [0.0, 9.0],
    };
    let made = |first, vertices: &[[f64; 2]], edges: &[[[f64; 2]; 2]]| {
        let vertices = (10..).zip(vertices.iter().copied());
        let edges = (7..).zip(edges.iter().copied());
        cut.band(first, vertices, edges, |_| ()).map(|_| ())
    };
    let [a, b] = [[3.0, 3.0], [4.0, 4.0]];
    assert_eq!(made(3, &[a, b], &[[a, b], [b, [0.0, 9.0]]]), Ok(()));
    for (first, vertices, error) in [
        (3, vec![], StreamError::NoVertices),
        (8, vec![a, b], StreamError::NotNext { end: 10, next: 9 }),
        (3, vec![b, a], StreamError::Unsorted { vertex: 11 }),
        (
            3,
            vec![a, [9.5, 4.0]],
            StreamError::OutsideRange { vertex: 11 },
        ),
        (
            3,
            vec![[0.0, f64::NAN]],
            StreamError::NonFiniteCoordinate { vertex: 10 },
        ),
    ] {
        assert_eq!(made(first, &vertices, &[]), Err(error));
    }
    let missing = Err(StreamError::MissingEnd { edge: 7 });
    // An end between the vertices, and ends below the first band and above the last.
    assert_eq!(made(3, &[a, b], &[[[5.0, 3.0], b]]), missing);
    assert_eq!(made(0, &[a, b], &[[[5.0, 2.0], b]]), missing);
    assert_eq!(made(7, &[a, b], &[[a, [5.0, 5.0]]]), missing);
    let bad = Err(StreamError::BadEdge { edge: 7 });
    assert_eq!(made(3, &[a, b], &[[a, [9.5, 5.0]]]), bad);
    assert_eq!(made(3, &[a, b], &[[a, [0.0, f64::INFINITY]]]), bad);
    let edge = (7, [a, [5.0, 5.0]]);
    let twice = cut.band(3, [(0, a), (1, b)], [edge, edge], |_| ());
    assert_eq!(twice.map(|_| ()), bad);
}

#[test]
fn rests_are_joined_with_their_neighbours_alone() {
    let cut = Cut {
        vertices: 9,
        between: [0.0, 9.0],
    };
    let made = |cut: &Cut<f64>, first, y, edges: &[_]| {
        let vertices = (0..).zip([[4.0, y], [3.0, y + 1.0]]);
        let edges = edges.iter().copied();
        cut.band(first, vertices, edges, |_| ()).expect("a band")
    };
    let edge = (7, [[4.0, 3.0], [4.0, 5.0]]);
    let joined = |above| {
        let below = made(&cut, 3, 3.0, &[edge]);
        below.followed_by(above).map(|rest| rest.covered())
    };
    assert_eq!(joined(made(&cut, 5, 5.0, &[edge])), Ok(3..7));
    let apart = StreamError::NotNext { end: 5, next: 6 };
    assert_eq!(joined(made(&cut, 6, 5.0, &[edge])), Err(apart));
    let of_other = Err(StreamError::OtherInput);
    // No such edge, another lower end, an edge that the lower band lacks.
    let moved = (7, [[3.0, 4.0], [4.0, 5.0]]);
    for edges in [&[][..], &[moved], &[edge, (8, edge.1)]] {
        assert_eq!(joined(made(&cut, 5, 5.0, edges)), of_other);
    }
    // Other counts, another range, a vertex that lies no higher than one below.
    let (vertices, between) = (8, [0.0, 8.0]);
    for other in [Cut { vertices, ..cut }, Cut { between, ..cut }] {
        assert_eq!(joined(made(&other, 5, 5.0, &[edge])), of_other);
    }
    assert_eq!(joined(made(&cut, 5, 3.5, &[edge])), of_other);
}

/// A rest with every kind of side and of edge, and what is no rest.
#[test]
fn files_that_are_no_rests_are_refused() {
    let points: Vec<[f64; 2]> = (0..100)
        .map(|i| [f64::from(i * 37 % 101), f64::from(i)])
        .collect();
    let cut = Cut {
        vertices: 300,
        between: [0.0, 101.0],
    };
    let ends = [[1.0, -5.0], [50.0, 200.0]];
    let edges = [
        (5, [points[3], points[90]]),
        (6, [points[20], ends[1]]),
        (7, [ends[0], points[80]]),
        (8, [[101.0, -9.0], [99.5, 300.0]]),
    ];
    let vertices = (0..).zip(points.iter().copied());
    let band = cut.band(100, vertices, edges, |_| ()).expect("a band");
    let mut session = Triangulator::new().session();
    let rest = band.settle(&mut session, |_| ()).expect("no crossings");
    let bytes = written_and_read(rest).to_bytes();
    let refused = |bytes: &[u8]| Rest::from_bytes(bytes).map(|rest| rest.covered());
    assert_eq!(refused(&bytes), Ok(100..200));
    for length in 0..bytes.len() {
        assert!(refused(&bytes[..length]).is_err(), "{length} bytes");
    }
    for at in 0..bytes.len() {
        let mut altered = bytes.clone();
        altered[at] ^= 1;
        let error = match at {
            0..8 => RestError::Foreign,
            8 => RestError::Version(0),
            9..16 => RestError::Version(1 + (1 << (8 * (at - 8)))),
            _ => RestError::Damaged,
        };
        assert_eq!(refused(&altered), Err(error), "byte {at}");
    }
    assert_eq!(
        refused(&[&bytes[..], &[0]].concat()),
        Err(RestError::Damaged)
    );
    assert_eq!(refused(b"ply\nformat ascii 1.0\n"), Err(RestError::Foreign));
}

/// Rows of a lattice, each a band.
fn rows(cut: &Cut<f64>, chosen: &[usize]) -> impl Iterator<Item = Rest<f64>> {
    let row = |&y: &usize| {
        let row: Vec<[f64; 2]> = (0..10).map(|x| [f64::from(x), y as f64]).collect();
        band(cut, 10 * y, &row)
    };
    chosen.iter().map(row).collect::<Vec<_>>().into_iter()
}

#[test]
fn bands_that_are_missing_are_named() {
    let cut = Cut {
        vertices: 90,
        between: [0.0, 9.0],
    };
    let all = [0, 1, 2, 3, 4, 5, 6, 7, 8];
    let settled = |chosen: &[usize], limit| {
        let mut bands = rows(&cut, chosen);
        settle_all(|_| Ok(bands.next()), Ok, limit, |_| ()).map(|stats| stats.triangles)
    };
    let not_next = |end, next| Err(StreamError::NotNext { end, next });
    assert_eq!(settled(&all, 90), Ok(2 * 8 * 9));
    assert_eq!(settled(&all[1..], 90), not_next(0, 10));
    assert_eq!(settled(&all[..5], 90), not_next(50, 90));
    assert_eq!(settled(&[0, 1, 2, 3, 4, 5, 7, 8], 90), not_next(60, 70));
    assert_eq!(settled(&[], 90), Ok(0));
    let few = settled(&all, 5);
    assert!(
        matches!(few, Err(StreamError::TooMuchAlive { limit: 5, .. })),
        "{few:?}"
    );
}

/// An error of a band goes before one of the bands above, whichever is found first.
#[test]
fn the_lowest_error_is_named() {
    let cut = Cut {
        vertices: 90,
        between: [0.0, 9.0],
    };
    for cut_at in [3, 4, 7, 8] {
        let mut bands = rows(&cut, &[0, 1, 3, 4, 5, 6, 7, 8]);
        let mut count = 0;
        let next = |_| {
            count += 1;
            match count > cut_at {
                true => Err(StreamError::OtherInput),
                false => Ok(bands.next()),
            }
        };
        let settled = settle_all(next, Ok, 90, |_| ());
        let expected = match cut_at {
            // The third band is never settled.
            3 => StreamError::OtherInput,
            _ => StreamError::NotNext { end: 20, next: 30 },
        };
        assert_eq!(settled.map(|_| ()), Err(expected), "{cut_at}");
    }
}
