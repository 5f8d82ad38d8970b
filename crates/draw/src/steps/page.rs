//! The page: one file that needs nothing else, with the steps in it.
//!
//! The script knows from when to when each triangle is there, so that any step is shown without those before it.

use std::io::{self, Write};
use std::ops::RangeInclusive;

use super::change::changes;
use super::choice::{Detail, fitting};
use super::data::{Data, Steps, cost};
use super::scene::Part;
use crate::style::PAGE_COLOURS;
use crate::window::{Bounds, places};
use sweep_cdt::scalar::Scalar;
use sweep_cdt::trace::Event;
use sweep_cdt::{Error, Pslg};

const HTML: &str = include_str!("page.html");
const CSS: &str = include_str!("page.css");
/// In the order in which they are run.
const SCRIPTS: [&str; 9] = [
    include_str!("steps.js"),
    include_str!("scene.js"),
    include_str!("paint.js"),
    include_str!("labels.js"),
    include_str!("tiles.js"),
    include_str!("ground.js"),
    include_str!("view.js"),
    include_str!("words.js"),
    include_str!("page.js"),
];
/// About what a vertex takes on the page, an edge, and both its triangles.
const BYTES: [usize; 3] = [27, 14, 50];
/// With more vertices than this, their places are rounded to a billionth of the picture.
const MOST_EXACT: usize = 5000;

/// A page to walk through the steps of a run, as HTML. It is one file that loads nothing.
///
/// A page holds no more bytes than a browser bears. If the steps of a run take more, it holds those from the first
/// point event on, or those [around](StepsPage::around) a step. If the vertices and edges do, it holds those that the
/// steps on the page are about and some of the others. It says so.
///
/// ```
/// use sweep_cdt::{Algorithm, Pslg, Triangulator, Watch};
/// use sweep_cdt_draw::StepsPage;
///
/// let points = vec![[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]];
/// let graph = Pslg { points, edges: vec![[0, 2]], ..Pslg::default() };
/// let mut events = Vec::new();
/// let mut push = |event| events.push(event);
/// let watch = Watch::new().events(&mut push);
/// Triangulator::new().algorithm(Algorithm::Paper).run(&graph.points, &graph.edges, watch)?;
/// let mut page = Vec::new();
/// StepsPage::new(&graph, &events).write(&mut page)?;
/// assert!(page.starts_with(b"<!DOCTYPE html>"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct StepsPage<'a, S> {
    graph: &'a Pslg<S>,
    events: &'a [Event],
    steps: RangeInclusive<usize>,
    around: Option<usize>,
    most_bytes: usize,
    refused: Option<&'a Error>,
}

impl<'a, S: Scalar> StepsPage<'a, S> {
    /// The default of [`most_bytes`](Self::most_bytes): 20 million, which a browser shows within a second or two.
    pub const MOST_BYTES: usize = 20_000_000;

    /// A page for a run on `graph`, of which `events` are all events.
    #[must_use]
    pub fn new(graph: &'a Pslg<S>, events: &'a [Event]) -> StepsPage<'a, S> {
        StepsPage {
            graph,
            events,
            steps: 1..=usize::MAX,
            around: None,
            most_bytes: Self::MOST_BYTES,
            refused: None,
        }
    }

    /// The numbers of the steps to show, counted from 1. The default is all steps.
    #[must_use]
    pub fn steps(self, steps: RangeInclusive<usize>) -> Self {
        StepsPage { steps, ..self }
    }

    /// The step to show first. If the page cannot hold all steps, it holds those before and after this one.
    #[must_use]
    pub fn around(self, step: usize) -> Self {
        let around = Some(step);
        StepsPage { around, ..self }
    }

    /// About how many bytes the page has at most. The default is [`MOST_BYTES`](Self::MOST_BYTES).
    #[must_use]
    pub fn most_bytes(self, most_bytes: usize) -> Self {
        StepsPage { most_bytes, ..self }
    }

    /// Says on the page that the run ended here with an error: edges that cross.
    #[must_use]
    pub fn refused(self, error: &'a Error) -> Self {
        let refused = Some(error);
        StepsPage { refused, ..self }
    }

    /// The numbers of the steps that the page holds.
    #[must_use]
    pub fn shown(&self) -> RangeInclusive<usize> {
        let last = *self.steps.end();
        let end = last.min(self.events.len());
        let start = self.steps.start().saturating_sub(1).min(end);
        let room = self.most_bytes - self.bytes_of_input().min(self.most_bytes / 2);
        let around = self.around.map(|step| step.saturating_sub(1));
        let shown = fitting(self.events, &(start..end), around, cost, room);
        shown.start + 1..=shown.end
    }

    /// About the bytes for all vertices and edges, and for the triangles before the first step.
    fn bytes_of_input(&self) -> usize {
        let [vertex, edge, triangles] = BYTES;
        let is_later = self.around.is_some() || *self.steps.start() > 1;
        let vertex = vertex + if is_later { triangles } else { 0 };
        self.graph.points.len() * vertex + self.graph.edges.len() * edge
    }

    /// Writes the page.
    ///
    /// # Errors
    /// Errors of `out`.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        let scheme = |at: usize| {
            let colour = |(name, light, dark)| format!("--{name}: {}; ", [light, dark][at]);
            format!(":root {{ {}}}", PAGE_COLOURS.map(colour).concat())
        };
        let [light, dark] = [0, 1].map(scheme);
        let dark = format!("@media (prefers-color-scheme: dark) {{ {dark} }}");
        // No sentence or name holds a `<`, so the data cannot end its element.
        let data = serde_json::to_string(&self.data())?;
        let mut rest = HTML;
        for (mark, text) in [
            ("{{css}}", format!("{light}\n{dark}\n{CSS}")),
            ("{{trace}}", data),
            ("{{js}}", SCRIPTS.join("\n")),
        ] {
            let (before, after) = rest.split_once(mark).expect("the page has its marks");
            write!(out, "{before}{text}")?;
            rest = after;
        }
        write!(out, "{rest}")
    }

    fn data(&self) -> Data {
        let (graph, shown) = (self.graph, self.shown());
        let part = Part::new(self.events, &shown, usize::MAX);
        let points = places(&graph.points);
        let bounds = Bounds::of(points.iter().copied());
        let (count, total) = (points.len(), self.events.len());
        let mut data = Data {
            first: part.first,
            total,
            start: self.around.unwrap_or(0),
            refused: self.refused.map(Error::to_string),
            size: bounds.size.map(|side| side / bounds.unit()),
            spacing: bounds.spacing(count),
            counts: [count, graph.edges.len()],
            counted: counted(&self.events[..part.first - 1], part.before.triangles.len()),
            steps: Steps::new(part.events),
            ..Data::new()
        };
        if part.events.len() < total {
            let last = part.first + part.events.len() - 1;
            let notice = format!("This page holds steps {} to {last} of {total}.", part.first);
            data.notices.push(notice);
        }
        if let Some(error) = &self.refused {
            let notice = format!("The run ends after step {total}: {error}.");
            data.notices.push(notice);
        }
        let place = |v: usize| {
            let share = bounds.share(points[v]);
            if count > MOST_EXACT {
                share.map(|x| (x * 1e9).round() / 1e9)
            } else {
                share
            }
        };
        let mut before = part.before.changes_since_new();
        if self.bytes_of_input() <= self.most_bytes / 2 {
            data.points = (0..count).map(place).collect();
            data.edges.clone_from(&graph.edges);
        } else {
            let sample = self.most_bytes / 8 / BYTES[0];
            let named = part.events.iter().flat_map(changes);
            let detail = Detail::new(named, &part.before, count, &graph.edges, sample);
            let (kept, edges) = (detail.vertices.len(), detail.edges.len());
            data.notices.push(format!(
                "It draws {kept} of {count} vertices and {edges} of {} edges: those near its steps, \
                 and some of the others.",
                graph.edges.len()
            ));
            data.points = detail.vertices.iter().map(|&v| place(v)).collect();
            data.edges = detail.edges.iter().map(|&e| graph.edges[e]).collect();
            data.point_numbers = Some(detail.vertices);
            data.edge_numbers = Some(detail.edges);
            before = detail.before;
        }
        for change in before {
            change.encode(&mut data.base);
        }
        data
    }
}

/// How many tests and flips there are among some events, and the triangles after them.
fn counted(events: &[Event], triangles: usize) -> [usize; 3] {
    let is_test = |event: &&Event| matches!(event, Event::Test { .. });
    let is_flip = |event: &&Event| matches!(event, Event::Flip { .. });
    [
        events.iter().filter(is_test).count(),
        events.iter().filter(is_flip).count(),
        triangles,
    ]
}
