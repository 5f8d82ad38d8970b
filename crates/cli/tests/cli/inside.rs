//! The files that `triangulate --inside` writes.

use std::fs;

use serde_json::{Value, json};

use crate::{assert_fails, folder, printed, printed_without_triangles, run};

/// A square with a square hole, and a region in what is left.
pub(crate) const FRAME: &str = "\
8 2 0 0
1 0 0
2 9 0
3 9 9
4 0 9
5 3 3
6 6 3
7 6 6
8 3 6
8 0
1 1 2
2 2 3
3 3 4
4 4 1
5 5 6
6 6 7
7 7 8
8 8 5
1
1 4 5
1
1 1 2 0.5
";

/// The triangles of the frame.
const FRAME_ELE: &str = "\
8 3 1
1 1 2 6 0.5
2 1 5 4 0.5
3 1 6 5 0.5
4 2 3 7 0.5
5 2 7 6 0.5
6 3 4 7 0.5
7 4 5 8 0.5
8 4 8 7 0.5
";

/// The frame in JSON, the inner square running as the outer one does.
const FRAME_JSON: &str = r#"{"points": [[0, 0], [9, 0], [9, 9], [0, 9], [3, 3], [6, 3], [6, 6], [3, 6]],
"edges": [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]]}"#;

fn lines(text: &str, start: &str) -> usize {
    text.lines().filter(|line| line.starts_with(start)).count()
}

/// The JSON that a run prints.
fn object(folder: &tempfile::TempDir, arguments: &str) -> Value {
    let output = run(folder, &format!("{arguments} -o - --output-format json"));
    serde_json::from_str(printed(&output)).expect("JSON")
}

#[test]
fn a_poly_with_holes_has_them() {
    let folder = folder(&[("frame.poly", FRAME)]);
    let ele = |options: &str| {
        let output = run(
            &folder,
            &format!("frame.poly -o - --output-format ele {options}"),
        );
        printed(&output).to_owned()
    };
    assert_eq!(ele(""), FRAME_ELE);
    assert_eq!(ele("--inside holes --scalar rational --verify"), FRAME_ELE);
    for (rule, triangles) in [("hull", 10), ("nonzero", 10), ("even-odd", 8)] {
        let ele = ele(&format!("--inside {rule}"));
        assert!(ele.starts_with(&format!("{triangles} 3 0\n")), "{ele}");
    }
    let summary = "frame.poly: points 8, duplicates 0, edges 8, triangles 10, hull 4";
    assert_eq!(
        printed(&run(&folder, "frame.poly")),
        format!(
            "{summary}\ninside 8 of 10 triangles: rule holes, as the input has 1 hole; --inside hull keeps all\n"
        )
    );
    assert_eq!(
        printed(&run(&folder, "frame.poly --inside hull")),
        format!("{summary}\ninside 10 of 10 triangles: rule hull, as --inside says\n")
    );
}

#[test]
fn seeds_may_be_fractions() {
    let fractions = FRAME.replace("1 4 5\n", "1 10/3 16/3\n");
    let folder = folder(&[("frame.poly", &fractions)]);
    let output = run(&folder, "frame.poly -o - --output-format ele");
    assert_eq!(printed(&output), FRAME_ELE);
}

#[test]
fn every_format_holds_what_is_inside() {
    let folder = folder(&[("frame.json", FRAME_JSON), ("frame.poly", FRAME)]);
    let frame = object(&folder, "frame.json --inside even-odd");
    assert_eq!(frame["triangles"][0], json!([0, 1, 5]));
    assert_eq!(frame["triangles"].as_array().map(Vec::len), Some(8));
    // Nothing lies beyond the hull and in the hole.
    assert_eq!(frame["neighbors"][0], json!([4, 2, null]));
    assert_eq!(frame["neighbors"][2], json!([null, 1, 0]));
    assert_eq!(frame["constrained"].as_array().map(Vec::len), Some(8));
    assert_eq!(frame["boundary"], json!([[0, 1, 2, 3], [4, 7, 6, 5]]));
    assert_eq!(frame["regions"], Value::Null);
    assert_eq!(object(&folder, "frame.json")["boundary"], Value::Null);
    let regions = object(&folder, "frame.poly")["regions"].clone();
    assert_eq!(regions, json!([0, 0, 0, 0, 0, 0, 0, 0]));

    printed(&run(
        &folder,
        "frame.json --inside even-odd -o frame.obj -o frame.svg -o frame.ele",
    ));
    let text = |name| fs::read_to_string(folder.path().join(name)).expect("a text");
    assert_eq!(lines(&text("frame.obj"), "f "), 8);
    assert_eq!(lines(&text("frame.obj"), "v "), 8);
    let svg = text("frame.svg");
    assert!(svg.contains("triangles: 8") && svg.contains("border: 8"));
    // The hull goes round it, and can be told from the border.
    assert!(svg.contains("<path class=\"outside\" d=\"M") && svg.contains("hull: 4"));
    let area = svg.lines().find(|line| line.contains("class=\"hull\""));
    assert_eq!(area.map(|path| path.matches('M').count()), Some(2));
    // The diagonal of the hole is not drawn.
    let sides = |svg: &str| {
        let mut lines = svg.lines();
        let path = lines.find(|line| line.contains("class=\"side\" d"));
        let (_, path) = path.and_then(|path| path.split_once("M")).expect("sides");
        let numbers = path.split(|c: char| !c.is_ascii_digit());
        let numbers = numbers.filter(|number| !number.is_empty()).count();
        numbers / 2 - path.matches('M').count() - 1
    };
    let whole = run(&folder, "frame.json -o - --output-format svg");
    assert_eq!([sides(&svg), sides(printed(&whole))], [8, 9]);
    assert!(printed(&whole).contains("hull: 4"));
    assert!(!printed(&whole).contains("class=\"outside"));
}

#[test]
fn an_outline_that_is_open_keeps_nothing() {
    // The first edge is the second one once more.
    let open = FRAME.replace("1 1 2\n", "1 2 3\n");
    let open = open.replace("1\n1 1 2 0.5\n", "0\n");
    let folder = folder(&[("open.poly", &open)]);
    let summary = "open.poly: points 8, duplicates 0, edges 8, triangles 10, hull 4\n\
                   inside 0 of 10 triangles: rule holes, as the input has 1 hole; --inside hull keeps all\n";
    // The outside comes in.
    let output = run(&folder, "open.poly");
    assert_eq!(printed_without_triangles(&output), summary);
    for rule in ["even-odd", "nonzero"] {
        let output = run(&folder, &format!("open.poly --inside {rule}"));
        let error =
            "open.poly: the edges are no closed rings: they do not go on at vertex 1, at (0, 0)";
        assert_fails(&output, error);
    }
}

#[test]
fn a_seed_that_tells_no_face_is_refused() {
    let way_out = "(--inside hull keeps all triangles)";
    for (line, with, error) in [
        (
            "1 4 5\n",
            "1 4 6\n",
            "hole 1 lies on the edge between vertices 7 and 8, at (4, 6)",
        ),
        ("1 4 5\n", "1 6 6\n", "hole 1 lies on vertex 7, at (6, 6)"),
        (
            "1 4 5\n",
            "1 4 9.5\n",
            "hole 1 lies outside of the hull, at (4, 9.5)",
        ),
        (
            "1 4 5\n",
            "1 nan 4\n",
            "hole 1 has a coordinate that is not finite",
        ),
        (
            "1 1 2 0.5",
            "1 5 4 0.5",
            "region 1 lies in a hole, or outside of the outline, at (5, 4)",
        ),
    ] {
        let folder = folder(&[("frame.poly", &FRAME.replace(line, with))]);
        let error = format!("frame.poly: the seed of {error}");
        let output = run(&folder, "frame.poly -o frame.ele");
        assert_fails(&output, &format!("{error} {way_out}"));
        assert_eq!(crate::names(folder.path()), ["frame.poly"]);
        assert_fails(&run(&folder, "frame.poly --inside holes"), &error);
        printed(&run(&folder, "frame.poly --inside hull"));
    }
}

#[test]
fn seeds_are_read_with_care() {
    for (line, with, error) in [
        ("1\n1 4 5\n", "2\n1 4 5\n", "21: the number is 1, not 2"),
        (
            "1\n1 4 5\n",
            "x\n1 4 5\n",
            "19: `x` is not a number of holes",
        ),
        (
            "1 4 5\n",
            "3 4 5\n",
            "20: the first number is 3, not 0 or 1",
        ),
        (
            "1 4 5\n",
            "1 4\n",
            "20: the line ends where a y coordinate should follow",
        ),
        ("1 4 5\n", "1 4 y\n", "20: `y` is not a coordinate"),
        (
            "1 2 0.5",
            "1 2 red",
            "22: `red` is not an attribute, a number",
        ),
        (
            "1 2 0.5",
            "1 2 inf",
            "22: `inf` is not an attribute, a number",
        ),
        (
            "1\n1 1 2 0.5\n",
            "2\n1 1 2\n",
            "22: the file ends where region 2 of 2 should follow",
        ),
    ] {
        let folder = folder(&[("frame.poly", &FRAME.replace(line, with))]);
        assert_fails(&run(&folder, "frame.poly"), &format!("frame.poly:{error}"));
    }
    // Without them the file may end.
    let end = FRAME.find("1\n1 4 5").expect("the holes");
    let folder = folder(&[("frame.poly", &FRAME[..end])]);
    let summary = "frame.poly: points 8, duplicates 0, edges 8, triangles 10, hull 4\n\
                   inside 10 of 10 triangles: rule hull, as the input has no holes and no polygons; --inside holes \
                   keeps what edges enclose\n";
    assert_eq!(printed(&run(&folder, "frame.poly")), summary);
}
