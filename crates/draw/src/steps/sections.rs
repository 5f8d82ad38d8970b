//! The sections of the paper, and which of them each event belongs to.

use serde::Serialize;

use sweep_cdt::trace::{Event, Why};

/// A section of the paper that describes steps of the sweep.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct Section {
    number: &'static str,
    title: &'static str,
    figures: &'static str,
}

const fn section(number: &'static str, title: &'static str, figures: &'static str) -> Section {
    Section {
        number,
        title,
        figures,
    }
}

/// All of them, in the paper's order.
pub(super) const SECTIONS: [Section; 7] = [
    section("2", "Legalization", "figures 2, 3"),
    section("3.3", "Initialization", "figures 5, 6"),
    section("3.4.1", "Point event", "figures 7, 8"),
    section("3.4.1 (i)", "Narrow corners", "figure 9"),
    section("3.4.1 (ii)", "Basins", "figure 10"),
    section("3.4.2", "Edge event", "figures 11–14"),
    section("3.5", "Finalization", "figure 15"),
];

/// The position in [`SECTIONS`] of what describes an event.
pub(super) fn section_of(event: &Event) -> usize {
    match event {
        Event::Test { .. } | Event::Flip { .. } => 0,
        Event::Sorted { .. } => 1,
        Event::Point { .. } | Event::FrontInsert { .. } | Event::FrontRemove { .. } => 2,
        Event::Triangle { why, .. } => match why {
            Why::First => 1,
            Why::Point => 2,
            Why::NarrowCorner => 3,
            Why::Basin => 4,
            Why::Pocket | Why::PseudoPolygon => 5,
            Why::Hull => 6,
        },
        Event::Edge { .. }
        | Event::Switch { .. }
        | Event::Part { .. }
        | Event::Pierced { .. }
        | Event::Border { .. }
        | Event::Fixed { .. } => 5,
        Event::Finalization | Event::Removed { .. } | Event::Finished { .. } => 6,
    }
}
