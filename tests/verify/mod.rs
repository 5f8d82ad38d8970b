//! The verifier must pass what is right and name what is wrong.

mod case;
mod chunks;
mod domains;
mod equal;
mod faults;
mod growth;
mod levels;
mod matching;
mod naive;
mod reports;
mod violations;
