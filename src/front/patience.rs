//! When a structure asks for places instead of x: after long walks of more than a few steps a vertex in all.
//!
//! So all long walks together take O(n) steps before it asks, as many as finding the places costs, and
//! inputs on which the structure finds its way never pay for them.

/// How many steps of long walks are borne, for each vertex: they take about as long as finding the places.
const STEPS: usize = 4;

/// The steps that are still borne.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Patience(usize);

impl Patience {
    /// That with a front of so many vertices in all.
    pub(super) fn with(vertices: usize) -> Patience {
        Patience(STEPS * vertices)
    }

    /// Whether it ends with a walk of so many steps.
    pub(super) fn ends(&mut self, steps: usize) -> bool {
        let is_over = steps > self.0;
        self.0 = self.0.saturating_sub(steps);
        is_over
    }
}
