//! The record of a verification: the files, the counts and the verdict, as JSON.
//!
//! Equal files give equal bytes: it holds no time, no path and nothing of the machine.

use std::io::{self, Write};
use std::path::Path;

use hmac_sha256::Hash;
use serde::{Serialize, Serializer};
use serde_json::value::RawValue;
use sweep_cdt::verify::{Depth, Depths};
use sweep_cdt_engine::{Answer, Inside, Verdict, counts};
use sweep_cdt_formats::{Coordinate, GraphFile, Source, Triangles, json_coordinate};

use crate::bounded::{self, Bounded};
use crate::shared::verification::{reached, report, violations};

/// A file by name and contents.
#[derive(Serialize)]
pub(crate) struct Fingerprint {
    file: String,
    sha256: String,
}

impl Fingerprint {
    pub(crate) fn of(source: &Source) -> Fingerprint {
        let name = Path::new(&source.name).file_name();
        let digits = Hash::hash(&source.bytes);
        Fingerprint {
            file: name.map_or_else(
                || source.name.clone(),
                |name| name.to_string_lossy().into_owned(),
            ),
            sha256: digits.iter().map(|byte| format!("{byte:02x}")).collect(),
        }
    }
}

/// The input that was verified, and how.
pub(crate) struct Subject<'a, S> {
    pub(crate) input: &'a [Fingerprint],
    pub(crate) result: &'a [Fingerprint],
    pub(crate) scalar: &'static str,
    /// The domain that the triangles must tile.
    pub(crate) domain: Inside,
    /// The level that they must reach.
    pub(crate) level: &'static str,
    pub(crate) steiner: bool,
    pub(crate) max_depth: Option<f64>,
    pub(crate) verdict: Verdict,
    pub(crate) file: &'a GraphFile<S>,
    pub(crate) triangles: &'a Triangles,
    pub(crate) bounds: Option<&'a Bounded<'a, S>>,
}

#[derive(Serialize)]
struct Record<'a> {
    program: &'static str,
    version: &'static str,
    verdict: &'static str,
    /// Whether a correct result is the canonical one.
    canonical: Option<bool>,
    input: &'a [Fingerprint],
    result: &'a [Fingerprint],
    scalar: &'static str,
    domain: String,
    level: &'static str,
    highest_level: &'static str,
    vertices_matched: MatchedBy,
    clockwise: bool,
    steiner: bool,
    max_depth: Option<f64>,
    #[serde(serialize_with = "by_name")]
    counts: [(&'static str, usize); 11],
    signs: Signs,
    violations_found: usize,
    depths: Measured,
    violations: Vec<Item>,
    #[serde(skip_serializing_if = "Option::is_none")]
    bounds: Option<bounded::Record>,
}

/// How the vertices of the result were matched with those of the input.
#[derive(Serialize)]
struct MatchedBy {
    by: &'static str,
    because: &'static str,
    /// None without coordinates.
    greatest_difference: Option<Box<RawValue>>,
}

#[derive(Serialize)]
struct Signs {
    by_filter: u64,
    exact: u64,
}

/// How deep violations are: how many were measured, the greatest, and how many are in each decade.
#[derive(Serialize)]
struct Measured {
    measured: usize,
    greatest: Option<f64>,
    decades: Vec<Decade>,
}

/// From ten to this exponent on.
#[derive(Serialize)]
struct Decade {
    exponent: i32,
    violations: usize,
}

/// A violation, with all things numbered as in their files.
#[derive(Serialize)]
struct Item {
    class: &'static str,
    message: String,
    depth: Option<f64>,
    vertices: Vec<Place>,
    edges: Vec<usize>,
    triangles: Vec<usize>,
}

#[derive(Serialize)]
struct Place {
    vertex: usize,
    at: [Box<RawValue>; 2],
}

/// Writes the record.
pub(crate) fn write<S: Coordinate>(
    subject: &Subject<'_, S>,
    answer: &Answer,
    out: &mut impl Write,
) -> io::Result<()> {
    let report = report(answer);
    let matched = subject.triangles.matched;
    let (list, found) = violations(answer);
    // A violation names things as in the files; the places of its vertices are found by position.
    let file = subject.file;
    let item = |&violation| {
        let numbered = subject.triangles.as_numbered(file, violation);
        let offenders = numbered.offenders();
        let vertices = subject.triangles.vertices_of(&file.graph, violation);
        let place = |v: usize| Place {
            vertex: v + file.numbering.vertex,
            at: file.graph.points[v].each_ref().map(json_coordinate),
        };
        Item {
            class: violation.name(),
            message: numbered.to_string(),
            depth: violation.depth().map(Depth::get),
            vertices: vertices.into_iter().map(place).collect(),
            edges: offenders.edges,
            triangles: offenders.triangles,
        }
    };
    let record = Record {
        program: env!("CARGO_BIN_NAME"),
        version: env!("CARGO_PKG_VERSION"),
        verdict: subject.verdict.name(),
        canonical: answer
            .as_ref()
            .ok()
            .map(sweep_cdt::verify::Report::is_canonical),
        input: subject.input,
        result: subject.result,
        scalar: subject.scalar,
        domain: subject.domain.to_string(),
        level: subject.level,
        highest_level: reached(report),
        vertices_matched: MatchedBy {
            by: matched.by(),
            because: matched.name(),
            greatest_difference: matched.difference().as_ref().map(json_coordinate),
        },
        clockwise: report.clockwise,
        steiner: subject.steiner,
        max_depth: subject.max_depth,
        counts: counts(report),
        signs: Signs {
            by_filter: report.filtered,
            exact: report.exact,
        },
        violations_found: found,
        depths: measured(answer),
        violations: list.iter().map(item).collect(),
        bounds: subject.bounds.map(Bounded::record),
    };
    serde_json::to_writer_pretty(&mut *out, &record)?;
    writeln!(out)
}

fn by_name<S: Serializer>(counts: &[(&str, usize)], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(counts.iter().copied())
}

fn measured(answer: &Answer) -> Measured {
    let none = Depths::default();
    let depths = match answer {
        Ok(_) => &none,
        Err(violations) => &violations.depths,
    };
    let decades = depths.decades.iter();
    let decades = decades.map(|(&exponent, &violations)| Decade {
        exponent,
        violations,
    });
    Measured {
        measured: depths.measured(),
        greatest: depths.greatest.map(Depth::get),
        decades: decades.collect(),
    }
}
