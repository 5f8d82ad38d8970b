//! Features of `GeoJSON`: places that a report names, for a map.
//!
//! Each feature has one geometry of one kind, since many programs of maps do not read collections of several kinds.
//! Coordinates are the nearest doubles; a geometry with one beyond the doubles is `null`.
//!
//! ```text
//! {"type": "FeatureCollection", "features": [
//! {"type":"Feature","properties":{...},"geometry":{"type":"Point","coordinates":[1.5,2]}}]}
//! ```
//!
//! Cost: linear in what is written.

use std::io::{self, Write};

use serde::Serialize;
use serde_json::value::RawValue;

use super::json::json_coordinate;

/// A place: points, lines, or polygons, each an outline and its holes as rings that are not closed; all in the coordinates
/// of their vertices.
pub(super) enum Shape {
    Points(Vec<[f64; 2]>),
    Lines(Vec<Vec<[f64; 2]>>),
    Polygons(Vec<Vec<Vec<[f64; 2]>>>),
}

#[derive(Serialize)]
struct Feature<P> {
    r#type: &'static str,
    properties: P,
    geometry: Option<Geometry>,
}

#[derive(Serialize)]
#[serde(tag = "type", content = "coordinates")]
enum Geometry {
    Point(Position),
    MultiPoint(Vec<Position>),
    LineString(Vec<Position>),
    MultiLineString(Vec<Vec<Position>>),
    Polygon(Vec<Vec<Position>>),
    MultiPolygon(Vec<Vec<Vec<Position>>>),
}

type Position = [Box<RawValue>; 2];

/// Writes a collection of features, each with its properties and its place.
pub(super) fn write_features<P: Serialize>(
    features: impl Iterator<Item = (P, Shape)>,
    out: &mut impl Write,
) -> io::Result<()> {
    out.write_all(b"{\"type\": \"FeatureCollection\", \"features\": [")?;
    write_list(features, out)
}

/// Writes the list of features, and the end of the collection.
pub(super) fn write_list<P: Serialize>(
    features: impl Iterator<Item = (P, Shape)>,
    out: &mut impl Write,
) -> io::Result<()> {
    for (at, (properties, shape)) in features.enumerate() {
        out.write_all(if at == 0 { b"\n" } else { b",\n" })?;
        let feature = Feature {
            r#type: "Feature",
            properties,
            geometry: geometry(shape),
        };
        serde_json::to_writer(&mut *out, &feature)?;
    }
    out.write_all(b"]}\n")
}

/// The geometry of a shape; `None`, if the shape is empty or a coordinate is not finite.
fn geometry(shape: Shape) -> Option<Geometry> {
    Some(match shape {
        Shape::Points(points) => {
            let mut points = positions(points)?;
            match points.len() {
                0 => return None,
                1 => Geometry::Point(points.remove(0)),
                _ => Geometry::MultiPoint(points),
            }
        }
        Shape::Lines(lines) => {
            let lines: Option<Vec<_>> = lines.into_iter().map(positions).collect();
            let mut lines = lines?;
            match lines.len() {
                0 => return None,
                1 => Geometry::LineString(lines.remove(0)),
                _ => Geometry::MultiLineString(lines),
            }
        }
        Shape::Polygons(polygons) => {
            let closed = |mut ring: Vec<[f64; 2]>| {
                ring.extend(ring.first().copied());
                positions(ring)
            };
            let rings = |rings: Vec<Vec<[f64; 2]>>| rings.into_iter().map(closed).collect();
            let polygons: Option<Vec<_>> = polygons.into_iter().map(rings).collect();
            let mut polygons = polygons?;
            match polygons.len() {
                0 => return None,
                1 => Geometry::Polygon(polygons.remove(0)),
                _ => Geometry::MultiPolygon(polygons),
            }
        }
    })
}

fn positions(points: Vec<[f64; 2]>) -> Option<Vec<Position>> {
    let position = |point: [f64; 2]| {
        let is_finite = point.iter().all(|x| x.is_finite());
        is_finite.then(|| point.each_ref().map(json_coordinate))
    };
    points.into_iter().map(position).collect()
}
