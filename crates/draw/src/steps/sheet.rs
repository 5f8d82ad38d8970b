//! A sheet of steps: each as a panel, with its heading and its sentence below.

use std::io::{self, Write};
use std::ops::RangeInclusive;

use super::panel::Panel;
use super::scene::Part;
use super::story::{heading, sentence};
use super::style::{STYLES, Style};
use crate::panels::{self, Panels};
use crate::style::{BLUE, GREY, INK, PAPER};
use crate::svg;
use crate::window::{PIXEL, places};
use sweep_cdt::Pslg;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::trace::Event;

/// Room for the note that steps are left out.
const NOTE: i64 = 20 * PIXEL;

/// A sheet with some steps of a run, as SVG.
///
/// ```
/// use sweep_cdt::{Algorithm, Pslg, Triangulator, Watch};
/// use sweep_cdt_draw::StepsSheet;
///
/// let points = vec![[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]];
/// let graph = Pslg { points, edges: vec![[0, 2]], ..Pslg::default() };
/// let mut events = Vec::new();
/// let mut push = |event| events.push(event);
/// let watch = Watch::new().events(&mut push);
/// Triangulator::new().algorithm(Algorithm::Paper).run(&graph.points, &graph.edges, watch)?;
/// let mut sheet = Vec::new();
/// StepsSheet::new(&graph, &events).steps(5..=10).write(&mut sheet)?;
/// assert!(sheet.starts_with(b"<svg "));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct StepsSheet<'a, S> {
    graph: &'a Pslg<S>,
    events: &'a [Event],
    steps: RangeInclusive<usize>,
    most: usize,
}

impl<'a, S: Scalar> StepsSheet<'a, S> {
    /// A sheet for a run on `graph`, of which `events` are all events up to the last step that is shown.
    #[must_use]
    pub fn new(graph: &'a Pslg<S>, events: &'a [Event]) -> StepsSheet<'a, S> {
        StepsSheet {
            graph,
            events,
            steps: 1..=usize::MAX,
            most: 60,
        }
    }

    /// The numbers of the steps to show, counted from 1. The default is all steps.
    #[must_use]
    pub fn steps(self, steps: RangeInclusive<usize>) -> Self {
        StepsSheet { steps, ..self }
    }

    /// How many steps are shown at most; the sheet says so if it leaves steps out. The default is 60.
    #[must_use]
    pub fn most(self, most: usize) -> Self {
        StepsSheet { most, ..self }
    }

    /// Writes the sheet.
    ///
    /// # Errors
    /// Errors of `out`.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        let points = places(&self.graph.points);
        let part = Part::new(self.events, &self.steps, self.most);
        let (shown, mut scene) = (part.events.len(), part.before);
        let panels = Panels::new(shown);

        // All panels are drawn first: the tallest one decides on the height of the rows.
        let mut drawn = Vec::new();
        for (number, event) in (part.first..).zip(part.events) {
            scene.advance(event);
            let panel = Panel::new(&points, &self.graph.edges, &scene, panels.side);
            let mut picture = Vec::new();
            panel.draw(&scene, &mut picture)?;
            let title = format!("{number}  {}", heading(event));
            drawn.push((panel.size(), picture, title, sentence(event)));
        }
        let tallest = drawn.iter().map(|(size, ..)| size[1]).max().unwrap_or(0);
        let panels = panels.tallest(tallest);
        let left_out = part.wanted > shown;
        let [width, height] = panels.size();
        let below = if left_out { NOTE } else { 0 };
        svg::begin(out, [width, height + below], &rules())?;
        writeln!(out, "{}", definitions())?;
        for (position, (size, picture, title, text)) in drawn.iter().enumerate() {
            panels.write(out, position, *size, "step", [title, text], |out| {
                out.write_all(picture)
            })?;
        }
        if left_out {
            let (x, wanted) = (24 * PIXEL, part.wanted);
            let note = format!("The first {shown} of {wanted} steps.");
            writeln!(
                out,
                "<text class=\"caption\" x=\"{x}\" y=\"{height}\">{note}</text>"
            )?;
        }
        svg::end(out)
    }
}

/// The style rules. A side under test is heavier than its circle.
fn rules() -> String {
    let styles = STYLES.map(|style| style.rule()).concat();
    format!(
        "{styles}circle.legal, circle.illegal {{ fill: none }}
path.legal, path.illegal {{ stroke-width: 400 }}
.inserted {{ marker-end: url(#arrow) }}
.ring {{ fill: none; stroke: {INK}; stroke-width: 200 }}
.vertex {{ fill: {PAPER}; stroke: {GREY}; stroke-width: 150 }}
.swept {{ fill: {INK} }}
.step text {{ font-size: 1100px }}
{}",
        panels::rules()
    )
}

/// The patterns of hatched areas, and the head of the arrow along an edge being inserted.
fn definitions() -> String {
    let patterns: String = STYLES.iter().filter_map(Style::pattern).collect();
    format!(
        r#"<defs>
{patterns}<marker id="arrow" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="4" markerHeight="4" orient="auto"><path d="M0 0L10 5L0 10Z" style="fill: {BLUE}"/></marker>
</defs>"#
    )
}
