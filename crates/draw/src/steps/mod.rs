//! The steps of a trace, drawn: a page to walk through them, and a sheet of single ones.
//!
//! Steps are numbered from 1, as in the other forms of a trace. Each [`Event`] becomes a heading and a
//! sentence ([`story`]) and a list of what it changes in the picture ([`change`]), so that neither the page
//! nor the [`scene`] that the sheet draws needs to know events. Both draw in the same [`style`]s.
//!
//! Sides to the artificial points P-1 and P-2, which are directions, are horizontal rays to the left and to
//! the right. A test that involves one of them has no circle.

mod change;
mod choice;
mod data;
mod page;
mod panel;
mod scene;
mod sections;
mod sheet;
mod story;
mod style;

pub use page::StepsPage;
pub use sheet::StepsSheet;

#[cfg(doc)]
use sweep_cdt::trace::Event;
