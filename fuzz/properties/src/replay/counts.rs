//! The counters of a run agree with what its trace tells.
//!
//! The trace knows no counters: what is made, flipped and removed is followed here by the vertices of the triangles.

use std::collections::BTreeMap;

use sweep_cdt::trace::{Event, PointCase, Vertex, Why};
use sweep_cdt::{Algorithm, ByCause, Heuristics, Stats, Triangulation, Triangulator, Watch};
use sweep_cdt_testing::Input;
use sweep_cdt_trace::Trace;

/// Panics unless another run in the paper's order, which reports its progress, has the same result as this one, with the
/// counters of this trace.
pub(super) fn judge_counts(
    Input { points, edges }: &Input,
    heuristics: Heuristics,
    trace: &Trace,
    expected: &Triangulation,
) {
    let mut reports = 0;
    let mut progress = |done, all| {
        assert!(done < all, "{done} of {all}");
        reports += 1;
    };
    let triangulator = Triangulator::new()
        .algorithm(Algorithm::Paper)
        .heuristics(heuristics);
    let mut stats = Stats::default();
    let watch = Watch::new().progress(&mut progress).stats(&mut stats);
    let result = triangulator.run(points, edges, watch).expect("as before");
    let counts = [
        stats.points,
        stats.edges,
        stats.duplicates,
        stats.triangles,
        stats.hull,
    ];
    let there = [
        points.len(),
        edges.len(),
        expected.duplicates().len(),
        expected.len(),
        expected.hull().len(),
    ];
    assert_eq!(counts, there, "the counts (left)");
    assert!(result.triangles().eq(expected.triangles()));
    assert_eq!(
        reports,
        u32::from(!points.is_empty()),
        "reports of progress"
    );

    let traced =
        |is: fn(&Event) -> bool| trace.events.iter().filter(|event| is(event)).count() as u64;
    let done = stats.counters;
    let counts = [
        done.flips,
        done.legalization_tests,
        done.left_cases,
        done.point_events,
        done.made.middle,
        done.made.left,
        done.made.narrow_corners,
        done.made.basins,
        done.made.pockets,
        done.made.pseudo_polygons,
        done.made.hull,
        done.made.flips,
        done.pierced,
        done.edges_present + done.edges_inserted,
    ];
    let made = |asked: Why| {
        let is_asked =
            |event: &&Event| matches!(event, Event::Triangle { why, .. } if *why == asked);
        trace.events.iter().filter(is_asked).count() as u64
    };
    let flips = traced(|event| matches!(event, Event::Flip { .. }));
    let points = traced(|event| matches!(event, Event::Point { .. }));
    let left = traced(|event| {
        let case = PointCase::Left;
        matches!(event, Event::Point { case: found, .. } if *found == case)
    });
    let there = [
        flips,
        traced(|event| matches!(event, Event::Test { .. })),
        left,
        points,
        points,
        left,
        made(Why::NarrowCorner),
        made(Why::Basin),
        made(Why::Pocket),
        made(Why::PseudoPolygon),
        made(Why::Hull),
        2 * flips,
        traced(|event| matches!(event, Event::Pierced { .. })),
        traced(|event| matches!(event, Event::Fixed { .. })),
    ];
    assert_eq!(counts, there, "the counters (left)");
    assert_eq!(
        [done.most_tests, done.most_flips],
        most_of_one(&trace.events),
        "the greatest legalization (left)"
    );
    assert_eq!(
        [done.longest_front, done.front_lengths],
        lengths(&trace.events),
        "the front (left)"
    );
    assert_eq!(done.survived, survivors(&trace.events), "survivors (left)");
    assert_eq!(done.survived.sum(), stats.triangles as u64);
}

/// The most tests, and the most flips, from one triangle to the next.
fn most_of_one(events: &[Event]) -> [u64; 2] {
    let is_triangle = |event: &Event| matches!(event, Event::Triangle { .. });
    let count = |is: fn(&Event) -> bool| {
        let each = events.split(is_triangle);
        let each = each.map(|steps| steps.iter().filter(|step| is(step)).count() as u64);
        each.max().unwrap_or_default()
    };
    [
        count(|event| matches!(event, Event::Test { .. })),
        count(|event| matches!(event, Event::Flip { .. })),
    ]
}

/// The greatest length of the front, and the sum of those before each vertex joins it.
fn lengths(events: &[Event]) -> [u64; 2] {
    let (mut length, mut longest, mut sum) = (0, 0, 0);
    for event in events {
        match event {
            Event::FrontInsert { .. } => {
                sum += length;
                length += 1;
                longest = longest.max(length);
            }
            Event::FrontRemove { .. } => length -= 1,
            _ => {}
        }
    }
    [longest, sum]
}

/// The triangles of the result by what made them.
fn survivors(events: &[Event]) -> ByCause {
    type Field = fn(&mut ByCause) -> &mut u64;
    let sorted = |mut vertices: [Vertex; 3]| {
        vertices.sort_unstable();
        vertices
    };
    let mut made: BTreeMap<[Vertex; 3], Field> = BTreeMap::new();
    let mut is_second = false;
    for event in events {
        match *event {
            Event::Point { .. } => is_second = false,
            Event::Triangle { vertices, why } => {
                let field: Field = match why {
                    Why::First => |all| &mut all.first,
                    Why::Point if is_second => |all| &mut all.left,
                    Why::Point => |all| &mut all.middle,
                    Why::NarrowCorner => |all| &mut all.narrow_corners,
                    Why::Basin => |all| &mut all.basins,
                    Why::Pocket => |all| &mut all.pockets,
                    Why::PseudoPolygon => |all| &mut all.pseudo_polygons,
                    Why::Hull => |all| &mut all.hull,
                };
                is_second = true;
                made.insert(sorted(vertices), field);
            }
            Event::Flip { side, new_side } => {
                let [[a, b], [p, q]] = [side, new_side];
                for apex in new_side {
                    made.remove(&sorted([a, b, apex]));
                }
                for apex in side {
                    made.insert(sorted([p, q, apex]), |all| &mut all.flips);
                }
            }
            Event::Pierced { vertices } | Event::Removed { vertices } => {
                made.remove(&sorted(vertices));
            }
            _ => {}
        }
    }
    let mut survived = ByCause::default();
    for field in made.values() {
        *field(&mut survived) += 1;
    }
    survived
}
