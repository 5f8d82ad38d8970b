//! How much memory a triangulation takes beyond its input: at the peak, and what the result keeps.
//!
//! `cargo bench --bench memory [-- FOLDER]`, on the inputs of the benchmark `peers`.

mod inputs;

use inputs::Named;
use peak_alloc::PeakAlloc;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

fn main() {
    println!(
        "{:24} {:>8} {:>14} {:>14}",
        "bytes a point", "points", "peak", "result"
    );
    for Named { name, input } in inputs::inputs() {
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
}
