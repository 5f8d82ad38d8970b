//! The picture of what is wrong with a triangulation: an overview with a number at each close-up, then close-ups of
//! the first violations.

use std::collections::BTreeMap;
use std::io::{self, Write};

use super::close_up::{Background, CloseUp};
use super::panels::{self, Panels};
use super::style::{LEGEND_HEIGHT, RED, mesh_rules, mesh_widths, write_legend};
use super::svg;
use super::window::{Bounds, PIXEL, Window};
use sweep_cdt::scalar::Scalar;
use sweep_cdt::verify::Violation;
use sweep_cdt_formats::{GraphFile, Triangles};

/// About the distance of neighbouring vertices in a close-up, in pixels.
const SPACING: f64 = 60.0;

/// A picture of a triangulation and its violations, as SVG: an overview, then close-ups of the first
/// violations.
///
/// ```
/// use sweep_cdt::Pslg;
/// use sweep_cdt::verify::Verifier;
/// use sweep_cdt_draw::ViolationsPicture;
/// use sweep_cdt_formats::{Format, GraphFile, Source, read_result};
///
/// let points = vec![[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]];
/// let file = GraphFile::from(Pslg { points, edges: vec![[0, 2]], ..Pslg::default() });
/// let bytes = br#"{"triangles": [[0, 1, 3], [1, 2, 3]]}"#.to_vec();
/// let source = Source::new("other.json", bytes);
/// let triangles = read_result(Format::Json, &source, None, &file)?;
/// let verdict = Verifier::new().verify(&file.graph.points, &file.graph.edges, &triangles.list);
/// let violations = verdict.expect_err("the edge is missing");
/// let mut picture = Vec::new();
/// ViolationsPicture::new(&file, &triangles, &violations.list)
///     .found(violations.found)
///     .close_ups(3)
///     .write(&mut picture)?;
/// assert!(picture.starts_with(b"<svg "));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct ViolationsPicture<'a, S> {
    file: &'a GraphFile<S>,
    triangles: &'a Triangles,
    violations: &'a [Violation],
    found: usize,
    close_ups: usize,
}

impl<'a, S: Scalar> ViolationsPicture<'a, S> {
    /// A picture of `violations`, which the verifier reported of `triangles`, a result for the graph of `file`. With
    /// no violations it shows the overview only.
    #[must_use]
    pub fn new(
        file: &'a GraphFile<S>,
        triangles: &'a Triangles,
        violations: &'a [Violation],
    ) -> ViolationsPicture<'a, S> {
        ViolationsPicture {
            file,
            triangles,
            violations,
            found: violations.len(),
            close_ups: 5,
        }
    }

    /// How many violations there are, beyond those listed too. The default is the length of the list.
    #[must_use]
    pub fn found(self, found: usize) -> Self {
        ViolationsPicture { found, ..self }
    }

    /// How many violations have a close-up at most. The default is 5.
    #[must_use]
    pub fn close_ups(self, close_ups: usize) -> Self {
        ViolationsPicture { close_ups, ..self }
    }

    /// Writes the picture.
    ///
    /// # Errors
    /// Errors of `out`.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        let (file, triangles) = (self.file, self.triangles);
        let graph = &file.graph;
        let background = Background::new(graph, triangles);
        let vertices_of = |&violation: &Violation| triangles.vertices_of(graph, violation);
        // The violations that are at vertices, and the vertices of each.
        let (shown, foci): (Vec<Violation>, Vec<Vec<usize>>) = self
            .violations
            .iter()
            .map(|violation| (*violation, vertices_of(violation)))
            .filter(|(_, vertices)| !vertices.is_empty())
            .unzip();
        let close_ups = foci.len().min(self.close_ups);
        let panels = Panels::new(1 + close_ups);
        let [width, height] = panels.size();
        let square = [panels.side; 2];

        let spacing = Bounds::of(background.points.iter().copied()).spacing(graph.points.len());
        let spacing = spacing * panels.side as f64 / PIXEL as f64;
        svg::begin(out, [width, height + LEGEND_HEIGHT], &rules(spacing))?;
        let title = match self.found {
            0 => "correct".to_owned(),
            1 => "1 violation".to_owned(),
            found => format!("{found} violations"),
        };
        // The overview, the close-ups, the legend.
        let window = overview_window(&background, panels.side);
        panels.write(out, 0, square, "overview", [&title, ""], |out| {
            draw_overview(&background, &window, &foci, close_ups, out)
        })?;
        for (position, (&violation, vertices)) in (1..=close_ups).zip(shown.iter().zip(&foci)) {
            let close_up = CloseUp {
                file,
                triangles,
                background: &background,
                violation,
                vertices,
            };
            let window = close_up.window(panels.side);
            let title = format!("{position}: {}", violation.name());
            let text = triangles.as_numbered(file, violation).to_string();
            panels.write(out, position, square, "close-up", [&title, &text], |out| {
                close_up.draw(&window, out)
            })?;
        }
        let entries = [
            ("side", format!("triangles: {}", triangles.list.len())),
            ("edge", format!("edges: {}", graph.edges.len())),
            ("hull", "boundary".to_owned()),
            ("vertex", format!("vertices: {}", graph.points.len())),
            ("wrong", format!("violations: {}", self.found)),
        ];
        write_legend(out, [width / 2, height], &entries)?;
        svg::end(out)
    }
}

/// The style rules, for vertices in the overview that are about `spacing` pixels apart.
pub(super) fn rules(spacing: f64) -> String {
    format!(
        "{}{}{}.wrong {{ stroke: {RED}; stroke-width: 350 }}
.absent {{ stroke: {RED}; stroke-width: 350; stroke-dasharray: 900 700 }}
.circle {{ stroke: {RED}; stroke-width: 150; stroke-dasharray: 500 400; fill: none }}
.bad {{ fill: {RED}; fill-opacity: 0.18; stroke: none }}
.culprit {{ stroke: {RED}; stroke-width: 1000 }}
.title {{ fill: {RED} }}
",
        mesh_rules(SPACING),
        mesh_widths(".overview ", spacing),
        panels::rules()
    )
}

/// Draws the overview in a window, with a dot at each of the `foci`: the points of a violation. The
/// first `numbered` of them have close-ups.
pub(super) fn draw_overview(
    background: &Background,
    window: &Window,
    foci: &[Vec<usize>],
    numbered: usize,
    out: &mut impl Write,
) -> io::Result<()> {
    background.draw(window, out)?;
    let middle = |vertices: &Vec<usize>| {
        let count = vertices.len() as f64;
        let points = || vertices.iter().map(|&v| background.points[v]);
        let mean = |axis: usize| points().map(|point| point[axis] / count).sum();
        window.place([mean(0), mean(1)])
    };
    let places: Vec<[i64; 2]> = foci.iter().map(middle).collect();
    svg::layer(out, "culprit", places.iter().copied().map(svg::dot))?;
    // Violations at one place share a label.
    let mut names: BTreeMap<[i64; 2], Vec<String>> = BTreeMap::new();
    for (&place, panel) in places.iter().take(numbered).zip(1_usize..) {
        names.entry(place).or_default().push(panel.to_string());
    }
    for (place, panels) in names {
        svg::label(out, place, panels.join(", "))?;
    }
    Ok(())
}

/// The window of an overview of this size.
pub(super) fn overview_window(background: &Background, size: i64) -> Window {
    let all = Bounds::of(background.points.iter().copied());
    Window::new(all.squared(all.longer()).with_margin(0.06), size)
}
