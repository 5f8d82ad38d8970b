//! A close-up of one violation: what lies around it, and what is wrong in red. That is its triangles, its
//! sides (broken where they should be and are not), the vertices to blame, and the circle that should
//! have been empty. Behind it, and behind the overview, are all lines of the triangulation that lie in the window.

use std::io::{self, Write};

use super::svg::{self, Circle};
use super::window::{Bounds, Window, places};
use sweep_cdt::Pslg;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::verify::Violation;
use sweep_cdt_formats::{GraphFile, Triangles, sorted_pairs};

/// Up to how many vertices in a panel are drawn, and numbered.
const MOST_DOTS: usize = 400;
const MOST_NUMBERS: usize = 60;
/// A violation at a single point is shown with this many of the points nearest to it.
const NEAREST: usize = 4;

/// A close-up.
pub(super) struct CloseUp<'a, S> {
    pub(super) file: &'a GraphFile<S>,
    pub(super) triangles: &'a Triangles,
    pub(super) background: &'a Background,
    pub(super) violation: Violation,
    /// The vertices that the violation names: they exist, and there is at least one.
    pub(super) vertices: &'a [usize],
}

impl<S> CloseUp<'_, S> {
    /// The close-up's window, `size` units wide and high, around the vertices. If these are one point, the window
    /// shows the points nearest to it too.
    pub(super) fn window(&self, size: i64) -> Window {
        let points = &self.background.points;
        let focus = Bounds::of(self.vertices.iter().map(|&v| points[v]));
        let mut side = focus.longer();
        if side <= 0.0 {
            let at = focus.low;
            let distance = |p: &[f64; 2]| (p[0] - at[0]).abs().max((p[1] - at[1]).abs());
            let others = points.iter().map(distance).filter(|&d| d > 0.0);
            let mut distances: Vec<f64> = others.collect();
            distances.sort_by(f64::total_cmp);
            let radius = distances.get(NEAREST.min(distances.len().saturating_sub(1)));
            side = 2.0 * radius.copied().unwrap_or(1.0);
        }
        Window::new(focus.squared(side).with_margin(0.2), size)
    }

    /// Draws it in its window.
    pub(super) fn draw(&self, window: &Window, out: &mut impl Write) -> io::Result<()> {
        self.background.draw(window, out)?;
        let place = |v: usize| window.place(self.background.points[v]);
        let offenders = self.violation.offenders();
        // Which sides are wrong or missing, and which vertices to blame.
        let (mut wrong, mut absent) = (vec![], vec![]);
        let mut culprits = offenders.vertices;
        match self.violation {
            Violation::MissingEdge { edge, .. } | Violation::BentEdge { edge, .. } => {
                absent.push(self.file.graph.edges[edge]);
            }
            Violation::MissingBoundary { side } | Violation::BentBoundary { side, .. } => {
                absent.push(side);
            }
            Violation::RepeatedSide { side, .. }
            | Violation::ExtraBoundary { side, .. }
            | Violation::UndeclaredBoundary { side, .. } => wrong.push(side),
            Violation::ConcaveBoundary {
                vertices: [a, b, c],
                ..
            } => wrong.extend([[a, b], [b, c]]),
            Violation::NotDelaunay { side, opposite, .. } => {
                wrong.push(side);
                culprits = opposite.to_vec();
                if let Some(circle) = self.smaller_circle(side, opposite) {
                    circle.write("circle", window, out)?;
                }
            }
            _ => {}
        }
        // What the violation names may not exist; then it is not drawn.
        let bad = offenders.triangles.into_iter();
        let bad = bad.map(|t| self.triangles.list[t]);
        let bad = bad.filter(|corners| self.exist(corners));
        svg::layer(
            out,
            "bad",
            bad.map(|corners| svg::polygon(&corners.map(place))),
        )?;
        for (class, lines) in [("wrong", wrong), ("absent", absent)] {
            let lines = lines.into_iter().filter(|line| self.exist(line));
            svg::layer(out, class, lines.map(|line| svg::line(&line.map(place))))?;
        }
        self.vertices(window, &culprits, out)
    }

    fn exist(&self, vertices: &[usize]) -> bool {
        let count = self.background.points.len();
        vertices.iter().all(|&v| v < count)
    }

    /// Draws the vertices in the window, if they are few, with their numbers. Those that the violation
    /// names are always drawn.
    fn vertices(
        &self,
        window: &Window,
        culprits: &[usize],
        out: &mut impl Write,
    ) -> io::Result<()> {
        let points = &self.background.points;
        let shown = (0..points.len()).filter(|&v| window.shows(points[v]));
        let shown: Vec<usize> = shown.take(MOST_DOTS + 1).collect();
        let dot = |&v: &usize| svg::dot(window.place(points[v]));
        if shown.len() <= MOST_DOTS {
            svg::layer(out, "vertex", shown.iter().map(dot))?;
        }
        let culprits = culprits.iter().filter(|&&v| self.exist(&[v]));
        svg::layer(out, "culprit", culprits.map(dot))?;
        let numbered = if shown.len() <= MOST_NUMBERS {
            &shown
        } else {
            self.vertices
        };
        for &v in numbered {
            let number = v.saturating_add(self.file.numbering.vertex);
            svg::label(out, window.place(points[v]), number)?;
        }
        Ok(())
    }

    /// A side has two opposite vertices, and there is a circle through the side and each of them. If one
    /// circle contains the other vertex, so does the other circle. The smaller one is easier to see.
    fn smaller_circle(&self, [a, b]: [usize; 2], opposite: [usize; 2]) -> Option<Circle> {
        let points = |c: usize| [a, b, c].map(|v| self.background.points[v]);
        let circles = opposite.into_iter().map(points);
        let circles = circles.filter_map(Circle::through);
        circles.min_by(|p, q| p.radius.total_cmp(&q.radius))
    }
}

/// More lines of a kind than this are left out of a panel, so that a file stays readable.
const MOST_LINES: usize = 30_000;

/// A triangulation that may be wrong in any way.
pub(super) struct Background {
    pub(super) points: Vec<[f64; 2]>,
    /// Sides of one triangle, sides of more, and edges, each with its class.
    layers: [(&'static str, Vec<[usize; 2]>); 3],
}

impl Background {
    pub(super) fn new<S: Scalar>(graph: &Pslg<S>, triangles: &Triangles) -> Background {
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

    /// Edges alone, among these points.
    pub(super) fn of_edges(points: Vec<[f64; 2]>, edges: &[[usize; 2]]) -> Background {
        let layers = [
            ("hull", Vec::new()),
            ("side", Vec::new()),
            ("edge", edges.to_vec()),
        ];
        Background { points, layers }
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
