//! Each event in words: a heading that names the part of the paper, and a sentence.

use sweep_cdt::trace::{EdgePosition, Event, Outcome, PointCase, PseudoPolygon, Vertex, Why};

/// The part of the algorithm that an event belongs to, with section or figure.
pub(super) fn heading(event: &Event) -> &'static str {
    match event {
        Event::Sorted { .. } => "Initialization · section 3.3",
        Event::Point { case, .. } => match case {
            PointCase::Middle => "Point event, middle case · figure 7",
            PointCase::Left => "Point event, left case · figure 8",
        },
        Event::Triangle { why, .. } => match why {
            Why::First => "Initial triangle · figure 6",
            Why::Point => "Point event, new triangle · section 3.4.1",
            Why::NarrowCorner => "Point event, narrow corner · figure 9",
            Why::Basin => "Point event, basin · figure 10",
            Why::Pocket => "Edge event, pocket under the edge · figure 13",
            Why::PseudoPolygon => "Edge event, triangle of a pseudo-polygon · figure 12",
            Why::Hull => "Finalization, upper hull · figure 15",
        },
        Event::Test { .. } => "Legalization, test · figure 2",
        Event::Flip { .. } => "Legalization, swap · figure 3",
        Event::FrontInsert { .. } | Event::FrontRemove { .. } => "Advancing front · figure 7",
        Event::Edge { .. } => "Edge event · section 3.4.2",
        Event::Switch { .. } => "Edge event, switch of traversal · figure 14",
        Event::Part { position, .. } => match position {
            EdgePosition::Present => "Edge event, edge already present · section 3.4.2",
            EdgePosition::BelowFront => "Edge event, below the front · figure 12",
            EdgePosition::FrontOnly => "Edge event, front only · figure 13",
            EdgePosition::Mixed => "Edge event, mixed · figure 14",
        },
        Event::Pierced { .. } => "Edge event, pierced triangle · figures 11, 12",
        Event::Border { .. } => "Edge event, pseudo-polygon · figure 12",
        Event::Fixed { .. } => "Edge event, constraint · section 3.4.2",
        Event::Finalization | Event::Removed { .. } | Event::Finished { .. } => {
            "Finalization · section 3.5"
        }
    }
}

/// The event as a sentence; vertices and edges by their input indices.
pub(super) fn sentence(event: &Event) -> String {
    match event {
        Event::Sorted { vertex } => format!("Vertex {vertex} is the next one in sweep order."),
        Event::Point {
            vertex,
            case,
            segment: [left, right],
        } => {
            let place = match case {
                PointCase::Middle => "strictly inside",
                PointCase::Left => "on the left end of",
            };
            format!(
                "The sweep line meets vertex {vertex}. Its projection falls {place} the front \
                 segment {left}–{right}."
            )
        }
        Event::Triangle {
            vertices: [a, b, c],
            why,
        } => {
            let why = match why {
                Why::First => "of the first vertex and the two artificial points",
                Why::Point => "between the new vertex and the front",
                Why::NarrowCorner => "in a narrow corner of the front",
                Why::Basin => "in a basin of the front",
                Why::Pocket => "in a pocket of the front below the edge",
                Why::PseudoPolygon => "in a pseudo-polygon",
                Why::Hull => "between the front and the upper hull",
            };
            format!("Triangle {a} {b} {c} is made {why}.")
        }
        Event::Test {
            side: [a, b],
            opposite: [p, q],
            outcome,
        } => {
            let is_real = [a, b, p, q].iter().all(|v| matches!(v, Vertex::Input(_)));
            let circle = match outcome {
                Outcome::Legal | Outcome::Illegal if !is_real => {
                    " No circle is drawn: an artificial point is a direction."
                }
                _ => "",
            };
            let outcome = match outcome {
                Outcome::Legal => "It is legal and stays.",
                Outcome::Illegal => "It is illegal and will be swapped.",
                Outcome::Fixed => "It is a constraint and stays.",
            };
            format!("The side {a}–{b} between vertices {p} and {q} is tested. {outcome}{circle}")
        }
        Event::Flip {
            side: [a, b],
            new_side: [p, q],
        } => format!("The side {a}–{b} is swapped for {p}–{q}."),
        Event::FrontInsert { vertex, after } => {
            format!("Vertex {vertex} joins the advancing front, right of {after}.")
        }
        Event::FrontRemove { vertex } => {
            format!("Vertex {vertex}, now covered by triangles, leaves the advancing front.")
        }
        Event::Edge { edge, upper, lower } => {
            format!("Input edge {edge} is inserted, from vertex {upper} down to {lower}.")
        }
        Event::Switch { to_front, segment } => {
            switch(*to_front, segment.map(|vertex| vertex.to_string()))
        }
        Event::Part { from, to, position } => {
            let position = match position {
                EdgePosition::Present => "is a side already and only needs to be fixed",
                EdgePosition::BelowFront => "lies below the front and pierces triangles",
                EdgePosition::FrontOnly => "lies above the front",
                EdgePosition::Mixed => "pierces triangles and crosses the front",
            };
            format!("The edge from {from} to {to} {position}.")
        }
        Event::Pierced {
            vertices: [a, b, c],
        } => {
            format!("The edge pierces triangle {a} {b} {c}, which is removed.")
        }
        Event::Border { polygon, vertex } => {
            let polygon = match polygon {
                PseudoPolygon::Upper => "upper",
                PseudoPolygon::Lower => "lower",
            };
            format!("Vertex {vertex} is on the border of the {polygon} pseudo-polygon.")
        }
        Event::Fixed { side: [a, b] } => {
            format!("The side {a}–{b} is fixed: it is a constraint and is never swapped.")
        }
        Event::Finalization => {
            "All vertices are swept. The hull remains to be completed.".to_owned()
        }
        Event::Removed {
            vertices: [a, b, c],
        } => {
            format!("The artificial triangle {a} {b} {c} is removed.")
        }
        Event::Finished { triangles } => format!("The triangulation has {triangles} triangles."),
    }
}

fn switch(to_front: bool, [a, b]: [String; 2]) -> String {
    match (to_front, a == b) {
        (true, true) => {
            format!("From vertex {a} the edge runs above the front, which the traversal follows.")
        }
        (true, false) => {
            format!(
                "The edge leaves the triangles across the front segment {a}–{b}. The traversal follows the front."
            )
        }
        (false, _) => format!(
            "The edge enters triangles across the front segment {a}–{b}. The traversal passes through them."
        ),
    }
}
