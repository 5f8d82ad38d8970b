//! Contour lines of triangles that pass one by one, in any order: the pieces of [`crate::contours`], joined as they come.
//!
//! A chain begins and ends at a crossing, or at the border of the surface. Two chains where one ends at the crossing at
//! which the other begins become one. A side of the border is a chain of one point, from the border to the crossing there
//! or from there to the border. So a chain that has no crossing at its ends is a line, and so is one that ends where it
//! begins: lines are passed on as soon as they are complete, and are those of the surface in memory.
//!
//! Cost: some steps in hash tables for a piece; joining moves the points of the shorter chain. Memory for the chains that
//! wait. One line may wait until the last triangle, and be as long as there are triangles. So there is a bound for the points
//! that wait: beyond it the chains are passed on as they are, as parts of lines, and go on where they end.

use std::collections::{HashMap, VecDeque};

use sweep_cdt::scalar::Scalar;

use crate::contours::{Contour, above, crossing, piece, place};
use crate::surface::Surface;

/// Chains that are no longer stay whole: passing them on would free nothing.
const SHORT: usize = 16;

/// A corner of a triangle that passes.
#[derive(Clone, Copy, Debug)]
pub struct Corner {
    /// The number of the vertex.
    pub number: u64,
    /// The place of the vertex.
    pub point: [f64; 2],
    /// The height of the vertex, NaN where it is missing.
    pub height: f64,
}

impl<S: Scalar> Surface<'_, S> {
    /// All triangles inside as triangles that pass, counter-clockwise; missing heights are NaN. Coordinates that are no doubles
    /// are rounded.
    ///
    /// ```
    /// use sweep_cdt::interior::Interior;
    /// use sweep_cdt_terrain::Surface;
    ///
    /// let points = [[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]];
    /// let result = sweep_cdt::triangulate(&points, &[])?;
    /// let whole = Interior::whole(&result);
    /// let surface = Surface::new(&points, &whole, &[0.0, 1.0]);
    /// let [corners] = surface.passing().collect::<Vec<_>>().try_into().unwrap();
    /// assert!(corners.iter().all(|corner| corner.height.is_nan() == (corner.number == 2)));
    /// # Ok::<(), sweep_cdt::Error>(())
    /// ```
    pub fn passing(&self) -> impl Iterator<Item = [Corner; 3]> {
        let corner = |v: usize| Corner {
            number: v as u64,
            point: self.points[v].each_ref().map(Scalar::approx),
            height: self.heights[v],
        };
        let inside = self.interior.inside();
        inside.map(move |t| self.interior.triangulation().triangle(t).map(corner))
    }
}

/// Contour lines of triangles that pass.
///
/// ```
/// use sweep_cdt_terrain::{Corner, PassingContours};
///
/// let corner = |number, point, height| Corner { number, point, height };
/// let [a, b, c] = [corner(0, [0.0, 0.0], 0.0), corner(1, [4.0, 0.0], 4.0), corner(2, [0.0, 4.0], 0.0)];
/// let mut lines = Vec::new();
/// let mut contours = PassingContours::new(vec![1.0], usize::MAX);
/// contours.triangle([a, b, c], |line| lines.push(line.points));
/// for side in [[a, b], [b, c], [c, a]] {
///     contours.border(side, |line| lines.push(line.points));
/// }
/// assert_eq!(lines, [[[1.0, 3.0], [1.0, 0.0]]]);
/// ```
#[derive(Debug)]
pub struct PassingContours {
    levels: Vec<f64>,
    chains: Vec<Option<Chain>>,
    /// The places of `chains` that are free.
    free: Vec<usize>,
    /// The chains that begin at a crossing, and those that end there.
    from: HashMap<Crossing, usize>,
    to: HashMap<Crossing, usize>,
    /// How many points wait, how many may, and how many may before chains are cut next.
    waiting: usize,
    most: usize,
    limit: usize,
    parts: u64,
}

/// A place in the levels, and the numbers of the ends of the side: below, above.
type Crossing = (usize, [u64; 2]);

/// Pieces that follow each other.
#[derive(Debug)]
struct Chain {
    from: Option<Crossing>,
    to: Option<Crossing>,
    /// Without steps of no length.
    points: VecDeque<[f64; 2]>,
    /// The least crossing, and the point there.
    least: (Crossing, usize),
}

impl Chain {
    /// A chain whose last crossing is the first of another one, with that.
    fn followed_by(mut self, mut next: Chain) -> Chain {
        let shift = self.points.len() - 1;
        let least = self.least.min((next.least.0, next.least.1 + shift));
        let (from, to) = (self.from, next.to);
        let points = if self.points.len() < next.points.len() {
            self.points.pop_back();
            self.points
                .into_iter()
                .rev()
                .for_each(|point| next.points.push_front(point));
            next.points
        } else {
            self.points.extend(next.points.into_iter().skip(1));
            self.points
        };
        Chain {
            from,
            to,
            points,
            least,
        }
    }

    /// The points, if they are no single one; a closed line begins at its least crossing.
    fn line(self) -> Option<Vec<[f64; 2]>> {
        let mut points = Vec::from(self.points);
        if points.len() < 2 {
            return None;
        }
        if self.from.is_some() && self.from == self.to {
            points.pop();
            let least = self.least.1 % points.len();
            points.rotate_left(least);
            points.push(points[0]);
        }
        Some(points)
    }

    /// What it takes of the memory, in points.
    fn size(&self) -> usize {
        SHORT + self.points.len()
    }
}

impl PassingContours {
    /// The lines at these levels, which are sorted. If more points wait than `most`, lines are passed on in parts.
    #[must_use]
    pub fn new(levels: Vec<f64>, most: usize) -> PassingContours {
        PassingContours {
            levels,
            chains: Vec::new(),
            free: Vec::new(),
            from: HashMap::new(),
            to: HashMap::new(),
            waiting: 0,
            most,
            limit: most,
            parts: 0,
        }
    }

    /// How many lines were passed on that are parts of lines.
    #[must_use]
    pub fn parts(&self) -> u64 {
        self.parts
    }

    /// The next triangle, counter-clockwise. `out` gets the lines that are complete.
    pub fn triangle(&mut self, corners: [Corner; 3], mut out: impl FnMut(Contour)) {
        let heights = corners.map(|corner| corner.height);
        if heights.iter().any(|height| height.is_nan()) {
            // The surface ends at its sides.
            let [a, b, c] = corners;
            for side in [[b, a], [c, b], [a, c]] {
                self.border(side, &mut out);
            }
            return;
        }
        for level in crossing(heights.map(|height| above(&self.levels, height))) {
            let sides = piece(corners, heights, self.levels[level]);
            self.add(level, sides.map(|(_, ends)| Some(ends)), &mut out);
        }
    }

    /// A side of the border, which has the surface on its left: one of the hull. `out` gets the lines that are complete.
    pub fn border(&mut self, ends: [Corner; 2], mut out: impl FnMut(Contour)) {
        let [from, to] = ends.map(|end| end.height);
        if from.is_nan() || to.is_nan() {
            return;
        }
        for level in crossing([from, to].map(|height| above(&self.levels, height))) {
            let [a, b] = ends;
            let sides = match from < to {
                true => [Some([a, b]), None],
                false => [None, Some([b, a])],
            };
            self.add(level, sides, &mut out);
        }
    }

    /// Adds a chain between two sides, given as their ends below and above; none is the border.
    fn add(
        &mut self,
        level: usize,
        sides: [Option<[Corner; 2]>; 2],
        out: &mut impl FnMut(Contour),
    ) {
        let named = sides.map(|side| side.map(|ends| (level, ends.map(|end| end.number))));
        let mut points = VecDeque::new();
        for ends in sides.into_iter().flatten() {
            let heights = ends.map(|end| end.height);
            let point = place(self.levels[level], heights, ends.map(|end| end.point));
            if points.back() != Some(&point) {
                points.push_back(point);
            }
        }
        let at = |end: usize| named[end].map(|crossing| (crossing, end.min(points.len() - 1)));
        let least = at(0).into_iter().chain(at(1)).min();
        let [from, to] = named;
        let mut chain = Chain {
            from,
            to,
            least: least.expect("one side is none of the border"),
            points,
        };
        if let Some(before) = chain.from.and_then(|from| self.to.get(&from).copied()) {
            chain = self.take(before).followed_by(chain);
        }
        let is_closed = chain.from.is_some() && chain.from == chain.to;
        if let Some(next) = chain.to.and_then(|to| self.from.get(&to).copied())
            && !is_closed
        {
            chain = chain.followed_by(self.take(next));
        }
        if is_closed || chain.from.or(chain.to).is_none() {
            pass_on(self.levels[level], chain, out);
            return;
        }
        self.keep(chain);
        if self.waiting > self.limit {
            self.cut(out);
        }
    }

    /// Keeps a chain that waits.
    fn keep(&mut self, chain: Chain) {
        let at = self.free.pop().unwrap_or(self.chains.len());
        self.from.extend(chain.from.map(|from| (from, at)));
        self.to.extend(chain.to.map(|to| (to, at)));
        self.waiting += chain.size();
        if at == self.chains.len() {
            self.chains.push(None);
        }
        self.chains[at] = Some(chain);
    }

    /// Takes a chain that waits.
    fn take(&mut self, at: usize) -> Chain {
        let chain = self.chains[at].take().expect("a chain that waits");
        self.free.push(at);
        chain.from.map(|from| self.from.remove(&from));
        chain.to.map(|to| self.to.remove(&to));
        self.waiting -= chain.size();
        chain
    }

    /// Passes on the chains that are not short, and goes on where they begin and end.
    fn cut(&mut self, out: &mut impl FnMut(Contour)) {
        for at in 0..self.chains.len() {
            let is_long = |chain: &Chain| chain.points.len() > SHORT;
            if !self.chains[at].as_ref().is_some_and(is_long) {
                continue;
            }
            let chain = self.take(at);
            let [first, last] = [chain.points[0], chain.points[chain.points.len() - 1]];
            let end = |from: Option<Crossing>, to: Option<Crossing>, point| {
                let least = (from.or(to)?, 0);
                let points = VecDeque::from([point]);
                Some(Chain {
                    from,
                    to,
                    points,
                    least,
                })
            };
            let ends = [end(chain.from, None, first), end(None, chain.to, last)];
            ends.into_iter().flatten().for_each(|end| self.keep(end));
            let level = self.levels[chain.least.0.0];
            pass_on(
                level,
                Chain {
                    from: None,
                    ..chain
                },
                out,
            );
            self.parts += 1;
        }
        // Where the chains are short and many, nothing is gained before there are twice as many.
        self.limit = self.most.max(2 * self.waiting);
    }
}

/// Passes on the line along a chain, if it is one.
fn pass_on(level: f64, chain: Chain, out: &mut impl FnMut(Contour)) {
    if let Some(points) = chain.line() {
        out(Contour { level, points });
    }
}
