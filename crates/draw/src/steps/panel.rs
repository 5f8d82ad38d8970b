//! One step as a drawing: from back to front pseudo-polygons, triangles, rays, front, constraints, sweep
//! line, what the step points at, and vertices.

use std::io::{self, Write};

use super::change::Change;
use super::scene::Scene;
use crate::svg;
use crate::svg::Circle;
use crate::window::{Bounds, PIXEL, Window};
use sweep_cdt::trace::{Outcome, Vertex};

/// Up to this many points the whole input is drawn; with more, only the surroundings of the step.
const MOST_POINTS: usize = 300;
/// Vertices get numbers if they are at least this many pixels apart.
const ROOM_FOR_NUMBERS: f64 = 24.0;

/// A part of the plane, and all points and edges.
pub(super) struct Panel<'a> {
    points: &'a [[f64; 2]],
    edges: &'a [[usize; 2]],
    window: Window,
    is_numbered: bool,
}

impl<'a> Panel<'a> {
    /// A panel that shows the last step of `scene`, at most `side` units wide and high.
    pub(super) fn new(
        points: &'a [[f64; 2]],
        edges: &'a [[usize; 2]],
        scene: &Scene,
        side: i64,
    ) -> Panel<'a> {
        let all = Bounds::of(points.iter().copied());
        let spacing = all.spacing(points.len()) * all.unit();
        let focus = scene.step.iter().flat_map(Change::vertices);
        let focus: Vec<[f64; 2]> = focus.filter_map(|v| points.get(v).copied()).collect();
        let part = if points.len() > MOST_POINTS && !focus.is_empty() {
            let focus = Bounds::of(focus);
            focus.squared((2.5 * focus.longer()).max(12.0 * spacing))
        } else {
            all
        };
        let window = Window::new(part.with_margin(0.07), side);
        let is_numbered = window.length(spacing) as f64 > ROOM_FOR_NUMBERS * PIXEL as f64;
        Panel {
            points,
            edges,
            window,
            is_numbered,
        }
    }

    /// Width and height in units of the picture.
    pub(super) fn size(&self) -> [i64; 2] {
        self.window.size
    }

    /// Draws the scene.
    pub(super) fn draw(&self, scene: &Scene, out: &mut impl Write) -> io::Result<()> {
        // Areas.
        for (class, border) in ["upper", "lower"].into_iter().zip(&scene.borders) {
            let shape = if border.len() > 2 {
                svg::polygon
            } else {
                svg::line
            };
            self.shapes(class, shape, [border], out)?;
        }
        self.shapes("pierced", svg::polygon, &scene.pierced, out)?;
        let is_real = |corners: &&[Vertex; 3]| corners.iter().all(|&v| self.place(v).is_some());
        let (real, artificial): (Vec<_>, Vec<_>) = scene.triangles.iter().partition(is_real);
        self.shapes("triangle", svg::polygon, real, out)?;
        let rays = artificial
            .into_iter()
            .flat_map(|corners| self.rays(corners));
        svg::layer(out, "ray", rays)?;
        let added = scene.step.iter().filter_map(|change| match change {
            Change::Add(corners) => Some(corners),
            _ => None,
        });
        self.shapes("added", svg::polygon, added, out)?;

        // Lines.
        svg::layer(out, "front", self.front(scene))?;
        let edges = self.edges.iter().map(|ends| {
            let places = ends.map(|v| self.window.place(self.points[v]));
            svg::line(&places)
        });
        svg::layer(out, "input", edges)?;
        self.shapes("constraint", svg::line, &scene.fixed, out)?;
        if let Some([_, y]) = scene.sweep.and_then(|v| self.place(v)) {
            let right = self.window.size[0];
            svg::layer(out, "sweep", [svg::line(&[[0, y], [right, y]])])?;
        }
        self.shapes("inserted", svg::line, scene.edge, out)?;

        // What the step points at, and vertices.
        let is_swap = scene.step.iter().any(|c| matches!(c, Change::Gone(_)));
        let line = if is_swap { "came" } else { "line" };
        for change in &scene.step {
            self.highlight(change, line, out)?;
        }
        self.vertices(scene, out)
    }

    /// Highlights what a change is about, with lines of the class `line`.
    fn highlight(&self, change: &Change, line: &str, out: &mut impl Write) -> io::Result<()> {
        match change {
            Change::Line(ends) => self.shapes(line, svg::line, [ends], out),
            Change::Gone(ends) => self.shapes("gone", svg::line, [ends], out),
            Change::Test([a, b, p, q], outcome) => {
                let class = match outcome {
                    Outcome::Legal => "legal",
                    Outcome::Illegal => "illegal",
                    Outcome::Fixed => "line",
                };
                self.shapes("quad", svg::polygon, [[*p, *a, *q, *b]], out)?;
                self.shapes(class, svg::line, [[*a, *b]], out)?;
                let corners = [a, b, p, q].map(|&v| self.point(v));
                if let [Some(a), Some(b), Some(p), Some(_)] = corners
                    && *outcome != Outcome::Fixed
                    && let Some(circle) = Circle::through([a, b, p])
                {
                    circle.write(class, &self.window, out)?;
                }
                Ok(())
            }
            Change::Vertex(v) => match self.place(*v) {
                Some(place) => self.circle("ring", place, 8, out),
                None => Ok(()),
            },
            _ => Ok(()),
        }
    }

    /// The sides of an artificial triangle, from its vertices outwards.
    fn rays(&self, corners: &[Vertex; 3]) -> Vec<String> {
        let far = self.window.size[0];
        let ends = [(Vertex::Left, -far), (Vertex::Right, far)].into_iter();
        let ends = ends.filter(|(artificial, _)| corners.contains(artificial));
        ends.flat_map(|(_, far)| {
            let places = corners.iter().filter_map(|&v| self.place(v));
            places.map(move |[x, y]| svg::line(&[[x, y], [x + far, y]]))
        })
        .collect()
    }

    /// The front, with the segments to the artificial points as horizontal rays.
    fn front(&self, scene: &Scene) -> Option<String> {
        let places = scene.front.iter().filter_map(|&v| self.place(v));
        let mut places: Vec<[i64; 2]> = places.collect();
        let ([left, y], [right, to_y]) = (*places.first()?, *places.last()?);
        let far = self.window.size[0];
        places.insert(0, [left - far, y]);
        places.push([right + far, to_y]);
        Some(svg::line(&places))
    }

    fn vertices(&self, scene: &Scene, out: &mut impl Write) -> io::Result<()> {
        let sweep = scene.sweep.and_then(|v| self.point(v));
        for (v, &[x, y]) in self.points.iter().enumerate() {
            if !self.window.shows([x, y]) {
                continue;
            }
            let is_swept = sweep.is_some_and(|sweep| (y, x) <= (sweep[1], sweep[0]));
            let class = if is_swept || scene.is_swept {
                "swept"
            } else {
                "vertex"
            };
            let place = self.window.place([x, y]);
            self.circle(class, place, 3, out)?;
            if self.is_numbered {
                svg::label(out, place, v)?;
            }
        }
        Ok(())
    }

    /// Draws a circle around a place, with its radius in pixels.
    fn circle(
        &self,
        class: &str,
        [x, y]: [i64; 2],
        radius: i64,
        out: &mut impl Write,
    ) -> io::Result<()> {
        let r = radius * PIXEL;
        writeln!(
            out,
            "<circle class=\"{class}\" cx=\"{x}\" cy=\"{y}\" r=\"{r}\"/>"
        )
    }

    /// Draws shapes through vertices, without the artificial ones, that may lie in the window.
    fn shapes<V: AsRef<[Vertex]>>(
        &self,
        class: &str,
        shape: fn(&[[i64; 2]]) -> String,
        lists: impl IntoIterator<Item = V>,
        out: &mut impl Write,
    ) -> io::Result<()> {
        let path = |vertices: V| {
            let vertices = vertices.as_ref().iter();
            let places: Vec<[i64; 2]> = vertices.filter_map(|&v| self.place(v)).collect();
            (places.len() > 1 && self.window.may_show(&places)).then(|| shape(&places))
        };
        svg::layer(out, class, lists.into_iter().filter_map(path))
    }

    fn place(&self, vertex: Vertex) -> Option<[i64; 2]> {
        self.point(vertex).map(|point| self.window.place(point))
    }

    /// Where a vertex is; `None` if it is artificial.
    fn point(&self, vertex: Vertex) -> Option<[f64; 2]> {
        match vertex {
            Vertex::Input(index) => self.points.get(index).copied(),
            Vertex::Left | Vertex::Right => None,
        }
    }
}
