//! The walk from the left end: no structure at all, and no memory of the last place either.
//!
//! Cost: O(n) for a search on a front of n nodes, all of it steps of the sweep.

use sweep_cdt::front::{Front, FrontNode, FrontSearch};

use super::structure::{Structure, Work};

/// Starts at the left end always.
#[derive(Clone, Copy, Debug, Default)]
pub struct FromEnd;

impl FrontSearch for FromEnd {
    fn locate(&mut self, _: f64, front: &Front) -> FrontNode {
        front.left_end()
    }
}

impl Structure for FromEnd {
    fn work(&self) -> Option<Work> {
        Some(Work::default())
    }
}
