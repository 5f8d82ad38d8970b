//! The window: vertices that have come and are needed, edges among them, edges that have begun, and the border of what
//! is final.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use super::error::StreamError;
use sweep_cdt::Error;
use sweep_cdt::scalar::Scalar;

/// The order of the sweep: by y, then by x.
pub(super) fn sweep_order<S: Scalar>(a: &[S; 2], b: &[S; 2]) -> Ordering {
    a[1].compare(&b[1]).then_with(|| a[0].compare(&b[0]))
}

/// A position in a window; what is too many for 32 bits, the sweep has refused.
pub(super) fn narrow(position: usize) -> u32 {
    u32::try_from(position).expect("a window's size is checked")
}

/// A side or edge of the window.
#[derive(Clone, Copy, Debug)]
pub(super) struct Origin {
    /// The edge that it is a piece of.
    pub(super) edge: Option<u64>,
    /// Whether it is a side of the border: what is right of it, from its first end to its second, is final.
    pub(super) is_border: bool,
}

/// A point by its place in the sweep.
#[derive(Debug)]
struct Place<S>([S; 2]);

impl<S: Scalar> Ord for Place<S> {
    fn cmp(&self, other: &Self) -> Ordering {
        sweep_order(&self.0, &other.0)
    }
}

impl<S: Scalar> PartialOrd for Place<S> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<S: Scalar> PartialEq for Place<S> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl<S: Scalar> Eq for Place<S> {}

/// An edge whose upper end has not come.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pending {
    /// The last vertex that is known to lie on the edge; the part below it is among the window's edges.
    pub(super) from: usize,
    pub(super) edge: u64,
}

/// What is alive, and what has come since.
#[derive(Debug)]
pub(super) struct Window<S> {
    pub(super) points: Vec<[S; 2]>,
    /// The caller's number of each vertex.
    numbers: Vec<u64>,
    /// Pairs of vertices.
    pub(super) edges: Vec<[usize; 2]>,
    /// What each edge is.
    pub(super) origins: Vec<Origin>,
    /// The first so many vertices were in the last window too.
    kept: usize,
    /// The edges that have begun and not ended, by their upper ends.
    pending: BTreeMap<Place<S>, Vec<Pending>>,
    /// The vertex that was pushed last, in this window.
    last: Option<usize>,
}

impl<S> Default for Window<S> {
    fn default() -> Self {
        Window {
            points: Vec::new(),
            numbers: Vec::new(),
            edges: Vec::new(),
            origins: Vec::new(),
            kept: 0,
            pending: BTreeMap::new(),
            last: None,
        }
    }
}

impl<S: Scalar + Clone> Window<S> {
    /// The vertex that was pushed last, and its number.
    pub(super) fn last(&self) -> Option<(&[S; 2], u64)> {
        self.last.map(|v| (&self.points[v], self.numbers[v]))
    }

    /// How many vertices come from the last window.
    pub(super) fn kept(&self) -> usize {
        self.kept
    }

    /// How many vertices are new.
    pub(super) fn fresh(&self) -> usize {
        self.points.len() - self.kept
    }

    /// Makes room for so many new vertices.
    pub(super) fn reserve(&mut self, vertices: usize) {
        self.points.reserve_exact(vertices);
        self.numbers.reserve_exact(vertices);
    }

    /// The edges that have begun and not ended, with their upper ends.
    pub(super) fn pending(&self) -> impl Iterator<Item = (&[S; 2], Pending)> + '_ {
        let ends = self.pending.iter();
        ends.flat_map(|(end, edges)| edges.iter().map(|&edge| (&end.0, edge)))
    }

    /// The caller's number of each vertex.
    pub(super) fn numbers(&self) -> &[u64] {
        &self.numbers
    }

    pub(super) fn number(&self, v: usize) -> u64 {
        self.numbers[v]
    }

    /// An edge whose upper end should have come before this vertex.
    pub(super) fn missed_by(&self, next: &[S; 2]) -> Option<u64> {
        let (first, _) = self.pending.first_key_value()?;
        let is_missed = sweep_order(&first.0, next).is_lt();
        is_missed.then(|| self.waiting()).flatten()
    }

    /// An edge whose upper end has not come.
    pub(super) fn waiting(&self) -> Option<u64> {
        let (_, edges) = self.pending.first_key_value()?;
        edges.iter().map(|pending| pending.edge).min()
    }

    /// Whether the points lie farther apart by x than by y.
    pub(super) fn is_wide(&self) -> bool {
        let [width, height] = [0, 1].map(|axis| {
            let numbers = self.points.iter().map(|point| point[axis].approx());
            let range = [f64::INFINITY, f64::NEG_INFINITY];
            let [least, most] = numbers.fold(range, |[a, b], x| [a.min(x), b.max(x)]);
            most - least
        });
        width > height
    }

    /// Exchanges x and y of all points.
    pub(super) fn exchange_coordinates(&mut self) {
        for point in &mut self.points {
            point.reverse();
        }
    }

    /// Brings the vertices into this order; `place` says where each is then.
    pub(super) fn reorder(&mut self, order: &[u32], place: &[u32]) {
        let vertices = || order.iter().map(|&v| v as usize);
        self.points = vertices().map(|v| self.points[v].clone()).collect();
        self.numbers = vertices().map(|v| self.numbers[v]).collect();
        let of_pending = self.pending.values_mut().flatten();
        let of_pending = of_pending.map(|pending| &mut pending.from);
        for v in self.edges.as_flattened_mut().iter_mut().chain(of_pending) {
            *v = place[*v] as usize;
        }
        self.last = self.last.map(|v| place[v] as usize);
    }

    /// Adds a vertex, which follows the last one, and the edges that end there.
    pub(super) fn push(&mut self, number: u64, point: [S; 2]) {
        let v = self.points.len();
        let place = Place(point);
        let ending = match self.pending.is_empty() {
            true => None,
            false => self.pending.remove(&place),
        };
        for Pending { from, edge } in ending.unwrap_or_default() {
            self.connect([from, v], edge);
        }
        self.points.push(place.0);
        self.numbers.push(number);
        self.last = Some(v);
    }

    /// Adds an edge from the last vertex to one at `upper`, which is to come.
    pub(super) fn add_edge(&mut self, edge: u64, upper: [S; 2]) {
        if let Some(from) = self.last {
            let at_end = self.pending.entry(Place(upper)).or_default();
            at_end.push(Pending { from, edge });
        }
    }

    /// Adds an edge, or a piece of one, between two vertices.
    pub(super) fn connect(&mut self, ends: [usize; 2], edge: u64) {
        self.edges.push(ends);
        self.origins.push(Origin {
            edge: Some(edge),
            is_border: false,
        });
    }

    /// Adds another window, whose vertices follow these; both are without pending edges.
    pub(super) fn append(&mut self, above: Window<S>) {
        let shift = self.points.len();
        self.points.extend(above.points);
        self.numbers.extend(above.numbers);
        let shifted = above.edges.into_iter().map(|ends| ends.map(|v| v + shift));
        self.edges.extend(shifted);
        self.origins.extend(above.origins);
        self.kept = self.points.len();
    }

    /// The window that follows, where nothing is forgotten.
    pub(super) fn whole(mut self) -> Self {
        self.kept = self.points.len();
        self
    }

    /// The window that follows: the vertices that are marked, with these edges between them. `reached` gets their new
    /// positions; the last ones are the vertices from which the pending edges go on, in their order.
    pub(super) fn followed_by(
        self,
        is_kept: &[bool],
        mut edges: Vec<[usize; 2]>,
        origins: Vec<Origin>,
        reached: &mut [[Option<usize>; 2]],
    ) -> Self {
        let mut place = vec![0; is_kept.len()];
        let mut next = Window::default();
        let vertices = self.points.into_iter().zip(self.numbers);
        for (v, (point, number)) in vertices.enumerate() {
            if is_kept[v] {
                place[v] = next.points.len();
                next.points.push(point);
                next.numbers.push(number);
            }
        }
        for v in edges.as_flattened_mut() {
            *v = place[*v];
        }
        next.kept = next.points.len();
        next.edges = edges;
        next.origins = origins;
        next.pending = self.pending;
        for v in reached.as_flattened_mut().iter_mut().flatten() {
            *v = place[*v];
        }
        let of_pending = next.pending.values_mut().flatten();
        for (pending, &mut [_, last]) in of_pending.zip(reached) {
            pending.from = last.unwrap_or(pending.from);
        }
        next
    }

    /// The error of the window's triangulation with the caller's numbers.
    pub(super) fn renumbered(&self, error: Error) -> StreamError {
        match error {
            Error::CrossingEdges { edges } => match edges.map(|e| self.origins[e].edge) {
                [Some(e), Some(g)] => StreamError::CrossingEdges {
                    edges: [e.min(g), e.max(g)],
                },
                // Sides of the border cross nothing.
                _ => StreamError::Window(error),
            },
            error => StreamError::Window(error),
        }
    }
}
