//! A polygon triangulated and drawn.
//!
//!     cargo run --release --example polygon -- star.svg
//!
//! The sides of the polygon are edges of the input. The result covers the convex hull; which triangles lie
//! inside the polygon follows from the constrained sides.

use std::error::Error;
use std::fs::File;
use std::io::BufWriter;

use sweep_cdt::formats::{Graph, OutputFormat, write};
use sweep_cdt::{Triangulation, triangulate};

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).unwrap_or("star.svg".to_owned());
    let points: Vec<[f64; 2]> = (0..10).map(corner).collect();
    let edges: Vec<[usize; 2]> = (0..10).map(|v| [v, (v + 1) % 10]).collect();
    let result = triangulate(&points, &edges)?;
    let inside = inside(&result).into_iter().filter(|&inside| inside);
    println!(
        "{} triangles, {} inside the star",
        result.len(),
        inside.count()
    );

    let graph = Graph {
        points,
        edges,
        ..Graph::default()
    };
    let mut file = BufWriter::new(File::create(&path)?);
    write(OutputFormat::Svg, &graph, &result, &mut file)?;
    println!("drawn to {path}");
    Ok(())
}

/// Corner `i` of a star with five points.
fn corner(i: u8) -> [f64; 2] {
    let radius = if i.is_multiple_of(2) { 10.0 } else { 4.0 };
    let (sine, cosine) = (f64::from(i) * std::f64::consts::PI / 5.0).sin_cos();
    [radius * sine, radius * cosine]
}

/// For each triangle, whether it lies inside the polygon. The answer spreads from the hull inwards; each
/// constrained side that is crossed reverses it.
fn inside(result: &Triangulation) -> Vec<bool> {
    let mut inside = vec![None; result.len()];
    let mut waiting = Vec::new();
    for t in 0..result.len() {
        // On the hull, a triangle is inside if its side there belongs to the polygon.
        for side in 0..3 {
            if result.neighbor(t, side).is_none() {
                waiting.push((t, result.is_constrained(t, side)));
            }
        }
    }
    while let Some((t, is_inside)) = waiting.pop() {
        if inside[t].replace(is_inside).is_some() {
            continue;
        }
        for side in 0..3 {
            if let Some(neighbor) = result.neighbor(t, side) {
                waiting.push((neighbor, is_inside != result.is_constrained(t, side)));
            }
        }
    }
    inside
        .into_iter()
        .map(|found| found == Some(true))
        .collect()
}
