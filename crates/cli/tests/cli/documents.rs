//! Numbers in the help and in documents are those of the code.

use std::fs;

use sweep_cdt_formats::{MAX_DIGITS, MAX_EXPONENT};

use crate::{folder, printed, sweep_cdt};

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// A document on one line.
fn document(name: &str) -> String {
    let text = fs::read_to_string(format!("{ROOT}/{name}")).expect("a document");
    on_one_line(&text)
}

fn on_one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The help of a subcommand on one line.
fn help(subcommand: &str) -> String {
    let folder = folder(&[]);
    let command = sweep_cdt(&folder, &format!("{subcommand} --help")).output();
    on_one_line(printed(&command.expect("the command starts")))
}

/// A number with commas.
fn with_commas(number: usize) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (at, digit) in digits.chars().enumerate() {
        if at > 0 && (digits.len() - at).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

fn assert_says(text: &str, expected: &str, place: &str) {
    assert!(text.contains(expected), "{place} does not say: {expected}");
}

#[test]
fn limits_of_exact_numbers() {
    let digits = format!("at most {} digits", with_commas(MAX_DIGITS));
    let exponents = format!("from -{MAX_EXPONENT} to {MAX_EXPONENT}");
    for subcommand in ["triangulate", "verify"] {
        let help = help(subcommand);
        assert_says(&help, &digits, subcommand);
        assert_says(&help, &exponents, subcommand);
    }
    let formats = document("docs/formats.md");
    assert_says(&formats, &digits, "docs/formats.md");
    assert_says(&formats, &exponents, "docs/formats.md");
}

#[test]
fn counts_of_targets_and_cases() {
    const WORDS: [&str; 13] = [
        "zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten",
        "eleven", "twelve",
    ];
    let targets = fs::read_dir(format!("{ROOT}/fuzz/fuzz_targets")).expect("a folder");
    let targets = WORDS[targets.count()];
    for (name, expected) in [
        ("README.md", format!("{targets} fuzz targets")),
        ("fuzz/README.md", format!("{targets} targets for")),
    ] {
        assert_says(&document(name).to_lowercase(), &expected, name);
    }

    let suite = format!("{ROOT}/tests/conformance/cases.jsonl");
    let suite = fs::read_to_string(suite).expect("the suite");
    let cases = with_commas(
        suite
            .lines()
            .filter(|line| line.contains("\"name\""))
            .count(),
    );
    for (name, expected) in [
        (
            "tests/conformance/README.md",
            format!("{cases} small inputs"),
        ),
        ("CHANGELOG.md", format!("{cases} small inputs")),
        ("docs/testing.md", format!("{cases} cases")),
    ] {
        assert_says(&document(name), &expected, name);
    }
}
