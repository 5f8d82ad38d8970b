//! Domains: the rules on small inputs with known answers, here; random inputs against ray casting and geometry in
//! exact integers.

mod inside;
mod oracle;
mod polygons;
mod random;
mod seeds;

use sweep_cdt::interior::{FillRule, InteriorError};
use sweep_cdt::triangulate;

/// A square in a square, with room for a second edge through each side.
const SQUARES: [[i64; 2]; 8] = [
    [0, 0],
    [9, 0],
    [9, 9],
    [0, 9],
    [3, 3],
    [6, 3],
    [6, 6],
    [3, 6],
];
const OUTER: [[usize; 2]; 4] = [[0, 1], [1, 2], [2, 3], [3, 0]];
const INNER: [[usize; 2]; 4] = [[4, 5], [5, 6], [6, 7], [7, 4]];

#[test]
fn a_hole_is_a_ring_that_runs_the_other_way() {
    let reversed = INNER.map(|[a, b]| [b, a]);
    for (inner, depth, count) in [(INNER, 2, 10), (reversed, 0, 8)] {
        let edges = [OUTER, inner].concat();
        let result = triangulate(&SQUARES, &edges).unwrap();
        let domain = result.interior(FillRule::NonZero).unwrap();
        assert_eq!(domain.inside().len(), count);
        let in_hole = |t: &usize| result.triangle(*t).iter().all(|v| *v >= 4);
        let holes: Vec<usize> = (0..result.len()).filter(in_hole).collect();
        assert_eq!(holes.len(), 2);
        assert!(holes.iter().all(|&t| domain.depth(t) == depth));
    }
}

#[test]
fn a_ring_given_twice_is_none_for_even_odd() {
    let edges = [OUTER, INNER, INNER].concat();
    let result = triangulate(&SQUARES, &edges).unwrap();
    let domain = result.interior(FillRule::EvenOdd).unwrap();
    assert_eq!(domain.inside().len(), result.len());
    assert_eq!(domain.boundary(), [vec![0, 1, 2, 3]]);
    let edges = [OUTER, INNER, OUTER].concat();
    let result = triangulate(&SQUARES, &edges).unwrap();
    let domain = result.interior(FillRule::EvenOdd).unwrap();
    assert_eq!(domain.boundary(), [vec![4, 5, 6, 7]]);
}

#[test]
fn a_ring_that_meets_itself_stays_with_its_triangles() {
    // Two triangles that share the vertex 2, as one ring and as two.
    let points = [[0, 0], [0, 4], [2, 2], [4, 4], [4, 0]];
    let one = [[0, 2], [2, 4], [4, 3], [3, 2], [2, 1], [1, 0]];
    let two = [[0, 2], [2, 1], [1, 0], [2, 4], [4, 3], [3, 2]];
    for edges in [one, two] {
        let result = triangulate(&points, &edges).unwrap();
        let domain = result.interior(FillRule::EvenOdd).unwrap();
        assert_eq!(domain.boundary(), [vec![0, 2, 1], vec![2, 4, 3]]);
    }
}

#[test]
fn a_hole_that_touches_the_outline_is_part_of_its_chain() {
    let points = [[0, 0], [8, 0], [0, 8], [2, 1], [1, 2]];
    let edges = [[0, 1], [1, 2], [2, 0], [0, 3], [3, 4], [4, 0]];
    let result = triangulate(&points, &edges).unwrap();
    let domain = result.interior(FillRule::EvenOdd).unwrap();
    assert_eq!(domain.boundary(), [vec![0, 1, 2, 0, 4, 3]]);
}

#[test]
fn what_does_not_close_is_named() {
    let open = Some(InteriorError::OpenAtVertex { vertex: 0 });
    let result = triangulate(&SQUARES, &OUTER[1..]).unwrap();
    assert_eq!(result.interior(FillRule::EvenOdd).err(), open);
    assert_eq!(result.interior(FillRule::NonZero).err(), open);
    // Closed, but two of its edges run against the others.
    let turned = [[0, 1], [1, 2], [3, 2], [0, 3]];
    let result = triangulate(&SQUARES, &turned).unwrap();
    assert_eq!(result.interior(FillRule::NonZero).err(), open);
    assert!(result.interior(FillRule::EvenOdd).is_ok());
}

#[test]
fn without_triangles_nothing_is_inside() {
    let line = [[0, 0], [1, 1], [2, 2]];
    let edges = [[0, 2], [2, 1], [1, 0]];
    for points in [&line[..], &[]] {
        let edges = if points.is_empty() { &[] } else { &edges[..] };
        let result = triangulate(points, edges).unwrap();
        for rule in [FillRule::Hull, FillRule::EvenOdd, FillRule::NonZero] {
            let domain = result.interior(rule).unwrap();
            assert_eq!((domain.inside().len(), domain.boundary().len()), (0, 0));
        }
    }
}
