//! How long sorting takes: nanoseconds a point of generated points, or of a file.
//!
//! `cargo run --release -p sweep-cdt-stream --example time -- 10000000 256 uniform` sorts ten million points in 256
//! megabytes. `uniform`, `rows` (a thousand different y), `clusters`, `equal` and `ordered` (nearly) are kinds of points;
//! with `edges` at the end an edge joins each point to the next, with `far-edges` to one far from it in the file. A file in
//! the place of the count is sorted as it is.

use std::path::Path;
use std::time::Instant;

use sweep_cdt_formats::ReadError;
use sweep_cdt_stream::external::{FORMATS, Format, Input, Sorting, open};

/// Points that are made when they are asked for.
struct Made {
    kind: String,
    left: u64,
    edges: u64,
    /// How far the ends of an edge are from each other in the input.
    step: u64,
    next_edge: u64,
    state: u64,
}

impl Made {
    /// A number from 0 to 1 (xorshift).
    fn random(&mut self) -> f64 {
        self.state ^= self.state << 13;
        self.state ^= self.state >> 7;
        self.state ^= self.state << 17;
        (self.state >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn point(&mut self) -> [f64; 2] {
        let [x, y, z] = [self.random(), self.random(), self.random()];
        match self.kind.as_str() {
            "rows" => [x, (y * 1000.0).floor()],
            "clusters" => {
                let place = (z * 100.0).floor();
                [place + x * x * x * 1e-3, place * place + y * y * y * 1e-3]
            }
            "equal" => [1.0, 1.0],
            "ordered" => [x, -(self.left as f64)],
            _ => [x, y],
        }
    }
}

impl Input for Made {
    fn name(&self) -> &str {
        &self.kind
    }

    fn next_points(&mut self, points: &mut Vec<[f64; 2]>) -> Result<(), ReadError> {
        let count = self.left.min(1 << 13);
        self.left -= count;
        points.extend((0..count).map(|_| self.point()));
        Ok(())
    }

    fn next_edges(&mut self, edges: &mut Vec<[u64; 2]>) -> Result<(), ReadError> {
        let end = (self.next_edge + (1 << 13)).min(self.edges);
        edges.extend(
            (self.next_edge..end).map(|edge| [edge, (edge + self.step) % (self.edges + 1)]),
        );
        self.next_edge = end;
        Ok(())
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let argument =
        |at: usize, default: &str| arguments.get(at).map_or(default.to_owned(), String::clone);
    let (what, megabytes) = (argument(0, "10000000"), argument(1, "256").parse::<u64>()?);
    let mut input: Box<dyn Input> = match what.parse::<u64>() {
        Ok(count) => Box::new(Made {
            kind: argument(2, "uniform"),
            left: count,
            edges: match argument(3, "").as_str() {
                "" => 0,
                _ => count - 1,
            },
            step: match argument(3, "").as_str() {
                "far-edges" => count / 7 * 3 + 1,
                _ => 1,
            },
            next_edge: 0,
            state: 88_172_645_463_325_252,
        }),
        Err(_) => {
            let path = Path::new(&what);
            let extension = path.extension().and_then(|extension| extension.to_str());
            let format =
                Format::named(extension.unwrap_or_default(), FORMATS).ok_or("an unknown format")?;
            open(path, format, None)?
        }
    };
    let since = Instant::now();
    let mut order = Sorting::new(megabytes << 20, std::env::temp_dir()).sort(&mut *input)?;
    let sorted = since.elapsed();
    let mut last = [f64::NEG_INFINITY; 2];
    let (mut points, mut edges) = (0_u64, 0);
    while let Some(vertex) = order.next_vertex()? {
        let place = [vertex.point[1], vertex.point[0]];
        assert!(last <= place, "a point comes too late");
        last = place;
        points += 1;
        edges += vertex.upper.len() as u64;
    }
    assert_eq!(
        (points, edges),
        (order.summary().points, order.summary().edges)
    );
    let each = |time: std::time::Duration| time.as_secs_f64() * 1e9 / points as f64;
    println!(
        "{points} points and {edges} edges: {:.1} ns a point up to the first vertex, {:.1} in all",
        each(sorted),
        each(since.elapsed())
    );
    println!("{:?}", order.statistics());
    Ok(())
}
