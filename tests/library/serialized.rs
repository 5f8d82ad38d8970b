//! Results as data and back: the same in every answer; data that is none is refused, and whatever is accepted answers.

use serde_json::{Value, json};
use sweep_cdt::interior::FillRule;
use sweep_cdt::verify::{Level, verify};
use sweep_cdt::{Error, Location, Triangulation, Triangulator, triangulate};
use sweep_cdt_testing::{Random, counted};

use crate::location::input;

/// All that a triangulation of so many points tells of itself.
fn answers(result: &Triangulation, points: usize, edges: usize) -> Vec<String> {
    let each = 0..result.len();
    let stars = result.vertex_stars();
    let around = |v| {
        format!(
            "{:?} {}",
            stars.star(v).collect::<Vec<_>>(),
            result.representative(v)
        )
    };
    let fixed = each
        .clone()
        .map(|t| [0, 1, 2].map(|side| result.is_constrained(t, side)));
    let chain = |e| result.edge_chain(e).collect::<Vec<_>>();
    vec![
        format!("{:?}", result.triangles().collect::<Vec<_>>()),
        format!(
            "{:?}",
            each.map(|t| result.neighbors(t)).collect::<Vec<_>>()
        ),
        format!("{:?}", fixed.collect::<Vec<_>>()),
        format!("{:?}", result.hull().collect::<Vec<_>>()),
        format!("{:?}", result.duplicates().collect::<Vec<_>>()),
        format!("{:?}", (0..edges).map(chain).collect::<Vec<_>>()),
        format!("{:?}", (0..points).map(around).collect::<Vec<_>>()),
        format!(
            "{:?}",
            result
                .interior(FillRule::EvenOdd)
                .map(|domain| domain.inside().collect::<Vec<_>>())
        ),
    ]
}

#[test]
fn what_is_read_is_what_was_written() {
    let mut random = Random::new(1);
    let mut chains = 0;
    for round in 0..60 {
        let (count, width) = [(1, 1), (3, 2), (8, 3), (20, 5), (80, 9), (100, 40)][round % 6];
        let (points, edges) = input(&mut random, count, width);
        let result = triangulate(&points, &edges).expect("edges that do not cross");
        chains += (0..edges.len())
            .filter(|&e| result.edge_chain(e).len() > 2)
            .count();
        let text = serde_json::to_string(&result).expect("data");
        let read: Triangulation = serde_json::from_str(&text).expect("a triangulation");
        let [before, after] = [&result, &read].map(|it| answers(it, count, edges.len()));
        assert_eq!(before, after);
    }
    assert!(chains > 50, "{chains}");
}

/// A square with its diagonal, a duplicate and a point on that.
fn square() -> Value {
    let points = [[0, 0], [4, 0], [4, 4], [0, 4], [2, 2], [4, 0]];
    let result = triangulate(&points, &[[0, 2], [5, 5]]).expect("one diagonal");
    serde_json::to_value(result).expect("data")
}

#[test]
fn the_form_is_as_documented() {
    assert_eq!(square()["hull"], json!([3, 0, 1, 2]));
    assert_eq!(square()["duplicates"], json!([[5, 1]]));
    assert_eq!(square()["edges"], json!([[0, 4, 2], [1]]));
    assert_eq!(square()["triangles"].as_array().map(Vec::len), Some(4));
}

#[test]
fn data_of_no_triangulation_is_refused() {
    let empty = json!({"triangles": [], "hull": [], "duplicates": [], "edges": []});
    assert!(serde_json::from_value::<Triangulation>(empty).is_ok());
    // Two tetrahedra with one corner in common, one of which lacks a triangle: a disk and a sphere.
    let pinched = json!([
        [0, 1, 3],
        [1, 2, 3],
        [2, 0, 3],
        [3, 4, 5],
        [3, 5, 6],
        [3, 6, 4],
        [4, 6, 5]
    ]);
    // A torus of nine vertices without one triangle.
    let torus: Vec<[usize; 3]> = (0..9)
        .flat_map(|v| {
            let at = |x: usize, y: usize| (v / 3 + y) % 3 * 3 + (v % 3 + x) % 3;
            [
                [at(0, 0), at(1, 0), at(1, 1)],
                [at(0, 0), at(1, 1), at(0, 1)],
            ]
        })
        .collect();
    let [a, b, c] = torus[0];
    let torus_hull = [c, b, a];
    // The closed torus of seven vertices beside a triangle.
    let closed =
        (0..7).flat_map(|v| [[v, v + 1, v + 3], [v, v + 3, v + 2]].map(|t| t.map(|i| i % 7)));
    let beside: Vec<[usize; 3]> = closed.chain([[7, 8, 9]]).collect();
    // An icosahedron whose two poles, which have no neighbour in common, are both vertex 0.
    let ring = |first: usize, i: usize| first + i % 5;
    let poles = (0..5).flat_map(|i| {
        let [a, b] = [1, 6].map(|first| [i, i + 1].map(|i| ring(first, i)));
        [
            [0, a[0], a[1]],
            [a[0], b[0], a[1]],
            [b[0], b[1], a[1]],
            [0, b[1], b[0]],
        ]
    });
    let poles: Vec<[usize; 3]> = poles.collect();
    for (field, value, expected) in [
        (
            "triangles",
            json!([[0, 1, 1]]),
            "a triangle has a corner twice",
        ),
        (
            "triangles",
            json!([[0, 1, 0]]),
            "a triangle has a corner twice",
        ),
        (
            "triangles",
            json!([[0, 1, 2], [0, 1, 3]]),
            "two triangles lie to the left of one side",
        ),
        (
            "triangles",
            json!([[0, 1, 200_000_000]]),
            "a vertex has too large a number",
        ),
        (
            "triangles",
            json!([[0, 1, 2]]),
            "the hull is not the border of the triangles",
        ),
        (
            "triangles",
            json!([]),
            "the hull is not the border of the triangles",
        ),
        (
            "hull",
            json!([0, 1, 2]),
            "the hull is not the border of the triangles",
        ),
        (
            "hull",
            json!([3, 2, 1, 0]),
            "the hull is not the border of the triangles",
        ),
        (
            "duplicates",
            json!([[5, 5]]),
            "a duplicate is of none before it",
        ),
        (
            "duplicates",
            json!([[5, 1], [6, 5]]),
            "a duplicate is of none before it",
        ),
        (
            "duplicates",
            json!([[5, 6]]),
            "a duplicate is of none before it",
        ),
        (
            "duplicates",
            json!([[6, 1], [5, 1]]),
            "the duplicates are not in order",
        ),
        ("duplicates", json!([[3, 1]]), "a duplicate is a corner"),
        (
            "duplicates",
            json!([[6, 1]]),
            "a point is no corner and no duplicate",
        ),
        ("edges", json!([[6]]), "an edge passes no corner"),
        ("edges", json!([[]]), "an edge passes no vertex"),
        ("edges", json!([[2, 0]]), "an edge passes where no side is"),
        ("edges", json!([[2, 2]]), "an edge ends where it begins"),
        ("edges", json!([[0, 4, 0]]), "an edge ends where it begins"),
        ("edges", json!([[5]]), "an edge passes a duplicate"),
        ("heights", json!([]), "unknown field"),
    ] {
        let mut data = square();
        data[field] = value;
        let refused = serde_json::from_value::<Triangulation>(data).expect_err(expected);
        assert!(
            refused.to_string().contains(expected),
            "{field}: {refused}, not {expected}"
        );
    }
    for (triangles, hull) in [
        (pinched, json!([0, 1, 2])),
        (json!(torus[1..]), json!(torus_hull)),
        (json!(beside), json!([7, 8, 9])),
        (json!(poles), json!([])),
    ] {
        let data = json!({"triangles": triangles, "hull": hull, "duplicates": [], "edges": []});
        let refused = serde_json::from_value::<Triangulation>(data).expect_err("no disk");
        assert_eq!(refused.to_string(), "the triangles are no disk");
    }
}

/// A table by vertex would take 512 MB (the stars of the first), or 1 GB (the canonical order of the second).
#[test]
fn a_few_bytes_cannot_ask_for_long_tables() {
    let most = (1 << 27) - 1;
    for [a, b, c] in [[0, 1, most], [most - 2, most - 1, most]] {
        let data =
            json!({"triangles": [[a, b, c]], "hull": [a, b, c], "duplicates": [], "edges": []});
        let refused = serde_json::from_value::<Triangulation>(data).expect_err("a gap");
        assert_eq!(refused.to_string(), "a point is no corner and no duplicate");
    }
}

/// One number of the data is another one, or two are exchanged.
#[test]
fn damaged_data_is_refused_or_answers() {
    let mut random = Random::new(2);
    let (mut accepted, mut refused) = (0, 0);
    for _ in 0..3000 {
        let count = 3 + random.below(8);
        let (points, edges) = input(&mut random, count, 3);
        let result = triangulate(&points, &edges).expect("edges that do not cross");
        let mut text: Vec<char> = serde_json::to_string(&result)
            .expect("data")
            .chars()
            .collect();
        let digits: Vec<usize> = (0..text.len())
            .filter(|&i| text[i].is_ascii_digit())
            .collect();
        if digits.is_empty() {
            continue;
        }
        let place = digits[random.below(digits.len())];
        if random.one_in(2) {
            text.swap(place, digits[random.below(digits.len())]);
        } else {
            text[place] = char::from(b'0' + u8::try_from(random.below(10)).expect("a digit"));
        }
        let text: String = text.into_iter().collect();
        let Ok(read) = serde_json::from_str::<Triangulation>(&text) else {
            refused += 1;
            continue;
        };
        accepted += 1;
        answers(&read, 12, edges.len());
        let _ = read.with_points(&points).verify(&edges);
        let again = serde_json::to_string(&read).expect("data");
        assert_eq!(again, text);
    }
    assert!(accepted > 100 && refused > 1000, "{accepted} {refused}");
}

#[test]
fn other_results_are_data_too() {
    let points = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
    let stats = counted(&Triangulator::new(), &points, &[])
        .expect("no edges")
        .stats;
    let back = |value: Value| serde_json::from_value(value).expect("it was written so");
    assert_eq!(stats, back(json!(stats)));
    let error = Error::CrossingEdges { edges: [0, 1] };
    assert_eq!(json!(error), json!({"CrossingEdges": {"edges": [0, 1]}}));
    assert_eq!(
        serde_json::from_value::<Error>(json!(error)).ok(),
        Some(error)
    );
    let report = verify(&points, &[], &[[0, 1, 3], [1, 2, 3]]).expect("a right result");
    assert_eq!(json!(report)["level"], json!("canonical"));
    assert_eq!(report.level, Some(Level::Canonical));
    assert_eq!(serde_json::from_value(json!(report)).ok(), Some(report));
    let place = Location::Side {
        triangle: 3,
        side: 1,
    };
    assert_eq!(serde_json::from_value(json!(place)).ok(), Some(place));
    let wrong = verify(&points, &[], &[[0, 1, 3]]).expect_err("a triangle is missing");
    assert_eq!(json!(wrong)["found"], json!(wrong.found));
    assert!(
        json!(wrong)["list"]
            .as_array()
            .is_some_and(|list| list.len() == wrong.list.len())
    );
}
