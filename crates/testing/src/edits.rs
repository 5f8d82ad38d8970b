//! Random histories of edits, each step of which is compared with a fresh run.
//!
//! The fresh run is judged elsewhere; it shares no state with the triangulation that was edited.

use std::collections::{BTreeMap, BTreeSet};

use sweep_cdt::scalar::Scalar;
use sweep_cdt::{Error, triangulate};
use sweep_cdt_edit::{DynamicTriangulation, EditError, Edits};
use sweep_cdt_generate::Random;

/// Panics unless the triangulation is, in all that it tells, the one of a fresh run.
pub fn assert_fresh<S: Scalar + Clone>(edited: &DynamicTriangulation<S>, what: &str) {
    let numbers: Vec<usize> = edited.points().collect();
    let place = |&p: &usize| edited.point(p).expect("a point").clone();
    let places: Vec<[S; 2]> = numbers.iter().map(place).collect();
    let index = |p: usize| numbers.binary_search(&p).expect("a point");
    let (edges, ends): (Vec<usize>, Vec<[usize; 2]>) =
        edited.edges().map(|(e, ends)| (e, ends.map(index))).unzip();
    let fresh = triangulate(&places, &ends).unwrap_or_else(|error| panic!("{what}: {error}"));
    let triangles = fresh.canonical_triangles().into_iter();
    let triangles: Vec<_> = triangles.map(|t| t.map(|v| numbers[v])).collect();
    assert_eq!(edited.canonical_triangles(), triangles, "{what}");
    assert_eq!(edited.len(), fresh.len(), "{what}");
    let hull: Vec<usize> = fresh.hull().map(|v| numbers[v]).collect();
    assert_eq!(edited.hull(), hull, "{what}");
    let mut borders = 0;
    let all = (0..).filter_map(|t| Some((t, edited.triangle(t)?)));
    for (t, corners) in all.take(edited.len()) {
        for side in 0..3 {
            let Some(across) = edited.neighbor(t, side) else {
                borders += 1;
                continue;
            };
            let ends = [1, 2].map(|i| corners[(side + i) % 3]);
            let beyond = edited.triangle(across).expect("a triangle");
            let apex = beyond.iter().position(|v| !ends.contains(v));
            let back = apex.and_then(|apex| edited.neighbor(across, apex));
            assert_eq!(back, Some(t), "{what}: side {side} of {corners:?}");
        }
    }
    assert_eq!(borders, hull.len(), "{what}");
    for (i, &e) in edges.iter().enumerate() {
        let chain: Vec<usize> = fresh.edge_chain(i).map(|v| numbers[v]).collect();
        assert_eq!(edited.edge_chain(e), Some(chain), "{what}: edge {e}");
    }
    if !edited.is_empty() {
        let sides = fresh.constrained_sides();
        let mut sides: Vec<_> = sides
            .map(|[a, b]| [a.min(b), a.max(b)].map(|v| numbers[v]))
            .collect();
        sides.sort_unstable();
        assert_eq!(edited.constrained_sides(), sides, "{what}");
    }
    let stars = fresh.vertex_stars();
    for (i, &p) in numbers.iter().enumerate() {
        assert_eq!(
            edited.representative(p),
            Some(numbers[fresh.representative(i)]),
            "{what}"
        );
        let mut around: Vec<usize> = stars.neighbors(i).map(|v| numbers[v]).collect();
        let mut found = edited.neighbors(p);
        around.sort_unstable();
        found.sort_unstable();
        assert_eq!(found, around, "{what}: point {p}");
    }
}

fn lowest_first(mut corners: [usize; 3]) -> [usize; 3] {
    let lowest = (0..3).min_by_key(|&i| corners[i]).expect("three corners");
    corners.rotate_left(lowest);
    corners
}

/// Panics unless the batch was refused for a reason that it gives, and changed nothing.
fn assert_refused<S: Scalar + Clone>(
    before: &DynamicTriangulation<S>,
    after: &DynamicTriangulation<S>,
    edits: &Edits<S>,
    error: EditError,
    what: &str,
) {
    assert_eq!(
        after.canonical_triangles(),
        before.canonical_triangles(),
        "{what}"
    );
    assert_eq!(
        after.constrained_sides(),
        before.constrained_sides(),
        "{what}"
    );
    // The points and edges that the batch asks for.
    let [next, next_edge] = before.next_numbers();
    let stays = before.points().filter(|p| !edits.remove_points.contains(p));
    let place = |p| (p, before.point(p).expect("a point").clone());
    let mut places: BTreeMap<usize, [S; 2]> = stays.map(place).collect();
    places.extend((next..).zip(edits.points.iter().cloned()));
    let stays = before
        .edges()
        .filter(|(e, _)| !edits.remove_edges.contains(e));
    let ends: BTreeMap<usize, [usize; 2]> = stays
        .chain((next_edge..).zip(edits.edges.iter().copied()))
        .collect();
    match error {
        EditError::PointInUse { point, edge } => {
            let is_end = ends[&edge].contains(&point);
            assert!(is_end && edits.remove_points.contains(&point), "{what}");
        }
        EditError::CrossingEdges { edges: [a, b] } => {
            assert!(a < b, "{what}");
            let points: Vec<[S; 2]> = places.values().cloned().collect();
            let numbers: Vec<usize> = places.keys().copied().collect();
            let index = |p: usize| numbers.binary_search(&p).expect("a point");
            let two = [a, b].map(|e| ends[&e].map(index));
            let refused = triangulate(&points, &two);
            assert_eq!(
                refused,
                Err(Error::CrossingEdges { edges: [0, 1] }),
                "{what}"
            );
        }
        other => panic!("{what}: {other}"),
    }
}

/// Makes the first batch of edits, and then so many others of at most so many points and edges each. Compares the
/// triangulation with a fresh run after each. `point` gives new points. Returns how many batches were made, how many
/// were refused, and how many edits were in those that were made.
///
/// # Panics
/// If they differ.
pub fn history<S: Scalar + Clone>(
    random: &mut Random,
    first: Edits<S>,
    [batches, most]: [usize; 2],
    what: &str,
    mut point: impl FnMut(&mut Random) -> [S; 2],
) -> [usize; 3] {
    let mut edited = DynamicTriangulation::new();
    let mut counts = [0; 3];
    let mut first = Some(first);
    for step in 0..=batches {
        let what = format!("{what}, step {step}");
        let edits = first.take();
        let edits = edits.unwrap_or_else(|| batch(random, &edited, most, &mut point));
        let before = edited.clone();
        match edited.apply(edits.clone()) {
            Ok(change) => {
                counts[0] += 1;
                counts[2] += edits.points.len()
                    + edits.edges.len()
                    + edits.remove_points.len()
                    + edits.remove_edges.len();
                assert_eq!(change.points.len(), edits.points.len(), "{what}");
                assert_eq!(change.edges.len(), edits.edges.len(), "{what}");
                // A vertex has another name if its first point went and an equal one stays.
                let is_renamed = |p: usize| {
                    let name = edited.representative(p);
                    name.is_some() && name != before.representative(p)
                };
                if !before.points().any(is_renamed) {
                    let sweeps = edited.last_sweeps().into_iter();
                    let swept: BTreeSet<[usize; 3]> = sweeps
                        .flat_map(|(graph, numbers)| {
                            let run = triangulate(&graph.points, &graph.edges);
                            let run = run.unwrap_or_else(|error| panic!("{what}: {error}"));
                            let named = run.triangles().map(|t| t.map(|v| numbers[v]));
                            named.map(lowest_first).collect::<Vec<_>>()
                        })
                        .collect();
                    let is_swept = |t: &[usize; 3]| swept.contains(t);
                    assert!(change.new.iter().all(is_swept), "{what}");
                    let mut triangles = before.canonical_triangles();
                    triangles.retain(|t| !change.gone.contains(t));
                    triangles.extend(change.new);
                    triangles.sort_unstable();
                    assert_eq!(triangles, edited.canonical_triangles(), "{what}");
                }
            }
            Err(error) => {
                counts[1] += 1;
                assert!(edited.last_sweeps().is_empty(), "{what}");
                assert_refused(&before, &edited, &edits, error, &what);
            }
        }
        assert_fresh(&edited, &what);
    }
    counts
}

/// Batches of more edits have no long edges and remove no ends of edges: nearly all would be refused.
const MANY: usize = 20;

/// A batch of edits, which may be refused.
fn batch<S: Scalar + Clone>(
    random: &mut Random,
    edited: &DynamicTriangulation<S>,
    most: usize,
    point: &mut impl FnMut(&mut Random) -> [S; 2],
) -> Edits<S> {
    let numbers: Vec<usize> = edited.points().collect();
    let edges: Vec<usize> = edited.edges().map(|(e, _)| e).collect();
    let some = |random: &mut Random, list: &[usize]| -> Vec<usize> {
        let count = random.below(most + 1).min(list.len());
        (0..count).map(|_| random.pick(list)).collect()
    };
    let mut edits = Edits::default();
    if !random.one_in(3) {
        edits.points = (0..random.below(most + 1)).map(|_| point(random)).collect();
    }
    if random.one_in(3) {
        edits.remove_edges = some(random, &edges);
    }
    if random.one_in(3) {
        edits.remove_points = some(random, &numbers);
    }
    if most > MANY {
        let stays = edited
            .edges()
            .filter(|(e, _)| !edits.remove_edges.contains(e));
        let used: BTreeSet<usize> = stays.flat_map(|(_, ends)| ends).collect();
        edits.remove_points.retain(|p| !used.contains(p));
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
            .map(|_| {
                let end = random.pick(&ends);
                let mut others = edited.neighbors(end);
                others.retain(|p| !edits.remove_points.contains(p));
                let is_side = most > MANY && !others.is_empty();
                [end, random.pick(if is_side { &others } else { &ends })]
            })
            .collect();
    }
    edits
}
