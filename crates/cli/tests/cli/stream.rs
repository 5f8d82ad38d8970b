//! `sweep-cdt stream`: its triangles are those of `sweep-cdt triangulate`, from every format, in little memory and in
//! small windows; what is refused, and what is left of a run that keeps too much alive.

use std::fs;
use std::path::Path;
use std::process::{Output, Stdio};

use serde_json::{Value, json};
use sweep_cdt_testing::Input;
use sweep_cdt_testing::data::Hard;
use tempfile::TempDir;

use crate::outputs::assert_refused;
use crate::{CONTOURS, FORMATS, assert_fails, folder, names, printed, run, sweep_cdt, text};

/// Settings that change time and memory, and no triangle.
const SETTINGS: [&str; 4] = [
    "--window 1",
    "--window 7 --check",
    "--memory 60K --window 2000",
    "--memory 100K --check",
];

pub(crate) type Triangles = Vec<[u64; 3]>;

pub(crate) fn ran(folder: impl AsRef<Path>, arguments: &str) -> Output {
    let output = sweep_cdt(folder, arguments).output();
    output.expect("the command starts")
}

/// Triangles from their lowest corner on, sorted. None may be there twice.
fn set(mut triangles: Triangles) -> Triangles {
    for corners in &mut triangles {
        let lowest = (0..3).min_by_key(|&i| corners[i]).unwrap_or(0);
        corners.rotate_left(lowest);
    }
    triangles.sort_unstable();
    assert!(
        triangles.is_sorted_by(|a, b| a < b),
        "a triangle is there twice"
    );
    triangles
}

/// The triangles that a file holds.
fn triangles(bytes: &[u8], extension: &str) -> Triangles {
    let numbers: Vec<u64> = match extension {
        "u32" => {
            let (numbers, rest) = bytes.as_chunks();
            assert!(rest.is_empty());
            let wide = numbers
                .iter()
                .map(|&bytes| u32::from_le_bytes(bytes).into());
            wide.collect()
        }
        _ => {
            let (numbers, rest) = bytes.as_chunks();
            assert!(rest.is_empty());
            numbers
                .iter()
                .map(|&bytes| u64::from_le_bytes(bytes))
                .collect()
        }
    };
    let (triangles, rest) = numbers.as_chunks();
    assert!(rest.is_empty());
    triangles.to_vec()
}

/// What `sweep-cdt triangulate` finds for a file.
fn expected(folder: &TempDir, input: &str) -> Triangles {
    let made = ran(folder, &format!("triangulate {input} -o expected.json"));
    assert_eq!(made.status.code(), Some(0), "{}", text(&made.stderr));
    let json = fs::read(folder.path().join("expected.json")).expect("a file");
    let json: Value = serde_json::from_slice(&json).expect("JSON");
    set(serde_json::from_value(json["triangles"].clone()).expect("triangles"))
}

/// Asserts that `stream` and these arguments make these triangles, whatever the settings, and that `verify --stream`
/// accepts each file.
#[track_caller]
fn assert_streams(folder: &TempDir, arguments: &str, expected: &Triangles) {
    for (i, settings) in SETTINGS.iter().enumerate() {
        let extension = ["u32", "u64"][i % 2];
        let result = format!("t.{extension}");
        let made = ran(
            folder,
            &format!("stream {arguments} {settings} -o {result}"),
        );
        let verdict = printed(&made);
        assert_eq!(
            verdict.is_empty(),
            !settings.contains("--check"),
            "{verdict}"
        );
        let bytes = fs::read(folder.path().join(&result)).expect("a file");
        let found = set(triangles(&bytes, extension));
        assert!(found == *expected, "{arguments} {settings}");
        let verify = format!("verify --stream {arguments} {result} --level canonical");
        let report = ran(folder, &verify);
        assert!(printed(&report).starts_with("correct: "), "{verify}");
    }
    let piped = ran(folder, &format!("stream {arguments} -o -"));
    assert_eq!(text(&piped.stderr), "");
    assert_eq!(piped.status.code(), Some(0));
    assert!(
        set(triangles(&piped.stdout, "u64")) == *expected,
        "{arguments}"
    );
}

/// Writes points and edges as raw numbers.
fn write_raw(folder: &TempDir, input: &Input) {
    let points = input.points.as_flattened().iter();
    let points: Vec<u8> = points.flat_map(|number| number.to_le_bytes()).collect();
    let edges = input.edges.as_flattened().iter();
    let edges: Vec<u8> = edges.flat_map(|&end| (end as u64).to_le_bytes()).collect();
    fs::write(folder.path().join("p.f64"), points).expect("a file");
    fs::write(folder.path().join("e.u64"), edges).expect("a file");
}

/// Writes them as `.json` too.
fn write_both(folder: &TempDir, input: &Input) {
    write_raw(folder, input);
    let json = json!({ "points": input.points, "edges": input.edges });
    fs::write(folder.path().join("p.json"), json.to_string()).expect("a file");
}

#[test]
fn real_files_give_the_triangles_of_triangulate() {
    let folder = folder(&[]);
    for input in ["ten.poly", "split.poly", "split.node"] {
        let input = format!("{FORMATS}/{input}");
        let expected = expected(&folder, &input);
        assert_streams(&folder, &input, &expected);
    }
    let expected = expected(&folder, CONTOURS);
    for settings in ["--window 3000 --check", "--memory 1M --window 1"] {
        let made = ran(&folder, &format!("stream {CONTOURS} {settings} -o t.u32"));
        assert_eq!(made.status.code(), Some(0), "{}", text(&made.stderr));
        let bytes = fs::read(folder.path().join("t.u32")).expect("a file");
        assert!(set(triangles(&bytes, "u32")) == expected, "{settings}");
    }
}

#[test]
fn generated_files_of_all_formats_do_too() {
    let formats = ["ply", "node", "poly", "xyz", "csv", "txt"];
    for kind in ["contours 300", "lattice 200", "parcels 30", "circle 60"] {
        let folder = folder(&[]);
        for format in formats {
            let file = format!("a.{format}");
            printed(&ran(&folder, &format!("generate {kind} -o {file}")));
            // The points of a `.poly` may be in the `.node`, but these are not.
            let expected = expected(&folder, &file);
            assert!(!expected.is_empty());
            assert_streams(&folder, &file, &expected);
        }
    }
}

#[test]
fn raw_points_and_edges_do_too() {
    let mut inputs = vec![
        Input::generated("uniform", 2500, 3),
        Input::generated("segments", 500, 4),
        Input::generated("outlines", 400, 5),
    ];
    let twice = &mut inputs[0].points;
    twice.extend_from_within(100..200);
    for input in inputs {
        let folder = folder(&[]);
        write_both(&folder, &input);
        let expected = expected(&folder, "p.json");
        let few = match input.edges.is_empty() {
            true => "p.f64",
            false => "p.f64 --edges e.u64",
        };
        assert_streams(&folder, few, &expected);
    }
}

/// Each input that broke some program: its triangles, or the error that it must be.
#[test]
fn hard_inputs_do_too_or_are_refused() {
    let mut count = [0; 4];
    for hard in Hard::own() {
        let folder = folder(&[]);
        write_raw(&folder, &hard.input);
        let made = ran(
            &folder,
            "stream p.f64 --edges e.u64 --window 5 --check -o t.u64",
        );
        let (name, error) = (&hard.name, text(&made.stderr));
        let (kind, is_said) = match hard.expect.as_str() {
            "nonfinite" => (0, error.contains(" has a coordinate that is not finite")),
            "invalid_index" => (1, error.contains(", which does not exist: ")),
            "crossing" => (2, error.contains(" cross")),
            _ => (3, error.is_empty()),
        };
        count[kind] += 1;
        assert!(is_said, "{name}: {error}");
        assert_eq!(made.status.code(), Some(i32::from(kind < 3)), "{name}");
        if kind < 3 {
            assert_eq!(names(folder.path()), ["e.u64", "p.f64"], "{name}");
            continue;
        }
        write_both(&folder, &hard.input);
        let bytes = fs::read(folder.path().join("t.u64")).expect("a file");
        let expected = expected(&folder, "p.json");
        assert!(set(triangles(&bytes, "u64")) == expected, "{name}");
        let report = ran(&folder, "verify --stream p.f64 --edges e.u64 t.u64");
        assert!(printed(&report).starts_with("correct: "), "{name}");
    }
    // None of them has a coordinate that is not finite.
    assert!(count[1..].iter().all(|&count| count > 0), "{count:?}");
}

#[test]
fn no_points_and_points_on_a_line_have_no_triangles() {
    for points in ["", "1 2", "1 2, 1 2", "0 0, 1 1, 3 3", "-0 5, 0 7, 0.0 6"] {
        let folder = folder(&[]);
        write_raw(&folder, &Input::parse(points, ""));
        for arguments in [
            "stream p.f64 -o t.u32 --check",
            "verify --stream p.f64 t.u32",
        ] {
            assert!(
                printed(&ran(&folder, arguments)).starts_with("correct: "),
                "{points}"
            );
            assert_eq!(fs::read(folder.path().join("t.u32")).expect("a file"), b"");
        }
    }
}

#[test]
fn the_table_counts_what_came() {
    let folder = folder(&[]);
    let square = Input::parse("0 0, 4 0, 4 4, 0 4, 2 1, 4 4, 4 4", "0 5, 5 6, 1 2");
    write_raw(&folder, &square);
    for arguments in ["", "--stats -o t.u32", "--check"] {
        let output = ran(&folder, &format!("stream p.f64 --edges e.u64 {arguments}"));
        let table = printed(&output);
        let number = |name: &str| -> Option<&str> {
            let row = table
                .lines()
                .find(|line| line.trim_start().starts_with(name));
            row?.split_whitespace().last()
        };
        // The edge between two of the equal points has no length.
        for (name, value) in [
            ("points", "7"),
            ("edges", "2"),
            ("triangles", "4"),
            ("sides of the hull", "4"),
            ("equal points", "2"),
            ("windows", "1"),
            ("runs sorted", "1"),
            ("bytes of temporary files", "0"),
        ] {
            assert_eq!(number(name), Some(value), "{name}\n{table}");
        }
        let verdict =
            "correct: the result is the canonical constrained Delaunay triangulation of p.f64";
        let last = table.lines().last();
        assert_eq!(last == Some(verdict), arguments == "--check", "{table}");
    }
}

#[test]
fn wrong_input_is_named_as_the_file_numbers_it() {
    let crossing = "4 2\n1 0 0\n2 2 2\n3 0 2\n4 2 0\n3\n1 1 2\n2 1 4\n3 3 4\n";
    let from_0 = "4 2\n0 0 0\n1 2 2\n2 0 2\n3 2 0\n3\n0 0 1\n1 0 3\n2 2 3\n";
    let folder = folder(&[
        ("one.poly", crossing),
        ("zero.poly", from_0),
        ("end.poly", "3\n1 0 0\n2 1 0\n3 0 1\n2\n1 1 2\n2 2 4\n"),
        ("nan.node", "3 2\n1 0 0\n2 0 nan\n3 1 1\n"),
        ("no.node", "2\n1 0 0\n"),
    ]);
    let advice = "(where memory holds them, `sweep-cdt crossings` lists all that do)";
    write_raw(&folder, &Input::parse("0 0, 1 0, 0 1, inf 2", ""));
    let before = names(folder.path());
    for (arguments, error) in [
        (
            "one.poly",
            format!("one.poly: edges 1 and 3 cross {advice}"),
        ),
        (
            "one.poly --window 1 --memory 1K",
            format!("one.poly: edges 1 and 3 cross {advice}"),
        ),
        (
            "zero.poly",
            format!("zero.poly: edges 0 and 2 cross {advice}"),
        ),
        (
            "end.poly",
            "end.poly: edge 2 ends at point 4, which does not exist: the points are numbered \
             from 1 to 3"
                .to_owned(),
        ),
        (
            "p.f64",
            "p.f64: point 3 has a coordinate that is not finite".to_owned(),
        ),
        (
            "nan.node",
            "nan.node: point 2 has a coordinate that is not finite".to_owned(),
        ),
        (
            "no.node",
            "no.node:2: the file ends where vertex 2 of 2 should follow".to_owned(),
        ),
        (
            "missing.f64",
            "missing.f64: no such file or directory".to_owned(),
        ),
    ] {
        assert_fails(
            &ran(&folder, &format!("stream {arguments} -o t.u64")),
            &error,
        );
        assert_eq!(names(folder.path()), before);
    }
    fs::write(folder.path().join("p.f64"), [0; 40]).expect("a file");
    let error = "p.f64: the file has 40 bytes, and a point of two doubles takes 16: it is cut off, \
                 or holds something else";
    assert_fails(&ran(&folder, "stream p.f64 -o t.u64"), error);
    write_raw(&folder, &Input::parse("0 0, 1 0, 0 1", "0 1, 2 3"));
    let error = "e.u64: edge 1 ends at point 3, which does not exist: the points are numbered from \
                 0 to 2";
    assert_fails(&ran(&folder, "stream p.f64 --edges e.u64 -o t.u64"), error);
    assert_eq!(names(folder.path()), before);
}

/// Random points, and far above them many on one circle, all of whose triangles wait for the last.
fn under_a_circle() -> Input {
    let mut input = Input::generated("uniform", 800, 6);
    let circle = Input::generated("circle", 1500, 0);
    let [low, high] = [f64::min, f64::max].map(|best| {
        let all = circle.points.as_flattened().iter().copied();
        all.reduce(best).expect("points")
    });
    let place = |value: f64| (value - low) / (high - low);
    let above = circle.points.iter().map(|&[x, y]| [place(x), place(y)]);
    let top = input
        .points
        .iter()
        .fold(0.0, |top: f64, &[_, y]| top.max(y));
    input
        .points
        .extend(above.map(|[x, y]| [x * top, (y + 1.5) * top]));
    input
}

#[test]
fn what_is_final_is_kept_where_too_much_is_alive() {
    let folder = folder(&[("t.u64", "old")]);
    write_both(&folder, &under_a_circle());
    let expected = expected(&folder, "p.json");
    let settings = "--window 50 --memory 90K";
    let output = ran(&folder, &format!("stream p.f64 {settings} -o t.u64"));
    let error = text(&output.stderr);
    let ending = " (--memory allows more); what is final up to there is in t.u64.incomplete\n";
    assert!(error.starts_with("error: p.f64: "), "{error}");
    assert!(
        error.contains(" vertices are alive, more than the limit of 300: "),
        "{error}"
    );
    assert!(
        error.ends_with(ending) && error.lines().count() == 1,
        "{error}"
    );
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(
        names(folder.path()),
        [
            "e.u64",
            "expected.json",
            "p.f64",
            "p.json",
            "t.u64",
            "t.u64.incomplete"
        ]
    );
    assert_eq!(
        fs::read(folder.path().join("t.u64")).expect("a file"),
        b"old"
    );
    let part = fs::read(folder.path().join("t.u64.incomplete")).expect("a file");
    let part = set(triangles(&part, "u64"));
    assert!(
        part.len() > 1000 && part.len() < expected.len(),
        "{}",
        part.len()
    );
    assert!(
        part.iter()
            .all(|corners| expected.binary_search(corners).is_ok())
    );
    // Standard output gets no less.
    let output = ran(&folder, &format!("stream p.f64 {settings} -o -"));
    assert!(text(&output.stderr).ends_with("; what is final up to there is written\n"));
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(set(triangles(&output.stdout, "u64")), part);
    // Without an output there is nothing to keep.
    let output = ran(&folder, &format!("stream p.f64 {settings}"));
    assert!(text(&output.stderr).ends_with(" (--memory allows more)\n"));
    assert_eq!(output.status.code(), Some(1));
    // With more memory it goes well.
    assert_eq!(
        printed(&ran(&folder, "stream p.f64 --window 50 -o t.u64")),
        ""
    );
    let whole = fs::read(folder.path().join("t.u64")).expect("a file");
    assert_eq!(set(triangles(&whole, "u64")), expected);
}

/// A window does not grow to more than memory holds: here it would take all that comes.
#[test]
fn windows_grow_as_far_as_memory_allows() {
    let folder = folder(&[]);
    write_raw(&folder, &Input::generated("circle", 100_000, 0));
    let stream = |memory: u32| ran(&folder, &format!("stream p.f64 --memory {memory} -o t.u32"));
    let output = stream(300 * 40_000);
    let error = text(&output.stderr);
    let words = " vertices are alive, more than the limit of 40000: ";
    let alive = error.strip_prefix("error: p.f64: ");
    let alive = alive.and_then(|rest| rest.split_once(words)?.0.parse().ok());
    let alive: u32 = alive.unwrap_or_else(|| panic!("{error}"));
    assert!((40_001..=80_000).contains(&alive), "{alive}");
    assert_eq!(printed(&stream(300 * 100_000)), "");
}

#[test]
fn too_little_memory_says_how_much_is_enough() {
    let folder = folder(&[]);
    write_raw(&folder, &Input::generated("segments", 1000, 1));
    let stream = |memory: &str| {
        let arguments = format!("stream p.f64 --edges e.u64 --memory {memory} -o t.u64");
        ran(&folder, &arguments)
    };
    let output = stream("2KiB");
    let error = text(&output.stderr);
    let words = "error: 2.0 KiB of memory do not suffice to sort so much: --memory ";
    let enough = error
        .strip_prefix(words)
        .and_then(|rest| rest.strip_suffix(" does\n"));
    let enough = enough.unwrap_or_else(|| panic!("{error}"));
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(names(folder.path()), ["e.u64", "p.f64"]);
    assert_eq!(printed(&stream(enough)), "");
}

#[test]
fn a_folder_for_temporary_files_that_is_not_there_is_named() {
    let folder = folder(&[]);
    write_raw(&folder, &Input::generated("uniform", 1000, 1));
    let arguments = "stream p.f64 --memory 60K --temporary missing -o t.u64";
    let error = "missing: no such file or directory, after 0 bytes of temporary files; another \
                 folder may have room for them (--temporary names one)";
    assert_fails(&ran(&folder, arguments), error);
    assert_eq!(names(folder.path()), ["e.u64", "p.f64"]);
}

#[test]
fn what_is_read_is_not_overwritten() {
    let folder = folder(&[
        ("a.poly", "0 2\n1\n0 0 1\n"),
        ("a.node", "3 2\n0 0 0\n1 1 0\n2 0 1\n"),
    ]);
    write_raw(&folder, &Input::parse("0 0, 1 0, 0 1", "0 1"));
    fs::copy(folder.path().join("p.f64"), folder.path().join("p.u64")).expect("a copy");
    fs::copy(
        folder.path().join("e.u64"),
        folder.path().join("e.u64.incomplete"),
    )
    .expect("a copy");
    // Only Unix tells that a hard link is the same file.
    if cfg!(unix) {
        let hard = folder.path().join("hard.u32");
        fs::hard_link(folder.path().join("a.node"), hard).expect("a link");
        let message = "hard.u32 is an input and would be overwritten";
        assert_refused(&folder, "stream a.poly -o hard.u32", message);
    }
    for (arguments, name) in [
        ("p.f64 --edges e.u64 -o e.u64", "e.u64"),
        ("p.f64 --edges e.u64 -o ./e.u64", "./e.u64"),
        ("p.u64 --stream-format f64 -o p.u64", "p.u64"),
        (
            "p.f64 --edges e.u64.incomplete -o e.u64",
            "e.u64.incomplete",
        ),
    ] {
        let message = format!("{name} is an input and would be overwritten");
        assert_refused(&folder, &format!("stream {arguments}"), &message);
    }
    assert_eq!(
        printed(&ran(&folder, "stream p.f64 --edges e.u64 -o t.u64")),
        ""
    );
}

#[test]
fn wrong_usage_says_what_to_do() {
    let folder = folder(&[("a.json", "{}"), ("a.ele", "")]);
    write_raw(&folder, &Input::parse("0 0, 1 0, 0 1", ""));
    for (arguments, message) in [
        (
            "stream p.f64 -o t.ele",
            "t.ele is no name for triangles of a stream: let it end in .u32 or .u64",
        ),
        (
            "stream a.json -o t.u32",
            "the format of a.json is not known: add --stream-format with one of f64, ply, node, \
             poly, csv, xyz, txt",
        ),
        (
            "stream - --stream-format f64 -o t.u32",
            "a stream is read from a file, since its size must be known: write INPUT to a file",
        ),
        (
            "stream p.f64 -o - --stats",
            "--stats and `-o -` would both write to standard output",
        ),
        (
            "stream p.f64 --window 0",
            "invalid value '0' for '--window <N>': number would be zero for non-zero type",
        ),
        (
            "verify --stream p.f64 a.ele",
            "a.ele is no name for triangles of a stream: let it end in .u32 or .u64",
        ),
        (
            "verify --stream p.f64 -",
            "triangles of a stream are read from a file: .u32 or .u64",
        ),
        (
            "verify p.f64 a.ele --edges e.u64",
            "--edges is for --stream",
        ),
        ("verify p.f64 a.ele --memory 1G", "--memory is for --stream"),
        (
            "verify --stream p.f64 t.u32 --svg a.svg",
            "the argument '--stream' cannot be used with '--svg <FILE>'",
        ),
        (
            "verify --stream p.f64 t.u32 --by-number",
            "the argument '--stream' cannot be used with '--by-number'",
        ),
        (
            "verify --stream p.f64 t.u32 --limit 3",
            "the argument '--stream' cannot be used with '--limit <N>'",
        ),
        (
            "verify --stream p.f64 t.u32 --scalar rational",
            "the argument '--stream' cannot be used with '--scalar <SCALAR>'",
        ),
    ] {
        assert_refused(&folder, arguments, message);
    }
}

#[test]
fn a_reader_that_has_enough_is_no_failure() {
    let folder = folder(&[]);
    write_raw(&folder, &Input::generated("uniform", 20_000, 2));
    let mut child = sweep_cdt(&folder, "stream p.f64 --window 100 -o -")
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the command starts");
    // More than a pipe holds is written, and nobody reads.
    drop(child.stdout.take());
    assert_eq!(
        printed(&child.wait_with_output().expect("the command ends")),
        ""
    );
}

/// The triangles of fractions are no stream of doubles.
#[test]
fn fractions_are_refused() {
    let output = ran(FORMATS, "stream thirds.poly");
    let error = text(&output.stderr);
    assert!(error.starts_with("error: thirds.poly:3: `1/3` "), "{error}");
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(run(FORMATS, "thirds.poly").status.code(), Some(0));
}
