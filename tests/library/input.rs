//! Points and edges in other forms give the result of the same arrays.

use sweep_cdt::{Error, Triangulation, triangulate, triangulate_from};

const POINTS: [(i32, i32); 6] = [(0, 0), (7, 1), (8, 6), (1, 5), (4, 3), (4, 3)];

#[track_caller]
fn check(found: Result<Triangulation, Error>) {
    let points = POINTS.map(|(x, y)| [x, y]);
    let expected = triangulate(&points, &[[0, 4], [4, 2]]).expect("edges that do not cross");
    let found = found.expect("the same input");
    assert_eq!(found.canonical_triangles(), expected.canonical_triangles());
    let sides = |result: &Triangulation| result.constrained_sides().count();
    assert_eq!(sides(&found), sides(&expected));
    assert_eq!(found.duplicates().collect::<Vec<_>>(), [[5, 4]]);
}

#[test]
fn tuples_arrays_and_numbers_of_any_size() {
    let doubles = POINTS.map(|(x, y)| (f64::from(x), f64::from(y)));
    check(triangulate_from(doubles, [(0_u32, 4), (4, 2)]));
    check(triangulate_from(doubles, [[0_usize, 4], [4, 2]]));
    check(triangulate_from(
        doubles.map(<[f64; 2]>::from),
        vec![(0, 4), (4, 2)],
    ));
    check(triangulate_from(POINTS.to_vec(), [[0_u16, 4], [4, 2]]));
    let wide = POINTS.iter().map(|&(x, y)| [i128::from(x), i128::from(y)]);
    check(triangulate_from(wide, [(0_u64, 4), (4, 2)]));
    let numbers = POINTS.map(|(x, y)| [x, y]);
    check(triangulate_from(
        numbers.each_ref().map(|[x, y]| (x, y)),
        [(0_u8, 4), (4, 2)],
    ));
}

#[test]
fn ends_that_are_no_points_are_refused() {
    let edge = |end: i64| triangulate_from(POINTS, [(0, end)]).map(|result| result.len());
    let refused = |vertex| Err(Error::EdgeOutOfRange { edge: 0, vertex });
    assert_eq!(edge(6), refused(6));
    assert_eq!(edge(-1), refused(usize::MAX));
    assert_eq!(
        triangulate_from(POINTS, [[0; 2]; 0]).map(|result| result.len()),
        Ok(4)
    );
}
