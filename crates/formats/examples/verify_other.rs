//! The result of another program verified: what `SciPy` 1.17.1 (Qhull) makes of 17 points.
//!
//!     cargo run --release --example verify_other
//!     cargo run --release --example verify_other -- POINTS.json TRIANGLES.json
//!
//! The second file holds `{"triangles": [[0, 1, 2], ...]}`, as
//! `json.dump({'triangles': scipy.spatial.Delaunay(points).simplices.tolist()}, file)` writes it.

use std::error::Error;
use std::fs::File;

use sweep_cdt::verify::Verifier;
use sweep_cdt_formats::{Format, Input, Source, read, read_result};

fn main() -> Result<(), Box<dyn Error>> {
    let mut files = std::env::args().skip(1);
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/data");
    let mut source = |default: &str| -> std::io::Result<Source> {
        let name = files.next().unwrap_or(format!("{folder}/{default}"));
        let mut file = File::open(&name)?;
        Source::of_file(name, &mut file)
    };
    let points = source("peers/issue13.json")?;
    let triangles = source("peers/scipy_issue13.json")?;

    let Input::Doubles(file) = read(Format::Json, &points, None)? else {
        return Err("the points are fractions".into());
    };
    let triangles = read_result(Format::Json, &triangles, None, &file)?;

    // SciPy may list triangles clockwise.
    let verifier = Verifier::new().accept_clockwise(true);
    match verifier.verify(&file.graph.points, &file.graph.edges, &triangles.list) {
        Ok(_) => println!("right"),
        Err(violations) => {
            println!("wrong:");
            for violation in &violations.list {
                println!("- {violation}");
            }
        }
    }
    Ok(())
}
