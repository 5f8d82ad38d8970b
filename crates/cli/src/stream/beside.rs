//! Writing on a thread beside the sweep: while the system takes the bytes, more triangles are made.
//!
//! Cost: memory for a few parts of the output. Where the system gives no thread, this one writes.

use std::io::{self, Write};
use std::mem;
use std::sync::Mutex;
use std::sync::mpsc::{Receiver, Sender, SyncSender, channel, sync_channel};
use std::thread::{Builder, Scope, ScopedJoinHandle};

use crate::shared::outputs::Out;

/// Bytes that are passed on at once.
const PART: usize = 256 << 10;
/// How many parts may wait.
const WAITING: usize = 4;

/// Where a stream is written: the thread holds it while it writes.
pub(super) type Shared<'a, 'w> = Mutex<&'a mut Out<'w>>;

/// Passes what is written on to a thread, part by part.
pub(super) struct Beside<'s, 'a, 'w> {
    out: &'s Shared<'a, 'w>,
    part: Vec<u8>,
    full: SyncSender<Vec<u8>>,
    /// Parts that are written: their memory is used again.
    empty: Receiver<Vec<u8>>,
    thread: Option<ScopedJoinHandle<'s, io::Result<()>>>,
}

impl<'s, 'a, 'w> Beside<'s, 'a, 'w> {
    pub(super) fn new(scope: &'s Scope<'s, '_>, out: &'s Shared<'a, 'w>) -> Self {
        let (full, parts) = sync_channel(WAITING);
        let (written, empty) = channel();
        let write = move || write_parts(out, &parts, &written);
        Beside {
            out,
            part: Vec::with_capacity(PART),
            full,
            empty,
            thread: Builder::new().spawn_scoped(scope, write).ok(),
        }
    }

    /// Waits until all is written.
    pub(super) fn finish(mut self) -> io::Result<()> {
        self.pass_on()?;
        let Beside { full, thread, .. } = self;
        drop(full);
        thread.map_or(Ok(()), joined)
    }

    fn pass_on(&mut self) -> io::Result<()> {
        let next = self.empty.try_recv().unwrap_or_default();
        let part = mem::replace(&mut self.part, next);
        self.part.clear();
        let Err(unsent) = self.full.send(part) else {
            return Ok(());
        };
        match self.thread.take() {
            // The thread has ended before all was written.
            Some(thread) => joined(thread).and(Err(io::ErrorKind::BrokenPipe.into())),
            None => locked(self.out, |out| out.write_all(&unsent.0)),
        }
    }
}

impl Write for Beside<'_, '_, '_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.part.extend_from_slice(bytes);
        if self.part.len() >= PART {
            self.pass_on()?;
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn write_parts(
    out: &Shared<'_, '_>,
    parts: &Receiver<Vec<u8>>,
    written: &Sender<Vec<u8>>,
) -> io::Result<()> {
    locked(out, |out| {
        for part in parts {
            out.write_all(&part)?;
            // Nobody wants the memory at the end.
            let _ = written.send(part);
        }
        Ok(())
    })
}

fn locked(
    out: &Shared<'_, '_>,
    write: impl FnOnce(&mut Out<'_>) -> io::Result<()>,
) -> io::Result<()> {
    let mut out = out
        .lock()
        .map_err(|_| io::Error::other("the thread that writes has panicked"))?;
    write(&mut out)
}

fn joined(thread: ScopedJoinHandle<'_, io::Result<()>>) -> io::Result<()> {
    let ended = thread.join();
    ended.unwrap_or_else(|_| Err(io::Error::other("the thread that writes has panicked")))
}

#[cfg(test)]
mod tests {
    use std::thread::scope;

    use super::*;

    /// Takes so many bytes and then fails.
    struct Disk {
        room: usize,
        bytes: Vec<u8>,
    }

    impl Write for Disk {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            if self.bytes.len() + bytes.len() > self.room {
                return Err(io::ErrorKind::StorageFull.into());
            }
            self.bytes.extend_from_slice(bytes);
            Ok(bytes.len())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    /// Writes numbers beside, and flushes what is buffered then.
    fn write_numbers(disk: &mut Disk, numbers: u32) -> io::Result<()> {
        let mut buffered: Out<'_> = io::BufWriter::new(disk);
        let out = Mutex::new(&mut buffered);
        scope(|scope| {
            let mut beside = Beside::new(scope, &out);
            for number in 0..numbers {
                beside.write_all(&number.to_le_bytes())?;
            }
            beside.finish()
        })?;
        buffered.flush()
    }

    #[test]
    fn all_bytes_arrive_in_order() {
        for numbers in [0, 1, 65_535, 65_536, 65_537, 1_000_000] {
            let mut disk = Disk {
                room: usize::MAX,
                bytes: Vec::new(),
            };
            write_numbers(&mut disk, numbers).unwrap();
            let expected: Vec<u8> = (0..numbers).flat_map(u32::to_le_bytes).collect();
            assert!(disk.bytes == expected, "{numbers}");
        }
    }

    #[test]
    fn a_full_disk_is_an_error_that_nothing_hides() {
        for room in [0, 300_000, 3_999_999] {
            let mut disk = Disk {
                room,
                bytes: Vec::new(),
            };
            let error = write_numbers(&mut disk, 1_000_000).unwrap_err();
            assert_eq!(error.kind(), io::ErrorKind::StorageFull, "{room}");
        }
    }

    #[test]
    fn all_is_written_here_where_there_is_no_thread() {
        let mut disk = Disk {
            room: usize::MAX,
            bytes: Vec::new(),
        };
        let mut buffered: Out<'_> = io::BufWriter::new(&mut disk);
        let out = Mutex::new(&mut buffered);
        let mut beside = Beside {
            out: &out,
            part: Vec::new(),
            // Nobody takes what is passed on.
            full: sync_channel(WAITING).0,
            empty: channel().1,
            thread: None,
        };
        let bytes: Vec<u8> = (0..200_000_u32).flat_map(u32::to_le_bytes).collect();
        for some in bytes.chunks(12) {
            beside.write_all(some).unwrap();
        }
        beside.finish().unwrap();
        buffered.flush().unwrap();
        drop(buffered);
        assert!(disk.bytes == bytes);
    }
}
