//! Long calls: without the interpreter's lock, on as many threads as asked for, and ended by Ctrl-C.
//!
//! A large call works on a thread of its own, while the calling thread looks for signals. Once one has come, the next
//! report of progress unwinds the work. Where the crate reports none (edges that wait for the complete hull, divide and
//! conquer, bands on several threads, crossings), the call ends when that part is done. A small call works on the calling
//! thread, since making a thread would take longer.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::Duration;

use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::ThreadPoolBuilder;

use crate::errors::{Fault, exception};

/// Calls with fewer points and triangles work on the calling thread.
const SMALL: usize = 20_000;
/// How long the calling thread waits between two looks for signals.
const PAUSE: Duration = Duration::from_millis(50);
/// The most threads that are of use: there are no more bands.
const MOST_THREADS: usize = 256;

/// What unwinds the work when a signal has come.
struct Interrupted;

/// Reports progress, and ends the work if a signal has come.
#[derive(Debug)]
pub(crate) struct Watch {
    is_over: AtomicBool,
    /// The exception of a function of the user.
    exception: Mutex<Option<PyErr>>,
}

impl Watch {
    pub(crate) fn look(&self) {
        if self.is_over.load(Ordering::Relaxed) {
            resume_unwind(Box::new(Interrupted));
        }
    }

    /// Ends the work with an exception of a function of the user.
    pub(crate) fn end(&self, error: PyErr) -> ! {
        *self
            .exception
            .lock()
            .unwrap_or_else(PoisonError::into_inner) = Some(error);
        resume_unwind(Box::new(Interrupted));
    }
}

/// Does work on `size` points and triangles with the interpreter's lock released, in a pool of so many threads.
pub(crate) fn call<T: Send>(
    py: Python<'_>,
    size: usize,
    threads: usize,
    work: impl FnOnce(&Watch) -> Result<T, Fault> + Send,
) -> PyResult<T> {
    let watch = Watch {
        is_over: AtomicBool::new(false),
        exception: Mutex::new(None),
    };
    let work = || {
        if threads == 1 {
            return work(&watch);
        }
        let pool = ThreadPoolBuilder::new().num_threads(threads.min(MOST_THREADS));
        match pool.build() {
            Ok(pool) => pool.install(|| work(&watch)),
            Err(_) => work(&watch),
        }
    };
    let (done, signal) = if size < SMALL {
        (py.detach(|| catch_unwind(AssertUnwindSafe(work))), None)
    } else {
        py.detach(|| watched(&watch, work))
    };
    let exception = watch.exception.into_inner();
    let exception = exception.unwrap_or_else(PoisonError::into_inner);
    if let Some(signal) = signal.or(exception) {
        return Err(signal);
    }
    match done {
        Ok(result) => result.map_err(|fault| fault.raise(py)),
        Err(payload) => Err(internal(py, payload.as_ref())),
    }
}

type Done<T> = Result<T, Box<dyn Any + Send>>;

/// Works on another thread; on this one where none can be made. Returns what came of it, and the exception of a signal.
fn watched<T: Send>(watch: &Watch, work: impl FnOnce() -> T + Send) -> (Done<T>, Option<PyErr>) {
    let waiting = Mutex::new(Some(work));
    let work = &|| {
        let mut waiting = waiting.lock().unwrap_or_else(PoisonError::into_inner);
        let work = waiting.take().expect("the work is done once");
        drop(waiting);
        work()
    };
    thread::scope(|scope| {
        let (sender, receiver) = mpsc::channel::<()>();
        let worker = thread::Builder::new().spawn_scoped(scope, move || {
            // Dropped at the end, however that comes.
            let _sender = sender;
            work()
        });
        let Ok(worker) = worker else {
            return (catch_unwind(AssertUnwindSafe(work)), None);
        };
        let mut signal = None;
        while receiver.recv_timeout(PAUSE) == Err(RecvTimeoutError::Timeout) {
            if signal.is_none()
                && let Err(error) = Python::attach(|py| py.check_signals())
            {
                signal = Some(error);
                watch.is_over.store(true, Ordering::Relaxed);
            }
        }
        (worker.join(), signal)
    })
}

/// The exception for a broken invariant of the crate.
fn internal(py: Python<'_>, payload: &(dyn Any + Send)) -> PyErr {
    let text = payload.downcast_ref::<String>().map(String::as_str);
    let text = text.or_else(|| payload.downcast_ref::<&str>().copied());
    let message = format!("a bug of sweep-cdt: {}", text.unwrap_or("no message"));
    exception(py, "InternalError", message, &PyDict::new(py))
}
