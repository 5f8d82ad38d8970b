//! Results of other programs: the verifier accepts the right ones and refuses the wrong ones.
#![cfg(feature = "cli")]

mod chosen;
mod hard;
