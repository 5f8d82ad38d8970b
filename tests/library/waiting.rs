//! Edges that wait for the hull, in inputs so small that most edges would not wait with the thresholds that ship: the
//! result, and the crossing that is named, are those of the paper's order.

use sweep_cdt::verify::verify;
use sweep_cdt::{Algorithm, Error, Triangulation, Triangulator, Tuning};
use sweep_cdt_testing::Random;

type Points = Vec<[f64; 2]>;

/// Points on a lattice of few places, so that edges overlap and pass through vertices, and edges between them.
fn on_few_places(random: &mut Random, size: usize) -> (Points, Vec<[usize; 2]>) {
    let points = 4 + random.below(if size > 35 { 200 } else { 30 });
    let place = |random: &mut Random| random.below(size) as f64;
    let list = (0..points)
        .map(|_| [place(random), place(random)])
        .collect();
    let edges = 1 + random.below(6);
    let ends = (0..edges).map(|_| [random.below(points), random.below(points)]);
    (list, ends.collect())
}

/// Many edges that cross nothing: then they hang in the pseudo-polygons of each other.
fn without_crossings(random: &mut Random, size: usize) -> (Points, Vec<[usize; 2]>) {
    let (points, _) = on_few_places(random, size);
    let turn = |a: usize, b: usize, c: usize| {
        let [[ax, ay], [bx, by], [cx, cy]] = [a, b, c].map(|v| points[v]);
        // Exact: the coordinates are small whole numbers.
        let turn = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
        if turn > 0.0 {
            1
        } else if turn < 0.0 {
            -1
        } else {
            0
        }
    };
    let cross = |[a, b]: [usize; 2], [c, d]: [usize; 2]| {
        turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0
    };
    let mut edges: Vec<[usize; 2]> = Vec::new();
    for _ in 0..40 {
        let edge = [random.below(points.len()), random.below(points.len())];
        if !edges.iter().any(|&other| cross(edge, other)) {
            edges.push(edge);
        }
    }
    (points, edges)
}

fn assert_same(
    here: &Result<Triangulation, Error>,
    plain: &Result<Triangulation, Error>,
    input: &(Points, Vec<[usize; 2]>),
) {
    match (here, plain) {
        (Ok(here), Ok(plain)) => {
            assert_eq!(
                here.canonical_triangles(),
                plain.canonical_triangles(),
                "{input:?}"
            );
            for edge in 0..input.1.len() {
                assert!(
                    here.edge_chain(edge).eq(plain.edge_chain(edge)),
                    "{edge} of {input:?}"
                );
            }
            let triangles = here.canonical_triangles();
            let report = verify(&input.0, &input.1, &triangles).expect("a triangulation");
            assert!(report.is_canonical(), "{input:?}");
        }
        (Err(here), Err(plain)) => assert_eq!(here, plain, "{input:?}"),
        _ => panic!("{here:?}, where the plain order gives {plain:?}: {input:?}"),
    }
}

#[test]
fn deferred_edges_give_the_result_of_the_plain_order() {
    let random = &mut Random::new(1);
    let (mut valid, mut wrong) = (0, 0);
    for _ in 0..20_000 {
        let size = 3 + random.below(40);
        let input = if random.below(2) == 0 {
            on_few_places(random, size)
        } else {
            without_crossings(random, size)
        };
        let (points, edges) = &input;
        let plain = Triangulator::new().algorithm(Algorithm::Paper);
        let plain = plain.triangulate(points, edges);
        *(if plain.is_ok() {
            &mut valid
        } else {
            &mut wrong
        }) += 1;
        for algorithm in [Algorithm::Auto, Algorithm::DivideAndConquer] {
            let here = Triangulator::new()
                .algorithm(algorithm)
                .tuning(&Tuning::SMALL)
                .triangulate(points, edges);
            assert_same(&here, &plain, &input);
        }
    }
    assert!(
        valid > 3000 && wrong > 3000,
        "{valid} valid and {wrong} wrong"
    );
}
