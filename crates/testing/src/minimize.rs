//! A small input out of a large one that fails.

use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};

use crate::Input;

/// Whether `test` panics on the input.
pub fn fails(test: &dyn Fn(&Input), input: &Input) -> bool {
    catch_unwind(AssertUnwindSafe(|| test(input))).is_err()
}

/// Drops edges and points as long as `test` panics on what is left: many at a time first, then fewer.
pub fn minimize(test: &dyn Fn(&Input), input: &Input) -> Input {
    let mut least = input.clone();
    let mut many = least.points.len().max(least.edges.len());
    while many > 0 {
        let before = least.points.len() + least.edges.len();
        let fails = &mut |input: &Input| fails(test, input);
        drop_runs(&mut least, many, |i| i.points.len(), without_points, fails);
        drop_runs(&mut least, many, |i| i.edges.len(), without_edges, fails);
        if many > 1 || least.points.len() + least.edges.len() == before {
            many /= 2;
        }
    }
    least
}

/// Drops runs of things of a given length, one after the other, as long as what is left `fails` too.
pub(crate) fn drop_runs<T: Clone>(
    least: &mut T,
    many: usize,
    count: fn(&T) -> usize,
    without: fn(&mut T, Range<usize>),
    fails: &mut dyn FnMut(&T) -> bool,
) {
    let mut at = 0;
    while at < count(least) {
        let mut smaller = least.clone();
        without(&mut smaller, at..(at + many).min(count(least)));
        if fails(&smaller) {
            *least = smaller;
        } else {
            at += many;
        }
    }
}

fn without_edges(input: &mut Input, range: Range<usize>) {
    input.edges.drain(range);
}

/// Drops some points and the edges that end there.
fn without_points(input: &mut Input, range: Range<usize>) {
    input.points.drain(range.clone());
    let is_out = |v: &usize| range.contains(v);
    let renamed = |v: usize| if v < range.start { v } else { v - range.len() };
    input.edges.retain(|edge| !edge.iter().any(is_out));
    for edge in &mut input.edges {
        *edge = edge.map(renamed);
    }
}

/// Runs `test`; if it panics, says on which seed and on which small input it does, and panics.
pub fn run(test: &dyn Fn(&Input), input: &Input, seed: u64) {
    if fails(test, input) {
        let least = minimize(test, input);
        eprintln!("failed with SWEEP_CDT_SEED={seed} on\n{input}\nand on\n{least}");
        test(&least);
        unreachable!("the smallest input that fails does not fail");
    }
}

#[test]
fn finds_the_two_points_and_the_edge_to_blame() {
    let input = Input::parse(
        "0 0, 1 0, 2 0, 3 0, 4 0, 5 0, 6 0, 7 0, 8 0",
        "0 1, 3 7, 7 8",
    );
    let joins = |input: &Input| {
        let has = |x: f64, v: usize| input.points[v][0].total_cmp(&x).is_eq();
        assert!(!input.edges.iter().any(|&[a, b]| has(3.0, a) && has(7.0, b)));
    };
    let least = minimize(&joins, &input);
    assert_eq!(least.to_string(), r#"("name", "3.0 0.0, 7.0 0.0", "0 1"),"#);
}
