//! The inside alone, in one call: against the whole triangulation, which the oracle judges, and ray casting.

use num_rational::BigRational;
use sweep_cdt::interior::{FillRule, InteriorError};
use sweep_cdt::verify::Verifier;
use sweep_cdt::{Session, Triangulator, triangulate};
use sweep_cdt_testing::oracle::{canonical, check, windings};
use sweep_cdt_testing::{Input, Random, families, runs};

use super::oracle::{Point, Rings, rings};

/// Tried of each kind, unless `SWEEP_CDT_DOMAINS` says otherwise.
const CASES: u64 = 2000;

/// Memory that all cases share, and points of three scalars in it.
#[derive(Debug)]
struct Judge {
    session: Session,
    errors: u32,
}

impl Judge {
    fn new() -> Judge {
        let session = Triangulator::new().session();
        Judge { session, errors: 0 }
    }

    /// By every rule the triangles inside are those that ray casting finds, or the error is that of the whole call.
    fn judge(&mut self, Rings { points, edges }: &Rings) {
        let what = format!("{points:?} {edges:?}");
        let doubles: Vec<[f64; 2]> = points.iter().map(|p| p.map(|x| x as f64)).collect();
        let fractions = runs::convert::<BigRational>(&doubles).expect("fractions hold doubles");
        let whole = triangulate(points, edges);
        if let Ok(result) = &whole {
            check(&doubles, edges, result);
        }
        for rule in [FillRule::EvenOdd, FillRule::NonZero, FillRule::Hull] {
            let expected = match &whole {
                Err(error) => Err(InteriorError::Refused { error: *error }),
                Ok(result) => result.interior(rule).map(|_| {
                    let is_inside = |t: &[usize; 3]| match (rule, windings(points, edges, *t)) {
                        (FillRule::EvenOdd, (crossed, _)) => crossed % 2 == 1,
                        (FillRule::Hull, _) => true,
                        (_, (_, winding)) => winding != 0,
                    };
                    let inside: Vec<_> = result.triangles().filter(is_inside).collect();
                    canonical(result, &inside)
                }),
            };
            self.errors += u32::from(expected.is_err());
            let expected = expected.as_deref().map_err(|error| *error);
            let session = &mut self.session;
            let found = session.triangulate_inside(points, edges, rule);
            assert_eq!(found, expected, "{rule:?}: {what}");
            let found = session.triangulate_inside(&doubles, edges, rule);
            assert_eq!(found, expected, "{rule:?}, doubles: {what}");
            let found = session.triangulate_inside(&fractions, edges, rule);
            assert_eq!(found, expected, "{rule:?}, fractions: {what}");
        }
        // The next call of the other kind works in the same memory.
        let again = self.session.triangulate(points, edges);
        let lists = [
            again.map(|result| result.canonical_triangles()),
            whole.map(|w| w.canonical_triangles()),
        ];
        assert_eq!(lists[0], lists[1], "{what}");
    }
}

/// Returns how many errors there were for a case.
fn for_seeds(test: impl Fn(&mut Random, &mut Judge)) -> f64 {
    let cases = std::env::var("SWEEP_CDT_DOMAINS");
    let cases = cases.map_or(CASES, |text| text.parse().expect("a number"));
    let mut judge = Judge::new();
    for seed in 0..cases {
        test(&mut Random::new(seed), &mut judge);
    }
    f64::from(judge.errors) / cases as f64
}

/// The boundary of some cells of a small lattice, each edge with its cell on the left: rings with holes and islands,
/// which may touch in a point. The lattice is slanted, or its points are moved a little.
fn cells(random: &mut Random) -> Rings {
    let [columns, rows] = [(); 2].map(|()| 1 + random.below(5));
    let full: Vec<bool> = (0..columns * rows).map(|_| !random.one_in(3)).collect();
    let is_full = |x: usize, y: usize| {
        (1..=columns).contains(&x) && (1..=rows).contains(&y) && full[(y - 1) * columns + x - 1]
    };
    // A cell has the number of its upper right corner.
    let corner = |x: usize, y: usize| y * (columns + 1) + x;
    let mut edges = Vec::new();
    for (x, y) in (1..=rows).flat_map(|y| (1..=columns).map(move |x| (x, y))) {
        let corners = [
            corner(x - 1, y - 1),
            corner(x, y - 1),
            corner(x, y),
            corner(x - 1, y),
        ];
        let beyond = [(x, y - 1), (x + 1, y), (x, y + 1), (x - 1, y)];
        for (i, (z, w)) in beyond.into_iter().enumerate() {
            if is_full(x, y) && !is_full(z, w) {
                edges.push([corners[i], corners[(i + 1) % 4]]);
            }
        }
    }
    let mut points: Vec<Point> = (0..(columns + 1) * (rows + 1))
        .map(|i| [i % (columns + 1), i / (columns + 1)].map(|x| 3 * x as i64))
        .collect();
    if random.one_in(3) {
        for point in &mut points {
            *point = point.map(|x| x + random.below(3) as i64 - 1);
        }
    } else {
        leave_out_straight_corners(&points, &mut edges, random);
        let [a, b, c] = [(); 3].map(|()| random.below(5) as i64 - 2);
        points = points
            .iter()
            .map(|&[x, y]| [x + a * y, c * x + (b + a * c) * y])
            .collect();
    }
    named(&points, &edges, random)
}

/// Joins some pairs of edges along one line.
fn leave_out_straight_corners(points: &[Point], edges: &mut Vec<[usize; 2]>, random: &mut Random) {
    for v in 0..points.len() {
        let at = |side: usize| edges.iter().filter(|edge| edge[side] == v).count();
        if at(0) != 1 || at(1) != 1 || random.one_in(2) {
            continue;
        }
        let [[_, to], [from, _]] =
            [0, 1].map(|side| *edges.iter().find(|edge| edge[side] == v).expect("one"));
        let [[ax, ay], [bx, by], [cx, cy]] = [from, v, to].map(|v| points[v]);
        if (bx - ax) * (cy - ay) == (by - ay) * (cx - ax) {
            edges.retain(|edge| !edge.contains(&v));
            edges.push([from, to]);
        }
    }
}

/// The points at which edges end, in a random order.
fn named(points: &[Point], edges: &[[usize; 2]], random: &mut Random) -> Rings {
    let mut used: Vec<usize> = edges.as_flattened().to_vec();
    used.sort_unstable();
    used.dedup();
    random.shuffle(&mut used);
    let name = |v: usize| used.iter().position(|&u| u == v).expect("used");
    let mut edges: Vec<[usize; 2]> = edges.iter().map(|edge| edge.map(name)).collect();
    random.shuffle(&mut edges);
    let points = used.iter().map(|&v| points[v]).collect();
    Rings { points, edges }
}

/// Spoils rings a little: they may touch, overlap or cross then, or be closed no more.
fn spoil(rings: &mut Rings, random: &mut Random) {
    let Rings { points, edges } = rings;
    if edges.is_empty() {
        return;
    }
    let [e, f] = [(); 2].map(|()| random.below(edges.len()));
    let [v, w] = [(); 2].map(|()| random.below(points.len()));
    match random.below(9) {
        0 => edges.push(edges[e]),
        1 => drop(edges.swap_remove(e)),
        2 => edges[e].reverse(),
        3 => points.push([points[v][0], points[w][1]]),
        4 => points[v] = points[w],
        5 => points[v] = [points[w][0] + 1, points[w][1]],
        6 => {
            // One end at an equal point.
            edges[e][1] = points.len();
            points.push(points[v]);
        }
        7 => (edges[e][1], edges[f][1]) = (edges[f][1], edges[e][1]),
        _ => {
            // One ring, or all that hang together, the other way.
            let mut turned = vec![edges[e]];
            while let Some(at) = edges.iter().position(|edge| {
                !turned.contains(edge) && turned.iter().any(|turned| turned[1] == edge[0])
            }) {
                turned.push(edges[at]);
            }
            for edge in edges.iter_mut().filter(|edge| turned.contains(edge)) {
                edge.reverse();
            }
        }
    }
}

#[test]
fn boundaries_of_cells() {
    let errors = for_seeds(|random, judge| judge.judge(&cells(random)));
    assert!(errors <= 0.0, "{errors}");
}

#[test]
fn spoiled_boundaries_of_cells() {
    let errors = for_seeds(|random, judge| {
        let mut rings = cells(random);
        for _ in 0..1 + random.below(2) {
            spoil(&mut rings, random);
        }
        judge.judge(&rings);
    });
    assert!(errors > 0.2, "{errors}");
}

/// Rings through points of a lattice, of which most go through themselves.
#[test]
fn rings_in_any_order() {
    let errors = for_seeds(|random, judge| {
        let (n, size) = (random.below(9), 2 + random.below(6));
        let mut rings = Rings {
            points: Vec::new(),
            edges: Vec::new(),
        };
        for i in 0..n {
            rings
                .points
                .push([(); 2].map(|()| random.below(size) as i64));
            let first = if n > 6 { i / 3 * 3 } else { 0 };
            let is_last = i + 1 == n || n > 6 && i % 3 == 2;
            rings.edges.push([i, if is_last { first } else { i + 1 }]);
        }
        judge.judge(&rings);
    });
    assert!(errors > 0.2, "{errors}");
}

#[test]
fn rings_that_touch_and_overlap() {
    for_seeds(|random, judge| {
        if random.one_in(10) {
            judge.judge(&rings(random));
        }
    });
}

/// Star-shaped polygons, and every family of inputs that are slow for some algorithm.
#[test]
fn larger_polygons() {
    let mut session = Triangulator::new().session();
    let mut inputs: Vec<Input> = families::all().map(|family| (family.member)(150)).collect();
    let mut random = Random::new(1);
    for n in [50, 300, 2000] {
        let corner = |i: usize| {
            let (sin, cos) = (std::f64::consts::TAU * i as f64 / n as f64).sin_cos();
            let radius = 1.0 + random.below(1000) as f64 / 500.0;
            [radius * cos, radius * sin]
        };
        let points: Vec<[f64; 2]> = (0..n).map(corner).collect();
        let edges = (0..n).map(|i| [i, (i + 1) % n]).collect();
        let ring = [(0..n).collect()];
        let Input { points, edges } = Input { points, edges };
        let found = session
            .triangulate_inside(&points, &edges, FillRule::EvenOdd)
            .expect("a star");
        let verifier = Verifier::new().boundary(&ring);
        assert!(verifier.verify(&points, &edges, found).is_ok(), "{n}");
        inputs.push(Input { points, edges });
    }
    for Input { points, edges } in &inputs {
        let expected = triangulate(points, edges).map_err(|error| InteriorError::Refused { error });
        for rule in [FillRule::EvenOdd, FillRule::NonZero] {
            let expected = expected.as_ref().map_err(|error| *error);
            let expected =
                expected.and_then(|result| Ok(result.interior(rule)?.canonical_triangles()));
            let found = session.triangulate_inside(points, edges, rule);
            assert_eq!(found, expected.as_deref().map_err(|error| *error));
        }
    }
}
