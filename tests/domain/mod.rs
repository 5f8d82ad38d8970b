//! Domains against ray casting and geometry in exact integers.

mod broken;
mod oracle;
mod random;
mod rings;
mod rules;
mod seeds;
