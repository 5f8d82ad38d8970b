//! The simulation beside runs of the command.

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
const BAND: u64 = 1_000_000;
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
    let cut = timed(|| {
        let (size, mut cut) = (BAND.to_string(), Command::new(command));
        cut.arg("stream").arg(&points).args(["--band", &size, "-o"]);
        done(cut.arg(&bands));
    });
    println!("| workers | | simulated | run | error | processor, a worker | error |");
    println!("|---:|---|---:|---:|---:|---:|---:|");
    let row = |workers: usize, what, simulated, [run, processor]: [f64; 2]| {
        let each = processor / workers as f64;
        let [error, of_each] = [run, each].map(|time| 100.0 * (simulated / time - 1.0));
        println!(
            "| {workers} | {what} | {simulated:.2} s | {run:.2} s | {error:+.0} % | {each:.2} s | {of_each:+.0} % |"
        );
    };
    for workers in [1, 2] {
        let plan = Plan {
            workers,
            fan: FAN,
            sorted_by_one: true,
            disk,
            served: workers,
        };
        let simulated = simulate(&band, sort, plan);
        if workers == 1 {
            row(1, "sort and cut", simulated.sort, cut);
        }
        let runs = (0..3).map(|_| timed(|| join(command, &bands, &folder.join("joined"), workers)));
        let runs: Vec<[f64; 2]> = runs.collect();
        let least = [0, 1].map(|i| runs.iter().map(|run| run[i]).fold(f64::INFINITY, f64::min));
        let time = simulated.bands + simulated.joins;
        row(workers, "bands and joins", time, least);
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

/// Seconds of a run, and of the processor in the processes that it starts.
fn timed(run: impl FnOnce()) -> [f64; 2] {
    let (start, before) = (Instant::now(), children());
    run();
    [start.elapsed().as_secs_f64(), children() - before]
}

/// Seconds of the processor that processes took which were started here and have ended; none beside Linux.
fn children() -> f64 {
    let text = fs::read_to_string("/proc/self/stat").unwrap_or_default();
    // Behind the name of the program; hundredths of a second.
    let fields = text
        .rsplit(')')
        .next()
        .unwrap_or_default()
        .split_whitespace();
    let hundredths = fields
        .skip(13)
        .take(2)
        .filter_map(|field| field.parse::<f64>().ok());
    hundredths.sum::<f64>() / 100.0
}
