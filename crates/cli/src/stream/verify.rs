//! `sweep-cdt verify --stream`: triangles in a file that is read once, of points that are sorted outside memory.

use std::io::Write;

use sweep_cdt::verify::Level;
use sweep_cdt_stream::external::{Choice, SweepOrder};
use sweep_cdt_stream::{StreamReport, StreamVerifier, StreamViolation};

use super::numbers::Triangles;
use super::order::{Sorted, is_one_place};
use super::{STEP, SortArgs, to_usize};
use crate::shared::failure::Failure;
use crate::shared::files::{FileArgument, input_names};
use crate::shared::outputs::print;
use crate::shared::resources::Progress;

/// Why there is no verdict, or a bad one.
enum Ended {
    Wrong(Wrong),
    Failure(Failure),
}

/// What is wrong, and the triangle of the file that has shown it, from 0, unless it was the end.
struct Wrong {
    violation: String,
    triangle: Option<u64>,
}

impl From<StreamViolation> for Ended {
    fn from(violation: StreamViolation) -> Ended {
        Ended::Wrong(Wrong {
            violation: violation.to_string(),
            triangle: None,
        })
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
    (inputs, choice): (&[FileArgument], Choice),
    result: &FileArgument,
) -> Result<(), Failure> {
    let Some(path) = result.path() else {
        let message = "triangles of a stream are read from a file: .u32 or .u64";
        return Err(Failure::Usage(message.to_owned()));
    };
    let triangles = Triangles::open(path)?;
    let Sorted { order, .. } = sort.sorted(inputs, choice, |_, _| Ok(()))?;
    let (what, all) = (level.title(), triangles.left());
    let (input, result) = (input_names(inputs), result.input_name());
    match judged(sort, order, triangles, level) {
        Ok(report) => print(|out| {
            writeln!(out, "correct: {result} is {what} of {input}")?;
            writeln!(out)?;
            writeln!(out, "points                {:>14}", report.vertices)?;
            writeln!(out, "edges                 {:>14}", report.edges)?;
            writeln!(out, "triangles             {:>14}", report.triangles)?;
            writeln!(out, "sides of the hull     {:>14}", report.hull_sides)?;
            writeln!(out, "vertices kept at most {:>14}", report.most_vertices)?;
            writeln!(out, "sides kept at most    {:>14}", report.most_sides)
        }),
        Err(Ended::Wrong(Wrong {
            violation,
            triangle,
        })) => {
            print(|out| {
                writeln!(out, "wrong: {result} is not {what} of {input}: {violation}")?;
                match triangle {
                    Some(triangle) => write!(out, "found at triangle {triangle} of {all}")?,
                    None => write!(out, "found behind the last of {all} triangles")?,
                }
                writeln!(out, "; points, edges and triangles are numbered from 0")
            })?;
            Err(Failure::Wrong)
        }
        Err(Ended::Failure(failure)) => Err(failure),
    }
}

fn judged(
    sort: &SortArgs,
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
        let vertex = order.next_vertex();
        let Some(vertex) = vertex.map_err(|error| sort.failure(&error))? else {
            return Ok(false);
        };
        match first {
            Some((place, of)) if is_one_place(place, vertex.point) => {
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
        let done = all - triangles.left();
        let wrong = |violation| Wrong {
            violation,
            triangle: Some(done - 1),
        };
        for corner in corners {
            if corner >= points {
                let violation = format!("point {corner} is named, and there are {points} points");
                return Err(Ended::Wrong(wrong(violation)));
            }
            // A corner that has come and gone is named where all have come.
            while !verifier.has_vertex(corner) && next_vertex(&mut verifier)? {}
        }
        let judged = verifier.triangle(corners, None);
        judged.map_err(|violation| {
            Ended::Wrong(wrong(match violation {
                // All points have come by now.
                StreamViolation::UnknownVertex { vertex } => format!(
                    "vertex {vertex} is named, but triangles went all the way round it before"
                ),
                _ => violation.to_string(),
            }))
        })?;
        if done.is_multiple_of(STEP) {
            progress.show(to_usize(done), to_usize(all));
        }
    }
    while next_vertex(&mut verifier)? {}
    Ok(verifier.finish()?)
}
