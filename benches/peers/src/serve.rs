//! A crate as a program for `sweep-cdt-judge`: a question in a line of JSON, the answer in a line of JSON.
//!
//! Crates that fill polygons get the points of one polygon after the other, ring after ring, as [`crate::crates`] wants
//! them; the others get all points and edges. A crate that panics ends this process, which the judge calls a crash.

use std::io::{self, Write};

use serde::Deserialize;
use serde_json::json;
use sweep_cdt_testing::Input;

use crate::crates::{Answer, Stopwatch};
use crate::programs::{Crate, locked_version};

#[derive(Deserialize)]
struct Question {
    points: Vec<[f64; 2]>,
    edges: Vec<[usize; 2]>,
    /// For each polygon its rings.
    polygons: Vec<Vec<Vec<usize>>>,
}

/// Answers questions until there are no more.
pub(crate) fn serve(name: &str) -> io::Result<()> {
    let asked = Crate::named(name);
    let program = format!("{name} {}", locked_version(asked.package));
    for line in io::stdin().lines() {
        let question: Question = serde_json::from_str(&line?)?;
        let answer = match answer(asked, question) {
            Ok(triangles) => json!({ "triangles": triangles, "program": program }),
            Err(reason) => json!({ "refused": reason, "program": program }),
        };
        println!("{answer}");
        io::stdout().flush()?;
    }
    Ok(())
}

fn answer(asked: &Crate, question: Question) -> Answer {
    let Question {
        points,
        edges,
        polygons,
    } = question;
    let mut stopwatch = Stopwatch::default();
    if !asked.is_inside {
        return (asked.call)(&Input { points, edges }, &mut stopwatch);
    }
    let mut all = Vec::new();
    for rings in polygons {
        let edges = closed(&rings);
        let numbers = rings.concat();
        let points = numbers.iter().map(|&v| points[v]).collect();
        let triangles = (asked.call)(&Input { points, edges }, &mut stopwatch)?;
        all.extend(triangles.iter().map(|t| t.map(|v| numbers[v])));
    }
    Ok(all)
}

/// The sides of rings whose corners follow each other.
fn closed(rings: &[Vec<usize>]) -> Vec<[usize; 2]> {
    let mut sides = Vec::new();
    for ring in rings {
        let (first, end) = (sides.len(), sides.len() + ring.len());
        sides.extend((first..end).map(|v| [v, if v + 1 < end { v + 1 } else { first }]));
    }
    sides
}
