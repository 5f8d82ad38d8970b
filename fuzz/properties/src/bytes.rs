//! Bytes without a fuzzer: random ones, or, every second time, a seed with some changes.

use std::io;
use std::path::Path;

use sweep_cdt_testing::Random;

use crate::seeds;

/// Where the bytes come from.
#[derive(Clone, Debug)]
pub struct Source {
    random: Random,
    seeds: Vec<Vec<u8>>,
}

impl Source {
    /// Bytes by the seeds of a file; another number gives others.
    ///
    /// # Errors
    /// If there is no such file.
    pub fn new(file: &Path, number: u64) -> io::Result<Source> {
        Ok(Source {
            random: Random::new(number),
            seeds: seeds::read(file)?.into_keys().collect(),
        })
    }

    /// The next bytes.
    pub fn more(&mut self) -> Vec<u8> {
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
