//! What `sweep-cdt stream` refuses, how its messages say what to do, and what is left of a run that keeps too much alive.

use std::fs;
use std::process::Stdio;

use sweep_cdt_testing::Input;

use crate::outputs::assert_refused;
use crate::stream::{expected, ran, set, triangles, write_both, write_raw};
use crate::{FORMATS, assert_fails, folder, names, printed, run, sweep_cdt, text};

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
            "one.poly --window 1 --memory 2K",
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
    let settings = "--window 50 --memory 240K";
    let output = ran(&folder, &format!("stream p.f64 {settings} -o t.u64"));
    let error = text(&output.stderr);
    let ending =
        " (--memory 1MiB allows so many); what is final up to there is in t.u64.incomplete\n";
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
    assert!(text(&output.stderr).ends_with(" (--memory 1MiB allows so many)\n"));
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
    let output = stream(800 * 40_000);
    let error = text(&output.stderr);
    let words = " vertices are alive, more than the limit of 40000: ";
    let alive = error.strip_prefix("error: p.f64: ");
    let alive = alive.and_then(|rest| rest.split_once(words)?.0.parse().ok());
    let alive: u32 = alive.unwrap_or_else(|| panic!("{error}"));
    assert!((40_001..=80_000).contains(&alive), "{alive}");
    assert_eq!(printed(&stream(800 * 100_000)), "");
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
            "stream p.f64 -o t.obj",
            "t.obj is no name for triangles of a stream: let it end in .u32, .u64, .ele, .ply or .cert",
        ),
        (
            "stream p.f64 -o t.ply --vertices v.f64",
            "a .ply has its vertices itself, as the input numbers them: let OUTPUT beside --vertices end in .u32, .u64 \
             or .ele",
        ),
        (
            "stream p.f64 -o t.u32 --vertices v.node",
            "v.node is no name for vertices of a stream: let it end in .f64",
        ),
        (
            "stream p.f64 -o t.u32 --vertices p.f64",
            "p.f64 is an input and would be overwritten",
        ),
        (
            "stream a.json -o t.u32",
            if cfg!(feature = "las") {
                "a.json: a stream reads no .json, but f64, ply, node, poly, csv, xyz, txt, las, laz. In memory \
                 `sweep-cdt contours` and `heights` read it"
            } else {
                "a.json: a stream reads no .json, but f64, ply, node, poly, csv, xyz, txt. In memory `sweep-cdt contours` \
                 and `heights` read it"
            },
        ),
        (
            "stream - -o t.u32",
            if cfg!(feature = "las") {
                "the format of standard input is not known: add --stream-format with one of f64, ply, node, \
                 poly, csv, xyz, txt, las, laz"
            } else {
                "the format of standard input is not known: add --stream-format with one of f64, ply, node, \
                 poly, csv, xyz, txt"
            },
        ),
        (
            "stream p.f64 -o - --stats",
            "--stats and `-o -` would both write to standard output",
        ),
        (
            "stream p.f64 --vertices v.f64",
            "the following required arguments were not provided:",
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
