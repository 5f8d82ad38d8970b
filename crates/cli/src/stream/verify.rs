//! `sweep-cdt verify --stream`: triangles in a file that is read once, of points that are sorted outside memory.

use sweep_cdt::verify::{Level, StreamReport, StreamVerifier, StreamViolation};
use sweep_cdt_external::SweepOrder;

use super::numbers::Triangles;
use super::{STEP, SortArgs, to_usize};
use crate::shared::failure::Failure;
use crate::shared::files::FileArgument;
use crate::shared::outputs::print;
use crate::shared::resources::Progress;

/// Why there is no verdict, or a bad one.
enum Ended {
    Violation(StreamViolation),
    Failure(Failure),
}

impl From<StreamViolation> for Ended {
    fn from(violation: StreamViolation) -> Ended {
        Ended::Violation(violation)
    }
}

impl From<Failure> for Ended {
    fn from(failure: Failure) -> Ended {
        Ended::Failure(failure)
    }
}

/// Verifies the triangles of `result`, and prints the verdict.
pub(crate) fn verify_stream(
    sort: &SortArgs,
    level: Level,
    input: &FileArgument,
    result: &FileArgument,
) -> Result<(), Failure> {
    let Some(path) = result.path() else {
        let message = "triangles of a stream are read from a file: .u32 or .u64";
        return Err(Failure::Usage(message.to_owned()));
    };
    let triangles = Triangles::open(path)?;
    let order = sort.sorted(input)?;
    match judged(order, triangles, level) {
        Ok(report) => print(|out| {
            use std::io::Write;
            writeln!(out, "points                {:>14}", report.vertices)?;
            writeln!(out, "edges                 {:>14}", report.edges)?;
            writeln!(out, "triangles             {:>14}", report.triangles)?;
            writeln!(out, "sides of the hull     {:>14}", report.hull_sides)?;
            writeln!(out, "vertices kept at most {:>14}", report.most_vertices)?;
            writeln!(out, "sides kept at most    {:>14}", report.most_sides)?;
            writeln!(out, "correct: {}", level.title())
        }),
        Err(Ended::Violation(violation)) => {
            print(|out| {
                use std::io::Write;
                writeln!(out, "wrong: {violation}")
            })?;
            Err(Failure::Wrong)
        }
        Err(Ended::Failure(failure)) => Err(failure),
    }
}

fn judged(
    mut order: SweepOrder,
    mut triangles: Triangles,
    level: Level,
) -> Result<StreamReport, Ended> {
    let mut verifier = StreamVerifier::new().level(level);
    let mut progress = Progress::new("verifying");
    let all = triangles.left();
    let points = order.summary().points;
    let mut first: Option<([f64; 2], u64)> = None;
    let mut next_vertex = |verifier: &mut StreamVerifier<f64>| -> Result<bool, Ended> {
        let vertex = order
            .next_vertex()
            .map_err(|error| Failure::Error(error.to_string()))?;
        let Some(vertex) = vertex else {
            return Ok(false);
        };
        match first {
            Some((place, of)) if place == vertex.point => {
                verifier.duplicate(vertex.number, &vertex.point, of)?;
            }
            _ => {
                verifier.vertex(vertex.number, vertex.point)?;
                first = Some((vertex.point, vertex.number));
                for &(edge, upper) in vertex.upper {
                    verifier.edge(edge, vertex.number, upper)?;
                }
            }
        }
        Ok(true)
    };
    while let Some(corners) = triangles.next()? {
        for corner in corners {
            // A corner that has come and gone, or is no point, is named by the verifier below.
            while corner < points && !verifier.has_vertex(corner) && next_vertex(&mut verifier)? {}
        }
        verifier.triangle(corners, None)?;
        let done = all - triangles.left();
        if done % STEP == 0 {
            progress.show(to_usize(done), to_usize(all));
        }
    }
    while next_vertex(&mut verifier)? {}
    Ok(verifier.finish()?)
}
