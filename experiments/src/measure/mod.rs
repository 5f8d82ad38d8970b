//! Measuring: a cell, its variants, and the rows that they give.

mod cell;
mod clock;
mod fingerprint;
mod row;
mod variant;

pub(crate) use cell::{Cell, Source};
pub(crate) use row::Row;
pub(crate) use variant::Variant;
