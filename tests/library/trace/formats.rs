//! How steps are written, and what is read: parts of a trace, texts that are none, JSON lines; and every heading
//! and sentence of the drawn steps, one for each kind of event.

use sweep_cdt::Heuristics;
use sweep_cdt::draw::StepsPage;
use sweep_cdt::formats::Graph;
use sweep_cdt::trace::{
    EdgePosition, Event, Outcome, PointCase, PseudoPolygon, Trace, Vertex, Why,
};
use sweep_cdt_testing::Input;
use sweep_cdt_testing::page::{data_of_page, words_of_steps};

use super::{lines, steps, text};
use crate::{assert_snapshot, cases};

#[test]
fn a_part_of_a_trace_is_read_but_not_replayed() {
    let (_, input) = cases::all()
        .find(|(_, input)| input.points.len() > 5)
        .expect("a case");
    let whole = steps(&input, Heuristics::FAST).trace;
    let part = Trace {
        skipped: 3,
        events: whole.events[3..6].to_vec(),
    };
    let text = text(&part);
    assert!(
        text.starts_with("sweep-cdt trace 3 from step 4\n"),
        "{text}"
    );
    assert_eq!(Trace::parse(&text).as_ref(), Ok(&part));
    assert_eq!(Trace::parse(&lines(&part)).as_ref(), Ok(&part));
    assert_eq!(
        part.replay().unwrap_err().to_string(),
        "line 1: the trace lacks its first 3 steps"
    );
}

#[test]
fn what_is_no_trace_is_refused() {
    let cases = [
        ("", "line 1: is not the header `sweep-cdt trace 3`"),
        (
            "sweep-cdt trace 1\n",
            "line 1: is not the header `sweep-cdt trace 3`",
        ),
        ("sweep-cdt trace 3\n", "line 2: the trace ends too early"),
        (
            "sweep-cdt trace 3\nsorted  3\n",
            "line 2: is no step: \"sorted  3\"",
        ),
        (
            "sweep-cdt trace 3\nsorted 0\nsorted 0\n",
            "line 3: vertex 0 is sorted twice",
        ),
        (
            "sweep-cdt trace 3\nsorted -1\n",
            "line 2: is no step: \"sorted -1\"",
        ),
        (
            "sweep-cdt trace 3\nfinalization\nfinished: 0 triangles\nsorted 0\n",
            "line 4: the trace is over",
        ),
        ("{}\n", "line 1: is not the header of a trace of version 3"),
        (
            "{\"format\":\"other\",\"version\":3}\n",
            "line 1: is not the header of a trace of version 3",
        ),
        (
            "{\"format\":\"sweep-cdt trace\",\"version\":3,\"from\":0}\n",
            "line 1: is not the header of a trace of version 3",
        ),
        (
            "{\"format\":\"sweep-cdt trace\",\"version\":3}\n{\"event\":\"sorted\",\"vertex\":1,\"x\":0}\n",
            "line 2: is no step: \"{\\\"event\\\":\\\"sorted\\\",\\\"vertex\\\":1,\\\"x\\\":0}\"",
        ),
    ];
    for (text, message) in cases {
        let refused = Trace::parse(text).and_then(|trace| trace.replay());
        assert_eq!(refused.unwrap_err().to_string(), message);
    }
}

#[test]
fn json_lines_are_as_documented() {
    let input = Input::parse("0 0, 2 0, 1 1", "");
    let lines = lines(&steps(&input, Heuristics::FAST).trace);
    let some = [
        r#"{"format":"sweep-cdt trace","version":3}"#,
        r#"{"event":"sorted","vertex":0}"#,
        r#"{"event":"triangle","vertices":[0,"P-1","P-2"],"why":"first"}"#,
        r#"{"event":"front-insert","vertex":0,"after":"P-1"}"#,
        r#"{"event":"point","vertex":1,"case":"middle","segment":[0,"P-2"]}"#,
        r#"{"event":"finalization"}"#,
        r#"{"event":"finished","triangles":1}"#,
    ];
    for line in some {
        assert!(
            lines.lines().any(|other| other == line),
            "{line} in\n{lines}"
        );
    }
}

/// The names of the snapshots.
pub(crate) const NAMES: &[&str] = &["story"];

/// Events of every kind and variety, in the order in which a sweep may report them.
fn events() -> Vec<Event> {
    let v = Vertex::Input;
    let point = |case| Event::Point {
        vertex: v(7),
        case,
        segment: [v(3), v(5)],
    };
    let triangle = |why| Event::Triangle {
        vertices: [v(7), v(3), v(5)],
        why,
    };
    let test = |opposite, outcome| Event::Test {
        side: [v(3), v(5)],
        opposite,
        outcome,
    };
    let switch = |to_front, segment| Event::Switch { to_front, segment };
    let part = |position| Event::Part {
        from: v(7),
        to: v(0),
        position,
    };
    let border = |polygon| Event::Border {
        polygon,
        vertex: v(4),
    };
    let mut events = vec![Event::Sorted { vertex: v(7) }];
    events.extend([PointCase::Middle, PointCase::Left].map(point));
    events.extend([Why::First, Why::Point, Why::NarrowCorner, Why::Basin].map(triangle));
    events.extend([Why::Pocket, Why::PseudoPolygon, Why::Hull].map(triangle));
    for outcome in [Outcome::Legal, Outcome::Illegal, Outcome::Fixed] {
        events.push(test([v(7), v(1)], outcome));
        events.push(test([v(7), Vertex::Left], outcome));
    }
    events.extend([
        Event::Flip {
            side: [v(3), v(5)],
            new_side: [v(7), v(1)],
        },
        Event::FrontInsert {
            vertex: v(7),
            after: Vertex::Left,
        },
        Event::FrontRemove { vertex: v(5) },
        Event::Edge {
            edge: 2,
            upper: v(7),
            lower: v(0),
        },
        switch(true, [v(7), v(7)]),
        switch(true, [v(3), v(5)]),
        switch(false, [v(3), v(5)]),
    ]);
    events.extend([EdgePosition::Present, EdgePosition::BelowFront].map(part));
    events.extend([EdgePosition::FrontOnly, EdgePosition::Mixed].map(part));
    events.push(Event::Pierced {
        vertices: [v(1), v(3), v(5)],
    });
    events.extend([PseudoPolygon::Upper, PseudoPolygon::Lower].map(border));
    events.extend([
        Event::Fixed { side: [v(7), v(0)] },
        Event::Finalization,
        Event::Removed {
            vertices: [Vertex::Left, v(0), Vertex::Right],
        },
        Event::Finished { triangles: 12 },
    ]);
    events
}

#[test]
fn every_sentence() {
    let (graph, events) = (Graph::<f64>::default(), events());
    let mut page = Vec::new();
    StepsPage::new(&graph, &events)
        .write(&mut page)
        .expect("memory takes all");
    let page = String::from_utf8(page).expect("text");
    let mut text = String::new();
    for (event, [heading, sentence]) in events.iter().zip(words_of_steps(&data_of_page(&page))) {
        text += &format!("{event}\n  {heading}\n  {sentence}\n");
    }
    assert_snapshot(NAMES[0], &text);
}
