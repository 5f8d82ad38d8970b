//! Every file that the page saves has the bytes that the command writes. The program runs in node, with the page's own
//! `wasi.js`.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::{Value, json};
use sweep_cdt_formats::Format;
use sweep_cdt_generate::KINDS;
use tempfile::TempDir;

use super::{command, program, skipped};

const WASI: &str = include_str!("../../src/page/wasi.js");

/// Runs the program with each request of a folder: `N.request`, whose files are `N.files`, becomes `N.answer`, and
/// `N.failure` where it fails.
const RUN: &str = r#"
const [fs, folder] = [require("node:fs"), process.argv[2]];
const module = new WebAssembly.Module(fs.readFileSync(process.argv[1]));
for (let number = 0; fs.existsSync(`${folder}/${number}.request`); number++) {
  const file = (kind) => `${folder}/${number}.${kind}`;
  const request = fs.readFileSync(file("request"), "utf8");
  const end = runProgram(module, ["sweep-cdt-compute", request], fs.readFileSync(file("files")));
  fs.writeFileSync(file("answer"), end.output);
  if (end.status !== 0) {
    fs.writeFileSync(file("failure"), `${end.trap ?? ""}${end.errors}`);
  }
}
"#;

/// The answer of a process of the program, or its last words as it fails.
type Answer = Result<Vec<u8>, String>;

/// The answers to requests, each with the bytes of its files; nothing where they cannot be had here.
fn answers(requests: &[(Value, Vec<u8>)]) -> Option<Vec<Answer>> {
    let program = program()?;
    let folder = TempDir::new().expect("a temporary folder");
    let file = |number: usize, kind: &str| folder.path().join(format!("{number}.{kind}"));
    for (number, (request, files)) in requests.iter().enumerate() {
        fs::write(file(number, "request"), request.to_string()).expect("a file");
        fs::write(file(number, "files"), files).expect("a file");
    }
    let mut node = Command::new("node");
    node.args(["--eval", &format!("{WASI}{RUN}")]);
    let Ok(output) = node.arg(program).arg(folder.path()).output() else {
        return skipped("node is not installed");
    };
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    let answer = |number| match fs::read_to_string(file(number, "failure")) {
        Ok(failure) => Err(failure),
        Err(_) => Ok(fs::read(file(number, "answer")).expect("an answer")),
    };
    Some((0..requests.len()).map(answer).collect())
}

/// The settings that the page begins with.
fn settings() -> Value {
    json!({"method": "auto", "front": "hash", "heuristics": "fast", "inside": "default", "split": true})
}

fn request(input: &Value, settings: &Value, wanted: &Value) -> Value {
    json!({"input": input, "settings": settings, "wanted": wanted})
}

/// A file, and the `.node` beside it, as the page names them.
fn given(path: &Path) -> (Value, Vec<u8>) {
    let read = |path: &Path| fs::read(path).expect("a file");
    let name = |path: &Path| {
        path.file_name()
            .and_then(|name| name.to_str())
            .map(str::to_owned)
    };
    let mut bytes = read(path);
    let length = bytes.len();
    let node = path.with_extension("node");
    let node = (node != path && node.exists()).then(|| {
        let beside = read(&node);
        bytes.extend(&beside);
        json!([name(&node), beside.len()])
    });
    let format = path.extension().and_then(|extension| extension.to_str());
    let file = json!({"name": name(path), "format": format, "bytes": length, "node": node});
    (json!({ "file": file }), bytes)
}

/// The counterpart of a result of the page: the arguments of a command that prints it.
struct Case {
    request: Value,
    files: Vec<u8>,
    folder: PathBuf,
    arguments: String,
}

/// The result in all formats, and the steps in all formats, of the file called `name`.
fn cases_of_file(folder: &Path, name: &str, settings: &Value, flags: &str) -> Vec<Case> {
    let (input, files) = given(&folder.join(name));
    let case = |wanted: Value, arguments: String| Case {
        request: request(&input, settings, &wanted),
        files: files.clone(),
        folder: folder.to_owned(),
        arguments,
    };
    let formats = Format::OUTPUTS.iter().map(|output| output.name());
    let results = formats.map(|format| {
        let arguments = format!("triangulate {name} {flags} -o - --output-format {format}");
        case(json!({ "result": format }), arguments)
    });
    let traces = ["txt", "jsonl", "html"].map(|format| {
        let arguments = format!("trace {name} -o - --output-format {format}");
        case(json!({ "trace": format }), arguments)
    });
    let has_steps = !flags.contains("--split") && !flags.contains("--inside");
    results
        .chain(traces.into_iter().filter(|_| has_steps))
        .collect()
}

#[track_caller]
fn assert_same(cases: &[Case]) {
    let requests = cases
        .iter()
        .map(|case| (case.request.clone(), case.files.clone()));
    let Some(answers) = answers(&requests.collect::<Vec<_>>()) else {
        return;
    };
    for (case, answer) in cases.iter().zip(answers) {
        let expected = command(&case.folder, &case.arguments);
        let answer = answer.unwrap_or_else(|failure| panic!("{}: {failure}", case.arguments));
        assert!(!expected.is_empty(), "{}", case.arguments);
        assert!(
            answer == expected,
            "not as `sweep-cdt {}` has it",
            case.arguments
        );
    }
}

#[test]
fn results_and_steps_of_files() {
    let formats = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/data/formats");
    let mut cases = Vec::new();
    // Doubles, fractions, and a `.poly` whose vertices are in the `.node` beside it.
    for name in ["ten.poly", "ten.json", "thirds.poly", "split.poly"] {
        cases.extend(cases_of_file(&formats, name, &settings(), ""));
    }
    // A third is no integer times a power of two, so there is no certificate of it.
    let of_thirds = |case: &Case| case.arguments.starts_with("triangulate thirds");
    cases.retain(|case| !(of_thirds(case) && case.arguments.ends_with("cert")));
    assert_same(&cases);
}

/// A square with a cross in it, and heights.
const CROSS: &str = "4 2 1 0\n1 0 0 8\n2 3 1 9\n3 0 1 7\n4 3 0 8\n3 0\n1 1 2\n2 3 4\n3 1 3\n0\n";
/// A square in a square; the inner one is a hole.
const HOLE: &str = "8 2 0 0\n0 0 0\n1 9 0\n2 9 9\n3 0 9\n4 3 3\n5 6 3\n6 6 6\n7 3 6\n8 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n\
    4 4 5\n5 5 6\n6 6 7\n7 7 4\n1\n0 4 4\n1\n0 1 1 7\n";

#[test]
fn crossings_holes_and_rules() {
    let folder = TempDir::new().expect("a temporary folder");
    for (name, text) in [("cross.poly", CROSS), ("hole.poly", HOLE)] {
        fs::write(folder.path().join(name), text).expect("a file");
    }
    let mut cases = cases_of_file(
        folder.path(),
        "cross.poly",
        &settings(),
        "--split-crossings",
    );
    cases.extend(cases_of_file(folder.path(), "hole.poly", &settings(), ""));
    let certified = ["hull", "even-odd", "nonzero", "holes"];
    for rule in certified
        .iter()
        .chain(&["negative", "at-least-2", "hull-without-holes"])
    {
        let mut settings = settings();
        settings["inside"] = json!(rule);
        let flags = format!("--inside {rule}");
        let mut more = cases_of_file(folder.path(), "hole.poly", &settings, &flags);
        // There are no certificates by the other rules.
        more.retain(|case| certified.contains(rule) || !case.arguments.ends_with("cert"));
        cases.extend(more);
    }
    assert_same(&cases);
}

/// The steps up to the crossing, after which the command ends with an error.
#[test]
fn steps_of_edges_that_cross() {
    let folder = TempDir::new().expect("a temporary folder");
    fs::write(folder.path().join("cross.poly"), CROSS).expect("a file");
    let mut settings = settings();
    settings["split"] = json!(false);
    let mut cases = cases_of_file(folder.path(), "cross.poly", &settings, "");
    cases.retain(|case| case.arguments.starts_with("trace"));
    assert_eq!(cases.len(), 3);
    assert_same(&cases);
}

#[test]
fn settings_change_the_steps_as_those_of_the_command() {
    let formats = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/data/formats");
    let (input, files) = given(&formats.join("ten.poly"));
    let case = |front: &str, heuristics: &str, flags: &str| {
        let mut settings = settings();
        [settings["front"], settings["heuristics"]] = [json!(front), json!(heuristics)];
        Case {
            request: request(&input, &settings, &json!({"trace": "txt"})),
            files: files.clone(),
            folder: formats.clone(),
            arguments: format!("trace ten.poly --front {front} {flags}"),
        }
    };
    assert_same(&[
        case("skip-list", "paper", "--heuristics paper"),
        case("linear", "off", "--no-narrow-corners --no-basins"),
    ]);
}

#[test]
fn generated_data() {
    let inputs = Format::INPUTS.iter().map(|input| input.name());
    let kinds = KINDS.iter().map(|kind| (kind.name, "poly"));
    let formats = inputs.map(|format| ("segments", format));
    let case = |(kind, format): (&str, &str)| {
        let input = json!({"generated": {"kind": kind, "points": 60, "seed": 7}});
        Case {
            request: request(&input, &settings(), &json!({ "graph": format })),
            files: Vec::new(),
            folder: env!("CARGO_MANIFEST_DIR").into(),
            arguments: format!("generate {kind} 60 --seed 7 --output-format {format}"),
        }
    };
    assert_same(&kinds.chain(formats).map(case).collect::<Vec<_>>());
}

/// A wrong file is one line, the command's without its `error:`; and never a trap.
#[test]
fn what_is_wrong_is_said_as_the_command_says_it() {
    let cases = [
        (
            "a.node",
            "2 2 0 0\n0 0 0\n1 nan 1\n",
            "a.node: vertex 1 has a coordinate that is not finite\n",
        ),
        (
            "a.node",
            "2 2 0 0\n0 0 0\n1 one 1\n",
            "a.node:3: `one` is not a coordinate\n",
        ),
        ("a.foo", "", "there is no format `foo`\n"),
    ];
    let request = |(name, text, _): (&str, &str, &str)| {
        let format = name.rsplit_once('.').expect("an extension").1;
        let file = json!({"name": name, "format": format, "bytes": text.len(), "node": null});
        let request = request(&json!({ "file": file }), &settings(), &json!("picture"));
        (request, text.as_bytes().to_vec())
    };
    let Some(answers) = answers(&cases.map(request)) else {
        return;
    };
    for ((.., expected), answer) in cases.into_iter().zip(answers) {
        assert_eq!(answer, Err(expected.to_owned()));
    }
}
