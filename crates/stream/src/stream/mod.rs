//! Triangulating a stream: vertices in the order of the sweep go in, triangles that are final come out, and what
//! nothing names any more is forgotten.
//!
//! The sweep's order is a stream's order. What lies far below the sweep line cannot change any more, as Isenburg, Liu,
//! Shewchuk and Snoeyink (2006) use for points without edges. Here the vertices are collected in a *window*. When it is
//! full, it is triangulated by the sweep, with the edges that have ended; triangles that no vertex to come can change
//! are final (`finality.rs`) and retire (`retire.rs`); the others stay, and their vertices begin the next window:
//!
//! ```text
//!      . .   .  .    .  .    vertices to come
//!     ---------------------  the sweep line
//!     \/\/\/\/\/\/\/\/\/\/\  alive: they may still change
//!     *--*---*--*--*---*--*  the border: sides that are final
//!      ▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒   final: passed on and forgotten
//! ```
//!
//! **Why the result is the one in memory.** A side between a final and a living triangle is a side of the whole result,
//! and stays one: so it may be declared an edge, and nothing changes. (Where four vertices on one circle leave a choice,
//! all triangles on the circle hold the first corner, which decides on either side of the new edge as it did before.)
//! Edges are all that lets one part of a constrained Delaunay triangulation depend on another. So the border's sides as
//! edges stand for all that was forgotten. The window's triangulation also covers what lies beyond the border; these
//! triangles are marked from the border, and thrown away.
//!
//! **Edges** become edges of the window when their upper end has come. What they pierce waits for that (`corridor.rs`),
//! and their insertion changes nothing else. An edge to come has both ends at or above the line, and pierces nothing
//! below it.
//!
//! **Departure from the paper:** the paper sweeps once. Here the living part is swept again with the next window, which
//! costs the share of the window that is alive, an eighth by default. In exchange the sweep stays as it is, with all its
//! fronts, scalars and nets, and pays nothing.
//!
//! **Cost:** the time of the sweep, and memory for one window: its vertices and what is alive. Where the data keep
//! everything alive (one circle, a comb), windows grow with it, twofold each time, so that the time stays that of the
//! sweep.

mod bands;
mod carried;
mod corridor;
mod error;
mod finality;
mod rest;
mod rest_file;
mod retire;
mod stats;
mod swept;
mod window;

use std::fmt;
use std::mem;

pub use bands::settle_all;
pub use carried::Carried;
pub use error::StreamError;
pub use rest::{Cut, Rest};
pub use rest_file::RestError;
pub use retire::Final;
pub use stats::{Alive, StreamStats};

use corridor::{Path, corridors};
use finality::Line;
use retire::Retired;
use sweep_cdt::front::FrontSearch;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::trace::Event;
use sweep_cdt::{Session, Triangulator};
use swept::{Steps, Swept};
use window::{Pending, Window};

/// So many new vertices a window has at least, if the caller does not say, and so many for each vertex that is alive.
/// At most an eighth of a window has then been swept before.
const WINDOW: usize = 1 << 15;
const SHARE: usize = 7;

/// A triangulation of a stream.
///
/// Vertices are pushed in the order of the sweep, by y and then by x, with numbers of the caller's choice. Edges follow
/// their lower end at once. The closure gets what is final, each once: as a set it is what
/// [`Triangulator::triangulate`] finds for all points and edges together, with the constrained sides and the hull.
///
/// Say [`between`](Stream::between) which x the vertices lie, if you know. Otherwise thin triangles along the left and
/// right of the hull wait for the end.
///
/// ```
/// use sweep_cdt::Triangulator;
/// use sweep_cdt_stream::{Final, Stream};
///
/// let points = [[0, 0], [4, 0], [2, 1], [0, 3], [4, 4]];
/// let mut triangles = Vec::new();
/// let mut stream = Stream::new(Triangulator::new(), |found| {
///     if let Final::Triangle { corners, .. } = found {
///         triangles.push(corners);
///     }
/// });
/// for (number, point) in (100..).zip(points) {
///     stream.push(number, point)?;
///     if number == 100 {
///         // An edge from vertex 100, with a number of its own, to the vertex that will be at (4, 4).
///         stream.edge(7, [4, 4])?;
///     }
/// }
/// let stats = stream.finish()?;
/// assert_eq!((stats.vertices, stats.triangles, triangles.len()), (5, 4, 4));
/// # Ok::<(), sweep_cdt_stream::StreamError>(())
/// ```
pub struct Stream<'a, S, O> {
    session: Session,
    out: O,
    front: Option<&'a mut dyn FrontSearch>,
    steps: Option<Box<Steps<'a>>>,
    window: Window<S>,
    /// The vertices lie between these two x.
    between: Option<[S; 2]>,
    /// New vertices of a window, if the caller says.
    size: Option<usize>,
    /// So many vertices may be alive.
    limit: usize,
    stats: StreamStats,
    /// What has ended the stream.
    failed: Option<StreamError>,
}

impl<'a, S: Scalar + Clone, O: FnMut(Final)> Stream<'a, S, O> {
    /// A stream with these settings, which passes on to `out` what is final.
    pub fn new(triangulator: Triangulator, out: O) -> Self {
        Stream {
            session: triangulator.session(),
            out,
            front: None,
            steps: None,
            window: Window::default(),
            between: None,
            size: None,
            limit: usize::MAX,
            stats: StreamStats::default(),
            failed: None,
        }
    }

    /// Uses this search structure for the advancing front of each window.
    #[must_use]
    pub fn front(mut self, front: &'a mut dyn FrontSearch) -> Self {
        self.front = Some(front);
        self
    }

    /// Each window gets so many new vertices, at least one, or as many as are alive if these are more. By default a window
    /// gets 32,768, or seven times as many as are alive. Small windows take less memory and more time.
    #[must_use]
    pub fn window(mut self, vertices: usize) -> Self {
        self.size = Some(vertices.max(1));
        self
    }

    /// All vertices, and the upper ends of all edges, lie between these two x, inclusive.
    #[must_use]
    pub fn between(mut self, least: S, most: S) -> Self {
        self.between = Some([least, most]);
        self
    }

    /// Passes on each step of the sweep through each window, as [`Watch::events`](sweep_cdt::Watch::events) does for an input, before what is
    /// final after it.
    ///
    /// An event names vertices by their positions in the window, and the closure gets the caller's number of each. A window
    /// that is wider than high is swept from left to right: read x for y in the paper's words, and triangles are clockwise.
    ///
    /// ```
    /// use sweep_cdt::trace::{Event, Vertex};
    /// use sweep_cdt::Triangulator;
    /// use sweep_cdt_stream::Stream;
    ///
    /// // The points are farther apart by x than by y, so they are met from left to right.
    /// let mut met = Vec::new();
    /// let stream = Stream::new(Triangulator::new(), |_| {});
    /// let mut stream = stream.observe(|event, numbers| {
    ///     if let Event::Point { vertex: Vertex::Input(v), .. } = event {
    ///         met.push(numbers[v as usize]);
    ///     }
    /// });
    /// for (number, point) in (10..).zip([[0, 0], [1, 1], [0, 3], [9, 4], [3, 5]]) {
    ///     stream.push(number, point)?;
    /// }
    /// stream.finish()?;
    /// assert_eq!(met, [12, 11, 14, 13]);
    /// # Ok::<(), sweep_cdt_stream::StreamError>(())
    /// ```
    #[must_use]
    pub fn observe(mut self, steps: impl FnMut(Event, &[u64]) + 'a) -> Self {
        self.steps = Some(Box::new(steps));
        self
    }

    /// Ends the stream with [`StreamError::TooMuchAlive`] where more vertices stay alive after a window.
    #[must_use]
    pub fn limit(mut self, vertices: usize) -> Self {
        self.limit = vertices;
        self
    }

    /// The next vertex, with its number: after the last one by y, then by x. A vertex equal to the last one is a
    /// duplicate, which the closure is told; edges that follow it begin at the first one.
    ///
    /// # Errors
    /// [`StreamError`]: a coordinate that is not finite, a vertex before its predecessor or beyond the range of x, an
    /// edge whose upper end did not come, and what [`Error`](sweep_cdt::Error) names, for a window. What has been passed on
    /// before is right. All later calls return the error again.
    pub fn push(&mut self, number: u64, point: [S; 2]) -> Result<(), StreamError> {
        self.ended()?;
        let pushed = self.try_push(number, point);
        self.keep(pushed)
    }

    fn try_push(&mut self, number: u64, point: [S; 2]) -> Result<(), StreamError> {
        if !point.iter().all(S::is_finite) {
            return Err(StreamError::NonFiniteCoordinate { vertex: number });
        }
        if let Some((last, of)) = self.window.last() {
            match window::sweep_order(&point, last) {
                std::cmp::Ordering::Less => return Err(StreamError::Unsorted { vertex: number }),
                std::cmp::Ordering::Equal => {
                    self.stats.duplicates += 1;
                    (self.out)(Final::Duplicate { number, of });
                    return Ok(());
                }
                std::cmp::Ordering::Greater => {}
            }
        }
        if !finality::is_between(&point, self.between.as_ref()) {
            return Err(StreamError::OutsideRange { vertex: number });
        }
        if let Some(edge) = self.window.missed_by(&point) {
            return Err(StreamError::MissingEnd { edge });
        }
        if self.window.fresh() >= self.full() {
            let before = self.window.points.len();
            self.retire(Some(&point))?;
            // Memory for no more than came before, whatever the caller says.
            self.window.reserve(self.full().min(before));
        }
        self.window.push(number, point);
        self.stats.vertices += 1;
        Ok(())
    }

    /// How many new vertices the window gets.
    fn full(&self) -> usize {
        let kept = self.window.kept();
        self.size
            .map_or(WINDOW.max(SHARE * kept), |size| size.max(kept))
    }

    /// An edge from the vertex that was pushed last to a vertex that is to come, at `upper`. Edges of no length are left
    /// out.
    ///
    /// # Errors
    /// [`StreamError`]: no vertex has been pushed, or `upper` is not finite, before the vertex, or beyond the range of x.
    pub fn edge(&mut self, number: u64, upper: [S; 2]) -> Result<(), StreamError> {
        self.ended()?;
        let added = self.try_edge(number, upper);
        self.keep(added)
    }

    fn try_edge(&mut self, number: u64, upper: [S; 2]) -> Result<(), StreamError> {
        let is_finite = upper.iter().all(S::is_finite);
        let order = self
            .window
            .last()
            .map(|(last, _)| window::sweep_order(&upper, last));
        match order {
            Some(std::cmp::Ordering::Equal) => return Ok(()),
            Some(std::cmp::Ordering::Greater)
                if is_finite && finality::is_between(&upper, self.between.as_ref()) => {}
            _ => return Err(StreamError::BadEdge { edge: number }),
        }
        self.window.add_edge(number, upper);
        self.stats.edges += 1;
        Ok(())
    }

    /// The end of the stream: all that is left is final.
    ///
    /// # Errors
    /// [`StreamError`], as [`push`](Stream::push).
    pub fn finish(mut self) -> Result<StreamStats, StreamError> {
        self.ended()?;
        if let Some(edge) = self.window.waiting() {
            return Err(StreamError::MissingEnd { edge });
        }
        self.retire(None)?;
        Ok(self.stats)
    }

    /// What has come and gone so far, and what is alive.
    pub fn stats(&self) -> &StreamStats {
        &self.stats
    }

    /// The numbers of the vertices that what is to come may name: those that are alive, and those that have come since the
    /// last window, in any order.
    pub fn vertices(&self) -> &[u64] {
        self.window.numbers()
    }

    /// Triangulates the window, and passes on what is final now that `next` is the next vertex.
    fn retire(&mut self, next: Option<&[S; 2]>) -> Result<(), StreamError> {
        let line = next.map(|next| Line::new(next, self.between.as_ref()));
        let mut window = mem::take(&mut self.window);
        let front = self.front.as_mut().map(|front| &mut **front as _);
        let steps = self.steps.as_deref_mut();
        let swept = Swept::sweep(&mut window, &mut self.session, front, steps);
        let swept = swept.map_err(|error| window.renumbered(error))?;
        let paths: Vec<_> = window
            .pending()
            .map(|(end, Pending { from, edge })| Path {
                edge,
                line: [&window.points[from], end],
                start: Some(from),
            })
            .collect();
        let corridors = corridors(&window.points, &swept, &paths);
        let retired = retire::retire(window, &swept, line.as_slice(), corridors, &mut |found| {
            found.count(&mut self.stats);
            (self.out)(found);
        });
        let Retired { window, alive, .. } = retired;
        self.window = window;
        self.stats.after(1, alive);
        StreamError::refuse(alive, self.limit)
    }

    fn ended(&self) -> Result<(), StreamError> {
        self.failed.map_or(Ok(()), Err)
    }

    fn keep(&mut self, done: Result<(), StreamError>) -> Result<(), StreamError> {
        self.failed = done.err();
        done
    }
}

impl<S, O> fmt::Debug for Stream<'_, S, O> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Stream")
            .field("size", &self.size)
            .field("limit", &self.limit)
            .field("stats", &self.stats)
            .finish_non_exhaustive()
    }
}
