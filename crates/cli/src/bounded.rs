//! Triangles that break bounds, in a report and in a record.

use std::io::{self, Write};

use serde::Serialize;
use serde_json::value::RawValue;
use sweep_cdt_edit::Bounds;
use sweep_cdt_engine::{Violator, broken, violators, with_bounds};
use sweep_cdt_formats::{Coordinate, Triangles, json_coordinate};

use crate::shared::failure::Failure;

/// Bounds, and the triangles of a result that break them.
pub(crate) struct Bounded<'a, S> {
    bounds: Bounds,
    pub(crate) violators: Vec<Violator>,
    points: &'a [[S; 2]],
    triangles: &'a Triangles,
    limit: usize,
}

/// Bounds and the triangles that break them, in a record.
#[derive(Serialize)]
pub(crate) struct Record {
    min_angle: Option<f64>,
    max_area: Option<f64>,
    max_side: Option<f64>,
    triangles_out_of_bounds: usize,
    violations_found: usize,
    violations: Vec<Item>,
}

/// A triangle that breaks a bound, numbered as in its file.
#[derive(Serialize)]
struct Item {
    class: &'static str,
    message: String,
    triangle: usize,
    size: f64,
    limit: f64,
    at: [[Box<RawValue>; 2]; 3],
}

impl<'a, S: Coordinate> Bounded<'a, S> {
    /// Finds the triangles that break bounds; `limit` of them are listed.
    pub(crate) fn new(
        bounds: Bounds,
        points: &'a [[S; 2]],
        triangles: &'a Triangles,
        limit: usize,
    ) -> Result<Bounded<'a, S>, Failure> {
        let violators = violators(&bounds, points, &triangles.list);
        Ok(Bounded {
            violators: violators.map_err(|error| Failure::Usage(error.to_string()))?,
            bounds,
            points,
            triangles,
            limit,
        })
    }

    /// A headline with what the bounds add to it.
    pub(crate) fn headline(&self, headline: &str) -> String {
        with_bounds(headline, broken(&self.violators), self.triangles.list.len())
    }

    fn listed(&self) -> impl Iterator<Item = (&Violator, usize, [&[S; 2]; 3])> {
        let listed = self.violators.iter().take(self.limit);
        listed.map(|violator| {
            let corners = self.triangles.list[violator.triangle];
            let number = violator.triangle + self.triangles.first;
            (violator, number, corners.map(|v| &self.points[v]))
        })
    }

    /// Writes the triangles, with the places of their corners.
    pub(crate) fn write(&self, out: &mut impl Write) -> io::Result<()> {
        for (violator, number, corners) in self.listed() {
            writeln!(out, "\n{}: {}", violator.name(), violator.words(number))?;
            let places = corners.map(|[x, y]| format!("({}, {})", x.text(), y.text()));
            writeln!(out, "  {}", places.join(", "))?;
        }
        match self.violators.len().saturating_sub(self.limit) {
            0 => Ok(()),
            more => writeln!(out, "\nand {more} more out of bounds"),
        }
    }

    /// What a record says of it.
    pub(crate) fn record(&self) -> Record {
        let item = |(violator, number, corners): (&Violator, usize, [&[S; 2]; 3])| Item {
            class: violator.name(),
            message: violator.words(number),
            triangle: number,
            size: violator.size,
            limit: violator.limit,
            at: corners.map(|corner| corner.each_ref().map(json_coordinate)),
        };
        Record {
            min_angle: self.bounds.least_angle,
            max_area: self.bounds.greatest_area,
            max_side: self.bounds.greatest_side,
            triangles_out_of_bounds: broken(&self.violators),
            violations_found: self.violators.len(),
            violations: self.listed().map(item).collect(),
        }
    }
}
