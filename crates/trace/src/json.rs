//! Traces as JSON Lines, for programs: a header and then one object a step.
//!
//! The header is `{"format":"sweep-cdt trace","version":3}`; each step is an object whose `event` is the name of the
//! variant of [`Event`](sweep_cdt::trace::Event) in lower case with hyphens, and whose other members are its fields;
//! words are written the same way. Vertices are numbers, or `"P-1"` and `"P-2"`. A part of a trace says at which step it begins: `"from":120`.

use std::io::{self, Write};

use serde::{Deserialize, Serialize};

use crate::bad_trace::{BadTrace, VERSION};
use crate::trace::Trace;

const FORMAT: &str = "sweep-cdt trace";

/// The first line.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Header {
    format: String,
    version: u32,
    /// The first step that follows, if it is not the first one.
    #[serde(default = "first", skip_serializing_if = "is_first")]
    from: usize,
}

fn first() -> usize {
    1
}

fn is_first(step: &usize) -> bool {
    *step == first()
}

/// Writes a trace as JSON Lines.
///
/// ```
/// use sweep_cdt::{Triangulator, Watch};
/// use sweep_cdt_trace::{Trace, read_trace, write_trace};
///
/// let mut trace = Trace::default();
/// let mut push = |event| trace.events.push(event);
/// Triangulator::new().run(&[[0, 0], [3, 0], [0, 2]], &[], Watch::new().events(&mut push))?;
/// let mut lines = Vec::new();
/// write_trace(&trace, &mut lines)?;
/// assert_eq!(read_trace(&String::from_utf8(lines)?)?, trace);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Errors of `out`.
pub fn write_trace(trace: &Trace, mut out: impl Write) -> io::Result<()> {
    let header = Header {
        format: FORMAT.to_owned(),
        version: VERSION,
        from: trace.skipped + 1,
    };
    serde_json::to_writer(&mut out, &header)?;
    writeln!(out)?;
    for event in &trace.events {
        serde_json::to_writer(&mut out, event)?;
        writeln!(out)?;
    }
    Ok(())
}

/// Reads a trace that was written as JSON Lines, or as the text of [`Trace::write_text`].
///
/// # Errors
/// [`BadTrace`] names the first line that is no line of a trace.
pub fn read_trace(text: &str) -> Result<Trace, BadTrace> {
    if !text.starts_with('{') {
        return Trace::parse(text);
    }
    let mut lines = (1..).zip(text.lines());
    let header = lines
        .next()
        .and_then(|(_, line)| serde_json::from_str(line).ok());
    let skipped = match header {
        Some(Header {
            format,
            version: VERSION,
            from: from @ 1..,
        }) if format == FORMAT => from - 1,
        _ => {
            let message = "is not the header of a trace of version 3".to_owned();
            return Err(BadTrace { line: 1, message });
        }
    };
    let step =
        |(number, line)| serde_json::from_str(line).map_err(|_| BadTrace::no_step(number, line));
    let events = lines.map(step).collect::<Result<_, _>>()?;
    Ok(Trace { skipped, events })
}
