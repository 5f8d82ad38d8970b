//! Random tests of another crate: degenerate inputs, a judge, and the smallest input that fails.
//!
//! ```sh
//! cargo run --release -p sweep-cdt-testing --example other_crate
//! ```

use sweep_cdt_testing::judge::{Reply, ask, least};
use sweep_cdt_testing::{Input, Random, generators};

/// The crate to test. It takes no edges.
fn delaunator(points: &[[f64; 2]], _: &[[usize; 2]]) -> Reply {
    let points: Vec<_> = points
        .iter()
        .map(|&[x, y]| delaunator::Point { x, y })
        .collect();
    Ok(delaunator::triangulate(&points)
        .triangles
        .as_chunks()
        .0
        .to_vec())
}

/// The fault of its answer, if it may be expected to have one.
fn fault(input: &Input) -> Option<&'static str> {
    let is_moderate = |x: &f64| *x == 0.0 || (1e-9..1e15).contains(&x.abs());
    let is_question = input.edges.is_empty() && input.points.iter().flatten().all(is_moderate);
    is_question.then(|| ask(input, delaunator)).flatten()
}

fn main() {
    for seed in 0..20_000 {
        let input = generators::small(&mut Random::new(seed));
        if let Some(name) = fault(&input) {
            println!("{name}, seed {seed}: {}", least(&input, name, &fault));
        }
    }
}
