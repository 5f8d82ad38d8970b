//! Edges in any order: what the edges of slanted families pierce and flip is bounded, whatever the order of the input;
//! the result, and the crossing that is named, are those of the paper's order.

use sweep_cdt::{Algorithm, Bands, Error, Triangulator};
use sweep_cdt_testing::families::{self, Order};
use sweep_cdt_testing::oracle::check;
use sweep_cdt_testing::{Input, Random, counted};

/// Flips that the points alone need, beyond those of edges.
fn flips_of_points(input: &Input, triangulator: &Triangulator) -> u64 {
    let run = counted(triangulator, &input.points, &[]);
    run.expect("valid points").stats.counters.flips
}

#[test]
#[ignore = "12 seconds: `.ci/nightly` runs it"]
fn no_order_of_edges_is_bad() {
    for family in families::slanted() {
        println!("{}", family.name);
        for n in [2000, 16_000] {
            let input = (family.member)(n);
            let n = input.points.len() as f64;
            for algorithm in [Algorithm::Auto, Algorithm::DivideAndConquer] {
                for order in Order::ALL {
                    let input = order.of(&input);
                    let triangulator = Triangulator::new().algorithm(algorithm);
                    let run = counted(&triangulator, &input.points, &input.edges);
                    let counters = run.expect("edges that do not cross").stats.counters;
                    let pierced = counters.pierced as f64;
                    let flips = counters.flips as f64;
                    let points = flips_of_points(&input, &triangulator) as f64;
                    assert!(
                        pierced <= 4.0 * n * n.log2(),
                        "{algorithm:?}, {order:?}: {pierced} pierced"
                    );
                    assert!(
                        flips <= points + 8.0 * pierced + 4.0 * n,
                        "{algorithm:?}, {order:?}: {flips} flips, {points} of points alone, pierced {pierced}"
                    );
                }
            }
        }
    }
}

#[test]
fn small_members_are_right() {
    for family in families::slanted() {
        println!("{}", family.name);
        let input = Order::Shuffled.of(&(family.member)(100));
        for algorithm in [Algorithm::Auto, Algorithm::DivideAndConquer] {
            let triangulator = Triangulator::new().algorithm(algorithm);
            let result = triangulator.triangulate(&input.points, &input.edges);
            check(
                &input.points,
                &input.edges,
                &result.expect("edges that do not cross"),
            );
        }
    }
}

#[test]
fn deferred_edges_give_the_result_of_the_papers_order() {
    for family in families::slanted() {
        println!("{}", family.name);
        for order in Order::ALL {
            let Input { points, edges } = order.of(&(family.member)(1000));
            let plain = Triangulator::new().algorithm(Algorithm::Paper);
            let plain = plain.triangulate(&points, &edges);
            let plain = plain.expect("edges that do not cross");
            let triangulator = Triangulator::new();
            let results = [
                triangulator.triangulate(&points, &edges),
                triangulator
                    .algorithm(Algorithm::DivideAndConquer)
                    .triangulate(&points, &edges),
                triangulator.triangulate_parallel(&points, &edges, Bands::new().count(2)),
            ];
            for result in results {
                let result = result.expect("edges that do not cross");
                assert!(
                    result.canonical_triangles() == plain.canonical_triangles(),
                    "{order:?}"
                );
            }
        }
    }
}

#[test]
fn the_crossing_of_the_papers_order_is_named() {
    let mut crossings = 0;
    for family in families::slanted() {
        println!("{}", family.name);
        for seed in 0..4 {
            let Input { points, mut edges } = Order::Shuffled.of(&(family.member)(1000));
            let random = &mut Random::new(seed);
            for _ in 0..=seed {
                let at = random.below(edges.len() + 1);
                edges.insert(at, [random.below(points.len()), random.below(points.len())]);
            }
            let plain = Triangulator::new().algorithm(Algorithm::Paper);
            let plain = plain.triangulate(&points, &edges).err();
            for algorithm in [Algorithm::Auto, Algorithm::DivideAndConquer] {
                let here = Triangulator::new()
                    .algorithm(algorithm)
                    .triangulate(&points, &edges);
                assert_eq!(here.err(), plain, "{algorithm:?}, seed {seed}");
            }
            crossings += usize::from(matches!(plain, Some(Error::CrossingEdges { .. })));
        }
    }
    assert!(crossings > 100, "{crossings} crossings");
}
