//! The verifier must pass what is right and name what is wrong.

mod case;
mod faults;
mod naive;
mod reports;
