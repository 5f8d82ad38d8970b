//! Lists of edges that cross, as CSV, JSON or `GeoJSON`.
//!
//! Edges are numbered as in their file. `x` and `y` are exact: a whole number that is a double, or a
//! fraction. `near_x` and `near_y` are the nearest doubles.
//!
//! ```text
//! edge,other,x,y,near_x,near_y
//! 1,3,1/3,1/2,0.3333333333333333,0.5
//!
//! {"crossings": [
//! {"edges":[1,3],"point":["1/3","1/2"],"near":[0.3333333333333333,0.5]}]}
//!
//! {"type": "FeatureCollection", "features": [
//! {"type":"Feature","properties":{"edge":1,"other":3,"x":"1/3","y":"1/2"},"geometry":{"type":"Point","coordinates":[0.3333333333333333,0.5]}}]}
//! ```
//!
//! Cost: the fraction of a point takes some 20 microseconds.

use std::io::{self, Write};

use num_rational::BigRational;
use serde::Serialize;
use serde_json::value::RawValue;

use super::features::{Shape, write_features};
use super::json::json_coordinate;
use crate::{Coordinate, Format, Numbering};
use sweep_cdt::crossings::{Crossing, Exact};

/// An element of the list.
#[derive(Serialize)]
struct Element {
    edges: [usize; 2],
    point: [Box<RawValue>; 2],
    /// `null` beyond the doubles.
    near: [Option<Box<RawValue>>; 2],
}

/// The properties of a feature.
#[derive(Serialize)]
struct Properties {
    edge: usize,
    other: usize,
    x: String,
    y: String,
}

/// Writes a list of edges that cross, in one of [`Format::CROSSINGS`], numbered as in their file.
///
/// ```
/// use sweep_cdt::crossings::crossings;
/// use sweep_cdt_formats::{Format, Numbering, write_crossings};
///
/// let points = vec![[0.0, 0.0], [3.0, 1.0], [0.0, 1.0], [1.0, 0.0]];
/// let edges = vec![[0, 1], [2, 3]];
/// let mut text = Vec::new();
/// let found = crossings(&points, &edges)?;
/// write_crossings(Format::Csv, Numbering::FROM_ONE, &found, &mut text)?;
/// assert_eq!(text, b"edge,other,x,y,near_x,near_y\n1,2,3/4,1/4,0.75,0.25\n");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Errors of `out`; [`io::ErrorKind::Unsupported`] for another format.
pub fn write_crossings<S: Exact>(
    format: Format,
    numbering: Numbering,
    crossings: &[Crossing<S>],
    out: &mut impl Write,
) -> io::Result<()> {
    match format {
        Format::Csv => {
            writeln!(out, "edge,other,x,y,near_x,near_y")?;
            crossings.iter().try_for_each(|crossing| {
                let [edge, other] = numbering.edges(crossing.edges);
                let [x, y] = crossing.point().each_ref().map(BigRational::text);
                let [near_x, near_y] = crossing.point_f64().map(|x| x.text());
                writeln!(out, "{edge},{other},{x},{y},{near_x},{near_y}")
            })
        }
        Format::Json => {
            out.write_all(b"{\"crossings\": [")?;
            for (at, crossing) in crossings.iter().enumerate() {
                out.write_all(if at == 0 { b"\n" } else { b",\n" })?;
                let element = Element {
                    edges: numbering.edges(crossing.edges),
                    point: crossing.point().each_ref().map(json_coordinate),
                    near: crossing
                        .point_f64()
                        .map(|x| x.is_finite().then(|| json_coordinate(&x))),
                };
                serde_json::to_writer(&mut *out, &element)?;
            }
            out.write_all(b"]}\n")
        }
        Format::Geojson => {
            let features = crossings.iter().map(|crossing| {
                let [edge, other] = numbering.edges(crossing.edges);
                let [x, y] = crossing.point().each_ref().map(BigRational::text);
                let properties = Properties { edge, other, x, y };
                (properties, Shape::Points(vec![crossing.point_f64()]))
            });
            write_features(features, out)
        }
        _ => Err(super::unsupported(format, "list of crossings")),
    }
}
