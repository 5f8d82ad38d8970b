//! How good the search structures are: the steps that they leave to the sweep. And that they forget an earlier run.

use std::fmt::Debug;

use num_bigint::BigInt;
use sweep_cdt::front::{FrontInput, FrontSearch, HashTable, Linear, SkipList};
use sweep_cdt::scalar::Scalar;
use sweep_cdt::{Algorithm, Counters, Triangulator, Watch};
use sweep_cdt_testing::{AnyFront, Random, counted, watched};

use crate::statistics::{raster, square};

/// The counters of a run of the sweep with this structure.
fn with_front<S: Scalar>(front: &mut dyn FrontSearch, points: &[[S; 2]]) -> Counters {
    let triangulator = Triangulator::new().algorithm(Algorithm::Sweep);
    let run = watched(&triangulator, points, &[], Watch::new().front(front));
    run.expect("no edges").stats.counters
}

/// How many steps of the walk a structure left, a point.
fn steps_a_point<F: FrontSearch + Default>(points: &[[f64; 2]]) -> f64 {
    let counters = with_front(&mut F::default(), points);
    counters.front_steps as f64 / points.len() as f64
}

/// Random points in a square, x to some odd power: the higher, the more crowd around zero.
fn skewed(power: i32) -> Vec<[f64; 2]> {
    let mut random = Random::new(1);
    let mut at = || [random.integer(1 << 20).powi(power), random.integer(1 << 20)];
    (0..5000).map(|_| at()).collect()
}

#[test]
fn a_skip_list_leaves_no_steps() {
    for points in [skewed(1), skewed(5), raster(5000)] {
        assert!(steps_a_point::<SkipList>(&points) == 0.0);
    }
}

#[test]
fn the_last_node_is_near_where_points_come_in_rows() {
    assert!(steps_a_point::<Linear>(&raster(5000)) < 3.0);
}

#[test]
fn an_input_is_the_vertices() {
    let near = [[3.0, 1.0], [2.0, 5.0]];
    let input = FrontInput::new(&near);
    assert_eq!((input.len(), input.is_empty()), (2, false));
    assert_eq!([0, 1].map(|rank| input.x(rank).to_string()), ["3", "2"]);
    assert!(FrontInput::new(&[]).is_empty());
}

/// A structure that an earlier run has filled works as a new one does.
fn assert_forgets<F: FrontSearch + Clone + Debug>(new: &F) {
    let [large, small] = [70, 10].map(square);
    let count = |mut front: F, points: &[[f64; 2]]| (with_front(&mut front, points), front);
    for [first, second] in [[&large, &small], [&small, &large]] {
        let (_, used) = count(new.clone(), first);
        let (expected, fresh) = count(new.clone(), second);
        let (found, used) = count(used, second);
        assert_eq!(found, expected);
        assert_eq!(format!("{used:?}"), format!("{fresh:?}"));
    }
}

#[test]
fn every_front_forgets_an_earlier_run() {
    assert_forgets(&HashTable::default());
    assert_forgets(&HashTable::counting());
    assert_forgets(&SkipList::default());
    assert_forgets(&SkipList::counting());
    assert_forgets(&Linear::default());
}

/// Steps along the front for each vertex.
fn whole_steps_a_point<F: FrontSearch + Default, S: Scalar>(points: &[[S; 2]]) -> u64 {
    with_front(&mut F::default(), points).front_steps / points.len() as u64
}

/// A fifth of the points in a millionth of the width and height: equal intervals would be crowded.
#[test]
fn a_crowded_fifth_makes_no_walk_longer() {
    let mut points = Random::new(1).points(50_000);
    for point in points.iter_mut().step_by(5) {
        *point = point.map(|x| 0.5 + 1e-6 * x);
    }
    assert!(whole_steps_a_point::<HashTable, _>(&points) < 2);
}

/// A row, whose front is far longer than the square root of the number of points, and points above it far from one
/// another: without more intervals for such a front the walks take 6.7 steps a point.
#[test]
fn a_long_row_makes_no_walk_longer() {
    let row = (0..5000).map(|i| [f64::from(i), 0.0]);
    let above = (0..5000).map(|i| [f64::from(i * 1931 % 5000) + 0.5, f64::from(i) + 1.0]);
    let points: Vec<_> = row.chain(above).collect();
    let steps = steps_a_point::<HashTable>(&points);
    assert!(steps < 1.5, "{steps}");
}

/// The points that the hash table samples lie all over the width, the others in a tiny part of it.
#[test]
fn points_placed_beside_the_sample_make_no_search_long() {
    const COUNT: usize = 60_000;
    let sampled = COUNT.div_ceil(4096);
    let mut points = Random::new(1).points(COUNT);
    points.sort_by(|a, b| a[1].total_cmp(&b[1]));
    for (rank, [x, y]) in points.iter_mut().enumerate() {
        *y *= 1e-9;
        if rank % sampled != 0 {
            *x = 0.5 + 1e-9 * *x;
        }
    }
    let steps = steps_a_point::<HashTable>(&points);
    assert!(steps < 12.0, "{steps} steps a point");
}

/// A row far from most points, where doubles cannot tell its points apart, and points above it.
fn with_equal_doubles() -> Vec<[BigInt; 2]> {
    let far = BigInt::from(1) << 100;
    let row = |i: i32| [&far + 1000 * i, BigInt::from(0)];
    let above = |i: i32| [&far + (i * 7919 % 1000) * 1000 + 500, BigInt::from(1 + i)];
    let near = |i: i32| [i, 10_000 + i * i % 7].map(BigInt::from);
    let mut points: Vec<[BigInt; 2]> = (0..1000).flat_map(|i| [row(i), above(i)]).collect();
    points.extend((0..3000).map(near));
    points
}

/// Long walks spend the budget of flips: divide and conquer takes over.
#[test]
fn where_walks_are_long_the_sweep_is_abandoned() {
    let points = with_equal_doubles();
    let run = counted(&Triangulator::new(), &points, &[]).expect("no edges");
    let steps = run.stats.counters.front_steps;
    assert!(run.stats.is_divided && steps < 20 * points.len() as u64);
    let sweep = Triangulator::new().algorithm(Algorithm::Sweep);
    let sweep = sweep.triangulate(&points, &[]).expect("no edges");
    assert!(run.triangulation.canonical_triangles() == sweep.canonical_triangles());
}

#[test]
fn a_front_has_the_name_by_which_it_is_found() {
    for front in AnyFront::all() {
        let found = AnyFront::named(front.name()).expect("it has this name");
        assert_eq!(format!("{found:?}"), format!("{front:?}"));
    }
    assert!(AnyFront::named("").is_none());
    assert_eq!(AnyFront::default().name(), AnyFront::all()[0].name());
}
