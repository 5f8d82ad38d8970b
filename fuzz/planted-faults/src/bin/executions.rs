//! Runs one fuzz target on bytes from a fixed seed until it fails: `executions TARGET LIMIT SEEDS [NUMBER]`.
//!
//! Another number in place of 1 gives other bytes, so that a long run can be made in pieces.
//!
//! Prints `found N MESSAGE` if execution `N` failed, or did not end within [`PATIENCE`]; otherwise `none`. The bytes
//! are those of [`Source`]. The bytes that failed are printed
//! to standard error in hexadecimal.

use std::panic;
use std::path::Path;
use std::process::exit;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::time::Duration;
use std::{env, thread};

use sweep_cdt_properties::TARGETS;
use sweep_cdt_properties::bytes::Source;

/// An execution takes milliseconds; one that takes so long has no end, or the machine is very busy.
const PATIENCE: Duration = Duration::from_secs(10);

fn main() {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [name, limit, seeds, number @ ..] = &arguments[..] else {
        panic!("executions TARGET LIMIT SEEDS [NUMBER]");
    };
    let limit: u64 = limit.parse().expect("a number");
    let number = number
        .first()
        .map_or(1, |number| number.parse().expect("a number"));
    let target = TARGETS.iter().find(|target| target.name == name);
    let test = target.expect("a target").test;

    static MESSAGE: Mutex<String> = Mutex::new(String::new());
    panic::set_hook(Box::new(|info| {
        *MESSAGE.lock().expect("no panic here") = info.to_string().replace('\n', " ");
    }));
    static DONE: AtomicU64 = AtomicU64::new(0);
    thread::spawn(|| {
        loop {
            let before = DONE.load(Relaxed);
            thread::sleep(PATIENCE);
            if DONE.load(Relaxed) == before {
                println!("found {} no end", before + 1);
                exit(0);
            }
        }
    });

    let mut source = Source::new(Path::new(seeds), number).expect("a file of seeds");
    for execution in 1..=limit {
        let bytes = source.more();
        if panic::catch_unwind(|| test(&bytes)).is_err() {
            println!("found {execution} {}", MESSAGE.lock().expect("no panic"));
            let hex: String = bytes.iter().map(|byte| format!("{byte:02x}")).collect();
            eprintln!("bytes {hex}");
            exit(0);
        }
        DONE.store(execution, Relaxed);
    }
    println!("none");
    exit(0);
}
