//! The module `sweep_cdt._native`: the crate for the package `sweep_cdt`, which wraps it in Python.
//!
//! Python converts what it is given to arrays of doubles or to exact points, and what comes back to other libraries'
//! objects. Here is what must be fast or exact.
//!
//! The one class whose state changes has a lock of its own, so that the module needs none of the interpreter.

#![deny(unsafe_code)]

mod bands;
mod calls;
mod columns;
mod crossings;
mod dynamic;
mod errors;
mod input;
mod matching;
mod measure;
mod picture;
mod refine;
mod remarks;
mod rule;
mod trace;
mod triangulation;
mod verify;
mod voronoi;

use mimalloc::MiMalloc;
use pyo3::prelude::*;

/// Keeps for a moment what a call has freed: the arrays that come after it take memory that is already mapped.
#[global_allocator]
static ALLOCATOR: MiMalloc = MiMalloc;

#[pymodule(gil_used = false)]
mod _native {
    /// The version of the package.
    #[pymodule_export]
    #[allow(non_upper_case_globals, reason = "Python's name")]
    const __version__: &str = env!("CARGO_PKG_VERSION");
    #[pymodule_export]
    use crate::bands::{band, join};
    #[pymodule_export]
    use crate::columns::{gathered, named_columns, named_height};
    #[pymodule_export]
    use crate::crossings::{Crossings, crossings, split};
    #[pymodule_export]
    use crate::dynamic::Dynamic;
    #[pymodule_export]
    use crate::input::ExactPoints;
    #[pymodule_export]
    use crate::matching::match_vertices;
    #[pymodule_export]
    use crate::measure::fronts;
    #[pymodule_export]
    use crate::picture::picture;
    #[pymodule_export]
    use crate::refine::refine;
    #[pymodule_export]
    use crate::remarks::{
        half_of_the_globe, height_property, ignored, is_of_degrees, off_terrain, voids,
        without_heights,
    };
    #[pymodule_export]
    use crate::rule::inside;
    #[pymodule_export]
    use crate::trace::{Steps, trace};
    #[pymodule_export]
    use crate::triangulation::{Core, triangulate, triangulate_inside};
    #[pymodule_export]
    use crate::verify::{advise, verify};
    #[pymodule_export]
    use crate::voronoi::{cells, voronoi};
}
