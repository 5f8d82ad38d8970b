//! Traces: the steps of the paper's figures, the same steps for every scalar and front. A replay returns the
//! result, and refuses a damaged trace.

pub(crate) mod figures;
mod formats;
mod replay;
mod same;

use sweep_cdt::Heuristics;
use sweep_cdt::trace::Trace;
use sweep_cdt_testing::{Input, Steps};

const HEURISTICS: [Heuristics; 3] = [Heuristics::FAST, Heuristics::PAPER, Heuristics::OFF];

/// The steps of the default scalar and front.
fn steps(input: &Input, heuristics: Heuristics) -> Steps {
    Steps::of(&input.points, &input.edges, heuristics)
}

fn text(trace: &Trace) -> String {
    let mut text = Vec::new();
    trace.write_text(&mut text).expect("memory takes all");
    String::from_utf8(text).expect("text")
}

fn lines(trace: &Trace) -> String {
    let mut text = Vec::new();
    trace.write_lines(&mut text).expect("memory takes all");
    String::from_utf8(text).expect("text")
}
