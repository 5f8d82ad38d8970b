//! The vertices of results, moved in every way: nothing is correct for another input than its own.

use std::fmt::Write;

use num_rational::BigRational;
use sweep_cdt::verify::verify;
use sweep_cdt::{Pslg, triangulate};
use sweep_cdt_formats::{
    Format, GraphFile, Matched, Matching, ResultError, Source, Triangles, read_result,
};
use sweep_cdt_testing::Random;

type Points = Vec<[f64; 2]>;

pub(crate) const FORMATS: [Format; 3] = [Format::Ele, Format::Json, Format::Obj];

/// The files of a result, with coordinates as `number` writes them; the second is a `.node`.
pub(crate) fn files(
    format: Format,
    points: &[[f64; 2]],
    triangles: &[[usize; 3]],
    number: impl Fn(f64) -> String,
) -> (Source, Option<Source>) {
    let source = |name: &str, text: String| Source::new(name, text.into_bytes());
    let (mut node, mut ele) = (
        format!("{} 2\n", points.len()),
        format!("{} 3\n", triangles.len()),
    );
    let mut obj = String::new();
    let mut list = Vec::new();
    for (v, point) in points.iter().enumerate() {
        let [x, y] = point.map(&number);
        writeln!(node, "{v} {x} {y}").unwrap();
        writeln!(obj, "v {x} {y} 0").unwrap();
        list.push(format!("[{x}, {y}]"));
    }
    for (t, [a, b, c]) in triangles.iter().enumerate() {
        writeln!(ele, "{t} {a} {b} {c}").unwrap();
        writeln!(obj, "f {} {} {}", a + 1, b + 1, c + 1).unwrap();
    }
    let list = list.join(",\n");
    let json = format!("{{\"points\": [{list}], \"triangles\": {triangles:?}}}");
    match format {
        Format::Ele => (source("r.ele", ele), Some(source("r.node", node))),
        Format::Json => (source("r.json", json), None),
        _ => (source("r.obj", obj), None),
    }
}

fn read(
    matching: Matching,
    format: Format,
    points: &[[f64; 2]],
    number: impl Fn(f64) -> String,
    input: &[[f64; 2]],
) -> Result<Triangles, ResultError> {
    let (source, node) = files(format, points, &[[0, 1, 2]], number);
    let graph = Pslg {
        points: input.to_vec(),
        ..Pslg::default()
    };
    matching.read(format, &source, node.as_ref(), &graph.into())
}

/// Points of many kinds: a lattice with duplicates, all digits, near each other and far from the origin.
fn points(random: &mut Random) -> Points {
    let count = 4 + random.below(12);
    let kind = random.below(5);
    let number = |random: &mut Random| {
        let small = random.below(4) as f64;
        let any = random.below(1 << 30) as f64 / 1e9;
        [small, any, 4_650_000.0 + any, 1e6 + small, any * 1e-12][kind]
    };
    (0..count)
        .map(|_| [number(random), number(random)])
        .collect()
}

/// The points elsewhere, or in another order.
fn moved(points: &[[f64; 2]], random: &mut Random) -> Points {
    let mut moved = points.to_vec();
    let v = random.below(points.len());
    let axis = random.below(2);
    let width = points.iter().map(|p| p[0]).fold(0.0, f64::max);
    match random.below(10) {
        0 => moved.reverse(),
        1 => moved.rotate_left(v),
        2 => moved.swap(0, v),
        3 => moved.iter_mut().for_each(|p| p[0] = width - p[0]),
        4 => moved.iter_mut().for_each(|p| p[axis] = -p[axis]),
        5 => moved.iter_mut().for_each(|p| *p = p.map(|x| x + 7.0)),
        6 => moved.iter_mut().for_each(|p| *p = p.map(|x| x * 1.001)),
        7 => moved[v][axis] += [5000.0, 1.0, 1e-3, 1e-9][random.below(4)],
        8 => moved[v][axis] = moved[v][axis].next_up(),
        _ => moved.iter_mut().for_each(|p| p.swap(0, 1)),
    }
    moved
}

/// Whether no coordinate is farther from the input's than half a unit of its sixth digit.
fn is_rounded(own: &[[f64; 2]], input: &[[f64; 2]]) -> bool {
    let pairs = own.as_flattened().iter().zip(input.as_flattened());
    own.len() == input.len()
        && pairs
            .into_iter()
            .all(|(x, y)| (x - y).abs() <= 5.000_001e-6 * y.abs())
}

#[test]
fn nothing_is_correct_for_another_input() {
    let mut random = Random::new(10);
    let mut kinds = [0; 4];
    for _ in 0..3000 {
        let input = GraphFile::from(Pslg {
            points: points(&mut random),
            ..Pslg::default()
        });
        let own = moved(&input.graph.points, &mut random);
        // What is right for the moved points, or was right before they moved.
        let of = if random.below(2) == 0 {
            &own
        } else {
            &input.graph.points
        };
        let triangles: Vec<[usize; 3]> = triangulate(of, &[]).unwrap().triangles().collect();
        for format in FORMATS {
            let (source, node) = files(format, &own, &triangles, |x| x.to_string());
            let result = match read_result(format, &source, node.as_ref(), &input) {
                Ok(result) => result,
                Err(error) => {
                    kinds[0] += 1;
                    let is_there = own.iter().all(|p| input.graph.points.contains(p));
                    assert!(!is_there, "{error}: {own:?} of {:?}", input.graph.points);
                    continue;
                }
            };
            let exact = |x: f64| BigRational::from_float(x).expect("finite");
            let pairs = || {
                let input = input.graph.points.as_flattened();
                own.as_flattened().iter().zip(input)
            };
            match result.matched {
                // What is verified are the triangles of the file, by their very corners.
                Matched::Equal => {
                    let corners = result
                        .list
                        .as_flattened()
                        .iter()
                        .map(|&v| input.graph.points[v]);
                    assert!(corners.eq(triangles.as_flattened().iter().map(|&v| own[v])));
                }
                Matched::Rounded { difference: told } => {
                    assert!(
                        is_rounded(&own, &input.graph.points),
                        "{own:?} of {:?}",
                        input.graph.points
                    );
                    assert!(told > 0.0);
                    // The least double that is no less than any difference.
                    let is_more = |(x, y): (&f64, &f64), told: f64| {
                        let difference = exact(*x) - exact(*y);
                        difference.clone().max(-difference) > exact(told)
                    };
                    assert!(!pairs().any(|pair| is_more(pair, told)));
                    assert!(pairs().any(|pair| is_more(pair, told.next_down())));
                }
                matched => panic!("{matched:?}"),
            }
            let is_correct = verify(&input.graph.points, &[], &result.list).is_ok();
            let kind = match (result.matched, is_correct) {
                (Matched::Equal, true) => 1,
                (Matched::Equal, false) => 2,
                _ => 3,
            };
            kinds[kind] += 1;
        }
    }
    let [refused, correct, wrong, rounded] = kinds;
    assert!(refused > 3000 && correct > 1000 && wrong > 100, "{kinds:?}");
    assert!(rounded < 200, "{kinds:?}");
}

#[test]
fn what_was_printed_with_six_digits_is_matched_by_number() {
    let mut random = Random::new(11);
    let input: Points = (0..50)
        .map(|_| [0; 2].map(|_| (1 + random.below(1 << 30)) as f64 / 1e7))
        .collect();
    for format in FORMATS {
        for digits in 4..=16 {
            let number = |x: f64| format!("{x:.*e}", digits - 1);
            let result = read(Matching::new(), format, &input, number, &input);
            match digits {
                4 | 5 => assert!(matches!(result, Err(ResultError::Stranger { .. }))),
                6..=9 => assert!(matches!(result.unwrap().matched, Matched::Rounded { .. })),
                _ => assert!(result.is_ok()),
            }
        }
        let result = read(Matching::new(), format, &input, |x| x.to_string(), &input);
        assert_eq!(result.unwrap().matched, Matched::Equal);
    }
}

/// A coordinate, as it is written, and whether that may be its rounding.
const ROUNDED: [(f64, &str, bool); 25] = [
    // Half a unit of the sixth digit goes either way, more does not.
    (1.234565, "1.23456", true),
    (1.234565, "1.23457", true),
    (1.234565, "1.23458", false),
    (1.234_565_1, "1.23456", false),
    (123_456.5, "123456", true),
    (123_456.5, "123457", true),
    (123_456.5, "1.23457e5", true),
    (123_456.5, "123458", false),
    (99_999.95, "100000", true),
    (99_999.95, "1E+5", true),
    (99_999.95, "99999.9", true),
    // Zeros at the end may be dropped.
    (1.000_004, "1", true),
    (1.000_006, "1", false),
    (1.000_004, "+1.0", true),
    (-1.000_004, "-1", true),
    (1.000_004, "-1", false),
    // What is written with more digits must agree in them.
    (123_456.5, "123456.4", false),
    (1.000_004, "1.0000000", false),
    (5_000_007.0, "5000010", false),
    (5_000_007.0, "5.00001e6", true),
    (0.000_123_456_78, "0.0001234568", true),
    (0.000_123_456_78, "0.0001234567", false),
    // Six decimals may be all that a file has, where its vertices are not like others.
    (0.000_123_456_78, "0.000123", true),
    (0.000_123_456_78, "0.000124", false),
    (1e-20, "0", false),
];

#[test]
fn roundings_agree_in_as_many_digits_as_there_are() {
    for (exact, text, expected) in ROUNDED {
        // A vertex that is no vertex of the input keeps it from being matched by coordinates.
        let input = [[exact, 1.5], [0.0, 0.5], [7.0, 0.0]];
        for format in [Format::Ele, Format::Obj] {
            let number = |x: f64| match x.to_bits() == exact.to_bits() {
                true => text.to_owned(),
                false => x.to_string(),
            };
            let result = read(Matching::new(), format, &input, number, &input);
            assert_eq!(result.is_ok(), expected, "{exact} as {text}: {result:?}");
        }
    }
}

#[test]
fn a_tolerance_is_kept_to_the_last_bit() {
    let input = [[1.0, 1.5], [0.0, 0.5], [7.0, 0.0]];
    let mut own = input;
    own[1][0] = -0.25;
    let with = |tolerance| {
        let matching = Matching::new().tolerance(tolerance);
        read(matching, Format::Json, &own, |x| x.to_string(), &input)
    };
    let matched = with(0.25).map(|result| result.matched);
    assert_eq!(matched, Ok(Matched::Near { difference: 0.25 }));
    assert!(with(0.25_f64.next_down()).is_err());
    assert_eq!(
        with(f64::MAX).unwrap().matched,
        Matched::Near { difference: 0.25 }
    );
}
