//! Which degenerate events the executions of a campaign reach.
//!
//! With the environment variable `SWEEP_CDT_REACHED` set to a folder, every sixteenth input is triangulated once more
//! with counters and once with events, by the paper's heuristics, and how many of these inputs had each event
//! is written there from time to time, one file a process. Otherwise this costs one test.

use std::fs;
use std::path::PathBuf;
use std::sync::{Mutex, OnceLock};

use sweep_cdt::trace::{Event, EdgePosition, PointCase, Why};
use sweep_cdt::{Heuristics, Triangulator};

use crate::Input;

/// Of so many inputs one is looked at.
const EVERY: u64 = 16;
/// So many inputs looked at pass between two writings of the file.
const WRITE: u64 = 64;

/// What may be reached, as named in the file.
const NAMES: [&str; 16] = [
    "left case",
    "fill",
    "basin",
    "flip",
    "edge already there",
    "edge below the front",
    "edge by front traversal only",
    "edge by mixed traversal",
    "vertex on an edge",
    "upper hull",
    "orientation by exact stage",
    "in-circle by exact stage",
    "canonical tie",
    "test with an artificial vertex",
    "duplicate points",
    "crossing edges",
];

#[derive(Default)]
struct Tally {
    seen: u64,
    looked_at: u64,
    reached: [u64; NAMES.len()],
}

static TALLY: Mutex<Tally> = Mutex::new(Tally {
    seen: 0,
    looked_at: 0,
    reached: [0; NAMES.len()],
});

/// Counts what this input reaches, if that is asked for.
pub fn sample(input: &Input) {
    static FOLDER: OnceLock<Option<PathBuf>> = OnceLock::new();
    let folder = FOLDER.get_or_init(|| std::env::var_os("SWEEP_CDT_REACHED").map(PathBuf::from));
    if let Some(folder) = folder
        && let Ok(mut tally) = TALLY.lock()
    {
        tally.seen += 1;
        if tally.seen % EVERY == 1 {
            tally.looked_at += 1;
            for (count, is_reached) in tally.reached.iter_mut().zip(reached(input)) {
                *count += u64::from(is_reached);
            }
            if tally.looked_at % WRITE == 1 {
                write(folder, &tally);
            }
        }
    }
}

/// Which of the events this input reaches, in the order of the names.
fn reached(input: &Input) -> [bool; NAMES.len()] {
    let Input { points, edges } = input;
    let mut reached = [false; NAMES.len()];
    let mut upper = None;
    let outcome = Triangulator::new()
        .heuristics(Heuristics::PAPER)
        .triangulate_observed(points, edges, |event| match event {
            Event::Point {
                case: PointCase::Left,
                ..
            } => reached[0] = true,
            Event::Triangle { why: Why::NarrowCorner, .. } => reached[1] = true,
            Event::Triangle {
                why: Why::Basin, ..
            } => reached[2] = true,
            Event::Flip { .. } => reached[3] = true,
            Event::Edge { upper: end, .. } => upper = Some(end),
            Event::Part { position, from, .. } => {
                reached[4] |= position == EdgePosition::Present;
                reached[5] |= position == EdgePosition::BelowFront;
                reached[6] |= position == EdgePosition::FrontOnly;
                reached[7] |= position == EdgePosition::Mixed;
                reached[8] |= upper != Some(from);
            }
            Event::Triangle { why: Why::Hull, .. } => reached[9] = true,
            _ => {}
        });
    reached[14] = outcome.is_ok_and(|result| result.duplicates().len() > 0);
    match Triangulator::new().triangulate_with_stats(points, edges) {
        Ok((_, stats)) => {
            reached[10] = stats.counters.orient2d_exact > 0;
            reached[11] = stats.counters.in_circle_exact > 0;
            reached[12] = stats.counters.cocircular > 0;
            reached[13] = stats.counters.symbolic > 0;
        }
        Err(_) => reached[15] = true,
    }
    reached
}

fn write(folder: &std::path::Path, tally: &Tally) {
    let mut text = format!("inputs\t{}\n", tally.looked_at);
    for (name, count) in NAMES.iter().zip(tally.reached) {
        text += &format!("{name}\t{count}\n");
    }
    // A report that cannot be written must not stop a campaign.
    let _ = fs::write(folder.join(format!("{}.tsv", std::process::id())), text);
}
