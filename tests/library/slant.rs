//! Edges in any order: what the edges of slanted families pierce and flip is bounded, whatever the order of the input.

use sweep_cdt::{Algorithm, Triangulator};
use sweep_cdt_testing::families::{self, Family};
use sweep_cdt_testing::{Input, Random};

/// The orders in which an input is given.
const ORDERS: [&str; 3] = ["natural", "reversed", "shuffled"];

fn in_order(input: &Input, order: &str) -> Input {
    let n = input.points.len();
    let mut places: Vec<usize> = (0..n).collect();
    let mut random = Random::new(9);
    match order {
        "natural" => {}
        "reversed" => places.reverse(),
        _ => random.shuffle(&mut places),
    }
    let mut input = input.permuted(&places);
    match order {
        "natural" => {}
        "reversed" => input.edges.reverse(),
        _ => random.shuffle(&mut input.edges),
    }
    input
}

fn member(family: Family, n: usize) -> Input {
    (family.member)(n)
}

/// Flips that the points alone need, beyond those of edges.
fn flips_of_points(input: &Input, triangulator: &Triangulator<'_>) -> u64 {
    let run = triangulator.triangulate_with_stats(&input.points, &[]);
    run.expect("valid points").stats.counters.flips
}

#[test]
fn no_order_of_edges_is_bad() {
    for family in families::slanted() {
        for n in [2000, 16_000] {
            let input = member(family, n);
            let n = input.points.len() as f64;
            for algorithm in [Algorithm::Auto, Algorithm::DivideAndConquer] {
                for order in ORDERS {
                    let input = in_order(&input, order);
                    let triangulator = Triangulator::new().algorithm(algorithm);
                    let run = triangulator.triangulate_with_stats(&input.points, &input.edges);
                    let run = run.unwrap_or_else(|error| panic!("{}: {error}", family.name));
                    let counters = run.stats.counters;
                    let pierced = counters.pierced as f64;
                    let flips = counters.flips as f64;
                    let points = flips_of_points(&input, &triangulator) as f64;
                    println!(
                        "{:40} {n:7} {algorithm:16?} {order:9} {:8.1} a point {:8.1} a pierced {:8.1} a point",
                        family.name,
                        pierced / n,
                        (flips - points).max(0.0) / pierced.max(1.0),
                        points / n
                    );
                    assert!(pierced <= 4.0 * n * n.log2(), "{pierced} pierced");
                    assert!(
                        flips <= points + 8.0 * pierced + 4.0 * n,
                        "{flips} flips, of points alone {points}, pierced {pierced}"
                    );
                }
            }
        }
    }
}
