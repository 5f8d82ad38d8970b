//! One step as a picture: from back to front pseudo-polygons, triangles, rays, constraints, front,
//! sweep line, what the step points at, and vertices.

use std::fmt::Write as _;

use super::change::Change;
use super::frame::{Frame, circle};
use super::scene::Scene;
use crate::trace::{Outcome, Vertex};

/// Up to how many points the whole is drawn; of more only the surroundings of the step.
const MOST_POINTS: usize = 300;
/// Vertices get numbers where they are so far apart, in pixels.
const ROOM_FOR_NUMBERS: f64 = 24.0;

/// A part of the plane and its place in the picture.
pub(super) struct Panel<'a> {
    frame: &'a Frame,
    edges: &'a [[usize; 2]],
    /// What is drawn: the lower left corner, and width and height.
    low: [f64; 2],
    extent: [f64; 2],
    /// Pixels for a unit.
    scale: f64,
}

impl<'a> Panel<'a> {
    /// A panel that shows the step of `scene`, at most `size` pixels wide and high.
    pub(super) fn new(
        frame: &'a Frame,
        edges: &'a [[usize; 2]],
        scene: &Scene,
        size: f64,
    ) -> Panel<'a> {
        let (mut low, mut extent) = ([0.0, 0.0], frame.size);
        let focus = scene.step.iter().flat_map(Change::vertices);
        let focus: Vec<[f64; 2]> = focus.filter_map(|v| frame.places.get(v).copied()).collect();
        if frame.places.len() > MOST_POINTS && !focus.is_empty() {
            let range = |axis: usize| {
                let values = focus.iter().map(|place| place[axis]);
                let low = values.clone().fold(f64::INFINITY, f64::min);
                (low, values.fold(f64::NEG_INFINITY, f64::max))
            };
            let [x, y] = [range(0), range(1)];
            let side = (2.5 * (x.1 - x.0).max(y.1 - y.0)).max(12.0 * frame.spacing());
            low = [x, y].map(|(low, high)| (low + high - side) / 2.0);
            extent = [side, side];
        }
        let margin = 0.07 * extent[0].max(extent[1]).max(0.01);
        let extent = extent.map(|length| length + 2.0 * margin);
        Panel {
            frame,
            edges,
            low: low.map(|at| at - margin),
            extent,
            scale: size / extent[0].max(extent[1]),
        }
    }

    /// Width and height in pixels.
    pub(super) fn size(&self) -> [f64; 2] {
        self.extent.map(|length| length * self.scale)
    }

    /// Draws the scene.
    pub(super) fn draw(&self, scene: &Scene) -> String {
        let [width, height] = self.size();
        let mut out = String::new();
        for (class, border) in ["upper", "lower"].into_iter().zip(&scene.borders) {
            self.path(&mut out, class, border, border.len() > 2);
        }
        for corners in &scene.pierced {
            self.path(&mut out, "pierced", corners, true);
        }
        let real = |corners: &&[Vertex; 3]| corners.iter().all(|&v| self.place(v).is_some());
        for corners in scene.triangles.iter().filter(real) {
            self.path(&mut out, "triangle", corners, true);
        }
        for corners in scene.triangles.iter().filter(|corners| !real(corners)) {
            self.rays(&mut out, corners);
        }
        for &change in &scene.step {
            if let Change::Add(corners) = change {
                self.path(&mut out, "new", &corners, true);
            }
        }
        self.path(&mut out, "front", &scene.front, false);
        if let [Vertex::Left, first, .., last, Vertex::Right] = scene.front[..] {
            let outward = [(first, -width), (last, width)];
            for (end, far) in outward.map(|(v, far)| (self.place(v), far)) {
                let Some([x, y]) = end else { continue };
                let _ = writeln!(out, r#"<path class="front" d="M{x:.1} {y:.1}h{far:.1}"/>"#);
            }
        }
        for ends in self.edges {
            self.line(&mut out, "input", ends.map(|v| self.frame.places[v]));
        }
        for ends in &scene.fixed {
            self.path(&mut out, "constraint", ends, false);
        }
        if let Some([_, y]) = scene.sweep.and_then(|v| self.place(v)) {
            let _ = writeln!(out, r#"<path class="sweep" d="M0 {y:.1}H{width:.1}"/>"#);
        }
        if let Some(ends) = scene.edge {
            self.path(&mut out, "inserted", &ends, false);
        }
        let is_swap = scene.step.iter().any(|c| matches!(c, Change::Gone(_)));
        let line = if is_swap { "came" } else { "looked" };
        for change in &scene.step {
            self.highlight(&mut out, change, line);
        }
        self.vertices(&mut out, scene, height);
        out
    }

    /// Points at what the step is about; lines have this class.
    fn highlight(&self, out: &mut String, change: &Change, line: &str) {
        match change {
            Change::Line(ends) => self.path(out, line, ends, false),
            Change::Gone(ends) => self.path(out, "gone", ends, false),
            Change::Test([a, b, p, q], outcome) => {
                let class = match outcome {
                    Outcome::Legal => "legal",
                    Outcome::Illegal => "illegal",
                    Outcome::Fixed => "looked",
                };
                self.path(out, "quad", &[*p, *a, *q, *b], true);
                self.path(out, class, &[*a, *b], false);
                let corners = [a, b, p, q].map(|&v| self.unit_place(v));
                if let [Some(a), Some(b), Some(p), Some(_)] = corners
                    && *outcome != Outcome::Fixed
                    && let Some((center, radius)) = circle([a, b, p])
                {
                    let ([x, y], r) = (self.pixels(center), radius * self.scale);
                    let _ = writeln!(
                        out,
                        r#"<circle class="{class}" cx="{x:.1}" cy="{y:.1}" r="{r:.1}"/>"#
                    );
                }
            }
            Change::Vertex(v) => {
                if let Some([x, y]) = self.place(*v) {
                    let _ = writeln!(
                        out,
                        r#"<circle class="ring" cx="{x:.1}" cy="{y:.1}" r="8"/>"#
                    );
                }
            }
            _ => {}
        }
    }

    /// Draws the sides of an artificial triangle from its vertices outwards.
    fn rays(&self, out: &mut String, corners: &[Vertex; 3]) {
        let far = self.size()[0];
        for (artificial, far) in [(Vertex::Left, -far), (Vertex::Right, far)] {
            if corners.contains(&artificial) {
                for [x, y] in corners.iter().filter_map(|&v| self.place(v)) {
                    let _ = writeln!(out, r#"<path class="ray" d="M{x:.1} {y:.1}h{far:.1}"/>"#);
                }
            }
        }
    }

    fn vertices(&self, out: &mut String, scene: &Scene, height: f64) {
        let sweep = scene.sweep.and_then(|v| self.unit_place(v));
        let numbered = self.frame.spacing() * self.scale > ROOM_FOR_NUMBERS;
        for (v, place) in self.frame.places.iter().enumerate() {
            let [x, y] = self.pixels(*place);
            if x < 0.0 || y < 0.0 || y > height || x > self.size()[0] {
                continue;
            }
            let is_swept = sweep.is_some_and(|[x, y]| (place[1], place[0]) <= (y, x));
            let is_swept = is_swept || scene.is_swept;
            let class = if is_swept { "swept" } else { "vertex" };
            let _ = writeln!(
                out,
                r#"<circle class="{class}" cx="{x:.1}" cy="{y:.1}" r="3"/>"#
            );
            if numbered {
                let (x, y) = (x + 6.0, y - 6.0);
                let _ = writeln!(out, r#"<text x="{x:.1}" y="{y:.1}">{v}</text>"#);
            }
        }
    }

    /// Draws lines through vertices, without the artificial ones.
    fn path(&self, out: &mut String, class: &str, vertices: &[Vertex], is_closed: bool) {
        let places: Vec<[f64; 2]> = vertices.iter().filter_map(|&v| self.place(v)).collect();
        let [width, height] = self.size();
        let outside = [
            places.iter().all(|p| p[0] < 0.0),
            places.iter().all(|p| p[0] > width),
            places.iter().all(|p| p[1] < 0.0),
            places.iter().all(|p| p[1] > height),
        ];
        if places.len() < 2 || outside.contains(&true) {
            return;
        }
        let points = places.iter().map(|[x, y]| format!("{x:.1} {y:.1}"));
        let points = points.collect::<Vec<_>>().join("L");
        let close = if is_closed { "Z" } else { "" };
        let _ = writeln!(out, r#"<path class="{class}" d="M{points}{close}"/>"#);
    }

    fn line(&self, out: &mut String, class: &str, ends: [[f64; 2]; 2]) {
        let [[x, y], [to_x, to_y]] = ends.map(|end| self.pixels(end));
        let _ = writeln!(
            out,
            r#"<path class="{class}" d="M{x:.1} {y:.1}L{to_x:.1} {to_y:.1}"/>"#
        );
    }

    fn place(&self, vertex: Vertex) -> Option<[f64; 2]> {
        self.unit_place(vertex).map(|place| self.pixels(place))
    }

    fn unit_place(&self, vertex: Vertex) -> Option<[f64; 2]> {
        match vertex {
            Vertex::Input(index) => self.frame.places.get(index as usize).copied(),
            Vertex::Left | Vertex::Right => None,
        }
    }

    fn pixels(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [
            (x - self.low[0]) * self.scale,
            (self.low[1] + self.extent[1] - y) * self.scale,
        ]
    }
}
