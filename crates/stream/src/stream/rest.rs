//! Bands: an input cut across the sweep, each part triangulated apart from the others, on any machine.
//!
//! ```text
//!      .  .   .    .  .   .      vertices above
//!     -------------------------  the line: at the band's last vertex
//!     \/\/\/\/\/\/\/\/\/\/\/\/\  alive
//!     *---*---*--*---*---*---*-  the border
//!     ::::::::::::::::::::::::   final, whatever lies below and above
//!     *--*---*---*--*----*--*--  the border
//!     /\/\/\/\/\/\/\/\/\/\/\/\/  alive
//!     -------------------------  the floor: at the band's first vertex
//!        .  .   .  .    .  .     vertices below
//! ```
//!
//! What is alive is the band's *rest*. A rest is an input again: two that follow each other are put together, and
//! triangulated as one window between the lower one's floor and the upper one's line. Joined in any order, all rests
//! give the triangles in memory. A band is a rest of which nothing has been triangulated.
//!
//! **Why the result is right:** `docs/proofs/bands.md`. The rules are those of a stream (`finality.rs`, `corridor.rs`,
//! `retire.rs`), each with a floor as well as with a line.
//!
//! **Cost:** an ordinary call of the sweep, and a step for each side of the hull and each edge that passes.

use std::cmp::Ordering;
use std::collections::{BTreeMap, btree_map};
use std::mem;
use std::ops::Range;

use super::corridor::{Path, corridors};
use super::error::StreamError;
use super::finality::{Line, is_between};
use super::retire::{Final, Retired, retire};
use super::stats::Alive;
use super::swept::Swept;
use super::window::{Window, sweep_order};
use sweep_cdt::Session;
use sweep_cdt::scalar::Scalar;

/// An input that is cut into bands: vertices in the order of the sweep, by y and then by x.
///
/// ```
/// use sweep_cdt::Triangulator;
/// use sweep_cdt_stream::{Cut, Final};
///
/// let cut = Cut { vertices: 5, between: [0, 4] };
/// let mut triangles = Vec::new();
/// let mut out = |found| {
///     if let Final::Triangle { corners, .. } = found {
///         triangles.push(corners);
///     }
/// };
/// let mut session = Triangulator::new().session();
/// // Edge 7 leads from vertex 100 in the lower band to vertex 104 in the upper one.
/// let edge = (7, [[0, 0], [4, 4]]);
/// let below = cut.band(0, [(100, [0, 0]), (101, [4, 0]), (102, [2, 1])], [edge], &mut out)?;
/// let above = cut.band(3, [(103, [0, 3]), (104, [4, 4])], [edge], &mut out)?;
/// let below = below.settle(&mut session, &mut out)?;
/// let above = above.settle(&mut session, &mut out)?;
/// let all = below.followed_by(above)?.settle(&mut session, &mut out)?;
/// assert!(all.is_complete());
/// assert_eq!(triangles.len(), 4);
/// # Ok::<(), sweep_cdt_stream::StreamError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Cut<S> {
    /// How many vertices all bands have together, duplicates among them.
    pub vertices: u64,
    /// All vertices lie between these two x, inclusive.
    pub between: [S; 2],
}

/// What of one band, or of several that follow each other, is not final yet, and all that is needed to go on.
#[derive(Debug)]
pub struct Rest<S> {
    pub(super) cut: Cut<S>,
    /// The positions of its vertices in the order.
    pub(super) covered: Range<u64>,
    /// The places of the first and the last vertex.
    pub(super) ends: [[S; 2]; 2],
    pub(super) window: Window<S>,
    /// The edges with an end beyond, by their numbers.
    pub(super) open: BTreeMap<u64, Open<S>>,
}

/// An edge with an end beyond the rest.
#[derive(Clone, Debug)]
pub(super) struct Open<S> {
    /// The lower end and the upper one.
    pub(super) ends: [[S; 2]; 2],
    /// The lowest vertex that is known to lie on it, if the lower end lies beyond, and the highest one, if the upper
    /// end does.
    pub(super) met: [Option<usize>; 2],
}

impl<S: Scalar + Clone> Cut<S> {
    /// A band: vertices in their order with numbers of the caller's choice, the first one at this position from 0; and
    /// edges with numbers and the places of both ends.
    ///
    /// Each band needs the edges that begin or end in it, or pass it: one end comes before it in the order, and one
    /// after it. Other edges are left out, and edges of no length. Equal vertices belong to one band, and `out` gets all
    /// but the first.
    ///
    /// # Errors
    /// [`StreamError`]: no vertices, or more than are left; a coordinate that is not finite, or beyond the range of x;
    /// a vertex before its predecessor; an end of an edge that should be a vertex, and is none; two edges of one number.
    pub fn band(
        &self,
        first: u64,
        vertices: impl IntoIterator<Item = (u64, [S; 2])>,
        edges: impl IntoIterator<Item = (u64, [[S; 2]; 2])>,
        mut out: impl FnMut(Final),
    ) -> Result<Rest<S>, StreamError> {
        let mut window = Window::<S>::default();
        let mut end = first;
        for (vertex, point) in vertices {
            end += 1;
            if !point.iter().all(S::is_finite) {
                return Err(StreamError::NonFiniteCoordinate { vertex });
            }
            if !is_between(&point, Some(&self.between)) {
                return Err(StreamError::OutsideRange { vertex });
            }
            match window
                .last()
                .map(|(last, of)| (sweep_order(&point, last), of))
            {
                Some((Ordering::Less, _)) => return Err(StreamError::Unsorted { vertex }),
                Some((Ordering::Equal, of)) => out(Final::Duplicate { number: vertex, of }),
                _ => window.push(vertex, point),
            }
        }
        let ends = window.points.first().zip(window.points.last());
        let (low, high) = ends.ok_or(StreamError::NoVertices)?;
        if end > self.vertices {
            let next = self.vertices;
            return Err(StreamError::NotNext { end, next });
        }
        let mut rest = Rest {
            cut: self.clone(),
            covered: first..end,
            ends: [low.clone(), high.clone()],
            window,
            open: BTreeMap::new(),
        };
        for (edge, ends) in edges {
            rest.add_edge(edge, ends)?;
        }
        Ok(rest)
    }
}

impl<S: Scalar + Clone> Rest<S> {
    fn add_edge(&mut self, edge: u64, [a, b]: [[S; 2]; 2]) -> Result<(), StreamError> {
        let is_known =
            |end: &[S; 2]| end.iter().all(S::is_finite) && is_between(end, Some(&self.cut.between));
        if ![&a, &b].into_iter().all(is_known) {
            return Err(StreamError::BadEdge { edge });
        }
        let ends = match sweep_order(&a, &b) {
            Ordering::Less => [a, b],
            Ordering::Equal => return Ok(()),
            Ordering::Greater => [b, a],
        };
        let is_beyond = self.beyond(&ends);
        if sweep_order(&ends[1], &self.ends[0]).is_lt()
            || sweep_order(&ends[0], &self.ends[1]).is_gt()
        {
            return Ok(());
        }
        let missing = StreamError::MissingEnd { edge };
        let is_last = [
            self.covered.start == 0,
            self.covered.end == self.cut.vertices,
        ];
        let mut at = [None; 2];
        for i in 0..2 {
            if is_beyond[i] {
                // Nothing lies beyond the first band and the last.
                (!is_last[i]).then_some(()).ok_or(missing)?;
            } else {
                let points = &self.window.points;
                let found = points.binary_search_by(|point| sweep_order(point, &ends[i]));
                at[i] = Some(found.map_err(|_| missing)?);
            }
        }
        let met = match at {
            [Some(low), Some(high)] => {
                self.window.connect([low, high], edge);
                return Ok(());
            }
            [low, high] => [high, low],
        };
        match self.open.entry(edge) {
            btree_map::Entry::Vacant(entry) => {
                entry.insert(Open { ends, met });
                Ok(())
            }
            btree_map::Entry::Occupied(_) => Err(StreamError::BadEdge { edge }),
        }
    }

    /// Whether the lower end of an edge lies below the first vertex, and the upper one above the last.
    pub(super) fn beyond(&self, [low, high]: &[[S; 2]; 2]) -> [bool; 2] {
        let [first, last] = &self.ends;
        [
            sweep_order(low, first).is_lt(),
            sweep_order(high, last).is_gt(),
        ]
    }

    /// Of a band that is not settled how many vertices it has, how many others equal them, and how many edges begin in it.
    pub(super) fn counts(&self) -> [u64; 3] {
        let vertices = self.window.points.len() as u64;
        let begins = |open: &&Open<S>| !self.beyond(&open.ends)[0];
        let begun = self.open.values().filter(begins).count();
        let edges = (self.window.edges.len() + begun) as u64;
        let covered = self.covered.end - self.covered.start;
        [vertices, covered - vertices, edges]
    }

    /// How many vertices it has.
    pub fn vertices(&self) -> usize {
        self.window.points.len()
    }

    /// How many vertices all bands have together.
    pub fn total(&self) -> u64 {
        self.cut.vertices
    }

    /// The positions in the order of the vertices that it stands for.
    pub fn covered(&self) -> Range<u64> {
        self.covered.clone()
    }

    /// Whether it stands for all vertices. Once it is settled, everything has been passed on.
    pub fn is_complete(&self) -> bool {
        self.covered == (0..self.cut.vertices)
    }

    /// This rest and the next one in the order, as one.
    ///
    /// # Errors
    /// [`StreamError`]: they do not follow each other, or are of different inputs.
    pub fn followed_by(mut self, mut above: Self) -> Result<Self, StreamError> {
        let [end, next] = [self.covered.end, above.covered.start];
        if end != next {
            return Err(StreamError::NotNext { end, next });
        }
        let is_equal = |a: &[S; 2], b: &[S; 2]| (0..2).all(|i| a[i].compare(&b[i]).is_eq());
        if self.cut.vertices != above.cut.vertices
            || !is_equal(&self.cut.between, &above.cut.between)
            || sweep_order(&self.ends[1], &above.ends[0]).is_ge()
        {
            return Err(StreamError::OtherInput);
        }
        let shift = self.window.points.len();
        let shifted = |met: [Option<usize>; 2]| met.map(|v| v.map(|v| v + shift));
        let [first, last] = above.ends;
        self.window.append(above.window);
        self.covered.end = above.covered.end;
        let border = mem::replace(&mut self.ends[1], last);
        for (edge, open) in mem::take(&mut self.open) {
            let goes_on = sweep_order(&open.ends[1], &border).is_gt();
            match (goes_on, above.open.remove(&edge)) {
                (false, None) => drop(self.open.insert(edge, open)),
                (true, Some(other)) if (0..2).all(|i| is_equal(&open.ends[i], &other.ends[i])) => {
                    self.join_edge(edge, open, shifted(other.met));
                }
                _ => return Err(StreamError::OtherInput),
            }
        }
        for (edge, Open { ends, met }) in above.open {
            if sweep_order(&ends[0], &first).is_lt() {
                return Err(StreamError::OtherInput);
            }
            let met = shifted(met);
            self.open.insert(edge, Open { ends, met });
        }
        Ok(self)
    }

    /// Joins the two parts of an edge that goes from one rest on to another, which has met these vertices on it.
    fn join_edge(&mut self, edge: u64, below: Open<S>, above: [Option<usize>; 2]) {
        let Open { ends, met } = below;
        if let (Some(u), Some(v)) = (met[1], above[0]) {
            self.window.connect([u, v], edge);
        }
        let [goes_down, goes_up] = self.beyond(&ends);
        let met = [
            met[0].or(above[0]).filter(|_| goes_down),
            above[1].or(met[1]).filter(|_| goes_up),
        ];
        if goes_down || goes_up {
            self.open.insert(edge, Open { ends, met });
        }
    }

    /// Triangulates the rest, passes on what is final whatever lies below and above, and returns what is left: all that
    /// is alive. Of a complete rest nothing is.
    ///
    /// # Errors
    /// [`StreamError`]: edges cross, and what [`Error`](sweep_cdt::Error) names.
    pub fn settle(
        self,
        session: &mut Session,
        mut out: impl FnMut(Final),
    ) -> Result<Self, StreamError> {
        let (left, _) = self.settle_counted(session, &mut out)?;
        Ok(left)
    }

    /// [`settle`](Rest::settle), and what is alive.
    pub(super) fn settle_counted(
        mut self,
        session: &mut Session,
        out: &mut dyn FnMut(Final),
    ) -> Result<(Self, Alive), StreamError> {
        let swept = Swept::sweep(&mut self.window, session, None, None);
        let swept = swept.map_err(|error| self.window.renumbered(error))?;
        for v in self
            .open
            .values_mut()
            .flat_map(|open| open.met.iter_mut().flatten())
        {
            *v = swept.place(*v);
        }
        let mut paths = Vec::new();
        for (&edge, Open { ends, met }) in &self.open {
            let [low, high] = ends.each_ref();
            let mut push = |line, start| paths.push(Path { edge, line, start });
            if is_followed_up(*met) {
                push([low, high], met[1]);
            }
            if met[0].is_some() {
                push([high, low], met[0]);
            }
        }
        let corridors = corridors(&self.window.points, &swept, &paths);
        let window = mem::take(&mut self.window);
        let Retired {
            window,
            reached,
            alive,
        } = retire(window, &swept, &self.lines(), corridors, out);
        self.window = window;
        let mut reached = reached.into_iter().flatten();
        let mut next = || reached.next().flatten();
        for Open { met, .. } in self.open.values_mut() {
            let [low, _] = *met;
            if is_followed_up(*met) {
                *met = [next(), next()];
            }
            if low.is_some() {
                next();
                met[0] = next();
            }
        }
        Ok((self, alive))
    }

    /// Beyond which vertices may come.
    fn lines(&self) -> Vec<Line<S>> {
        let [first, last] = &self.ends;
        let between = Some(&self.cut.between);
        let has_floor = self.covered.start > 0;
        let floor = has_floor.then(|| Line::floor(first, between));
        let has_line = self.covered.end < self.cut.vertices;
        let line = has_line.then(|| Line::new(last, between));
        floor.into_iter().chain(line).collect()
    }
}

/// Whether an edge is followed to its upper end: from the highest vertex on it, or from beyond the hull if none is known.
fn is_followed_up(met: [Option<usize>; 2]) -> bool {
    met[1].is_some() || met[0].is_none()
}
