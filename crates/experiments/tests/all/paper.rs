//! The paper in `docs/fronts`: no number of its own, and figures and summaries that its data gives.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/fronts")
}

/// The text without code, cross-references, formulas and comments: what is left is prose. Content in code is prose, too.
fn prose(text: &str) -> String {
    let mut prose = String::new();
    let mut rest = text;
    while let Some(at) = rest.find(['#', '@', '$', '`', '<', '/']) {
        let (before, after) = rest.split_at(at);
        prose.push_str(before);
        let word = after[1..].find(|c: char| !(c.is_alphanumeric() || "-_.".contains(c)));
        let word = &after[1..word.map_or(after.len(), |end| end + 1)];
        let closing = |end: &str| {
            after[1..]
                .find(end)
                .map_or(after.len(), |at| at + 1 + end.len())
        };
        let skip = match after.as_bytes()[0] {
            b'#' => {
                let is_declared = ["let", "set", "show", "include", "import"].contains(&word);
                assert!(
                    !["if", "for", "while"].contains(&word),
                    "write a function: #{word}"
                );
                let end = code(&after[1..], is_declared) + 1;
                for content in contents(&after[1..end]) {
                    prose += &self::prose(content);
                }
                end
            }
            b'@' => 1 + word.len(),
            b'$' => closing("$"),
            b'`' => closing("`"),
            b'<' if word.starts_with(|c: char| c.is_alphabetic()) => closing(">"),
            b'/' if after.starts_with("//") => closing("\n"),
            _ => 1,
        };
        rest = &after[skip..];
    }
    prose + rest
}

/// The length of code: a name with the groups in brackets after it, or a declaration, to the end of a line at which all
/// brackets are closed.
fn code(text: &str, is_declared: bool) -> usize {
    let (mut depth, mut quoted) = (0, false);
    for (at, c) in text.char_indices() {
        match c {
            '"' => quoted = !quoted,
            _ if quoted => {}
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' if depth > 0 => depth -= 1,
            '\n' if is_declared && depth == 0 => return at,
            _ if depth > 0 || is_declared || c.is_alphanumeric() || "-_".contains(c) => {}
            '.' if text[at + 1..].starts_with(|c: char| c.is_alphabetic()) => {}
            _ => return at,
        }
    }
    text.len()
}

/// The content blocks of code.
fn contents(code: &str) -> Vec<&str> {
    let (mut depth, mut quoted, mut start) = (0, false, 0);
    let mut found = Vec::new();
    for (at, c) in code.char_indices() {
        match c {
            '"' if depth == 0 => quoted = !quoted,
            _ if quoted => {}
            '[' => {
                if depth == 0 {
                    start = at + 1;
                }
                depth += 1;
            }
            ']' => {
                depth -= 1;
                if depth == 0 {
                    found.push(&code[start..at]);
                }
            }
            _ => {}
        }
    }
    found
}

/// The digits in the prose of a text, each with what is around it.
fn digits(text: &str) -> Vec<String> {
    let prose = prose(text);
    let at = prose.match_indices(|c: char| c.is_ascii_digit());
    at.map(|(at, _)| {
        prose[..at]
            .chars()
            .rev()
            .take(30)
            .collect::<Vec<_>>()
            .into_iter()
            .rev()
            .collect::<String>()
            + &prose[at..=at]
    })
    .collect()
}

#[test]
fn every_number_comes_from_the_data() {
    for name in ["paper.typ", "structures.typ"] {
        let text = fs::read_to_string(folder().join(name)).expect("a file");
        assert_eq!(digits(&text), [""; 0], "{name}");
    }
    // The check can fail, and lets pass what is generated.
    let text = "#let x = (\n  3,\n)\nIt wins #x.at(0) of 18 @a2020, $O(n^2)$, `f64`. #figure(f(7), caption: [In 9 of #x.])";
    let found = digits(text);
    let ends: Vec<&str> = found
        .iter()
        .map(|found| &found[found.len() - 5..])
        .collect();
    assert_eq!(ends, [" of 1", "of 18", " In 9"].map(|end| &end[..5]));
}

#[test]
fn summary_and_figures_are_what_the_data_gives() {
    let scratch = tempfile::tempdir().expect("a folder");
    let mut derived = 0;
    for entry in fs::read_dir(folder()).expect("the folder of the paper") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().expect("a name");
        if path.extension().is_some_and(|extension| extension == "csv") {
            fs::copy(&path, scratch.path().join(name)).expect("a copy");
        }
    }
    for name in ["summary.csv", "growth.csv"] {
        fs::remove_file(scratch.path().join(name)).expect("a copy");
    }
    let output = Command::new(env!("CARGO_BIN_EXE_sweep-cdt-experiments"))
        .args(["paper", "--out"])
        .arg(scratch.path())
        .output()
        .expect("the program runs");
    assert!(output.status.success(), "{output:?}");
    for entry in fs::read_dir(scratch.path()).expect("the scratch folder") {
        let path = entry.expect("an entry").path();
        let kept = fs::read(folder().join(path.file_name().expect("a name")));
        let is_same = kept.is_ok_and(|kept| kept == fs::read(&path).expect("a file"));
        assert!(
            is_same,
            "{} is not what the data gives: crates/experiments/reproduce",
            path.display()
        );
        derived += 1;
    }
    assert!(derived > 20, "{derived} files");
}
