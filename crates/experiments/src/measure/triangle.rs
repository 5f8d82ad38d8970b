//! Shewchuk's program Triangle as a variant, for the paper's table 1, which has it as LS-D&C: on its own mesh and
//! with its own signs, so it compares programs and not algorithms.
//!
//! Triangle runs as a process of its own. Its time is what it prints for the triangulation and the segments, whole
//! milliseconds on the clock, without reading and writing. Of equal diagonals it may choose others than this crate
//! does. So its result is not compared with those of the other variants, but verified.

use std::error::Error;
use std::path::Path;
use std::process::Command;
use std::{fs, io};

use sweep_cdt::Pslg;
use sweep_cdt::verify::verify;
use sweep_cdt_formats::{Format, GraphFile, Source, read_result, write_graph};
use sweep_cdt_testing::Input;

use super::row::{Row, Turn};
use super::variant::Variant;

/// The name of the variant.
pub(crate) const TRIANGLE: &str = "Triangle";

impl Variant {
    /// Triangle, as this program.
    pub(crate) fn triangle(program: &Path) -> Variant {
        let (counted, timed) = (program.to_owned(), program.to_owned());
        Variant::new(
            TRIANGLE,
            move |input, row| count(&counted, input, row),
            move |input| {
                let folder = tempfile::tempdir()?;
                let printed = run(&timed, "-pcNEP", folder.path(), &file(input))?;
                Ok(Turn {
                    clock_ms: milliseconds(&printed)?,
                    ..Turn::default()
                })
            },
        )
    }
}

/// Runs it once and verifies its result.
fn count(program: &Path, input: &Input, row: &mut Row) -> Result<(), Box<dyn Error>> {
    let (folder, file) = (tempfile::tempdir()?, file(input));
    run(program, "-pcNP", folder.path(), &file)?;
    let source = Source::new(TRIANGLE, fs::read(folder.path().join("input.1.ele"))?);
    let triangles = read_result(Format::Ele, &source, None, &file)?;
    let report = verify(&input.points, &input.edges, &triangles.list)?;
    row.triangles = report.triangles;
    Ok(())
}

fn file(input: &Input) -> GraphFile<f64> {
    let graph = Pslg {
        points: input.points.clone(),
        edges: input.edges.clone(),
        ..Pslg::default()
    };
    graph.into()
}

/// Runs the program, and returns its output.
fn run(
    program: &Path,
    options: &str,
    folder: &Path,
    file: &GraphFile<f64>,
) -> Result<String, Box<dyn Error>> {
    let path = folder.join("input.poly");
    let mut out = io::BufWriter::new(fs::File::create(&path)?);
    write_graph(Format::Poly, file, &mut out)?;
    io::Write::flush(&mut out)?;
    let output = Command::new(program).arg(options).arg(&path).output();
    let output = output.map_err(|error| format!("{}: {error}", program.display()))?;
    if !output.status.success() {
        return Err(format!("{}: {}", program.display(), output.status).into());
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

/// The times of the triangulation and of the segments.
fn milliseconds(printed: &str) -> Result<f64, Box<dyn Error>> {
    let of = |what: &str| -> Result<f64, Box<dyn Error>> {
        let line = format!("{what} milliseconds:");
        let number = printed.lines().find_map(|text| text.strip_prefix(&line));
        Ok(number
            .ok_or(format!("no `{line}` of {TRIANGLE}"))?
            .trim()
            .parse()?)
    };
    Ok(of("Delaunay")? + of("Segment")?)
}

#[cfg(test)]
mod tests {
    use super::milliseconds;

    #[test]
    fn times_are_read_from_what_is_printed() {
        let printed = "Opening a.poly.\nDelaunay milliseconds:  27\nRecovering segments.\n\
                       Segment milliseconds:  5\nOutput milliseconds:  9\n";
        assert_eq!(milliseconds(printed).expect("both"), 32.0);
        assert!(milliseconds("Delaunay milliseconds:  27\n").is_err());
    }
}
