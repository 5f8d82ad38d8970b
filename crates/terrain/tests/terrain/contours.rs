//! Contour lines.

use std::collections::HashMap;

use sweep_cdt::interior::{FillRule, Interior};
use sweep_cdt_generate::Random;
use sweep_cdt_terrain::{Contour, Surface, TooManyPieces};

use crate::{Lattice, below, triangulated};

/// A point of a line as text: sums and quotients of small whole numbers agree in ten digits or are the same.
fn name(point: [f64; 2]) -> String {
    let [x, y] = point.map(|x| if x.abs() < 1e-10 { 0.0 } else { x });
    format!("{x:.10} {y:.10}")
}

/// The pieces of lines, with the higher ground on the left, and how often each is there.
fn pieces(lines: &[Contour]) -> HashMap<(String, String), usize> {
    let mut pieces = HashMap::new();
    for line in lines {
        for step in line.points.windows(2) {
            *pieces.entry((name(step[0]), name(step[1]))).or_default() += 1;
        }
    }
    pieces
}

/// The lines by the definition: the level divides the corners of a triangle in those above, or just there, and those below.
/// `twice` is twice the level.
fn expected(
    lattice: &Lattice,
    triangles: &[([usize; 3], [i64; 3])],
    twice: i64,
) -> HashMap<(String, String), usize> {
    let mut pieces = HashMap::new();
    for (corners, heights) in triangles {
        let above = heights.map(|height| 2 * height >= twice);
        let count = above.iter().filter(|&&above| above).count();
        if count == 0 || count == 3 {
            continue;
        }
        // The corner that is alone on its side of the level, and the two others, counter-clockwise.
        let alone = (0..3)
            .find(|&i| above[i] == (count == 1))
            .expect("one is alone");
        let point = |other: usize| {
            let [(p, zp), (q, zq)] =
                [alone, other].map(|i| (lattice.points[corners[i]], heights[i]));
            let (over, under) = (twice - 2 * zp, 2 * (zq - zp));
            [0, 1].map(|axis| (p[axis] * under + (q[axis] - p[axis]) * over) as f64 / under as f64)
        };
        let [right, left] = [1, 2].map(|step| point((alone + step) % 3));
        // Around a high corner the line runs counter-clockwise, as seen from it.
        let [from, to] = if count == 1 {
            [right, left]
        } else {
            [left, right]
        };
        let piece = (name(from), name(to));
        if piece.0 != piece.1 {
            *pieces.entry(piece).or_default() += 1;
        }
    }
    pieces
}

#[test]
fn lines_have_the_pieces_of_the_definition() {
    let mut random = Random::new(1);
    let (mut closed, mut open, mut ties) = (0, 0, 0);
    for round in 0..3000 {
        let lattice = Lattice::new(&mut random, round % 3 == 0);
        let points = lattice.doubles();
        let result = triangulated(&points);
        let whole = Interior::whole(&result);
        let surface = Surface::new(&points, &whole, &lattice.known());
        let triangles = lattice.triangles(&result);
        for twice in -1..=13 {
            let level = twice as f64 / 2.0;
            let lines = surface.contours(&[level]).expect("few pieces");
            let found = pieces(&lines);
            let wanted = expected(&lattice, &triangles, twice);
            assert_eq!(found, wanted, "round {round}, level {level}");
            closed += lines.iter().filter(|line| line.is_closed()).count();
            open += lines.iter().filter(|line| !line.is_closed()).count();
            ties += usize::from(twice % 2 == 0 && !lines.is_empty());
        }
    }
    assert!(
        closed > 1000 && open > 1000 && ties > 1000,
        "{closed} {open} {ties}"
    );
}

/// Open lines end on sides that only one triangle of the surface has.
#[test]
fn lines_end_at_the_border() {
    let mut random = Random::new(2);
    for round in 0..1000 {
        let lattice = Lattice::new(&mut random, round % 2 == 0);
        let points = lattice.doubles();
        let result = triangulated(&points);
        let whole = Interior::whole(&result);
        let surface = Surface::new(&points, &whole, &lattice.known());
        let mut sides: HashMap<[usize; 2], usize> = HashMap::new();
        for ([a, b, c], _) in lattice.triangles(&result) {
            for [p, q] in [[a, b], [b, c], [c, a]] {
                *sides.entry([p.min(q), p.max(q)]).or_default() += 1;
            }
        }
        sides.retain(|_, count| *count == 1);
        let on_border = |point: [f64; 2]| {
            sides.keys().any(|ends| {
                let [p, q] = ends.map(|v| points[v]);
                let [d, e] = [
                    [q[0] - p[0], q[1] - p[1]],
                    [point[0] - p[0], point[1] - p[1]],
                ];
                let along = d[0] * e[0] + d[1] * e[1];
                let length = d[0] * d[0] + d[1] * d[1];
                (d[0] * e[1] - d[1] * e[0]).abs() < 1e-9 && (-1e-9..length + 1e-9).contains(&along)
            })
        };
        for line in surface.contours(&[0.5, 1.5, 2.5]).expect("few pieces") {
            if !line.is_closed() {
                let ends = [line.points.first(), line.points.last()];
                assert!(
                    ends.iter().all(|end| on_border(*end.expect("points"))),
                    "{round}"
                );
            }
        }
    }
}

/// On a plane a line is straight: every point lies on it exactly but for rounding, and it is one line from border to
/// border.
#[test]
fn lines_on_a_plane_are_straight() {
    let mut random = Random::new(3);
    let points: Vec<[f64; 2]> = (0..2000)
        .map(|_| [0, 1].map(|_| below(&mut random, 1 << 20) as f64 / 1024.0))
        .collect();
    let plane = |[x, y]: [f64; 2]| 0.75 * x - 0.5 * y + 12.0;
    let heights: Vec<f64> = points.iter().map(|point| plane(*point)).collect();
    let result = triangulated(&points);
    let whole = Interior::whole(&result);
    let surface = Surface::new(&points, &whole, &heights);
    let levels: Vec<f64> = (-100..200).map(|at| f64::from(at) * 3.0).collect();
    let lines = surface.contours(&levels).expect("few pieces");
    let [low, high] = surface.range().expect("triangles");
    let crossing = levels.iter().filter(|&level| (low..high).contains(level));
    assert_eq!(lines.len(), crossing.count());
    for line in &lines {
        assert!(!line.is_closed());
        for &[x, y] in &line.points {
            assert!((plane([x, y]) - line.level).abs() < 1e-9, "{x} {y}");
        }
        // The way uphill is (3, -2): along the line both coordinates grow with it on the left.
        for step in line.points.windows(2) {
            assert!(step[0][0] >= step[1][0] - 1e-9 && step[0][1] >= step[1][1] - 1e-9);
        }
    }
}

fn lines_of(points: &[[f64; 2]], heights: &[f64], level: f64) -> Vec<Vec<[f64; 2]>> {
    let result = triangulated(points);
    let whole = Interior::whole(&result);
    let lines = Surface::new(points, &whole, heights).contours(&[level]);
    let lines = lines.expect("few pieces").into_iter();
    lines.map(|line| line.points).collect()
}

const SQUARE: [[f64; 2]; 5] = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [2.0, 2.0]];

#[test]
fn a_peak_at_a_level_has_no_line_and_a_pit_neither() {
    let none: [Vec<[f64; 2]>; 0] = [];
    assert_eq!(lines_of(&SQUARE, &[0.0, 0.0, 0.0, 0.0, 5.0], 5.0), none);
    assert_eq!(lines_of(&SQUARE, &[9.0, 9.0, 9.0, 9.0, 5.0], 5.0), none);
}

#[test]
fn flat_triangles_make_no_area() {
    let none: [Vec<[f64; 2]>; 0] = [];
    assert_eq!(lines_of(&SQUARE, &[5.0; 5], 5.0), none);
    // A plateau of two triangles: one line along its lower border.
    let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [8.0, 2.0]];
    let lines = lines_of(&points, &[5.0, 5.0, 5.0, 5.0, 1.0], 5.0);
    assert_eq!(lines, [vec![[4.0, 0.0], [4.0, 4.0]]]);
}

#[test]
fn a_ridge_at_a_level_is_a_line() {
    let points = [
        [0.0, 0.0],
        [9.0, 0.0],
        [9.0, 6.0],
        [0.0, 6.0],
        [3.0, 3.0],
        [6.0, 3.0],
    ];
    let lines = lines_of(&points, &[0.0, 0.0, 0.0, 0.0, 5.0, 5.0], 5.0);
    // There and back.
    assert_eq!(lines, [[[3.0, 3.0], [6.0, 3.0], [3.0, 3.0]]]);
}

/// Two hills meet in a saddle that is just at the level: each has a line of its own or both have one, and none breaks.
#[test]
fn a_saddle_at_a_level_breaks_no_line() {
    let points = [
        [0.0, 0.0],
        [8.0, 0.0],
        [8.0, 4.0],
        [0.0, 4.0],
        [2.0, 2.0],
        [4.0, 2.0],
        [6.0, 2.0],
    ];
    let lines = lines_of(&points, &[0.0, 0.0, 0.0, 0.0, 9.0, 5.0, 9.0], 5.0);
    assert!(lines.iter().all(|line| line.first() == line.last()));
    // Both hills are inside, and the saddle is on a line twice, where one line goes round both.
    let at_saddle = lines
        .iter()
        .flatten()
        .filter(|point| name(**point) == name([4.0, 2.0]));
    assert_eq!((lines.len(), at_saddle.count()), (1, 2));
}

#[test]
fn missing_heights_and_the_outside_have_no_lines() {
    let none: [Vec<[f64; 2]>; 0] = [];
    assert_eq!(
        lines_of(&SQUARE, &[0.0, 0.0, 0.0, 0.0, f64::NAN], 5.0),
        none
    );
    assert_eq!(
        lines_of(&SQUARE, &[0.0, 0.0, 0.0, 0.0, f64::INFINITY], 5.0),
        none
    );
    assert_eq!(lines_of(&SQUARE, &[], 5.0), none);

    // A slope with a hole in the middle: the line ends at the hole and begins again behind it.
    let mut points = vec![[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0]];
    points.extend([[3.0, 3.0], [6.0, 3.0], [6.0, 6.0], [3.0, 6.0]]);
    let heights: Vec<f64> = points.iter().map(|[x, _]| *x).collect();
    let ring = |first: usize| [0, 1, 2, 3].map(|i| [first + i, first + (i + 1) % 4]);
    let edges = [ring(0), ring(4)].concat();
    let result = sweep_cdt::triangulate(&points, &edges).expect("a correct input");
    let domain = result.interior(FillRule::EvenOdd).expect("closed rings");
    let surface = Surface::new(&points, &domain, &heights);
    let lines = surface.contours(&[4.5]).expect("few pieces");
    let mut ends: Vec<[f64; 2]> = lines
        .iter()
        .flat_map(|line| [line.points[0], line.points[line.points.len() - 1]])
        .collect();
    ends.sort_by(|a, b| a[1].total_cmp(&b[1]));
    assert_eq!(ends, [[4.5, 0.0], [4.5, 3.0], [4.5, 6.0], [4.5, 9.0]]);
}

/// The first of equal points has no height, another has.
#[test]
fn a_height_that_one_of_equal_points_has_counts() {
    let mut points = SQUARE.to_vec();
    points.push([2.0, 2.0]);
    let lines = lines_of(&points, &[0.0, 0.0, 0.0, 0.0, f64::NAN, 10.0], 5.0);
    assert_eq!(lines.len(), 1);
}

#[test]
fn heights_of_any_size_have_lines() {
    for size in [5e-324, 1e-300, 1e300, f64::MAX / 4.0] {
        let lines = lines_of(&SQUARE, &[0.0, 0.0, 0.0, 0.0, 4.0 * size], 2.0 * size);
        assert_eq!(lines.len(), 1, "{size:e}");
        assert!(lines[0].contains(&[1.0, 1.0]), "{size:e}");
    }
    let heights = [-f64::MAX, -f64::MAX, -f64::MAX, -f64::MAX, f64::MAX];
    let lines = lines_of(&SQUARE, &heights, 0.0);
    assert!(lines[0].contains(&[1.0, 1.0]));
    let huge = SQUARE.map(|point| point.map(|x| (x - 2.0) * (f64::MAX / 2.0)));
    let lines = lines_of(&huge, &[0.0, 0.0, 0.0, 0.0, 10.0], 5.0);
    assert!(lines.iter().flatten().flatten().all(|x| x.is_finite()));
}

#[test]
fn lines_beyond_all_memory_are_refused() {
    let points: Vec<[f64; 2]> = (0..400)
        .map(|i| [f64::from(i % 20), f64::from(i / 20)])
        .collect();
    let heights: Vec<f64> = (0..400).map(|i| f64::from(i % 2) * 1e6).collect();
    let result = triangulated(&points);
    let whole = Interior::whole(&result);
    let levels: Vec<f64> = (1..=1_000_000).map(f64::from).collect();
    let refused = Surface::new(&points, &whole, &heights).contours(&levels);
    // 2 * 19 * 19 triangles, each from 0 to a million.
    assert_eq!(
        refused,
        Err(TooManyPieces {
            pieces: 722_000_000
        })
    );
}
