//! Rules and settings by name; verdicts within a domain; advice that is followed.

use sweep_cdt::interior::Ring;
use sweep_cdt::verify::Level;
use sweep_cdt::{Region, Watch, triangulate};
use sweep_cdt_engine::{
    ALGORITHMS, Advice, FRONTS, HEURISTICS, Input, Inside, Question, Setting, Settings, Verdict,
    Words, counts,
};
use sweep_cdt_formats::Numbering;

fn question<'a>(input: &'a Input<'a, f64>, triangles: &'a [[usize; 3]]) -> Question<'a, f64, f64> {
    Question {
        input,
        points: input.points,
        added_from: None,
        numbering: Numbering::default(),
        triangles,
        first_triangle: 0,
        strangers: &[],
        attributes: None,
        domain: Inside::HULL,
        level: Level::Delaunay,
        max_depth: None,
        limit: 20,
        triangulate: &triangulate,
        verify: &|verifier, points, edges, triangles| verifier.verify(points, edges, triangles),
    }
}

fn verdict(question: &Question<'_, f64, f64>) -> Verdict {
    question.verdict(&question.answer().expect("the input has a domain"))
}

#[test]
fn names_are_read_as_they_are_written() {
    for name in Inside::names().chain(["at-least-1", "at-least-12"]) {
        let rule: Inside = name.parse().expect("a rule");
        assert_eq!(rule.to_string(), name);
    }
    for name in ["odd", "", "at-least-0", "at-least--1", "at-least-", "Hull"] {
        let error = name.parse::<Inside>().expect_err("no rule").to_string();
        let known = "is not one of hull, polygons, even-odd, nonzero, positive, negative, holes, hull-without-holes, \
                     at-least-K with K from 1 on";
        assert_eq!(error, format!("rule {name:?} {known}"));
    }
}

/// A square with a notch from above, and a square hole in it, both counter-clockwise.
const POINTS: [[f64; 2]; 9] = [
    [0.0, 0.0],
    [9.0, 0.0],
    [9.0, 9.0],
    [4.5, 7.0],
    [0.0, 9.0],
    [3.0, 3.0],
    [6.0, 3.0],
    [6.0, 6.0],
    [3.0, 6.0],
];
const EDGES: [[usize; 2]; 9] = [
    [0, 1],
    [1, 2],
    [2, 3],
    [3, 4],
    [4, 0],
    [5, 6],
    [6, 7],
    [7, 8],
    [8, 5],
];

#[test]
fn each_rule_takes_its_part_of_the_hull() {
    let ring = |is_hole| Ring {
        polygon: 0,
        is_hole,
    };
    let input = Input {
        edges: &EDGES,
        holes: &[[4.0, 4.0]],
        rings: &[ring(false), ring(true)],
        ring_of: &[[Some(0); 5].as_slice(), &[Some(1); 4]].concat(),
        ..Input::of(&POINTS)
    };
    let hull = triangulate(&POINTS, &EDGES).expect("no edges cross");
    assert_eq!(hull.len(), 12);
    for (name, triangles) in [
        ("hull", 12),
        ("polygons", 9),
        ("even-odd", 9),
        ("nonzero", 11),
        ("positive", 11),
        ("negative", 0),
        ("at-least-2", 2),
        ("holes", 9),
        ("hull-without-holes", 10),
    ] {
        let rule: Inside = name.parse().expect("a rule");
        let interior = rule.interior(&input, &hull).expect("closed rings");
        assert_eq!(interior.inside().len(), triangles, "{name}");

        // What is inside is right there, and nowhere else where there is less or more.
        let list: Vec<_> = interior.triangles().collect();
        let mut asked = question(&input, &list);
        asked.domain = rule;
        let answer = asked.answer().expect("a domain");
        if triangles > 0 {
            let report = answer.expect("right triangles");
            assert_eq!(counts(&report)[2], ("edges", EDGES.len()));
        }
        asked.domain = Inside::HULL;
        let is_hull = triangles == hull.len();
        assert_eq!(verdict(&asked) == Verdict::Correct, is_hull, "{name}");
    }
    assert_eq!(Inside::default_of(true, true), Inside::Holes);
    assert_eq!(Inside::default_of(false, true), Inside::Polygons);
    assert_eq!(Inside::default_of(false, false), Inside::HULL);
}

#[test]
fn attributes_of_regions_are_asked_for_where_the_rule_has_them() {
    let region = Region {
        seed: [1.0, 1.0],
        attribute: 7.0,
    };
    let input = Input {
        edges: &EDGES,
        holes: &[[4.0, 4.0]],
        regions: &[region],
        ..Input::of(&POINTS)
    };
    let hull = triangulate(&POINTS, &EDGES).expect("no edges cross");
    let interior = Inside::Holes.interior(&input, &hull).expect("a domain");
    let list: Vec<_> = interior.triangles().collect();
    let mut attributes = vec![7.0; list.len()];
    let sentence_by = |rule: &str, attributes: &[f64]| {
        let mut asked = question(&input, &list);
        asked.domain = rule.parse().expect("a rule");
        asked.attributes = Some(attributes);
        sentence(&asked)
    };
    let right = "correct: nothing to do";
    assert_eq!(sentence_by("holes", &attributes), right);
    attributes[2] = 0.0;
    let line =
        "this is a triangulation, but with wrong attributes of regions: [Level(Tiling)] accepts it";
    assert_eq!(sentence_by("holes", &attributes), line);
    // Even-odd knows no regions.
    assert_eq!(sentence_by("even-odd", &attributes), right);
    let line = "this is a right triangulation of the interior: [Domain(Edges(EvenOdd))]";
    assert_eq!(sentence_by("hull", &attributes), line);
    let line = "this is a right triangulation of the interior: [Domain(Holes)]";
    assert_eq!(sentence_by("hull", &vec![7.0; list.len()]), line);
}

#[test]
fn edges_that_are_missing_within_a_domain_have_the_numbers_of_the_input() {
    // The first edge bounds nothing, and lies in the notch.
    let points = [&POINTS[..5], &[[4.5, 8.0]]].concat();
    let edges = [&[[3, 5]], &EDGES[..5], &[[0, 3]]].concat();
    let input = Input {
        edges: &edges,
        ..Input::of(&points)
    };
    let mut asked = question(&input, &[[0, 1, 3], [1, 2, 3], [0, 3, 4]]);
    asked.domain = Inside::Holes;
    assert_eq!(verdict(&asked), Verdict::Correct);
    asked.triangles = &[[0, 1, 4], [1, 3, 4], [1, 2, 3]];
    let violations = asked.answer().expect("a domain").expect_err("no edge 6");
    assert_eq!(violations.list[0].offenders().edges, [6]);
}

#[test]
fn settings_change_nothing() {
    let expected = triangulate(&POINTS, &EDGES).expect("no edges cross");
    for algorithm in ALGORITHMS {
        for front in FRONTS {
            for heuristics in HEURISTICS {
                let settings = Settings::named(algorithm.name, front.name, heuristics.name);
                let settings = settings.expect("known names");
                let result = settings.run(&POINTS, &EDGES, Watch::new());
                let result = result.expect("no edges cross");
                assert_eq!(result.canonical_triangles(), expected.canonical_triangles());
            }
        }
    }
    let error = Settings::named("auto", "hash", "slow").expect_err("no such heuristics");
    assert_eq!(
        error.to_string(),
        r#"heuristics "slow" is not one of fast, paper, off"#
    );
}

fn sentence(question: &Question<'_, f64, f64>) -> String {
    let words = Words {
        setting: "wish",
        max_depth: "depth",
        settings: &|settings: &[Setting]| format!("{settings:?}"),
        refused: &|error| error.to_string(),
        beside_input: None,
        show: "pictures show",
    };
    let answer = question.answer().expect("a domain");
    question.sentence(question.advice(&answer), &words)
}

/// What is advised is done, and accepted.
#[track_caller]
fn follow(asked: &mut Question<'_, f64, f64>, expected: &str) {
    assert_eq!(sentence(asked), expected);
    let answer = asked.answer().expect("a domain");
    let Advice::Accept(fit) = asked.advice(&answer) else {
        panic!("no settings are advised");
    };
    for setting in fit.settings() {
        match setting {
            Setting::Domain(domain) => asked.domain = domain,
            Setting::MaxDepth(depth) => asked.max_depth = Some(depth),
            Setting::Level(level) => asked.level = level,
        }
    }
    assert_ne!(verdict(asked), Verdict::Wrong);
    assert!(sentence(asked).ends_with(": nothing to do"));
}

#[test]
fn settings_that_are_advised_accept_the_triangles() {
    let notch = Input {
        edges: &EDGES[..5],
        ..Input::of(&POINTS[..5])
    };
    let inside = [[0, 1, 3], [1, 2, 3], [0, 3, 4]];
    let line = "this is a right triangulation of the interior: [Domain(Edges(EvenOdd))]";
    follow(&mut question(&notch, &inside), line);
    let hull = [inside.as_slice(), &[[3, 2, 4]]].concat();
    let mut asked = question(&notch, &hull);
    asked.domain = Inside::Holes;
    let line = "this is a right triangulation of the hull: [Domain(Edges(Hull))]";
    follow(&mut asked, line);

    let diagonal = [[0, 1, 3], [1, 2, 3]];
    for (y, size) in [
        (
            0.999_999_999_999_99,
            "rounding (depth 2.0e-14): [MaxDepth(1e-12)]",
        ),
        (
            0.999_999_999,
            "rounding to single precision (depth 2.0e-9): [MaxDepth(1e-8)]",
        ),
    ] {
        let points = [[0.0, 0.0], [1.0, 0.0], [1.0, y], [0.0, 1.0]];
        let line = format!("the only violation is of the size of {size} accepts it");
        follow(&mut question(&Input::of(&points), &diagonal), &line);
    }

    let points = [[0.0, 0.0], [4.0, 0.0], [5.0, 3.0], [0.0, 3.0]];
    let line =
        "this is a constrained triangulation, but not Delaunay: [Level(Constrained)] accepts it";
    let other = [[0, 1, 2], [0, 2, 3]];
    follow(&mut question(&Input::of(&points), &other), line);
    let input = Input {
        edges: &[[0, 1], [0, 2]],
        ..Input::of(&points)
    };
    let mut asked = question(&input, &diagonal);
    asked.numbering = Numbering::FROM_ONE;
    let line = "this is a triangulation, but without all edges of the input (edge 2 is missing): [Level(Tiling)] \
                accepts it";
    follow(&mut asked, line);
    let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
    let right = triangulate(&square, &[]).expect("no edges");
    let is_other = right.canonical_triangles() != [[0, 1, 2], [0, 2, 3]];
    let ties = if is_other { &other } else { &diagonal };
    let input = Input::of(&square);
    let mut asked = question(&input, ties);
    asked.level = Level::Canonical;
    let line = "this is a constrained Delaunay triangulation, but not the canonical one: [Level(Delaunay)] accepts it";
    follow(&mut asked, line);
}

#[test]
fn changes_that_are_advised_make_the_triangles_right() {
    let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [2.0, 1.0]];
    let right = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
    let input = Input::of(&points);
    let advised = |triangles: &[[usize; 3]]| {
        let mut asked = question(&input, triangles);
        asked.numbering = Numbering::FROM_ONE;
        asked.first_triangle = 1;
        sentence(&asked)
    };
    assert_eq!(advised(&right), "correct: nothing to do");
    let turned = |which: &[usize]| {
        let mut turned = right;
        which.iter().for_each(|&t| turned[t].swap(1, 2));
        advised(&turned)
    };
    let line = "correct: nothing to do; the triangles run clockwise";
    assert_eq!(turned(&[0, 1, 2, 3]), line);
    for (reversed, odd) in [(&[2][..], 3), (&[0], 1), (&[1, 2, 3], 1), (&[0, 2, 3], 2)] {
        let line = format!(
            "triangle {odd} runs the other way round than all others: swap two of its corners"
        );
        assert_eq!(turned(reversed), line);
    }
    let line = "2 triangles run the other way round than the others, the first is 2: swap two corners of each";
    assert_eq!(turned(&[1, 3]), line);
    let line = "corners are numbered from 1 and not from 0: subtract 1 from each";
    assert_eq!(advised(&right.map(|t| t.map(|v| v + 1))), line);
    let line = "vertex 5 of the input, at (2, 1), is used by no triangle, and nothing else is wrong: remove it from the \
                input, and run the program again";
    assert_eq!(advised(&[[0, 1, 3], [1, 2, 3]]), line);
    let line = "2 vertices of the input are used by no triangle, the first is 4 at (2, 0.5), and nothing else is wrong: \
                remove them from the input, and run the program again";
    let other = [points[0], points[1], points[2], [2.0, 0.5], [2.0, 1.0]];
    let more = Input::of(&other);
    let mut asked = question(&more, &[[0, 1, 2]]);
    asked.numbering = Numbering::FROM_ONE;
    assert_eq!(sentence(&asked), line);

    // Where it can only be told what is wrong.
    let show = ": pictures show where it is wrong";
    for (triangles, line) in [
        (
            [right[0], right[0], right[1]].as_slice(),
            "no wish accepts this, the first violation is repeated-side",
        ),
        (&[], "the result has no triangles"),
        (
            &[[0, 1, 7]],
            "corners are no vertices of the input: perhaps this is the result of another one",
        ),
    ] {
        assert_eq!(advised(triangles), format!("{line}{show}"));
    }
    let crossing = Input {
        edges: &[[0, 2], [1, 3]],
        ..Input::of(&points)
    };
    let line = "the input has no triangulation with its edges: edges 0 and 1 cross";
    assert_eq!(sentence(&question(&crossing, &right)), line);
}
