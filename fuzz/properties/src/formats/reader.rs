//! What reads bytes.

use sweep_cdt::formats::{InputFormat, ResultFormat, Source};

/// One of the readers.
#[derive(Clone, Copy, Debug)]
pub(super) enum Reader {
    Input(InputFormat),
    Result(ResultFormat),
    Trace,
    Numbers,
}

/// All of them.
pub(super) const READERS: [Reader; 8] = [
    Reader::Input(InputFormat::Node),
    Reader::Input(InputFormat::Poly),
    Reader::Input(InputFormat::Json),
    Reader::Result(ResultFormat::Ele),
    Reader::Result(ResultFormat::Json),
    Reader::Result(ResultFormat::Obj),
    Reader::Trace,
    Reader::Numbers,
];

/// Bytes as a file.
pub(super) fn source(bytes: &[u8]) -> Source {
    Source {
        name: "file".to_owned(),
        bytes: bytes.to_vec(),
    }
}
