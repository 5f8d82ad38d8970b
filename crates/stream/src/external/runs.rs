//! Sorted runs on disk, and their merging.
//!
//! All runs of a sort stand in one temporary file, one after the other. While they are merged a block of each is in
//! memory. Each block has a mark some records ahead, or at its last record if that is nearer and others follow on disk. The
//! least of the marks is the limit: whatever comes up to it is in memory, and within the marks. So all of that goes to a
//! batch, and is sorted there. A block that is used up is replaced by the next one of its run. Equal places make no
//! difference, since numbers tell the records apart.
//!
//! Cost: a batch is spread over buckets in a cache (`in_memory.rs`), whatever the number of runs. That measured as fast as a
//! merge of ten runs, and faster than one of more. Where the runs follow each other batches are short, and finding them
//! costs more than sorting them. There is a seek for each block.

use crate::external::error::Error;
use crate::external::in_memory::sort_piece;
use crate::external::memory::Account;
use crate::external::record::Record;
use crate::external::temporary::Temporary;

/// The bytes that are written or read at once.
pub(crate) const PIECE: usize = 1 << 18;

/// A run on disk, or what is left of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Run {
    /// Where the next record stands.
    place: u64,
    /// How many records follow.
    pub(crate) left: usize,
    /// The least number of the run.
    pub(crate) first: u64,
}

impl Run {
    /// Appends sorted records to a file.
    pub(crate) fn write<R: Record>(
        records: &[R],
        first: u64,
        file: &mut Temporary,
    ) -> Result<Run, Error> {
        let place = file.written();
        let each = PIECE / R::BYTES;
        let mut bytes = vec![0; each * R::BYTES];
        for piece in records.chunks(each) {
            let bytes = &mut bytes[..piece.len() * R::BYTES];
            for (record, bytes) in piece.iter().zip(bytes.chunks_exact_mut(R::BYTES)) {
                record.write(first, bytes);
            }
            file.append(bytes)?;
        }
        Ok(Run {
            place,
            left: records.len(),
            first,
        })
    }

    /// Reads the next records, up to so many, and appends them to `records`.
    pub(crate) fn read<R: Record>(
        &mut self,
        most: usize,
        file: &mut Temporary,
        bytes: &mut Vec<u8>,
        records: &mut Vec<R>,
    ) -> Result<(), Error> {
        let count = most.min(self.left);
        bytes.resize(count * R::BYTES, 0);
        file.read_at(self.place, bytes)?;
        let pieces = bytes.chunks_exact(R::BYTES);
        records.extend(pieces.map(|bytes| R::read(self.first, bytes)));
        self.place += bytes.len() as u64;
        self.left -= count;
        Ok(())
    }
}

/// A run, and its block in memory.
#[derive(Debug)]
struct Cursor<R> {
    run: Run,
    block: Vec<R>,
    at: usize,
}

/// Runs that are merged.
#[derive(Debug)]
pub(crate) struct Merger<R> {
    file: Temporary,
    cursors: Vec<Cursor<R>>,
    /// How many records a block has, and a batch.
    block: usize,
    batch: usize,
    bytes: Vec<u8>,
    scratch: Vec<R>,
}

impl<R: Record> Merger<R> {
    /// Merges runs, no more than the account allows.
    pub(crate) fn new(file: Temporary, runs: &[Run], account: Account) -> Merger<R> {
        let cursors = runs.iter().map(|&run| Cursor {
            run,
            block: Vec::new(),
            at: 0,
        });
        Merger {
            file,
            cursors: cursors.collect(),
            block: account.block::<R>(runs.len()),
            batch: account.batch(),
            bytes: Vec::new(),
            scratch: Vec::new(),
        }
    }

    /// How many bytes were read of the runs.
    pub(crate) fn read(&self) -> u64 {
        self.file.read()
    }

    /// Puts the next records in the place of a batch; none if there are no more.
    pub(crate) fn next_batch(&mut self, batch: &mut Vec<R>) -> Result<(), Error> {
        batch.clear();
        self.refill()?;
        let most = (self.batch / self.cursors.len().max(1)).max(1);
        let marks = self.cursors.iter().filter_map(|cursor| {
            let block = &cursor.block[cursor.at..];
            match block.get(most - 1) {
                None if cursor.run.left > 0 => block.last(),
                mark => mark,
            }
        });
        let limit = marks.min_by(|a, b| a.compare(b)).copied();
        for cursor in &mut self.cursors {
            let block = &cursor.block[cursor.at..];
            let block = &block[..block.len().min(most)];
            let count = match &limit {
                Some(limit) => block.partition_point(|record| record.compare(limit).is_le()),
                None => block.len(),
            };
            batch.extend_from_slice(&block[..count]);
            cursor.at += count;
        }
        sort_piece(batch, &mut self.scratch);
        Ok(())
    }

    /// Replaces the blocks that are used up, and forgets the runs that are.
    fn refill(&mut self) -> Result<(), Error> {
        for cursor in &mut self.cursors {
            if cursor.at == cursor.block.len() {
                cursor.block.clear();
                cursor.at = 0;
                let Cursor { run, block, .. } = cursor;
                run.read(self.block, &mut self.file, &mut self.bytes, block)?;
            }
        }
        self.cursors.retain(|cursor| !cursor.block.is_empty());
        Ok(())
    }
}
