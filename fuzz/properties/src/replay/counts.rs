//! A run that counts agrees with one that is observed.

use std::cell::Cell;

use sweep_cdt::trace::{Event, PointCase, Trace, Why};
use sweep_cdt::{Heuristics, Triangulation, Triangulator};

use sweep_cdt_testing::Input;

/// Panics unless a run that counts and reports its progress has the same result as this one, with the
/// counters of this trace.
pub(super) fn judge(
    Input { points, edges }: &Input,
    heuristics: Heuristics,
    trace: &Trace,
    expected: &Triangulation,
) {
    let reports = Cell::new(0);
    let progress = |done, all| {
        assert!(done < all, "{done} of {all}");
        reports.set(reports.get() + 1);
    };
    let run = Triangulator::new()
        .heuristics(heuristics)
        .progress(&progress)
        .triangulate_with_stats(points, edges)
        .expect("as without counting");
    let (result, stats) = (run.triangulation, run.stats);
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
        reports.get(),
        u32::from(!points.is_empty()),
        "reports of progress"
    );

    let traced =
        |is: fn(&Event) -> bool| trace.events.iter().filter(|event| is(event)).count() as u64;
    let done = stats.counters;
    let counts = [
        done.flips,
        done.left_cases,
        done.narrow_corners,
        done.basin_triangles,
        done.pocket_triangles,
        done.hull_triangles,
        done.pierced,
        done.edges_present + done.edges_inserted,
    ];
    let made = |asked: Why| {
        let is_asked =
            |event: &&Event| matches!(event, Event::Triangle { why, .. } if *why == asked);
        trace.events.iter().filter(is_asked).count() as u64
    };
    let there = [
        traced(|event| matches!(event, Event::Flip { .. })),
        traced(|event| {
            matches!(
                event,
                Event::Point {
                    case: PointCase::Left,
                    ..
                }
            )
        }),
        made(Why::NarrowCorner),
        made(Why::Basin),
        made(Why::Pocket),
        made(Why::Hull),
        traced(|event| matches!(event, Event::Pierced { .. })),
        traced(|event| matches!(event, Event::Fixed { .. })),
    ];
    assert_eq!(counts, there, "the counters (left)");
}
