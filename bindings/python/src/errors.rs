//! The crate's errors as exceptions of `sweep_cdt._errors`: with the sentence of the crate, and the offenders as
//! attributes.

use pyo3::prelude::*;
use pyo3::types::PyDict;
use sweep_cdt::Error;
use sweep_cdt::crossings::SplitError;
use sweep_cdt::interior::{InteriorError, Seed};
use sweep_cdt_edit::{BoundsError, EditError, RefineError, VoronoiError};
use sweep_cdt_stream::StreamError;

/// What a call gives that fails with an error of the crate.
#[derive(Debug)]
pub(crate) enum Fault {
    Input(Error),
    Interior(InteriorError),
    Split(SplitError),
    Edit(EditError),
    Refine(RefineError),
    Voronoi(VoronoiError),
    Stream(StreamError),
}

impl From<Error> for Fault {
    fn from(error: Error) -> Fault {
        Fault::Input(error)
    }
}

impl From<InteriorError> for Fault {
    fn from(error: InteriorError) -> Fault {
        match error {
            InteriorError::Refused { error } => Fault::Input(error),
            error => Fault::Interior(error),
        }
    }
}

impl From<SplitError> for Fault {
    fn from(error: SplitError) -> Fault {
        match error {
            SplitError::Input(error) => Fault::Input(error),
            error => Fault::Split(error),
        }
    }
}

impl From<EditError> for Fault {
    fn from(error: EditError) -> Fault {
        match error {
            EditError::CrossingEdges { edges } => Fault::Input(Error::CrossingEdges { edges }),
            EditError::Refused { error } => Fault::Input(error),
            error => Fault::Edit(error),
        }
    }
}

impl From<RefineError> for Fault {
    fn from(error: RefineError) -> Fault {
        match error {
            RefineError::Edit(error) => error.into(),
            error => Fault::Refine(error),
        }
    }
}

impl From<BoundsError> for Fault {
    fn from(error: BoundsError) -> Fault {
        Fault::Refine(error.into())
    }
}

impl From<VoronoiError> for Fault {
    fn from(error: VoronoiError) -> Fault {
        Fault::Voronoi(error)
    }
}

impl From<StreamError> for Fault {
    fn from(error: StreamError) -> Fault {
        Fault::Stream(error)
    }
}

/// The exception of this class, made from a sentence and attributes.
pub(crate) fn exception(
    py: Python<'_>,
    class: &str,
    message: String,
    attributes: &Bound<'_, PyDict>,
) -> PyErr {
    let make = || {
        let module = py.import("sweep_cdt._errors")?;
        module.getattr(class)?.call((message,), Some(attributes))
    };
    make().map_or_else(|error| error, PyErr::from_value)
}

/// The exception for an argument that cannot be used.
pub(crate) fn refused(message: String) -> PyErr {
    Python::attach(|py| exception(py, "Error", message, &PyDict::new(py)))
}

impl Fault {
    /// The exception.
    pub(crate) fn raise(self, py: Python<'_>) -> PyErr {
        let attributes = PyDict::new(py);
        match self.describe(&attributes) {
            Ok((class, message)) => exception(py, class, message, &attributes),
            Err(error) => error,
        }
    }

    /// Sets the attributes. Returns the class and the sentence.
    fn describe(self, attributes: &Bound<'_, PyDict>) -> PyResult<(&'static str, String)> {
        let class = match self {
            Fault::Input(error) => match error {
                Error::NonFiniteCoordinate { vertex } => {
                    attributes.set_item("vertex", vertex)?;
                    "NonFiniteError"
                }
                Error::EdgeOutOfRange { edge, vertex } => {
                    attributes.set_item("edge", edge)?;
                    attributes.set_item("vertex", vertex)?;
                    "EdgeOutOfRangeError"
                }
                Error::CrossingEdges { edges } => {
                    attributes.set_item("edges", (edges[0], edges[1]))?;
                    "CrossingEdgesError"
                }
                Error::OutOfMemory { bytes } => {
                    attributes.set_item("bytes", bytes)?;
                    "OutOfMemoryError"
                }
                Error::TooManyPoints { limit, .. }
                | Error::TooManyEdges { limit, .. }
                | Error::TooManyVerticesOnEdges { limit } => {
                    attributes.set_item("limit", limit)?;
                    "TooLargeError"
                }
                _ => "Error",
            },
            Fault::Interior(error) => match error {
                InteriorError::OpenAtVertex { vertex } => {
                    attributes.set_item("vertex", vertex)?;
                    "OpenRingError"
                }
                InteriorError::SeedNotFinite { seed }
                | InteriorError::SeedOutside { seed }
                | InteriorError::SeedOnVertex { seed, .. }
                | InteriorError::SeedOnEdge { seed, .. } => {
                    let (kind, index) = match seed {
                        Seed::Hole(index) => ("hole", index),
                        Seed::Region(index) => ("region", index),
                    };
                    attributes.set_item(kind, index)?;
                    "SeedError"
                }
                InteriorError::RegionOutside { region } => {
                    attributes.set_item("region", region)?;
                    "SeedError"
                }
                _ => "Error",
            },
            Fault::Split(error) => {
                if let SplitError::TooManyCrossings { limit }
                | SplitError::TooManyRounds { limit } = error
                {
                    attributes.set_item("limit", limit)?;
                }
                "TooLargeError"
            }
            Fault::Edit(error) => match error {
                EditError::NoPoint { point } => {
                    attributes.set_item("point", point)?;
                    "MissingError"
                }
                EditError::NoEdge { edge } => {
                    attributes.set_item("edge", edge)?;
                    "MissingError"
                }
                EditError::PointInUse { point, edge } => {
                    attributes.set_item("point", point)?;
                    attributes.set_item("edge", edge)?;
                    "PointInUseError"
                }
                EditError::NonFiniteCoordinate { point } => {
                    attributes.set_item("vertex", point)?;
                    "NonFiniteError"
                }
                _ => "Error",
            },
            Fault::Refine(_) => "Error",
            Fault::Voronoi(error) => match error {
                VoronoiError::NotDelaunay { side: [a, b] } => {
                    attributes.set_item("side", (a, b))?;
                    "NotDelaunayError"
                }
                _ => "Error",
            },
            Fault::Stream(error) => match error {
                StreamError::NonFiniteCoordinate { vertex } => {
                    attributes.set_item("vertex", vertex)?;
                    "NonFiniteError"
                }
                StreamError::CrossingEdges { edges: [a, b] } => {
                    attributes.set_item("edges", (a, b))?;
                    "CrossingEdgesError"
                }
                _ => "Error",
            },
        };
        let message = match self {
            Fault::Input(error) => error.to_string(),
            Fault::Interior(error) => error.to_string(),
            Fault::Split(error) => error.to_string(),
            Fault::Edit(error) => error.to_string(),
            Fault::Refine(RefineError::Endless) => {
                format!("{}: pass max_points", RefineError::Endless)
            }
            Fault::Refine(error) => error.to_string(),
            Fault::Voronoi(error) => error.to_string(),
            Fault::Stream(error) => error.to_string(),
        };
        Ok((class, message))
    }
}
