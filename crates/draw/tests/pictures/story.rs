//! Every heading and sentence of the drawn steps, one for each kind of event.

use sweep_cdt::Pslg;
use sweep_cdt::trace::{EdgePosition, Event, Outcome, PointCase, PseudoPolygon, Vertex, Why};
use sweep_cdt_draw::StepsPage;
use sweep_cdt_testing::page::{data_of_page, words_of_steps};

use crate::assert_snapshot;

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
    let (graph, events) = (Pslg::<f64>::default(), events());
    let mut page = Vec::new();
    StepsPage::new(&graph, &events)
        .write(&mut page)
        .expect("memory takes all");
    let page = String::from_utf8(page).expect("text");
    let mut text = String::new();
    for (event, [heading, sentence]) in events.iter().zip(words_of_steps(&data_of_page(&page))) {
        text += &format!("{event}\n  {heading}\n  {sentence}\n");
    }
    assert_snapshot("story", &text);
}
