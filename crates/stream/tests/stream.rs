//! Streams: what is passed on is the result in memory, whatever the window; what stays alive; each way to end early.
//!
//! The table of `runs` has streams of every scalar with every front, so that small inputs meet the oracle.

use sweep_cdt::verify::Level;
use sweep_cdt::{Error, Triangulator, Watch, triangulate};
use sweep_cdt_stream::{Final, Stream, StreamError, StreamVerifier, StreamViolation};
use sweep_cdt_testing::data::Hard;
use sweep_cdt_testing::generators::{drop_crossings, medium, small};
use sweep_cdt_testing::oracle::{crosses, found};
use sweep_cdt_testing::streams::{Altered, Feeding, Streaming, streamed};
use sweep_cdt_testing::{AnyFront, Input, Random, families};

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
        let mut push = |event| expected.push(event);
        let watch = Watch::new().events(&mut push);
        let run = Triangulator::new().run(&swept, &[], watch);
        run.expect("points");
        let mut steps = Vec::new();
        let mut stream = Stream::new(Triangulator::new(), |_| {}).observe(|event, numbers| {
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
        let right = Altered::right(&input.points, &input.edges, &result);
        right.assert_verdict(Level::Canonical, Feeding::AsNamed);
        let shuffled = right.shuffled(&mut Random::new(1));
        shuffled.assert_verdict(Level::Canonical, Feeding::Before);
    }
}

/// The verifier of streams accepts right lists of triangles, and of altered ones those that the verifier accepts: at each
/// level, in any order.
#[test]
fn both_verifiers_have_one_verdict() {
    for seed in 0..500 {
        let random = &mut Random::new(seed);
        let Input { points, edges } = small(random);
        if let Ok(result) = triangulate(&points, &edges) {
            let right = Altered::right(&points, &edges, &result);
            assert_one_verdict(&right, random);
            for _ in 0..4 {
                let altered = Altered::wrong(&points, &edges, &result, random);
                assert_one_verdict(&altered, random);
            }
        }
    }
}

/// The verdict on triangles in the order of the result, and in another one.
fn assert_one_verdict(altered: &Altered<'_>, random: &mut Random) {
    for level in Level::ALL {
        let feeding = random.pick(&Feeding::ALL);
        altered.assert_verdict(level, feeding);
        altered
            .clone()
            .shuffled(random)
            .assert_verdict(level, feeding);
    }
}

/// Edges from one side of a lattice to the other, through all vertices between, whose ends are points that occur twice.
#[test]
fn edges_through_many_vertices_may_be_taken_in_any_order() {
    for seed in 0..20 {
        let random = &mut Random::new(seed);
        let size = 3 + random.below(8);
        let place = |v: usize| [v % size, v / size].map(|x| x as f64);
        let mut points: Vec<[f64; 2]> = (0..size * size).map(place).collect();
        points.extend((0..size).map(place));
        let last = size * (size - 1);
        let mut edges: Vec<[usize; 2]> = Vec::new();
        for _ in 0..random.below(2 * size) {
            let (along, a, b) = (random.below(size), random.below(size), random.below(size));
            edges.push(match random.below(4) {
                0 => [size * a + along, size * b + along],
                1 => [size * size + along, last + along],
                2 => [size * along + a, size * along + b],
                _ => [size * a, last + a],
            });
        }
        drop_crossings(&points, &mut edges);
        let result = triangulate(&points, &edges).expect("edges that do not cross");
        let right = Altered::right(&points, &edges, &result);
        assert_one_verdict(&right, random);
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

/// What the verifier of streams could not decide later, it refuses at once.
#[test]
fn edges_come_before_triangles_at_their_lower_ends_and_above() {
    let with_square = || {
        let mut verifier = StreamVerifier::new();
        for (number, point) in (0..).zip([[0, 0], [4, 0], [4, 4], [0, 4], [2, 9], [3, 4]]) {
            verifier.vertex(number, point).expect("a vertex");
        }
        verifier.triangle([0, 1, 3], None).expect("a triangle");
        verifier
    };
    // Vertex 3 is the highest corner. Vertex 5 is farther right.
    for from in [0, 1, 3] {
        let late = StreamViolation::LateEdge { edge: 7 };
        assert_eq!(with_square().edge(7, from, [2, 9]), Err(late), "{from}");
    }
    assert_eq!(with_square().edge(7, 5, [2, 9]), Ok(()));
    let late = StreamViolation::LateEdge { edge: 7 };
    let tiling = with_square().level(Level::Tiling).edge(7, 0, [2, 9]);
    assert_eq!(tiling, Err(late));
}

/// A duplicate is named like the vertex that it equals, until triangles go all the way round both.
#[test]
fn duplicates_are_named_and_forgotten_with_their_vertex() {
    let mut verifier = StreamVerifier::new();
    for (number, point) in (0..).zip([[0, 0], [4, 0], [4, 4], [0, 4], [2, 1]]) {
        verifier.vertex(number, point).expect("a vertex");
    }
    verifier.duplicate(5, &[2, 1], 4).expect("a duplicate");
    verifier
        .duplicate(6, &[2, 1], 5)
        .expect("one of a duplicate");
    verifier.edge(9, 0, [4, 0]).expect("an edge");
    verifier.edge(8, 6, [4, 4]).expect("an edge of a duplicate");
    let repeated = StreamViolation::RepeatedVertex { vertex: 6 };
    assert_eq!(verifier.vertex(6, [9, 9]), Err(repeated));
    for corners in [[0, 1, 6], [1, 2, 4], [2, 3, 5]] {
        verifier.triangle(corners, None).expect("a triangle");
    }
    assert!([4, 5, 6].iter().all(|&number| verifier.has_vertex(number)));
    verifier
        .triangle([6, 3, 0], None)
        .expect("the last triangle");
    assert!(![4, 5, 6].iter().any(|&number| verifier.has_vertex(number)));
    let unknown = StreamViolation::UnknownVertex { vertex: 5 };
    assert_eq!(verifier.duplicate(7, &[2, 1], 5), Err(unknown));
    let report = verifier.finish().expect("a right result");
    assert_eq!((report.vertices, report.most_vertices), (7, 7));
}

/// Vertices are forgotten as soon as triangles go round them: of a lattice in rows, two rows and the hull are kept, and
/// edges that pass all of it change nothing.
#[test]
fn what_is_kept_is_the_width_of_the_stream() {
    let size = 40_u64;
    let place = |v: u64| [v % size, v / size].map(|x| i64::try_from(x).expect("a small number"));
    for has_edges in [false, true] {
        let mut verifier = StreamVerifier::new();
        let mut most = 0;
        for v in 0..size * size {
            verifier.vertex(v, place(v)).expect("a vertex");
            if has_edges && v < size {
                let upper = place(size * (size - 1) + v);
                verifier.edge(v, v, upper).expect("an upright edge");
            }
            if v > size && v % size > 0 {
                // The left, upper corner of each square is an end of its diagonal.
                let [a, b, c, d] = [v - size - 1, v - size, v, v - 1];
                for corners in [[a, b, d], [b, c, d]] {
                    verifier.triangle(corners, None).expect("a triangle");
                }
            }
            let kept = (0..=v).filter(|&v| verifier.has_vertex(v)).count();
            most = most.max(kept);
        }
        assert!(most <= 5 * 40, "{most}");
        assert!(verifier.finish().is_ok());
    }
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
    Stream::new(Triangulator::new(), ignored).window(1)
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
    let mut stream = Stream::new(Triangulator::new(), |_| ())
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
        let mut stream = Stream::new(Triangulator::new(), |_| ())
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
