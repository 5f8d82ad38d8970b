//! A kind of cases, and how they are made.

use std::collections::BTreeSet;

use sweep_cdt_testing::Random;
use sweep_cdt_testing::judge::{Question, Special};

use super::inputs::MOST;

/// A kind of cases.
pub(super) struct Kind {
    pub(super) name: &'static str,
    pub(super) about: &'static str,
    pub(super) count: usize,
    pub(super) make: fn(&mut Random) -> Question,
    pub(super) must: &'static [Special],
    pub(super) must_not: &'static [Special],
}

/// The kinds that need more points than [`MOST`].
const LARGE: [&str; 5] = [
    "many-holes",
    "four-holes",
    "five-holes",
    "six-to-nine-holes",
    "deep-nests",
];

/// The first inputs of a kind that are as it says, each once.
pub(super) fn made(kind: &Kind) -> Vec<Question> {
    let mut questions = Vec::new();
    let mut seen = BTreeSet::new();
    let start = kind
        .name
        .bytes()
        .fold(7, |hash: u64, byte| hash.wrapping_mul(31) + u64::from(byte));
    for seed in (start..).take(200 * kind.count) {
        let mut question = (kind.make)(&mut Random::new(seed));
        if !kind.must.contains(&Special::EdgesWithoutLength) {
            // Many programs do not take these: they are a kind of their own.
            let points = &question.points;
            let has_length = |&[a, b]: &[usize; 2]| !points[a].iter().eq(&points[b]);
            question.edges.retain(has_length);
        }
        if questions.len() == kind.count {
            break;
        }
        let is_sized = (question.points.len() <= MOST || LARGE.contains(&kind.name))
            && (kind.name == "few-points" || question.points.len() > 2);
        if !is_sized || !question.is_sound() || !seen.insert(format!("{question:?}")) {
            continue;
        }
        let specials = question.specials();
        let has = |special: &Special| specials.contains(special);
        if kind.must.iter().all(has) && !kind.must_not.iter().any(has) {
            questions.push(question);
        }
    }
    questions
}
