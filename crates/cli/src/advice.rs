//! The last line of a report of `verify`: what was found, and what to do, in the words of the command.

use sweep_cdt::Error;
use sweep_cdt::scalar::Scalar;
use sweep_cdt_engine::{Answer, Question, Setting, Words};
use sweep_cdt_formats::Coordinate;

use crate::shared::arithmetic::Given;
use crate::shared::places::located;

/// The line.
pub(crate) fn advice<S: Coordinate, T: Scalar>(
    given: &Given<'_, S, T>,
    question: &Question<'_, S, T>,
    answer: &Answer,
) -> String {
    let refused = |error: Error| {
        let error = located(given.file, error);
        let name = given.name;
        format!("{name}: {error} (`sweep-cdt crossings` lists edges that cross)")
    };
    let words = Words {
        setting: "option",
        max_depth: "--max-depth",
        settings: &options,
        refused: &refused,
        beside_input: None,
        show: "`--svg wrong.svg` and `--geojson wrong.geojson` show",
    };
    question.sentence(question.advice(answer), &words)
}

/// Settings as options.
fn options(settings: &[Setting]) -> String {
    let option = |setting: &Setting| match setting {
        Setting::Domain(rule) => format!("--domain {rule}"),
        Setting::MaxDepth(depth) => format!("--max-depth {depth:e}"),
        Setting::Level(level) => format!("--level {}", level.name()),
    };
    let options: Vec<String> = settings.iter().map(option).collect();
    format!("`{}`", options.join(" "))
}
