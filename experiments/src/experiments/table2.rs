//! The paper's table 2: the time of the three parts of the algorithm (section 3.2).

use std::fmt::Write;

use sweep_cdt::{Algorithm, Heuristics};

use super::experiment::{Experiment, cells, default_structure};
use crate::measure::{Row, Variant};
use crate::report::{Shape, View};

pub(super) const TABLE_2: Experiment = Experiment {
    name: "table2",
    about: "The paper's table 2: initialization, sweeping and finalization.",
    cells: |quick| {
        let sets = if quick { &PAPER[..1] } else { PAPER };
        let sizes: Vec<usize> = sets.iter().map(|set| set.points).collect();
        cells(&["parcels"], &sizes)
    },
    variants: |contestants| {
        let structure = default_structure(contestants);
        let variant =
            |name, heuristics| Variant::sweep(name, structure, Algorithm::Sweep, heuristics);
        vec![
            variant("default", Heuristics::FAST),
            variant("paper's heuristics", Heuristics::PAPER),
        ]
    },
    views: &[View {
        name: "phases",
        title: "Time of the parts, nanoseconds a point",
        about: "Medians of initialization, sweeping and finalization, on the clock.",
        measure: |row| Some(1e6 * row.total_ms / row.points.max(1) as f64),
        shape: Shape::Phases,
    }],
    remarks: beside_the_paper,
};

/// A row of the paper's table 2: seconds of initialization, sweeping and finalization.
struct Set {
    name: &'static str,
    points: usize,
    seconds: [f64; 3],
}

const PAPER: &[Set] = &[
    Set {
        name: "b",
        points: 93_048,
        seconds: [0.2033, 0.1093, 0.0],
    },
    Set {
        name: "f",
        points: 1_488_768,
        seconds: [1.6406, 3.1976, 0.0],
    },
    Set {
        name: "g",
        points: 2_444_700,
        seconds: [3.7343, 5.8853, 0.0053],
    },
];

/// Shares of the three parts, the paper's and those measured.
fn beside_the_paper(rows: &[Row]) -> String {
    let shares = |times: [f64; 3]| {
        let sum: f64 = times.iter().sum();
        let parts = times.map(|time| format!("{:.0} %", 100.0 * time / sum));
        parts.join(" | ")
    };
    let mut text = String::from(
        "## Beside the paper\n\nShares of the whole time.\n\n\
         | set | points | | initialization | sweeping | finalization |\n\
         |---|---:|---|---:|---:|---:|\n",
    );
    for set in PAPER {
        let head = format!("| {} | {}", set.name, set.points);
        let here: Vec<&Row> = rows.iter().filter(|row| row.size == set.points).collect();
        if !here.is_empty() {
            let _ = writeln!(text, "{head} | paper | {} |", shares(set.seconds));
        }
        for row in here {
            let times = [row.initialization_ms, row.sweeping_ms, row.finalization_ms];
            let _ = writeln!(text, "{head} | {} | {} |", row.variant, shares(times));
        }
    }
    text
}
