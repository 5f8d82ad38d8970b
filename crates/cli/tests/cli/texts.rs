//! Texts as editors and systems leave them: byte order marks, line ends, UTF-16, names with control
//! characters. And garbage: no bytes make the readers or the verifier panic.

use std::fs;
use std::path::Path;
use std::process::Output;

use sweep_cdt::verify::Verifier;
use sweep_cdt_draw::ViolationsPicture;
use sweep_cdt_formats::{Format, GraphFile, Input, Source, read, read_result};
use sweep_cdt_testing::Random;

use crate::{FORMATS, assert_fails, folder, printed, printed_despite_losses, run, sweep_cdt};

/// Every format that is read, and the command that reads it.
const FILES: &[(&str, &str)] = &[
    ("ten.poly", "triangulate ten.poly -o - --output-format json"),
    ("ten.json", "triangulate ten.json -o - --output-format json"),
    (
        "split.node",
        "triangulate split.node -o - --output-format obj",
    ),
    ("ten.ele", "verify ten.poly ten.ele"),
    ("ten.obj", "verify ten.poly ten.obj"),
    ("result.json", "verify ten.poly result.json"),
    ("ten.txt", "replay ten.txt"),
    ("ten.jsonl", "replay ten.jsonl"),
];

/// A folder with all of these.
fn samples() -> tempfile::TempDir {
    let folder = folder(&[]);
    for name in ["ten.poly", "ten.json", "split.node"] {
        fs::copy(format!("{FORMATS}/{name}"), folder.path().join(name)).expect("a copy");
    }
    printed_despite_losses(&run(
        &folder,
        "ten.poly -o ten.ele -o ten.obj -o result.json",
    ));
    for name in ["ten.txt", "ten.jsonl"] {
        printed(&ran(&folder, &format!("trace ten.poly -o {name}")));
    }
    folder
}

fn ran(folder: &tempfile::TempDir, arguments: &str) -> Output {
    let output = sweep_cdt(folder, arguments).output();
    output.expect("the command starts")
}

/// Rewrites each file and compares what is printed.
fn assert_no_difference(rewrite: impl Fn(&str) -> Vec<u8>) {
    let folder = samples();
    for (name, arguments) in FILES {
        let path = folder.path().join(name);
        let contents = fs::read_to_string(&path).expect("a text");
        let expected = ran(&folder, arguments);
        fs::write(&path, rewrite(&contents)).expect("a file");
        assert_eq!(
            printed_despite_losses(&ran(&folder, arguments)),
            printed_despite_losses(&expected),
            "{name}"
        );
        fs::write(&path, contents).expect("a file");
    }
}

#[test]
fn a_byte_order_mark_is_skipped() {
    assert_no_difference(|contents| format!("\u{feff}{contents}").into_bytes());
}

#[test]
fn lines_end_as_on_any_system() {
    assert_no_difference(|contents| contents.replace('\n', "\r\n").into_bytes());
    assert_no_difference(|contents| contents.replace('\n', "\r").into_bytes());
}

#[test]
fn errors_count_lines_as_editors_do() {
    let node = "2 2\n\n0 0 0\n# a comment\n1 0 x\n";
    let json = "{\"points\": [\n[0, 0],\n\n[0, {}]]}\n";
    let broken = "{\"points\": [\n[0, 0],\n\n[0, }]]}\n";
    for end in ["\n", "\r\n", "\r"] {
        for mark in ["", "\u{feff}"] {
            let written = |text: &str| format!("{mark}{}", text.replace('\n', end));
            let folder = folder(&[
                ("a.node", &written(node)),
                ("a.json", &written(json)),
                ("b.json", &written(broken)),
                ("c.json", &format!("{mark}{{\"points\": 7}}")),
            ]);
            for error in [
                "a.node:5: `x` is not a coordinate",
                "a.json:4:5: `{}` is not a coordinate",
                "b.json:4:5: `}` is no JSON here: expected value",
                "c.json:1:12: `points` should be a list",
            ] {
                let (name, _) = error.split_once(':').expect("a name");
                assert_fails(&run(&folder, name), error);
            }
        }
    }
}

#[test]
fn utf_16_is_named() {
    let folder = samples();
    for (name, arguments) in FILES {
        let path = folder.path().join(name);
        let contents = fs::read_to_string(&path).expect("a text");
        for (mark, is_little) in [(true, true), (true, false), (false, true), (false, false)] {
            let units = "\u{feff}".encode_utf16().filter(|_| mark);
            let units = units.chain(contents.encode_utf16());
            let bytes: Vec<u8> = units
                .flat_map(|unit| match is_little {
                    true => unit.to_le_bytes(),
                    false => unit.to_be_bytes(),
                })
                .collect();
            fs::write(&path, bytes).expect("a file");
            let error = format!("{name}: the text is UTF-16; save it as UTF-8");
            assert_fails(&ran(&folder, arguments), &error);
        }
        fs::write(&path, contents).expect("a file");
    }
}

#[test]
fn a_number_beyond_doubles_is_a_fraction_among_fractions() {
    let folder = folder(&[("a.node", "3\n1 1e400 0\n2 0 1/2\n3 0 0\n")]);
    let summary = "a.node: points 3, duplicates 0, edges 0, triangles 1, hull 3\n";
    assert_eq!(printed(&run(&folder, "a.node")), summary);
}

/// Names may hold what a terminal obeys.
#[cfg(unix)]
#[test]
fn control_characters_in_names_are_escaped() {
    let bell = "\u{1b}]0;\u{7}\n";
    let shown = "\\u{1b}]0;\\u{7}\\n";
    let triangle = r#"{"points": [[0, 0], [1, 0], [0, 1]]}"#;
    let right = r#"{"triangles": [[0, 1, 2]]}"#;
    let names = ["a.json", "b.json", "c.json"].map(|name| format!("{bell}{name}"));
    let [input, result, broken] = &names;
    let folder = folder(&[(input, triangle), (result, right), (broken, "{")]);
    let run = |arguments: &[&str]| {
        let mut command = sweep_cdt(&folder, "");
        command
            .args(arguments)
            .output()
            .expect("the command starts")
    };
    let summary = run(&["triangulate", input]);
    assert!(printed(&summary).starts_with(&format!("{shown}a.json: points 3")));
    let report = run(&["verify", input, result]);
    assert!(printed(&report).starts_with(&format!("correct: {shown}b.json is a ")));
    assert_fails(
        &run(&["triangulate", broken]),
        &format!("{shown}c.json:1: the file ends where the JSON should go on"),
    );
    assert_fails(
        &run(&["triangulate", &format!("{bell}x.json")]),
        &format!("{shown}x.json: no such file or directory"),
    );
    for wrong in [
        ["triangulate", input, "-o", input].as_slice(),
        &["triangulate", &format!("{bell}x.gif")],
        &["triangulate", input, "-o", &format!("{bell}x.gif")],
        &["triangulate", input, &format!("--{bell}")],
        &[bell],
    ] {
        let output = run(wrong);
        assert_eq!(output.status.code(), Some(2));
        let is_obeyed = |c: char| c.is_control() && c != '\n';
        let message = crate::text(&output.stderr);
        assert!(!message.contains(is_obeyed), "{message:?}");
        assert!(message.starts_with("error: "), "{message:?}");
    }
}

/// Results of `ten.poly`, to be damaged.
const SEEDS: [(Format, &str); 4] = [
    (Format::Ele, "3 3 0\n1 1 2 8\n2 2 3 8\n3 3 4 9\n"),
    (Format::Json, r#"{"triangles": [[0,1,7],[1,2,7],[2,3,8]]}"#),
    (Format::Json, r#"{"triangles": [0,1,7,1,2,7,2,3,8]}"#),
    (
        Format::Obj,
        "v 0 0 0\nv 6 0 0\nv 7.5 3.5 0\nf 1 2 3\nf 3/1 -1 2//4\n",
    ),
];

#[test]
fn damaged_results_are_errors_or_violations() {
    let Input::Doubles(file) = load("ten.poly") else {
        unreachable!("no fractions in it")
    };
    let mut random = Random::new(7);
    for _ in 0..5000 {
        for (format, seed) in SEEDS {
            let bytes = damaged(seed.as_bytes(), &mut random);
            let node = damaged(&bytes_of("split.node"), &mut random);
            let node = (random.below(3) == 0).then(|| source(node));
            try_all(format, &source(bytes), node.as_ref(), &file);
        }
    }
}

fn try_all(format: Format, source: &Source, node: Option<&Source>, file: &GraphFile<f64>) {
    let Ok(triangles) = read_result(format, source, node, file) else {
        return;
    };
    let graph = &file.graph;
    let verdict = Verifier::new().verify(&graph.points, &graph.edges, &triangles.list);
    let Err(violations) = verdict else { return };
    for &violation in &violations.list {
        triangles.as_numbered(file, violation).to_string();
        triangles.vertices_of(graph, violation);
    }
    let mut picture = Vec::new();
    ViolationsPicture::new(file, &triangles, &violations.list)
        .found(violations.found)
        .write(&mut picture)
        .expect("memory takes all that is written");
    assert!(!String::from_utf8(picture).expect("text").contains("NaN"));
}

fn bytes_of(name: &str) -> Vec<u8> {
    fs::read(Path::new(FORMATS).join(name)).expect("a file")
}

fn source(bytes: Vec<u8>) -> Source {
    Source::new("damaged", bytes)
}

fn load(name: &str) -> Input {
    read(Format::Poly, &source(bytes_of(name)), None).expect("a good file")
}

/// The bytes with a few replaced, removed, repeated or put in.
fn damaged(bytes: &[u8], random: &mut Random) -> Vec<u8> {
    const TOKENS: [&str; 12] = [
        "0",
        "-1",
        "99999999999999999999",
        "18446744073709551615",
        "1e999",
        "nan",
        " ",
        "\n",
        "[",
        "]",
        "\u{fffd}",
        "f 1 2 3\n",
    ];
    let mut bytes = bytes.to_vec();
    for _ in 0..=random.below(4) {
        let at = random.below(bytes.len() + 1);
        let end = (at + random.below(4)).min(bytes.len());
        let token = match random.below(4) {
            0 => String::new(),
            1 => char::from(u8::try_from(random.below(128)).expect("small")).to_string(),
            _ => TOKENS[random.below(TOKENS.len())].to_owned(),
        };
        bytes.splice(at..end, token.into_bytes());
    }
    bytes
}
