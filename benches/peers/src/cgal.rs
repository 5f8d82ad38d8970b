//! CGAL, compiled where there are a compiler and its headers: `cgal.cpp`.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The program in this folder that calls CGAL, if it can be compiled.
pub(crate) fn compile(folder: &Path) -> Option<PathBuf> {
    let program = folder.join("cgal");
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("cgal.cpp");
    let compiled = Command::new("c++")
        .args(["-O2", "-DNDEBUG", "-frounding-math", "-o"])
        .args([&program, &source])
        .args(["-lgmp", "-lmpfr"])
        .stderr(Stdio::null())
        .status();
    compiled
        .is_ok_and(|status| status.success())
        .then_some(program)
}
