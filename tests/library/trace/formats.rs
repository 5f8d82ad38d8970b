//! How steps are written, and what is read: parts of a trace, texts that are none, JSON lines.

use sweep_cdt::Heuristics;
use sweep_cdt_testing::Input;
use sweep_cdt_trace::Trace;
use sweep_cdt_trace::read_trace;

use super::{lines, steps, text};
use crate::cases;

#[test]
fn a_part_of_a_trace_is_read_but_not_replayed() {
    let (_, input) = cases::all()
        .find(|(_, input)| input.points.len() > 5)
        .expect("a case");
    let whole = steps(&input, Heuristics::FAST).trace;
    let part = Trace {
        skipped: 3,
        events: whole.events[3..6].to_vec(),
    };
    let text = text(&part);
    assert!(
        text.starts_with("sweep-cdt trace 3 from step 4\n"),
        "{text}"
    );
    assert_eq!(read_trace(&text).as_ref(), Ok(&part));
    assert_eq!(read_trace(&lines(&part)).as_ref(), Ok(&part));
    assert_eq!(
        part.replay().unwrap_err().to_string(),
        "line 1: the trace lacks its first 3 steps"
    );
}

#[test]
fn what_is_no_trace_is_refused() {
    let cases = [
        ("", "line 1: is not the header `sweep-cdt trace 3`"),
        (
            "sweep-cdt trace 1\n",
            "line 1: is not the header `sweep-cdt trace 3`",
        ),
        ("sweep-cdt trace 3\n", "line 2: the trace ends too early"),
        (
            "sweep-cdt trace 3\nsorted  3\n",
            "line 2: is no step: \"sorted  3\"",
        ),
        (
            "sweep-cdt trace 3\nsorted 0\nsorted 0\n",
            "line 3: vertex 0 is sorted twice",
        ),
        (
            "sweep-cdt trace 3\nsorted -1\n",
            "line 2: is no step: \"sorted -1\"",
        ),
        (
            "sweep-cdt trace 3\nfinalization\nfinished: 0 triangles\nsorted 0\n",
            "line 4: the trace is over",
        ),
        ("{}\n", "line 1: is not the header of a trace of version 3"),
        (
            "{\"format\":\"other\",\"version\":3}\n",
            "line 1: is not the header of a trace of version 3",
        ),
        (
            "{\"format\":\"sweep-cdt trace\",\"version\":3,\"from\":0}\n",
            "line 1: is not the header of a trace of version 3",
        ),
        (
            "{\"format\":\"sweep-cdt trace\",\"version\":3}\n{\"event\":\"sorted\",\"vertex\":1,\"x\":0}\n",
            "line 2: is no step: \"{\\\"event\\\":\\\"sorted\\\",\\\"vertex\\\":1,\\\"x\\\":0}\"",
        ),
    ];
    for (text, message) in cases {
        let refused = read_trace(text).and_then(|trace| trace.replay());
        assert_eq!(refused.unwrap_err().to_string(), message);
    }
}

#[test]
fn json_lines_are_as_documented() {
    let input = Input::parse("0 0, 2 0, 1 1", "");
    let lines = lines(&steps(&input, Heuristics::FAST).trace);
    let some = [
        r#"{"format":"sweep-cdt trace","version":3}"#,
        r#"{"event":"sorted","vertex":0}"#,
        r#"{"event":"triangle","vertices":[0,"P-1","P-2"],"why":"first"}"#,
        r#"{"event":"front-insert","vertex":0,"after":"P-1"}"#,
        r#"{"event":"point","vertex":1,"case":"middle","segment":[0,"P-2"]}"#,
        r#"{"event":"finalization"}"#,
        r#"{"event":"finished","triangles":1}"#,
    ];
    for line in some {
        assert!(
            lines.lines().any(|other| other == line),
            "{line} in\n{lines}"
        );
    }
}
