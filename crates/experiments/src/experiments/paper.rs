//! The paper's tables 1 and 2, measured here.

use std::fmt::Write;

use sweep_cdt::{Algorithm, Heuristics};

use super::{Experiment, cells, default_structure};
use crate::measure::{Row, TRIANGLE, Variant};
use crate::report::{Shape, View};

/// Table 1: nine sets of parcels and contour lines, and its algorithms as ratios to the sweep.
pub(crate) const TABLE_1: Experiment = Experiment {
    name: "table1",
    about: "The paper's table 1: the sweep and other algorithms on parcels and contour lines.",
    cells: |quick| {
        let count = if quick { 3 } else { PAPER_1.len() };
        let cell = |set: &Set| cells(&[set.kind], &[set.points], 1..=1);
        // M-INC did not end in the paper's time on the others.
        let ended = PAPER_1[..count]
            .iter()
            .filter(|set| set.seconds[0].is_some());
        ended.flat_map(cell).collect()
    },
    variants: |contestants| {
        let structure = default_structure(contestants);
        let variant =
            |name, algorithm, heuristics| Variant::sweep(name, structure, algorithm, heuristics);
        vec![
            variant(SL, Algorithm::Sweep, Heuristics::FAST),
            variant(
                "SL, paper's heuristics",
                Algorithm::Sweep,
                Heuristics::PAPER,
            ),
            variant(LS_DC, Algorithm::DivideAndConquer, Heuristics::FAST),
            variant(F_S, Algorithm::Fortune, Heuristics::FAST),
            variant(M_INC, Algorithm::Incremental, Heuristics::FAST),
            variant(Z_2005, Algorithm::Sweep2005, Heuristics::FAST),
        ]
    },
    views: &[
        View {
            name: "time",
            title: "Time of the whole triangulation, nanoseconds a point",
            about: "Medians, against the number of points.",
            measure: Row::ns_per_point,
            shape: Shape::Growth,
        },
        View {
            name: "flips",
            title: "Flips, a point",
            about: "Sides swapped by the legalization. An algorithm that swaps none has no line.",
            measure: |row| Some(row.flips as f64 / row.points.max(1) as f64),
            shape: Shape::Growth,
        },
    ],
    remarks: beside_table_1,
};

const SL: &str = "SL";
const LS_DC: &str = "LS-D&C";
const M_INC: &str = "M-INC";
const F_S: &str = "F-S";
/// The sweep of 2005, without artificial points; not in the paper's table.
const Z_2005: &str = "SL of 2005";

/// A row of the paper's table 1.
struct Set {
    name: &'static str,
    /// The kind of data here: edges to points tell which it was.
    kind: &'static str,
    points: usize,
    /// Seconds of M-INC (where it ended), F-S, LS-D&C and SL.
    seconds: [Option<f64>; 4],
}

const fn set(
    name: &'static str,
    kind: &'static str,
    points: usize,
    seconds: [Option<f64>; 4],
) -> Set {
    Set {
        name,
        kind,
        points,
        seconds,
    }
}

const PAPER_1: &[Set] = &[
    set(
        "a",
        "parcels",
        23_262,
        [Some(0.1624), Some(0.1030), Some(0.0690), Some(0.0658)],
    ),
    set(
        "b",
        "parcels",
        93_048,
        [Some(0.7996), Some(0.4656), Some(0.3376), Some(0.3227)],
    ),
    set(
        "c",
        "contours",
        162_244,
        [Some(1.2844), Some(0.7848), Some(0.5124), Some(0.5313)],
    ),
    set(
        "d",
        "parcels",
        372_192,
        [Some(4.5940), Some(2.0312), Some(1.6185), Some(1.2397)],
    ),
    set(
        "e",
        "contours",
        1_297_360,
        [Some(21.1436), Some(8.7032), Some(4.3500), Some(4.8907)],
    ),
    set(
        "f",
        "parcels",
        1_488_768,
        [Some(26.5833), Some(9.6303), Some(7.7188), Some(4.7813)],
    ),
    set(
        "g",
        "parcels",
        2_444_700,
        [Some(56.5155), Some(29.2453), Some(22.8850), Some(8.7660)],
    ),
    set(
        "h",
        "contours",
        5_189_440,
        [None, Some(64.9476), Some(19.9814), Some(20.4637)],
    ),
    set(
        "i",
        "parcels",
        5_955_072,
        [None, Some(119.7030), Some(45.0468), Some(23.4323)],
    ),
];

/// The paper's times and those measured, as ratios to the sweep's.
fn beside_table_1(rows: &[Row]) -> String {
    let mut text = String::from(
        "## Beside the paper\n\nRatios of times to SL. All sort the points here: M-INC too, which then takes \
         them in random order. The paper's sets are real and partly tiled, those here are \
         generated with about as many points and edges.\n\n\
         | set | data | points | paper: M-INC | paper: F-S | paper: LS-D&C | here: M-INC | here: F-S | \
         here: LS-D&C | here: SL of 2005 | here: Triangle |\n\
         |---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n",
    );
    for set in PAPER_1 {
        let total = |variant: &str| {
            let mut here = rows.iter().filter(|row| row.size == set.points);
            here.find(|row| row.variant == variant)
                .and_then(Row::ns_per_point)
        };
        let Some(sweep) = total(SL) else {
            continue;
        };
        let here = [M_INC, F_S, LS_DC, Z_2005, TRIANGLE].map(|variant| {
            let ratio = total(variant).map(|time| format!("{:.2}", time / sweep));
            ratio.unwrap_or_default()
        });
        let paper: Vec<String> = set.seconds[..3]
            .iter()
            .map(|&seconds| match (seconds, set.seconds[3]) {
                (Some(seconds), Some(sweep)) => format!("{:.2}", seconds / sweep),
                _ => String::new(),
            })
            .collect();
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} |",
            set.name,
            set.kind,
            set.points,
            paper.join(" | "),
            here.join(" | ")
        );
    }
    text
}

/// Table 2: the time of the three parts of the algorithm (section 3.2).
pub(crate) const TABLE_2: Experiment = Experiment {
    name: "table2",
    about: "The paper's table 2: initialization, sweeping and finalization.",
    cells: |quick| {
        let sets = if quick { &PAPER_2[..1] } else { PAPER_2 };
        let sizes: Vec<usize> = sets.iter().map(|set| set.points).collect();
        cells(&["parcels"], &sizes, 1..=1)
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
        measure: |row| row.phases().map(|parts| parts.iter().sum()),
        shape: Shape::Phases,
    }],
    remarks: beside_table_2,
};

/// A row of the paper's table 2: seconds of initialization, sweeping and finalization.
struct Phases {
    name: &'static str,
    points: usize,
    seconds: [f64; 3],
}

const PAPER_2: &[Phases] = &[
    Phases {
        name: "b",
        points: 93_048,
        seconds: [0.2033, 0.1093, 0.0],
    },
    Phases {
        name: "f",
        points: 1_488_768,
        seconds: [1.6406, 3.1976, 0.0],
    },
    Phases {
        name: "g",
        points: 2_444_700,
        seconds: [3.7343, 5.8853, 0.0053],
    },
];

/// Shares of the three parts, the paper's and those measured.
fn beside_table_2(rows: &[Row]) -> String {
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
    for set in PAPER_2 {
        let head = format!("| {} | {}", set.name, set.points);
        let is_shown = |row: &&Row| row.size == set.points && row.phases().is_some();
        let here: Vec<&Row> = rows.iter().filter(is_shown).collect();
        if !here.is_empty() {
            let _ = writeln!(text, "{head} | paper | {} |", shares(set.seconds));
        }
        for row in here {
            let parts = row.phases().map(shares).unwrap_or_default();
            let _ = writeln!(text, "{head} | {} | {parts} |", row.variant);
        }
    }
    text
}
