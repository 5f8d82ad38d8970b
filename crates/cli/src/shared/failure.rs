//! How a run ends early: why a subcommand fails, messages that a terminal shows and does not obey, and what the run
//! does when it is told to stop.
//!
//! A thread waits for INT, TERM, HUP and QUIT. It prints one `error:` line and lets the signal end the
//! process as it would have done by itself, so that a shell sees why. Signals that were ignored when the
//! process began (HUP under `nohup`) stay ignored. XFSZ, a file beyond the limit of its size, ends no
//! process: the write fails, and the run with it.
//!
//! Unfinished outputs have no names, so a process that ends at any moment leaves none of them behind. While
//! they get their names, the signals wait. Where no thread can be made, or the system does not tell what is
//! ignored (it has no `/proc`), a signal ends the process at once.

use std::io::{self, Write};
use std::path::Path;
use std::sync::{Mutex, MutexGuard, PoisonError};

use sweep_cdt_formats::{ReadError, ReadErrorKind, reason};

/// The words that the process prints, and how it exits.
pub(crate) enum Failure {
    /// The arguments contradict each other, or would have the run overwrite what it must not.
    Usage(String),
    /// The input is wrong, or a file cannot be read or written.
    Error(String),
    /// The verifier found violations; they are printed already.
    Wrong,
    /// The verifier found violations that may be rounding, and that is allowed for; they are printed already.
    Rounded,
}

impl Failure {
    /// A failure to read or write a file.
    pub(crate) fn of_file(path: &Path, error: &io::Error) -> Failure {
        Failure::Error(format!("{}: {}", path.display(), reason(error)))
    }
}

impl From<ReadError> for Failure {
    fn from(error: ReadError) -> Self {
        Failure::Error(format!("{error}{}", way_out(&error)))
    }
}

/// Says something that changes nothing about the files.
pub(crate) fn note(words: std::fmt::Arguments<'_>) {
    // If standard error is closed, it has no reader.
    let _ = writeln!(io::stderr(), "note: {words}");
}

/// The option that helps where a file is not read.
pub(crate) fn way_out(error: &ReadError) -> &'static str {
    match error.kind {
        ReadErrorKind::UnpackedLimit { .. } => " (--unpacked-limit allows more)",
        ReadErrorKind::UnknownColumns => {
            " (or --columns names or numbers those of x, y and perhaps z: `--columns 2,3`)"
        }
        _ => "",
    }
}

/// The text with its control characters escaped. File names may hold any of them but zero.
pub(crate) fn printable(text: &str) -> String {
    escaped(text, char::is_control)
}

/// The text with its control characters but line feeds escaped.
pub(crate) fn printable_lines(text: &str) -> String {
    escaped(text, |character| {
        character != '\n' && character.is_control()
    })
}

fn escaped(text: &str, is_unsafe: impl Fn(char) -> bool) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in text.chars() {
        if is_unsafe(character) {
            escaped.extend(character.escape_default());
        } else {
            escaped.push(character);
        }
    }
    escaped
}

/// Whether an output has replaced a file or is a new one; locked while that happens.
static CHANGED: Mutex<bool> = Mutex::new(false);

fn changed() -> MutexGuard<'static, bool> {
    CHANGED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Does what no signal may divide: it gives outputs their names, and notes when the first one has its own.
pub(crate) fn undivided<T>(give_names: impl FnOnce(&mut bool) -> T) -> T {
    give_names(&mut changed())
}

#[cfg(not(unix))]
pub(crate) fn wait_for_signals() {}

#[cfg(unix)]
pub(crate) use unix::wait_for_signals;

#[cfg(unix)]
mod unix {
    use std::io::{self, Write};
    use std::sync::atomic::AtomicBool;
    use std::sync::{Arc, mpsc};
    use std::{fs, thread};

    use signal_hook::{consts, flag, iterator::Signals, low_level};

    use super::changed;

    /// Begins to wait for signals.
    pub(crate) fn wait_for_signals() {
        // Nobody reads the flag: what counts is that the signal has a handler.
        let _ = flag::register(consts::SIGXFSZ, Arc::<AtomicBool>::default());
        let Some(ignored) = ignored() else { return };
        let heeded = [
            consts::SIGINT,
            consts::SIGTERM,
            consts::SIGHUP,
            consts::SIGQUIT,
        ];
        let heeded = heeded
            .into_iter()
            .filter(|signal| ignored >> (signal - 1) & 1 == 0);
        // The handlers are installed only when the thread that waits for them is there.
        let (send, receive) = mpsc::channel();
        let thread = thread::Builder::new().spawn(|| receive.into_iter().for_each(end_at_first));
        if thread.is_ok()
            && let Ok(signals) = Signals::new(heeded)
        {
            let _ = send.send(signals);
        }
    }

    /// The signals that the process ignored from the beginning, as bits.
    fn ignored() -> Option<u64> {
        let status = fs::read_to_string("/proc/self/status").ok()?;
        let bits = status
            .lines()
            .find_map(|line| line.strip_prefix("SigIgn:"))?;
        u64::from_str_radix(bits.trim(), 16).ok()
    }

    fn end_at_first(mut signals: Signals) {
        let Some(signal) = signals.forever().next() else {
            return;
        };
        // It is kept to the end: nothing gets a name any more.
        let changed = changed();
        let name = low_level::signal_name(signal).unwrap_or("a signal");
        let done = match *changed {
            true => "the outputs are written",
            false => "no file was changed",
        };
        // If standard error is closed, the message has no reader.
        let _ = writeln!(io::stderr(), "error: stopped by {name}; {done}");
        let _ = low_level::emulate_default_handler(signal);
    }
}
