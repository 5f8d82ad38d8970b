//! What is wrong with a scalar.

/// What a scalar promises and does not keep.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Nonconformity {
    /// An answer is wrong.
    #[error("{call} is {answer}, but must be {expected}")]
    WrongAnswer {
        /// The function and its arguments, as fractions.
        call: String,
        /// What the scalar answers.
        answer: String,
        /// What it must answer.
        expected: String,
    },
    /// There is no answer: the call panics, as arithmetic does that overflows.
    #[error("{call} panics")]
    Panic {
        /// The function and its arguments, as fractions.
        call: String,
    },
    /// Hardly any of the points that were to be tried have coordinates of this type.
    #[error("too few points can be tried: {tried}")]
    TooFewNumbers {
        /// How many have.
        tried: usize,
    },
}
