//! What the page draws and says of an input: a line of JSON, and then numbers.
//!
//! The numbers are little-endian: the vertices as pairs of doubles, those of the input first; the edges of the input as
//! pairs of 32 bits; the triangles as triples of 32 bits; the places where edges cross as pairs of doubles; the
//! edges that cross as pairs of 32 bits. The line says how many there are of each. So a million points pass from one
//! memory to the other without becoming text.

use std::io;

use serde::Serialize;
use sweep_cdt::crossings::{Crossing, Exact, crossings};
use sweep_cdt::formats::{Coordinate, Graph, Splitting};
use sweep_cdt::{Error, Stats, Triangulation};

use super::request::Settings;

/// All of it.
pub(crate) struct Picture {
    summary: Summary,
    vertices: Vec<[f64; 2]>,
    edges: Vec<[usize; 2]>,
    triangles: Vec<[usize; 3]>,
    crossings: Vec<Crossing>,
}

/// The line.
#[derive(Serialize)]
struct Summary {
    /// How many points the input has; the vertices after these are crossings.
    points: usize,
    vertices: usize,
    edges: usize,
    triangles: usize,
    crossings: usize,
    /// How far splitting moved an edge at most, in units in the last place, if edges were split.
    displacement: Option<f64>,
    /// Why the rule says nothing of what is inside, so that all triangles are drawn.
    domain_refused: Option<String>,
    /// Nothing, if edges cross and are not split.
    stats: Option<Stats>,
}

impl Picture {
    /// Triangulates. Edges that cross are no failure: they are listed, and split if the settings say so.
    pub(crate) fn new<S: Coordinate + Exact>(
        graph: &Graph<S>,
        settings: &Settings,
    ) -> Result<Picture, Error> {
        match settings.triangulate(graph, None) {
            Ok(run) => Ok(Picture::of(graph, graph, Some(run), Vec::new(), settings)),
            Err(Error::CrossingEdges { .. }) => {
                let found = crossings(&graph.points, &graph.edges)?;
                if !settings.split {
                    return Ok(Picture::of(graph, graph, None, found, settings));
                }
                let (pieces, splitting) = graph.split_crossings()?;
                let run = settings.triangulate(&pieces, None)?;
                let picture = Picture::of(graph, &pieces, Some(run), found, settings);
                Ok(picture.displaced(splitting))
            }
            Err(error) => Err(error),
        }
    }

    /// The picture of `graph`, of which `pieces` were triangulated.
    fn of<S: Coordinate>(
        graph: &Graph<S>,
        pieces: &Graph<S>,
        run: Option<(Triangulation, Stats)>,
        crossings: Vec<Crossing>,
        settings: &Settings,
    ) -> Picture {
        let mut domain_refused = None;
        let mut triangles = Vec::new();
        if let Some((result, _)) = &run {
            match settings.domain(pieces, result) {
                Some(Ok(domain)) => {
                    let inside = domain.inside();
                    triangles.extend(inside.map(|t| result.triangle(t)));
                }
                refused => {
                    let refused = refused.and_then(Result::err);
                    let refused = refused.map(|error| pieces.domain_as_numbered(error));
                    domain_refused = refused.map(|error| error.to_string());
                    triangles.extend(result.triangles());
                }
            }
        }
        let summary = Summary {
            points: graph.points.len(),
            vertices: pieces.points.len(),
            edges: graph.edges.len(),
            triangles: triangles.len(),
            crossings: crossings.len(),
            displacement: None,
            domain_refused,
            stats: run.map(|(_, stats)| stats),
        };
        let near = |point: &[S; 2]| point.each_ref().map(S::approx);
        Picture {
            summary,
            vertices: pieces.points.iter().map(near).collect(),
            edges: graph.edges.clone(),
            triangles,
            crossings,
        }
    }

    fn displaced(mut self, splitting: Splitting) -> Picture {
        self.summary.displacement = Some(splitting.displacement);
        self
    }

    /// Writes it.
    pub(crate) fn write(&self, out: &mut Vec<u8>) -> io::Result<()> {
        serde_json::to_writer(&mut *out, &self.summary)?;
        out.push(b'\n');
        doubles(out, self.vertices.iter().copied());
        indices(out, &self.edges);
        indices(out, &self.triangles);
        doubles(out, self.crossings.iter().map(Crossing::near));
        let pairs: Vec<[usize; 2]> = self.crossings.iter().map(|found| found.edges).collect();
        indices(out, &pairs);
        Ok(())
    }
}

fn doubles(out: &mut Vec<u8>, places: impl Iterator<Item = [f64; 2]>) {
    out.extend(places.flatten().flat_map(f64::to_le_bytes));
}

/// Positions in lists that a page can hold are below 2^32.
fn indices<const N: usize>(out: &mut Vec<u8>, rows: &[[usize; N]]) {
    let numbers = rows.as_flattened().iter();
    out.extend(numbers.flat_map(|&number| (number as u32).to_le_bytes()));
}
