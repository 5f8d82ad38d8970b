//! `verify --domain`: results that fill the interior of an input.

use serde_json::Value;

use crate::inside::FRAME;
use crate::verify::{first_line, refuted, verify};
use crate::{assert_fails, folder, printed, printed_despite_losses, run};

const WHAT: &str = "a constrained Delaunay triangulation of";

/// The frame with a point in its hole, which no triangle needs, and edges from there to the corner of the hole and on
/// to that of the frame.
fn dangling() -> String {
    let points = FRAME.replace("8 2 0 0\n", "9 2 0 0\n");
    let points = points.replace("8 3 6\n", "8 3 6\n9 4 4\n");
    points
        .replace("8 0\n", "10 0\n")
        .replace("8 8 5\n", "8 8 5\n9 9 5\n10 9 1\n")
}

#[test]
fn a_result_may_fill_the_interior() {
    let dangling = dangling();
    for poly in [FRAME, &dangling] {
        let folder = folder(&[("a.poly", poly)]);
        printed_despite_losses(&run(&folder, "a.poly -o a.ele -o a.obj"));
        for result in ["a.ele", "a.obj"] {
            let report = verify(&folder, &format!("a.poly {result} --domain holes"));
            let interior = "the interior of a.poly (holes), the canonical one";
            let expected = format!("correct: {result} is {WHAT} {interior}");
            assert_eq!(first_line(printed(&report)), expected);
            // What is inside by default is what is verified by default.
            let report = verify(&folder, &format!("a.poly {result}"));
            assert_eq!(first_line(printed(&report)), expected);
        }
        let hull = verify(&folder, "a.poly a.ele --domain hull");
        let mut lines = refuted(&hull).lines();
        let verdict = lines.next().expect("a verdict");
        assert!(verdict.starts_with("wrong: "), "{verdict}");
        let hint = "this is a right triangulation of the interior: `--domain holes`";
        assert_eq!(lines.next_back(), Some(hint));
        let json = verify(&folder, "a.poly a.ele --domain holes --json");
        let record: Value = serde_json::from_str(printed(&json)).expect("JSON");
        assert_eq!(record["domain"], "holes");
        let edges = if poly == FRAME { 8 } else { 10 };
        assert_eq!(record["counts"]["edges"], edges);
        assert_eq!(record["counts"]["triangles"], 8);
    }
}

#[test]
fn triangles_have_the_attributes_of_their_regions() {
    let folder = folder(&[("a.poly", FRAME)]);
    printed(&run(&folder, "a.poly -o a.ele -o a.json"));
    for result in ["a.ele", "a.json"] {
        printed(&verify(&folder, &format!("a.poly {result} --domain holes")));
    }
    let text = |name| std::fs::read_to_string(folder.path().join(name)).expect("a text");
    let (ele, json) = (text("a.ele"), text("a.json"));
    let regions = "\"regions\": [\n0";
    assert!(json.contains(regions), "{json}");
    for (name, wrong, triangle) in [
        ("a.ele", ele.replace("5 2 7 6 0.5", "5 2 7 6 0.25"), 5),
        ("a.ele", ele.replace("5 2 7 6 0.5", "5 2 7 6"), 5),
        ("a.json", json.replace(regions, "\"regions\": [\nnull"), 0),
        ("a.json", json.replace(regions, "\"regions\": [\n1"), 0),
    ] {
        std::fs::write(folder.path().join(name), wrong).expect("a file");
        let report = verify(&folder, &format!("a.poly {name} --domain holes"));
        let violation = format!("wrong-region: triangle {triangle} has another attribute than");
        assert!(
            refuted(&report).contains(&violation),
            "{}",
            refuted(&report)
        );
        // A triangulation is one whatever its attributes.
        printed(&verify(
            &folder,
            &format!("a.poly {name} --domain holes --level tiling"),
        ));
        printed(&verify(
            &folder,
            &format!("a.poly {name} --domain even-odd"),
        ));
    }
    // Triangles may run clockwise, and have other numbers.
    let clockwise = ele
        .lines()
        .map(|line| match line.split(' ').collect::<Vec<_>>()[..] {
            [t, a, b, c, attribute] => format!("{t} {b} {a} {c} {attribute}\n"),
            _ => format!("{line}\n"),
        });
    std::fs::write(folder.path().join("a.ele"), clockwise.collect::<String>()).expect("a file");
    printed(&verify(&folder, "a.poly a.ele --domain holes"));
}

#[test]
fn an_input_without_an_interior_is_refused() {
    let folder = folder(&[
        (
            "a.json",
            r#"{"points": [[0,0],[4,0],[0,4]], "edges": [[0,1]]}"#,
        ),
        ("b.json", r#"{"triangles": [[0,1,2]]}"#),
        (
            "c.json",
            r#"{"points": [[0,0],[4,0],[4,4],[0,4]], "edges": [[0,2],[1,3]]}"#,
        ),
    ]);
    assert_fails(
        &verify(&folder, "a.json b.json --domain even-odd"),
        "a.json: the edges are no closed rings: they do not go on at vertex 0, at (0, 0)",
    );
    assert_fails(
        &verify(&folder, "c.json b.json --domain holes"),
        "c.json: edges 0 and 1 cross near (2, 2)",
    );
    // Without a domain asked for, edges that cross are for the verifier to judge.
    assert!(refuted(&verify(&folder, "c.json b.json")).starts_with("wrong: "));
}

#[test]
fn a_result_is_judged_by_what_it_promises() {
    let folder = folder(&[
        (
            "a.json",
            r#"{"points": [[0,0],[4,0],[5,3],[0,3]], "edges": [[0,1]]}"#,
        ),
        ("b.json", r#"{"points": [[0,0],[4,0],[4,4],[0,4]]}"#),
        ("c.json", r#"{"triangles": [[0,1,2],[0,2,3]]}"#),
    ]);
    let judged =
        |input: &str, level: &str| verify(&folder, &format!("{input} c.json --level {level}"));
    let highest = |report: &str| {
        let mut lines = report.lines();
        let line = lines.find_map(|line| line.strip_prefix("highest level"));
        line.expect("a level").trim().to_owned()
    };
    for (level, what) in [("tiling", "a"), ("constrained", "a constrained")] {
        let report = judged("a.json", level);
        let expected = format!("correct: c.json is {what} triangulation of a.json");
        assert_eq!(first_line(printed(&report)), expected);
        assert_eq!(highest(printed(&report)), "constrained");
    }
    let report = judged("a.json", "delaunay");
    assert_eq!(highest(refuted(&report)), "constrained");
    let report = judged("b.json", "delaunay");
    assert_eq!(highest(printed(&report)), "delaunay");
    let report = judged("b.json", "canonical");
    let canonical = "the canonical constrained Delaunay triangulation of b.json";
    let expected = format!("wrong: c.json is not {canonical}: 1 violation");
    assert_eq!(first_line(refuted(&report)), expected);
    let not = "\nnot-canonical: diagonals between vertices on one circle that do not end at the leftmost one: 1\n";
    let line = "this is a constrained Delaunay triangulation, but not the canonical one: `--level delaunay` accepts it\n";
    assert!(
        refuted(&report).ends_with(&format!("{not}\n{line}")),
        "{}",
        refuted(&report)
    );
    let json = verify(&folder, "a.json c.json --level tiling --json");
    let record: Value = serde_json::from_str(printed(&json)).expect("JSON");
    assert_eq!(record["level"], "tiling");
    assert_eq!(record["highest_level"], "constrained");
}
