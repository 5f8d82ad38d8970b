//! Traces as JSON Lines, for programs: a header and then one object a step; see [`crate::trace`].

use std::io::{self, Write};

use serde::{Deserialize, Serialize};

use super::event::Event;
use super::{BadTrace, VERSION};

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

/// Writes a trace whose first `skipped` steps are left out.
pub(super) fn write(skipped: usize, events: &[Event], out: &mut impl Write) -> io::Result<()> {
    let header = Header {
        format: FORMAT.to_owned(),
        version: VERSION,
        from: skipped + 1,
    };
    serde_json::to_writer(&mut *out, &header)?;
    writeln!(out)?;
    for event in events {
        serde_json::to_writer(&mut *out, event)?;
        writeln!(out)?;
    }
    Ok(())
}

/// Reads a trace: how many steps are left out before the first one, and the steps.
pub(super) fn read(text: &str) -> Result<(usize, Vec<Event>), BadTrace> {
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
    Ok((skipped, events))
}
