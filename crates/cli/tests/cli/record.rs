//! Files that a verification leaves behind: records, certificates and pictures.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use tempfile::TempDir;

use crate::refuted::WRONG;
use crate::verify::{RIGHT, refuted, verify, with_square};
use crate::{FORMATS, folder, names, printed, run};

const RECORD: &str = r#"{
  "program": "sweep-cdt",
  "version": "VERSION",
  "verdict": "wrong",
  "canonical": null,
  "input": [
    {
      "file": "a.poly",
      "sha256": "INPUT"
    }
  ],
  "result": [
    {
      "file": "b.json",
      "sha256": "RESULT"
    }
  ],
  "scalar": "f64",
  "domain": "hull",
  "level": "delaunay",
  "highest_level": "constrained",
  "vertices_matched": {
    "by": "number",
    "because": "unplaced",
    "greatest_difference": null
  },
  "clockwise": false,
  "steiner": false,
  "max_depth": null,
  "counts": {
    "points": 5,
    "distinct_points": 5,
    "edges": 1,
    "triangles": 4,
    "boundary_sides": 4,
    "constrained_sides": 1,
    "free_sides": 4,
    "cocircular_sides": 0,
    "uncanonical_sides": 0,
    "added_points": 0,
    "split_edges": 0
  },
  "signs": {
    "by_filter": 12,
    "exact": 0
  },
  "violations_found": 1,
  "depths": {
    "measured": 1,
    "greatest": 0.875,
    "decades": [
      {
        "exponent": -1,
        "violations": 1
      }
    ]
  },
  "violations": [
    {
      "class": "not-delaunay",
      "message": "side 4-2 of triangles 2 and 1 is not Delaunay: the circle of one holds vertex 3 or 5 of the other",
      "depth": 0.875,
      "vertices": [
        {
          "vertex": 4,
          "at": [
            0,
            4
          ]
        },
        {
          "vertex": 2,
          "at": [
            4,
            0
          ]
        },
        {
          "vertex": 3,
          "at": [
            4,
            4
          ]
        },
        {
          "vertex": 5,
          "at": [
            2,
            1
          ]
        }
      ],
      "edges": [],
      "triangles": [
        2,
        1
      ]
    }
  ]
}
"#;

#[test]
fn records_are_exact_and_always_the_same() {
    let folder = with_square(&[("b.json", WRONG[0].1), ("a.ele", RIGHT)]);
    let arguments = "./a.poly ./b.json --record c.json --json";
    let output = verify(&folder, arguments);
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).expect("a file");
    let expected = RECORD
        .replace("VERSION", env!("CARGO_PKG_VERSION"))
        .replace(
            "INPUT",
            "4457027089fd9ee642729f36e5a813ef7dd8167426aef60640122d2ac3f39f90",
        )
        .replace(
            "RESULT",
            "c972808f2343f1dd782df4c450f50a869f671dd9bb9d896ef95357744be1aaa2",
        );
    assert_eq!(refuted(&output), expected);
    assert_eq!(read("c.json"), expected);
    assert_eq!(verify(&folder, arguments).stdout, output.stdout);

    printed(&verify(&folder, "a.poly a.ele --record c.json"));
    let record: serde_json::Value = serde_json::from_str(&read("c.json")).expect("a record");
    assert_eq!(record["verdict"], "correct");
    assert_eq!(record["canonical"], true);
}

#[test]
fn pictures_show_the_first_violations_from_near() {
    let folder = with_square(&[("b.json", r#"{"triangles": [[1,2,4]]}"#), ("a.ele", RIGHT)]);
    let picture = || fs::read_to_string(folder.path().join("a.svg")).expect("a picture");
    refuted(&verify(&folder, "a.poly b.json --svg a.svg"));
    let wrong = picture();
    for piece in [
        ">3 violations</text>",
        ">1: unused-point</text>",
        ">3: missing-edge</text>",
        ">vertex 4 is in no triangle</text>",
    ] {
        assert_eq!(wrong.matches(piece).count(), 1, "{piece}");
    }
    assert_eq!(wrong.matches("<svg").count(), 1 + 4);

    printed(&verify(&folder, "a.poly a.ele --svg a.svg"));
    assert!(picture().contains(">correct</text>"));
    assert_eq!(picture().matches("<svg").count(), 1 + 1);
    assert!(picture().ends_with("</svg>\n"));
    assert_eq!(names(folder.path()), ["a.ele", "a.poly", "a.svg", "b.json"]);
}

#[test]
fn records_name_every_file_and_setting() {
    let folder = folder(&[]);
    let input = format!("{FORMATS}/split.poly");
    printed(&run(&folder, &format!("{input} -o r.json")));
    let output = verify(&folder, &format!("{input} r.json --json"));
    let record: serde_json::Value = serde_json::from_str(printed(&output)).expect("JSON");
    let files = record["input"].as_array().expect("files");
    let files: Vec<_> = files.iter().map(|file| file["file"].as_str()).collect();
    assert_eq!(files, [Some("split.poly"), Some("split.node")]);
    assert_eq!(record["clockwise"], false);
}

#[test]
fn certificates_are_of_correct_results_alone() {
    let folder = with_square(&[("b.json", WRONG[0].1), ("a.ele", RIGHT)]);
    let at = |name: &str| folder.path().join(name);
    printed(&verify(&folder, "a.poly a.ele --write-certificate a.cert"));
    printed(&run(&folder, "a.poly -o b.cert"));
    let certificate = fs::read_to_string(at("a.cert")).expect("a certificate");
    assert_eq!(
        fs::read_to_string(at("b.cert")).expect("a certificate"),
        certificate
    );
    let expected = "sweep-cdt-certificate 3\nexponent 0\n";
    assert!(certificate.starts_with(expected), "{certificate}");

    refuted(&verify(&folder, "a.poly b.json --write-certificate c.cert"));
    assert!(!at("c.cert").exists());
    let output = verify(
        &folder,
        "a.poly a.ele --level tiling --write-certificate c.cert",
    );
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("--level"));
    // A third is no integer times a power of two.
    fs::write(at("t.json"), r#"{"points": [["1/3", 0], [1, 0], [0, 1]]}"#).expect("a file");
    let output = run(&folder, "t.json -o t.cert");
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&output.stderr).contains("power of two"));
    assert!(!at("t.cert").exists());
}

#[test]
fn a_certificate_of_an_earlier_run_is_told_from_one_of_this() {
    let folder = with_square(&[("b.json", WRONG[0].1), ("a.ele", RIGHT)]);
    let third = r#"{"points": [["1/3", 0], [1, 0], [0, 1]]}"#;
    fs::write(folder.path().join("t.json"), third).expect("a file");
    let noted =
        |output: &Output| String::from_utf8_lossy(&output.stderr).contains("of an earlier run");
    let to_c = "--write-certificate c.cert";
    assert!(!noted(&verify(&folder, &format!("a.poly b.json {to_c}"))));
    assert!(!noted(&verify(&folder, &format!("a.poly a.ele {to_c}"))));
    assert!(!noted(&verify(&folder, &format!("a.poly a.ele {to_c}"))));
    let earlier = fs::read(folder.path().join("c.cert")).expect("a certificate");
    for refusal in [
        verify(&folder, &format!("a.poly b.json {to_c}")),
        verify(&folder, &format!("a.poly none.ele {to_c}")),
        verify(&folder, &format!("a.poly a.ele --level tiling {to_c}")),
        run(&folder, "t.json -o c.cert"),
        run(&folder, "none.json -o c.cert"),
    ] {
        assert!(!refusal.status.success() && noted(&refusal), "{refusal:?}");
        let file = fs::read(folder.path().join("c.cert")).expect("a certificate");
        assert!(file == earlier);
    }
}

/// What a judge that shares no code with this crate says of a certificate: `proof/check.py`. `None` without Python.
fn second_judge(folder: &TempDir, certificate: &str) -> Option<Output> {
    let judge = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../proof/check.py");
    let mut python = Command::new("python3");
    let verdict = python
        .arg(judge)
        .arg(certificate)
        .current_dir(folder)
        .output();
    if verdict.is_err() {
        assert!(std::env::var_os("CI").is_none(), "python3 is missing");
        println!("left out: there is no python3");
    }
    verdict.ok()
}

#[test]
#[ignore = "15 seconds: `.ci/nightly` runs it"]
fn certificates_of_hard_inputs_pass_the_second_judge() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let folder = folder(&[]);
    let hard = fs::read_to_string(root.join("tests/data/hard.jsonl")).expect("a file");
    let mut judged = 0;
    for line in hard.lines() {
        let case: serde_json::Value = serde_json::from_str(line).expect("JSON");
        let graph = serde_json::json!({ "points": case["points"], "edges": case["edges"] });
        fs::write(folder.path().join("h.json"), graph.to_string()).expect("a file");
        // Edges of some cross, or name vertices that are not there.
        if !run(&folder, "h.json -o h.cert").status.success() {
            continue;
        }
        let Some(verdict) = second_judge(&folder, "h.cert") else {
            return;
        };
        assert!(verdict.status.success(), "{}: {verdict:?}", case["name"]);
        judged += 1;
    }
    assert!(judged > 100, "{judged}");
}

#[test]
fn certificates_of_polygons_pass_the_second_judge() {
    // A hole that sticks out, a polygon over both, and a line.
    let shapes = "MULTIPOLYGON (((0 0, 4 0, 4 1, 4 2, 4 4, 0 4, 0 0), (1 1, 1 2, 4 2, 5 2, 5 1, 4 1, 1 1)), \
                  ((4 0, 4 1, 4 2, 6 2, 6 0, 4 0))) LINESTRING (0 0, 1 1)";
    let folder = folder(&[("a.wkt", shapes)]);
    assert!(run(&folder, "a.wkt -o a.cert").status.success());
    let text = fs::read_to_string(folder.path().join("a.cert")).expect("a certificate");
    let declared = "\ndomain polygons\npolygons 2\noutlines 0 holes 1\noutlines 2 holes\n";
    assert!(text.contains(declared), "{text}");
    assert!(text.contains("\ne - 0 6\n"), "{text}");
    let mut lines = text.lines();
    let triangle = lines
        .find(|line| line.starts_with("t "))
        .expect("a triangle");
    let mut words: Vec<&str> = triangle.split(' ').collect();
    words[5] = if words[5] == "1" { "0" } else { "1" };
    let altered = text.replace(triangle, &words.join(" "));
    fs::write(folder.path().join("b.cert"), altered).expect("a file");
    for (certificate, is_right) in [("a.cert", true), ("b.cert", false)] {
        if let Some(verdict) = second_judge(&folder, certificate) {
            assert_eq!(verdict.status.success(), is_right, "{verdict:?}");
        }
    }
}

/// The certificate of a result that fills a domain, which the second judge accepts; how many of its triangles are inside.
fn certified_inside(folder: &TempDir, arguments: &str) -> (String, usize) {
    printed(&verify(
        folder,
        &format!("{arguments} --write-certificate r.cert"),
    ));
    let text = fs::read_to_string(folder.path().join("r.cert")).expect("a certificate");
    if let Some(verdict) = second_judge(folder, "r.cert") {
        assert!(verdict.status.success(), "{verdict:?}");
    }
    let triangles = text.lines().filter(|line| line.starts_with("t "));
    let inside = triangles.filter(|line| line.split(' ').nth(5) == Some("1"));
    let inside = inside.count();
    (text, inside)
}

#[test]
fn certificates_of_results_that_fill_a_domain_are_of_the_hull() {
    let shapes =
        "MULTIPOLYGON (((0 0, 9 0, 9 9, 5 9, 5 5, 4 5, 4 9, 0 9, 0 0), (1 1, 1 3, 3 3, 3 1, 1 1)))";
    let folder = folder(&[("a.wkt", shapes)]);
    for rule in ["polygons", "even-odd"] {
        printed(&run(&folder, &format!("a.wkt --inside {rule} -o a.json")));
        // Another program's order and corners.
        let result = fs::read_to_string(folder.path().join("a.json")).expect("a result");
        let result: serde_json::Value = serde_json::from_str(&result).expect("JSON");
        let mut triangles: Vec<[usize; 3]> =
            serde_json::from_value(result["triangles"].clone()).expect("triangles");
        triangles.reverse();
        triangles
            .iter_mut()
            .for_each(|corners| corners.rotate_left(1));
        let other = serde_json::json!({ "triangles": triangles }).to_string();
        fs::write(folder.path().join("b.json"), other).expect("a file");
        let arguments = format!("a.wkt b.json --domain {rule}");
        let (text, inside) = certified_inside(&folder, &arguments);
        assert!(text.contains(&format!("\ndomain {rule}\n")), "{text}");
        assert_eq!(inside, triangles.len());
    }
}

#[test]
fn certificates_hold_vertices_that_a_result_added() {
    let square =
        r#"{"points": [[0, 0], [4, 0], [4, 4], [0, 4]], "edges": [[0, 1], [1, 2], [2, 0]]}"#;
    // A vertex in the middle of the edge from 2 to 0, and one inside.
    let result = r#"{"points": [[0, 0], [4, 0], [4, 4], [0, 4], [2, 2], [3, 1]],
                     "triangles": [[0, 1, 5], [1, 2, 5], [2, 4, 5], [4, 0, 5]]}"#;
    let folder = folder(&[("a.json", square), ("r.json", result)]);
    let (text, inside) = certified_inside(&folder, "a.json r.json --steiner --domain even-odd");
    assert!(
        text.matches("\np ").count() == 6 && text.contains("\ne 2 4 0\n"),
        "{text}"
    );
    assert_eq!(inside, 4);
    let all = result.replace("[4, 0, 5]]", "[4, 0, 5], [2, 3, 4], [3, 0, 4]]");
    fs::write(folder.path().join("all.json"), all).expect("a file");
    let (text, _) = certified_inside(&folder, "a.json all.json --steiner");
    assert!(text.contains("\ndomain hull\n"), "{text}");
}
