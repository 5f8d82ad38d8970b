//! Runs one fuzz target on bytes from a fixed seed until it fails: `executions TARGET LIMIT SEEDS`.
//!
//! Prints `found N MESSAGE` if execution `N` failed, or hung for [`PATIENCE`]; else `none`. The bytes are
//! random, or, every second time, a file of the folder `SEEDS` with some changes, where there are any.

use std::panic;
use std::path::{Path, PathBuf};
use std::process::exit;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::time::Duration;
use std::{env, fs, thread};

use sweep_cdt_properties::TARGETS;

/// An execution takes a fraction of a millisecond; one that takes so long has no end.
const PATIENCE: Duration = Duration::from_secs(10);

fn main() {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [name, limit, seeds] = &arguments[..] else {
        panic!("executions TARGET LIMIT SEEDS");
    };
    let limit: u64 = limit.parse().expect("a number");
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

    let mut source = Source::new(Path::new(seeds));
    for execution in 1..=limit {
        let bytes = source.next();
        if panic::catch_unwind(|| test(&bytes)).is_err() {
            println!("found {execution} {}", MESSAGE.lock().expect("no panic"));
            exit(0);
        }
        DONE.store(execution, Relaxed);
    }
    println!("none");
    exit(0);
}

/// Where the bytes come from.
struct Source {
    state: u64,
    seeds: Vec<Vec<u8>>,
}

impl Source {
    fn new(folder: &Path) -> Source {
        let mut paths: Vec<PathBuf> = fs::read_dir(folder).map_or(Vec::new(), |entries| {
            entries.flatten().map(|entry| entry.path()).collect()
        });
        paths.sort();
        Source {
            state: 0x853C_49E6_748F_EA9B,
            seeds: paths
                .iter()
                .filter_map(|path| fs::read(path).ok())
                .collect(),
        }
    }

    /// The generator SplitMix64.
    fn random(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (self.state ^ self.state >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ mixed >> 31
    }

    /// Below `limit`.
    fn below(&mut self, limit: usize) -> usize {
        usize::try_from(self.random() >> 32).expect("32 bits") % limit
    }

    fn byte(&mut self) -> u8 {
        self.random().to_le_bytes()[0]
    }

    fn next(&mut self) -> Vec<u8> {
        if self.seeds.is_empty() || self.below(2) == 0 {
            let length = 4 + self.below(197);
            return (0..length).map(|_| self.byte()).collect();
        }
        let seed = self.below(self.seeds.len());
        let mut bytes = self.seeds[seed].clone();
        for _ in 0..=self.below(4) {
            self.change(&mut bytes);
        }
        bytes
    }

    /// Changes, removes or adds a byte, or goes on as another seed does.
    fn change(&mut self, bytes: &mut Vec<u8>) {
        let at = self.below(bytes.len() + 1);
        let byte = self.byte();
        match self.below(5) {
            0 => bytes.insert(at, byte),
            1 => {
                let other = self.below(self.seeds.len());
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
