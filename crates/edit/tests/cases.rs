//! Edits by name: what is refused, and what closes over.

use sweep_cdt_edit::{DynamicTriangulation, EditError, Edits};
use sweep_cdt_testing::edits::assert_fresh;

fn of(points: &[[i64; 2]], edges: &[[usize; 2]]) -> DynamicTriangulation<i64> {
    let mut made = DynamicTriangulation::new();
    let (points, edges) = (points.to_vec(), edges.to_vec());
    let edits = Edits {
        points,
        edges,
        ..Edits::default()
    };
    made.apply(edits).expect("edges that do not cross");
    made
}

/// A cross: edges go straight through a vertex in its middle.
const CROSS: [[i64; 2]; 5] = [[0, 0], [-2, 0], [2, 0], [0, -2], [0, 2]];

#[test]
fn edges_that_cross_at_a_point_that_goes() {
    let mut cross = of(&CROSS, &[[1, 2], [3, 4]]);
    let before = cross.canonical_triangles();
    let edges = [0, 1];
    assert_eq!(cross.remove(0), Err(EditError::CrossingEdges { edges }));
    assert_eq!(cross.canonical_triangles(), before);
    assert_fresh(&cross, "refused");
    // Without one of them the other closes over the point.
    cross.remove_edge(0).expect("an edge");
    cross.remove(0).expect("a point");
    assert_eq!(cross.edge_chain(1), Some(vec![3, 4]));
    assert_fresh(&cross, "closed over");
}

#[test]
fn an_edge_closes_over_points_that_follow_each_other() {
    let points = [[0, 0], [1, 0], [2, 0], [3, 0], [1, 3], [2, -3]];
    let mut made = of(&points, &[[0, 3], [1, 2], [0, 3]]);
    let remove_edges = vec![1];
    let remove_points = vec![2, 1];
    let edits = Edits {
        remove_edges,
        remove_points,
        ..Edits::default()
    };
    made.apply(edits).expect("a batch");
    assert_eq!(made.edge_chain(0), Some(vec![0, 3]));
    assert_fresh(&made, "two points");
    // The other edge still covers the side.
    made.remove_edge(0).expect("an edge");
    assert_eq!(made.constrained_sides(), [[0, 3]]);
}

#[test]
fn what_is_refused_is_named() {
    let mut cross = of(&CROSS, &[[1, 2]]);
    assert_eq!(cross.remove_edge(1), Err(EditError::NoEdge { edge: 1 }));
    assert_eq!(cross.remove(5), Err(EditError::NoPoint { point: 5 }));
    assert_eq!(
        cross.insert_edge([0, 7]),
        Err(EditError::NoPoint { point: 7 })
    );
    let in_use = EditError::PointInUse { point: 2, edge: 0 };
    assert_eq!(cross.remove(2), Err(in_use));
    let mut doubles = DynamicTriangulation::new();
    let refused = EditError::NonFiniteCoordinate { point: 0 };
    assert_eq!(doubles.insert([0.0, f64::NAN]), Err(refused));
    // The numbers are never used again.
    cross.remove(0).expect("a point");
    assert_eq!(cross.insert([0, 0]), Ok(5));
    assert_eq!(cross.remove(0), Err(EditError::NoPoint { point: 0 }));
    assert_fresh(&cross, "numbers");
}
