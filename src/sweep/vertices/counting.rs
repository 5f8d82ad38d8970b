//! Counting sort by a key of one coordinate: a step of [`super::sort`] (section 3.3; the paper sorts by comparison).
//!
//! Why it is right: no key decreases where the coordinate grows. So points of different keys are in order, and what is
//! left to sort are runs of one key. Cost: O(n) for n points, and up to 44 bytes for each.

use crate::bucket::bucket;
use crate::ids::narrow;
use alloc::vec::Vec;

/// A point: its approximation and its input index.
pub(super) type Key = ([f64; 2], u32);

/// Sites sorted by a key of one coordinate.
#[derive(Debug, Default)]
pub(super) struct CountingSort {
    pub(super) sites: Vec<Key>,
    axis: usize,
    /// The end of each key's range of sites.
    ends: Vec<u32>,
    /// A coordinate `x` has key `(x - low) * factor`.
    low: f64,
    factor: f64,
    keys: Vec<u32>,
}

impl CountingSort {
    /// Takes these sites and sorts them by a key of one coordinate: two to four keys for each site. At most `few` sites
    /// have one key.
    pub(super) fn set(
        &mut self,
        sites: impl ExactSizeIterator<Item = Key> + Clone,
        axis: usize,
        few: usize,
    ) {
        let n = sites.len();
        self.axis = axis;
        self.ends.clear();
        if n <= few {
            (self.low, self.factor) = (0.0, 0.0);
            self.ends.push(narrow(n));
            self.sites.clear();
            self.sites.extend(sites);
            return;
        }
        let keys = 2 * n.next_power_of_two();
        let (low, high) = extremes(sites.clone().map(|site| site.0[axis]));
        (self.low, self.factor) = (low, keys as f64 / (high - low));
        self.ends.resize(keys, 0);
        let key = |site: Key| narrow(key(&site, axis, (self.low, self.factor), keys));
        self.keys.clear();
        self.keys.extend(sites.clone().map(key));
        for &key in &self.keys {
            self.ends[key as usize] += 1;
        }
        begin(&mut self.ends);
        self.sites.resize(n, ([0.0; 2], 0));
        for (site, &key) in sites.zip(&self.keys) {
            let place = &mut self.ends[key as usize];
            self.sites[*place as usize] = site;
            *place += 1;
        }
    }

    /// Sorts each run of one key in which the coordinate does not ascend all the way.
    pub(super) fn sort_runs(&mut self, mut sort: impl FnMut(&mut [Key])) {
        let axis = self.axis;
        let mut at = 1;
        while let Some([a, b]) = self.sites.get(at - 1..=at) {
            if a.0[axis] < b.0[axis] {
                at += 1;
                continue;
            }
            let key = key(b, axis, (self.low, self.factor), self.ends.len());
            let from = if key == 0 { 0 } else { self.ends[key - 1] };
            let to = self.ends[key] as usize;
            sort(&mut self.sites[from as usize..to]);
            at = to + 1;
        }
    }
}

/// The key of a site by one coordinate.
fn key(site: &Key, axis: usize, (low, factor): (f64, f64), keys: usize) -> usize {
    bucket((site.0[axis] - low) * factor, keys)
}

/// Exclusive prefix sum: counts become start offsets. After scattering, each offset is the end of its range.
pub(super) fn begin(counts: &mut [u32]) {
    let mut sum = 0;
    for count in counts {
        sum += *count;
        *count = sum - *count;
    }
}

fn extremes(numbers: impl Iterator<Item = f64>) -> (f64, f64) {
    numbers.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
        (x.min(low), x.max(high))
    })
}
