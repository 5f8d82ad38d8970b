//! How much memory a triangulation takes beyond its input: at the peak, and what the result keeps.
//!
//! `cargo bench -p sweep-cdt-benches --bench memory [-- FOLDER]` takes a million uniform points and every `.poly` file of the
//! folder (`tests/data` unless named).

use std::path::PathBuf;

use peak_alloc::PeakAlloc;
use sweep_cdt_testing::{Input, Random, data};

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

fn main() {
    println!(
        "{:24} {:>8} {:>14} {:>14}",
        "bytes a point", "points", "peak", "result"
    );
    // Cargo itself adds an argument, `--bench`.
    let folder = std::env::args()
        .skip(1)
        .find(|argument| !argument.starts_with('-'));
    let folder = folder.map_or_else(|| data::path("tests/data"), PathBuf::from);

    let uniform = Input {
        points: Random::new(1).points(1_000_000),
        edges: Vec::new(),
    };
    measure("uniform points", &uniform);
    for path in data::files(&folder, "poly") {
        let name = path.file_stem().unwrap_or_default();
        measure(&name.to_string_lossy(), &data::poly(&path));
    }
}

fn measure(name: &str, input: &Input) {
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    let result = sweep_cdt::triangulate(&input.points, &input.edges).expect("a valid input");
    let per_point = |bytes: usize| (bytes - before) as f64 / input.points.len() as f64;
    let (peak, kept) = (
        per_point(MEMORY.peak_usage()),
        per_point(MEMORY.current_usage()),
    );
    println!(
        "{name:24} {:>8} {peak:>14.1} {kept:>14.1}",
        input.points.len()
    );
    drop(result);
}
