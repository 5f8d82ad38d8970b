//! The claims of a program, and how it is called, on the command line.

use std::time::Duration;

use sweep_cdt::verify::Level;
use sweep_cdt_testing::judge::{Asked, Claims, Numbers, Special};
use sweep_cdt_testing::names::level;
use sweep_cdt_testing::oracle::Domain;

use crate::process::Program;

/// What the program claims.
#[derive(clap::Args)]
pub(crate) struct ClaimArgs {
    /// What it is asked: points, edges, polygons, lines (polygons with edges and points besides), or operations (points
    /// that are inserted and removed)
    #[arg(long, value_name = "WHAT", default_value = "points")]
    asked: Asked,
    /// What its triangles fill: hull, polygons, even-odd or nonzero [default: polygons for polygons and lines, else
    /// hull]
    #[arg(long, value_name = "DOMAIN")]
    domain: Option<Domain>,
    /// What its triangles promise: tiling, constrained, delaunay or canonical [default: constrained for polygons and
    /// lines, else delaunay]
    #[arg(long, value_name = "LEVEL", value_parser = level)]
    level: Option<Level>,
    /// The coordinates that it takes: integers:BITS, doubles, doubles:LEAST..MOST, single or single:LEAST..MOST; zero
    /// is among them
    #[arg(long, value_name = "NUMBERS", default_value = "doubles")]
    numbers: Numbers,
    /// How many points it is asked at most
    #[arg(long, value_name = "N", default_value_t = 64)]
    most: usize,
    /// What it may refuse: equal-points, flat (all points on a line), points-on-edges, overlapping-edges,
    /// edges-without-length, crossing-edges, touching-rings, flat-rings, overlapping-rings, rings-either-way,
    /// holes, straight-corners
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    refuses: Vec<Special>,
    /// What it is never asked; of the same list. Edges without length, crossing edges, flat and overlapping rings, and
    /// rings that run either way are asked only where --refuses or --answers names them
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    never: Vec<Special>,
    /// What it is asked besides, and must answer; of the same list
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    answers: Vec<Special>,
    /// Some of its triangles may run clockwise and others counter-clockwise
    #[arg(long)]
    mixed: bool,
}

impl ClaimArgs {
    pub(crate) fn claims(&self) -> Claims {
        let claims = Claims::of(self.asked).with_numbers(self.numbers);
        let claims = claims
            .answering(&self.answers)
            .refusing(&self.refuses)
            .without(&self.never);
        Claims {
            domain: self.domain.unwrap_or(claims.domain),
            level: self.level.unwrap_or(claims.level),
            most: self.most.min(64),
            is_mixed: self.mixed,
            ..claims
        }
    }
}

/// How the program is called.
#[derive(clap::Args)]
pub(crate) struct ProgramArgs {
    /// After so many seconds without an answer the program hangs
    #[arg(long, value_name = "SECONDS", default_value_t = 10.0)]
    timeout: f64,
    /// The program, and its arguments
    #[arg(last = true, required = true, value_name = "PROGRAM")]
    program: Vec<String>,
}

impl ProgramArgs {
    pub(crate) fn start(&self) -> Result<Program, String> {
        let timeout =
            Duration::try_from_secs_f64(self.timeout).map_err(|error| error.to_string())?;
        Program::start(&self.program, timeout)
    }
}
