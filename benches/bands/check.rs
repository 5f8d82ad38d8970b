//! The simulation beside runs of the command.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Instant;

use sweep_cdt_testing::Random;

use crate::measure;
use crate::simulate::{Plan, simulate};

const POINTS: u32 = 20_000_000;
const BAND: u64 = 250_000;
const FAN: usize = 8;

/// Cuts, and joins with one process at a time and with two.
pub(crate) fn run(command: &Path) {
    let folder = std::env::temp_dir().join("sweep-cdt-bands-check");
    fs::create_dir(&folder).expect("no such folder yet");
    let mut random = Random::new(1);
    let points = folder.join("points.f64");
    let mut out = BufWriter::new(File::create(&points).expect("a folder to write to"));
    for _ in 0..2 * POINTS {
        out.write_all(&random.unit().to_le_bytes()).expect("room");
    }
    out.into_inner().expect("room");
    let (band, sort) = (
        measure::band(POINTS.into(), BAND),
        measure::sort(20_000_000),
    );
    let disk = measure::disk();
    let bands = folder.join("bands");
    let cut = seconds(|| {
        let size = BAND.to_string();
        let arguments = [
            OsString::from("stream"),
            points.clone().into(),
            "--band".into(),
        ];
        done(
            Command::new(command)
                .args(arguments)
                .arg(size)
                .arg("-o")
                .arg(&bands),
        );
    });
    println!("| workers | | simulated | run | error |\n|---:|---|---:|---:|---:|");
    for workers in [1, 2] {
        let plan = Plan {
            workers,
            fan: FAN,
            sorted_by_one: true,
            disk,
            served: workers,
        };
        let simulated = simulate(&band, sort, plan);
        let runs =
            (0..3).map(|_| seconds(|| join(command, &bands, &folder.join("joined"), workers)));
        let least = runs.fold(f64::INFINITY, f64::min);
        let rows = [
            ("sort and cut", simulated.sort, cut),
            ("bands and joins", simulated.bands + simulated.joins, least),
        ];
        for (what, simulated, run) in rows {
            println!(
                "| {workers} | {what} | {simulated:.2} s | {run:.2} s | {:+.0} % |",
                100.0 * (simulated / run - 1.0)
            );
        }
    }
    fs::remove_dir_all(&folder).expect("what was written");
}

/// Triangulates all bands and joins them level by level, so many processes at once.
fn join(command: &Path, bands: &Path, out: &Path, workers: usize) {
    fs::create_dir(out).expect("no such folder yet");
    let listed = fs::read_dir(bands)
        .expect("bands")
        .map(|entry| entry.expect("a band").path());
    let mut rests: Vec<PathBuf> = listed
        .filter(|path| path.extension().is_some_and(|e| e == "rest"))
        .collect();
    rests.sort();
    let mut fan = 1;
    for level in 0.. {
        let groups: Vec<&[PathBuf]> = rests.chunks(fan).collect();
        let name = |k: usize, kind: &str| out.join(format!("{level}-{k}.{kind}"));
        let next = AtomicUsize::new(0);
        thread::scope(|scope| {
            for _ in 0..workers {
                scope.spawn(|| {
                    while let Some((k, group)) = {
                        let k = next.fetch_add(1, Ordering::Relaxed);
                        groups.get(k).map(|group| (k, group))
                    } {
                        let mut join = Command::new(command);
                        join.arg("join").args(*group).arg("-o").arg(name(k, "u32"));
                        done(join.arg("--rest").arg(name(k, "rest")));
                    }
                });
            }
        });
        let count = groups.len();
        if count == 1 {
            break;
        }
        rests = (0..count).map(|k| name(k, "rest")).collect();
        fan = FAN;
    }
    fs::remove_dir_all(out).expect("what was written");
}

fn done(command: &mut Command) {
    assert!(
        command.status().expect("the command").success(),
        "{command:?}"
    );
}

fn seconds(run: impl FnOnce()) -> f64 {
    let start = Instant::now();
    run();
    start.elapsed().as_secs_f64()
}
