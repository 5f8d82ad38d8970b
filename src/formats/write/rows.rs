//! Long lists of short lines.

use std::io::{self, Write};

use crate::formats::cores;

/// Writes as many rows, each as `row` appends it to a text. The texts of some chunks at a time are made on all
/// cores and then written.
pub(super) fn write(
    out: &mut impl Write,
    count: usize,
    row: impl Fn(usize, &mut Vec<u8>) + Sync + Send,
) -> io::Result<()> {
    const ROWS: usize = 1 << 12;
    const CHUNKS: usize = 64;
    let starts: Vec<usize> = (0..count).step_by(ROWS).collect();
    for starts in starts.chunks(CHUNKS) {
        let texts = cores::map(starts.to_vec(), |start| {
            let mut text = Vec::new();
            (start..count.min(start + ROWS)).for_each(|at| row(at, &mut text));
            text
        });
        texts.iter().try_for_each(|text| out.write_all(text))?;
    }
    Ok(())
}

/// Appends a number.
pub(super) fn number(n: usize, text: &mut Vec<u8>) {
    text.extend_from_slice(itoa::Buffer::new().format(n).as_bytes());
}
