//! The page: one file that needs nothing else, with the steps in it.
//!
//! The script keeps copies of the scene at regular intervals. To show a step, it takes the copy before it and
//! applies a few changes.

use std::io::{self, Write};
use std::ops::RangeInclusive;

use serde::Serialize;

use super::change::{Change, changes};
use super::scene::Part;
use super::story::{heading, sentence};
use super::style::{STYLES, Style};
use crate::draw::style::PAGE_COLOURS;
use crate::draw::window::{Bounds, places};
use crate::formats::Graph;
use crate::scalar::Scalar;
use crate::trace::Event;

const HTML: &str = include_str!("page.html");
const CSS: &str = include_str!("page.css");
const SCRIPTS: [&str; 3] = [
    include_str!("scene.js"),
    include_str!("view.js"),
    include_str!("page.js"),
];

/// A page to walk through the steps of a run, as HTML. It is one file that loads nothing.
///
/// ```
/// use sweep_cdt::draw::StepsPage;
/// use sweep_cdt::formats::Graph;
///
/// let points = vec![[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]];
/// let graph = Graph { points, edges: vec![[0, 2]], ..Graph::default() };
/// let mut events = Vec::new();
/// sweep_cdt::Triangulator::new()
///     .triangulate_observed(&graph.points, &graph.edges, |event| events.push(event))?;
/// let mut page = Vec::new();
/// StepsPage::new(&graph, &events).write(&mut page)?;
/// assert!(page.starts_with(b"<!DOCTYPE html>"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct StepsPage<'a, S> {
    graph: &'a Graph<S>,
    events: &'a [Event],
    steps: RangeInclusive<usize>,
    most: usize,
}

impl<'a, S: Scalar> StepsPage<'a, S> {
    /// A page for a run on `graph`, of which `events` are all events.
    #[must_use]
    pub fn new(graph: &'a Graph<S>, events: &'a [Event]) -> StepsPage<'a, S> {
        StepsPage {
            graph,
            events,
            steps: 1..=usize::MAX,
            most: 20_000,
        }
    }

    /// The numbers of the steps to show, counted from 1. The default is all steps.
    #[must_use]
    pub fn steps(self, steps: RangeInclusive<usize>) -> Self {
        StepsPage { steps, ..self }
    }

    /// How many steps the page holds at most; it says so if it leaves steps out. The default is 20,000.
    #[must_use]
    pub fn most(self, most: usize) -> Self {
        StepsPage { most, ..self }
    }

    /// Writes the page.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        let colour = |(name, value): (&str, &str)| format!("--{name}: {value}; ");
        let css = format!(":root {{ {}}}\n{CSS}", PAGE_COLOURS.map(colour).concat());
        let part = Part::new(self.events, &self.steps, self.most);
        // No sentence or name holds a `<`, so the data cannot end its element.
        let data = serde_json::to_string(&Data::new(self.graph, self.events.len(), &part))?;
        let mut rest = HTML;
        for (mark, text) in [
            ("{{css}}", css),
            ("{{trace}}", data),
            ("{{js}}", SCRIPTS.join("\n")),
        ] {
            let (before, after) = rest.split_once(mark).expect("the page has its marks");
            write!(out, "{before}{text}")?;
            rest = after;
        }
        write!(out, "{rest}")
    }
}

/// What the script reads.
#[derive(Serialize)]
struct Data<'a> {
    /// The number of the first step on the page, and how many steps the run has.
    first: usize,
    total: usize,
    /// Width and height of the points' bounding box; its longer side is 1.
    size: [f64; 2],
    /// About the distance of neighbours.
    spacing: f64,
    /// The points, from the lower left corner of the bounding box.
    points: Vec<[f64; 2]>,
    edges: &'a [[usize; 2]],
    styles: &'static [Style],
    headings: Vec<&'static str>,
    /// The changes that lead from an empty scene to the one before the first step.
    base: Vec<Change>,
    steps: Vec<Step>,
}

/// A step: the position of its heading in the list of headings, its sentence, and its changes.
#[derive(Serialize)]
struct Step(usize, String, Vec<Change>);

impl<'a> Data<'a> {
    fn new<S: Scalar>(graph: &'a Graph<S>, total: usize, part: &Part<'_>) -> Data<'a> {
        let points = places(&graph.points);
        let bounds = Bounds::of(points.iter().copied());
        let mut headings: Vec<&str> = part.events.iter().map(heading).collect();
        headings.sort_unstable();
        headings.dedup();
        let step = |event| {
            let heading = headings.partition_point(|&other| other < heading(event));
            Step(heading, sentence(event), changes(event))
        };
        Data {
            first: part.first,
            total,
            size: bounds.size.map(|side| side / bounds.unit()),
            spacing: bounds.spacing(points.len()),
            points: points.into_iter().map(|p| bounds.share(p)).collect(),
            edges: &graph.edges,
            styles: &STYLES,
            base: part.before.changes_since_new(),
            steps: part.events.iter().map(step).collect(),
            headings,
        }
    }
}
