//! Small named inputs: every situation of the paper and every trap that is known.
//!
//! Each goes through every run, and what comes out is compared with the oracle. The table is in
//! `cases/table.rs`; a few results are spelled out here.

mod table;

use sweep_cdt::{Counters, Error, Heuristics, Triangulator, triangulate};

use sweep_cdt_testing::minimize;
use sweep_cdt_testing::oracle::{check, verdict};
use sweep_cdt_testing::{Input, counted};

use crate::runs;
use table::{CASES, PAPER};

fn input(name: &str) -> Input {
    let case = CASES.iter().chain(PAPER).find(|case| case.0 == name);
    let (_, points, edges) = case.unwrap_or_else(|| panic!("no case {name}"));
    Input::parse(points, edges)
}

/// All of the table: names and inputs.
pub(crate) fn all() -> impl Iterator<Item = (&'static str, Input)> {
    let rows = PAPER.iter().chain(CASES);
    rows.map(|(name, points, edges)| (*name, Input::parse(points, edges)))
}

#[test]
fn every_case_in_every_run() {
    let runs = runs::all();
    let failed: Vec<&str> = PAPER
        .iter()
        .chain(CASES)
        .filter(|(name, points, edges)| {
            println!("{name}");
            let agree = |input: &Input| {
                runs::assert_agree(input, &verdict(&input.points, &input.edges), &runs);
            };
            minimize::fails(&agree, &Input::parse(points, edges))
        })
        .map(|case| case.0)
        .collect();
    assert!(failed.is_empty(), "these failed: {failed:#?}");
}

#[test]
fn each_name_is_used_once() {
    let mut names: Vec<&str> = PAPER.iter().chain(CASES).map(|case| case.0).collect();
    names.sort_unstable();
    assert!(names.is_sorted_by(|a, b| a < b), "{names:?}");
}

/// Whether the paper's situations occur where the table says they do.
#[test]
fn the_papers_situations_occur() {
    let with = |heuristics, name| -> Counters {
        let Input { points, edges } = input(name);
        let triangulator = Triangulator::new().heuristics(heuristics);
        let result = counted(&triangulator, &points, &edges);
        result.expect("a valid case").stats.counters
    };
    let paper = |name| with(Heuristics::PAPER, name);
    assert_eq!(paper("figure 7: middle case").left_cases, 0);
    assert_eq!(paper("figure 8: left case").left_cases, 1);
    assert!(
        paper("figure 9: fill while the angle is below pi/2")
            .made
            .narrow_corners
            >= 1
    );
    assert!(paper("figure 10: basin").made.basins >= 1);
    assert_eq!(paper("figure 11: first pierced triangle").pierced, 2);
    // Without the heuristics the front stays as the figures draw it.
    let off = |name| with(Heuristics::OFF, name);
    let traversal = off("figure 12: upper and lower pseudo-polygon");
    assert!(traversal.pierced >= 9, "{traversal:?}");
    let above = off("figure 13: edge above the front");
    assert!(above.pierced == 0 && above.made.pockets >= 1, "{above:?}");
    let through = off("figure 14: edge through teeth of the front");
    assert!(
        through.pierced >= 1 && through.made.pockets >= 1,
        "{through:?}"
    );
    assert!(off("figure 15: upper hull").made.hull >= 1);
    assert!(off("figure 15: lower hull").symbolic >= 1);
    assert!(off("edge that is there already").edges_present >= 1);
    assert!(off("lattice of three by three").cocircular >= 1);
}

#[test]
fn a_square_is_cut_from_its_upper_left_corner() {
    let square = [[0, 0], [1, 0], [1, 1], [0, 1]];
    let result = triangulate(&square, &[]).unwrap();
    assert_eq!(result.canonical_triangles(), [[0, 1, 3], [1, 2, 3]]);
    assert_eq!(result.hull().collect::<Vec<_>>(), [3, 0, 1, 2]);
    let result = triangulate(&square, &[[0, 2]]).unwrap();
    assert_eq!(result.canonical_triangles(), [[0, 1, 2], [0, 2, 3]]);
    assert_eq!(result.constrained_sides().count(), 1);
}

#[test]
fn an_edge_through_vertices_is_split() {
    let points = [[0, 0], [1, 1], [2, 2], [3, 3], [0, 3], [3, 0]];
    let result = triangulate(&points, &[[0, 3], [2, 1]]).unwrap();
    assert_eq!(result.edge_chain(0).collect::<Vec<_>>(), [0, 1, 2, 3]);
    assert_eq!(result.edge_chain(1).collect::<Vec<_>>(), [2, 1]);
    assert_eq!(result.constrained_sides().count(), 3);
    assert_eq!(
        result.canonical_triangles(),
        [
            [0, 1, 4],
            [0, 5, 1],
            [1, 2, 4],
            [1, 5, 2],
            [2, 3, 4],
            [2, 5, 3]
        ]
    );
}

#[test]
fn duplicates_go_by_their_lowest_index() {
    let points = [[0.0, 0.0], [2.0, 0.0], [-0.0, 0.0], [1.0, 2.0], [2.0, -0.0]];
    let result = triangulate(&points, &[[2, 4], [2, 0]]).unwrap();
    assert_eq!(result.canonical_triangles(), [[0, 1, 3]]);
    assert_eq!(result.duplicates().collect::<Vec<_>>(), [[2, 0], [4, 1]]);
    assert_eq!(result.edge_chain(0).collect::<Vec<_>>(), [0, 1]);
    assert_eq!(result.edge_chain(1).collect::<Vec<_>>(), [0]);
}

#[test]
fn crossing_edges_are_named() {
    let points = [[0, 0], [4, 4], [0, 4], [4, 0], [9, 9], [9, 0]];
    let error = triangulate(&points, &[[4, 5], [0, 1], [2, 3]]).unwrap_err();
    assert_eq!(error, Error::CrossingEdges { edges: [1, 2] });
}

#[test]
fn a_raster_needs_no_flip() {
    let points: Vec<[i32; 2]> = (0..100).map(|i| [i % 10, i / 10]).collect();
    for heuristics in [Heuristics::FAST, Heuristics::PAPER, Heuristics::OFF] {
        let run = counted(&Triangulator::new().heuristics(heuristics), &points, &[]).unwrap();
        assert_eq!(
            (run.triangulation.len(), run.stats.counters.flips),
            (162, 0),
            "{heuristics:?}"
        );
    }
}

/// Closed corner by corner, these would take flips by the square of the number of points.
#[test]
fn long_convex_chains_take_few_flips() {
    let n = 2000_i32;
    let parabola: Vec<[i64; 2]> = (-n / 2..n / 2)
        .map(i64::from)
        .map(|x| [1000 * i64::from(n) * x, x * x])
        .collect();
    // The parabola as a pocket under an edge from its first to its last point, and as the upper hull.
    let last = parabola.len() - 1;
    let cubic: Vec<[i64; 2]> = (0..i64::from(n))
        .map(|x| [x * 1_000_000, x * x * x / 1000])
        .collect();
    for (points, edges) in [
        (&parabola, vec![[0, last]]),
        (&parabola, vec![]),
        (&cubic, vec![]),
    ] {
        for heuristics in [Heuristics::FAST, Heuristics::OFF] {
            let run = counted(&Triangulator::new().heuristics(heuristics), points, &edges);
            let flips = run.expect("no edges cross").stats.counters.flips;
            assert!(
                flips < 4 * points.len() as u64,
                "{flips} flips for {} points",
                points.len()
            );
        }
    }
}

/// How many points a side of the grid has.
const GRID: u32 = 12;

#[test]
fn a_grid_of_edges() {
    let points: Vec<[f64; 2]> = (0..GRID * GRID)
        .map(|i| [i / GRID, i % GRID].map(f64::from))
        .collect();
    let at = |x: u32, y: u32| (x * GRID + y) as usize;
    let columns = (0..GRID).map(|x| [at(x, 0), at(x, GRID - 1)]);
    let rows = (0..GRID).map(|y| [at(GRID - 1, y), at(0, y)]);
    let edges: Vec<[usize; 2]> = columns.chain(rows).collect();
    let input = Input { points, edges };
    let result = triangulate(&input.points, &input.edges).unwrap();
    let answer = check(&input.points, &input.edges, &result);
    assert_eq!(answer.constrained.len(), 2 * (GRID * (GRID - 1)) as usize);
    for run in runs::all() {
        assert_eq!(
            run.outcome(&input),
            Some(Ok(answer.clone())),
            "{}",
            run.name
        );
    }
}
