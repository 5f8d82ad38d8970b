//! Writes the cloud of a laser scanner: `cargo run --release -p sweep-cdt-stream --features las --example cloud --
//! 50000000 tile.laz` makes fifty million points, packed if the name ends in `.laz`.
//!
//! The scanner flies to and fro and looks to both sides, so that the points lie on a zigzag, some centimetres from an even
//! one. Coordinates are millimetres, as in most tiles. Most points are of the ground (class 2), whose heights are those of
//! hills; an eighth, in runs, are of trees above (class 5).

use std::path::Path;

use las::point::Classification;
use las::{Builder, Point, Transform, Writer};

/// So many points the scanner takes from one side to the other.
const ACROSS: u64 = 1000;
/// The distance of points, in metres.
const STEP: f64 = 0.25;
/// So many points one after the other are of a tree.
const TREE: u64 = 64;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [count, path] = &arguments[..] else {
        return Err("needs a number of points, and a file that ends in .las or .laz".into());
    };
    let (count, path): (u64, _) = (count.parse()?, Path::new(path));
    let mut builder = Builder::from((1, 2));
    builder.point_format.is_compressed =
        path.extension().is_some_and(|extension| extension == "laz");
    let millimetres = Transform {
        scale: 0.001,
        offset: 0.0,
    };
    builder.transforms.x = millimetres;
    builder.transforms.y = millimetres;
    builder.transforms.z = millimetres;
    let mut writer = Writer::from_path(path, builder.into_header()?)?;
    // As many rows in each strip as make all of them a square.
    let rows = count.isqrt().max(1);
    let mut state: u64 = 1;
    // From -1 to 1 (xorshift).
    let mut random = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    for number in 0..count {
        let (row, across) = (number / ACROSS, number % ACROSS);
        let (strip, along) = (row / rows, row % rows);
        let along = if strip % 2 == 0 {
            along
        } else {
            rows - 1 - along
        };
        let across = if row % 2 == 0 {
            across
        } else {
            ACROSS - 1 - across
        };
        let place =
            |at: u64, noise: f64| ((at as f64 + noise * 0.4) * STEP * 1000.0).round() / 1000.0;
        let [x, y] = [
            place(strip * ACROSS + across, random()),
            place(along, random()),
        ];
        let ground = 40.0 * (x / 170.0).sin() * (y / 230.0).cos() + 0.05 * random();
        let (classification, z) = match number / TREE % 8 {
            7 => (Classification::HighVegetation, ground + 9.0),
            _ => (Classification::Ground, ground),
        };
        writer.write_point(Point {
            x,
            y,
            z,
            classification,
            gps_time: None,
            ..Point::default()
        })?;
    }
    writer.close()?;
    Ok(())
}
