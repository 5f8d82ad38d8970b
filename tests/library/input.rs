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

/// Settings and results go from thread to thread, and sessions too.
#[test]
fn public_types_are_send_and_sync() {
    fn assert_both<T: Send + Sync>() {}
    fn assert_copied<T: Copy + Send + Sync>() {}
    assert_copied::<sweep_cdt::Triangulator>();
    assert_copied::<sweep_cdt::Algorithm>();
    assert_copied::<sweep_cdt::Heuristics>();
    assert_copied::<sweep_cdt::Corners>();
    assert_copied::<sweep_cdt::Counters>();
    assert_copied::<sweep_cdt::ByCause>();
    assert_copied::<sweep_cdt::Stats>();
    assert_copied::<sweep_cdt::Error>();
    assert_copied::<sweep_cdt::Location>();
    assert_copied::<sweep_cdt::trace::Event>();
    assert_copied::<sweep_cdt::interior::FillRule>();
    assert_both::<sweep_cdt::Session>();
    assert_both::<sweep_cdt::Triangulation>();
    assert_both::<sweep_cdt::Pslg<f64>>();
    assert_both::<sweep_cdt::Region<f64>>();
    assert_both::<sweep_cdt::VertexStars<'_>>();
    assert_both::<sweep_cdt::WithPoints<'_, f64>>();
    assert_both::<sweep_cdt::crossings::Crossing<f64>>();
    assert_both::<sweep_cdt::crossings::Split<f64>>();
    assert_both::<sweep_cdt::crossings::SplitError>();
    assert_both::<sweep_cdt::interior::Interior<'_>>();
    assert_both::<sweep_cdt::interior::InteriorError>();
    assert_both::<sweep_cdt::interior::Ring>();
    assert_both::<sweep_cdt::interior::Seed>();
    assert_both::<sweep_cdt::front::Front>();
    assert_both::<sweep_cdt::front::FrontInput<'_>>();
    assert_both::<sweep_cdt::front::FrontNode>();
    assert_both::<sweep_cdt::front::HashTable>();
    assert_both::<sweep_cdt::front::SkipList>();
    assert_both::<sweep_cdt::front::Linear>();
    assert_both::<sweep_cdt::front::Work>();
    assert_both::<sweep_cdt::verify::Verifier<'_>>();
    assert_both::<sweep_cdt::verify::Report>();
    assert_both::<sweep_cdt::verify::Violations>();
    assert_both::<sweep_cdt::verify::Violation>();
    assert_both::<sweep_cdt::verify::Depths>();
}
