//! The faults of a scalar.

use std::error::Error;
use std::fmt;

/// A promise that a scalar does not keep.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Nonconformity {
    /// An answer is wrong.
    WrongAnswer {
        /// The function and its arguments, as fractions.
        call: String,
        /// The answer of the scalar.
        answer: String,
        /// The right answer.
        expected: String,
    },
    /// There is no answer: the call panics, as arithmetic does that overflows.
    Panic {
        /// The function and its arguments, as fractions.
        call: String,
    },
    /// Hardly any of the points that were to be tried have coordinates of this type.
    TooFewNumbers {
        /// How many have.
        tried: usize,
    },
}

impl fmt::Display for Nonconformity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Nonconformity::WrongAnswer {
                call,
                answer,
                expected,
            } => write!(f, "{call} is {answer}, but must be {expected}"),
            Nonconformity::Panic { call } => write!(f, "{call} panics"),
            Nonconformity::TooFewNumbers { tried } => {
                write!(f, "too few points can be tried: {tried}")
            }
        }
    }
}

impl Error for Nonconformity {}
