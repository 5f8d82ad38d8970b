//! The page: one file that needs nothing else, with the steps in it.
//!
//! The script keeps copies of the picture at every so many steps, so that any step is a jump to one of
//! them and a few changes away.

use std::io::{self, Write};
use std::ops::RangeInclusive;

use super::change::{Change, changes};
use super::frame::Frame;
use super::positions;
use super::scene::Scene;
use super::story::{heading, sentence};
use crate::formats::Graph;
use crate::scalar::Scalar;
use crate::trace::Event;

/// How many steps a page holds at most; it says so if the trace has more.
pub const MOST_STEPS: usize = 20_000;

const HTML: &str = include_str!("page.html");
const CSS: &str = include_str!("page.css");
const SCRIPTS: [&str; 4] = [
    include_str!("scene.js"),
    include_str!("view.js"),
    include_str!("legend.js"),
    include_str!("page.js"),
];

/// Writes the page of some steps of a run, of which `events` are all. The first step has the number 1.
///
/// # Errors
/// Those of `out`.
///
/// ```
/// use sweep_cdt::formats::{Graph, write_page};
///
/// let points = vec![[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]];
/// let graph = Graph { points, edges: vec![[0, 2]], ..Graph::default() };
/// let mut events = Vec::new();
/// sweep_cdt::Triangulator::new()
///     .triangulate_observed(&graph.points, &graph.edges, |event| events.push(event))?;
/// let mut page = Vec::new();
/// write_page(&graph, &events, 1..=usize::MAX, &mut page)?;
/// assert!(page.starts_with(b"<!DOCTYPE html>"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_page<S: Scalar>(
    graph: &Graph<S>,
    events: &[Event],
    steps: RangeInclusive<usize>,
    out: &mut impl Write,
) -> io::Result<()> {
    let mut rest = HTML;
    for (mark, part) in [("{{css}}", CSS), ("{{trace}}", ""), ("{{js}}", "")] {
        let (before, after) = rest.split_once(mark).expect("the page has its marks");
        write!(out, "{before}{part}")?;
        match mark {
            "{{trace}}" => write_trace(graph, events, &steps, out)?,
            "{{js}}" => SCRIPTS
                .iter()
                .try_for_each(|script| writeln!(out, "{script}"))?,
            _ => {}
        }
        rest = after;
    }
    write!(out, "{rest}")
}

/// Writes what the script reads, as JSON; no text in it needs an escape.
fn write_trace<S: Scalar>(
    graph: &Graph<S>,
    events: &[Event],
    steps: &RangeInclusive<usize>,
    out: &mut impl Write,
) -> io::Result<()> {
    let frame = Frame::of(&graph.points);
    let positions = positions(steps, events.len(), MOST_STEPS);
    let mut scene = Scene::new();
    for event in &events[..positions.start] {
        scene.advance(event);
    }
    let events_shown = &events[positions.clone()];

    write!(out, "{{\"first\":{},", positions.start + 1)?;
    write!(out, "\"total\":{},\"size\":{:?},", events.len(), frame.size)?;
    let [points, edges] = [format!("{:?}", frame.places), format!("{:?}", graph.edges)];
    writeln!(out, "\"points\":{points},\"edges\":{edges},")?;
    let mut headings: Vec<&str> = events_shown.iter().map(heading).collect();
    headings.sort_unstable();
    headings.dedup();
    writeln!(out, "\"headings\":{headings:?},")?;
    writeln!(out, "\"base\":[{}],", codes(&scene.changes_since_new()))?;
    writeln!(out, "\"steps\":[")?;
    for (at, event) in events_shown.iter().enumerate() {
        let comma = if at == 0 { "" } else { "," };
        let heading = headings.binary_search(&heading(event)).unwrap_or(0);
        let changes = codes(&changes(event));
        writeln!(out, "{comma}[{heading},\"{}\",{changes}]", sentence(event))?;
    }
    writeln!(out, "]}}")
}

fn codes(changes: &[Change]) -> String {
    let code = |change: &Change| {
        let (name, numbers) = change.code();
        let numbers: String = numbers.iter().map(|number| format!(",{number}")).collect();
        format!("[\"{name}\"{numbers}]")
    };
    changes.iter().map(code).collect::<Vec<_>>().join(",")
}
