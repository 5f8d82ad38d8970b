//! Programs in other languages, where they can run.

use std::path::Path;
use std::process::{Command, Output};

use super::{ALL, Program, source};

/// CGAL, compiled here if there are a compiler and its headers.
pub(super) fn cgal(folder: &Path) -> Option<Program> {
    let program = folder.join("cgal").to_string_lossy().into_owned();
    let source = source("cgal.cpp").to_string_lossy().into_owned();
    let compiler = ["c++", "-O2", "-DNDEBUG", "-frounding-math", "-o"];
    let libraries = ["-lgmp", "-lmpfr"];
    let arguments = compiler
        .into_iter()
        .chain([program.as_str(), source.as_str()]);
    output(arguments.chain(libraries))?;
    Some(Program {
        name: "CGAL",
        version: output([program.as_str()].into_iter())?,
        command: vec![program],
        kinds: ALL,
        is_inside: false,
        is_exact: true,
    })
}

/// Triangle, if this Python imports it.
pub(super) fn triangle(python: &Path) -> Option<Program> {
    let python = python.to_string_lossy().into_owned();
    let script = source("with_triangle.py").to_string_lossy().into_owned();
    Some(Program {
        name: "Triangle",
        version: output([python.as_str(), script.as_str()].into_iter())?,
        command: vec![python, script],
        kinds: ALL,
        is_inside: false,
        is_exact: true,
    })
}

/// What a command prints, if it succeeds.
fn output<'a>(mut words: impl Iterator<Item = &'a str> + 'a) -> Option<String> {
    let output = Command::new(words.next()?).args(words).output();
    let Output { status, stdout, .. } = output.ok()?;
    let text = String::from_utf8_lossy(&stdout).trim().to_owned();
    status.success().then_some(text)
}
