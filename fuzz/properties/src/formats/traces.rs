//! Traces: both formats, and the replay.

use sweep_cdt::Triangulator;
use sweep_cdt::formats::Graph;
use sweep_cdt::trace::Trace;

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

/// The trace of a run reads as it was written, and its replay gives the result.
pub(super) fn run(graph: &Graph<f64>) {
    let mut trace = Trace::default();
    let result = Triangulator::new()
        .triangulate_observed(&graph.points, &graph.edges, |e| trace.events.push(e));
    assert_reads(&trace);
    if let Ok(result) = result {
        assert_eq!(
            trace.replay(),
            Ok(result.triangulation.canonical_triangles())
        );
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
