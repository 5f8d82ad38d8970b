//! What goes along with the vertices of a stream, for as long as it may name them.
//!
//! Vertices get consecutive numbers. After a window the values of those that are alive are sorted by their numbers; those
//! that have come since follow in their order. So memory is that of the window, and a value is found by halving.

use super::Stream;
use super::retire::Final;
use sweep_cdt::scalar::Scalar;

/// A value for each vertex of a [`Stream`] that may still be named: a height, for example.
///
/// ```
/// use sweep_cdt::Triangulator;
/// use sweep_cdt_stream::{Carried, Final, Stream};
/// use std::cell::RefCell;
///
/// let names = RefCell::new(Carried::default());
/// let mut corners = Vec::new();
/// let mut stream = Stream::new(Triangulator::new(), |found| {
///     if let Final::Triangle { corners: numbers, .. } = found {
///         corners.push(numbers.map(|number| *names.borrow().get(number)));
///     }
/// });
/// for (name, point) in [("low", [1, 0]), ("left", [0, 1]), ("right", [2, 1])] {
///     let number = names.borrow_mut().push(name);
///     stream.push(number, point)?;
///     names.borrow_mut().forget(&stream);
/// }
/// stream.finish()?;
/// corners[0].sort_unstable();
/// assert_eq!(corners, [["left", "low", "right"]]);
/// # Ok::<(), sweep_cdt_stream::StreamError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Carried<T> {
    /// What was alive after the last window, by number.
    kept: Vec<(u64, T)>,
    /// What has come since, from this number on.
    first: u64,
    fresh: Vec<T>,
    windows: u64,
}

impl<T> Default for Carried<T> {
    fn default() -> Self {
        Carried {
            kept: Vec::new(),
            first: 0,
            fresh: Vec::new(),
            windows: 0,
        }
    }
}

impl<T: Clone> Carried<T> {
    /// The value of the next vertex. Returns the number that the stream must get with it.
    pub fn push(&mut self, value: T) -> u64 {
        self.fresh.push(value);
        self.first + (self.fresh.len() as u64 - 1)
    }

    /// The value of a vertex that the stream names.
    ///
    /// # Panics
    /// The stream can name no such vertex.
    #[must_use]
    pub fn get(&self, number: u64) -> &T {
        match self.place(number) {
            (true, at) => &self.fresh[at],
            (false, at) => &self.kept[at].1,
        }
    }

    /// The value of a vertex that the stream names, to be changed.
    ///
    /// # Panics
    /// The stream can name no such vertex.
    pub fn get_mut(&mut self, number: u64) -> &mut T {
        match self.place(number) {
            (true, at) => &mut self.fresh[at],
            (false, at) => &mut self.kept[at].1,
        }
    }

    /// Whether a vertex has come since the last window, and its place among those or the others.
    fn place(&self, number: u64) -> (bool, usize) {
        let at = number.checked_sub(self.first);
        match at.and_then(|at| usize::try_from(at).ok()) {
            Some(at) => (true, at),
            None => {
                let at = self.kept.binary_search_by_key(&number, |kept| kept.0);
                (false, at.expect("a vertex that is alive"))
            }
        }
    }

    /// Forgets what a stream can name no more. Call it after each vertex that is pushed.
    pub fn forget<S: Scalar + Clone, O: FnMut(Final)>(&mut self, stream: &Stream<'_, S, O>) {
        if stream.stats().windows == self.windows {
            return;
        }
        self.windows = stream.stats().windows;
        let mut alive = stream.vertices().to_vec();
        alive.sort_unstable();
        let value = |number| (number, self.get(number).clone());
        self.kept = alive.into_iter().map(value).collect();
        self.first += self.fresh.len() as u64;
        self.fresh.clear();
    }
}
