//! The data that the script of the page reads.
//!
//! A step is a list of whole numbers: which heading, which sentence, the numbers in that sentence, and the changes of
//! the picture, each as its kind and the numbers that this kind takes. So a step takes some 40 bytes, and the script
//! needs to know neither events nor their words.

use std::collections::HashMap;

use serde::Serialize;

use super::change::{KINDS, changes};
use super::choice::sorted;
use super::sections::{SECTIONS, Section, section_of};
use super::story::{heading, sentence};
use super::style::{STYLES, Style};
use crate::style::PAGE_COLOURS;
use sweep_cdt::trace::Event;

/// All of it.
#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Data {
    /// The number of the first step on the page, how many steps the run has, and the one that is shown at first.
    pub(super) first: usize,
    pub(super) total: usize,
    pub(super) start: usize,
    /// Notes for the reader of this page.
    pub(super) notices: Vec<String>,
    /// Why the run ended before its end.
    pub(super) refused: Option<String>,
    /// Width and height of the points' bounding box; its longer side is 1.
    pub(super) size: [f64; 2],
    /// About the distance of neighbours.
    pub(super) spacing: f64,
    /// The points, from the lower left corner of the bounding box, and the edges; which of the input's they are, if
    /// they are not all of them; and how many the input has.
    pub(super) points: Vec<[f64; 2]>,
    pub(super) edges: Vec<[usize; 2]>,
    pub(super) point_numbers: Option<Vec<usize>>,
    pub(super) edge_numbers: Option<Vec<usize>>,
    pub(super) counts: [usize; 2],
    pub(super) styles: &'static [Style],
    /// Names of colours, on light paper and on dark paper.
    pub(super) colours: &'static [(&'static str, &'static str, &'static str)],
    pub(super) sections: &'static [Section],
    /// The names of changes, and how many numbers each takes.
    pub(super) kinds: &'static [(&'static str, usize)],
    /// How many tests and flips come before the first step, and how many triangles there are then.
    pub(super) counted: [usize; 3],
    /// The changes that lead from an empty scene to the one before the first step.
    pub(super) base: Vec<i64>,
    #[serde(flatten)]
    pub(super) steps: Steps,
}

impl Data {
    /// The data that do not depend on the input.
    pub(super) fn new() -> Data {
        Data {
            first: 1,
            total: 0,
            start: 0,
            notices: Vec::new(),
            refused: None,
            size: [0.0; 2],
            spacing: 1.0,
            points: Vec::new(),
            edges: Vec::new(),
            point_numbers: None,
            edge_numbers: None,
            counts: [0; 2],
            styles: &STYLES,
            colours: &PAGE_COLOURS,
            sections: &SECTIONS,
            kinds: &KINDS,
            counted: [0; 3],
            base: Vec::new(),
            steps: Steps::default(),
        }
    }
}

/// The steps, and the words that they share.
#[derive(Debug, Default, Serialize)]
pub(super) struct Steps {
    /// Each heading with the position of its section.
    headings: Vec<(&'static str, usize)>,
    /// Sentences with `#` in place of each number.
    sentences: Vec<String>,
    /// The vertices of the first steps, as far as these are those of the sorting. They share the first heading and the
    /// first sentence.
    sorted: Vec<usize>,
    /// The others.
    steps: Vec<Vec<i64>>,
    #[serde(skip)]
    heading_at: HashMap<&'static str, i64>,
    #[serde(skip)]
    sentence_at: HashMap<String, i64>,
}

impl Steps {
    /// The steps of some events that follow one another.
    pub(super) fn new(events: &[Event]) -> Steps {
        let mut steps = Steps::default();
        for event in events {
            match sorted(event) {
                Some(vertex) if steps.steps.is_empty() => {
                    if steps.sorted.is_empty() {
                        steps.encode(event);
                    }
                    steps.sorted.push(vertex);
                }
                _ => {
                    let step = steps.encode(event);
                    steps.steps.push(step);
                }
            }
        }
        steps
    }

    fn encode(&mut self, event: &Event) -> Vec<i64> {
        let (heading, (sentence, numbers)) = (heading(event), template(&sentence(event)));
        let next = self.heading_at.len();
        let at = self.heading_at.entry(heading).or_insert_with(|| {
            self.headings.push((heading, section_of(event)));
            number(next)
        });
        let mut step = vec![*at];
        let next = self.sentence_at.len();
        let at = self
            .sentence_at
            .entry(sentence)
            .or_insert_with_key(|sentence| {
                self.sentences.push(sentence.clone());
                number(next)
            });
        step.push(*at);
        step.extend(numbers);
        changes(event)
            .iter()
            .for_each(|change| change.encode(&mut step));
        step
    }
}

fn number(count: usize) -> i64 {
    i64::try_from(count).expect("a short list")
}

/// A sentence with `#` for each of its numbers, and these numbers. No sentence has a `#` of its own.
fn template(sentence: &str) -> (String, Vec<i64>) {
    let (mut words, mut numbers) = (String::new(), Vec::new());
    let mut rest = sentence;
    while let Some(at) = rest.find(|c: char| c.is_ascii_digit()) {
        let (before, from) = rest.split_at(at);
        let end = from.find(|c: char| !c.is_ascii_digit());
        let (digits, after) = from.split_at(end.unwrap_or(from.len()));
        words += before;
        words.push('#');
        numbers.extend(digits.parse::<i64>());
        rest = after;
    }
    (words + rest, numbers)
}

/// About the bytes that an event takes on the page.
pub(super) fn cost(event: &Event) -> usize {
    let length = |number: &i64| number.to_string().len() + 1;
    if let Some(vertex) = sorted(event) {
        return length(&number(vertex));
    }
    let (_, mut numbers) = template(&sentence(event));
    changes(event)
        .iter()
        .for_each(|change| change.encode(&mut numbers));
    // Two brackets, and two digits and a comma for each of heading and sentence.
    numbers.iter().map(length).sum::<usize>() + 8
}

#[cfg(test)]
mod tests {
    use super::{Steps, cost, template};
    use sweep_cdt::trace::{Event, Outcome, Vertex};

    #[test]
    fn sentences_without_their_numbers() {
        let found = template("The side 12–P-1 of 305.");
        assert_eq!(found, ("The side #–P-# of #.".to_owned(), vec![12, 1, 305]));
        assert_eq!(template("None."), ("None.".to_owned(), vec![]));
    }

    #[test]
    fn the_cost_is_what_is_written() {
        let [a, b, p, q] = [7, 123, 4567, 89].map(Vertex::Input);
        let test = Event::Test {
            side: [a, b],
            opposite: [p, q],
            outcome: Outcome::Illegal,
        };
        for event in [test, Event::Finalization, Event::FrontRemove { vertex: b }] {
            let steps = Steps::new(&[event]);
            let bytes = serde_json::to_string(&steps.steps).expect("JSON").len();
            assert!((bytes..bytes + 4).contains(&cost(&event)), "{event}");
        }
    }
}
