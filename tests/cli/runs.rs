//! Settings and summary.

use crate::{CONTOURS, FORMATS, printed, run, run_with_input};

#[test]
fn inputs_without_triangles_are_no_errors() {
    let inputs = [
        (r#"{"points":[]}"#, "points 0, duplicates 0, edges 0"),
        (
            r#"{"points":[[1,2],[1,2]],"edges":[[0,1]]}"#,
            "points 2, duplicates 1, edges 1",
        ),
        (
            r#"{"points":[[0,0],[1,1],[5,5]],"edges":[[0,2]]}"#,
            "points 3, duplicates 0, edges 1",
        ),
        (
            r#"{"points":[[-1.7e308,0],[1.7e308,0]]}"#,
            "points 2, duplicates 0, edges 0",
        ),
    ];
    for (input, counts) in inputs {
        let output = run_with_input("- --input-format json", input.as_bytes());
        assert_eq!(
            printed(&output),
            format!("standard input: {counts}, triangles 0, hull 0\n")
        );
        for format in ["ele", "json", "obj", "svg"] {
            let output = run_with_input(
                &format!("- --input-format json -o - --output-format {format}"),
                input.as_bytes(),
            );
            assert!(!printed(&output).contains("NaN"), "{format} of {input}");
        }
    }
}

#[test]
fn settings_change_no_byte() {
    let settings = [
        "--front skip-list",
        "--front linear",
        "--scalar rational",
        "--heuristics paper",
        "--no-narrow-corners",
        "--no-basins",
        "--no-narrow-corners --no-basins --front skip-list --scalar rational",
    ];
    let all = ["ele", "json", "obj", "svg"].as_slice();
    for (input, formats) in [
        ("ten.poly", all),
        ("thirds.json", all),
        (CONTOURS, &["json"]),
    ] {
        for format in formats {
            let run = |more: &str| {
                run(
                    FORMATS,
                    &format!("{input} -o - --output-format {format} {more}"),
                )
            };
            let expected = run("");
            for more in settings {
                assert!(
                    printed(&run(more)) == printed(&expected),
                    "{input} to {format} {more}"
                );
            }
        }
    }
}

/// Enough points for several bands, and every other piece of a path through all of them.
#[test]
fn threads_change_no_byte() {
    const N: u64 = 120_000;
    let point = |i: u64| format!("[{},{i}]", i * i % 307);
    let list = |text: Vec<String>| text.join(",");
    let points = list((0..N).map(point).collect());
    let edges = list(
        (0..N / 2)
            .map(|i| format!("[{},{}]", 2 * i, 2 * i + 1))
            .collect(),
    );
    let input = format!(r#"{{"points":[{points}],"edges":[{edges}]}}"#);
    let run = |more: &str| {
        let arguments = "- --input-format json -o - --output-format json";
        run_with_input(&format!("{arguments} {more}"), input.as_bytes())
    };
    let expected = run("--threads 1");
    for more in ["", "--threads 2", "--threads 3"] {
        assert!(printed(&run(more)) == printed(&expected), "{more}");
    }
}

/// The number in a row of `--stats`.
fn row(settings: &str, name: &str) -> u64 {
    let output = run(
        FORMATS,
        &format!("{CONTOURS} --stats --heuristics paper {settings}"),
    );
    let number = |line: &str| {
        line.strip_prefix(name)?
            .trim()
            .replace(',', "")
            .parse()
            .ok()
    };
    let found = printed(&output).lines().find_map(number);
    found.expect("a row of that name")
}

#[test]
fn each_setting_is_heeded() {
    for (setting, name) in [
        ("--no-narrow-corners", "triangles: narrow corners"),
        ("--no-basins", "triangles: basins"),
        ("--front skip-list", "front steps"),
    ] {
        assert!(row("", name) > 0, "{name}");
        assert_eq!(row(setting, name), 0, "{setting}");
    }
}
