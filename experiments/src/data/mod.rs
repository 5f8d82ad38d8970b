//! Inputs by kind, number of points and seed: the same bytes on every platform.
//!
//! Only `+ - * /`, square roots and integers make coordinates: these are rounded alike everywhere, sines and
//! powers are not.

mod contours;
mod edges;
mod points;

use std::io::{self, Write};

use sweep_cdt_testing::{Input, Random};

/// A kind of input.
#[derive(Clone, Copy, Debug)]
pub struct Kind {
    /// Its name, a word.
    pub name: &'static str,
    /// What it is, in a line.
    pub about: &'static str,
    make: fn(n: usize, random: &mut Random) -> Input,
}

impl Kind {
    /// The input of about `n` points, ten at least, for a seed.
    pub fn input(&self, n: usize, seed: u64) -> Input {
        (self.make)(n.max(10), &mut Random::new(seed))
    }

    /// The kind of this name.
    pub fn named(name: &str) -> Option<Kind> {
        KINDS.iter().copied().find(|kind| kind.name == name)
    }
}

/// All kinds: points, points with edges, and inputs made against some structure.
pub const KINDS: &[Kind] = &[
    Kind {
        name: "uniform",
        about: "points anywhere in a square",
        make: points::uniform,
    },
    Kind {
        name: "integers",
        about: "points anywhere with integers below a million as coordinates",
        make: points::integers,
    },
    Kind {
        name: "clusters",
        about: "twenty clusters, the widest 512 times as wide as the narrowest",
        make: points::clusters,
    },
    Kind {
        name: "power-law",
        about: "one cluster whose density falls with a power of the distance",
        make: points::power_law,
    },
    Kind {
        name: "lattice",
        about: "a square lattice, its points in random order",
        make: points::shuffled_lattice,
    },
    Kind {
        name: "lattice-in-order",
        about: "a square lattice, row by row",
        make: points::lattice,
    },
    Kind {
        name: "rows",
        about: "sixteen rows of equal y",
        make: points::rows,
    },
    Kind {
        name: "columns",
        about: "sixteen columns of equal x",
        make: points::columns,
    },
    Kind {
        name: "circle",
        about: "points on a circle",
        make: points::circle,
    },
    Kind {
        name: "parabola-up",
        about: "a parabola open above: left and right in turn",
        make: points::parabola_up,
    },
    Kind {
        name: "parabola-right",
        about: "a parabola open to the right",
        make: points::parabola_right,
    },
    Kind {
        name: "comb",
        about: "long narrow teeth that hang down, with edges along them",
        make: edges::comb,
    },
    Kind {
        name: "fans",
        about: "a hundred edges at each upper end",
        make: edges::fans,
    },
    Kind {
        name: "asterisk",
        about: "edges in all directions through one vertex",
        make: edges::asterisk,
    },
    Kind {
        name: "segments",
        about: "short edges that do not meet",
        make: edges::segments,
    },
    Kind {
        name: "outlines",
        about: "rough closed outlines of 256 vertices, nothing inside",
        make: edges::outlines,
    },
    Kind {
        name: "parcels",
        about: "parcels of land, with the paper's ratio of points to edges",
        make: edges::parcels,
    },
    Kind {
        name: "contours",
        about: "contour lines of a fractal terrain",
        make: contours::contours,
    },
    Kind {
        name: "alternating",
        about: "a row, and above it points near its two ends in turn",
        make: points::alternating,
    },
    Kind {
        name: "above-a-row",
        about: "a row, and points anywhere above it",
        make: points::above_a_row,
    },
    Kind {
        name: "outliers",
        about: "the same in a four-millionth of the width, between two points far away",
        make: points::outliers,
    },
    Kind {
        name: "leftwards",
        about: "half a parabola, each point to the left of all before it",
        make: points::leftwards,
    },
];

/// Writes an input as Triangle's `.poly`: points and edges, numbered from 0, and no holes.
/// Coordinates are the shortest decimals that read as the same doubles.
///
/// # Errors
/// Those of `out`.
pub fn write_poly(input: &Input, out: &mut impl Write) -> io::Result<()> {
    writeln!(out, "{} 2 0 0", input.points.len())?;
    for (i, [x, y]) in input.points.iter().enumerate() {
        writeln!(out, "{i} {x:?} {y:?}")?;
    }
    writeln!(out, "{} 0", input.edges.len())?;
    for (i, [a, b]) in input.edges.iter().enumerate() {
        writeln!(out, "{i} {a} {b}")?;
    }
    writeln!(out, "0")
}
