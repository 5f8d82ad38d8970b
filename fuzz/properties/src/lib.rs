//! What must hold of every triangulation, as functions of bytes: the bodies of the fuzz targets.
//!
//! [`generators`] turn bytes into points and edges that are degenerate nearly every time; [`oracle`] tells
//! in exact integers, with no code of the crate, what must come out; each other module is one property,
//! named as its fuzz target in `fuzz/fuzz_targets`, which panics where the property does not hold. All of
//! this runs without a fuzzer too: the crate's own tests give it random bytes and the corpus.

pub mod bits;
pub mod canonical;
pub mod differential;
pub mod formats;
pub mod fronts;
pub mod generators;
pub mod input;
pub mod minimize;
pub mod oracle;
pub mod peers;
pub mod random;
pub mod reached;
pub mod replay;
pub mod runs;
pub mod scalars;
pub mod steps;
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
    /// The points and edges that the bytes stand for, if it is those that are tested.
    pub input: Option<fn(&[u8]) -> Input>,
}

/// All properties.
pub const TARGETS: &[Target] = &[
    target("valid", valid::test, Some(generators::input)),
    target("bits", bits::test, Some(bits::input)),
    target("scalars", scalars::test, Some(after_choices)),
    target("fronts", fronts::test, Some(after_choices)),
    target("canonical", canonical::test, Some(after_choices)),
    target("replay", replay::test, Some(after_choices)),
    target("verify", verify::test, None),
    target("formats", formats::test, None),
    target("differential", differential::test, None),
];

const fn target(name: &'static str, test: fn(&[u8]), input: Option<fn(&[u8]) -> Input>) -> Target {
    Target { name, test, input }
}

/// The input of a property that has choices of its own.
fn after_choices(bytes: &[u8]) -> Input {
    generators::input_with_choices(bytes).1
}
