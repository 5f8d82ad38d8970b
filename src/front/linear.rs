//! No structure at all: the walk starts where the last vertex joined the front. Cost: O(n) for a search at worst; a
//! step or two where each point comes next to the one before.

use super::list::{Front, FrontNode};
use super::search::{FrontInput, FrontSearch};

/// Starts at the node inserted last: O(n).
#[derive(Clone, Copy, Debug, Default)]
pub struct Linear {
    last: Option<FrontNode>,
}

impl FrontSearch for Linear {
    fn begin(&mut self, _: FrontInput<'_>) {
        self.last = None;
    }

    fn locate(&mut self, _: f64, front: &Front) -> FrontNode {
        let live = self.last.filter(|&node| front.contains(node));
        live.unwrap_or(front.left_end())
    }

    fn inserted(&mut self, node: FrontNode, _: f64) {
        self.last = Some(node);
    }
}
