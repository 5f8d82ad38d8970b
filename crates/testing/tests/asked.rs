//! What is asked: no kind of questions that a user would name is rare.

use sweep_cdt_testing::Random;
use sweep_cdt_testing::asked::{KINDS, Tally};
use sweep_cdt_testing::generators;
use sweep_cdt_testing::judge::{Asked, Campaign, Claims, Question};
use sweep_cdt_testing::suite;

/// So many questions are made.
const QUESTIONS: u64 = 2_000;

/// What programs are not asked unless they claim it.
const REFUSED: [&str; 2] = ["edges that cross", "an edge without length"];
/// What no polygon is.
const FLAT: &str = "all points on a line";

/// Prints a table with `--nocapture`. Of all kinds but those that are never asked there is one question in a hundred.
fn assert_common(name: &str, never: &[&str], questions: impl Iterator<Item = Question>) {
    let mut tally = Tally::NONE;
    for question in questions {
        assert!(question.is_sound(), "{question:?}");
        tally.add(&question);
    }
    let counted = || KINDS.iter().map(|(kind, _)| kind).zip(tally.kinds);
    for (kind, count) in counted() {
        println!("{name}: {kind}: {count} of {}", tally.questions);
    }
    for (kind, count) in counted() {
        let is_right = match never.contains(kind) {
            true => count == 0,
            false => count * 100 >= tally.questions,
        };
        assert!(is_right, "{name}: {kind}: {count} of {}", tally.questions);
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
fn of_edges() {
    assert_common("edges", &REFUSED, judged(Asked::Edges));
}

#[test]
fn of_polygons() {
    let never = [REFUSED[0], REFUSED[1], FLAT];
    assert_common("polygons", &never, judged(Asked::Polygons));
}

#[test]
fn of_polygons_with_lines() {
    let never = [REFUSED[0], REFUSED[1], FLAT];
    assert_common("lines", &never, judged(Asked::Lines));
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
        &[],
        inputs.map(|input| Question::new(&input.points, &input.edges)),
    );
}

#[test]
fn of_the_suite() {
    let cases = suite::own();
    assert_common("suite", &[], cases.into_iter().map(|case| case.question));
}
