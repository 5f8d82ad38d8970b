//! The files through which other programs get their inputs: all numbers in 64 bits, little-endian.
//!
//! A data set is the number of its inputs and then, for each, the numbers of points and edges, the
//! coordinates and the ends. An answer is, for each input, the number of triangles and their corners.

use std::fs;
use std::io;
use std::path::Path;

use crate::Input;

/// Writes a data set.
///
/// # Errors
/// If the file cannot be written.
pub fn write_inputs(path: &Path, inputs: &[Input]) -> io::Result<()> {
    let mut bytes = number(inputs.len()).to_vec();
    for input in inputs {
        bytes.extend(number(input.points.len()));
        bytes.extend(number(input.edges.len()));
        bytes.extend(input.points.iter().flatten().flat_map(|c| c.to_le_bytes()));
        bytes.extend(input.edges.iter().flatten().flat_map(|&v| number(v)));
    }
    fs::write(path, bytes)
}

/// Reads a data set.
///
/// # Errors
/// If the file cannot be read.
///
/// # Panics
/// If it is cut off.
pub fn read_inputs(path: &Path) -> io::Result<Vec<Input>> {
    let bytes = fs::read(path)?;
    let mut numbers = bytes.as_chunks().0.iter();
    let mut next = || u64::from_le_bytes(*numbers.next().expect("a whole file"));
    let count = next();
    let input = |_| {
        let [points, edges] = [next(), next()];
        Input {
            points: (0..points)
                .map(|_| [next(), next()].map(f64::from_bits))
                .collect(),
            edges: (0..edges).map(|_| [next(), next()].map(index)).collect(),
        }
    };
    Ok((0..count).map(input).collect())
}

/// Writes an answer.
///
/// # Errors
/// If the file cannot be written.
pub fn write_answer(path: &Path, answer: &[Vec<[usize; 3]>]) -> io::Result<()> {
    let mut bytes = Vec::new();
    for triangles in answer {
        bytes.extend(number(triangles.len()));
        bytes.extend(triangles.iter().flatten().flat_map(|&v| number(v)));
    }
    fs::write(path, bytes)
}

/// Reads the answer to so many inputs.
///
/// # Errors
/// If the file cannot be read.
///
/// # Panics
/// If it is cut off.
pub fn read_answer(path: &Path, inputs: usize) -> io::Result<Vec<Vec<[usize; 3]>>> {
    let bytes = fs::read(path)?;
    let mut numbers = bytes.as_chunks().0.iter();
    let mut next = || index(u64::from_le_bytes(*numbers.next().expect("a whole file")));
    let triangles = |_| (0..next()).map(|_| [next(), next(), next()]).collect();
    Ok((0..inputs).map(triangles).collect())
}

fn number(n: usize) -> [u8; 8] {
    (n as u64).to_le_bytes()
}

fn index(n: u64) -> usize {
    usize::try_from(n).expect("fits in memory")
}
