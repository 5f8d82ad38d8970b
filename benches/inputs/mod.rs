//! Inputs of the benchmarks: uniform points, and the `.poly` files of a folder.

use std::path::{Path, PathBuf};

/// Points and edges with a name.
pub(crate) struct Input {
    pub(crate) name: String,
    pub(crate) points: Vec<[f64; 2]>,
    pub(crate) edges: Vec<[usize; 2]>,
}

/// A million uniform points and the `.poly` files in the folder that the command line names (or in
/// `tests/data`).
pub(crate) fn inputs() -> Vec<Input> {
    // Cargo itself adds an argument, `--bench`.
    let folder = std::env::args()
        .skip(1)
        .find(|argument| !argument.starts_with('-'));
    let tests = || Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data");
    let folder = folder.map_or_else(tests, PathBuf::from);
    let entries = std::fs::read_dir(&folder).expect("a folder of .poly files");
    let mut paths: Vec<PathBuf> = entries
        .map(|entry| entry.expect("an entry").path())
        .collect();
    paths.retain(|path| {
        path.extension()
            .is_some_and(|extension| extension == "poly")
    });
    paths.sort();
    let mut inputs = vec![uniform(1_000_000)];
    inputs.extend(paths.iter().map(|path| read(path)));
    inputs
}

/// Uniform points in the unit square, the same ones on every run.
fn uniform(n: usize) -> Input {
    let mut state = 1_u64;
    let mut coordinate = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let points = (0..n).map(|_| [coordinate(), coordinate()]).collect();
    Input {
        name: format!("{n} uniform points"),
        points,
        edges: Vec::new(),
    }
}

/// Reads a `.poly` file that holds its own points.
fn read(path: &Path) -> Input {
    let text = std::fs::read_to_string(path).expect("a readable file");
    let mut rows = text
        .lines()
        .map(|line| line.split('#').next().unwrap_or_default())
        .map(|line| {
            line.split_whitespace()
                .map(|field| field.parse().expect("a number"))
                .collect()
        })
        .filter(|row: &Vec<f64>| !row.is_empty());
    let mut row = || rows.next().expect("more lines");
    let whole = |x: f64| format!("{x}").parse::<usize>().expect("an index");
    let n = whole(row()[0]);
    let points: Vec<Vec<f64>> = (0..n).map(|_| row()).collect();
    let first = whole(points[0][0]);
    let m = whole(row()[0]);
    let edge = |row: Vec<f64>| [whole(row[1]) - first, whole(row[2]) - first];
    Input {
        name: path
            .file_stem()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned(),
        points: points.iter().map(|point| [point[1], point[2]]).collect(),
        edges: (0..m).map(|_| edge(row())).collect(),
    }
}
