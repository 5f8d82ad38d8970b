//! Vertices of a result that are moved and shuffled: each is matched with the right one, or the refusal is true.

use num_bigint::BigInt;
use num_rational::BigRational;
use sweep_cdt::scalar::Scalar;
use sweep_cdt_formats::{Listed, Matched, Matching, Precision, ResultError, WayOut};
use sweep_cdt_testing::Random;

fn exact(x: f64) -> BigRational {
    BigRational::from_float(x).expect("finite")
}

/// The greater difference of two points, by definition.
fn apart(p: &[f64; 2], q: &[f64; 2]) -> BigRational {
    let [x, y] = [0, 1].map(|axis| exact(p[axis]) - exact(q[axis]));
    x.clone().max(-x).max(y.clone().max(-y))
}

fn listed<S>(points: &[[S; 2]], precision: Precision) -> Listed<'_, S> {
    Listed {
        points,
        precision,
        is_soup: false,
    }
}

/// Distinct points in any place, some close to each other.
fn points(random: &mut Random) -> Vec<[f64; 2]> {
    let unit = [1.0, 1e-3, 1e6][random.below(3)];
    let near = unit / [1e3, 1e8][random.below(2)];
    let mut points: Vec<[f64; 2]> = Vec::new();
    for _ in 0..2 + random.below(12) {
        let base = match random.below(3) {
            0 => points.last().copied().unwrap_or_default(),
            _ => [0, 1].map(|_| random.below(1000) as f64 * unit),
        };
        points.push(base.map(|x| x + random.below(100) as f64 * near));
    }
    points.sort_by(|p, q| p.partial_cmp(q).expect("numbers"));
    points.dedup();
    points
}

/// The input, a moved copy in another order, and for each vertex of the copy which one it was.
fn moved(random: &mut Random) -> (Vec<[f64; 2]>, Vec<[f64; 2]>, Vec<usize>) {
    let input = points(random);
    let mut order: Vec<usize> = (0..input.len()).collect();
    for end in (1..order.len()).rev() {
        order.swap(end, random.below(end + 1));
    }
    let size = 10_f64.powi(-i32::try_from(random.below(9)).expect("small"));
    let decimals = random.below(10);
    let mut copy: Vec<[f64; 2]> = order.iter().map(|&v| input[v]).collect();
    let how = random.below(3);
    for x in copy.as_flattened_mut() {
        match how {
            0 => *x += size * (random.below(2001) as f64 - 1000.0),
            1 => *x = format!("{x:.decimals$}").parse().expect("a number"),
            _ => *x = format!("{x:.decimals$e}").parse().expect("a number"),
        }
    }
    (input, copy, order)
}

/// With a tolerance below half of the least distance every vertex within it is matched with the right one, to the last bit;
/// the tolerance that a refusal offers is such a one, and the vertices that it names are the nearest one, or two near ones.
#[test]
fn what_is_offered_and_named_is_true() {
    let mut random = Random::new(11);
    let (mut offers, mut twins, mut strangers, mut matches) = (0, 0, 0, 0);
    for _ in 0..3000 {
        let (input, copy, order) = moved(&mut random);
        let pairs = (0..input.len()).flat_map(|v| (0..v).map(move |w| (v, w)));
        let least = pairs.map(|(v, w)| apart(&input[v], &input[w])).min();
        let moved = copy.iter().zip(&order).map(|(p, &v)| apart(p, &input[v]));
        let moved = moved.max().expect("a point");
        let result = listed(&copy, Precision::Digits);
        let is_separated = |tolerance: f64| {
            let twice = exact(tolerance) * BigInt::from(2);
            least.as_ref().is_none_or(|least| twice < *least)
        };
        let refusal = match result.places(Matching::new(), &input) {
            Ok((Matched::Rounded { .. }, None)) => continue,
            Ok((matched, places)) => {
                let places = places.unwrap_or_else(|| (0..copy.len()).collect());
                let difference = matched.difference().expect("coordinates");
                let pairs = || copy.iter().zip(&places).map(|(p, &v)| apart(p, &input[v]));
                assert!(pairs().all(|apart| apart <= exact(difference)));
                if is_separated(difference) && is_separated(moved.approx().next_up()) {
                    assert_eq!(places, order, "{input:?} {copy:?}");
                    matches += 1;
                }
                continue;
            }
            Err(error) => error,
        };
        match &refusal {
            ResultError::Stranger {
                vertex, nearest, ..
            } => {
                let nearest = nearest.as_ref().expect("there are vertices");
                let from = &copy[*vertex];
                let difference = apart(from, &input[nearest.of_input]);
                assert!(input.iter().all(|p| apart(from, p) >= difference));
                assert!(difference <= exact(nearest.difference));
                assert!(difference > exact(0.0));
                strangers += 1;
            }
            ResultError::Ambiguous {
                vertex,
                of_input: [one, other],
                ..
            } => {
                assert!(apart(&input[*one], &input[*other]) > exact(0.0));
                let rounding = |v: usize| apart(&copy[*vertex], &input[v]).approx();
                let size = copy[*vertex].map(f64::abs).into_iter().fold(0.0, f64::max);
                assert!(rounding(*one).max(rounding(*other)) <= 1e-5 * size);
                twins += 1;
            }
            ResultError::Shared { vertices, .. } => {
                assert!(apart(&copy[vertices[0]], &copy[vertices[1]]) > exact(0.0));
            }
            other => panic!("{other}"),
        }
        let ways_out = refusal.ways_out();
        if let [WayOut::Tolerance(tolerance)] = ways_out[..] {
            assert!(is_separated(tolerance), "{tolerance} {input:?}");
            let matching = Matching::new().tolerance(tolerance);
            let (_, places) = result.places(matching, &input).expect("it was offered");
            let places = places.unwrap_or_else(|| (0..copy.len()).collect());
            if moved <= exact(tolerance) {
                assert_eq!(places, order);
            }
            offers += 1;
        } else {
            assert!(!ways_out.is_empty());
        }
    }
    let counts = [offers, twins, strangers, matches];
    assert!(counts.iter().all(|&count| count > 100), "{counts:?}");
}

/// A tolerance is exact: the double that is no less than the greatest difference accepts, the one before it does not.
#[test]
fn a_tolerance_counts_to_the_last_bit() {
    let mut random = Random::new(12);
    for _ in 0..2000 {
        let number = |random: &mut Random| random.below(1 << 40) as f64 / 3.0;
        let scale = 2_f64.powi(i32::try_from(random.below(120)).expect("small") - 60);
        let p = [0, 1].map(|_| number(&mut random));
        let q = p.map(|x| x + number(&mut random) * scale);
        let far = [-1e300, 1e300];
        let difference = apart(&p, &q);
        let mut tolerance = difference.approx();
        while exact(tolerance) < difference {
            tolerance = tolerance.next_up();
        }
        while tolerance > 0.0 && exact(tolerance.next_down()) >= difference {
            tolerance = tolerance.next_down();
        }
        // By number, and in another order; in doubles and in fractions.
        for (points, input) in [([p, far], [q, far]), ([p, far], [far, q])] {
            let fractions = [points, input].map(|points| points.map(|p| p.map(exact)));
            let [exact_points, exact_input] = &fractions;
            for (tolerance, is_accepted) in [(tolerance, true), (tolerance.next_down(), false)] {
                if tolerance < 0.0 || difference == exact(0.0) {
                    continue;
                }
                let matching = Matching::new().tolerance(tolerance);
                let doubles = listed(&points, Precision::Digits).places(matching, &input);
                let exactly = listed(exact_points, Precision::Exact).places(matching, exact_input);
                assert_eq!(doubles.is_ok(), is_accepted, "{p:?} {q:?} {tolerance:e}");
                assert_eq!(exactly.is_ok(), is_accepted, "{p:?} {q:?} {tolerance:e}");
            }
        }
    }
}

/// A result as `%.6f` prints it, shuffled: the decimals are told by the doubles alone.
#[test]
fn fixed_decimals_are_seen_in_doubles() {
    let input = [[0.00960412, 1.0], [33.5000004, 0.2], [12.3456789, 7.0]];
    let copy = [[33.5, 0.2], [0.009604, 1.0], [12.345679, 7.0]];
    let found = listed(&copy, Precision::Digits).places(Matching::new(), &input);
    let (matched, places) = found.expect("rounded");
    assert!(matches!(matched, Matched::Printed { .. }));
    assert_eq!(places, Some(vec![1, 0, 2]));
}
