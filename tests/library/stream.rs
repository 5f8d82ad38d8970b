//! Streams: what is passed on is the result in memory, whatever the window; what stays alive; each way to end early.
//!
//! The table of `runs` has streams of every scalar with every front, so that small inputs meet the oracle.

use sweep_cdt::front::AnyFront;
use sweep_cdt::stream::{Final, Stream, StreamError};
use sweep_cdt::verify::{StreamVerifier, StreamViolation};
use sweep_cdt::{Error, Triangulator, triangulate};
use sweep_cdt_testing::data::Hard;
use sweep_cdt_testing::generators::{medium, small};
use sweep_cdt_testing::oracle::{crosses, found};
use sweep_cdt_testing::streams::{Altered, Streaming, streamed};
use sweep_cdt_testing::{Input, Random, families};

/// Tries windows of several sizes, with and without the range of x.
fn assert_as_in_memory(input: &Input, windows: &[usize]) {
    let Input { points, edges } = input;
    let memory = triangulate(points, edges);
    for &window in windows {
        for is_range_known in [false, true] {
            let way = Streaming {
                window,
                is_range_known,
                front: AnyFront::default(),
            };
            let name = || format!("{way:?}: {input:?}");
            match (&memory, streamed::<f64>(input, &way)) {
                (Ok(result), Some(Ok(answer))) => {
                    assert_eq!(
                        answer,
                        found(result, points.len(), edges.len()),
                        "{}",
                        name()
                    );
                }
                (Err(_), Some(Err(Error::CrossingEdges { edges: pair }))) => {
                    assert!(crosses(points, edges, pair), "{pair:?}, {}", name());
                }
                (Err(_), None) => {}
                (memory, stream) => panic!("{memory:?}, but {stream:?}, {}", name()),
            }
        }
    }
}

#[test]
fn small_inputs_are_as_in_memory() {
    for seed in 0..1000 {
        assert_as_in_memory(&small(&mut Random::new(seed)), &[1, 2, 7]);
    }
}

#[test]
fn medium_inputs_are_as_in_memory() {
    for seed in 0..30 {
        assert_as_in_memory(&medium(&mut Random::new(seed)), &[7, 100, 1000]);
    }
}

#[test]
fn hard_inputs_are_as_in_memory() {
    for hard in Hard::own() {
        let windows: &[usize] = match hard.input.points.len() {
            0..100 => &[1, 2, 7],
            100..3000 => &[100, 1000],
            _ => &[10_000],
        };
        assert_as_in_memory(&hard.input, windows);
    }
}

/// The steps of a window are those of a run on it: along y where it is high, along x where it is wide.
#[test]
fn the_steps_of_a_window_are_passed_on() {
    let few: [[i32; 2]; 7] = [[0, 0], [5, 1], [2, 3], [4, 7], [1, 8], [3, 12], [2, 19]];
    for is_wide in [false, true] {
        let place = |[x, y]: [i32; 2]| if is_wide { [y, x] } else { [x, y] };
        let mut points = few.map(place);
        points.sort_by_key(|&[x, y]| (y, x));
        let swept = points.map(place);
        let mut expected = Vec::new();
        let run = Triangulator::new().observe(&swept, &[], |event| expected.push(event));
        run.expect("points");
        let mut steps = Vec::new();
        let mut stream = Triangulator::new()
            .stream(|_| {})
            .observe(|event, numbers| {
                assert_eq!(numbers, [10, 11, 12, 13, 14, 15, 16]);
                steps.push(event);
            });
        for (number, point) in (10..).zip(points) {
            stream.push(number, point).expect("a point in order");
        }
        stream.finish().expect("an end");
        assert_eq!(steps, expected);
        assert!(steps.len() > 20, "{}", steps.len());
    }
}

/// The families that attack promises about time: most of them keep much alive, or have many edges at one vertex.
#[test]
fn families_are_as_in_memory() {
    for family in families::all().chain(families::slanted()) {
        let input = (family.member)(200);
        assert_as_in_memory(&input, &[16]);
        let result = triangulate(&input.points, &input.edges).expect(family.name);
        Altered::right(&input.points, &input.edges, &result).assert_verdict();
    }
}

/// The verifier of streams accepts right lists of triangles, and of altered ones those that the verifier accepts.
#[test]
fn the_verifier_of_streams_knows_right_from_wrong() {
    for seed in 0..2000 {
        let random = &mut Random::new(seed);
        let Input { points, edges } = small(random);
        if let Ok(result) = triangulate(&points, &edges) {
            Altered::right(&points, &edges, &result).assert_verdict();
            for _ in 0..4 {
                Altered::wrong(&points, &edges, &result, random).assert_verdict();
            }
        }
    }
}

/// An edge that ends inside a side is no chain of sides.
#[test]
fn an_edge_must_end_at_a_vertex() {
    let verdict = |upper| {
        let mut verifier = StreamVerifier::new();
        for (number, point) in (0..).zip([[0, 0], [4, 0], [0, 4]]) {
            verifier.vertex(number, point)?;
        }
        verifier.edge(7, 0, upper)?;
        verifier.triangle([0, 1, 2], None)?;
        verifier.finish()
    };
    let broken = StreamViolation::BrokenEdge { edge: 7, vertex: 0 };
    assert_eq!(verdict([2, 0]), Err(broken));
    assert!(verdict([4, 0]).is_ok());
}

/// Two edges meet at a vertex that comes after both have begun.
#[test]
fn edges_may_meet_at_a_vertex_to_come() {
    let points = vec![[0.0, 0.0], [4.0, 0.0], [2.0, 2.0], [0.0, 4.0], [4.0, 4.0]];
    let edges = vec![[0, 4], [1, 3]];
    assert_as_in_memory(&Input { points, edges }, &[1, 2]);
}

/// Many edges begin at one vertex, more than their steps through a small window are counted for: all that is alive waits,
/// also the sides of the hull, of which one is a piece of an edge.
#[test]
fn many_edges_may_begin_at_one_vertex() {
    let mut points = vec![
        [0.0, 0.0],
        [60.0, 0.0],
        [60.0, 1.0],
        [30.0, 2.0],
        [60.0, 3.0],
    ];
    points.extend((0..=60).map(|i| [f64::from(i), 60.0]));
    let mut edges: Vec<[usize; 2]> = (5..points.len()).map(|v| [0, v]).collect();
    edges.push([1, points.len() - 1]);
    assert_as_in_memory(&Input { points, edges }, &[1, 2, 3, 7]);
}

type Ignored = fn(Final);

fn stream() -> Stream<'static, f64, Ignored> {
    let ignored: Ignored = |_| ();
    Triangulator::new().stream(ignored).window(1)
}

#[test]
fn each_error_names_its_offender_and_stays() {
    let end = |mut stream: Stream<'static, f64, Ignored>, error| {
        assert_eq!(stream.push(99, [9.0, 99.0]), Err(error));
        assert_eq!(stream.edge(99, [9.0, 999.0]), Err(error));
        assert_eq!(stream.finish(), Err(error));
    };
    let begun = || {
        let mut stream = stream().between(-9.0, 9.0);
        stream.push(5, [0.0, 0.0]).expect("a first vertex");
        stream
    };
    for (point, error) in [
        (
            [f64::NAN, 1.0],
            StreamError::NonFiniteCoordinate { vertex: 6 },
        ),
        ([0.0, -1.0], StreamError::Unsorted { vertex: 6 }),
        ([-1.0, 0.0], StreamError::Unsorted { vertex: 6 }),
        ([9.5, 1.0], StreamError::OutsideRange { vertex: 6 }),
    ] {
        let mut stream = begun();
        assert_eq!(stream.push(6, point), Err(error));
        end(stream, error);
    }
    let error = StreamError::BadEdge { edge: 7 };
    for upper in [[0.0, -1.0], [-1.0, 0.0], [9.5, 1.0], [0.0, f64::INFINITY]] {
        let mut stream = begun();
        assert_eq!(stream.edge(7, upper), Err(error));
        end(stream, error);
    }
    assert_eq!(stream().edge(7, [0.0, 0.0]), Err(error));
    let error = StreamError::MissingEnd { edge: 7 };
    let mut stream = begun();
    stream.edge(7, [1.0, 1.0]).expect("an edge");
    assert_eq!(stream.push(6, [2.0, 1.0]), Err(error));
    end(stream, error);
    let mut stream = begun();
    stream.edge(7, [1.0, 1.0]).expect("an edge");
    assert_eq!(stream.finish(), Err(error));
}

#[test]
fn an_edge_of_no_length_is_left_out() {
    let mut stream = stream();
    stream.push(0, [0.0, 0.0]).expect("a vertex");
    stream.edge(0, [0.0, 0.0]).expect("an edge");
    let stats = stream.finish().expect("no triangle");
    assert_eq!((stats.vertices, stats.edges, stats.triangles), (1, 0, 0));
}

/// How many vertices of evenly spread points are alive at most: one and a half times the root of their number.
#[test]
fn few_vertices_of_even_points_are_alive() {
    let mut points = Random::new(1).points(40_000);
    points.sort_by(|a, b| a[1].total_cmp(&b[1]));
    let mut stream = Triangulator::new()
        .stream(|_| ())
        .window(1000)
        .between(0.0, 1.0);
    for (number, point) in (0..).zip(points) {
        stream.push(number, point).expect("a vertex in order");
    }
    let stats = stream.finish().expect("no edges");
    assert_eq!(stats.vertices, 40_000);
    assert!(stats.most_alive.vertices < 500, "{stats:?}");
}

/// A whole circle stays alive to the end: windows grow twofold, and a limit ends the stream.
#[test]
fn a_circle_is_alive_as_a_whole() {
    let turn = |i: u32| f64::from(i) / 4096.0 * std::f64::consts::TAU;
    let mut points: Vec<[f64; 2]> = (0..4096).map(|i| [turn(i).cos(), turn(i).sin()]).collect();
    points.sort_by(|a, b| a[1].total_cmp(&b[1]).then(a[0].total_cmp(&b[0])));
    let fed = |limit| {
        let mut stream = Triangulator::new()
            .stream(|_| ())
            .window(16)
            .limit(limit)
            .between(-1.0, 1.0);
        for (number, &point) in (0..).zip(&points) {
            stream.push(number, point)?;
        }
        stream.finish()
    };
    let stats = fed(5000).expect("no edges");
    assert!(stats.most_alive.vertices > 1000, "{stats:?}");
    assert!(stats.windows < 12, "{stats:?}");
    let Err(StreamError::TooMuchAlive { alive, limit: 100 }) = fed(100) else {
        panic!("more than 100 vertices are alive");
    };
    assert!(alive.vertices > 100 && alive.circles > 50, "{alive:?}");
}
