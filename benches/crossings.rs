//! How the search for crossings, and splitting, grow with the number of edges.
//!
//! `cargo bench -p sweep-cdt-benches --bench crossings [-- MOST [FAMILY]]` goes from 8,000 edges up to `MOST` (512,000
//! unless named), in steps of eight, with the families of `sweep_cdt_testing::families::crossed` whose names contain
//! `FAMILY`. Printed are the pairs that cross; for each edge and each such pair the boxes and edges that are looked at
//! and the microseconds, of listing and of splitting; and how many times as many are looked at as with 8,000 edges.

use std::time::Instant;

use sweep_cdt::crossings::{Effort, crossings_with, split_with};
use sweep_cdt_testing::families;

/// Looked at and microseconds, for each edge and pair.
type Work = [f64; 2];

fn main() {
    // Cargo itself adds an argument, `--bench`.
    let arguments = std::env::args().skip(1);
    let arguments: Vec<String> = arguments.filter(|text| text != "--bench").collect();
    let most = arguments
        .first()
        .map_or(512_000, |text| text.parse().expect("a number of edges"));
    let wanted = arguments.get(1).map_or("", String::as_str);
    println!(
        "{:56} {:>8} {:>8} {:>8} {:>7} {:>7} {:>8} {:>7} {:>7}",
        "for each edge and pair",
        "edges",
        "pairs",
        "listing",
        "us",
        "growth",
        "split",
        "us",
        "growth"
    );
    let mut worst: f64 = 0.0;
    for family in families::crossed().filter(|family| family.name().contains(wanted)) {
        let mut first = None;
        let mut count = 8000;
        while count <= most {
            let input = family.of_edges(count);
            let work = |effort: &Effort, start: Instant, pairs: usize| {
                let each = (input.edges.len() + pairs) as f64;
                let looked = effort.visited + effort.swept + effort.separated;
                [
                    looked as f64 / each,
                    1e6 * start.elapsed().as_secs_f64() / each,
                ]
            };
            let (start, mut effort) = (Instant::now(), Effort::default());
            let found = crossings_with(&input.points, &input.edges, &mut effort);
            let pairs = match found {
                Ok(found) => found.len(),
                Err(error) => {
                    println!("{:56} {:>8} {error}", family.name(), input.edges.len());
                    break;
                }
            };
            let listing: Work = work(&effort, start, pairs);
            let (start, mut effort) = (Instant::now(), Effort::default());
            split_with(&input.points, &input.edges, &mut effort).expect("a valid input");
            let splitting: Work = work(&effort, start, pairs);
            let [listed, split] = *first.get_or_insert([listing[0], splitting[0]]);
            // Some families make neither boxes nor a triangulation.
            let growth = [(listing[0], listed), (splitting[0], split)];
            let growth =
                growth.map(|(now, first)| if first > 0.0 { now / first } else { 1.0 + now });
            worst = worst.max(growth[0]).max(growth[1]);
            println!(
                "{:56} {:>8} {pairs:>8} {:>8.1} {:>7.2} {:>7.2} {:>8.1} {:>7.2} {:>7.2}",
                family.name(),
                input.edges.len(),
                listing[0],
                listing[1],
                growth[0],
                splitting[0],
                splitting[1],
                growth[1]
            );
            count *= 8;
        }
    }
    println!("the greatest growth: {worst:.2}");
}
