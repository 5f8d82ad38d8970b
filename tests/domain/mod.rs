//! Domains against ray casting and geometry in exact integers.

mod oracle;
mod random;
mod rings;
mod rules;
mod seeds;
