//! The panels of a picture of violations: all that lies in a window, and what is wrong in red: its
//! triangles, its sides (broken where they should be and are not), the vertices to blame, and the
//! circle that should have been empty.

use std::collections::BTreeMap;
use std::io::{self, Write};

use super::frame::PIXEL;
use super::window::{Window, halves};
use super::{label, layer, widths};
use crate::formats::write::trails::sorted_pairs;
use crate::formats::{Coordinate, Graph, Triangles};
use crate::verify::Violation;

/// How many violations are drawn from near.
pub(super) const MOST_PANELS: usize = 5;
/// More lines of a kind than this are left out of a panel, so that a file stays readable.
const MOST_LINES: usize = 30_000;
/// Up to how many vertices in a panel are drawn, and numbered.
const MOST_DOTS: usize = 400;
const MOST_NUMBERS: usize = 60;

/// What is drawn in every panel.
pub(super) struct Drawing<'a, S> {
    graph: &'a Graph<S>,
    triangles: &'a Triangles,
    /// The points in halves.
    points: Vec<[f64; 2]>,
    /// Sides of two triangles and of one.
    inner: Vec<[usize; 2]>,
    boundary: Vec<[usize; 2]>,
    /// Edges with ends that exist.
    edges: Vec<[usize; 2]>,
}

impl<'a, S: Coordinate> Drawing<'a, S> {
    pub(super) fn new(graph: &'a Graph<S>, triangles: &'a Triangles) -> Drawing<'a, S> {
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
        Drawing {
            graph,
            triangles,
            points: halves(&graph.points),
            inner,
            boundary,
            edges: graph.edges.iter().copied().filter(exists).collect(),
        }
    }

    /// All of it, with a number at each violation that has a panel of its own.
    pub(super) fn overview(
        &self,
        foci: &[(Violation, Vec<usize>)],
        corner: [i64; 2],
        size: i64,
        out: &mut impl Write,
    ) -> io::Result<()> {
        let window = Window::around(&self.points, 0.06, size);
        let spacing = size as f64 / PIXEL as f64 / (self.points.len().max(1) as f64).sqrt();
        writeln!(out, "<style>")?;
        widths(out, ".overview ", spacing)?;
        writeln!(out, "</style>\n<g class=\"overview\">")?;
        self.begin(&window, corner, size, out)?;
        let middle = |vertices: &[usize]| {
            let count = vertices.len() as f64;
            let mean = |axis: usize| vertices.iter().map(|&v| self.points[v][axis] / count).sum();
            window.place([mean(0), mean(1)])
        };
        let places: Vec<[i64; 2]> = foci.iter().map(|(_, vertices)| middle(vertices)).collect();
        layer(out, "culprit", places.iter().copied().map(dot))?;
        let mut names: BTreeMap<[i64; 2], Vec<String>> = BTreeMap::new();
        for (&place, panel) in places.iter().zip(1..=MOST_PANELS) {
            names.entry(place).or_default().push(panel.to_string());
        }
        for (place, panels) in names {
            label(out, place, panels.join(", "))?;
        }
        writeln!(out, "</svg>\n</g>")
    }

    /// The surroundings of one violation.
    pub(super) fn detail(
        &self,
        violation: Violation,
        vertices: &[usize],
        corner: [i64; 2],
        size: i64,
        out: &mut impl Write,
    ) -> io::Result<()> {
        let focus = self.with_neighbors(vertices);
        let window = Window::around(&focus, 0.2, size);
        let place = |v: usize| window.place(self.points[v]);
        self.begin(&window, corner, size, out)?;
        let lines = |class: &'static str, lines: &[[usize; 2]], out: &mut _| {
            let lines = lines.iter().filter(|line| self.exist(&line[..]));
            layer(out, class, lines.map(|line| segment(line.map(place))))
        };
        let (mut wrong, mut absent, mut culprits) =
            (vec![], vec![], violation.offenders().vertices);
        match violation {
            Violation::MissingEdge { edge, .. } => absent.push(self.graph.edges[edge]),
            Violation::MissingBoundary { side } => absent.push(side),
            Violation::RepeatedSide { side, .. }
            | Violation::ExtraBoundary { side, .. }
            | Violation::UndeclaredBoundary { side, .. } => wrong.push(side),
            Violation::ConcaveBoundary {
                vertices: [a, b, c],
            } => wrong.extend([[a, b], [b, c]]),
            Violation::NotDelaunay { side, opposite, .. } => {
                wrong.push(side);
                culprits = opposite.to_vec();
                self.circle(&window, side, opposite, out)?;
            }
            _ => {}
        }
        let bad = violation.offenders().triangles.into_iter();
        let bad = bad.map(|t| self.triangles.list[t]);
        let bad = bad.filter(|corners| self.exist(corners));
        layer(out, "bad", bad.map(|corners| closed(corners.map(place))))?;
        lines("wrong", &wrong, out)?;
        lines("absent", &absent, out)?;
        self.dots(&window, vertices, &culprits, out)?;
        writeln!(out, "</svg>")
    }

    fn exist(&self, vertices: &[usize]) -> bool {
        vertices.iter().all(|&v| v < self.points.len())
    }

    /// Where to look: the vertices, or if they are one point, those nearest to it too.
    fn with_neighbors(&self, vertices: &[usize]) -> Vec<[f64; 2]> {
        const NEAREST: usize = 4;
        let mut focus: Vec<[f64; 2]> = vertices.iter().map(|&v| self.points[v]).collect();
        let at = focus[0];
        let distance = |p: &[f64; 2]| (p[0] - at[0]).abs().max((p[1] - at[1]).abs());
        if focus.iter().all(|point| distance(point) <= 0.0) {
            let others = self.points.iter().map(distance).filter(|&d| d > 0.0);
            let mut distances: Vec<f64> = others.collect();
            distances.sort_by(f64::total_cmp);
            let radius = distances.get(NEAREST.min(distances.len().saturating_sub(1)));
            let radius = radius.copied().unwrap_or(1.0);
            focus.extend([at.map(|x| x - radius), at.map(|x| x + radius)]);
        }
        focus
    }

    /// Begins a panel and draws what lies in it.
    fn begin(
        &self,
        window: &Window,
        [x, y]: [i64; 2],
        size: i64,
        out: &mut impl Write,
    ) -> io::Result<()> {
        writeln!(
            out,
            "<rect class=\"frame\" x=\"{x}\" y=\"{y}\" width=\"{size}\" height=\"{size}\"/>\n\
             <svg x=\"{x}\" y=\"{y}\" width=\"{size}\" height=\"{size}\">"
        )?;
        for (class, lines) in [
            ("hull", &self.boundary),
            ("side", &self.inner),
            ("edge", &self.edges),
        ] {
            let visible = |&[a, b]: &[usize; 2]| window.clip([self.points[a], self.points[b]]);
            let shown: Vec<[[f64; 2]; 2]> = lines
                .iter()
                .filter_map(visible)
                .take(MOST_LINES + 1)
                .collect();
            if shown.len() <= MOST_LINES {
                let strokes = shown
                    .iter()
                    .map(|ends| segment(ends.map(|p| window.place(p))));
                layer(out, class, strokes)?;
            }
        }
        Ok(())
    }

    /// The vertices in a panel, if they are few, with their numbers; those that the violation names always.
    fn dots(
        &self,
        window: &Window,
        named: &[usize],
        culprits: &[usize],
        out: &mut impl Write,
    ) -> io::Result<()> {
        let shown: Vec<usize> = (0..self.points.len())
            .filter(|&v| window.shows(self.points[v]))
            .take(MOST_DOTS + 1)
            .collect();
        let dots = |list: &[usize]| {
            let of = |&v: &usize| dot(window.place(self.points[v]));
            list.iter().map(of).collect::<Vec<_>>().into_iter()
        };
        if shown.len() <= MOST_DOTS {
            layer(out, "vertex", dots(&shown))?;
        }
        let culprits: Vec<usize> = culprits
            .iter()
            .copied()
            .filter(|&v| self.exist(&[v]))
            .collect();
        layer(out, "culprit", dots(&culprits))?;
        let numbered = if shown.len() <= MOST_NUMBERS {
            &shown
        } else {
            named
        };
        for &v in numbered {
            let place = window.place(self.points[v]);
            label(out, place, v + self.graph.first_vertex)?;
        }
        Ok(())
    }

    /// The smaller one of the circles through a side and a vertex opposite to it.
    fn circle(
        &self,
        window: &Window,
        [a, b]: [usize; 2],
        opposite: [usize; 2],
        out: &mut impl Write,
    ) -> io::Result<()> {
        let circles = opposite.map(|c| circumcircle([a, b, c].map(|v| self.points[v])));
        let smaller = circles.into_iter().min_by(|p, q| p.1.total_cmp(&q.1));
        match smaller {
            Some((middle, radius)) if window.length(radius) < 100_000 * PIXEL => {
                let ([x, y], r) = (window.place(middle), window.length(radius));
                writeln!(
                    out,
                    "<circle class=\"circle\" cx=\"{x}\" cy=\"{y}\" r=\"{r}\"/>"
                )
            }
            _ => Ok(()),
        }
    }
}

/// Middle and radius, as well as doubles can.
fn circumcircle([a, b, c]: [[f64; 2]; 3]) -> ([f64; 2], f64) {
    let [[bx, by], [cx, cy]] = [b, c].map(|p| [p[0] - a[0], p[1] - a[1]]);
    // Scaled, so that squares neither overflow nor vanish.
    let unit = bx.abs().max(by.abs()).max(cx.abs()).max(cy.abs());
    let [bx, by, cx, cy] = [bx, by, cx, cy].map(|x| x / unit);
    let twice = 2.0 * (bx * cy - by * cx);
    let (b2, c2) = (bx * bx + by * by, cx * cx + cy * cy);
    let (x, y) = ((cy * b2 - by * c2) / twice, (bx * c2 - cx * b2) / twice);
    ([a[0] + x * unit, a[1] + y * unit], x.hypot(y) * unit)
}

fn dot([x, y]: [i64; 2]) -> String {
    format!("M{x} {y}h0")
}

fn segment([[ax, ay], [bx, by]]: [[i64; 2]; 2]) -> String {
    format!("M{ax} {ay}L{bx} {by}")
}

fn closed([[ax, ay], [bx, by], [cx, cy]]: [[i64; 2]; 3]) -> String {
    format!("M{ax} {ay}L{bx} {by}L{cx} {cy}z")
}
