//! Edges that some order of insertion makes quadratic: what they pierce and flip, and how the time grows, by default, by
//! divide and conquer and in two bands. Of the orders natural, reversed and shuffled the worst counts and times are
//! printed, and how many times as long as at [`COMPARED`] points the slowest of the three takes for a point. There
//! the times of the other programs stand beside.

use std::path::Path;
use std::time::Instant;

use sweep_cdt::{Algorithm, Bands, Counters, Stats, Triangulator};
use sweep_cdt_testing::families::{self, Order};
use sweep_cdt_testing::{Input, counted};

use crate::others::{columns, time_cgal, time_spade};

/// The number of points at which other programs run, and from which the growth counts.
const COMPARED: usize = 8000;

/// Prints the table.
pub(crate) fn print(most: usize, wanted: &str, cgal: Option<&Path>) {
    println!(
        "\n{:40} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>6} {:>8} {:>8} {:>6}",
        "edges: nanoseconds a point",
        "points",
        "pierced",
        "4 log2 n",
        "flips",
        "default",
        "divide",
        "bands",
        "growth",
        "spade",
        "CGAL",
        "ratio"
    );
    for family in families::slanted().filter(|family| family.name.contains(wanted)) {
        let mut compared = None;
        for n in [2000, 8000, 32_000, 128_000, 512_000] {
            if n > most {
                continue;
            }
            let input = (family.member)(n);
            let rows = Order::ALL.map(|order| measure(&order.of(&input)));
            let worst = rows[1..].iter().fold(rows[0], |worst, row| worst.and(row));
            let points = input.points.len();
            print!(
                "{:40} {points:>8} {:>8.2} {:>8.1} {:>8.2} {:>8.0} {:>8.0} {:>8.0}",
                family.name,
                worst.pierced,
                4.0 * (points as f64).log2(),
                worst.flips,
                worst.default,
                worst.divide,
                worst.bands
            );
            if n == COMPARED {
                compared = Some(worst);
            }
            match &compared {
                Some(row) => print!(" {:>6.2}", worst.growth(row)),
                None => print!(" {:>6}", ""),
            }
            if n == COMPARED {
                let scattered = families::scattered(&input);
                let theirs = [time_spade(family.name, n), time_cgal(cgal, &scattered)];
                print!("{}", columns(theirs, worst.default));
            }
            println!();
        }
    }
}

/// Pierced triangles a point, flips of edges for each of them, and times in nanoseconds a point.
#[derive(Clone, Copy)]
struct Row {
    pierced: f64,
    flips: f64,
    default: f64,
    divide: f64,
    bands: f64,
}

impl Row {
    /// How many times as long as in the other row a point takes, by the algorithm whose time grows most.
    fn growth(&self, other: &Row) -> f64 {
        (self.default / other.default)
            .max(self.divide / other.divide)
            .max(self.bands / other.bands)
    }

    /// The greater ones of two rows.
    fn and(self, other: &Row) -> Row {
        Row {
            pierced: self.pierced.max(other.pierced),
            flips: self.flips.max(other.flips),
            default: self.default.max(other.default),
            divide: self.divide.max(other.divide),
            bands: self.bands.max(other.bands),
        }
    }
}

fn measure(input: &Input) -> Row {
    let n = input.points.len() as f64;
    let timed = |run: &dyn Fn()| {
        let start = Instant::now();
        run();
        1e9 * start.elapsed().as_secs_f64() / n
    };
    let mut row = Row {
        pierced: 0.0,
        flips: 0.0,
        default: 0.0,
        divide: 0.0,
        bands: 0.0,
    };
    let auto = Triangulator::new();
    let divide = auto.algorithm(Algorithm::DivideAndConquer);
    type Counted<'c> = &'c dyn Fn(&[[usize; 2]]) -> Counters;
    let counted: [Counted<'_>; 3] = [
        &|edges| of_one(&auto, input, edges),
        &|edges| of_one(&divide, input, edges),
        &|edges| {
            let mut stats = Stats::default();
            let bands = Bands::new().count(2).stats(&mut stats);
            let result = auto.triangulate_parallel(&input.points, edges, bands);
            result.expect("edges that do not cross");
            stats.counters
        },
    ];
    for count in counted {
        let [with, without] = [&input.edges[..], &[]].map(count);
        row.pierced = row.pierced.max(with.pierced as f64 / n);
        let flips = with.flips.saturating_sub(without.flips) as f64;
        row.flips = row.flips.max(flips / (with.pierced as f64).max(n));
    }
    let one = |triangulator: &Triangulator| {
        timed(&|| {
            let result = triangulator.triangulate(&input.points, &input.edges);
            result.expect("edges that do not cross");
        })
    };
    (row.default, row.divide) = (one(&auto), one(&divide));
    row.bands = timed(&|| {
        let result = auto.triangulate_parallel(&input.points, &input.edges, Bands::new().count(2));
        result.expect("edges that do not cross");
    });
    row
}

fn of_one(triangulator: &Triangulator, input: &Input, edges: &[[usize; 2]]) -> Counters {
    let run = counted(triangulator, &input.points, edges);
    run.expect("edges that do not cross").stats.counters
}
