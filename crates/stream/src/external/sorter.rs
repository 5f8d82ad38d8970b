//! Records of one kind, sorted outside memory: runs that fill the memory are sorted and written, and then merged.
//!
//! What fits in one run is never written.

use std::path::Path;

use crate::external::error::Error;
use crate::external::in_memory::sort;
use crate::external::memory::Account;
use crate::external::record::Record;
use crate::external::runs::{Merger, Run};
use crate::external::temporary::Temporary;

/// The runs of a sort.
#[derive(Debug)]
pub(crate) struct Runs<R> {
    file: Temporary,
    runs: Vec<Run>,
    scratch: Vec<R>,
    account: Account,
}

impl<R: Record> Runs<R> {
    /// No runs; a file for them is made in this folder when there are.
    pub(crate) fn new(account: Account, folder: &Path) -> Runs<R> {
        Runs {
            account,
            file: Temporary::new(folder),
            runs: Vec::new(),
            scratch: Vec::new(),
        }
    }

    /// Sorts records, writes them as a run and forgets them; `first` is the least number. Refuses more runs than can be
    /// merged.
    pub(crate) fn add(&mut self, records: &mut Vec<R>, first: u64) -> Result<(), Error> {
        if self.runs.len() == self.account.runs::<R>() {
            let memory = self.account.0;
            return Err(Error::TooLittleMemory {
                memory,
                needed: memory,
            });
        }
        self.sort(records)?;
        self.runs.push(Run::write(records, first, &mut self.file)?);
        records.clear();
        Ok(())
    }

    fn sort(&mut self, records: &mut Vec<R>) -> Result<(), Error> {
        let more = records.len().saturating_sub(self.scratch.len());
        reserve(&mut self.scratch, more, records.len())?;
        sort(records, &mut self.scratch);
        Ok(())
    }

    /// All records sorted; `last` are those that are in no run.
    pub(crate) fn finish(mut self, mut last: Vec<R>, first: u64) -> Result<Sorted<R>, Error> {
        if self.runs.is_empty() {
            self.sort(&mut last)?;
            return Ok(Sorted::Memory(last));
        }
        if !last.is_empty() {
            self.add(&mut last, first)?;
        }
        Ok(Sorted::Disk {
            file: self.file,
            runs: self.runs,
        })
    }
}

/// Sorted records.
#[derive(Debug)]
pub(crate) enum Sorted<R> {
    /// One run in memory.
    Memory(Vec<R>),
    /// Runs on disk.
    Disk { file: Temporary, runs: Vec<Run> },
}

impl<R: Record> Sorted<R> {
    /// How many bytes were written.
    pub(crate) fn written(&self) -> u64 {
        match self {
            Sorted::Memory(_) => 0,
            Sorted::Disk { file, .. } => file.written(),
        }
    }

    /// How many runs there are.
    pub(crate) fn runs(&self) -> usize {
        match self {
            Sorted::Memory(_) => 1,
            Sorted::Disk { runs, .. } => runs.len(),
        }
    }

    /// The records in batches.
    pub(crate) fn batches(self, account: Account) -> Batches<R> {
        match self {
            Sorted::Memory(records) => Batches::Memory {
                records,
                at: 0,
                batch: account.batch(),
            },
            Sorted::Disk { file, runs } => Batches::Disk(Merger::new(file, &runs, account)),
        }
    }
}

/// Sorted records that come one batch after the other.
#[derive(Debug)]
pub(crate) enum Batches<R> {
    Memory {
        records: Vec<R>,
        at: usize,
        batch: usize,
    },
    Disk(Merger<R>),
}

impl<R: Record> Batches<R> {
    /// Puts the next records in the place of a batch; none if there are no more.
    pub(crate) fn next(&mut self, batch: &mut Vec<R>) -> Result<(), Error> {
        match self {
            Batches::Disk(merger) => merger.next_batch(batch),
            Batches::Memory {
                records,
                at,
                batch: most,
            } => {
                let end = (*at + *most).min(records.len());
                batch.clear();
                batch.extend_from_slice(&records[*at..end]);
                *at = end;
                Ok(())
            }
        }
    }

    /// How many bytes were read.
    pub(crate) fn read(&self) -> u64 {
        match self {
            Batches::Memory { .. } => 0,
            Batches::Disk(merger) => merger.read(),
        }
    }
}

/// So many records are made room for step by step; the system gives memory only when it is used, so that all of a longer
/// list is asked for at once, and nothing is copied.
const SHORT: usize = 1 << 16;

/// Makes room for more records of a list that will have `most` at most.
pub(crate) fn reserve<R>(records: &mut Vec<R>, more: usize, most: usize) -> Result<(), Error> {
    let length = records.len() + more;
    if length <= records.capacity() {
        return Ok(());
    }
    let wanted = match length {
        ..SHORT => length.max(2 * records.capacity()).min(most.max(length)),
        _ => most.max(length),
    };
    let got = records.try_reserve_exact(wanted - records.len());
    got.map_err(|_| Error::OutOfMemory {
        bytes: (wanted * size_of::<R>()) as u64,
    })
}
