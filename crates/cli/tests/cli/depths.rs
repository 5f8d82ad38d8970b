//! `verify --max-depth` and `--steiner`: what is wrong by rounding only, and vertices that the input lacks.

use serde_json::Value;

use crate::inside::FRAME;
use crate::verify::{first_line, refuted, verify};
use crate::{folder, printed, printed_despite_losses, run, text};

#[test]
fn rounding_has_a_verdict_and_a_status_of_its_own() {
    let points = r#"{"points": [[0,0],[1,0],[1,0.999999999999],[0,1]]}"#;
    let folder = folder(&[
        ("a.json", points),
        ("b.json", r#"{"triangles": [[0,1,3],[1,2,3]]}"#),
        ("c.json", r#"{"triangles": [[0,1,3]]}"#),
    ]);
    let output = verify(&folder, "a.json b.json --max-depth 1e-11");
    assert_eq!(output.status.code(), Some(3));
    let report = text(&output.stdout);
    let verdict = "up to 1e-11: b.json is a constrained Delaunay triangulation of a.json, but not exactly: \
                   1 violation, the deepest by 2.0e-12";
    assert_eq!(first_line(report), verdict);
    let depths = "\ndepths of violations\n1e-12 to 1e-11                       1\nthe deepest                    2.0e-12\n";
    assert!(report.contains(depths), "{report}");
    assert!(
        report.contains("\n  by 2.0e-12 of the squared radius\n\n"),
        "{report}"
    );
    let json = verify(&folder, "a.json b.json --max-depth 1e-11 --json");
    assert_eq!(json.status.code(), Some(3));
    let record: Value = serde_json::from_str(text(&json.stdout)).expect("JSON");
    assert_eq!(record["verdict"], "within-max-depth");
    assert_eq!(record["max_depth"], 1e-11);

    // Deeper than that, or wrong in another way.
    for wrong in ["b.json", "b.json --max-depth 1e-12", "c.json --max-depth 1"] {
        let report = verify(&folder, &format!("a.json {wrong}"));
        assert!(refuted(&report).starts_with("wrong: "), "{wrong}");
    }
    // What is right stays so.
    printed(&run(&folder, "a.json -o r.json"));
    let right = verify(&folder, "a.json r.json --max-depth 1e-11");
    assert!(printed(&right).starts_with("correct: "));
}

#[test]
fn vertices_may_be_added_where_that_is_allowed() {
    let more = FRAME
        .replace("8 2 0 0\n", "10 2 0 0\n")
        .replace("8 3 6\n", "8 3 6\n9 4 0\n10 1 1\n");
    let folder = folder(&[("a.poly", FRAME), ("more.poly", &more)]);
    printed_despite_losses(&run(&folder, "more.poly --inside holes -o b.obj"));
    let refused = verify(&folder, "a.poly b.obj --domain holes");
    let hint = "(--steiner allows for vertices that were added, --by-number ignores coordinates, write the result with all \
                digits, 17, or without coordinates)\n";
    assert_eq!(refused.status.code(), Some(1));
    assert!(text(&refused.stderr).ends_with(hint));

    let report = verify(&folder, "a.poly b.obj --domain holes --steiner");
    let report = printed(&report);
    assert!(report.starts_with("correct: b.obj is "), "{report}");
    let counts =
        "\nadded points                         2\nsplit edges                          1\n";
    assert!(report.contains(counts), "{report}");
    let unasked = verify(&folder, "a.poly b.obj --domain hull --steiner");
    let last = refuted(&unasked).lines().next_back();
    let hint = "this is a right triangulation of the interior: `--domain holes`";
    assert_eq!(last, Some(hint));

    // Outside of the hull.
    let beyond = more.replace("9 4 0\n", "9 4 -1\n");
    std::fs::write(folder.path().join("beyond.poly"), beyond).expect("a file");
    printed(&run(&folder, "beyond.poly --inside hull -o b.obj"));
    let report = verify(&folder, "a.poly b.obj --domain hull --steiner");
    let outside =
        "\nbent-boundary: the boundary from vertex 1 to 2 is not straight: vertex 9 is beside it\n";
    assert!(refuted(&report).contains(outside), "{}", refuted(&report));
}

#[test]
fn as_many_triangles_as_an_interior_has_are_no_hint() {
    let folder = folder(&[("a.poly", FRAME)]);
    printed(&run(&folder, "a.poly -o a.ele"));
    let path = folder.path().join("a.ele");
    let mut ele = std::fs::read_to_string(&path).expect("a text");
    let last = ele.find("\n8 ").expect("8 triangles") + 1;
    // A triangle of the hole takes the place of one beside it.
    ele.replace_range(last.., "8 5 6 7 0\n");
    std::fs::write(path, ele).expect("a file");
    let report = verify(&folder, "a.poly a.ele");
    assert!(
        !refuted(&report).contains("this is a right"),
        "{}",
        refuted(&report)
    );
}
