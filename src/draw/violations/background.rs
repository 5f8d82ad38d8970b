//! What every panel of violations shows: all lines of the triangulation that lie in its window.

use std::io::{self, Write};

use crate::draw::plane::places;
use crate::draw::svg;
use crate::draw::window::Window;
use crate::formats::{Graph, Triangles, sorted_pairs};
use crate::scalar::Scalar;

/// More lines of a kind than this are left out of a panel, so that a file stays readable.
const MOST_LINES: usize = 30_000;

/// A triangulation that may be wrong in any way.
pub(super) struct Background {
    pub(super) points: Vec<[f64; 2]>,
    /// Sides of one triangle, sides of more, and edges, each with its class.
    layers: [(&'static str, Vec<[usize; 2]>); 3],
}

impl Background {
    pub(super) fn new<S: Scalar>(graph: &Graph<S>, triangles: &Triangles) -> Background {
        let exists = |ends: &[usize; 2]| ends.iter().all(|&v| v < graph.points.len());
        let corners = triangles.list.iter();
        let sides = corners.flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        let (mut inner, mut boundary) = (Vec::new(), Vec::new());
        for same in sorted_pairs(sides.filter(exists)).chunk_by(|a, b| a == b) {
            let kind = if same.len() == 1 {
                &mut boundary
            } else {
                &mut inner
            };
            kind.push(same[0]);
        }
        let edges = graph.edges.iter().copied().filter(exists).collect();
        Background {
            points: places(&graph.points),
            layers: [("hull", boundary), ("side", inner), ("edge", edges)],
        }
    }

    /// Draws the lines, clipped to the window.
    pub(super) fn draw(&self, window: &Window, out: &mut impl Write) -> io::Result<()> {
        for (class, lines) in &self.layers {
            let visible = |ends: &[usize; 2]| window.clip(ends.map(|v| self.points[v]));
            let shown = lines.iter().filter_map(visible).take(MOST_LINES + 1);
            let shown: Vec<[[f64; 2]; 2]> = shown.collect();
            if shown.len() <= MOST_LINES {
                let place = |ends: [[f64; 2]; 2]| svg::line(&ends.map(|p| window.place(p)));
                svg::layer(out, class, shown.into_iter().map(place))?;
            }
        }
        Ok(())
    }
}
