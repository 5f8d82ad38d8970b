//! The verifier of streams: is this list of triangles, read once, the constrained Delaunay triangulation?
//!
//! The verifier keeps the sides whose other triangle has not come, and the vertices that may still be named ([`forget`]).
//! In the order of a sweep that is the width of the stream; in any other order more is kept, and the verdict is the same.
//! With the sweep and with [`Stream`](crate::Stream) it shares the predicates of [`scalar`](sweep_cdt::scalar) alone.
//!
//! | | check | when |
//! |---|---|---|
//! | 1 | coordinates are finite, numbers are new, and name vertices that have come | at once |
//! | 2 | each triangle turns left, strictly | at once |
//! | 3 | two triangles at one side pass it in opposite directions | when the second comes |
//! | 4 | where triangles say which sides are constrained, both say alike; a side that is no part of an edge is locally Delaunay | when the second comes |
//! | 5 | each edge is a chain of sides; a side that is said to be constrained, or is not Delaunay, is a part of an edge ([`chains`]) | as soon as sides and edges have come |
//! | 6 | the sides with one triangle are one convex polygon, passed once ([`border`]) | at the end |
//! | 7 | each vertex is a corner, or one that is declared to equal it is | at the end |
//!
//! # Why that proves it
//! Around a point q on no side count the triangles. They turn left (2), so the count is the sum of the winding numbers
//! of their borders. Sides with two triangles cancel (3), and no matter how sides are paired if more than two triangles
//! have one: what is left is the winding number of the border, which is 1 inside a convex polygon that is passed once, and
//! 0 outside (6). So the triangles cover the polygon once, and pairs are neighbors. All vertices are corners (7), so the
//! polygon is their hull. That local tests suffice (4), for ties too, stands in [`verify`](mod@sweep_cdt::verify).
//!
//! Cost: some ten look-ups a triangle, 1,400 instructions in all.

mod border;
mod chains;
mod forget;
mod records;
mod violation;

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::fmt;

pub use violation::StreamViolation;

use self::border::upward;
use self::records::{Map, Open, Place, Vertex, Vertices};
use sweep_cdt::scalar::{Scalar, in_circle, orient2d};
use sweep_cdt::verify::Level;

/// What a stream has shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct StreamReport {
    /// Triangles that have come.
    pub triangles: u64,
    /// Vertices that have come, with duplicates.
    pub vertices: u64,
    /// Edges that have come.
    pub edges: u64,
    /// Sides of the hull.
    pub hull_sides: u64,
    /// Most vertices that were kept, with duplicates.
    pub most_vertices: usize,
    /// Most sides that were kept.
    pub most_sides: usize,
}

/// Verifies a triangulation that comes as a stream.
///
/// The verifier accepts what [`Verifier`](sweep_cdt::verify::Verifier) accepts, in every order of triangles, and says what it finds first; that
/// one lists all. What it asks for, since it reads once:
///
/// - Vertices come before what names them, with numbers of any kind.
/// - A vertex that equals another is declared a [`duplicate`](Self::duplicate) of it, before triangles go all the way
///   round that place. Triangles and edges may name either.
/// - [Edges](Self::edge) come before triangles; or each with its lower end, in the order of a sweep.
///
/// ```
/// use sweep_cdt_stream::StreamVerifier;
///
/// let mut verifier = StreamVerifier::new();
/// for (number, point) in (0..).zip([[0, 0], [4, 0], [4, 3], [0, 3]]) {
///     verifier.vertex(number, point)?;
/// }
/// verifier.edge(9, 0, [4, 3])?;
/// verifier.triangle([0, 1, 2], None)?;
/// verifier.triangle([0, 2, 3], None)?;
/// assert_eq!(verifier.finish()?.hull_sides, 4);
/// # Ok::<(), sweep_cdt_stream::StreamViolation>(())
/// ```
pub struct StreamVerifier<S> {
    level: Level,
    vertices: Vertices<S>,
    /// The sides with one triangle, by the slots of both ends, the lower one first.
    open: Map<[usize; 2], Open<S>>,
    report: StreamReport,
    /// For each duplicate that may still be named, the vertex that it equals.
    duplicates: Map<u64, u64>,
    /// The highest corner of a triangle, by y, then x.
    highest: Option<[S; 2]>,
    /// How many edges that wait end at a place.
    ends: BTreeMap<Place<S>, usize>,
    /// Vertices that may be closed now.
    loose: Vec<u64>,
}

impl<S: Scalar + Clone> Default for StreamVerifier<S> {
    fn default() -> Self {
        StreamVerifier::new()
    }
}

impl<S: Scalar + Clone> StreamVerifier<S> {
    /// A verifier that asks for the canonical triangulation.
    pub fn new() -> Self {
        StreamVerifier {
            level: Level::Canonical,
            vertices: Vertices::new(),
            open: Map::default(),
            report: StreamReport::default(),
            duplicates: Map::default(),
            highest: None,
            ends: BTreeMap::new(),
            loose: Vec::new(),
        }
    }

    /// Asks for this level, before anything comes.
    #[must_use]
    pub fn level(mut self, level: Level) -> Self {
        self.level = level;
        self
    }

    /// A vertex with its number, before anything that names it. One number must name one vertex; whether it was given
    /// before is checked while the vertex is kept.
    ///
    /// # Errors
    /// A coordinate that is not finite, or a number that was given before.
    pub fn vertex(&mut self, number: u64, point: [S; 2]) -> Result<(), StreamViolation> {
        if !point.iter().all(S::is_finite) {
            return Err(StreamViolation::NonFiniteCoordinate { vertex: number });
        }
        self.is_new(number)?;
        self.vertices.insert(Vertex::new(number, point));
        self.count_vertex();
        Ok(())
    }

    /// A vertex that equals vertex `of`, before triangles go all the way round it. Either may be named in place of the
    /// other.
    ///
    /// # Errors
    /// Vertex `of` is not known, or lies elsewhere; or as [`vertex`](Self::vertex).
    pub fn duplicate(
        &mut self,
        number: u64,
        point: &[S; 2],
        of: u64,
    ) -> Result<(), StreamViolation> {
        let first = self.known(of)?;
        let place = &self.vertices.at(first).point;
        if (0..2).any(|axis| place[axis].compare(&point[axis]).is_ne()) {
            return Err(StreamViolation::NoDuplicate { vertex: number, of });
        }
        self.is_new(number)?;
        let vertex = self.vertices.at_mut(first);
        vertex.duplicates.push(number);
        self.duplicates.insert(number, vertex.number);
        self.count_vertex();
        Ok(())
    }

    fn count_vertex(&mut self) {
        self.report.vertices += 1;
        let kept = self.vertices.len() + self.duplicates.len();
        self.report.most_vertices = self.report.most_vertices.max(kept);
    }

    /// Whether a vertex has come, and is not forgotten.
    pub fn has_vertex(&self, number: u64) -> bool {
        self.vertices.slot(number).is_some() || self.duplicates.contains_key(&number)
    }

    fn is_new(&self, number: u64) -> Result<(), StreamViolation> {
        let error = StreamViolation::RepeatedVertex { vertex: number };
        if self.has_vertex(number) {
            Err(error)
        } else {
            Ok(())
        }
    }

    /// The slot of the vertex of a number.
    fn known(&self, number: u64) -> Result<usize, StreamViolation> {
        let first = *self.duplicates.get(&number).unwrap_or(&number);
        let slot = self.vertices.slot(first);
        slot.ok_or(StreamViolation::UnknownVertex { vertex: number })
    }

    /// A triangle, and whether the side opposite each corner is an edge or a piece of one, if that is to be verified too:
    /// by all triangles or by none, and at a level that asks for edges.
    ///
    /// # Errors
    /// What this triangle shows to be wrong: [`StreamViolation`].
    pub fn triangle(
        &mut self,
        corners: [u64; 3],
        constrained: Option<[bool; 3]>,
    ) -> Result<(), StreamViolation> {
        let [a, b, c] = corners;
        let slots = [self.known(a)?, self.known(b)?, self.known(c)?];
        let found = slots.map(|slot| self.vertices.at(slot));
        let points = found.map(|vertex| vertex.point.clone());
        let numbers = found.map(|vertex| vertex.number);
        let are_used = found.map(|vertex| vertex.is_used);
        let [p, q, r] = &points;
        if orient2d(p, q, r).is_le() {
            return Err(StreamViolation::NotLeft { corners });
        }
        for i in (0..3).filter(|&i| !are_used[i]) {
            self.vertices.at_mut(slots[i]).is_used = true;
            let is_below = |highest| upward(&points[i], highest).is_le();
            if !self.highest.as_ref().is_some_and(is_below) {
                self.highest = Some(points[i].clone());
            }
        }
        let constrained = constrained.filter(|_| self.level >= Level::Constrained);
        for side in 0..3 {
            let [i, j] = [(side + 1) % 3, (side + 2) % 3];
            self.side(
                [slots[i], slots[j]],
                [numbers[i], numbers[j]],
                [&points[i], &points[j], &points[side]],
                constrained.map(|sides| sides[side]),
            )?;
        }
        self.report.triangles += 1;
        self.report.most_sides = self.report.most_sides.max(self.open.len());
        self.forget();
        Ok(())
    }

    /// A vertex that is known.
    fn at(&mut self, number: u64) -> &mut Vertex<S> {
        let vertex = self.vertices.get_mut(number);
        vertex.expect("a vertex that has come")
    }

    /// A side of a triangle, in its direction: the slots and numbers of its ends, where they and the corner opposite are.
    fn side(
        &mut self,
        [u, v]: [usize; 2],
        side: [u64; 2],
        places: [&[S; 2]; 3],
        is_constrained: Option<bool>,
    ) -> Result<(), StreamViolation> {
        let ends = [places[0], places[1]];
        let (key, is_upward) = ([u.min(v), u.max(v)], u < v);
        let Some(other) = self.open.remove(&key) else {
            let apex = places[2].clone();
            self.open.insert(
                key,
                Open {
                    apex,
                    is_upward,
                    is_constrained,
                },
            );
            for end in key {
                self.vertices.at_mut(end).open += 1;
            }
            if is_constrained.unwrap_or(!self.ends.is_empty()) {
                self.offer(side, ends, is_constrained == Some(true));
            }
            return Ok(());
        };
        if other.is_upward == is_upward {
            return Err(StreamViolation::RepeatedSide { side });
        }
        if other.is_constrained != is_constrained {
            return Err(StreamViolation::HalfConstrained { side });
        }
        for end in key {
            let vertex = self.vertices.at_mut(end);
            vertex.open -= 1;
            if vertex.open == 0 {
                self.loose.push(vertex.number);
            }
        }
        let fault = match is_constrained {
            Some(true) => None,
            _ => self.local_fault(side, places, &other.apex),
        };
        match fault {
            Some(fault) if is_constrained.is_some() || !self.must_be_taken(side, ends, fault) => {
                Err(fault)
            }
            _ => Ok(()),
        }
    }

    /// What is wrong with a side between two triangles that is no part of an edge. The corners on its left run `p`, `q`,
    /// `apex`.
    fn local_fault(
        &self,
        side: [u64; 2],
        [p, q, apex]: [&[S; 2]; 3],
        other: &[S; 2],
    ) -> Option<StreamViolation> {
        if self.level < Level::Delaunay {
            return None;
        }
        match in_circle(p, q, apex, other) {
            Ordering::Greater => Some(StreamViolation::NotDelaunay { side }),
            Ordering::Equal if self.level >= Level::Canonical => {
                let all = [p, q, apex, other];
                let first = all.into_iter().min_by(|a, b| from_left(a, b))?;
                let ends_at = |end: &[S; 2]| from_left(first, end).is_eq();
                let is_first = ends_at(p) || ends_at(q);
                (!is_first).then_some(StreamViolation::NotCanonical { side })
            }
            _ => None,
        }
    }

    /// The end of the stream.
    ///
    /// # Errors
    /// What is missing, or what the whole shows to be wrong.
    pub fn finish(mut self) -> Result<StreamReport, StreamViolation> {
        if self.report.triangles == 0 {
            border::all_on_one_line(&self.vertices)?;
            return Ok(self.report);
        }
        let unused = self.vertices.iter().filter(|vertex| !vertex.is_used);
        if let Some(vertex) = unused.map(|vertex| vertex.number).min() {
            return Err(StreamViolation::UnusedVertex { vertex });
        }
        self.report.hull_sides = border::convex(&self.open, &self.vertices)?;
        self.no_chain_is_broken()?;
        Ok(self.report)
    }
}

/// From left to right, of points with equal x from above.
fn from_left<S: Scalar>(a: &[S; 2], b: &[S; 2]) -> Ordering {
    a[0].compare(&b[0]).then_with(|| b[1].compare(&a[1]))
}

impl<S> fmt::Debug for StreamVerifier<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("StreamVerifier")
            .field("level", &self.level)
            .field("report", &self.report)
            .finish_non_exhaustive()
    }
}
