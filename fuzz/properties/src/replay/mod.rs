//! A trace replays to the triangulation, in either format; a damaged one is refused, or harmless.
//!
//! The replay knows no coordinates, so it cannot agree with the sweep by computing the same. In the text
//! (`damage`) a line is removed, doubled, changed or moved, the end is cut off, or two vertices change their
//! names. The replay must refuse this, at that line or a later one. The exceptions are changes that
//! [`Trace::replay`] says it cannot notice; they leave the triangles the same. The counters of a run agree
//! with its trace (`counts`).

mod counts;
mod damage;

use sweep_cdt::Heuristics;
use sweep_cdt::trace::{Event, Vertex, Why};
use sweep_cdt_trace::Trace;

use counts::judge_counts;
use damage::{Damage, Kind};

use crate::file::File;
use crate::{reached, share};
use sweep_cdt_testing::Random;
use sweep_cdt_testing::Steps;
use sweep_cdt_testing::{Input, generators};
use sweep_cdt_trace::{read_trace, write_trace};

/// The property for the choices and the input that the bytes stand for.
pub fn test(bytes: &[u8]) {
    let (choices, input) = generators::input_with_choices(bytes);
    reached::sample(&input);
    judge(&input, choices, share::is_chosen(bytes, 2));
}

/// A run, its trace as it is written, and how that is damaged if the run has a result.
struct Case {
    heuristics: Heuristics,
    steps: Steps,
    text: String,
    damage: Option<Damage>,
}

impl Case {
    fn new(Input { points, edges }: &Input, choices: u64) -> Case {
        let random = &mut Random::new(choices);
        let settings = [Heuristics::FAST, Heuristics::PAPER, Heuristics::OFF];
        let heuristics = random.pick(&settings);
        let steps = Steps::of(points, edges, heuristics);
        // JSON takes several times as long to read as text.
        let text = random.pick(&[text, text, text, lines])(&steps.trace);
        let damage = steps.result.is_ok();
        let damage = damage.then(|| Damage::new(&text, &steps.trace, random));
        Case {
            heuristics,
            steps,
            text,
            damage,
        }
    }
}

/// The trace as it is written, the damaged one, and where that is damaged.
pub fn files(bytes: &[u8]) -> Vec<File> {
    let (choices, input) = generators::input_with_choices(bytes);
    let Case { text, damage, .. } = Case::new(&input, choices);
    let mut files = vec![("written.txt".to_owned(), text.into_bytes())];
    if let Some(Damage { kind, at, text }) = damage {
        let what = format!("{kind:?}, lines {} and {}\n", at[0] + 1, at[1] + 1);
        files.push(("damage.txt".to_owned(), what.into_bytes()));
        files.push(("damaged.txt".to_owned(), text.into_bytes()));
    }
    files
}

/// Panics unless the trace of this input, all of whose coordinates are finite, replays, and the damaged
/// one that follows from `choices` is refused or harmless. Its text is read again, or its events are counted.
fn judge(input: &Input, choices: u64, is_read: bool) {
    let Case {
        heuristics,
        steps,
        text,
        damage,
    } = Case::new(input, choices);
    let trace = &steps.trace;
    if is_read {
        assert_eq!(read_trace(&text).as_ref(), Ok(trace), "read again (left)");
    }
    match &steps.result {
        Ok(result) => {
            let triangles = result.canonical_triangles();
            assert_eq!(trace.replay().as_ref(), Ok(&triangles), "replayed (left)");
            if !is_read {
                judge_counts(input, heuristics, trace, result);
            }
            if let Some(damage) = damage {
                judge_damaged(&damage, trace, &triangles);
            }
        }
        Err(_) => {
            let line = trace.replay().map_err(|bad| bad.line);
            assert_eq!(line, Err(trace.events.len() + 2), "the trace has no end");
        }
    }
}

fn text(trace: &Trace) -> String {
    let mut text = Vec::new();
    trace.write_text(&mut text).expect("memory takes all");
    String::from_utf8(text).expect("text")
}

fn lines(trace: &Trace) -> String {
    let mut text = Vec::new();
    write_trace(trace, &mut text).expect("memory takes all");
    String::from_utf8(text).expect("text")
}

/// Panics unless this is refused at a line that may be blamed, or harmless.
fn judge_damaged(damage: &Damage, trace: &Trace, triangles: &[[usize; 3]]) {
    let parsed = read_trace(&damage.text);
    let events = parsed.as_ref().map_or(0, |trace| trace.events.len());
    match parsed.clone().and_then(|trace| trace.replay()) {
        Err(bad) => {
            let first = damage.at[0] + 1;
            let last = damage.text.lines().count() + 1;
            let blamed = first..=last.max(first);
            assert!(blamed.contains(&bad.line), "{bad}, but {damage:?}");
        }
        Ok(found) => {
            assert_eq!(found, triangles, "{damage:?}");
            let is_same = parsed.as_ref() == Ok(trace);
            let event = |line: usize| line.checked_sub(1).map(|step| trace.events[step]);
            let is_harmless = match (damage.at.map(event), damage.kind) {
                _ if is_same => true,
                ([Some(a), Some(b)], Kind::Removed | Kind::Swapped) => may_move(a, b),
                ([Some(a), Some(b)], Kind::Doubled) => is_informal(a) || is_informal(b),
                ([Some(a), _], Kind::Edited) => {
                    let edited = parsed.map(|trace| trace.events[damage.at[0] - 1]);
                    let (before, after) = trace.events.split_at(damage.at[0] - 1);
                    let part = after[1..].iter().find_map(end_of_part);
                    edited.is_ok_and(|edited| {
                        let are_repeated = [edited, a].iter().all(|edge| is_repeated(edge, before));
                        may_stand_for(edited, a, part) || are_repeated
                    })
                }
                _ => false,
            };
            assert!(is_harmless, "not noticed in {events} events: {damage:?}");
        }
    }
}

/// Whether this edge equals one of those before, which alone goes on below its first part.
fn is_repeated(event: &Event, before: &[Event]) -> bool {
    let ends = |event: &Event| match *event {
        Event::Edge { upper, lower, .. } => Some([upper, lower]),
        _ => None,
    };
    ends(event).is_some() && before.iter().any(|other| ends(other) == ends(event))
}

fn end_of_part(event: &Event) -> Option<Vertex> {
    match *event {
        Event::Part { to, .. } => Some(to),
        _ => None,
    }
}

/// Whether the replay may not notice that one event stands for the other, where the next part of an edge
/// ends at this vertex.
fn may_stand_for(a: Event, b: Event, part: Option<Vertex>) -> bool {
    use Event::{Edge, Triangle};
    match (a, b) {
        (
            Edge { upper, lower, .. },
            Edge {
                upper: u, lower: l, ..
            },
        ) => upper == u && (lower == l || [lower, l].map(Some).contains(&part)),
        (
            Triangle { vertices, why },
            Triangle {
                vertices: v,
                why: w,
            },
        ) => {
            let is_heuristic = |why| matches!(why, Why::NarrowCorner | Why::Basin);
            vertices == v && is_heuristic(why) && is_heuristic(w)
        }
        _ => false,
    }
}

/// Whether no triangle depends on such an event.
fn is_informal(event: Event) -> bool {
    matches!(event, Event::Test { .. } | Event::Switch { .. })
}

/// Whether the replay may not notice that these have changed places, or that one, given twice, is missing.
fn may_move(a: Event, b: Event) -> bool {
    use Event::{Edge, FrontRemove, Removed, Triangle};
    if a == b {
        return is_informal(a);
    }
    is_informal(a)
        || is_informal(b)
        || matches!(
            (a, b),
            (
                FrontRemove { .. } | Triangle { .. },
                FrontRemove { .. } | Triangle { .. }
            ) | (Removed { .. }, Removed { .. })
                | (Edge { .. }, Edge { .. })
        )
}
