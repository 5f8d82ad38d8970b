//! `sweep-cdt stream`: its triangles are those of `sweep-cdt triangulate`, from every format, in little memory and in
//! small windows; and what its table says.

use std::fs;
use std::path::Path;
use std::process::Output;

use serde_json::{Value, json};
use sweep_cdt::triangulate;
use sweep_cdt_testing::Input;
use sweep_cdt_testing::data::Hard;
use tempfile::TempDir;

use crate::{
    CONTOURS, FORMATS, folder, names, printed, printed_despite_losses, sweep_cdt, text,
    without_losses,
};

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
pub(crate) fn set(mut triangles: Triangles) -> Triangles {
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
pub(crate) fn triangles(bytes: &[u8], extension: &str) -> Triangles {
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
pub(crate) fn expected(folder: &TempDir, input: &str) -> Triangles {
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
        let verdict = printed_despite_losses(&made);
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
    assert_eq!(without_losses(&piped.stderr), "");
    assert_eq!(piped.status.code(), Some(0));
    assert!(
        set(triangles(&piped.stdout, "u64")) == *expected,
        "{arguments}"
    );
}

/// Writes points and edges as raw numbers.
pub(crate) fn write_raw(folder: &TempDir, input: &Input) {
    let points = input.points.as_flattened().iter();
    let points: Vec<u8> = points.flat_map(|number| number.to_le_bytes()).collect();
    let edges = input.edges.as_flattened().iter();
    let edges: Vec<u8> = edges.flat_map(|&end| (end as u64).to_le_bytes()).collect();
    fs::write(folder.path().join("p.f64"), points).expect("a file");
    fs::write(folder.path().join("e.u64"), edges).expect("a file");
}

/// Writes them as `.json` too.
pub(crate) fn write_both(folder: &TempDir, input: &Input) {
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

/// Bands are triangulated on all cores, and written in one order.
#[test]
fn the_number_of_threads_changes_no_byte() {
    let folder = folder(&[]);
    let mut input = Input::generated("parcels", 100_000, 7);
    input.points.extend_from_within(..1000);
    write_raw(&folder, &input);
    let made = ["1", "2", "5"].map(|threads| {
        let arguments = "stream p.f64 --edges e.u64 --memory 1M --stats -o t.u32";
        let mut command = sweep_cdt(&folder, arguments);
        let output = command.env("RAYON_NUM_THREADS", threads).output();
        let output = output.expect("the command starts");
        let table = printed(&output);
        let row = |name: &str| {
            let row = table.lines().find_map(|line| line.strip_prefix(name));
            row.and_then(|row| row.trim().parse::<u64>().ok())
        };
        assert_eq!(row("equal points"), Some(1000), "{table}");
        assert!(row("windows") > Some(8), "{table}");
        fs::read(folder.path().join("t.u32")).expect("a file")
    });
    assert!(made[0] == made[1] && made[1] == made[2]);
    let whole = triangulate(&input.points, &input.edges).expect("parcels");
    let whole = whole.triangles().map(|corners| corners.map(|v| v as u64));
    assert!(set(triangles(&made[0], "u32")) == set(whole.collect()));
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
