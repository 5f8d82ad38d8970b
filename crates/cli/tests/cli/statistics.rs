//! `--stats-json`: which members there are, and of what type; that they agree with each other and with the input; where
//! they go.

use std::fs;

use serde_json::Value;

use crate::outputs::{TRIANGLE, assert_refused, read};
use crate::{
    CONTOURS, FORMATS, folder, names, printed, printed_without_triangles, run, run_with_input,
};

/// Every member in its order. Programs rely on these names: none may go or change.
const MEMBERS: &str = "\
program text
version text
points count
duplicates count
edges count
triangles count
hull count
initialization number
sweeping number
finalization number
is_divided truth
memory count
counters.orient2d_filtered count
counters.orient2d_integers count
counters.orient2d_expansions count
counters.orient2d_big count
counters.orient2d_own count
counters.in_circle_filtered count
counters.in_circle_integers count
counters.in_circle_expansions count
counters.in_circle_big count
counters.in_circle_own count
counters.symbolic count
counters.cocircular count
counters.legalization_tests count
counters.flips count
counters.most_tests count
counters.most_flips count
counters.front_steps count
counters.point_events count
counters.front_lengths count
counters.longest_front count
counters.left_cases count
counters.edges_present count
counters.edges_inserted count
counters.pierced count
counters.made.first count
counters.made.middle count
counters.made.left count
counters.made.narrow_corners count
counters.made.basins count
counters.made.pockets count
counters.made.pseudo_polygons count
counters.made.hull count
counters.made.divide_and_conquer count
counters.made.flips count
counters.survived.first count
counters.survived.middle count
counters.survived.left count
counters.survived.narrow_corners count
counters.survived.basins count
counters.survived.pockets count
counters.survived.pseudo_polygons count
counters.survived.hull count
counters.survived.divide_and_conquer count
counters.survived.flips count
means.tests number
means.flips number
means.front number
";

/// The members of an object with their types, each on a line; of those in it with their paths.
fn members(path: &str, object: &Value, lines: &mut Vec<String>) {
    for (name, value) in object.as_object().expect("an object") {
        let path = format!("{path}{name}");
        let kind = match value {
            Value::Object(_) => {
                members(&format!("{path}."), value, lines);
                continue;
            }
            Value::Number(number) if number.is_u64() => "count",
            Value::Number(_) => "number",
            Value::String(_) => "text",
            Value::Bool(_) => "truth",
            _ => panic!("{path}: {value}"),
        };
        lines.push(format!("{path} {kind}\n"));
    }
}

fn json(text: &str) -> Value {
    serde_json::from_str(text).expect("JSON")
}

/// The statistics of a run on the contour lines.
fn of_contours(more: &str) -> Value {
    let output = run(FORMATS, &format!("{CONTOURS} --stats-json - {more}"));
    json(printed(&output))
}

#[test]
fn the_members_and_their_types_are_these() {
    let mut lines = Vec::new();
    members("", &of_contours(""), &mut lines);
    // The order is that of the text, which a map of JSON does not keep.
    let mut expected: Vec<String> = MEMBERS.lines().map(|line| format!("{line}\n")).collect();
    expected.sort();
    lines.sort();
    assert_eq!(lines.concat(), expected.concat());
}

/// All but the times and the version.
fn steady(more: &str) -> Value {
    let mut object = of_contours(more);
    for time in ["initialization", "sweeping", "finalization"] {
        let seconds = object[time].as_f64().expect("a number");
        assert!(seconds > 0.0 && seconds < 60.0, "{time}: {seconds}");
        object[time] = Value::Null;
    }
    object
}

#[test]
fn numbers_are_those_of_the_input_and_agree() {
    let found = steady("");
    assert_eq!(found, steady(""), "the same in every run");
    for (name, expected) in [("points", 23_036), ("edges", 22_850), ("duplicates", 0)] {
        assert_eq!(found[name], expected, "{name}");
    }
    let count = |path: &str| {
        found
            .pointer(path)
            .and_then(Value::as_u64)
            .expect("a count")
    };
    let sum = |path: &str| {
        let all = found
            .pointer(path)
            .and_then(Value::as_object)
            .expect("an object");
        all.values()
            .map(|value| value.as_u64().expect("a count"))
            .sum::<u64>()
    };
    assert_eq!(sum("/counters/survived"), count("/triangles"));
    assert_eq!(
        count("/counters/made/middle"),
        23_035,
        "one for each point but the first"
    );
    assert_eq!(count("/counters/made/flips"), 2 * count("/counters/flips"));
    // Each step makes one triangle: no more are left than were made and not removed, nor fewer flipped.
    let steps = sum("/counters/made") - count("/counters/made/flips");
    let mean = |name: &str| found["means"][name].as_f64().expect("a number");
    for (name, path) in [("tests", "legalization_tests"), ("flips", "flips")] {
        let expected = count(&format!("/counters/{path}")) as f64 / steps as f64;
        assert!((mean(name) - expected).abs() < 1e-12, "{name}");
        let most = count(&format!("/counters/most_{name}")) as f64;
        assert!(most >= mean(name).ceil() && most < 1000.0, "{name}: {most}");
    }
    let front = mean("front");
    assert!(
        front > 10.0 && front < count("/counters/longest_front") as f64,
        "{front}"
    );
}

#[test]
fn divide_and_conquer_makes_all_triangles() {
    let found = steady("--algorithm divide-and-conquer");
    assert_eq!(found["is_divided"], true);
    let survived = found["counters"]["survived"]
        .as_object()
        .expect("an object");
    let all: u64 = survived.values().filter_map(Value::as_u64).sum();
    assert_eq!(found["triangles"], all);
    assert!(survived["divide_and_conquer"].as_u64() > Some(all / 2));
    assert_eq!(survived["middle"], 0);
}

#[test]
fn statistics_go_where_they_are_sent() {
    let folder = folder(&[("a.json", TRIANGLE)]);
    let summary = "a.json: points 3, duplicates 0, edges 0, triangles 1, hull 3\n";
    assert_eq!(
        printed(&run(&folder, "a.json --stats-json s.json")),
        summary
    );
    assert_eq!(json(&read(&folder, "s.json"))["triangles"], 1);
    // Beside the table; and in the place of the summary and of the verdict.
    let table = run(&folder, "a.json --stats --stats-json s.json");
    assert!(printed(&table).starts_with("points "));
    let object = run(&folder, "a.json -o a.obj --verify --stats-json -");
    assert_eq!(json(printed(&object))["hull"], 3);
    assert_eq!(
        printed(&run(
            &folder,
            "a.json -o - --output-format obj --stats-json t.json"
        )),
        read(&folder, "a.obj")
    );
    assert_eq!(json(&read(&folder, "t.json"))["hull"], 3);
    // Without points.
    let none = run_with_input("- --input-format json --stats-json -", br#"{"points": []}"#);
    let none = json(printed_without_triangles(&none));
    assert_eq!(
        (&none["triangles"], &none["means"]["flips"]),
        (&0.into(), &0.0.into())
    );
    assert_eq!(
        names(folder.path()),
        ["a.json", "a.obj", "s.json", "t.json"]
    );
}

#[test]
fn two_things_in_one_place_are_refused() {
    let folder = folder(&[("a.json", TRIANGLE), ("s.json", "old")]);
    let same = |one, other| format!("{one} and {other} would both write to standard output");
    for (arguments, message) in [
        (
            "--stats-json - -o - --output-format obj",
            same("`--stats-json -`", "`-o -`"),
        ),
        (
            "--stats-json - --stats",
            same("--stats", "`--stats-json -`"),
        ),
        (
            "--stats -o - --output-format obj",
            same("--stats", "`-o -`"),
        ),
        (
            "--stats-json a.json",
            "a.json is an input and would be overwritten".to_owned(),
        ),
        (
            "--stats-json s.json -o s.json",
            "s.json and s.json are the same file and would both be written".to_owned(),
        ),
        (
            "--stats-json x.node -o x.ele",
            "x.node and x.node are the same file and would both be written".to_owned(),
        ),
    ] {
        assert_refused(
            &folder,
            &format!("triangulate a.json {arguments}"),
            &message,
        );
    }
    let failed = run(&folder, "a.json -o missing/a.obj --stats-json s.json");
    assert_eq!(failed.status.code(), Some(1));
    assert_eq!(
        fs::read_to_string(folder.path().join("s.json")).expect("a file"),
        "old"
    );
}
