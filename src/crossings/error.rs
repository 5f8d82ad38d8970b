//! Why edges that cross are not listed, or not split.

use core::fmt;

use crate::error::Error;

/// Why edges that cross are not listed, or not split. Every error names the offenders by the caller's own indices.
///
/// ```
/// use sweep_cdt::Error;
/// use sweep_cdt::crossings::{SplitError, split};
///
/// let error = split(&[[0.0, f64::NAN]], &[]).unwrap_err();
/// assert_eq!(error, SplitError::Input(Error::NonFiniteCoordinate { vertex: 0 }));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum SplitError {
    /// A coordinate is not finite, or an end of an edge is no point.
    Input(Error),
    /// More pairs of edges cross than can be listed.
    TooManyCrossings {
        /// How many there may be.
        limit: usize,
    },
    /// Edges that are split at their crossings still cross, since rounding bends them each time.
    TooManyRounds {
        /// How many rounds there may be.
        limit: usize,
    },
}

impl fmt::Display for SplitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SplitError::Input(error) => error.fmt(f),
            SplitError::TooManyCrossings { limit } => {
                write!(f, "more than {limit} pairs of edges cross")
            }
            SplitError::TooManyRounds { limit } => write!(
                f,
                "edges still cross after {limit} rounds of splitting and rounding"
            ),
        }
    }
}

impl core::error::Error for SplitError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            SplitError::Input(error) => Some(error),
            SplitError::TooManyCrossings { .. } | SplitError::TooManyRounds { .. } => None,
        }
    }
}

impl From<Error> for SplitError {
    fn from(error: Error) -> SplitError {
        SplitError::Input(error)
    }
}

impl SplitError {
    /// The error with other numbers for vertices and edges; see [`Error::renumbered`].
    #[must_use]
    pub fn renumbered(
        self,
        on_vertex: impl FnOnce(usize) -> usize,
        on_edge: impl FnMut(usize) -> usize,
    ) -> SplitError {
        match self {
            SplitError::Input(error) => SplitError::Input(error.renumbered(on_vertex, on_edge)),
            SplitError::TooManyCrossings { .. } | SplitError::TooManyRounds { .. } => self,
        }
    }
}
