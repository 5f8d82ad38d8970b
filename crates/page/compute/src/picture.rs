//! The answer that the page draws and says: a line of JSON, and then numbers.
//!
//! The numbers are little-endian, places as pairs of doubles, the rest in 32 bits each: the vertices, those of the input
//! first; the edges of the input; the triangles; their sides, first those between two of them, then those of one; the
//! places where edges cross; the edges that cross. The line says how many there are of each. So a million points pass
//! from one memory to the other without becoming text.

use std::io;

use serde::Serialize;
use sweep_cdt::crossings::{Crossing, Exact, SplitError, crossings};
use sweep_cdt::{Error, Pslg, Stats, Triangulation};
use sweep_cdt_engine::remarks;
use sweep_cdt_formats::{Coordinate, GraphFile, Remark, Splitting};

use super::settings::Asked;

/// All of it.
pub(crate) struct Picture {
    summary: Summary,
    vertices: Vec<[f64; 2]>,
    edges: Vec<[usize; 2]>,
    shown: Shown,
    /// The edges of each pair that crosses, and where.
    crossings: Vec<([usize; 2], [f64; 2])>,
}

/// Triangles and their sides: those of two triangles, and those of one.
#[derive(Default)]
struct Shown {
    triangles: Vec<[usize; 3]>,
    inner: Vec<[usize; 2]>,
    border: Vec<[usize; 2]>,
}

impl Shown {
    /// The triangles of a result that are drawn.
    fn new(result: &Triangulation, is_drawn: impl Fn(usize) -> bool) -> Shown {
        let mut shown = Shown::default();
        for t in (0..result.len()).filter(|&t| is_drawn(t)) {
            let corners = result.triangle(t);
            shown.triangles.push(corners);
            for side in 0..3 {
                let ends = [corners[(side + 1) % 3], corners[(side + 2) % 3]];
                match result.neighbor(t, side).filter(|&across| is_drawn(across)) {
                    None => shown.border.push(ends),
                    Some(across) if across > t => shown.inner.push(ends),
                    Some(_) => {}
                }
            }
        }
        shown
    }
}

/// The line.
#[derive(Serialize)]
struct Summary {
    /// How many points the input has; the vertices after these are crossings.
    points: usize,
    vertices: usize,
    edges: usize,
    triangles: usize,
    inner: usize,
    border: usize,
    crossings: usize,
    /// How far splitting moved an edge at most, in units in the last place, if edges were split.
    displacement: Option<f64>,
    /// Why the rule says nothing of what is inside, so that all triangles are drawn.
    domain_refused: Option<String>,
    /// What is ignored, merged, missing, chosen or guessed.
    remarks: Vec<String>,
    /// Nothing, if edges cross and are not split.
    stats: Option<Stats>,
}

impl Picture {
    /// Triangulates. Edges that cross are no failure: they are listed, and split if the settings say so.
    pub(crate) fn new<S: Coordinate + Exact>(
        file: &GraphFile<S>,
        settings: &Asked,
    ) -> Result<Picture, SplitError> {
        let graph = &file.graph;
        match settings.triangulate(graph, None) {
            Ok(run) => Ok(Picture::of(graph, file, Some(run), &[], settings)),
            Err(Error::CrossingEdges { .. }) => {
                let found = crossings(&graph.points, &graph.edges)?;
                if !settings.split {
                    return Ok(Picture::of(graph, file, None, &found, settings));
                }
                let (pieces, splitting) = file.split_crossings()?;
                let run = settings.triangulate(&pieces.graph, None)?;
                let picture = Picture::of(graph, &pieces, Some(run), &found, settings);
                Ok(picture.displaced(splitting))
            }
            Err(error) => Err(error.into()),
        }
    }

    /// The picture of `graph`, of which `pieces` were triangulated.
    fn of<S: Coordinate + Exact>(
        graph: &Pslg<S>,
        pieces: &GraphFile<S>,
        run: Option<(Triangulation, Stats)>,
        crossings: &[Crossing<S>],
        settings: &Asked,
    ) -> Picture {
        let mut domain_refused = None;
        let mut shown = Shown::default();
        let mut all = pieces.remarks.clone();
        if let Some((result, _)) = &run {
            let domain = settings.domain(pieces, result).transpose();
            let domain = domain.unwrap_or_else(|error| {
                domain_refused = Some(pieces.interior_as_numbered(error).to_string());
                None
            });
            let is_drawn = |t| domain.as_ref().is_none_or(|domain| domain.is_inside(t));
            shown = Shown::new(result, is_drawn);
            all.extend(remarks(pieces, result, domain.as_ref()));
        }
        let summary = Summary {
            points: graph.points.len(),
            vertices: pieces.graph.points.len(),
            edges: graph.edges.len(),
            triangles: shown.triangles.len(),
            inner: shown.inner.len(),
            border: shown.border.len(),
            crossings: crossings.len(),
            displacement: None,
            domain_refused,
            remarks: all.iter().map(Remark::to_string).collect(),
            stats: run.map(|(_, stats)| stats),
        };
        let near = |point: &[S; 2]| point.each_ref().map(S::approx);
        Picture {
            summary,
            vertices: pieces.graph.points.iter().map(near).collect(),
            edges: graph.edges.clone(),
            shown,
            crossings: crossings
                .iter()
                .map(|found| (found.edges, found.point_f64()))
                .collect(),
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
        indices(out, &self.shown.triangles);
        indices(out, &self.shown.inner);
        indices(out, &self.shown.border);
        doubles(out, self.crossings.iter().map(|&(_, near)| near));
        let pairs: Vec<[usize; 2]> = self.crossings.iter().map(|&(edges, _)| edges).collect();
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
