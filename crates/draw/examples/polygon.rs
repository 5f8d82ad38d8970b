//! A polygon triangulated and drawn.
//!
//!     cargo run --release --example polygon -- star.svg
//!
//! The sides of the polygon are edges of the input. The result covers the convex hull; the triangles inside the
//! polygon are a domain of it.

use std::error::Error;
use std::fs::File;
use std::io::BufWriter;

use sweep_cdt::interior::FillRule;
use sweep_cdt::{Pslg, triangulate};
use sweep_cdt_draw::write_interior;
use sweep_cdt_formats::Format;

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).unwrap_or("star.svg".to_owned());
    let points: Vec<[f64; 2]> = (0..10).map(corner).collect();
    let edges: Vec<[usize; 2]> = (0..10).map(|v| [v, (v + 1) % 10]).collect();
    let result = triangulate(&points, &edges)?;
    let star = result.interior(FillRule::EvenOdd)?;
    let (all, inside) = (result.len(), star.inside().len());
    println!("{all} triangles, {inside} inside the star");

    let graph = Pslg {
        points,
        edges,
        ..Pslg::default()
    };
    let mut file = BufWriter::new(File::create(&path)?);
    write_interior(Format::Svg, &graph.into(), &star, &mut file)?;
    println!("drawn to {path}");
    Ok(())
}

/// Corner `i` of a star with five points.
fn corner(i: u8) -> [f64; 2] {
    let radius = if i.is_multiple_of(2) { 10.0 } else { 4.0 };
    let (sine, cosine) = (f64::from(i) * std::f64::consts::PI / 5.0).sin_cos();
    [radius * sine, radius * cosine]
}
