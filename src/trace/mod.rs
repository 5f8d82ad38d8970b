//! Step traces: every step of the paper as an [`Event`].

mod event;

pub use event::{Event, Outcome, PartCase, PointCase, Side, Vertex, Why};
