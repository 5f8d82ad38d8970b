//! WKT and `GeoJSON`: points, lines, and polygons with holes, alone or several together, in collections or not.

use arbitrary::{Result, Unstructured};
use sweep_cdt::{Pslg, triangulate};
use sweep_cdt_formats::{Format, Input, read, read_result};
use sweep_cdt_testing::generators;

use super::shapes_text::{Kind, Shape, Third, geojson, height, wkt};
use crate::formats::again::{as_heights, heights, source};

/// The triangles of a generated input, with other geometries or without, in both formats.
pub(super) fn judge(style: u8, bytes: &mut Unstructured<'_>) -> Result<()> {
    let words: [[u8; 4]; 3] = bytes.arbitrary()?;
    let points = generators::read(bytes)?.points;
    if points.is_empty() {
        return Ok(());
    }
    let result = triangulate(&points, &[]).expect("there are no edges");
    let polygon = |t: [usize; 3]| vec![[&t[..], &t[..1]].concat()];
    let mut shapes = vec![Shape {
        kind: Kind::Polygons,
        parts: result.triangles().map(polygon).collect(),
        third: Third::Nothing,
    }];
    // Holes of triangles, and other geometries.
    for [kind, first, count, third] in words {
        shape(&mut shapes, [kind, first, count, third], points.len());
    }
    shapes.retain(|shape| !shape.parts.is_empty());
    let order = if style & 1 == 0 { 0 } else { shapes.len() / 2 };
    shapes.rotate_left(order);
    let is_collection = style & 2 != 0;
    let file = wkt(&shapes, &points, is_collection, style >> 2);
    compare("wkt", &file, &shapes, &points);
    shapes.iter_mut().for_each(|shape| {
        if shape.third == Third::Measure {
            shape.third = Third::Nothing;
        }
    });
    let file = geojson(&shapes, &points, is_collection, style >> 2);
    compare("geojson", &file, &shapes, &points);
    Ok(())
}

/// Adds a geometry of some points in a row, or a hole to a polygon, or nothing.
fn shape(shapes: &mut Vec<Shape>, [kind, first, count, third]: [u8; 4], points: usize) {
    let list = |from: u8, count: usize| -> Vec<usize> {
        let from = usize::from(from);
        (from..from + count).map(|v| v % points).collect()
    };
    let third = [Third::Nothing, Third::Height, Third::Measure][usize::from(third % 3)];
    let count = usize::from(count % 8);
    let mut add = |kind, parts| shapes.push(Shape { kind, parts, third });
    match kind % 8 {
        0 => add(Kind::Points, vec![vec![list(first, 1 + count)]]),
        1 => add(
            Kind::Lines,
            vec![vec![list(first, 2 + count), list(first / 2, 2)]],
        ),
        2 => add(Kind::Polygons, vec![vec![list(first, 3 + count)]]),
        3 => add(
            Kind::Polygons,
            vec![vec![list(first, 4), list(first / 2, 3 + count)]],
        ),
        4 => {
            if let Some(parts) = shapes[0].parts.get_mut(usize::from(first)) {
                parts.push(list(first, 3 + count));
            }
        }
        _ => shapes[0].third = third,
    }
}

/// Panics unless the file reads as the positions and lines that it means, and as its triangles if it has no other
/// polygons.
fn compare(name: &str, file: &str, shapes: &[Shape], points: &[[f64; 2]]) {
    let mut meant: Pslg<f64> = Pslg::default();
    let mut meant_heights = Vec::new();
    let mut corners = Some(Vec::new());
    // Whether each ring is a hole, and the ring of each edge.
    let (mut rings, mut ring_of) = (Vec::new(), Vec::new());
    for shape in shapes {
        for (at, part) in shape
            .parts
            .iter()
            .flat_map(|parts| parts.iter().enumerate())
        {
            let mut place = |v: &usize| {
                let place = meant.points.iter().position(|p| *p == points[*v]);
                let place = place.unwrap_or_else(|| {
                    meant.points.push(points[*v]);
                    meant_heights.push(f64::NAN);
                    meant.points.len() - 1
                });
                // The first height that the place is given.
                if shape.third == Third::Height && meant_heights[place].is_nan() {
                    meant_heights[place] = height(*v);
                }
                place
            };
            let places: Vec<usize> = part.iter().map(&mut place).collect();
            if shape.kind != Kind::Points {
                meant
                    .edges
                    .extend(places.windows(2).map(|pair| [pair[0], pair[1]]));
            }
            let [first, last] = [places[0], places[places.len() - 1]];
            if shape.kind == Kind::Polygons {
                meant.edges.extend((first != last).then_some([last, first]));
                let is_closed = usize::from(places.len() > 1 && first == last);
                let ring = &part[..part.len() - is_closed];
                corners = corners.filter(|_| at == 0 && ring.len() == 3);
                corners
                    .iter_mut()
                    .for_each(|list| list.extend(ring.iter().map(|&v| points[v])));
                rings.push(at > 0);
            }
            let ring = (shape.kind == Kind::Polygons).then(|| rings.len() - 1);
            ring_of.resize(meant.edges.len(), ring);
        }
    }
    let format = Format::named(name, Format::INPUTS).expect("a format");
    let found = match read(format, &source(file.as_bytes()), None) {
        Ok(Input::Doubles(found)) => found,
        other => panic!("{other:?}: {file}"),
    };
    assert_eq!(found.graph.points, meant.points, "{file}");
    assert_eq!(found.graph.edges, meant.edges, "{file}");
    let expected = as_heights(meant_heights, meant.points.len());
    assert_eq!(heights(&found), expected, "{file}");
    let found_rings: Vec<bool> = found
        .polygons
        .rings
        .iter()
        .map(|ring| ring.is_hole)
        .collect();
    assert_eq!(found_rings, rings, "{file}");
    if !rings.is_empty() {
        assert_eq!(found.polygons.ring_of, ring_of, "{file}");
    }
    let outlines = rings.iter().filter(|is_hole| !**is_hole).count();
    assert_eq!(found.polygons.features.len(), outlines, "{file}");
    if let Ok(result) = triangulate(&found.graph.points, &found.graph.edges)
        && outlines > 0
    {
        assert!(found.polygons.interior(&result).is_ok(), "{file}");
    }

    let input = Pslg {
        points: points.to_vec(),
        ..Pslg::default()
    };
    let format = Format::named(name, Format::RESULTS).expect("a format");
    let read = read_result(format, &source(file.as_bytes()), None, &input.into());
    let found = read.as_ref().ok().map(|read| {
        let list = read.list.as_flattened().iter();
        list.map(|&v| points[v]).collect::<Vec<_>>()
    });
    assert_eq!(found, corners, "{read:?} of {file}");
}
