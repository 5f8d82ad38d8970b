//! Counted work: no test passes or fails by the clock.
//!
//! The amount of work for larger inputs is a snapshot: a change must be looked at. The promises about time are
//! kept on every family of inputs that grow.

use sweep_cdt::{Algorithm, Counters, Error, Heuristics, Stats, Triangulation, Triangulator};
use sweep_cdt_testing::families::{self, Family};
use sweep_cdt_testing::oracle::{Answer, check, found};
use sweep_cdt_testing::runs::ALGORITHMS;
use sweep_cdt_testing::{Input, Random, counted, data};

use crate::assert_snapshot;

/// The name of the snapshot.
pub(crate) const NAMES: &[&str] = &["work"];

/// All counters of a run on some input, under its name.
fn counters_of(name: &str, points: &[[f64; 2]], edges: &[[usize; 2]]) -> String {
    let mut text = format!(
        "== {name}\npoints {}\nedges {}\n",
        points.len(),
        edges.len()
    );
    for (setting, heuristics) in [("fast", Heuristics::FAST), ("paper", Heuristics::PAPER)] {
        let triangulator = Triangulator::new().heuristics(heuristics);
        let run = counted(&triangulator, points, edges);
        let stats = run.expect("a valid input").stats;
        text += &format!("\n{setting} heuristics\n");
        // All counters, whatever there will be: `name: number,` in the middle of the debug format.
        for line in format!("{:#?}", stats.counters).lines() {
            if let Some((name, number)) = line.trim().trim_end_matches(',').split_once(": ") {
                // A group of them begins with the name of its type.
                let number = number.trim_end_matches(" {");
                text += &format!("{name} {number}\n");
            }
        }
    }
    text
}

/// Random points, the more of them on the left the higher the power of x.
fn crowded(power: i32) -> Vec<[f64; 2]> {
    let points = Random::new(1).points(5000);
    let crowded = |[x, y]: &[f64; 2]| [x.powi(power) - 0.25, *y];
    points.iter().map(crowded).collect()
}

/// Teeth of the front along a slope, and an edge through all of them.
fn comb() -> Input {
    let tooth = |i: u32| {
        let x = f64::from(i);
        let length = 1.0 + f64::from(i * 7 % 10) / 16.0;
        [
            x,
            if i.is_multiple_of(2) {
                x - length
            } else {
                x + length
            },
        ]
    };
    let mut points: Vec<[f64; 2]> = (1..=2000).map(tooth).collect();
    let edges = vec![[points.len(), points.len() + 1]];
    points.extend([[0.0, 0.0], [2001.0, 2001.0]]);
    Input { points, edges }
}

#[test]
fn the_work_for_larger_inputs() {
    let [contours, comb] = [data::contours(), comb()];
    let lattice: Vec<[f64; 2]> = (0..10_000)
        .map(|i| [i % 100, i / 100].map(f64::from))
        .collect();
    let parts = [
        counters_of("contours", &contours.points, &contours.edges),
        counters_of("uniform", &Random::new(1).points(10_000), &[]),
        // First so little that the hash table keeps intervals of equal width, then so much that it does not.
        counters_of("crowded", &crowded(2), &[]),
        counters_of("crowded more", &crowded(3), &[]),
        counters_of("lattice", &lattice, &[]),
        counters_of("comb", &comb.points, &comb.edges),
    ];
    assert_snapshot(NAMES[0], &parts.join("\n"));
}

/// Families that need more than their share with the sweep alone; the default abandons it there.
const ABANDONED: &[&str] = &[
    "square",
    "rectangle",
    "hexagon",
    "toothed parabola, flat",
    "edge between two toothed parabolas",
    "two linked asterisks",
];

fn run(input: &Input, algorithm: Algorithm) -> (Triangulation, Stats) {
    let triangulator = Triangulator::new().algorithm(algorithm);
    let run = counted(&triangulator, &input.points, &input.edges);
    let run = run.expect("a valid input");
    let survived = run.stats.counters.survived.sum();
    assert_eq!(survived, run.triangulation.len() as u64, "each has a cause");
    (run.triangulation, run.stats)
}

/// The parts of a result that must not depend on the algorithm.
fn answer(input: &Input, result: &Triangulation) -> Answer {
    found(result, input.points.len(), input.edges.len())
}

fn member(family: Family, n: usize) -> Input {
    families::scattered(&(family.member)(n))
}

/// Steps and tests, each of which takes about the same time.
fn work(c: &Counters) -> u64 {
    c.orient2d_filtered
        + c.orient2d_exact()
        + c.in_circle_filtered
        + c.in_circle_exact()
        + c.symbolic
        + c.flips
        + c.front_steps
}

/// What an input asks for: points, triangles that its edges pierce, vertices that they pass.
fn size(input: &Input, result: &Triangulation, counters: &Counters) -> u64 {
    let passed: usize = (0..input.edges.len())
        .map(|e| result.edge_chain(e).len())
        .sum();
    (input.points.len() + passed) as u64 + counters.pierced
}

#[test]
fn small_members_are_right() {
    for family in families::all() {
        println!("{}", family.name);
        let input = member(family, 100);
        let others = ALGORITHMS.iter().map(|&(_, algorithm)| algorithm);
        for algorithm in [Algorithm::Auto].into_iter().chain(others) {
            let (result, _) = run(&input, algorithm);
            check(&input.points, &input.edges, &result);
        }
    }
}

#[test]
fn all_algorithms_agree_on_every_family() {
    for family in families::all() {
        println!("{}", family.name);
        let input = member(family, 3000);
        let by = |algorithm| {
            let (result, stats) = run(&input, algorithm);
            // Points on one line are left to divide and conquer, and by Fortune's sweep line some more.
            let is_divided = match algorithm {
                Algorithm::Sweep => false,
                Algorithm::DivideAndConquer => true,
                _ => result.is_empty(),
            };
            let may_be_divided = is_divided || format!("{algorithm:?}") == "Fortune";
            assert!(stats.is_divided == is_divided || may_be_divided);
            answer(&input, &result)
        };
        let here = by(Algorithm::Sweep);
        for &(name, algorithm) in ALGORITHMS {
            assert_eq!(here, by(algorithm), "{name}");
        }
    }
}

#[test]
fn an_abandoned_sweep_has_the_same_result() {
    for family in families::all() {
        println!("{}", family.name);
        let input = member(family, 5000);
        let (here, stats) = run(&input, Algorithm::Auto);
        let is_known = ABANDONED.contains(&family.name);
        assert!(stats.is_divided || !is_known, "the sweep was not abandoned");
        if stats.is_divided {
            // With edges too: what was left undone when the sweep was abandoned must not remain so.
            let (there, _) = run(&input, Algorithm::DivideAndConquer);
            let [here, there] = [here, there].map(|result| {
                result
                    .with_points(&input.points)
                    .verify(&input.edges)
                    .expect("right");
                answer(&input, &result)
            });
            assert_eq!(here, there);
        }
    }
}

#[test]
fn work_grows_with_the_input() {
    for family in families::all() {
        println!("{}", family.name);
        let [few, many] = [5_000, 40_000].map(|n| {
            let input = member(family, n);
            [Algorithm::Auto, Algorithm::DivideAndConquer].map(|algorithm| {
                let (result, stats) = run(&input, algorithm);
                let work = work(&stats.counters);
                let work = work as f64 / size(&input, &result, &stats.counters) as f64;
                (algorithm, stats.is_divided, work)
            })
        });
        let [_, (.., small_divided)] = few;
        for ((algorithm, is_divided, large), (_, was_divided, small)) in many.into_iter().zip(few) {
            // log n grows by 1.25; an abandoned sweep adds its budget, where there was none before divide
            // and conquer as well.
            let small = if is_divided && !was_divided {
                small.max(small_divided)
            } else {
                small
            };
            assert!(
                large < 2.0 * small + 20.0 && large < 120.0,
                "{algorithm:?}: {small} and {large} a point"
            );
        }
    }
}

#[test]
fn where_flips_are_many_the_papers_heuristics_go_on() {
    let family = families::all().find(|family| family.name == "clusters in clusters");
    let input = member(family.expect("a family"), 20_000);
    let runs = [Algorithm::Sweep, Algorithm::Auto].map(|algorithm| run(&input, algorithm));
    let [(as_set, asked), (changed, auto)] = runs;
    assert!(!auto.is_divided);
    assert_eq!(asked.counters.made.basins, 0);
    assert!(auto.counters.made.basins > 0);
    assert!(4 * auto.counters.flips < 3 * asked.counters.flips);
    assert_eq!(answer(&input, &as_set), answer(&input, &changed));
}

/// Mücke, Saias and Zhu: where points are evenly spread, the walk has about as many steps as triangles are
/// drawn, the cube root of the points. A point is inserted with three flips or fewer, on average over the orders.
#[cfg(feature = "comparison")]
#[test]
fn walks_to_random_points_are_short() {
    for n in [1000, 30_000] {
        let points = Random::new(2).points(n);
        let edges = Vec::new();
        let (_, stats) = run(&Input { points, edges }, Algorithm::Incremental);
        let [steps, flips] =
            [stats.counters.front_steps, stats.counters.flips].map(|count| count as f64 / n as f64);
        assert!(steps < 1.3 * (n as f64).cbrt(), "{steps} steps, {n} points");
        assert!(flips < 3.1, "{flips} flips, {n} points");
    }
}

/// Of what floating point chooses for Fortune's sweep line, exact signs must mend next to nothing.
#[cfg(feature = "comparison")]
#[test]
fn a_beach_line_leaves_few_sides_to_flip() {
    let points = Random::new(3).points(10_000);
    let edges = Vec::new();
    let (_, stats) = run(&Input { points, edges }, Algorithm::Fortune);
    let Counters {
        flips, front_steps, ..
    } = stats.counters;
    assert!(!stats.is_divided);
    assert!(flips < 10, "{flips} flips");
    assert!(front_steps < 100_000, "{front_steps} steps");
}

/// On an arch that opens upwards every point is on the lower hull.
#[cfg(feature = "comparison")]
#[test]
fn the_sweep_of_2005_has_no_artificial_points() {
    let arch = (-500..=500).map(|i: i32| [f64::from(i), f64::from(i * i) + f64::from(i) / 2e3]);
    let (points, edges) = (arch.collect(), Vec::new());
    let input = Input { points, edges };
    let [with, without] = [Algorithm::Sweep, Algorithm::Sweep2005]
        .map(|algorithm| run(&input, algorithm).1.counters.symbolic);
    assert!(with > 1000 && without < 10, "{with} and {without} tests");
}

#[test]
fn equal_edges_share_their_chain() {
    let n = 2000;
    let points: Vec<[f64; 2]> = (0..n).map(|i| [f64::from(i), 0.0]).collect();
    let (first, last) = (0, points.len() - 1);
    let edges = [[first, last], [last, first]].repeat(points.len() / 2);
    let input = Input { points, edges };
    let (result, stats) = run(&input, Algorithm::Auto);
    for e in 0..input.edges.len() {
        let mut chain: Vec<usize> = result.edge_chain(e).collect();
        if e % 2 == 1 {
            chain.reverse();
        }
        assert!(chain.into_iter().eq(0..input.points.len()));
    }
    assert!(stats.memory < 200 * input.points.len(), "{}", stats.memory);
}

#[test]
fn all_algorithms_name_the_same_crossing() {
    let mut crossings = 0;
    for seed in 0..2000 {
        let random = &mut Random::new(seed);
        // Few places, so that edges pass through vertices, and many edges, so that several cross.
        let points: Vec<_> = (0..12)
            .map(|_| [random.below(5) as f64, random.below(5) as f64])
            .collect();
        let edges: Vec<_> = (0..6)
            .map(|_| [random.below(12), random.below(12)])
            .collect();
        let by = |algorithm| {
            let triangulator = Triangulator::new().algorithm(algorithm);
            triangulator.triangulate(&points, &edges).err()
        };
        let here = by(Algorithm::Sweep);
        for &(name, algorithm) in ALGORITHMS {
            assert_eq!(here, by(algorithm), "{name}, seed {seed}");
        }
        crossings += usize::from(matches!(here, Some(Error::CrossingEdges { .. })));
    }
    assert!(crossings > 500, "{crossings} crossings");
}
