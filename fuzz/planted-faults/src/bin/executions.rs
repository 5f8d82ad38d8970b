//! Runs one fuzz target on bytes from a fixed seed until it fails: `executions TARGET LIMIT SEEDS [NUMBER]`.
//!
//! Another number in place of 1 gives other bytes, so that a long run can be made in pieces.
//!
//! Prints `found N MESSAGE` if execution `N` failed, or did not end within [`PATIENCE`]; otherwise `none`. The bytes
//! are random, or, every second time, a seed of the file `SEEDS` with some changes. The bytes that failed are printed
//! to standard error in hexadecimal.

use std::panic;
use std::path::Path;
use std::process::exit;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::time::Duration;
use std::{env, thread};

use sweep_cdt_properties::{TARGETS, seeds};
use sweep_cdt_testing::Random;

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

    let mut source = Source::new(Path::new(seeds), number);
    for execution in 1..=limit {
        let bytes = source.next();
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

/// Where the bytes come from.
struct Source {
    random: Random,
    seeds: Vec<Vec<u8>>,
}

impl Source {
    fn new(seeds: &Path, number: u64) -> Source {
        let seeds = seeds::read(seeds).expect("a file of seeds");
        Source {
            random: Random::new(number),
            seeds: seeds.into_keys().collect(),
        }
    }

    fn next(&mut self) -> Vec<u8> {
        if self.random.one_in(2) {
            let length = 4 + self.random.below(197);
            return self.random.bytes(length);
        }
        let seed = self.random.below(self.seeds.len());
        let mut bytes = self.seeds[seed].clone();
        for _ in 0..=self.random.below(4) {
            self.change(&mut bytes);
        }
        bytes
    }

    /// Changes, removes or adds a byte, or replaces the rest by that of another seed.
    fn change(&mut self, bytes: &mut Vec<u8>) {
        let at = self.random.below(bytes.len() + 1);
        let byte = self.random.byte();
        match self.random.below(5) {
            0 => bytes.insert(at, byte),
            1 => {
                let other = self.random.below(self.seeds.len());
                bytes.truncate(at);
                bytes.extend(self.seeds[other].iter().skip(at));
            }
            kind if at < bytes.len() => match kind {
                2 => drop(bytes.remove(at)),
                3 => bytes[at] = byte,
                _ => bytes[at] ^= 1 << (byte & 7),
            },
            _ => bytes.push(byte),
        }
    }
}
