//! The sweep order against a sort by exact comparison: by y, then x, then input index.

use num_bigint::BigInt;
use num_rational::BigRational;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::trace::{Event, Vertex};
use sweep_cdt::{Algorithm, Heuristics, Triangulator, Watch};
use sweep_cdt_testing::Random;

/// The distinct points as the sweep comes to them, by index, and the duplicates.
fn swept<S: Scalar>(points: &[[S; 2]]) -> (Vec<usize>, Vec<[usize; 2]>) {
    let mut order = Vec::new();
    let mut note = |event| {
        if let Event::Sorted {
            vertex: Vertex::Input(index),
        } = event
        {
            order.push(index);
        }
    };
    let triangulator = Triangulator::new()
        .algorithm(Algorithm::Sweep)
        .heuristics(Heuristics::PAPER);
    let result = triangulator.run(points, &[], Watch::new().events(&mut note));
    let result = result.expect("a valid input");
    (order, result.duplicates().collect())
}

/// The expected order, by a single sort.
fn expected<S: Scalar>(points: &[[S; 2]]) -> (Vec<usize>, Vec<[usize; 2]>) {
    let compare = |a: usize, b: usize| {
        let by_y = points[a][1].compare(&points[b][1]);
        by_y.then_with(|| points[a][0].compare(&points[b][0]))
    };
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&a, &b| compare(a, b));
    let (mut distinct, mut duplicates) = (Vec::new(), Vec::new());
    for equal in order.chunk_by(|&a, &b| compare(a, b).is_eq()) {
        distinct.push(equal[0]);
        duplicates.extend(equal[1..].iter().map(|&other| [other, equal[0]]));
    }
    duplicates.sort_unstable();
    (distinct, duplicates)
}

#[test]
fn points_are_swept_by_y_then_x() {
    const KINDS: [&str; 9] = [
        "uniform",
        "rows",
        "columns",
        "few places",
        "one row",
        "power law",
        "far away",
        "all sizes",
        "zeros",
    ];
    let mut random = Random::new(26);
    for n in [2, 19, 20, 21, 22, 63, 300, 511, 512, 513, 700, 1500, 4000] {
        for kind in KINDS {
            let points: Vec<[f64; 2]> = (0..n)
                .map(|i| {
                    let mut number = |below| random.below(below) as f64;
                    match kind {
                        "rows" => [number(1000), number(20)],
                        "columns" => [number(3), number(1_000_000)],
                        "few places" => [number(5), number(7)],
                        "one row" => [number(1_000_000), 0.1],
                        "power law" => [number(100), 0.5_f64.powi(i % 80) * number(1000)],
                        "far away" if i % 100 == 7 => [number(9), number(3) * 1e30 - 1e30],
                        "all sizes" => [number(50), (number(1000) - 500.0) * 2_f64.powi(i % 999)],
                        "zeros" => [0.0, 0.0, -0.0, number(1000)]
                            .get(i.cast_unsigned() as usize % 4)
                            .map_or([0.0; 2], |&y| [number(2) - 0.0, y]),
                        _ => [number(1_000_000) / 7.0, number(1_000_000) / 3.0],
                    }
                })
                .collect();
            assert_eq!(swept(&points), expected(&points), "{n} of kind {kind}");
        }
    }
}

/// Numbers that share doubles: their order is exact all the same.
#[test]
fn points_that_share_doubles_are_swept_by_their_numbers() {
    let mut random = Random::new(27);
    let tiny = BigRational::new(BigInt::from(1), BigInt::from(10).pow(40));
    for n in [30, 600, 1300] {
        let points: Vec<[BigRational; 2]> = (0..n)
            .map(|_| {
                let coarse = BigRational::from_integer(BigInt::from(random.below(3)));
                let mut number =
                    |below| BigRational::from_integer(BigInt::from(random.below(below)));
                [number(4) * &tiny, coarse + number(40) * &tiny]
            })
            .collect();
        assert_eq!(swept(&points), expected(&points), "{n}");
    }
}
