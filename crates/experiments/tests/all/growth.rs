//! The worst case of each structure: the data that reaches it, and how work, entries moved and steps of the sweep grow
//! there. All are counts, the same in every run.

use sweep_cdt::{Algorithm, Stats, Triangulator, Watch};
use sweep_cdt_experiments::fronts::Structure;
use sweep_cdt_experiments::{Contestant, standard};
use sweep_cdt_generate::Kind;

/// How a count grows with the number of points.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Growth {
    /// Never more than this.
    AtMost(f64),
    /// As log(n) or less.
    Log,
    /// As sqrt(n), but for a logarithm.
    Root,
    Linear,
}

use Growth::{AtMost, Linear, Log, Root};

const NONE: Growth = AtMost(0.0);

/// A structure and the kind of data that is worst for it: how the structure's own work grows, what it moves, and the
/// steps of the sweep, all a search.
const WORST: [(&str, &str, [Growth; 3]); 24] = [
    (
        "hash table (default)",
        "towers",
        [AtMost(34.0), NONE, Linear],
    ),
    ("uniform table, 2 sqrt(n)", "outliers", [Linear, NONE, NONE]),
    ("uniform table, n/10", "outliers", [Linear, NONE, NONE]),
    ("uniform table, n/100", "outliers", [Linear, NONE, NONE]),
    ("hash over ranks", "above-a-row", [AtMost(2.0), NONE, Root]),
    ("hash over ranks", "towers", [Root, NONE, AtMost(1.0)]),
    ("learned table", "above-a-row", [Log, NONE, Root]),
    ("fixed table, 1024", "outliers", [AtMost(2.0), NONE, Linear]),
    ("fixed table, 32", "outliers", [AtMost(2.0), NONE, Linear]),
    (
        "fixed table, 32",
        "above-a-row",
        [AtMost(2.0), NONE, Linear],
    ),
    ("bit set over ranks", "above-a-row", [Log, NONE, NONE]),
    (
        "van Emde Boas tree",
        "above-a-row",
        [AtMost(9.0), NONE, NONE],
    ),
    ("sampled universe", "towers", [AtMost(5.0), Root, NONE]),
    ("skip list", "above-a-row", [Log, AtMost(3.0), NONE]),
    ("treap", "above-a-row", [Log, AtMost(7.0), NONE]),
    ("B-tree", "above-a-row", [Log, NONE, NONE]),
    (
        "splay tree, 10 % sample",
        "above-a-row",
        [Log, Log, AtMost(10.0)],
    ),
    ("sorted array", "leftwards", [Log, Linear, NONE]),
    ("finger", "alternating", [Log, Linear, NONE]),
    ("two fingers", "above-a-row", [Log, Linear, NONE]),
    ("two fingers", "towers", [AtMost(10.0), Linear, NONE]),
    (
        "walk from the last node",
        "alternating",
        [NONE, NONE, Linear],
    ),
    ("walk from the last node", "towers", [NONE, NONE, Linear]),
    ("walk from the end", "alternating", [NONE, NONE, Linear]),
];

/// Numbers of points. With the fewer ones the default looks through a large part of its few intervals, so its steps grow
/// faster than the points at first.
const SIZES: [usize; 2] = [2000, 32_000];

/// The structure's work, what it moves, and the steps of the sweep, a search.
fn counts(contestant: &Contestant, kind: Kind, n: usize) -> [f64; 3] {
    let input = kind.graph(n, 1);
    let (mut front, mut stats) = (contestant.front().clone(), Stats::default());
    let watch = Watch::new().front(&mut front).stats(&mut stats);
    // To its end, however long its walks are.
    let sweep = Triangulator::new().algorithm(Algorithm::Sweep);
    let result = sweep.run(&input.points, &input.edges, watch);
    result.expect("every kind can be triangulated");
    let work = front.work().expect("all count");
    let inside = work.comparisons.max(work.visited);
    let counts = [inside, work.rearranged, stats.counters.front_steps];
    counts.map(|count| count as f64 / input.points.len() as f64)
}

#[test]
fn the_worst_case_of_each_structure_grows_as_said() {
    let structures = standard();
    for contestant in &structures {
        let name = contestant.name();
        // The control does what the default does.
        assert!(
            name == "hash table, counting" || WORST.iter().any(|worst| worst.0 == name),
            "{name}: no worst case"
        );
    }
    for (name, kind, expected) in WORST {
        let contestant = structures
            .iter()
            .find(|contestant| contestant.name() == name);
        let contestant = contestant.expect("a structure of this name");
        let kind = Kind::named(kind).expect("a kind of this name");
        let [few, many] = SIZES.map(|n| counts(contestant, kind, n));
        for (i, what) in ["work", "moved", "steps"].into_iter().enumerate() {
            let exponent = (many[i] / few[i]).log(SIZES[1] as f64 / SIZES[0] as f64);
            let is_expected = match expected[i] {
                AtMost(most) => few[i].max(many[i]) <= most,
                Log => exponent < 0.25,
                Root => (0.25..0.75).contains(&exponent),
                Linear => exponent > 0.8,
            };
            assert!(
                is_expected,
                "{name} on {}: {what} {few:?} {many:?}",
                kind.name
            );
        }
    }
}
