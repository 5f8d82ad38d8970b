//! The suite of conformance in the repository: its sum, its schema, and how it is made.

use std::fs;

use serde_json::Value;

use crate::schema::conforms;
use crate::{judge, path, text};

fn cases() -> String {
    fs::read_to_string(path("tests/conformance/cases.jsonl")).expect("a readable file")
}

#[test]
fn it_is_made_as_it_stands() {
    let folder = tempfile::tempdir().expect("a folder");
    let output = judge(folder.path(), &["cases"]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let (made, found) = (text(&output.stdout), cases());
    for (number, (made, found)) in (1..).zip(made.lines().zip(found.lines())) {
        assert_eq!(made, found, "line {number}");
    }
    assert_eq!(made.len(), found.len());
}

#[test]
fn its_sum_is_that_of_the_list() {
    let sums = fs::read_to_string(path("tests/conformance/SHA256SUMS")).expect("a readable file");
    for line in sums.lines() {
        let (sum, name) = line.split_once("  ").expect("a sum and a name");
        let bytes = fs::read(path("tests/conformance").join(name)).expect("a readable file");
        let digest = hmac_sha256::Hash::hash(&bytes);
        let digest: String = digest.iter().map(|byte| format!("{byte:02x}")).collect();
        assert_eq!(digest, sum, "{name}");
    }
    assert_eq!(sums.lines().count(), 2);
}

#[test]
fn its_lines_are_as_the_schema_says() {
    let text = fs::read_to_string(path("tests/conformance/schema.json")).expect("a readable file");
    let schema: Value = serde_json::from_str(&text).expect("JSON");
    let mut names = std::collections::BTreeSet::new();
    for line in cases().lines().skip(1) {
        let case: Value = serde_json::from_str(line).expect("JSON");
        assert_eq!(conforms(&case, &schema, &schema), Ok(()), "{line}");
        assert!(
            names.insert(case["name"].to_string()),
            "{} twice",
            case["name"]
        );
    }
    // The schema refuses what is not so.
    let line = cases().lines().nth(1).expect("a case").to_owned();
    for (from, to) in [
        ("\"points\"", "\"pionts\""),
        ("[[", "[[null,"),
        ("\"hull\":[]", "\"hull\":[-1]"),
        ("\"name\":\"few-points/0\"", "\"name\":3"),
    ] {
        let case: Value = serde_json::from_str(&line.replace(from, to)).expect("JSON");
        assert!(conforms(&case, &schema, &schema).is_err(), "{from}");
    }
}
