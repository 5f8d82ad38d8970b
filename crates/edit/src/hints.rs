//! A vertex near a place, where a search begins: a grid whose cells remember the last vertex that came there.
//!
//! Why it is right: it is a guess. A vertex that has gone leads a search to begin elsewhere, and one whose number stands
//! for another place leads it a longer way. Cost: 4 bytes for every four vertices; the grid is made anew when there are
//! twice as many. For points spread evenly a walk from there takes a few steps.

use sweep_cdt::scalar::Scalar;

use crate::mesh::NONE;

#[derive(Clone, Debug, Default)]
pub(crate) struct Hints {
    cells: Vec<u32>,
    low: [f64; 2],
    /// Cells for each unit, along x and y.
    scale: [f64; 2],
    /// Cells in a row.
    width: usize,
    /// How many vertices may come before the grid is made anew.
    room: usize,
}

/// Vertices in each cell, if they are spread evenly.
const IN_CELL: usize = 4;

fn near<S: Scalar>(place: &[S; 2]) -> [f64; 2] {
    [place[0].approx(), place[1].approx()]
}

impl Hints {
    /// Whether so many more vertices are too many for the grid.
    pub(crate) fn is_full(&mut self, more: usize) -> bool {
        let is_full = self.room < more;
        self.room -= more.min(self.room);
        is_full
    }

    /// A grid for these vertices.
    pub(crate) fn new<'a, S: Scalar + 'a>(
        vertices: impl Iterator<Item = (u32, &'a [S; 2])> + Clone,
    ) -> Hints {
        let mut bounds = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        let mut count = 0;
        for (_, place) in vertices.clone() {
            for (i, x) in near(place).into_iter().enumerate() {
                bounds[0][i] = bounds[0][i].min(x);
                bounds[1][i] = bounds[1][i].max(x);
            }
            count += 1;
        }
        let width = (count / IN_CELL).isqrt().max(1);
        let [low, high] = bounds;
        let mut hints = Hints {
            cells: vec![NONE; width * width],
            low,
            scale: [0, 1].map(|i| width as f64 / (high[i] - low[i])),
            width,
            room: count.max(16),
        };
        for (v, place) in vertices {
            hints.keep(v, place);
        }
        hints
    }

    /// The cell of a place.
    pub(crate) fn cell<S: Scalar>(&self, place: &[S; 2]) -> usize {
        let near = near(place);
        // A number out of range goes to the nearest cell, and what is no number to the first.
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "it saturates"
        )]
        let at = |i: usize| ((near[i] - self.low[i]) * self.scale[i]) as usize;
        let last = self.width.saturating_sub(1);
        at(0).min(last) + self.width * at(1).min(last)
    }

    /// Remembers a vertex.
    pub(crate) fn keep<S: Scalar>(&mut self, v: u32, place: &[S; 2]) {
        if self.width > 0 {
            let cell = self.cell(place);
            self.cells[cell] = v;
        }
    }

    /// A vertex that came near the place, if there is one.
    pub(crate) fn near<S: Scalar>(&self, place: &[S; 2]) -> Option<u32> {
        let v = (self.width > 0).then(|| self.cells[self.cell(place)])?;
        (v != NONE).then_some(v)
    }
}
