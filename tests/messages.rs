//! What the compiler says of coordinates that are none: not only that they lack a trait, but what to use.
//!
//! A package that depends on the library is written and checked, so that these are the messages that a user gets.

use std::fs;
use std::path::Path;
use std::process::Command;

/// What `cargo check` says of a program that triangulates points of this type.
fn messages(coordinate: &str) -> String {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("messages");
    fs::create_dir_all(folder.join("src")).expect("a folder for the package");
    let here = env!("CARGO_MANIFEST_DIR");
    let manifest = format!(
        "[package]\nname = 'messages'\nedition = '2024'\n[workspace]\n[dependencies]\nnum-rational = '0.4'\n\
         sweep-cdt = {{ path = '{here}', default-features = false }}\n"
    );
    let program = format!(
        "pub fn triangles(points: &[[{coordinate}; 2]]) -> usize {{
            sweep_cdt::triangulate(points, &[]).unwrap().len()
        }}"
    );
    let write = |name: &str, text: &str| fs::write(folder.join(name), text).expect("a file");
    write("Cargo.toml", &manifest);
    write("src/lib.rs", &program);
    // The versions that are here already.
    fs::copy(
        Path::new(here).join("Cargo.lock"),
        folder.join("Cargo.lock"),
    )
    .expect("a lock file");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["check", "--offline", "--color", "never"]);
    let output = cargo.current_dir(&folder).output().expect("cargo runs");
    String::from_utf8(output.stderr).expect("text")
}

#[test]
fn types_that_are_no_coordinates_are_told_what_to_use() {
    assert!(!messages("f64").contains("error["));
    for (coordinate, title) in [
        ("u32", "`u32`"),
        ("&'static u64", "`&u64`"),
        ("num_rational::Ratio<i32>", "`Ratio<i32>`"),
        ("String", "`String`"),
    ] {
        let said = messages(coordinate);
        for expected in [
            &format!("{title} is no coordinate: it does not implement `Scalar`"),
            &format!("no exact predicates are known for {title}"),
            "`points.map(|p| p.map(i64::from))` does for `u32`, `i128::from` for `u64`",
            "other fractions, such as `Ratio<i32>`, become `Ratio<i64>` or `BigRational`",
            "a type of your own implements `Scalar`",
        ] {
            assert!(said.contains(expected), "{expected}\nis missing in\n{said}");
        }
    }
}
