//! The input that the bytes of a finding stand for, as files to look at.
//!
//! Points and edges become a row for the table of cases, JSON for the command, the steps of their sweep and a
//! picture: of the triangles, of the edges that cross, or, where the sweep panics or does not end, of the input
//! alone. The steps are then those up to there. What else a target reads out of its bytes (a damaged trace, a file,
//! a result to verify, changes of a front) it turns into [`File`]s itself.
//!
//! A finding may be a panic or an endless loop in the very code that is called here, so all of it runs in threads
//! that are waited for some seconds.

use std::any::Any;
use std::path::Path;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;
use std::{fs, io, thread};

use sweep_cdt::crossings::crossings;
use sweep_cdt::trace::Event;
use sweep_cdt::{Algorithm, Error, Pslg, Triangulation, Triangulator, Watch};
use sweep_cdt_draw::{CrossingsPicture, ResultPicture};
use sweep_cdt_testing::Input;
use sweep_cdt_testing::judge::quietly;
use sweep_cdt_trace::Trace;

use crate::file::{File, json};

/// An answer is waited for so long.
const PATIENCE: Duration = Duration::from_secs(10);
/// So many steps are written at most.
const STEPS: usize = 100_000;

/// Writes what the bytes stand for into the folder.
///
/// # Errors
/// If the folder cannot be written.
pub fn show(
    input: Option<Input>,
    files: fn(&[u8]) -> Vec<File>,
    bytes: &[u8],
    folder: &Path,
) -> io::Result<()> {
    fs::create_dir_all(folder)?;
    let row = match input {
        Some(input) => {
            show_input(&input, folder)?;
            input.to_string()
        }
        None => format!("{bytes:?}"),
    };
    fs::write(folder.join("row.txt"), row + "\n")?;
    let bytes = bytes.to_vec();
    match within(PATIENCE, move || files(&bytes)) {
        Ok(files) => write(folder, files),
        Err(why) => fs::write(folder.join("files.txt"), format!("none: {why}\n")),
    }
}

fn write(folder: &Path, files: Vec<File>) -> io::Result<()> {
    let mut files = files.into_iter();
    files.try_for_each(|(name, content)| fs::write(folder.join(name), content))
}

fn show_input(input: &Input, folder: &Path) -> io::Result<()> {
    let Input { points, edges } = input;
    // Other numbers are none in JSON, and have no place in a picture.
    let is_finite = points.as_flattened().iter().all(|x| x.is_finite());
    if is_finite {
        fs::write(folder.join("input.json"), json(points, edges))?;
    }
    let (events, result) = swept(input);
    let outcome = match &result {
        Ok(Ok(result)) => format!("{} triangles", result.triangles().count()),
        Ok(Err(error)) => format!("error: {error}"),
        Err(why) => why.clone(),
    };
    fs::write(folder.join("outcome.txt"), outcome + "\n")?;
    let mut trace = Vec::new();
    Trace { skipped: 0, events }.write_text(&mut trace)?;
    fs::write(folder.join("trace.txt"), trace)?;
    let picture = is_finite.then(|| picture(input, result.ok())).flatten();
    picture.map_or(Ok(()), |picture| {
        fs::write(folder.join("picture.svg"), picture)
    })
}

/// The steps of the sweep as far as it comes, and its result.
fn swept(input: &Input) -> (Vec<Event>, Result<Result<Triangulation, Error>, String>) {
    let events = Arc::new(Mutex::new(Vec::new()));
    let (input, seen) = (input.clone(), Arc::clone(&events));
    let result = within(PATIENCE, move || {
        let mut observer = |event| {
            let mut seen = seen.lock().unwrap_or_else(PoisonError::into_inner);
            if seen.len() < STEPS {
                seen.push(event);
            }
        };
        let watch = Watch::new().events(&mut observer);
        let triangulator = Triangulator::new().algorithm(Algorithm::Paper);
        triangulator.run(&input.points, &input.edges, watch)
    });
    let seen = events.lock().unwrap_or_else(PoisonError::into_inner);
    (seen.clone(), result)
}

/// Triangles, crossings, or points and edges alone.
fn picture(input: &Input, result: Option<Result<Triangulation, Error>>) -> Option<Vec<u8>> {
    let mut graph = Pslg {
        points: input.points.clone(),
        edges: input.edges.clone(),
        ..Pslg::default()
    };
    let n = graph.points.len();
    graph.edges.retain(|edge| edge.iter().all(|&v| v < n));
    let plain = graph.clone();
    let drawn = within(PATIENCE, move || {
        let mut picture = Vec::new();
        match result {
            Some(Ok(result)) => ResultPicture::new(&graph, &result).write(&mut picture),
            _ => {
                let found = crossings(&graph.points, &graph.edges).unwrap_or_default();
                CrossingsPicture::new(&graph, &found).write(&mut picture)
            }
        }
        .map(|()| picture)
    });
    let plain = move || {
        let mut picture = Vec::new();
        CrossingsPicture::new(&plain, &[]).write(&mut picture)?;
        Ok(picture)
    };
    let drawn: io::Result<Vec<u8>> = drawn.or_else(|_| within(PATIENCE, plain)).ok()?;
    drawn.ok()
}

/// The result of a function, or why there is none: it panics, or is not done in time. It then goes on until the
/// process ends.
fn within<T: Send + 'static>(
    patience: Duration,
    call: impl FnOnce() -> T + Send + 'static,
) -> Result<T, String> {
    let (done, waits) = channel();
    // In a fuzz target a panic that is heard ends the process.
    let worker = thread::spawn(move || done.send(quietly(call)));
    match waits.recv_timeout(patience) {
        Ok(value) => Ok(value),
        Err(RecvTimeoutError::Timeout) => Err(format!("had not ended after {patience:?}")),
        Err(RecvTimeoutError::Disconnected) => {
            let panic = worker.join().err();
            Err(format!(
                "panicked: {}",
                panic.as_deref().map_or("", message)
            ))
        }
    }
}

fn message(panic: &(dyn Any + Send)) -> &str {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    text.or_else(|| panic.downcast_ref::<&str>().copied())
        .unwrap_or("no message")
}

#[test]
fn what_panics_or_does_not_end_is_told() {
    let panics = within(PATIENCE, || -> u8 { panic!("a {}", "message") });
    assert_eq!(panics, Err("panicked: a message".to_owned()));
    let endless = within(Duration::from_millis(20), || {
        loop {
            thread::park();
        }
    });
    assert_eq!(
        endless.map(|()| 0),
        Err("had not ended after 20ms".to_owned())
    );
    assert_eq!(within(PATIENCE, || 1), Ok(1));
}
