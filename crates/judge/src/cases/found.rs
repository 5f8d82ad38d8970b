//! Cases out of the repository's test data: inputs that broke other programs, inputs of public reports, and findings of
//! this crate's fuzz targets.

use std::fs;

use sweep_cdt_formats::{self as formats, Format, Source};
use sweep_cdt_testing::Input;
use sweep_cdt_testing::data::{self, Hard};
use sweep_cdt_testing::generators::input_with_choices;
use sweep_cdt_testing::judge::Question;

use super::OWN;

/// An input of the repository's test data.
pub(super) struct Found {
    pub(super) name: String,
    pub(super) question: Question,
    pub(super) source: String,
    pub(super) licence: String,
}

/// An input that was found has at most so many points.
const FOUND: usize = 24;

/// All of them that are small.
pub(super) fn found() -> Vec<Found> {
    let mut all = Vec::new();
    let is_sized = |question: &Question| question.is_sound() && question.points.len() <= FOUND;
    for hard in Hard::own() {
        let question = Question::new(&hard.input.points, &hard.input.edges);
        if is_sized(&question) {
            all.push(Found {
                name: format!("hard/{}", hard.name),
                question,
                licence: licence(&hard.source),
                source: hard.source,
            });
        }
    }
    let table = data::path("tests/data/reports/README.md");
    let table = fs::read_to_string(table).expect("a readable file");
    for row in table.lines().filter(|row| row.starts_with("| `")) {
        let mut cells = row.split('|').map(str::trim);
        let (Some(names), Some(source)) = (cells.nth(1), cells.next()) else {
            continue;
        };
        for name in names.split(',').map(|name| name.trim().trim_matches('`')) {
            let Some(question) = report(name).filter(is_sized) else {
                continue;
            };
            let name = format!("reports/{name}");
            let licence = format!("data of a public report, {OWN} as far as it is ours");
            all.push(Found {
                name,
                question,
                source: source.to_owned(),
                licence,
            });
        }
    }
    for target in ["replay", "scalars"] {
        for file in data::all_files(&data::path("fuzz/regressions").join(target)) {
            let bytes = fs::read(&file).expect("a readable file");
            let (_, Input { points, edges }) = input_with_choices(&bytes);
            let question = Question::new(&points, &edges);
            let word = file.file_stem().unwrap_or_default().to_string_lossy();
            let name = format!("regressions/{word}");
            let source = format!("fuzz/regressions/{target}/{word}");
            all.extend(is_sized(&question).then(|| Found {
                name,
                question,
                source,
                licence: OWN.to_owned(),
            }));
        }
    }
    all
}

/// The licence that a source names in brackets.
fn licence(source: &str) -> String {
    let inside = source.split(['(', ')']).nth(1);
    match inside {
        Some("BSD-3") => "BSD-3-Clause".to_owned(),
        Some("WTFPL/MIT") => "WTFPL OR MIT".to_owned(),
        Some("Natural Earth, public domain") => "public domain".to_owned(),
        Some("MIT/Apache-2.0") | None => OWN.to_owned(),
        Some(licence) => licence.to_owned(),
    }
}

/// The points and edges of a report, if they are doubles.
fn report(name: &str) -> Option<Question> {
    let format = match name.rsplit_once('.')?.1 {
        "json" => Format::Json,
        "wkt" => Format::Wkt,
        "geojson" => Format::Geojson,
        "poly" => Format::Poly,
        _ => return None,
    };
    let bytes = fs::read(data::path("tests/data/reports").join(name)).ok()?;
    let source = Source::new(name.to_owned(), bytes);
    match formats::read(format, &source, None) {
        Ok(formats::Input::Doubles(file)) => {
            Some(Question::new(&file.graph.points, &file.graph.edges))
        }
        _ => None,
    }
}
