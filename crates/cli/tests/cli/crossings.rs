//! Edges that cross: listed, drawn, and split.

use std::fs;

use crate::{
    FORMATS, assert_fails, feed, folder, names, printed, printed_despite_losses, run, sweep_cdt,
    text,
};

/// Three edges, of which the first crosses both others; numbered from 1.
const POLY: &str = "6\n1 0 0\n2 3 1\n3 0 1\n4 3 0\n5 1 0\n6 1 1\n4\n1 1 2\n2 3 4\n3 5 6\n4 2 3\n";
/// The input of `POLY` in fractions: the first coordinate is not a double.
const THIRDS: &str =
    r#"{"points": [["0/1",0],[3,1],[0,1],[3,0],[1,0],[1,1]], "edges": [[0,1],[2,3],[4,5],[1,2]]}"#;

const LIST: &str = "\
edge,other,x,y,near_x,near_y
1,2,3/2,1/2,1.5,0.5
1,3,1,1/3,1,0.3333333333333333
2,3,1,2/3,1,0.6666666666666666
";

#[test]
fn all_pairs_are_listed_as_the_file_numbers_them() {
    let folder = folder(&[("a.poly", POLY), ("b.json", THIRDS)]);
    let listed = |arguments: &str| {
        let output = sweep_cdt(&folder, &format!("crossings {arguments}")).output();
        let output = output.expect("the command starts");
        assert_eq!(text(&output.stderr), "");
        assert_eq!(output.status.code(), Some(1), "{arguments}");
        text(&output.stdout).to_owned()
    };
    let report = "a.poly: edges 4, crossings 3\n";
    let pairs = "edges 1 and 2 cross near (1.5, 0.5)\n\
                 edges 1 and 3 cross near (1, 0.3333333333333333)\n\
                 edges 2 and 3 cross near (1, 0.6666666666666666)\n";
    assert_eq!(listed("a.poly"), format!("{report}{pairs}"));
    let exact = "edges 1 and 2 cross near (1.5, 0.5), exactly at (3/2, 1/2)\n\
                 edges 1 and 3 cross near (1, 0.3333333333333333), exactly at (1, 1/3)\n\
                 edges 2 and 3 cross near (1, 0.6666666666666666), exactly at (1, 2/3)\n";
    assert_eq!(listed("a.poly --fractions"), format!("{report}{exact}"));
    let feature = |edges: &str, place: &str, near: &str| {
        format!(
            "{{\"type\":\"Feature\",\"properties\":{{{edges},{place}}},\"geometry\":{{\"type\":\"Point\",\"coordinates\":{near}}}}}"
        )
    };
    let features = [
        feature(
            "\"edge\":0,\"other\":1",
            "\"x\":\"3/2\",\"y\":\"1/2\"",
            "[1.5,0.5]",
        ),
        feature(
            "\"edge\":0,\"other\":2",
            "\"x\":\"1\",\"y\":\"1/3\"",
            "[1,0.3333333333333333]",
        ),
        feature(
            "\"edge\":1,\"other\":2",
            "\"x\":\"1\",\"y\":\"2/3\"",
            "[1,0.6666666666666666]",
        ),
    ];
    let collection = "{\"type\": \"FeatureCollection\", \"features\": [\n";
    assert_eq!(
        listed("b.json -o - --output-format geojson"),
        format!("{collection}{}]}}\n", features.join(",\n"))
    );
    assert_eq!(listed("a.poly -o - --output-format csv"), LIST);
    assert_eq!(listed("a.poly -o a.csv --svg a.svg"), report);
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).expect("a file");
    assert_eq!(read("a.csv"), LIST);
    // A dot for each crossing, and three close-ups.
    let picture = read("a.svg");
    assert_eq!(picture.matches("class=\"close-up\"").count(), 3);
    assert!(picture.contains("2: edges 1 and 3 cross"));
    assert_eq!(
        listed("b.json -o - --output-format json"),
        "{\"crossings\": [\n\
         {\"edges\":[0,1],\"point\":[\"3/2\",\"1/2\"],\"near\":[1.5,0.5]},\n\
         {\"edges\":[0,2],\"point\":[1,\"1/3\"],\"near\":[1,0.3333333333333333]},\n\
         {\"edges\":[1,2],\"point\":[1,\"2/3\"],\"near\":[1,0.6666666666666666]}]}\n"
    );
    assert_eq!(names(folder.path()), ["a.csv", "a.poly", "a.svg", "b.json"]);
}

#[test]
fn without_crossings_the_status_is_0() {
    let output = sweep_cdt(FORMATS, "crossings ten.poly").output();
    let output = output.expect("the command starts");
    let shown = printed(&output);
    assert!(shown.ends_with("crossings 0\n"), "{shown}");
    let none = feed(
        &mut sweep_cdt(
            FORMATS,
            "crossings - --input-format json -o - --output-format json",
        ),
        b"{\"points\": []}",
    );
    assert_eq!(printed(&none), "{\"crossings\": []}\n");
}

#[test]
fn wrong_inputs_and_usage_are_refused() {
    let folder = folder(&[("a.poly", POLY), ("b.json", r#"{"points": [["nan", 0]]}"#)]);
    for (arguments, status, error) in [
        (
            "crossings b.json",
            1,
            "b.json: vertex 0 has a coordinate that is not finite",
        ),
        (
            "crossings a.poly -o a.ele",
            2,
            "the format of a.ele is not known",
        ),
        (
            "crossings a.poly -o a.csv --svg a.csv",
            2,
            "are the same file",
        ),
        (
            "crossings a.poly --svg a.poly",
            2,
            "is an input and would be overwritten",
        ),
    ] {
        let output = sweep_cdt(&folder, arguments).output();
        let output = output.expect("the command starts");
        assert_eq!(output.status.code(), Some(status), "{arguments}");
        let message = text(&output.stderr);
        assert!(
            message.starts_with("error: ") && message.contains(error),
            "{message}"
        );
    }
    assert_eq!(names(folder.path()), ["a.poly", "b.json"]);
}

#[test]
fn edges_are_split_and_the_result_is_verified() {
    let folder = folder(&[("a.poly", POLY), ("b.json", THIRDS)]);
    let line = |name: &str, displacement: &str| {
        format!(
            "{name}: 4 edges split into 11, new vertices 3, rounds 1, \
             greatest displacement {displacement} units in the last place\n"
        )
    };
    let correct = |name: &str| {
        format!(
            "correct: the result is a constrained Delaunay triangulation of {name}, the canonical one\n"
        )
    };
    // 2/3 is rounded by a third of a unit there, which is half of one at 1, the largest y of edge 2. That has three
    // times the width and twice the unit in x: the distance is 3/5 of a sixth.
    let output = run(&folder, "a.poly --split-crossings --verify -o a.json");
    let expected = line("a.poly", "0.1") + &correct("the split edges of a.poly");
    assert_eq!(printed(&output), expected);
    let output = run(&folder, "b.json --split-crossings --verify -o c.json");
    assert_eq!(
        printed(&output),
        line("b.json", "0") + &correct("the split edges of b.json")
    );
    let output = run(
        &folder,
        "a.poly --split-crossings --scalar rational -o d.json",
    );
    assert_eq!(printed(&output), line("a.poly", "0"));

    let read = |name: &str| fs::read_to_string(folder.path().join(name)).expect("a file");
    let [rounded, exact] = ["a.json", "c.json"].map(read);
    assert_eq!(read("d.json"), exact);
    assert!(
        exact.contains("[\"3/2\",\"1/2\"],\n[1,\"1/3\"],\n[1,\"2/3\"]],\n"),
        "{exact}"
    );
    assert!(
        rounded.contains("[1.5,0.5],\n[1,0.3333333333333333],\n"),
        "{rounded}"
    );
    let chains = "\"split\": [\n[0,7,6,1],\n[2,8,6,3],\n[4,7,8,5],\n[1,5,2]]\n";
    for written in [&rounded, &exact] {
        assert!(written.contains(chains), "{written}");
    }
    // The points and pieces that were written are an input of which the triangles are the result.
    for name in ["a.json", "c.json"] {
        let output = sweep_cdt(&folder, &format!("verify {name} {name}")).output();
        let output = output.expect("the command starts");
        assert!(printed_despite_losses(&output).starts_with("correct: "));
    }
}

#[test]
fn splitting_changes_nothing_where_nothing_crosses() {
    let folder = folder(&[]);
    let ten = format!("{FORMATS}/ten.poly");
    run(&folder, &format!("{ten} -o a.ele -o a.svg"));
    run(
        &folder,
        &format!("{ten} --split-crossings -o b.ele -o b.svg"),
    );
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).expect("a file");
    assert_eq!(read("a.ele"), read("b.ele"));
    assert_eq!(read("a.node"), read("b.node"));
    assert_eq!(read("a.svg"), read("b.svg"));
    assert_fails(
        &run(FORMATS, "thirds.poly --split-crossings --scalar f64"),
        "thirds.poly: has fractions, which --scalar f64 refuses",
    );
}
