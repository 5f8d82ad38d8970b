//! Contour lines: where the surface has a given height.
//!
//! A vertex is *above* a level if its height is at least the level, and below it otherwise: one exactly at the level
//! counts as a little higher. So a level crosses two sides of a triangle or none, each crossing belongs to one piece in
//! each triangle beside it, and pieces join to chains that never branch: they end at the border of the surface, or close.
//! No flat triangle makes an area; a plateau at a level has a line around it. Chains do not cross. Their places are rounded:
//! along a side they stay in the order of their levels, but in a triangle that is thinner than the rounding, lines may
//! touch or cross.
//!
//! The higher ground lies on the left of a line. Crossings on sides that end at a vertex of just that level are one
//! point. A peak of just that level has no line, and a ridge has one that goes there and back.
//!
//! A crossing is named by the two ends of its side. A closed line begins at the least of these names, and lines of a
//! level come in the order of their first ones, so that the output depends on the points and their numbers alone.
//!
//! Cost: linear in the triangles, the levels and the pieces, but for the order of the lines, and log of the number of
//! levels for each vertex.

use std::fmt;
use std::ops::Range;

use sweep_cdt::memory::has_room;
use sweep_cdt::scalar::Scalar;

use crate::interpolate::between;
use crate::surface::Surface;

/// More pieces are refused.
const MOST_PIECES: u64 = 1 << 27;
/// Bytes that a piece takes.
const PIECE: u64 = 24;

/// A line of equal height.
#[derive(Clone, Debug, PartialEq)]
pub struct Contour {
    /// The height.
    pub level: f64,
    /// The points, with the higher ground on the left. The last equals the first where the line is closed.
    pub points: Vec<[f64; 2]>,
}

impl Contour {
    /// Whether the line ends where it begins.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.points.len() > 2 && self.points.first() == self.points.last()
    }
}

/// The refusal of contour lines that no memory holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooManyPieces {
    /// How many pieces there would be: one for each level in each triangle.
    pub pieces: u64,
}

impl fmt::Display for TooManyPieces {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let TooManyPieces { pieces } = self;
        write!(
            f,
            "the contour lines have {pieces} pieces, too many for the memory: ask for fewer levels"
        )
    }
}

impl std::error::Error for TooManyPieces {}

/// The side that a level crosses, by its ends: below, above.
type Crossing = [usize; 2];

impl<S: Scalar> Surface<'_, S> {
    /// The contour lines at these levels, which are sorted.
    ///
    /// ```
    /// use sweep_cdt::interior::Interior;
    /// use sweep_cdt_terrain::Surface;
    ///
    /// // A slope that rises to the right by 1 a step.
    /// let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 1.0], [0.0, 1.0]];
    /// let result = sweep_cdt::triangulate(&points, &[])?;
    /// let whole = Interior::whole(&result);
    /// let surface = Surface::new(&points, &whole, &[10.0, 14.0, 14.0, 10.0]);
    /// let lines = surface.contours(&[11.0, 20.0])?;
    /// assert_eq!(lines.len(), 1);
    /// assert_eq!(lines[0].points.first(), Some(&[1.0, 1.0]));
    /// assert_eq!(lines[0].points.last(), Some(&[1.0, 0.0]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`TooManyPieces`], before any line is made.
    pub fn contours(&self, levels: &[f64]) -> Result<Vec<Contour>, TooManyPieces> {
        let crossed = self.crossed(levels)?;
        // The last level that a triangle was passed at, counted from 1.
        let mut passed = vec![0; self.interior.triangulation().len()];
        let mut lines = Vec::new();
        for (at, &level) in levels.iter().enumerate() {
            let mut chains = self.chains(level, crossed.at(at), |t| {
                std::mem::replace(&mut passed[t], at + 1) == at + 1
            });
            chains.sort_unstable_by_key(|chain| chain[0]);
            let lines_of_level = chains.iter().filter_map(|chain| self.line(level, chain));
            lines.extend(lines_of_level);
        }
        Ok(lines)
    }

    /// The triangles that each level crosses.
    fn crossed(&self, levels: &[f64]) -> Result<Crossed, TooManyPieces> {
        // How many levels each vertex is above.
        let above = self.heights.iter().map(|&height| above(levels, height));
        let above: Vec<usize> = above.collect();
        let range = |corners: [usize; 3]| crossing(corners.map(|v| above[v]));
        // First the number of pieces alone, which may be beyond all memory.
        let mut changes = vec![0_i64; levels.len() + 1];
        for (_, corners) in self.triangles() {
            changes[range(corners).start] += 1;
            changes[range(corners).end] -= 1;
        }
        let counts = changes.iter().scan(0, |count, change| {
            *count += change;
            Some(count.unsigned_abs())
        });
        let pieces: u64 = counts.clone().sum();
        let bytes = usize::try_from(pieces * PIECE).unwrap_or(usize::MAX);
        if pieces > MOST_PIECES || !has_room(bytes) {
            return Err(TooManyPieces { pieces });
        }
        let mut ends: Vec<usize> = counts
            .scan(0, |begin, count| {
                let this = *begin;
                *begin += usize::try_from(count).expect("at most as many as all pieces");
                Some(this)
            })
            .collect();
        let mut triangles = vec![0; ends.last().copied().unwrap_or(0)];
        for (t, corners) in self.triangles() {
            for level in range(corners) {
                triangles[ends[level]] = t;
                ends[level] += 1;
            }
        }
        Ok(Crossed { triangles, ends })
    }

    /// The chains of a level that crosses these triangles. `pass` notes that a triangle is passed, and says whether it was
    /// before.
    fn chains(
        &self,
        level: f64,
        crossed: &[usize],
        mut pass: impl FnMut(usize) -> bool,
    ) -> Vec<Vec<Crossing>> {
        let mut chains = Vec::new();
        // Those that begin at the border, then those that are closed.
        for closed in [false, true] {
            for &start in crossed {
                let [enter, _] = self.piece(start, level);
                let begins = closed || self.across(start, enter.0).is_none();
                if !begins || pass(start) {
                    continue;
                }
                let mut chain = vec![enter.1];
                let mut t = start;
                loop {
                    let [_, leave] = self.piece(t, level);
                    chain.push(leave.1);
                    match self.across(t, leave.0) {
                        Some(across) if !pass(across) => t = across,
                        _ => break,
                    }
                }
                if closed {
                    // The last crossing is the first.
                    chain.pop();
                    let least = (0..chain.len()).min_by_key(|&at| chain[at]);
                    chain.rotate_left(least.unwrap_or(0));
                    chain.push(chain[0]);
                }
                chains.push(chain);
            }
        }
        chains
    }

    fn piece(&self, t: usize, level: f64) -> [(usize, Crossing); 2] {
        let corners = self.interior.triangulation().triangle(t);
        piece(corners, corners.map(|v| self.heights[v]), level)
    }

    /// The line along a chain, without steps of no length; none, if it is one point.
    fn line(&self, level: f64, chain: &[Crossing]) -> Option<Contour> {
        let mut points: Vec<[f64; 2]> = chain.iter().map(|&side| self.place(level, side)).collect();
        points.dedup();
        (points.len() > 1).then_some(Contour { level, points })
    }

    /// The place where a level crosses a side.
    fn place(&self, level: f64, [below, above]: Crossing) -> [f64; 2] {
        let heights = [below, above].map(|v| self.heights[v]);
        let ends = [below, above].map(|v| self.points[v].each_ref().map(S::approx));
        place(level, heights, ends)
    }
}

/// How many of these levels a height is above.
pub(crate) fn above(levels: &[f64], height: f64) -> usize {
    levels.partition_point(|level| *level <= height)
}

/// The levels between some heights, each of which is above so many.
pub(crate) fn crossing<const N: usize>(above: [usize; N]) -> Range<usize> {
    let least = above.iter().min().copied().unwrap_or(0);
    least..above.iter().max().copied().unwrap_or(0)
}

/// The sides of a triangle through which the line of a level enters and leaves it, with the higher ground on its left, and
/// the ends of each: below, above.
pub(crate) fn piece<V: Copy>(
    corners: [V; 3],
    heights: [f64; 3],
    level: f64,
) -> [(usize, [V; 2]); 2] {
    let is_above = heights.map(|height| height >= level);
    let side = |from_above: bool| {
        let side = (0..3).find(|side| {
            let [from, to] = [(side + 1) % 3, (side + 2) % 3];
            is_above[from] == from_above && is_above[to] != from_above
        });
        let side = side.expect("the level crosses the triangle");
        let [from, to] = [corners[(side + 1) % 3], corners[(side + 2) % 3]];
        (side, if from_above { [to, from] } else { [from, to] })
    };
    [side(true), side(false)]
}

/// The place where a level crosses a side, from its end below to that above.
pub(crate) fn place(level: f64, heights: [f64; 2], ends: [[f64; 2]; 2]) -> [f64; 2] {
    [0, 1].map(|axis| between(level, heights, ends.map(|end| end[axis])))
}

/// Triangles by the levels that cross them.
struct Crossed {
    triangles: Vec<usize>,
    /// Where the triangles of each level end.
    ends: Vec<usize>,
}

impl Crossed {
    /// The triangles that the level at this place crosses.
    fn at(&self, level: usize) -> &[usize] {
        let begin = level.checked_sub(1).map_or(0, |before| self.ends[before]);
        &self.triangles[begin..self.ends[level]]
    }
}
