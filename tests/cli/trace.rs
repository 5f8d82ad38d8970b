//! Traces: recorded, replayed, refused.

use std::fs;
use std::process::Output;

use serde_json::Value;

use crate::{FORMATS, assert_fails, feed, folder, names, printed, sweep_cdt, text};

fn run(arguments: &str) -> Output {
    let output = sweep_cdt(FORMATS, arguments).output();
    output.expect("the command starts")
}

fn replay(trace: &[u8]) -> Output {
    feed(&mut sweep_cdt(FORMATS, "replay -"), trace)
}

/// The triangles of an input as `replay` prints them.
fn triangles(input: &str) -> String {
    let output = run(&format!("triangulate {input} -o - --output-format json"));
    let json: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let list = json["triangles"].as_array().expect("triangles");
    let line = |triangle: &Value| format!("{} {} {}\n", triangle[0], triangle[1], triangle[2]);
    list.iter().map(line).collect()
}

#[test]
fn replay_prints_the_triangles_of_the_result() {
    for input in ["ten.poly", "thirds.json", "split.poly"] {
        for settings in [
            "",
            "--output-format jsonl",
            "--heuristics paper --front skip-list",
        ] {
            let trace = run(&format!("trace {input} {settings}"));
            let replayed = replay(printed(&trace).as_bytes());
            assert_eq!(printed(&replayed), triangles(input), "{input} {settings}");
        }
    }
}

#[test]
fn fronts_and_scalars_take_the_same_steps() {
    let trace = run("trace ten.poly");
    for settings in ["--front skip-list", "--front linear", "--scalar rational"] {
        let other = run(&format!("trace ten.poly {settings}"));
        assert_eq!(printed(&other), printed(&trace));
    }
}

#[test]
fn files_are_written_by_their_extension() {
    let folder = folder(&[]);
    for (extension, option) in [("txt", ""), ("jsonl", "--output-format jsonl")] {
        let path = folder.path().join("steps").with_extension(extension);
        let written = run(&format!("trace ten.poly -o {}", path.display()));
        assert_eq!(printed(&written), "");
        let printed_directly = run(&format!("trace ten.poly {option}"));
        assert_eq!(
            fs::read_to_string(&path).expect("a file"),
            printed(&printed_directly)
        );
    }
    let refused = run("trace ten.poly -o steps.svgz");
    assert_eq!(refused.status.code(), Some(2));
    let advice = "is not known: add --output-format with one of txt, jsonl, html, svg\n";
    assert!(text(&refused.stderr).contains(advice));
    let path = folder.path().join("steps.svgz");
    let given = format!("trace ten.poly -o {} --output-format jsonl", path.display());
    assert_eq!(printed(&run(&given)), "");
    let lines = fs::read_to_string(folder.path().join("steps.jsonl"));
    assert_eq!(
        fs::read_to_string(path).expect("a file"),
        lines.expect("a file")
    );
}

/// What `trace` draws of `ten.poly` in a file with this name.
fn drawn(name: &str, arguments: &str) -> String {
    let folder = folder(&[]);
    let path = folder.path().join(name);
    let output = run(&format!("trace ten.poly -o {} {arguments}", path.display()));
    assert_eq!(printed(&output), "");
    assert_eq!(names(folder.path()), [name]);
    fs::read_to_string(&path).expect("a file")
}

/// The JSON in a page.
fn steps_in(page: &str) -> Value {
    let start = "<script type=\"application/json\" id=\"trace\">";
    let (_, rest) = page.split_once(start).expect("the steps");
    let (json, _) = rest.split_once("</script>").expect("an end of the steps");
    serde_json::from_str(json).expect("JSON")
}

#[test]
fn the_page_holds_all_steps_and_loads_nothing() {
    let page = drawn("steps.html", "");
    assert!(page.starts_with("<!DOCTYPE html>") && page.ends_with("</html>\n"));
    for source in [
        "http", "src=", "href=", "url(", "@import", "import ", "fetch(",
    ] {
        let found: Vec<&str> = page.lines().filter(|line| line.contains(source)).collect();
        let own = match source {
            "href=" => ["<link rel=\"icon\" href=\"data:,\">"].as_slice(),
            _ => &[],
        };
        assert_eq!(found, own, "{source}");
    }

    let trace = run("trace ten.poly");
    let lines = printed(&trace).lines().count();
    let shown = steps_in(&page);
    assert_eq!(shown["first"], 1);
    assert_eq!(shown["total"], lines - 1);
    let steps = shown["steps"].as_array().expect("steps");
    assert_eq!(steps.len(), lines - 1);
    assert_eq!(steps[0][1], "Vertex 0 is the next one in sweep order.");
    let last = &steps[lines - 2][1];
    assert!(
        last.as_str()
            .expect("a sentence")
            .starts_with("The triangulation has")
    );
}

#[test]
fn a_stretch_of_the_steps_is_drawn_on_demand() {
    let whole = steps_in(&drawn("steps.html", ""));
    let stretch = "--from 3 --to 6";
    let page = steps_in(&drawn("steps.html", stretch));
    assert_eq!(page["first"], 3);
    assert_eq!(page["total"], whole["total"]);
    let sentences = |page: &Value| {
        let steps = page["steps"].as_array().expect("steps").iter();
        let sentence = |step: &Value| step[1].as_str().expect("a sentence").to_owned();
        steps.map(sentence).collect::<Vec<_>>()
    };
    let expected = &sentences(&whole)[2..6];
    assert_eq!(sentences(&page), expected);

    let sheet = drawn("steps.svg", stretch);
    let of_class = |class: &str| {
        let start = format!("<text class=\"{class}\"");
        let lines = sheet.lines().filter(|line| line.starts_with(&start));
        let text = |line: &str| Some(line.split_once('>')?.1.strip_suffix("</text>")?.to_owned());
        lines
            .map(|line| text(line).expect("a text"))
            .collect::<Vec<_>>()
    };
    assert_eq!(of_class("caption"), expected);
    let numbers = of_class("title");
    let numbers: Vec<_> = numbers
        .iter()
        .filter_map(|title| title.split(' ').next())
        .collect();
    assert_eq!(numbers, ["3", "4", "5", "6"]);
    // The namespace is a name, not a place.
    assert_eq!(sheet.matches("http").count(), 1);
    assert!(sheet.contains("xmlns=\"http://www.w3.org/2000/svg\""));
}

#[test]
fn steps_that_there_are_not_are_refused() {
    let input = format!("{FORMATS}/ten.poly");
    let trace = run("trace ten.poly");
    let last = printed(&trace).lines().count() - 1;
    let folder = folder(&[]);
    for extension in ["txt", "jsonl", "html", "svg"] {
        let run = |range: &str| {
            let arguments = format!("trace {input} -o steps.{extension} {range}");
            let output = sweep_cdt(&folder, &arguments).output();
            output.expect("the command starts")
        };
        for range in [
            "--from 6 --to 5",
            "--from 0",
            "--to 0",
            "--to -1",
            "--from x",
        ] {
            let refused = run(range);
            assert_eq!(refused.status.code(), Some(2), "{range}");
            assert!(text(&refused.stderr).starts_with("error: "), "{range}");
        }
        let error = format!("{input}: there is no step 99999; the last step is {last}");
        assert_fails(&run("--from 99999"), &error);
        assert_eq!(names(folder.path()), Vec::<String>::new());
    }
    let rest = run(&format!("trace ten.poly --from {last} --to 99999"));
    assert_eq!(printed(&rest).lines().count(), 2);
}

#[test]
fn a_stretch_of_the_steps_is_written_on_demand() {
    let whole = run("trace ten.poly");
    let lines: Vec<&str> = printed(&whole).lines().collect();
    let part = run("trace ten.poly --from 4 --to 6");
    let expected = [
        "sweep-cdt trace 3 from step 4",
        lines[4],
        lines[5],
        lines[6],
    ];
    assert_eq!(printed(&part).lines().collect::<Vec<_>>(), expected);
    assert_fails(
        &replay(&part.stdout),
        "standard input:1: the trace lacks its first 3 steps",
    );
}

#[test]
fn what_is_no_trace_is_refused_by_line() {
    assert_fails(
        &replay(b"sweep-cdt trace 3\nsorted 0\nhello\n"),
        "standard input:3: is no step: \"hello\"",
    );
    assert_fails(
        &replay(b"\xff"),
        "standard input:1: is not the header `sweep-cdt trace 3`",
    );
    assert_fails(
        &run("replay nowhere.txt"),
        "nowhere.txt: no such file or directory",
    );
}

#[test]
fn wrong_input_leaves_no_file() {
    let crossing = r#"{"points":[[0,0],[1,1],[0,1],[1,0]],"edges":[[0,1],[2,3]]}"#;
    let folder = folder(&[("crossing.json", crossing)]);
    let output = sweep_cdt(&folder, "trace crossing.json -o steps.txt").output();
    assert_fails(
        &output.expect("the command starts"),
        "crossing.json: edges 0 and 1 cross",
    );
    assert_eq!(names(folder.path()), ["crossing.json"]);
}
