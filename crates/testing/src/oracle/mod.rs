//! The right result: the canonical constrained Delaunay triangulation by its definition.
//!
//! Nothing here is shared with the crate. The numbers are integers (`numbers`), and each part of the answer
//! is found by trying everything (`graph`: vertices, pieces of edges, crossings; `definition`: triangles,
//! hull, all of it). That is slow and short, and meant for a dozen points. For large results `check` tests
//! side by side what makes a triangulation the canonical one. `naive` judges triangulations of any program,
//! canonical or not; [`refined`] those with vertices that the input lacks, in a part of the plane, and says how deep
//! faults are. `region` has domains, and judges answers that promise less or more than Delaunay triangles.
//! [`arrangement`] has edges that cross, in fractions. `answer` takes the crate's result apart, and
//! tests whether its parts agree with each other.

mod answer;
pub mod arrangement;
mod check;
mod definition;
mod graph;
mod naive;
mod numbers;
pub mod refined;
mod region;

pub use answer::{Answer, boundary, canonical, check_links, found, lowest_first, sorted};
pub use check::{check, check_answer, check_found, firm_sides};
pub use definition::{Verdict, crosses, exact_verdict, verdict};
pub use graph::Graph;
pub use naive::{is_exactly_right, is_right};
pub use numbers::{Coordinate, Integers, Number, Point, common_denominator, integers};
pub use region::{Domain, Region, turns_left, windings};
