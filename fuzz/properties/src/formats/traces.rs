//! Traces: both formats, and the replay.

use sweep_cdt::Heuristics;
use sweep_cdt::formats::Graph;
use sweep_cdt::trace::Trace;
use sweep_cdt_testing::Steps;

/// Reads any text, replays it if it is a trace, and reads it again as it is written.
pub(super) fn try_text(text: &str) {
    match Trace::parse(text) {
        Ok(trace) => {
            assert_reads(&trace);
            if let Err(error) = trace.replay() {
                assert!(!error.to_string().is_empty());
            }
        }
        Err(error) => assert!(error.line > 0, "{error}"),
    }
}

/// The trace of a run reads as it was written, and its replay returns the result.
pub(super) fn run(graph: &Graph<f64>) {
    let steps = Steps::of(&graph.points, &graph.edges, Heuristics::default());
    let Steps { trace, result, .. } = steps;
    assert_reads(&trace);
    if let Ok(result) = result {
        assert_eq!(trace.replay(), Ok(result.canonical_triangles()));
    }
}

fn assert_reads(trace: &Trace) {
    let (mut text, mut lines) = (Vec::new(), Vec::new());
    trace
        .write_text(&mut text)
        .and_then(|()| trace.write_lines(&mut lines))
        .expect("memory takes all that is written");
    for file in [text, lines] {
        let file = String::from_utf8(file).expect("traces are text");
        assert_eq!(Trace::parse(&file).as_ref(), Ok(trace));
    }
}
