//! Traces: the same for every scalar and front; replayed, they give the result; damaged, they are
//! refused.

mod large;

use num_bigint::BigInt;
use num_rational::BigRational;
use sweep_cdt::trace::{BadTrace, Trace};
use sweep_cdt::{
    Error, FrontSearch, HashTable, Heuristics, Linear, SkipList, Triangulation, Triangulator,
};

use crate::runs::{Sample, convert};
use crate::{cases, hard};
use sweep_cdt_properties::Input;

const HEURISTICS: [Heuristics; 3] = [Heuristics::FAST, Heuristics::PAPER, Heuristics::OFF];

type Run = (Trace, Result<Triangulation, Error>);

fn observe<S: Sample, F: FrontSearch>(input: &Input, heuristics: Heuristics) -> Option<Run> {
    let points = convert::<S>(&input.points)?;
    let mut trace = Trace::default();
    let result = Triangulator::new()
        .front::<F>()
        .heuristics(heuristics)
        .triangulate_observed(&points, &input.edges, |event| trace.events.push(event));
    Some((trace, result))
}

fn trace(input: &Input, heuristics: Heuristics) -> Run {
    observe::<f64, HashTable>(input, heuristics).expect("doubles hold doubles")
}

/// Asserts that the trace in these numbers is `expected` for every front.
fn assert_same<S: Sample>(input: &Input, heuristics: Heuristics, expected: &Trace) {
    let observe = [
        observe::<S, HashTable>,
        observe::<S, SkipList>,
        observe::<S, Linear>,
    ];
    for observe in observe {
        if let Some((trace, _)) = observe(input, heuristics) {
            assert!(trace == *expected, "{}", std::any::type_name::<S>());
        }
    }
}

#[test]
fn the_same_steps_for_every_scalar_and_front() {
    for (name, input) in cases::all() {
        println!("{name}");
        for heuristics in HEURISTICS {
            let (expected, _) = trace(&input, heuristics);
            assert_same::<f64>(&input, heuristics, &expected);
            assert_same::<f32>(&input, heuristics, &expected);
            assert_same::<i32>(&input, heuristics, &expected);
            assert_same::<i64>(&input, heuristics, &expected);
            assert_same::<BigInt>(&input, heuristics, &expected);
            assert_same::<BigRational>(&input, heuristics, &expected);
        }
    }
}

fn text(trace: &Trace) -> String {
    let mut text = Vec::new();
    trace.write_text(&mut text).expect("memory takes all");
    String::from_utf8(text).expect("text")
}

#[cfg(feature = "formats")]
fn lines(trace: &Trace) -> String {
    let mut text = Vec::new();
    trace.write_lines(&mut text).expect("memory takes all");
    String::from_utf8(text).expect("text")
}

/// Writes, reads and replays the trace of an input.
fn assert_replays(input: &Input) {
    for heuristics in HEURISTICS {
        let (trace, result) = trace(input, heuristics);
        assert_eq!(Trace::parse(&text(&trace)).as_ref(), Ok(&trace));
        #[cfg(feature = "formats")]
        assert_eq!(Trace::parse(&lines(&trace)).as_ref(), Ok(&trace));
        let replayed = trace.replay();
        match result {
            Ok(result) => assert_eq!(replayed, Ok(result.canonical_triangles())),
            Err(_) => {
                let line = trace.events.len() + 2;
                assert_eq!(replayed.map_err(|bad| bad.line), Err(line));
            }
        }
    }
}

#[test]
fn replay_gives_the_result_of_every_case() {
    for (name, input) in cases::all() {
        println!("{name}");
        assert_replays(&input);
    }
}

#[test]
fn replay_gives_the_result_of_hard_inputs() {
    for file in hard::own_files() {
        if file.input.points.len() <= 5000 {
            println!("{}", file.path.display());
            assert_replays(&file.input);
        }
    }
}

fn read_and_replay(lines: &[&str]) -> Result<Vec<[usize; 3]>, BadTrace> {
    Trace::parse(&(lines.join("\n") + "\n"))?.replay()
}

/// Calls `damage` with the lines of the trace of every case and the result.
fn for_each_trace(damage: impl Fn(&[&str], &[[usize; 3]])) {
    for (name, input) in cases::all() {
        println!("{name}");
        for heuristics in [Heuristics::PAPER, Heuristics::OFF] {
            let (trace, result) = trace(&input, heuristics);
            if let Ok(result) = result {
                let text = text(&trace);
                let lines: Vec<&str> = text.lines().collect();
                damage(&lines, &result.canonical_triangles());
            }
        }
    }
}

#[test]
fn a_line_that_is_missing_is_noticed() {
    for_each_trace(|lines, triangles| {
        for at in 0..lines.len() {
            let mut damaged = lines.to_vec();
            let line = damaged.remove(at);
            match read_and_replay(&damaged) {
                Err(bad) => assert!(bad.line > at, "{line}: {bad}"),
                Ok(found) => {
                    let is_informal = line.starts_with("test") || line.starts_with("switch");
                    assert!(is_informal, "{line}");
                    assert_eq!(found, triangles);
                }
            }
        }
    });
}

#[test]
fn a_line_that_comes_twice_is_noticed() {
    for_each_trace(|lines, triangles| {
        for at in 0..lines.len() {
            let mut damaged = lines.to_vec();
            let line = damaged[at];
            damaged.insert(at, line);
            match read_and_replay(&damaged) {
                Err(bad) => assert!(bad.line > at + 1, "{line}: {bad}"),
                Ok(found) => {
                    // Only an illegal edge is not there to be tested again.
                    let stays = line.ends_with(": legal") || line.ends_with(": fixed");
                    assert!(line.starts_with("test") && stays, "{line}");
                    assert_eq!(found, triangles);
                }
            }
        }
    });
}

#[test]
fn a_trace_cut_short_is_noticed() {
    for_each_trace(|lines, _| {
        for length in 0..lines.len() {
            let bad = read_and_replay(&lines[..length]).expect_err("lines are missing");
            assert_eq!(bad.line, (length + 1).max(1));
        }
    });
}

#[test]
fn lines_that_change_places_are_noticed_or_commute() {
    for_each_trace(|lines, triangles| {
        for at in 0..lines.len() - 1 {
            let mut damaged = lines.to_vec();
            damaged.swap(at, at + 1);
            let pair = [lines[at], lines[at + 1]];
            if let Ok(found) = read_and_replay(&damaged) {
                let are_all = |starts: &[&str]| {
                    let is_one = |line: &&str| starts.iter().any(|start| line.starts_with(start));
                    pair.iter().all(is_one)
                };
                let commutes = are_all(&["front loses", "triangle"]) || are_all(&["removed"]);
                let has_test = pair.iter().any(|line| line.starts_with("test"));
                assert!(commutes || has_test, "{pair:?}");
                assert_eq!(found, triangles);
            }
        }
    });
}

#[test]
fn an_edited_word_is_noticed_or_a_name() {
    for_each_trace(|lines, triangles| {
        for (at, line) in lines.iter().enumerate() {
            let words: Vec<&str> = line.split(' ').collect();
            for (place, word) in words.iter().enumerate() {
                for other in edits(word) {
                    let mut words: Vec<String> =
                        words.iter().map(|&word| word.to_owned()).collect();
                    words[place] = other;
                    let edited = words.join(" ");
                    let mut damaged = lines.to_vec();
                    damaged[at] = &edited;
                    match read_and_replay(&damaged) {
                        Err(bad) => assert!(bad.line > at, "{line} -> {edited}: {bad}"),
                        Ok(found) => {
                            assert!(line.starts_with("edge") && place == 1, "{line} -> {edited}");
                            assert_eq!(found, triangles);
                        }
                    }
                }
            }
        }
    });
}

/// Other numbers and other words in place of one.
fn edits(word: &str) -> Vec<String> {
    let number = word.trim_end_matches(':');
    let mark = &word[number.len()..];
    if let Ok(number) = number.parse::<i64>() {
        let others = [number - 1, number + 1].map(|n| n.to_string());
        let artificial = ["P-1".to_owned(), "P-2".to_owned()];
        let all = others.into_iter().chain(artificial);
        return all.map(|other| other + mark).collect();
    }
    let groups: [&[&str]; 4] = [
        &["middle", "left"],
        &["legal", "illegal", "fixed"],
        &["P-1", "P-2"],
        &[
            "(point)",
            "(basin)",
            "(first)",
            "(pocket)",
            "(pseudo-polygon)",
        ],
    ];
    let of_group = groups.into_iter().find(|group| group.contains(&word));
    let others = of_group
        .into_iter()
        .flatten()
        .filter(|&&other| other != word);
    others.map(|&other| other.to_owned()).collect()
}

#[test]
fn a_part_of_a_trace_is_read_but_not_replayed() {
    let (_, input) = cases::all()
        .find(|(_, input)| input.points.len() > 5)
        .expect("a case");
    let (whole, _) = trace(&input, Heuristics::FAST);
    let part = Trace {
        skipped: 3,
        events: whole.events[3..6].to_vec(),
    };
    let text = text(&part);
    assert!(
        text.starts_with("sweep-cdt trace 2 from step 4\n"),
        "{text}"
    );
    assert_eq!(Trace::parse(&text).as_ref(), Ok(&part));
    #[cfg(feature = "formats")]
    assert_eq!(Trace::parse(&lines(&part)).as_ref(), Ok(&part));
    assert_eq!(
        part.replay().unwrap_err().to_string(),
        "line 1: the trace lacks its first 3 steps"
    );
}

#[test]
fn what_is_no_trace_is_refused() {
    let cases = [
        ("", "line 1: is not the header `sweep-cdt trace 2`"),
        (
            "sweep-cdt trace 2\n",
            "line 1: is not the header `sweep-cdt trace 2`",
        ),
        ("sweep-cdt trace 2\n", "line 2: the trace ends too early"),
        (
            "sweep-cdt trace 2\nsorted  3\n",
            "line 2: is no step: \"sorted  3\"",
        ),
        (
            "sweep-cdt trace 2\nsorted 0\nsorted 0\n",
            "line 3: vertex 0 is sorted twice",
        ),
        (
            "sweep-cdt trace 2\nsorted -1\n",
            "line 2: is no step: \"sorted -1\"",
        ),
        (
            "sweep-cdt trace 2\nfinalization\nfinished: 0 triangles\nsorted 0\n",
            "line 4: the trace is over",
        ),
        #[cfg(feature = "formats")]
        ("{}\n", "line 1: is not the header of a trace of version 2"),
        #[cfg(feature = "formats")]
        (
            "{\"format\":\"sweep-cdt trace\",\"version\":2}\n{\"event\":\"sorted\",\"vertex\":1,\"x\":0}\n",
            "line 2: is no step: \"{\\\"event\\\":\\\"sorted\\\",\\\"vertex\\\":1,\\\"x\\\":0}\"",
        ),
    ];
    for (text, message) in cases {
        let refused = Trace::parse(text).and_then(|trace| trace.replay());
        assert_eq!(refused.unwrap_err().to_string(), message);
    }
}

#[cfg(feature = "formats")]
#[test]
fn json_lines_are_as_documented() {
    let input = Input::parse("0 0, 2 0, 1 1", "");
    let (trace, _) = trace(&input, Heuristics::FAST);
    let lines = lines(&trace);
    let some = [
        r#"{"format":"sweep-cdt trace","version":2}"#,
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
