//! Violations as `GeoJSON`: where a result is wrong, for a map.
//!
//! The triangles that a violation names are polygons. Of a violation without triangles the edges or the side are lines,
//! and of one without these the vertices are points.
//!
//! Cost: linear in the violations that are written.

use std::io::{self, Write};

use serde::Serialize;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::verify::{Depth, Offenders, Violation};

use super::features::{Shape, write_features};
use crate::{Coordinate, GraphFile, Triangles};

/// The properties of a feature, with all things numbered as in their files.
#[derive(Serialize)]
struct Properties {
    name: &'static str,
    message: String,
    depth: Option<f64>,
    vertices: Vec<usize>,
    edges: Vec<usize>,
    triangles: Vec<usize>,
}

/// Writes violations of a result for `file` as `GeoJSON`: a feature each, with the properties `name`, `message` and
/// `depth`, and the numbers of `vertices`, `edges` and `triangles`.
///
/// ```
/// use sweep_cdt::Pslg;
/// use sweep_cdt::verify::verify;
/// use sweep_cdt_formats::{Format, Source, read_result, write_violations};
///
/// let points = vec![[0.0, 0.0], [3.0, 0.0], [0.0, 3.0], [1.0, 1.0]];
/// let input = Pslg { points, ..Pslg::default() }.into();
/// let source = Source::new("r.json", b"{\"triangles\": [[0, 1, 2]]}".to_vec());
/// let triangles = read_result(Format::Json, &source, None, &input)?;
/// let found = verify(&input.graph.points, &[], &triangles.list).unwrap_err();
/// let mut text = Vec::new();
/// write_violations(&input, &triangles, &found.list, &mut text)?;
/// let text = String::from_utf8(text)?;
/// assert!(text.contains("{\"name\":\"unused-point\",\"message\":\"vertex 3 is in no triangle\",\"depth\":null,"));
/// assert!(text.contains("\"geometry\":{\"type\":\"Point\",\"coordinates\":[1,1]}}"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Errors of `out`.
pub fn write_violations<S: Coordinate>(
    file: &GraphFile<S>,
    triangles: &Triangles,
    violations: &[Violation],
    out: &mut impl Write,
) -> io::Result<()> {
    let features = violations.iter().map(|&violation| {
        let numbered = triangles.as_numbered(file, violation);
        let Offenders {
            vertices,
            edges,
            triangles: numbers,
            ..
        } = numbered.offenders();
        let properties = Properties {
            name: violation.name(),
            message: numbered.to_string(),
            depth: violation.depth().map(Depth::get),
            vertices,
            edges,
            triangles: numbers,
        };
        (properties, shape(file, triangles, violation))
    });
    write_features(features, out)
}

/// The place of a violation.
fn shape<S: Coordinate>(file: &GraphFile<S>, triangles: &Triangles, violation: Violation) -> Shape {
    let points = &file.graph.points;
    let place = |v: &usize| points[*v].each_ref().map(Scalar::approx);
    // Corners and ends that do not exist have no place.
    let known = |list: &[usize]| -> Option<Vec<[f64; 2]>> {
        let exist = list.iter().all(|&v| v < points.len());
        exist.then(|| list.iter().map(place).collect())
    };
    let offenders = violation.offenders();
    let corners = offenders.triangles.iter();
    let rings = corners.filter_map(|&t| known(&triangles.list[t]));
    let polygons: Vec<_> = rings.map(|ring| vec![ring]).collect();
    if !polygons.is_empty() {
        return Shape::Polygons(polygons);
    }
    let lines: Vec<_> = match &violation {
        Violation::ExtraBoundary { side, .. }
        | Violation::MissingBoundary { side }
        | Violation::BentBoundary { side, .. }
        | Violation::TangledBoundary { side } => known(side).into_iter().collect(),
        Violation::ConcaveBoundary { vertices, .. } => known(vertices).into_iter().collect(),
        _ => {
            let ends = offenders.edges.iter().map(|&e| &file.graph.edges[e]);
            ends.filter_map(|ends| known(ends)).collect()
        }
    };
    if !lines.is_empty() {
        return Shape::Lines(lines);
    }
    let vertices = triangles.vertices_of(&file.graph, violation);
    Shape::Points(vertices.iter().map(place).collect())
}
