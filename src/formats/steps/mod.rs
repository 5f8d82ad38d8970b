//! The steps of a trace, drawn: a page to walk through them, and pictures of single ones.
//!
//! Steps are numbered from 1, as in the other forms of a trace. Each [`Event`] is told in a sentence
//! ([`story`]) and reduced to what changes in the picture ([`change`]), so that neither the page nor
//! the [`scene`] that pictures are drawn from needs to know events. Both show the same:
//!
//! | what | colour | and told apart by |
//! |---|---|---|
//! | triangle, new triangle | grey sides; green | fill |
//! | advancing front | orange | broad line |
//! | sweep line | purple | dashes and dots, across the whole view |
//! | constraint: to come, fixed, being inserted | blue | thin dashes; a heavy line; an arrow |
//! | pierced triangle | grey | dots |
//! | pseudo-polygon: upper, lower | sky blue, yellow | hatching `/`, `\` |
//! | edge under test: legal, illegal, fixed | green, red, black | circle whole, dashed, none |
//! | edge that was swapped, that came | red | dots, a heavy line |
//!
//! The colours are Okabe and Ito's, which colour-blind people can tell. Sides to the artificial points
//! P-1 and P-2, which are directions, are horizontal rays to the left and to the right, and a test that
//! involves one of them has no circle.

mod change;
mod frame;
mod page;
mod panel;
mod scene;
mod sheet;
mod story;

pub use page::{MOST_STEPS, write_page};
pub use sheet::{MOST_PANELS, write_sheet};

use std::ops::{Range, RangeInclusive};

#[cfg(doc)]
use crate::trace::Event;

/// The positions in a trace of at most so many steps, given by their numbers.
fn positions(steps: &RangeInclusive<usize>, events: usize, most: usize) -> Range<usize> {
    let start = steps.start().saturating_sub(1).min(events);
    let end = (*steps.end()).min(events).max(start);
    start..end.min(start + most)
}
