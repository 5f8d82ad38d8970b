//! The proof of the floating-point filter, checked by Gappa.
//!
//! Gappa (Debian package `gappa`) bounds the rounding of floating-point expressions. Melquiond and Pion,
//! "Formally certified floating-point filters for homogeneous geometric predicates" (2007), checked
//! filters of this kind with it. Each script in `tests/proofs.gappa` proves one part of the reasoning in
//! `docs/proofs/filter.md`; what remains by hand is said there.
//!
//! Proof and code cannot drift apart: the constants in the scripts are those of the source text, and
//! each line of a script that starts with `# code:` must stand in the source. Each constant made half as
//! large must fail.
//!
//! Where Gappa is not installed the tests print so and pass; in continuous integration, where `CI` is `true`,
//! they fail.

use std::io::Write;
use std::process::{Command, Stdio};

const FILTER: &str = include_str!("../src/scalar/filter.rs");
const SCALE: &str = include_str!("../src/scalar/scale.rs");
const DOUBLES: &str = include_str!("../src/scalar/doubles.rs");

/// The scripts, each under a line with `###` and its name.
const SCRIPTS: &str = include_str!("proofs.gappa");

/// The names of the scripts, and the constants that each is about.
const CONSTANTS: [(&str, &[&str]); 6] = [
    ("orient2d_exact", &["ORIENT2D"]),
    ("in_circle_exact", &["IN_CIRCLE"]),
    ("orient2d_approx", &["ORIENT2D_APPROX"]),
    ("in_circle_approx", &["IN_CIRCLE_APPROX"]),
    ("underflow", &["UNDERFLOW"]),
    ("scale", &["RELATIVE_ERROR"]),
];

/// The name of each script, the script, and the constants that it is about.
fn scripts() -> Vec<(&'static str, &'static str, &'static [&'static str])> {
    let parts: Vec<&str> = SCRIPTS.split("\n### ").skip(1).collect();
    assert_eq!(parts.len(), CONSTANTS.len(), "the number of scripts");
    let script = |(part, (name, constants)): (&'static str, (&'static str, _))| {
        let (title, script) = part.split_once('\n').expect("a script under its name");
        assert_eq!(title, name, "the order of the scripts");
        (name, script, constants)
    };
    parts.into_iter().zip(CONSTANTS).map(script).collect()
}

/// The value of a constant as the source has it, in Gappa's words, which differ for powers of two only.
fn value(name: &str) -> String {
    let start = format!("const {name}: f64 = ");
    let line = [FILTER, SCALE, DOUBLES]
        .iter()
        .flat_map(|source| source.lines())
        .map(|line| line.trim_start_matches("pub(crate) "))
        .find_map(|line| line.trim_start_matches("pub(super) ").strip_prefix(&start))
        .unwrap_or_else(|| panic!("no source has the constant {name}"));
    let value = line.strip_suffix(';').expect("a constant of one line");
    match value
        .strip_prefix("power(")
        .and_then(|x| x.strip_suffix(')'))
    {
        Some(exponent) => format!("1b{exponent}"),
        None => value.to_owned(),
    }
}

/// Whether Gappa proves the script with these constants; what it says if not.
fn prove(script: &str, constants: &[(&str, String)]) -> Result<(), String> {
    let mut text = format!("U = {};\n", value("U"));
    for (name, value) in constants {
        text += &format!("{name} = {value};\n");
    }
    text += script;
    // The constants hold with a margin of some u^2, far below Gappa's usual 60 bits. Coordinates are
    // variables without bounds.
    let mut gappa = Command::new("gappa")
        .args(["-Eprecision=400", "-Wno-unbound-variable"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("gappa was found before");
    let mut input = gappa.stdin.take().expect("a pipe");
    input.write_all(text.as_bytes()).expect("gappa reads");
    drop(input);
    let output = gappa.wait_with_output().expect("gappa ends");
    let said =
        [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
    // A warning is a failure too: a hint that Gappa cannot check for itself would be one.
    if output.status.success() && said.iter().all(String::is_empty) {
        Ok(())
    } else {
        Err(said.concat())
    }
}

fn has_gappa() -> bool {
    let found = Command::new("gappa")
        .arg("--version")
        .stdout(Stdio::null())
        .status()
        .is_ok();
    if !found {
        let is_ci = std::env::var_os("CI").is_some_and(|value| value == "true");
        assert!(!is_ci, "gappa is not installed");
        eprintln!("skipped: gappa is not installed");
    }
    found
}

#[test]
fn every_part_is_proved() {
    if !has_gappa() {
        return;
    }
    for (name, script, constants) in scripts() {
        let constants: Vec<_> = constants.iter().map(|&name| (name, value(name))).collect();
        if let Err(said) = prove(script, &constants) {
            panic!("{name} with {constants:?}:\n{said}");
        }
    }
}

#[test]
fn half_of_any_constant_fails() {
    if !has_gappa() {
        return;
    }
    for (name, script, constants) in scripts() {
        for &constant in constants {
            let half = format!("({}) / 2", value(constant));
            let result = prove(script, &[(constant, half)]);
            assert!(result.is_err(), "{name} holds with half of {constant}");
        }
    }
}

#[test]
fn scripts_are_about_the_code() {
    let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    let source = words(&[FILTER, SCALE].concat());
    for (name, script, _) in scripts() {
        let mut lines = script
            .lines()
            .filter_map(|line| line.strip_prefix("# code: "));
        assert!(script.contains("# code: "), "{name} is about no code");
        if let Some(line) = lines.find(|line| !source.contains(&words(line))) {
            panic!("{name}: the source has no line `{line}`");
        }
    }
}
