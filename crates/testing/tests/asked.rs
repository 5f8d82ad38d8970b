//! What is asked: no kind of polygons that a user would name is rare.

use sweep_cdt_testing::Random;
use sweep_cdt_testing::asked::{KINDS, Tally};
use sweep_cdt_testing::generators;
use sweep_cdt_testing::judge::{Asked, Campaign, Claims, Question};

/// So many questions are made.
const QUESTIONS: u64 = 2_000;

/// Prints a table with `--nocapture`, and looks at the kinds from the first one about polygons on.
fn assert_common(name: &str, questions: impl Iterator<Item = Question>) {
    let mut tally = Tally::NONE;
    for question in questions {
        assert!(question.is_sound(), "{question:?}");
        tally.add(&question);
    }
    let counted = || KINDS.iter().map(|(kind, _)| kind).zip(tally.kinds);
    for (kind, count) in counted() {
        println!("{name}: {kind}: {count} of {}", tally.questions);
    }
    for (kind, count) in counted().skip_while(|(kind, _)| **kind != "1 polygon") {
        let is_common = count * 100 >= tally.questions;
        assert!(is_common, "{name}: {kind}: {count} of {}", tally.questions);
    }
}

fn judged(asked: Asked) -> impl Iterator<Item = Question> {
    let campaign = Campaign {
        claims: Claims::of(asked),
        executions: QUESTIONS,
        seed: 1,
        kept: 0,
    };
    (0..QUESTIONS).filter_map(move |execution| campaign.question(execution).1)
}

#[test]
fn of_polygons() {
    assert_common("polygons", judged(Asked::Polygons));
}

#[test]
fn of_polygons_with_lines() {
    assert_common("lines", judged(Asked::Lines));
}

/// The inputs of the fuzz targets, without a fuzzer and without seeds.
#[test]
fn of_random_bytes() {
    let input = |seed| {
        let mut random = Random::new(seed);
        let length = 4 + random.below(197);
        generators::input(&random.bytes(length))
    };
    let inputs = (0..QUESTIONS).map(input);
    assert_common(
        "bytes",
        inputs.map(|input| Question::new(&input.points, &input.edges)),
    );
}
