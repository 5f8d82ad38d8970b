//! A trace gives the triangulation again, in either format; a damaged one is refused, or no worse for it.
//!
//! The replay knows no coordinates, so it cannot agree with the sweep by computing the same. In one of the
//! texts a line is removed, doubled, changed or moved, or the end is cut off. That must be refused, at
//! that line or a later one; or be a change that [`Trace::replay`] says it cannot notice, and then the
//! triangles are the same.

use sweep_cdt::trace::{Event, Trace};
use sweep_cdt::{HashTable, Heuristics};

use crate::random::Random;
use crate::steps::Steps;
use crate::{Input, generators, reached};

/// The property for the choices and the input that the bytes stand for.
pub fn test(bytes: &[u8]) {
    let (choices, input) = generators::input_with_choices(bytes);
    reached::sample(&input);
    judge(&input, choices);
}

/// Panics unless the trace of this input, all of whose coordinates are finite, replays, and the damaged
/// one that follows from `choices` is refused or harmless.
fn judge(Input { points, edges }: &Input, choices: u64) {
    let random = &mut Random::new(choices);
    let settings = [Heuristics::FAST, Heuristics::PAPER, Heuristics::OFF];
    let steps = Steps::of::<f64, HashTable>(points, edges, random.pick(&settings));
    let trace = &steps.trace;
    let texts = [text(trace), lines(trace)];
    for text in &texts {
        assert_eq!(Trace::parse(text).as_ref(), Ok(trace), "read again (left)");
    }
    match &steps.result {
        Ok(result) => {
            let triangles = result.canonical_triangles();
            assert_eq!(trace.replay().as_ref(), Ok(&triangles), "replayed (left)");
            let text = &texts[random.below(texts.len())];
            Damage::new(text, random).judge(trace, &triangles);
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
    trace.write_lines(&mut text).expect("memory takes all");
    String::from_utf8(text).expect("text")
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// From a line on, there is nothing.
    Cut,
    Removed,
    Doubled,
    /// Two lines have changed places.
    Swapped,
    Edited,
}

/// A damaged text.
#[derive(Debug)]
struct Damage {
    kind: Kind,
    /// The lines concerned, the first of them first.
    at: [usize; 2],
    text: String,
}

impl Damage {
    fn new(text: &str, random: &mut Random) -> Damage {
        use Kind::{Cut, Doubled, Edited, Removed, Swapped};
        let mut lines: Vec<&str> = text.lines().collect();
        let [i, j] = [0, 1].map(|_| random.below(lines.len()));
        let near = (i + 1).min(lines.len() - 1);
        let other = if random.one_in(2) { near } else { j };
        let edited = edited(lines[i], lines[j], random);
        let kind = random.pick(&[Cut, Removed, Doubled, Swapped, Edited]);
        match kind {
            Cut => lines.truncate(i),
            Removed => drop(lines.remove(i)),
            Doubled => lines.insert(other, lines[i]),
            Swapped => lines.swap(i, other),
            Edited => lines[i] = &edited,
        }
        let at = match kind {
            Doubled | Swapped => [i.min(other), i.max(other)],
            Cut | Removed | Edited => [i, i],
        };
        let mut text = lines.join("\n");
        text.push('\n');
        Damage { kind, at, text }
    }

    /// Panics unless this is refused at a line that may be blamed, or harmless.
    fn judge(&self, trace: &Trace, triangles: &[[usize; 3]]) {
        let parsed = Trace::parse(&self.text);
        let events = parsed.as_ref().map_or(0, |trace| trace.events.len());
        match parsed.clone().and_then(|trace| trace.replay()) {
            Err(bad) => {
                let first = self.at[0] + 1;
                let last = self.text.lines().count() + 1;
                let blamed = first..=last.max(first);
                assert!(blamed.contains(&bad.line), "{bad}, but {self:?}");
            }
            Ok(found) => {
                assert_eq!(found, triangles, "{self:?}");
                let is_same = parsed.as_ref() == Ok(trace);
                let event = |line: usize| line.checked_sub(1).map(|step| trace.events[step]);
                let is_harmless = match (self.at.map(event), self.kind) {
                    _ if is_same => true,
                    ([Some(a), Some(b)], Kind::Removed | Kind::Swapped) => may_move(a, b),
                    ([Some(a), Some(b)], Kind::Doubled) => is_informal(a) || is_informal(b),
                    ([Some(a), _], Kind::Edited) => matches!(a, Event::Edge { .. }),
                    _ => false,
                };
                assert!(is_harmless, "not noticed in {events} events: {self:?}");
            }
        }
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

/// The line with another number or word: one nearby, or one of another line.
fn edited(line: &str, other: &str, random: &mut Random) -> String {
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '/';
    let words = |line: &str| -> Vec<String> {
        let words = line.split(|c| !is_word(c));
        words
            .filter(|word| !word.is_empty())
            .map(str::to_owned)
            .collect()
    };
    let (old, new) = (words(line), words(other));
    let [old, new] = [old, new].map(|words| words[random.below(words.len())].clone());
    let new = match old.parse::<u32>() {
        Ok(number) => match random.below(4) {
            0 => number.wrapping_sub(1).to_string(),
            1 => number.wrapping_add(1).to_string(),
            2 => random
                .pick(&["P-1", "P-2", "\"P-1\"", "\"P-2\"", "-1", "007"])
                .to_owned(),
            _ => new,
        },
        Err(_) => new,
    };
    let places: Vec<usize> = line.match_indices(&old).map(|(at, _)| at).collect();
    let at = random.pick(&places);
    line[..at].to_owned() + &new + &line[at + old.len()..]
}
