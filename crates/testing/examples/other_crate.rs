//! A campaign against another crate: questions within its claims, a judge, and a small question for each finding.
//!
//! ```sh
//! cargo run --release -p sweep-cdt-testing --example other_crate
//! ```

use sweep_cdt_testing::judge::{Asked, Claims, Numbers, Question, Reply, campaign};

/// The crate to test. It takes no edges.
fn delaunator(question: &Question) -> Reply {
    let points = question
        .points
        .iter()
        .map(|&[x, y]| delaunator::Point { x, y });
    let corners = delaunator::triangulate(&points.collect::<Vec<_>>()).triangles;
    Ok(corners.as_chunks().0.to_vec())
}

fn main() {
    // delaunator computes fourth powers in doubles.
    let claims = Claims::of(Asked::Points).with_numbers(Numbers::integers(20));
    println!("{}", campaign(&claims, 20_000, 1, delaunator));
}
