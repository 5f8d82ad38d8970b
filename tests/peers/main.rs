//! Results of other programs: the right ones verify, and a wrong one is told.
#![cfg(feature = "formats")]

mod chosen;
mod hard;
