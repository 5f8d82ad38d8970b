//! Geometries as WKT and `GeoJSON`.

use std::fmt::Write;

/// Files are written to memory, which takes all of them.
const GROWS: &str = "memory takes it";

/// A geometry: lists of positions, each a point of the input.
#[derive(Debug)]
pub(super) struct Shape {
    pub(super) kind: Kind,
    /// Of polygons the rings of each, the holes behind the first; of all else one list of lists.
    pub(super) parts: Vec<Vec<Vec<usize>>>,
    pub(super) third: Third,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Points,
    Lines,
    Polygons,
}

/// The numbers behind x and y.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Third {
    Nothing,
    Height,
    /// A number that is no coordinate. `GeoJSON` has none.
    Measure,
}

/// The height of a vertex.
pub(super) fn height(v: usize) -> f64 {
    [812.5, 0.0, -1e-7][v % 3]
}

/// The text of all shapes, after each other or in a collection.
pub(super) fn wkt(shapes: &[Shape], points: &[[f64; 2]], is_collection: bool, style: u8) -> String {
    let mut text = String::new();
    for (number, shape) in shapes.iter().enumerate() {
        let separator = if is_collection { ",\n" } else { ";\n" };
        text += if number > 0 { separator } else { "" };
        let is_one = shape.parts.len() == 1;
        let (name, depth) = match shape.kind {
            Kind::Points if is_one && shape.parts[0][0].len() == 1 => ("Point", 1),
            Kind::Points => ("MULTIPOINT", 1),
            Kind::Lines if is_one && shape.parts[0].len() == 1 => ("LINESTRING", 1),
            Kind::Lines => ("MultiLineString", 2),
            Kind::Polygons if is_one => (["POLYGON", "TRIANGLE"][usize::from(style & 1)], 2),
            Kind::Polygons => (["MULTIPOLYGON", "TIN"][usize::from(style & 1)], 3),
        };
        let mark = match (shape.third, style & 2) {
            (Third::Nothing, _) => "",
            (Third::Height, 0) => " Z",
            // The numbers say it.
            (Third::Height, _) => "",
            (Third::Measure, 0) => "M",
            (Third::Measure, _) => " m",
        };
        let position = |&v: &usize| {
            let [x, y] = points[v];
            match shape.third {
                Third::Nothing => format!("{x:?} {y:?}"),
                Third::Height => format!("{x:?}  {y:?} {}", height(v)),
                Third::Measure => format!("{x:?} {y:?} 5"),
            }
        };
        let nested = nested(&shape.parts, depth, ["(", ")"], position);
        write!(text, "{name}{mark} {nested}").expect(GROWS);
    }
    match is_collection {
        true if shapes.is_empty() => "GEOMETRYCOLLECTION EMPTY".to_owned(),
        true => format!("SRID=4326;GEOMETRYCOLLECTION ({text})"),
        false => text,
    }
}

/// The shapes as `GeoJSON`: a collection of geometries, or of features.
pub(super) fn geojson(
    shapes: &[Shape],
    points: &[[f64; 2]],
    is_collection: bool,
    style: u8,
) -> String {
    let mut objects = Vec::new();
    for shape in shapes {
        let is_one = shape.parts.len() == 1 && style & 1 == 0;
        let (name, depth) = match shape.kind {
            Kind::Points => ("MultiPoint", 1),
            Kind::Lines => ("MultiLineString", 2),
            Kind::Polygons if is_one => ("Polygon", 2),
            Kind::Polygons => ("MultiPolygon", 3),
        };
        let position = |&v: &usize| {
            let [x, y] = points[v];
            match shape.third {
                Third::Height => format!("[{x:?}, {y:?}, {:?}]", height(v)),
                _ => format!("[{x:?},{y:?}]"),
            }
        };
        let nested = nested(&shape.parts, depth, ["[", "]"], position);
        let geometry = format!(r#"{{"coordinates": {nested}, "type": "{name}"}}"#);
        objects.push(match is_collection {
            true => geometry,
            false => format!(
                r#"{{"type": "Feature", "properties": {{"type": "Point"}}, "geometry": {geometry}}}"#
            ),
        });
    }
    let (kind, member) = match is_collection {
        true => ("GeometryCollection", "geometries"),
        false => ("FeatureCollection", "features"),
    };
    format!(
        r#"{{"type": "{kind}", "{member}": [{}]}}"#,
        objects.join(",\n")
    )
}

/// The lists of positions in as many brackets as the kind of geometry has.
fn nested(
    parts: &[Vec<Vec<usize>>],
    depth: usize,
    [open, close]: [&str; 2],
    position: impl Fn(&usize) -> String,
) -> String {
    let of = |pieces: Vec<String>| format!("{open}{}{close}", pieces.join(", "));
    let list = |list: &Vec<usize>| of(list.iter().map(&position).collect());
    let lists = |lists: &Vec<Vec<usize>>| of(lists.iter().map(list).collect());
    match depth {
        1 => list(&parts[0][0]),
        2 => lists(&parts[0]),
        _ => of(parts.iter().map(lists).collect()),
    }
}
