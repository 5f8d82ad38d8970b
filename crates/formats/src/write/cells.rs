//! Voronoi diagrams: cells as `GeoJSON`, and vertices and ridges as JSON.
//!
//! ```text
//! {"type":"FeatureCollection","features":[
//! {"type":"Feature","properties":{"point":0},"geometry":{"type":"Polygon","coordinates":[[...]]}}]}
//! ```
//!
//! | member of the JSON | one element for each | which is |
//! |---|---|---|
//! | `points` | point of the input | `[x, y]`, or `[x, y, z]` with a height |
//! | `vertices` | Voronoi vertex | `[x, y]` |
//! | `ridge_points` | ridge | the points whose cells it separates, on its left and on its right |
//! | `ridge_vertices` | ridge | its ends, `null` where it has none |
//! | `ridge_directions` | ridge | `[x, y]`, from its first end to its second |
//! | `cells` | point | the vertices around its cell, counter-clockwise |
//!
//! All numbers are positions, from 0; but the property `point` is the number in the file.

use std::io::{self, Write};

use serde::Serialize;

use super::features::{Shape, write_list};
use super::json::{json_coordinate, member, write_input};
use super::shapes::write_system;
use crate::{Coordinate, GraphFile};
use sweep_cdt::Pslg;
use sweep_cdt::scalar::Scalar;

/// The cell of a point.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell<S> {
    /// The point, by position; of equal points the first.
    pub point: usize,
    /// What the cell covers: polygons, each an outline that runs counter-clockwise and its holes.
    pub polygons: Vec<Vec<Vec<[S; 2]>>>,
}

/// The properties of a feature.
#[derive(Serialize)]
struct Properties {
    point: usize,
}

/// Writes cells of the points of a file as `GeoJSON`: a feature each, whose property `point` is the number of the point in
/// the file.
///
/// ```
/// use sweep_cdt_formats::{Cell, GraphFile, write_cells};
///
/// let polygons = vec![vec![vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]]];
/// let mut text = Vec::new();
/// write_cells(&GraphFile::default(), &[Cell { point: 7, polygons }], &mut text)?;
/// let text = String::from_utf8(text).expect("text");
/// assert!(text.contains(r#"{"point":7},"geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1],[0,0]]]}"#));
/// # Ok::<(), std::io::Error>(())
/// ```
///
/// # Errors
/// Errors of `out`.
pub fn write_cells<S: Coordinate>(
    file: &GraphFile<S>,
    cells: &[Cell<S>],
    out: &mut impl Write,
) -> io::Result<()> {
    let near = |ring: &Vec<[S; 2]>| -> Vec<[f64; 2]> {
        let near = |place: &[S; 2]| place.each_ref().map(Scalar::approx);
        ring.iter().map(near).collect()
    };
    let features = cells.iter().map(|cell| {
        let polygons = cell.polygons.iter();
        let polygons = polygons.map(|rings| rings.iter().map(near).collect());
        let point = cell.point + file.numbering.vertex;
        (Properties { point }, Shape::Polygons(polygons.collect()))
    });
    write_system(r#"{"type":"FeatureCollection","#, file.system.as_ref(), out)?;
    out.write_all(br#""features":["#)?;
    write_list(features, out)
}

/// Voronoi vertices, and the ridges and cells between them.
#[derive(Clone, Debug)]
pub struct Ridges<'a, S> {
    /// The places of the vertices.
    pub vertices: &'a [[S; 2]],
    /// The points on both sides of each ridge.
    pub points: Vec<[usize; 2]>,
    /// The ends of each ridge.
    pub ends: Vec<[Option<usize>; 2]>,
    /// The direction of each ridge.
    pub directions: Vec<[S; 2]>,
    /// The vertices around the cell of each point.
    pub cells: &'a [Vec<usize>],
}

/// Writes the diagram of the points of a file as JSON.
///
/// ```
/// use sweep_cdt::Pslg;
/// use sweep_cdt_formats::{Ridges, write_ridges};
///
/// let points = vec![[0.0, 0.0], [4.0, 0.0]];
/// let ridges = Ridges {
///     vertices: &[],
///     points: vec![[0, 1]],
///     ends: vec![[None; 2]],
///     directions: vec![[0.0, 4.0]],
///     cells: &[vec![], vec![]],
/// };
/// let mut text = Vec::new();
/// write_ridges(&Pslg { points, ..Pslg::default() }.into(), &ridges, &mut text)?;
/// assert!(String::from_utf8(text).expect("text").contains("\"ridge_vertices\": [\n[null,null]]"));
/// # Ok::<(), std::io::Error>(())
/// ```
///
/// # Errors
/// Errors of `out`.
pub fn write_ridges<S: Coordinate>(
    file: &GraphFile<S>,
    ridges: &Ridges<'_, S>,
    out: &mut impl Write,
) -> io::Result<()> {
    let place = |place: &[S; 2]| place.each_ref().map(json_coordinate);
    let points = Pslg {
        points: file.graph.points.clone(),
        ..Pslg::default()
    };
    let points = GraphFile {
        columns: file.columns.clone(),
        system: file.system.clone(),
        ..points.into()
    };
    write_input(&points, out)?;
    member(out, "vertices", ridges.vertices.iter().map(place))?;
    member(out, "ridge_points", &ridges.points)?;
    member(out, "ridge_vertices", &ridges.ends)?;
    member(out, "ridge_directions", ridges.directions.iter().map(place))?;
    member(out, "cells", ridges.cells)?;
    out.write_all(b"\n}\n")
}
