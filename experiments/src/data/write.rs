//! Writes an input as Triangle's `.poly`.

use std::io::{self, Write};

use sweep_cdt_testing::Input;

/// Points and edges, numbered from 0, and no holes. Coordinates are the shortest decimals that read as the
/// same doubles.
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
