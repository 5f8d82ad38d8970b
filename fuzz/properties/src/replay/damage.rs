//! Traces with one fault in their text.

use std::mem::discriminant;

use sweep_cdt::trace::Event;
use sweep_cdt_trace::Trace;

use sweep_cdt_testing::Random;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// From a line on, there is nothing.
    Cut,
    Removed,
    Doubled,
    /// Two lines have changed places.
    Swapped,
    Edited,
    /// Two vertices have changed their names everywhere but in the sweep order.
    Renamed,
}

/// A damaged text.
#[derive(Debug)]
pub(super) struct Damage {
    pub(super) kind: Kind,
    /// The lines concerned, the first of them first.
    pub(super) at: [usize; 2],
    pub(super) text: String,
}

impl Damage {
    /// Damages the text of a trace, whose lines are a header and one for each event.
    pub(super) fn new(text: &str, trace: &Trace, random: &mut Random) -> Damage {
        use Kind::{Cut, Doubled, Edited, Removed, Renamed, Swapped};
        let mut lines: Vec<&str> = text.lines().collect();
        let [i, j] = [0, 1].map(|_| any_or_rare(trace, random));
        let near = (i + 1).min(lines.len() - 1);
        let other = if random.one_in(2) { near } else { j };
        let (edited, renamed);
        let kind = random.pick(&[Cut, Removed, Doubled, Swapped, Edited, Renamed]);
        let mut at = [i, i];
        match kind {
            Cut => lines.truncate(i),
            Removed => drop(lines.remove(i)),
            Doubled => lines.insert(other, lines[i]),
            Swapped => lines.swap(i, other),
            Edited => {
                let line = if random.one_in(2) {
                    alike(trace, i, random)
                } else {
                    j
                };
                edited = self::edited(lines[i], lines[line], random);
                lines[i] = &edited;
            }
            Renamed => {
                let sorted = |event: &&Event| matches!(event, Event::Sorted { .. });
                let first = 1 + trace.events.iter().take_while(sorted).count();
                let last = lines.len() - 1;
                if 1 < first && first < last {
                    let names = [0, 1].map(|_| random.below(first - 1));
                    let names = names.map(|v| trace.events[v]);
                    renamed = self::renamed(&lines[first..last], names);
                    for (line, renamed) in lines[first..last].iter_mut().zip(&renamed) {
                        *line = renamed;
                    }
                }
                at = [first, last];
            }
        }
        if matches!(kind, Doubled | Swapped) {
            at = [i.min(other), i.max(other)];
        }
        let mut text = lines.join("\n");
        text.push('\n');
        Damage { kind, at, text }
    }
}

/// Any line; half of the time one of a kind, each of which is as likely.
fn any_or_rare(trace: &Trace, random: &mut Random) -> usize {
    let events = &trace.events;
    if events.is_empty() || random.one_in(2) {
        return random.below(1 + events.len());
    }
    let mut kinds: Vec<(_, Vec<usize>)> = Vec::new();
    for (line, event) in (1..).zip(events) {
        let outcome = match event {
            Event::Test { outcome, .. } => Some(*outcome),
            _ => None,
        };
        let kind = (discriminant(event), outcome);
        match kinds.iter_mut().find(|(other, _)| *other == kind) {
            Some((_, lines)) => lines.push(line),
            None => kinds.push((kind, vec![line])),
        }
    }
    let kind = random.below(kinds.len());
    random.pick(&kinds[kind].1)
}

/// A line with the same sort of event.
fn alike(trace: &Trace, line: usize, random: &mut Random) -> usize {
    let sort = |line: usize| line.checked_sub(1).map(|i| discriminant(&trace.events[i]));
    let lines = 0..=trace.events.len();
    let alike: Vec<usize> = lines.filter(|&i| sort(i) == sort(line)).collect();
    random.pick(&alike)
}

fn is_word(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '-' || c == '/'
}

fn words(line: &str) -> Vec<&str> {
    let words = line.split(|c| !is_word(c));
    words.filter(|word| !word.is_empty()).collect()
}

/// The line with another number or word: one nearby, or one of another line.
fn edited(line: &str, other: &str, random: &mut Random) -> String {
    let (old, new) = (words(line), words(other));
    let at = random.below(old.len());
    let differ = new.len() == old.len() && old[at] != new[at];
    let new = if differ {
        new[at]
    } else {
        new[random.below(new.len())]
    };
    let old = old[at];
    let new = match old.parse::<u32>() {
        Ok(number) => match random.below(4) {
            0 => number.wrapping_sub(1).to_string(),
            1 => number.wrapping_add(1).to_string(),
            2 => random
                .pick(&["P-1", "P-2", "\"P-1\"", "\"P-2\"", "-1", "007"])
                .to_owned(),
            _ => new.to_owned(),
        },
        Err(_) => new.to_owned(),
    };
    let places: Vec<usize> = line.match_indices(old).map(|(at, _)| at).collect();
    let at = random.pick(&places);
    line[..at].to_owned() + &new + &line[at + old.len()..]
}

/// The lines with the names of two vertices exchanged.
fn renamed(lines: &[&str], sorted: [Event; 2]) -> Vec<String> {
    let names = sorted.map(|event| match event {
        Event::Sorted { vertex } => vertex.to_string(),
        _ => unreachable!("vertices are sorted first"),
    });
    let exchanged = |word: &str| match names.iter().position(|name| name == word) {
        Some(at) => names[1 - at].clone(),
        None => word.to_owned(),
    };
    let line = |line: &&str| {
        let pieces = line.split_inclusive(|c| !is_word(c));
        let piece = |piece: &str| {
            let mark = piece.find(|c| !is_word(c)).unwrap_or(piece.len());
            exchanged(&piece[..mark]) + &piece[mark..]
        };
        pieces.map(piece).collect()
    };
    lines.iter().map(line).collect()
}
