//! Changes of the picture by an event.

use sweep_cdt::trace::{Event, Outcome, PseudoPolygon, Vertex, Why};

/// The names of changes in the page, and how many numbers follow each.
pub(super) const KINDS: [(&str, usize); 19] = [
    ("sweep", 1),
    ("swept", 0),
    ("end", 0),
    ("add", 3),
    ("remove", 3),
    ("pierce", 3),
    ("join", 2),
    ("leave", 1),
    ("edge", 2),
    ("upper", 1),
    ("lower", 1),
    ("fix", 2),
    ("about", 1),
    ("vertex", 1),
    ("line", 2),
    ("gone", 2),
    ("legal", 4),
    ("illegal", 4),
    ("fixed", 4),
];

/// A change of the picture. The last five only highlight something while their step is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Change {
    /// The sweep line comes to a vertex; the edge event before it is over.
    Sweep(Vertex),
    /// The sweep line has passed all vertices.
    Swept,
    /// The triangulation is complete, and without a front.
    End,
    /// A triangle appears.
    Add([Vertex; 3]),
    /// A triangle disappears.
    Remove([Vertex; 3]),
    /// A triangle disappears, and its place is marked until the edge is fixed.
    Pierce([Vertex; 3]),
    /// A vertex joins the front after another one.
    Join(Vertex, Vertex),
    /// A vertex leaves the front.
    Leave(Vertex),
    /// An edge is being inserted from its upper end to its lower one.
    Edge([Vertex; 2]),
    /// A pseudo-polygon has one more vertex.
    Border(PseudoPolygon, Vertex),
    /// A constraint is there, and the pseudo-polygons are gone.
    Fix([Vertex; 2]),
    /// Look at this edge of the input.
    About(usize),
    /// Look at this vertex.
    Vertex(Vertex),
    /// Look at this line.
    Line([Vertex; 2]),
    /// Look at where this line was.
    Gone([Vertex; 2]),
    /// The side between the first two is tested against the others.
    Test([Vertex; 4], Outcome),
}

impl Change {
    /// The change's name and numbers in the page; P-1 and P-2 are -1 and -2.
    fn code(&self) -> (&'static str, Vec<i64>) {
        let codes = |vertices: &[Vertex]| vertices.iter().copied().map(number).collect();
        match self {
            Change::Sweep(v) => ("sweep", codes(&[*v])),
            Change::Swept => ("swept", Vec::new()),
            Change::End => ("end", Vec::new()),
            Change::Add(corners) => ("add", codes(corners)),
            Change::Remove(corners) => ("remove", codes(corners)),
            Change::Pierce(corners) => ("pierce", codes(corners)),
            Change::Join(v, after) => ("join", codes(&[*v, *after])),
            Change::Leave(v) => ("leave", codes(&[*v])),
            Change::Edge(ends) => ("edge", codes(ends)),
            Change::Border(PseudoPolygon::Upper, v) => ("upper", codes(&[*v])),
            Change::Border(PseudoPolygon::Lower, v) => ("lower", codes(&[*v])),
            Change::Fix(ends) => ("fix", codes(ends)),
            Change::About(edge) => ("about", vec![*edge as i64]),
            Change::Vertex(v) => ("vertex", codes(&[*v])),
            Change::Line(ends) => ("line", codes(ends)),
            Change::Gone(ends) => ("gone", codes(ends)),
            Change::Test(vertices, Outcome::Legal) => ("legal", codes(vertices)),
            Change::Test(vertices, Outcome::Illegal) => ("illegal", codes(vertices)),
            Change::Test(vertices, Outcome::Fixed) => ("fixed", codes(vertices)),
        }
    }

    /// Appends the position of its name in [`KINDS`], and its numbers.
    pub(super) fn encode(&self, numbers: &mut Vec<i64>) {
        let (name, codes) = self.code();
        let kind = (0..).zip(KINDS).find(|(_, (other, _))| *other == name);
        numbers.extend(kind.map(|(kind, _)| kind));
        numbers.extend(codes);
    }

    /// The vertices that the picture must show.
    pub(super) fn vertices(&self) -> Vec<usize> {
        if matches!(self, Change::About(_)) {
            return Vec::new();
        }
        let (_, codes) = self.code();
        let real = |code: &i64| usize::try_from(*code).ok();
        codes.iter().filter_map(real).collect()
    }
}

fn number(vertex: Vertex) -> i64 {
    match vertex {
        Vertex::Input(index) => index as i64,
        Vertex::Left => -1,
        Vertex::Right => -2,
    }
}

/// The changes by an event.
pub(super) fn changes(event: &Event) -> Vec<Change> {
    use Change as C;
    match *event {
        Event::Sorted { vertex } => vec![C::Vertex(vertex)],
        Event::Point {
            vertex, segment, ..
        } => vec![C::Sweep(vertex), C::Vertex(vertex), C::Line(segment)],
        Event::Triangle {
            vertices,
            why: Why::First,
        } => vec![C::Sweep(vertices[0]), C::Add(vertices)],
        Event::Triangle { vertices, .. } => vec![C::Add(vertices)],
        Event::Test {
            side: [a, b],
            opposite: [p, q],
            outcome,
        } => vec![C::Test([a, b, p, q], outcome)],
        Event::Flip {
            side: [a, b],
            new_side: [p, q],
        } => vec![
            C::Remove([p, a, b]),
            C::Remove([q, b, a]),
            C::Add([p, a, q]),
            C::Add([q, b, p]),
            C::Gone([a, b]),
            C::Line([p, q]),
        ],
        Event::FrontInsert { vertex, after } => vec![C::Join(vertex, after), C::Vertex(vertex)],
        Event::FrontRemove { vertex } => vec![C::Leave(vertex), C::Vertex(vertex)],
        Event::Edge { edge, upper, lower } => {
            vec![C::Edge([upper, lower]), C::About(edge), C::Vertex(upper)]
        }
        Event::Switch {
            segment: [a, b], ..
        } if a == b => vec![C::Vertex(a)],
        Event::Switch { segment, .. } => vec![C::Line(segment)],
        Event::Part { from, to, .. } => vec![C::Vertex(from), C::Vertex(to)],
        Event::Pierced { vertices } => vec![C::Pierce(vertices)],
        Event::Border { polygon, vertex } => vec![C::Border(polygon, vertex), C::Vertex(vertex)],
        Event::Fixed { side } => vec![C::Fix(side), C::Line(side)],
        Event::Finalization => vec![C::Swept],
        Event::Removed { vertices } => vec![C::Remove(vertices)],
        Event::Finished { .. } => vec![C::End],
    }
}
