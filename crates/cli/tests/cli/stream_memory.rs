//! The memory of `sweep-cdt stream`: `--memory` is a bound, and what a refusal advises is enough.

use std::fmt::Write;
use std::fs;
use std::process::Stdio;

use sweep_cdt_testing::Input;
use tempfile::TempDir;

use crate::stream::{ran, write_raw};
use crate::{folder, printed, sweep_cdt, text, without_losses};

/// What the program takes beside the bound, as its help says.
const PROGRAM: u64 = 48 << 20;

/// The greatest memory of a run, in bytes, and what it says.
fn peak(folder: &TempDir, arguments: &str) -> (u64, String) {
    let mut command = sweep_cdt(folder, arguments);
    let command = command.stdout(Stdio::null()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("the command starts");
    let status = format!("/proc/{}/status", child.id());
    let mut peak = 0;
    while child.try_wait().expect("a child").is_none() {
        // At the end of a process it is not told any more.
        let status = fs::read_to_string(&status).unwrap_or_default();
        let told = status.lines().find_map(|line| {
            let kilobytes = line.strip_prefix("VmHWM:")?.trim().strip_suffix(" kB")?;
            kilobytes.parse::<u64>().ok()
        });
        peak = peak.max(told.unwrap_or(0) << 10);
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    let output = child.wait_with_output().expect("the command ends");
    (peak, text(&output.stderr).to_owned())
}

/// Asserts that a stream takes no more than it may, whether it ends well or too much is alive.
#[track_caller]
fn assert_bounded(folder: &TempDir, arguments: &str, bounds: &[u64]) {
    for bound in bounds {
        let stream = format!("stream {arguments} --temporary . --memory {bound}MiB -o t.u64");
        let (peak, said) = peak(folder, &stream);
        let said = without_losses(said.as_bytes());
        assert!(
            said.is_empty() || said.contains(" vertices are alive"),
            "{said}"
        );
        assert!(peak > 4 << 20, "{stream}: the memory was not told");
        let most = (bound << 20) + PROGRAM;
        assert!(
            peak <= most,
            "{stream}: {peak} bytes, and {most} were allowed"
        );
    }
}

/// Vertices of a lattice in any order, and its edges, whose ends are far apart in the file.
fn lattice(width: usize, height: usize) -> Input {
    let count = width * height;
    // Coprime to the count, so that each number occurs once.
    let number = |at: usize| at * 7919 % count;
    let mut points = vec![[0.0; 2]; count];
    let mut edges = Vec::new();
    for at in 0..count {
        let (x, y) = (at % width, at / width);
        points[number(at)] = [x as f64, y as f64];
        if x + 1 < width {
            edges.push([number(at), number(at + 1)]);
        }
        if y + 1 < height {
            edges.push([number(at), number(at + width)]);
        }
    }
    Input { points, edges }
}

#[test]
#[ignore = "23 seconds: `.ci/nightly` runs it"]
fn memory_is_a_bound_for_points() {
    let folder = folder(&[]);
    let input = Input::generated("uniform", 300_000, 1);
    write_raw(&folder, &input);
    assert_bounded(&folder, "p.f64", &[1, 16, 64]);
    let (mut rows, mut nodes) = (String::new(), "300000 2\n".to_owned());
    for (at, [x, y]) in input.points.iter().enumerate() {
        writeln!(rows, "{x},{y}").expect("room");
        writeln!(nodes, "{at} {x} {y}").expect("room");
    }
    fs::write(folder.path().join("p.csv"), rows).expect("a file");
    fs::write(folder.path().join("p.node"), nodes).expect("a file");
    assert_bounded(&folder, "p.csv", &[1, 16]);
    assert_bounded(&folder, "p.node", &[1, 16]);
    // As many points as a text of its length can have, and lines as long as they may be.
    fs::write(folder.path().join("p.xyz"), "1 2\n".repeat(2_000_000)).expect("a file");
    assert_bounded(&folder, "p.xyz", &[1]);
    let long = format!(
        "x,y,name\n{}",
        format!("1,2,{}\n", "n".repeat(1_900_000)).repeat(20)
    );
    fs::write(folder.path().join("long.csv"), long).expect("a file");
    assert_bounded(&folder, "long.csv", &[1]);
}

#[test]
fn memory_is_a_bound_for_terrain() {
    let folder = folder(&[]);
    let mut rows = "x,y,z\n".to_owned();
    for [x, y] in Input::generated("uniform", 200_000, 1).points {
        writeln!(rows, "{x},{y},{}", (x + y) * 1e3).expect("room");
    }
    fs::write(folder.path().join("p.csv"), rows).expect("a file");
    let terrain = "p.csv --contours a.wkt --every 0.5 --raster a.asc --cell 0.001";
    assert_bounded(&folder, terrain, &[2, 16]);
}

#[cfg(feature = "las")]
#[test]
fn memory_is_a_bound_for_clouds() {
    let count = 300_000_u32;
    // Spread over the plane: multiples of an odd number in two orders of bits.
    let place = |at: u32| at.wrapping_mul(0x9e37_79b1) >> 1;
    let points = (0..count).map(|at| [place(at), (at.reverse_bits() ^ place(at)) >> 1, 0, 0]);
    let bytes = crate::clouds::cloud(points, &[]);
    let folder = folder(&[]);
    fs::write(folder.path().join("p.las"), bytes).expect("a file");
    assert_bounded(&folder, "p.las", &[1, 16]);
}

#[test]
fn memory_is_a_bound_for_edges() {
    let folder = folder(&[]);
    let edges = "p.f64 --edges e.u64";
    write_raw(&folder, &lattice(400, 500));
    assert_bounded(&folder, edges, &[2, 16]);
    // Edges that are open at once, upright and not.
    let count = 100_000;
    let ends = (0..2 * count).map(|at| [(at % count) as f64, (at / count * 9) as f64]);
    let upright = Input {
        points: ends.collect(),
        edges: (0..count).map(|at| [at, at + count]).collect(),
    };
    write_raw(&folder, &upright);
    assert_bounded(&folder, edges, &[2, 16]);
    // Each edge five times.
    let mut segments = Input::generated("segments", 100_000, 1);
    segments.edges = segments.edges.repeat(5);
    write_raw(&folder, &segments);
    assert_bounded(&folder, edges, &[2, 16]);
}

/// All that comes stays alive.
#[test]
fn memory_is_a_bound_for_what_is_alive() {
    let folder = folder(&[]);
    write_raw(&folder, &Input::generated("circle", 300_000, 0));
    assert_bounded(&folder, "p.f64", &[1, 64, 96]);
}

/// The option that the error of a run advises.
fn advised(error: &str) -> Option<&str> {
    let rest = error.split_once("--memory ")?.1;
    rest.split([' ', ')']).next()
}

#[test]
fn memory_that_a_refusal_advises_is_enough() {
    let folder = folder(&[]);
    for (kind, count) in [
        ("segments", 1000),
        ("parcels", 2000),
        ("uniform", 50_000),
        ("circle", 100_000),
    ] {
        write_raw(&folder, &Input::generated(kind, count, 1));
        let mut memory = "1".to_owned();
        let mut refusals = Vec::new();
        loop {
            let stream = format!("stream p.f64 --edges e.u64 --memory {memory} -o t.u64");
            let output = ran(&folder, &stream);
            if output.status.success() {
                assert_eq!(printed(&output), "");
                break;
            }
            let error = text(&output.stderr);
            assert_eq!(output.status.code(), Some(1), "{error}");
            memory = advised(error)
                .unwrap_or_else(|| panic!("{error}"))
                .to_owned();
            refusals.push(
                error
                    .split_once(" (")
                    .map_or(error, |parts| parts.0)
                    .to_owned(),
            );
        }
        // Sorting is refused once. Each time that more was alive, more came before.
        let of_sorting = refusals
            .iter()
            .filter(|said| said.contains("to sort so much"));
        assert_eq!(of_sorting.count(), 1, "{refusals:?}");
        let most = if kind == "circle" { 4 } else { 1 };
        assert!(refusals.len() <= most, "{refusals:?}");
    }
}
