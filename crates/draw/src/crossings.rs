//! The picture of edges that cross: an overview with a dot at each crossing, then close-ups of the first ones.
//!
//! A close-up reaches as far as the nearest end of its two edges, which are red. Nothing is triangulated: there is no
//! triangulation of edges that cross.

use std::io::{self, Write};

use super::close_up::Background;
use super::panels::Panels;
use super::style::{LEGEND_HEIGHT, write_legend};
use super::svg;
use super::violations::{draw_overview, overview_window, rules};
use super::window::{Bounds, PIXEL, Window, places};
use sweep_cdt::Pslg;
use sweep_cdt::crossings::{Crossing, Exact};
use sweep_cdt_formats::{Coordinate, Numbering};

/// More dots than this are left out of the overview, so that a file stays readable.
const MOST_DOTS: usize = 30_000;

/// A picture of edges that cross, as SVG: an overview, then close-ups of the first crossings.
///
/// ```
/// use sweep_cdt::Pslg;
/// use sweep_cdt::crossings::crossings;
/// use sweep_cdt_draw::CrossingsPicture;
///
/// let points = vec![[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]];
/// let graph = Pslg { points, edges: vec![[0, 2], [1, 3]], ..Pslg::default() };
/// let found = crossings(&graph.points, &graph.edges)?;
/// let mut picture = Vec::new();
/// CrossingsPicture::new(&graph, &found).close_ups(1).write(&mut picture)?;
/// assert!(picture.starts_with(b"<svg "));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct CrossingsPicture<'a, S> {
    graph: &'a Pslg<S>,
    crossings: &'a [Crossing<S>],
    numbering: Numbering,
    close_ups: usize,
}

impl<'a, S: Exact> CrossingsPicture<'a, S> {
    /// A picture of `crossings`, those of the edges of `graph`.
    #[must_use]
    pub fn new(graph: &'a Pslg<S>, crossings: &'a [Crossing<S>]) -> CrossingsPicture<'a, S> {
        CrossingsPicture {
            graph,
            crossings,
            numbering: Numbering::default(),
            close_ups: 5,
        }
    }

    /// How the file of the graph counts its vertices and edges. By default from 0.
    #[must_use]
    pub fn numbering(self, numbering: Numbering) -> Self {
        CrossingsPicture { numbering, ..self }
    }

    /// How many crossings have a close-up at most. The default is 5.
    #[must_use]
    pub fn close_ups(self, close_ups: usize) -> Self {
        CrossingsPicture { close_ups, ..self }
    }

    /// Writes the picture.
    ///
    /// # Errors
    /// Errors of `out`.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        let CrossingsPicture {
            graph, crossings, ..
        } = *self;
        // The points of the graph, then the crossings that are drawn, all on one scale.
        let near = graph.points.iter().map(|p| p.each_ref().map(S::approx));
        let drawn = crossings.iter().take(MOST_DOTS).map(Crossing::point_f64);
        let all: Vec<[f64; 2]> = near.chain(drawn).collect();
        let background = Background::of_edges(places(&all), &graph.edges);
        let first = graph.points.len();
        let foci: Vec<Vec<usize>> = (first..all.len()).map(|point| vec![point]).collect();

        let close_ups = foci.len().min(self.close_ups);
        let panels = Panels::new(1 + close_ups);
        let [width, height] = panels.size();
        let square = [panels.side; 2];
        let spacing = Bounds::of(background.points.iter().copied()).spacing(first);
        let spacing = spacing * panels.side as f64 / PIXEL as f64;
        svg::begin(out, [width, height + LEGEND_HEIGHT], &rules(spacing))?;
        let title = match crossings.len() {
            0 => "no edges cross".to_owned(),
            1 => "1 crossing".to_owned(),
            count => format!("{count} crossings"),
        };
        let window = overview_window(&background, panels.side);
        panels.write(out, 0, square, "overview", [&title, ""], |out| {
            draw_overview(&background, &window, &foci, close_ups, out)
        })?;
        for (position, crossing) in (1..=close_ups).zip(crossings) {
            let [edge, other] = self.numbering.edges(crossing.edges);
            let title = format!("{position}: edges {edge} and {other} cross");
            let [x, y] = crossing.point_f64().map(|x| x.text());
            let text = format!("near {x}, {y}");
            panels.write(out, position, square, "close-up", [&title, &text], |out| {
                let at = first + position - 1;
                self.draw(&background, crossing, at, panels.side, out)
            })?;
        }
        let entries = [
            ("edge", format!("edges: {}", graph.edges.len())),
            ("vertex", format!("vertices: {first}")),
            ("wrong", format!("crossings: {}", crossings.len())),
        ];
        write_legend(out, [width / 2, height], &entries)?;
        svg::end(out)
    }

    /// Draws a close-up of the crossing at this point of the background.
    fn draw(
        &self,
        background: &Background,
        crossing: &Crossing<S>,
        at: usize,
        size: i64,
        out: &mut impl Write,
    ) -> io::Result<()> {
        let points = &background.points;
        let edges = crossing.edges.map(|edge| self.graph.edges[edge]);
        let distance = |&v: &usize| {
            let off = |i: usize| (points[v][i] - points[at][i]).abs();
            off(0).max(off(1))
        };
        let ends = edges.as_flattened();
        let nearest = ends.iter().map(distance).fold(f64::INFINITY, f64::min);
        let focus = Bounds::of([points[at]]).squared(2.0 * nearest);
        let window = Window::new(focus.with_margin(0.2), size);
        background.draw(&window, out)?;
        let shown = edges
            .iter()
            .filter_map(|ends| window.clip(ends.map(|v| points[v])));
        let lines = shown.map(|ends| svg::line(&ends.map(|p| window.place(p))));
        svg::layer(out, "wrong", lines)?;
        let dot = |&v: &usize| svg::dot(window.place(points[v]));
        let in_sight: Vec<usize> = ends
            .iter()
            .copied()
            .filter(|&v| window.shows(points[v]))
            .collect();
        svg::layer(out, "vertex", in_sight.iter().map(dot))?;
        svg::layer(out, "culprit", [dot(&at)])?;
        for v in in_sight {
            let number = v.saturating_add(self.numbering.vertex);
            svg::label(out, window.place(points[v]), number)?;
        }
        Ok(())
    }
}
