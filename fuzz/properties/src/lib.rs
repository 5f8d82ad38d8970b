//! What must hold of every triangulation, as functions of bytes: the bodies of the fuzz targets.
//!
//! [`generators`] turn bytes into points and edges that are degenerate nearly every time; [`oracle`] tells
//! in exact integers, with no code of the crate, what must come out; each other module is one property,
//! named as its fuzz target in `fuzz/fuzz_targets`, which panics where the property does not hold. All of
//! this runs without a fuzzer too: the crate's own tests give it random bytes and the corpus.

pub mod bits;
pub mod differential;
pub mod formats;
pub mod generators;
pub mod input;
pub mod minimize;
pub mod oracle;
pub mod peers;
pub mod reached;
pub mod runs;
pub mod valid;
pub mod verify;

pub use input::Input;

/// A property by its name.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// As its fuzz target and its folder of seeds are called.
    pub name: &'static str,
    /// Panics if the property does not hold for what the bytes stand for.
    pub test: fn(&[u8]),
}

/// All properties.
pub const TARGETS: &[Target] = &[
    Target {
        name: "valid",
        test: valid::test,
    },
    Target {
        name: "bits",
        test: bits::test,
    },
    Target {
        name: "verify",
        test: verify::test,
    },
    Target {
        name: "formats",
        test: formats::test,
    },
    Target {
        name: "differential",
        test: differential::test,
    },
];
