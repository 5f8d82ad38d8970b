//! What is final leaves the window, and what is alive begins the next one.
//!
//! The window's triangulation covers more than what is alive: beyond the border lie triangles among its vertices that
//! stand for nothing. Those at the border are known by its sides, which have what is final on their right; the others
//! are reached from them without crossing the border. Beyond a side of the hull lies a *ghost*, as if it were a
//! triangle: it is alive while vertices may come there.
//!
//! Why it is right: the border is closed, but for the hull. A part of the triangulation that no side of the border
//! touches is thus all of it. Each side between a living triangle or ghost and one that is not becomes a side of the next
//! border, so that the living part is again all that lies left of the border.
//!
//! Cost: one pass over the triangles of the window; memory: a byte a triangle.

use super::corridor::Corridors;
use super::finality::Line;
use super::stats::{Alive, StreamStats};
use super::swept::Swept;
use super::window::{Origin, Window, narrow};
use sweep_cdt::scalar::Scalar;

/// What is passed on by a stream, by the caller's numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Final {
    /// A triangle.
    Triangle {
        /// The vertices, counter-clockwise.
        corners: [u64; 3],
        /// Whether the side opposite each corner is an edge or a piece of one.
        constrained: [bool; 3],
    },
    /// A side of the convex hull, which is on its left.
    HullSide {
        /// The ends.
        ends: [u64; 2],
    },
    /// A vertex that equals its predecessor.
    Duplicate {
        /// The vertex.
        number: u64,
        /// The first vertex at this place, which stands for both.
        of: u64,
    },
}

impl Final {
    /// Counts what is passed on.
    pub(super) fn count(&self, stats: &mut StreamStats) {
        match self {
            Final::Triangle { .. } => stats.triangles += 1,
            Final::HullSide { .. } => stats.hull_sides += 1,
            Final::Duplicate { .. } => {}
        }
    }
}

/// What becomes of a triangle.
#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    Alive,
    /// Alive until edges have ended.
    Held,
    /// Final since now.
    Final,
    /// Beyond the border.
    Beyond,
}

/// The window that follows.
pub(super) struct Retired<S> {
    pub(super) window: Window<S>,
    /// [`Corridors::reached`], by the vertices of this window.
    pub(super) reached: Vec<[Option<usize>; 2]>,
    pub(super) alive: Alive,
}

/// Passes on what is final beside these lines, or all that is left without, and returns the next window.
pub(super) fn retire<S: Scalar + Clone>(
    window: Window<S>,
    swept: &Swept<'_>,
    lines: &[Line<S>],
    corridors: Corridors,
    out: &mut dyn FnMut(Final),
) -> Retired<S> {
    if swept.len() == 0 {
        // All vertices are on one line.
        let alive = Alive {
            vertices: window.points.len(),
            ..Alive::default()
        };
        return Retired {
            window: window.whole(),
            reached: corridors.reached,
            alive,
        };
    }
    let pass = Pass::new(&window, swept, lines, &corridors);
    let (is_kept, sides, alive) = pass.run(out);
    let mut origins = labels(&window, swept, &is_kept, &sides, &corridors.pieces);
    let mut edges: Vec<_> = sides.iter().map(|side| side.ends).collect();
    for (ends, edge) in corridors.pieces {
        edges.push(ends);
        origins.push(Origin {
            edge: Some(edge),
            is_border: false,
        });
    }
    let mut reached = corridors.reached;
    let window = window.followed_by(&is_kept, edges, origins, &mut reached);
    Retired {
        window,
        reached,
        alive,
    }
}

/// A side that the next window needs.
struct Side {
    ends: [usize; 2],
    is_border: bool,
    is_constrained: bool,
}

struct Pass<'a, S> {
    window: &'a Window<S>,
    swept: &'a Swept<'a>,
    lines: &'a [Line<S>],
    /// The sides of the border as seen from beyond, sorted, and whether they are edges or pieces of edges.
    border: Vec<([usize; 2], bool)>,
    /// For each vertex where its sides of the border begin, and one number more.
    border_of: Vec<u32>,
    /// The pieces of pending edges that the next window has, sorted.
    pieces: Vec<[usize; 2]>,
    /// Whether all that is alive waits for edges.
    is_all_held: bool,
    states: Vec<State>,
    is_kept: Vec<bool>,
    sides: Vec<Side>,
    alive: Alive,
}

impl<'a, S: Scalar + Clone> Pass<'a, S> {
    fn new(
        window: &'a Window<S>,
        swept: &'a Swept<'a>,
        lines: &'a [Line<S>],
        corridors: &Corridors,
    ) -> Self {
        let sides = window.edges.iter().zip(&window.origins);
        let sides = sides.filter(|(_, origin)| origin.is_border);
        let mut border: Vec<_> = sides
            .map(|(&[u, v], origin)| ([v, u], origin.edge.is_some()))
            .collect();
        border.sort_unstable();
        let mut border_of = Vec::with_capacity(window.points.len() + 1);
        for (at, &([u, _], _)) in border.iter().enumerate() {
            if border_of.len() <= u {
                border_of.resize(u + 1, narrow(at));
            }
        }
        border_of.resize(window.points.len() + 1, narrow(border.len()));
        let mut is_kept = vec![false; window.points.len()];
        for &v in corridors.reached.as_flattened().iter().flatten() {
            is_kept[v] = true;
        }
        let mut states = vec![State::Alive; swept.len()];
        match &corridors.held {
            Some(held) => {
                for &t in held {
                    states[t] = State::Held;
                }
            }
            None => states.fill(State::Held),
        }
        let mut pieces: Vec<_> = corridors
            .pieces
            .iter()
            .map(|(ends, _)| sorted(*ends))
            .collect();
        pieces.sort_unstable();
        Pass {
            window,
            swept,
            lines,
            border,
            border_of,
            pieces,
            is_all_held: corridors.held.is_none(),
            is_kept,
            states,
            sides: Vec::new(),
            alive: Alive::default(),
        }
    }

    fn run(mut self, out: &mut dyn FnMut(Final)) -> (Vec<bool>, Vec<Side>, Alive) {
        self.mark_beyond();
        let mut living = Vec::new();
        for t in 0..self.swept.len() {
            let corners = self.swept.triangle(t);
            match self.states[t] {
                State::Alive if self.is_final(corners) => {
                    self.states[t] = State::Final;
                    self.pass_on(t, corners, out);
                }
                State::Alive => self.alive.circles += 1,
                State::Held => self.alive.edges += 1,
                State::Final | State::Beyond => {}
            }
            if self.is_alive(t) {
                living.push(t);
            }
            for side in 0..3 {
                if self.swept.neighbor(t, side).is_none() {
                    self.judge_ghost(t, side, out);
                }
            }
        }
        for t in living {
            self.keep(t);
        }
        self.alive.vertices = self.is_kept.iter().filter(|&&is_kept| is_kept).count();
        (self.is_kept, self.sides, self.alive)
    }

    /// Marks the triangles beyond the border.
    fn mark_beyond(&mut self) {
        if self.border.is_empty() {
            return;
        }
        let mut found = Vec::new();
        for t in 0..self.swept.len() {
            let corners = self.swept.triangle(t);
            let old = corners.iter().filter(|&&v| self.swept.is_old(v)).count();
            if old >= 2 && (0..3).any(|side| self.seen_from_beyond(t, side).is_some()) {
                self.states[t] = State::Beyond;
                found.push(t);
            }
        }
        while let Some(t) = found.pop() {
            for side in 0..3 {
                let Some(next) = self.swept.neighbor(t, side) else {
                    continue;
                };
                if self.states[next] != State::Beyond && self.seen_from_beyond(t, side).is_none() {
                    self.states[next] = State::Beyond;
                    found.push(next);
                }
            }
        }
    }

    /// The ends of a side, with its triangle on the left.
    fn ends(&self, t: usize, side: usize) -> [usize; 2] {
        let corners = self.swept.triangle(t);
        [corners[(side + 1) % 3], corners[(side + 2) % 3]]
    }

    /// If this is a side of the border, and the triangle lies beyond it: whether it is an edge or a piece of one.
    fn seen_from_beyond(&self, t: usize, side: usize) -> Option<bool> {
        // The border's sides are edges of the window.
        self.swept.is_constrained(t, side).then_some(())?;
        self.on_border(self.ends(t, side))
    }

    /// If this is a side of the border, and the triangle lies within it: likewise.
    fn seen_from_within(&self, t: usize, side: usize) -> Option<bool> {
        self.swept.is_constrained(t, side).then_some(())?;
        let [u, v] = self.ends(t, side);
        self.on_border([v, u])
    }

    /// If this is a side of the border, with what is final on its left: whether it is an edge or a piece of one.
    fn on_border(&self, [u, v]: [usize; 2]) -> Option<bool> {
        let [from, to] = [u, u + 1].map(|u| self.border_of[u] as usize);
        let sides = &self.border[from..to];
        let at = sides.binary_search_by_key(&v, |&([_, v], _)| v).ok()?;
        Some(sides[at].1)
    }

    /// Whether a side is an edge or a piece of one: a side of the border may be neither.
    #[inline]
    fn is_constrained(&self, t: usize, side: usize) -> bool {
        self.swept.is_constrained(t, side) && self.is_more_than_border(t, side)
    }

    #[cold]
    fn is_more_than_border(&self, t: usize, side: usize) -> bool {
        let of_border = self.seen_from_beyond(t, side);
        let of_border = of_border.or_else(|| self.seen_from_within(t, side));
        of_border.unwrap_or(true)
    }

    fn is_final(&self, corners: [usize; 3]) -> bool {
        let points = &self.window.points;
        let points = [
            &points[corners[0]],
            &points[corners[1]],
            &points[corners[2]],
        ];
        let mut lines = self.lines.iter();
        lines.all(|line| line.is_clear_of_circle(points))
    }

    fn is_alive(&self, t: usize) -> bool {
        matches!(self.states[t], State::Alive | State::Held)
    }

    /// Whether a side is an edge in the next window.
    fn will_be_constrained(&self, t: usize, side: usize) -> bool {
        let is_piece = || {
            self.pieces
                .binary_search(&sorted(self.ends(t, side)))
                .is_ok()
        };
        self.is_constrained(t, side) || is_piece()
    }

    /// Notes the corners of a living triangle, and its sides that the next window needs.
    fn keep(&mut self, t: usize) {
        for v in self.swept.triangle(t) {
            self.is_kept[v] = true;
        }
        for side in 0..3 {
            let Some(next) = self.swept.neighbor(t, side) else {
                continue;
            };
            let is_border = !self.is_alive(next);
            let is_constrained = self.will_be_constrained(t, side);
            if is_border || is_constrained && t < next {
                self.sides.push(Side {
                    ends: self.ends(t, side),
                    is_border,
                    is_constrained,
                });
            }
        }
    }

    #[inline]
    fn pass_on(&self, t: usize, [a, b, c]: [usize; 3], out: &mut dyn FnMut(Final)) {
        let number = |v| self.window.number(v);
        let is_edge = |side| self.is_constrained(t, side);
        out(Final::Triangle {
            corners: [number(a), number(b), number(c)],
            constrained: [is_edge(0), is_edge(1), is_edge(2)],
        });
    }

    /// Decides about the ghost beyond a side of the window's hull.
    #[cold]
    fn judge_ghost(&mut self, t: usize, side: usize, out: &mut dyn FnMut(Final)) {
        let [u, v] = self.ends(t, side);
        let is_constrained = self.will_be_constrained(t, side);
        let was_alive = match self.states[t] {
            State::Beyond => self.seen_from_beyond(t, side).is_some(),
            _ => self.seen_from_within(t, side).is_none(),
        };
        let is_alive = was_alive && !self.is_final_side([u, v]);
        if was_alive && !is_alive {
            out(Final::HullSide {
                ends: [u, v].map(|v| self.window.number(v)),
            });
        }
        let ends = match (self.is_alive(t), is_alive) {
            (true, _) => [u, v],
            // What is alive lies beyond the hull's side.
            (false, true) => [v, u],
            (false, false) => return,
        };
        let is_border = self.is_alive(t) != is_alive;
        if is_border || is_constrained {
            self.sides.push(Side {
                ends,
                is_border,
                is_constrained,
            });
        }
        if is_alive {
            self.alive.hull_sides += 1;
            for v in [u, v] {
                self.is_kept[v] = true;
            }
        }
    }

    /// Whether a side of the hull is final. None is, where edges that may run along it were not followed.
    fn is_final_side(&self, ends: [usize; 2]) -> bool {
        let [u, v] = ends.map(|v| &self.window.points[v]);
        let mut lines = self.lines.iter();
        lines.all(|line| !self.is_all_held && line.is_behind_side(u, v))
    }
}

fn sorted([u, v]: [usize; 2]) -> [usize; 2] {
    [u.min(v), u.max(v)]
}

/// For each side the edge that it is a piece of.
fn labels<S: Scalar + Clone>(
    window: &Window<S>,
    swept: &Swept<'_>,
    is_kept: &[bool],
    sides: &[Side],
    of_pending: &[([usize; 2], u64)],
) -> Vec<Origin> {
    let constrained = sides.iter().filter(|side| side.is_constrained);
    let note = |pieces: &mut Vec<([usize; 2], Option<u64>)>, ends, edge: u64| {
        if let Ok(at) = pieces.binary_search_by_key(&sorted(ends), |&(ends, _)| ends) {
            let least = pieces[at].1.map_or(edge, |known| known.min(edge));
            pieces[at].1 = Some(least);
        }
    };
    let mut pieces: Vec<_> = constrained.map(|side| (sorted(side.ends), None)).collect();
    pieces.sort_unstable();
    for &(ends, edge) in of_pending {
        note(&mut pieces, ends, edge);
    }
    for (e, origin) in window.origins.iter().enumerate() {
        let Some(edge) = origin.edge else { continue };
        let chain = swept.edge_chain(e);
        for (u, v) in chain.clone().zip(chain.skip(1)) {
            if is_kept[u] && is_kept[v] {
                note(&mut pieces, [u, v], edge);
            }
        }
    }
    let label = |side: &Side| {
        let at = pieces.binary_search_by_key(&sorted(side.ends), |&(ends, _)| ends);
        Origin {
            edge: at.ok().and_then(|at| pieces[at].1),
            is_border: side.is_border,
        }
    };
    sides.iter().map(label).collect()
}
