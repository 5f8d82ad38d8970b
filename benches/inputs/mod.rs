//! Inputs of the benchmarks: uniform points, and the `.poly` files of a folder.

use std::path::{Path, PathBuf};

use sweep_cdt_testing::{Input, Random, data};

/// Points and edges with a name.
pub(crate) struct Named {
    pub(crate) name: String,
    pub(crate) input: Input,
}

/// A million uniform points and the `.poly` files in the folder that the command line names (or in
/// `tests/data`).
pub(crate) fn inputs() -> Vec<Named> {
    // Cargo itself adds an argument, `--bench`.
    let folder = std::env::args()
        .skip(1)
        .find(|argument| !argument.starts_with('-'));
    let folder = folder.map_or_else(|| data::path("tests/data"), PathBuf::from);
    let mut inputs = vec![uniform(1_000_000)];
    inputs.extend(data::files(&folder, "poly").iter().map(|path| read(path)));
    inputs
}

/// Uniform points in the unit square, the same ones on every run.
fn uniform(n: usize) -> Named {
    let points = Random::new(1).points(n);
    Named {
        name: format!("{n} uniform points"),
        input: Input {
            points,
            edges: Vec::new(),
        },
    }
}

fn read(path: &Path) -> Named {
    let name = path.file_stem().unwrap_or_default();
    Named {
        name: name.to_string_lossy().into_owned(),
        input: data::poly(path),
    }
}
