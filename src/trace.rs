//! Step traces: each step of the sweep as an [`Event`] in the paper's words, made of indices only.
//!
//! With [`Algorithm::Paper`](crate::Algorithm::Paper) an input gives the same events for every scalar that holds it and for
//! every search structure (whose own steps [`crate::Counters`] counts), not for other heuristics. Written, an event is a
//! line to be read beside the paper; the package `sweep-cdt-trace` reads, checks and replays whole traces.
//!
//! ```text
//! sorted 4                                            the sweep order, one vertex a line
//! point 7: middle case, projected on segment 3 5      or `left case`
//! triangle 7 3 5 (point)                              or first, narrow corner, basin, pocket,
//!                                                     pseudo-polygon, upper hull
//! test 3 5 against 7 2: illegal                       or legal, fixed
//! flip 3 5 to 7 2
//! front gains 7 after 3
//! front loses 5
//! edge 0: from 7 down to 1
//! switch to the front at 3 5                          or to triangles
//! part 7 1: mixed                                     or there already, below the front, front only
//! pierced 3 1 5
//! border 3 (upper pseudo-polygon)                     or lower
//! fixed 7 1
//! finalization
//! removed P-1 P-2 4
//! finished: 12 triangles
//! ```

use core::fmt;

/// A vertex as events name it: the input index that stands for it, or an artificial point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Vertex {
    /// The artificial point P-1, far to the left (section 3.3).
    #[cfg_attr(feature = "serde", serde(rename = "P-1"))]
    Left,
    /// The artificial point P-2, far to the right (section 3.3).
    #[cfg_attr(feature = "serde", serde(rename = "P-2"))]
    Right,
    /// A point of the input, by its index; of equal points the lowest.
    #[cfg_attr(feature = "serde", serde(untagged))]
    Input(usize),
}

impl fmt::Display for Vertex {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Vertex::Input(index) => index.fmt(f),
            Vertex::Left => f.write_str("P-1"),
            Vertex::Right => f.write_str("P-2"),
        }
    }
}

/// One step of the sweep.
///
/// Triangles are counter-clockwise. Between events, those made and neither flipped away nor removed are those of the
/// mesh. A `match` must name all kinds of steps.
///
/// ```
/// use sweep_cdt::trace::{Event, PointCase, Vertex};
/// use sweep_cdt::{Triangulator, Watch};
///
/// let mut cases = Vec::new();
/// let points = [[0.0, 0.0], [2.0, 0.0], [0.0, 1.0]];
/// let mut keep = |event| {
///     if let Event::Point { vertex, case, .. } = event {
///         cases.push((vertex, case));
///     }
/// };
/// Triangulator::new().run(&points, &[], Watch::new().events(&mut keep))?;
/// let expected = [(Vertex::Input(1), PointCase::Middle), (Vertex::Input(2), PointCase::Left)];
/// assert_eq!(cases, expected);
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(tag = "event", rename_all = "kebab-case", deny_unknown_fields)
)]
pub enum Event {
    /// The next vertex in sweep order (section 3.3); all of them come first.
    Sorted {
        /// The vertex.
        vertex: Vertex,
    },
    /// A point event (section 3.4.1).
    Point {
        /// The vertex that the sweep line meets.
        vertex: Vertex,
        /// Where the projection of the vertex falls.
        case: PointCase,
        /// The front segment that the projection falls on, left end first.
        segment: [Vertex; 2],
    },
    /// A triangle is made.
    Triangle {
        /// The vertices, counter-clockwise.
        vertices: [Vertex; 3],
        /// The reason.
        why: Why,
    },
    /// The legalization tests a side (figure 2).
    Test {
        /// The ends of the side.
        side: [Vertex; 2],
        /// The vertices opposite in the two triangles.
        opposite: [Vertex; 2],
        /// How the test ends.
        outcome: Outcome,
    },
    /// A side is swapped (figure 3).
    Flip {
        /// The ends of the side that goes.
        side: [Vertex; 2],
        /// The ends of the side that comes.
        new_side: [Vertex; 2],
    },
    /// A vertex joins the advancing front.
    FrontInsert {
        /// The vertex.
        vertex: Vertex,
        /// The front vertex before the new one.
        after: Vertex,
    },
    /// A vertex, now covered by triangles, leaves the advancing front.
    FrontRemove {
        /// The vertex.
        vertex: Vertex,
    },
    /// An edge event (section 3.4.2) begins.
    Edge {
        /// The index of the input edge.
        edge: usize,
        /// The upper end of the edge, or the vertex on it where its rest begins.
        upper: Vertex,
        /// The lower end of the edge.
        lower: Vertex,
    },
    /// The traversal of the edge switches between triangles and front (figure 14).
    Switch {
        /// Whether the traversal follows the front now.
        to_front: bool,
        /// The front segment that the edge crosses, left end first; twice the upper end of a part that begins above it.
        segment: [Vertex; 2],
    },
    /// A part of the edge has been traversed, down to the first vertex on it. When the hull is complete, an edge that
    /// passes through a vertex goes on from there, as an edge event of its own.
    Part {
        /// The upper end of the part.
        from: Vertex,
        /// The lower end of the part: that of the edge, or a vertex found on the edge.
        to: Vertex,
        /// Where the part lies against the advancing front.
        position: EdgePosition,
    },
    /// A triangle that the edge pierces is removed (figure 12).
    Pierced {
        /// The vertices, counter-clockwise.
        vertices: [Vertex; 3],
    },
    /// The next vertex on the border of a pseudo-polygon (figure 12), both ends of the part included.
    Border {
        /// The pseudo-polygon.
        polygon: PseudoPolygon,
        /// The vertex.
        vertex: Vertex,
    },
    /// An edge, or a part of one, becomes a constrained side, which is never flipped.
    Fixed {
        /// The ends of the side, upper one first.
        side: [Vertex; 2],
    },
    /// The sweep has passed all vertices; finalization (section 3.5) begins.
    Finalization,
    /// An artificial triangle is removed (figure 15).
    Removed {
        /// The vertices, counter-clockwise.
        vertices: [Vertex; 3],
    },
    /// The run ends.
    Finished {
        /// How many triangles there are.
        triangles: usize,
    },
}

impl fmt::Display for Event {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Event::Sorted { vertex } => write!(f, "sorted {vertex}"),
            Event::Point {
                vertex,
                case,
                segment: [l, r],
            } => {
                write!(
                    f,
                    "point {vertex}: {case} case, projected on segment {l} {r}"
                )
            }
            Event::Triangle {
                vertices: [a, b, c],
                why,
            } => write!(f, "triangle {a} {b} {c} ({})", why),
            Event::Test {
                side: [a, b],
                opposite: [p, q],
                outcome,
            } => {
                write!(f, "test {a} {b} against {p} {q}: {outcome}")
            }
            Event::Flip {
                side: [a, b],
                new_side: [p, q],
            } => write!(f, "flip {a} {b} to {p} {q}"),
            Event::FrontInsert { vertex, after } => write!(f, "front gains {vertex} after {after}"),
            Event::FrontRemove { vertex } => write!(f, "front loses {vertex}"),
            Event::Edge { edge, upper, lower } => {
                write!(f, "edge {edge}: from {upper} down to {lower}")
            }
            Event::Switch {
                to_front,
                segment: [l, r],
            } => {
                let to = if *to_front { "the front" } else { "triangles" };
                write!(f, "switch to {to} at {l} {r}")
            }
            Event::Part { from, to, position } => {
                write!(f, "part {from} {to}: {}", position)
            }
            Event::Pierced {
                vertices: [a, b, c],
            } => write!(f, "pierced {a} {b} {c}"),
            Event::Border { polygon, vertex } => {
                write!(f, "border {vertex} ({} pseudo-polygon)", polygon)
            }
            Event::Fixed { side: [a, b] } => write!(f, "fixed {a} {b}"),
            Event::Finalization => write!(f, "finalization"),
            Event::Removed {
                vertices: [a, b, c],
            } => write!(f, "removed {a} {b} {c}"),
            Event::Finished { triangles } => write!(f, "finished: {triangles} triangles"),
        }
    }
}

/// Where the projection of a new vertex falls.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum PointCase {
    /// Strictly inside a front segment (figure 7).
    Middle,
    /// On the left end of a front segment (figure 8).
    Left,
}

/// The reason for a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum Why {
    /// The first triangle (figure 6).
    First,
    /// Needed by a point event (figures 7 and 8).
    Point,
    /// A narrow corner of the front beside the new vertex: the pi/2 heuristic (figure 9).
    NarrowCorner,
    /// The basin heuristic (figure 10).
    Basin,
    /// A pocket of the front under an edge (figures 13 and 14).
    Pocket,
    /// A pseudo-polygon (figure 12).
    PseudoPolygon,
    /// The upper hull (figure 15).
    Hull,
}

/// How a legalization test ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum Outcome {
    /// The side is locally Delaunay, and in a tie it is the canonical one.
    Legal,
    /// The side is not legal, and is flipped next.
    Illegal,
    /// The side is constrained, so it stays.
    Fixed,
}

/// The position of a part of an edge against the advancing front (section 3.4.2).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum EdgePosition {
    /// The part is a side of the triangulation already: all steps are bypassed.
    Present,
    /// Below the front: through triangles only (figure 12).
    BelowFront,
    /// Along the front only (figure 13).
    FrontOnly,
    /// Through triangles and along the front (figure 14).
    Mixed,
}

/// One of the two pseudo-polygons of an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum PseudoPolygon {
    /// Above the edge.
    Upper,
    /// Below the edge.
    Lower,
}

/// Gives each variant of an enum its word in the text of a trace.
macro_rules! words {
    ($($type:ident { $($variant:ident $word:literal),* $(,)? })*) => {
        $(
            impl fmt::Display for $type {
                fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                    f.write_str(match self {
                        $($type::$variant => $word),*
                    })
                }
            }

            impl $type {
                #[doc(hidden)]
                pub fn of_word(word: &str) -> Option<$type> {
                    match word {
                        $($word => Some($type::$variant),)*
                        _ => None,
                    }
                }
            }
        )*
    };
}

words! {
    PointCase { Middle "middle", Left "left" }
    Why { First "first", Point "point", NarrowCorner "narrow corner", Basin "basin", Pocket "pocket", PseudoPolygon "pseudo-polygon", Hull "upper hull" }
    Outcome { Legal "legal", Illegal "illegal", Fixed "fixed" }
    EdgePosition { Present "there already", BelowFront "below the front", FrontOnly "front only", Mixed "mixed" }
    PseudoPolygon { Upper "upper", Lower "lower" }
}
