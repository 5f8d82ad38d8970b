//! Traces as text: one line a step, in the words of [`Event`]. A line is read by its words. Then the event is written
//! again, and the line is refused unless it is the same. So nothing is read that could not have been written.

use std::fmt;

use sweep_cdt::trace::{EdgePosition, Event, Outcome, PointCase, PseudoPolygon, Vertex, Why};

use crate::bad_trace::{BadTrace, VERSION};

const HEADER: &str = "sweep-cdt trace";

fn vertex(word: &str) -> Option<Vertex> {
    match word {
        "P-1" => Some(Vertex::Left),
        "P-2" => Some(Vertex::Right),
        _ => word.parse().ok().map(Vertex::Input),
    }
}

fn vertices<const N: usize>(words: [&str; N]) -> Option<[Vertex; N]> {
    let vertices: Option<Vec<Vertex>> = words.into_iter().map(vertex).collect();
    vertices?.try_into().ok()
}

fn event(line: &str) -> Option<Event> {
    let is_mark = |c: char| c.is_whitespace() || ":,()".contains(c);
    let words: Vec<&str> = line
        .split(is_mark)
        .filter(|word| !word.is_empty())
        .collect();
    Some(match *words {
        ["sorted", v] => Event::Sorted { vertex: vertex(v)? },
        ["point", v, case, "case", "projected", "on", "segment", l, r] => Event::Point {
            vertex: vertex(v)?,
            case: PointCase::of_word(case)?,
            segment: vertices([l, r])?,
        },
        ["triangle", a, b, c, ref why @ ..] => Event::Triangle {
            vertices: vertices([a, b, c])?,
            why: Why::of_word(&why.join(" "))?,
        },
        ["test", a, b, "against", p, q, outcome] => Event::Test {
            side: vertices([a, b])?,
            opposite: vertices([p, q])?,
            outcome: Outcome::of_word(outcome)?,
        },
        ["flip", a, b, "to", p, q] => Event::Flip {
            side: vertices([a, b])?,
            new_side: vertices([p, q])?,
        },
        ["front", "gains", v, "after", left] => Event::FrontInsert {
            vertex: vertex(v)?,
            after: vertex(left)?,
        },
        ["front", "loses", v] => Event::FrontRemove { vertex: vertex(v)? },
        ["edge", edge, "from", upper, "down", "to", lower] => Event::Edge {
            edge: edge.parse().ok()?,
            upper: vertex(upper)?,
            lower: vertex(lower)?,
        },
        ["switch", "to", ref to @ .., "at", l, r] => Event::Switch {
            to_front: matches!(to, ["the", "front"]),
            segment: vertices([l, r])?,
        },
        ["part", from, to, ref position @ ..] => Event::Part {
            from: vertex(from)?,
            to: vertex(to)?,
            position: EdgePosition::of_word(&position.join(" "))?,
        },
        ["pierced", a, b, c] => Event::Pierced {
            vertices: vertices([a, b, c])?,
        },
        ["border", v, polygon, "pseudo-polygon"] => Event::Border {
            polygon: PseudoPolygon::of_word(polygon)?,
            vertex: vertex(v)?,
        },
        ["fixed", a, b] => Event::Fixed {
            side: vertices([a, b])?,
        },
        ["finalization"] => Event::Finalization,
        ["removed", a, b, c] => Event::Removed {
            vertices: vertices([a, b, c])?,
        },
        ["finished", triangles, "triangles"] => Event::Finished {
            triangles: triangles.parse().ok()?,
        },
        _ => return None,
    })
}

fn header(skipped: usize) -> String {
    match skipped {
        0 => format!("{HEADER} {VERSION}"),
        _ => format!("{HEADER} {VERSION} from step {}", skipped + 1),
    }
}

/// Writes a trace whose first `skipped` steps are left out.
pub(super) fn write(skipped: usize, events: &[Event], out: &mut impl fmt::Write) -> fmt::Result {
    writeln!(out, "{}", header(skipped))?;
    events.iter().try_for_each(|event| writeln!(out, "{event}"))
}

/// Reads a trace: how many steps are left out before the first one, and the steps.
pub(super) fn read(text: &str) -> Result<(usize, Vec<Event>), BadTrace> {
    let mut lines = text.lines();
    let first = lines.next().unwrap_or_default();
    let step = first.rsplit(' ').next().and_then(|step| step.parse().ok());
    let starts = [0, step.map_or(0, |step: usize| step.saturating_sub(1))];
    let Some(skipped) = starts.into_iter().find(|&start| header(start) == first) else {
        let message = format!("is not the header `{}`", header(0));
        return Err(BadTrace { line: 1, message });
    };
    let mut events = Vec::new();
    for (number, line) in (2..).zip(lines) {
        match event(line) {
            Some(event) if event.to_string() == line => events.push(event),
            _ => return Err(BadTrace::no_step(number, line)),
        }
    }
    Ok((skipped, events))
}
