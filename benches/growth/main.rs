//! How time and memory grow with the number of points on inputs that are made to be hard, and other programs
//! on the same inputs.
//!
//! `cargo bench --bench growth [-- MOST [FAMILY]]` goes up to `MOST` points (a million unless named), with the
//! families of `sweep_cdt_testing::families` whose names contain `FAMILY`. Printed are, for each number of
//! points:
//!
//! * nanoseconds a point, the least of three runs: by the default with the hash table and with the skip
//!   list, by the sweep alone up to 10,000 points, and by divide and conquer; `*` marks a sweep that was
//!   abandoned;
//! * what the input asks for beyond its points: pierced triangles and vertices on edges, for each point;
//! * bytes a point at the peak, beyond the input;
//! * at 100,000 points the time of spade and of CGAL (compiled here, where `c++` finds its headers), and the
//!   default's time divided by that of the faster one;
//! * for stars and asterisks the time of the verification.

mod ours;
mod peers;

use std::io::Write;

use peak_alloc::PeakAlloc;
use sweep_cdt_testing::families;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// The number of points at which other programs run.
const COMPARED: usize = 100_000;

fn main() {
    let arguments: Vec<String> = std::env::args()
        .skip(1)
        .filter(|argument| !argument.starts_with('-'))
        .collect();
    if let [command, family, n] = &arguments[..]
        && command == "spade"
    {
        return peers::spade(family, n.parse().expect("a number of points"));
    }
    let most = arguments
        .first()
        .map_or(1_000_000, |text| text.parse().expect("a number of points"));
    let wanted = arguments.get(1).map_or("", String::as_str);
    let cgal = peers::compile_cgal();

    println!(
        "{:40} {:>8} {:>8} {:>9} {:>8} {:>8} {:>7} {:>7} {:>8} {:>8} {:>6} {:>8}",
        "nanoseconds a point",
        "points",
        "hash",
        "skip list",
        "sweep",
        "divide",
        "asked",
        "bytes",
        "spade",
        "CGAL",
        "ratio",
        "verified"
    );
    for family in families::all().filter(|family| family.name.contains(wanted)) {
        for n in [10_000, 100_000, 1_000_000, 10_000_000] {
            if n <= most {
                let input = families::scattered(&(family.member)(n));
                let row = ours::measure(&input, n, family.name);
                print!("{:40} {:>8} {row}", family.name, input.points.len());
                if n == COMPARED {
                    let spade = peers::time_spade(family.name, n);
                    let theirs = [spade, peers::time_cgal(cgal.as_deref(), &input)];
                    print!("{}", peers::columns(theirs, row.default));
                } else {
                    print!(" {:>8} {:>8} {:>6}", "", "", "");
                }
                println!(" {}", row.verified);
                std::io::stdout().flush().expect("standard output");
            }
        }
    }
}
