//! STL: triangles by coordinates of single precision, or printed ones.
//!
//! What must be read of a binary file: if all corners are points of the input, these. Else each corner must be one point
//! of the input rounded to single precision, and no other one; or the file is refused. Of a text whose corners are
//! printed with different numbers of digits: what is one vertex has one place.

use sweep_cdt::{Pslg, triangulate};
use sweep_cdt_formats::{Format, GraphFile, Matched, read_result};

use super::numbers::{Form, Kind, Order};
use crate::formats::again::source;

/// Points, some of which may have a neighbour that is the same in single precision, and their triangulation.
pub(super) fn judge(mut points: Vec<[f64; 2]>, [style, which, height]: [u8; 3]) {
    let twin = points.get(usize::from(which)).or(points.first()).copied();
    if let Some(mut twin) = twin.filter(|_| style & 3 == 0) {
        let axis = usize::from(style >> 2 & 1);
        twin[axis] = twin[axis].next_up();
        points.extend(twin.iter().all(|x| x.is_finite()).then_some(twin));
    }
    if style >> 3 & 1 == 0 {
        // No numbers of single precision, most of them.
        points.iter_mut().flatten().for_each(|x| *x *= 0.7);
    }
    let result = triangulate(&points, &[]).expect("there are no edges");
    let triangles: Vec<[usize; 3]> = result.triangles().collect();
    let file = stl(&points, &triangles, style, f64::from(height));

    let input = GraphFile::from(Pslg {
        points,
        ..Pslg::default()
    });
    let points = &input.graph.points;
    let corners = triangles
        .as_flattened()
        .iter()
        .map(|&v| points[v].map(single));
    let corners: Vec<[f64; 2]> = corners.collect();
    let is_point = |corner: &[f64; 2]| points.contains(corner);
    let only = |corner: &[f64; 2]| {
        let mut near = points.iter().filter(|p| p.map(single) == *corner);
        let first = near.next()?;
        near.all(|p| p == first).then_some(*first)
    };
    let is_exact = corners.iter().all(is_point);
    let expected: Option<Vec<[f64; 2]>> = match is_exact {
        true => Some(corners.clone()),
        false => corners.iter().map(only).collect(),
    };
    let is_finite = corners.as_flattened().iter().all(|x| x.is_finite());
    let expected = expected.filter(|_| is_finite);
    judge_printed(&input, &triangles, style);
    let read = read_result(Format::Stl, &source(&file), None, &input);
    let found = read.as_ref().ok().map(|read| {
        let list = read.list.as_flattened().iter();
        list.map(|&v| points[v]).collect::<Vec<_>>()
    });
    assert_eq!(found, expected, "{read:?} of {corners:?} for {points:?}");
    let Ok(read) = read else { return };
    let is_equal = read.matched == Matched::Equal;
    assert_eq!(is_equal, is_exact, "{read:?} of {corners:?} for {points:?}");
}

/// Triangles as text, in which every second one has one more digit.
fn judge_printed(input: &GraphFile<f64>, triangles: &[[usize; 3]], style: u8) {
    let digits = 6 + usize::from(style >> 5);
    let mut places = Vec::new();
    let mut text = "solid a\n".to_owned();
    for (t, corners) in triangles.iter().enumerate() {
        text += "facet normal 0 0 1\nouter loop\n";
        for &v in corners {
            let [x, y] = input.graph.points[v].map(|x| format!("{x:.*e}", digits - 1 + t % 2));
            text += &format!("vertex {x} {y} 0\n");
            places.push([x, y].map(|x| x.parse::<f64>().expect("a number")));
        }
        text += "endloop\nendfacet\n";
    }
    text += "endsolid a\n";
    let read = read_result(Format::Stl, &source(text.as_bytes()), None, input);
    let Ok(read) = read else { return };
    let mut place_of = vec![None; input.graph.points.len()];
    for (&v, place) in read.list.as_flattened().iter().zip(&places) {
        let first = *place_of[v].get_or_insert(place);
        assert_eq!(first, place, "vertex {v} at two places: {text}");
    }
}

/// A file; the normals and the two bytes after each triangle mean nothing.
fn stl(points: &[[f64; 2]], triangles: &[[usize; 3]], style: u8, height: f64) -> Vec<u8> {
    let form = |kind| Form {
        kind,
        order: Order::LeastSignificantFirst,
    };
    // Some programs begin as a text does.
    let title: &[u8] = if style >> 4 & 1 == 0 { b"solid" } else { b"" };
    let mut file = title.to_vec();
    file.resize(80, b' ');
    form(Kind::U32).put_indices(&[triangles.len()], &mut file);
    for corners in triangles {
        let put = |x: f64, file: &mut Vec<u8>| form(Kind::F32).put(x, file);
        [0.0, -0.5, 1.0].into_iter().for_each(|x| put(x, &mut file));
        for point in corners.map(|v| points[v]) {
            point.into_iter().for_each(|x| put(x, &mut file));
            put(height, &mut file);
        }
        file.extend([style; 2]);
    }
    file
}

/// The nearest number of single precision.
#[expect(clippy::cast_possible_truncation, reason = "this is meant")]
fn single(x: f64) -> f64 {
    f64::from(x as f32)
}
