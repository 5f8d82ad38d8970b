//! After every edit of random sequences the triangulation is that of a fresh run, on degenerate inputs.

use std::collections::BTreeMap;

use sweep_cdt::scalar::Scalar;
use sweep_cdt::{Error, Triangulation, triangulate};
use sweep_cdt_edit::{DynamicTriangulation, EditError, Edits};
use sweep_cdt_generate::Random;

/// Points of a kind: few places, so that many are equal, on lines and on circles.
type Kind = (&'static str, fn(&mut Random) -> [i64; 2]);

fn below(random: &mut Random, n: usize) -> i64 {
    random.below(n) as i64
}

const KINDS: [Kind; 8] = [
    ("lattice", |r| [below(r, 6), below(r, 6)]),
    ("wide lattice", |r| [below(r, 40), below(r, 3)]),
    ("one line", |r| [below(r, 12), 0]),
    ("slanted line and a few beside", |r| {
        let i = below(r, 12);
        [2 * i, 3 * i + i64::from(r.below(6) == 0)]
    }),
    ("circle", |r| CIRCLE[r.below(CIRCLE.len())]),
    ("circle and lattice", |r| {
        if r.below(2) == 0 {
            CIRCLE[r.below(12)]
        } else {
            [below(r, 5) - 2, below(r, 5) - 2]
        }
    }),
    ("even", |r| [below(r, 1 << 20), below(r, 1 << 20)]),
    ("two clusters", |r| {
        let far = 1000 * below(r, 2);
        [far + below(r, 5), below(r, 5)]
    }),
];

/// All points at a distance of 25 from the origin that are whole.
const CIRCLE: [[i64; 2]; 20] = [
    [25, 0],
    [24, 7],
    [20, 15],
    [15, 20],
    [7, 24],
    [0, 25],
    [-7, 24],
    [-15, 20],
    [-20, 15],
    [-24, 7],
    [-25, 0],
    [-24, -7],
    [-20, -15],
    [-15, -20],
    [-7, -24],
    [0, -25],
    [7, -24],
    [15, -20],
    [20, -15],
    [24, -7],
];

/// What a fresh run makes of the points and edges that are there.
struct Fresh {
    numbers: Vec<usize>,
    edges: Vec<usize>,
    result: Result<Triangulation, Error>,
}

fn fresh<S: Scalar + Clone>(edited: &DynamicTriangulation<S>) -> Fresh {
    let numbers: Vec<usize> = edited.points().collect();
    let places: Vec<[S; 2]> = numbers
        .iter()
        .map(|&p| edited.point(p).expect("a point").clone())
        .collect();
    let index: BTreeMap<usize, usize> = numbers.iter().enumerate().map(|(i, &p)| (p, i)).collect();
    let (edges, ends): (Vec<usize>, Vec<[usize; 2]>) = edited
        .edges()
        .map(|(e, ends)| (e, ends.map(|p| index[&p])))
        .unzip();
    let result = triangulate(&places, &ends);
    Fresh {
        numbers,
        edges,
        result,
    }
}

fn assert_fresh<S: Scalar + Clone>(edited: &DynamicTriangulation<S>, what: &str) {
    let Fresh {
        numbers,
        edges,
        result,
    } = fresh(edited);
    let result = result.unwrap_or_else(|error| panic!("{what}: {error}"));
    let named = |list: Vec<[usize; 3]>| -> Vec<[usize; 3]> {
        list.into_iter().map(|t| t.map(|v| numbers[v])).collect()
    };
    assert_eq!(
        edited.canonical_triangles(),
        named(result.canonical_triangles()),
        "{what}"
    );
    assert_eq!(edited.len(), result.len(), "{what}");
    let hull: Vec<usize> = result.hull().map(|v| numbers[v]).collect();
    assert_eq!(edited.hull(), hull, "{what}");
    for (i, &e) in edges.iter().enumerate() {
        let chain: Vec<usize> = result.edge_chain(i).map(|v| numbers[v]).collect();
        assert_eq!(edited.edge_chain(e), Some(chain), "{what}: edge {e}");
    }
    let sides = result
        .constrained_sides()
        .map(|[a, b]| [numbers[a.min(b)], numbers[a.max(b)]]);
    let mut sides: Vec<[usize; 2]> = sides.collect();
    sides.sort_unstable();
    if !edited.is_empty() {
        assert_eq!(edited.constrained_sides(), sides, "{what}");
    }
    for (i, &p) in numbers.iter().enumerate() {
        assert_eq!(
            edited.representative(p),
            Some(numbers[result.representative(i)]),
            "{what}"
        );
    }
}

/// A batch of edits: at most so many of each, which may be refused.
fn batch(
    random: &mut Random,
    edited: &DynamicTriangulation<i64>,
    kind: &Kind,
    most: usize,
) -> Edits<i64> {
    let numbers: Vec<usize> = edited.points().collect();
    let edges: Vec<usize> = edited.edges().map(|(e, _)| e).collect();
    let some = |random: &mut Random, list: &[usize]| -> Vec<usize> {
        let count = random.below(most + 1).min(list.len());
        (0..count).map(|_| random.pick(list)).collect()
    };
    let mut edits = Edits::default();
    if random.below(3) != 0 {
        edits.points = (0..random.below(most + 1))
            .map(|_| kind.1(random))
            .collect();
    }
    if random.one_in(3) {
        edits.remove_edges = some(random, &edges);
    }
    if random.one_in(3) {
        edits.remove_points = some(random, &numbers);
    }
    let [next, _] = edited.next_numbers();
    let mut ends = numbers;
    ends.extend(next..next + edits.points.len());
    if !random.one_in(8) {
        ends.retain(|p| !edits.remove_points.contains(p));
    }
    if random.one_in(2) && !ends.is_empty() {
        let count = random.below(most + 1);
        edits.edges = (0..count)
            .map(|_| [random.pick(&ends), random.pick(&ends)])
            .collect();
    }
    edits
}

/// A batch is refused for a reason that it gives.
fn assert_refused(
    before: &DynamicTriangulation<i64>,
    edits: &Edits<i64>,
    error: EditError,
    what: &str,
) {
    // The points and edges that the batch asks for.
    let [next, next_edge] = before.next_numbers();
    let stays = before.points().filter(|p| !edits.remove_points.contains(p));
    let mut places: BTreeMap<usize, [i64; 2]> = stays
        .map(|p| (p, *before.point(p).expect("a point")))
        .collect();
    places.extend((next..).zip(edits.points.iter().copied()));
    let stays = before
        .edges()
        .filter(|(e, _)| !edits.remove_edges.contains(e));
    let ends: BTreeMap<usize, [usize; 2]> = stays
        .chain((next_edge..).zip(edits.edges.iter().copied()))
        .collect();
    match error {
        EditError::PointInUse { point, edge } => {
            assert!(
                edits.remove_points.contains(&point) && ends[&edge].contains(&point),
                "{what}"
            );
        }
        EditError::CrossingEdges { edges: [a, b] } => {
            assert!(a < b, "{what}");
            let four = [ends[&a], ends[&b]].concat();
            let points: Vec<[i64; 2]> = places.values().copied().collect();
            let index: Vec<usize> = places.keys().copied().collect();
            let four: Vec<usize> = four
                .iter()
                .map(|p| index.binary_search(p).expect("a point"))
                .collect();
            let two = [[four[0], four[1]], [four[2], four[3]]];
            let refused = Err(Error::CrossingEdges { edges: [0, 1] });
            assert_eq!(triangulate(&points, &two), refused, "{what}");
        }
        other => panic!("{what}: {other}"),
    }
}

#[test]
fn every_history_ends_in_the_fresh_result() {
    let rounds: usize =
        std::env::var("SWEEP_CDT_EDITS").map_or(60, |text| text.parse().expect("a number"));
    for kind in KINDS {
        let (mut made, mut refused) = (0, 0);
        for round in 0..rounds {
            let mut random = Random::new(round as u64);
            let mut edited = DynamicTriangulation::new();
            let most = [1, 3, 10][round % 3];
            for step in 0..30 {
                let what = format!("{}, round {round}, step {step}", kind.0);
                let edits = batch(&mut random, &edited, &kind, most);
                let before = edited.clone();
                match edited.apply(edits.clone()) {
                    Ok(change) => {
                        made += 1;
                        assert_eq!(change.points.len(), edits.points.len());
                        assert_eq!(change.edges.len(), edits.edges.len());
                    }
                    Err(error) => {
                        refused += 1;
                        assert_refused(&before, &edits, error, &what);
                        assert_eq!(
                            edited.canonical_triangles(),
                            before.canonical_triangles(),
                            "{what}"
                        );
                        assert_eq!(
                            edited.constrained_sides(),
                            before.constrained_sides(),
                            "{what}"
                        );
                    }
                }
                assert_fresh(&edited, &what);
            }
        }
        assert!(
            made > 10 * rounds,
            "{}: {made} made, {refused} refused",
            kind.0
        );
    }
}
