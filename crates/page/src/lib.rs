//! Makes the page that computes: one file, which needs no network.
//!
//! The page is the files of `src/page` put together with the program of `compute`, which is built here for
//! `wasm32-wasip1` and stands in the page as base64 of a gzip file. A worker of the page runs the program for each
//! change of the input, and for each file to save; the steps are shown by the page that the command writes.
//!
//! `rustup target add wasm32-wasip1` installs what the build needs.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::Command;

use base64::prelude::{BASE64_STANDARD, Engine};
use flate2::Compression;
use flate2::write::GzEncoder;
use sweep_cdt_engine::{ALGORITHMS, FRONTS, HEURISTICS, Inside};
use sweep_cdt_formats::Format;
use sweep_cdt_generate::KINDS;

/// The platform of the program.
pub const TARGET: &str = "wasm32-wasip1";

const HTML: &str = include_str!("page/index.html");
const CSS: &str = include_str!("page/style.css");
const WORKER: [&str; 2] = [include_str!("page/wasi.js"), include_str!("page/worker.js")];
const SCRIPTS: [&str; 7] = [
    include_str!("page/computer.js"),
    include_str!("page/answer.js"),
    include_str!("page/input.js"),
    include_str!("page/view.js"),
    include_str!("page/pointer.js"),
    include_str!("page/words.js"),
    include_str!("page/page.js"),
];

/// Builds the program in a folder for what is built, and returns its file.
///
/// # Errors
/// Fails if the program cannot be built; the compiler has said why.
pub fn build_program(folder: &Path) -> io::Result<PathBuf> {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.current_dir(env!("CARGO_MANIFEST_DIR"));
    cargo.args(["build", "--release", "--locked", "--target", TARGET]);
    cargo.args(["--package", "sweep-cdt-compute", "--target-dir"]);
    let status = cargo.arg(folder).status()?;
    if !status.success() {
        let advice = format!("the program for {TARGET} cannot be built: {status}");
        return Err(io::Error::other(advice));
    }
    let program = folder.join(TARGET).join("release/sweep-cdt-compute.wasm");
    Ok(program)
}

/// The page with this program in it.
///
/// # Errors
/// The program cannot be read.
pub fn page(program: &Path) -> io::Result<String> {
    let mut packed = GzEncoder::new(Vec::new(), Compression::best());
    packed.write_all(&fs::read(program)?)?;
    let program = BASE64_STANDARD.encode(packed.finish()?);
    let option = |kind: &str, name: &str, text: &str| {
        format!(r#"<option value="{kind}{name}">{text}</option>"#)
    };
    let files = |kind: &'static str, names: Vec<&'static str>| -> String {
        let file = |name| option(kind, name, &format!(".{name}"));
        names.into_iter().map(file).collect()
    };
    let inputs: Vec<&str> = Format::INPUTS.iter().map(|input| input.name()).collect();
    let outputs = Format::OUTPUTS.iter().map(|output| output.name()).collect();
    let named = |name: &str| option("", name, name);
    let kinds = KINDS.iter().map(|kind| named(kind.name));
    let rules = Inside::names().chain(["at-least-2"]).map(named);
    let extensions: Vec<String> = inputs.iter().map(|name| format!(".{name}")).collect();
    let parts = [
        ("{{css}}", CSS.to_owned()),
        ("{{results}}", files("result ", outputs)),
        ("{{graphs}}", files("graph ", inputs)),
        ("{{kinds}}", kinds.collect()),
        ("{{extensions}}", extensions.join(",")),
        (
            "{{fronts}}",
            FRONTS.iter().map(|front| named(front.name)).collect(),
        ),
        (
            "{{heuristics}}",
            HEURISTICS.iter().map(|rules| named(rules.name)).collect(),
        ),
        (
            "{{algorithms}}",
            ALGORITHMS
                .iter()
                .map(|algorithm| named(algorithm.name))
                .collect(),
        ),
        ("{{rules}}", rules.collect()),
        ("{{program}}", program),
        ("{{worker}}", WORKER.join("\n")),
        ("{{js}}", SCRIPTS.join("\n")),
    ];
    let mut page = String::new();
    let mut rest = HTML;
    for (mark, text) in parts {
        let (before, after) = rest.split_once(mark).expect("the page has its marks");
        page = page + before + &text;
        rest = after;
    }
    Ok(page + rest)
}
