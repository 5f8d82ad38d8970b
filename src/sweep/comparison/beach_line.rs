//! The beach line of Fortune's sweep (1987): the sites whose parabolas the sweep line sees, from left to right.
//!
//! The points that are nearer to a site than to the sweep line lie below a parabola. The upper border of all these
//! regions is the beach line. A site may have several *arcs* of it. A new site cuts the arc below it in two, and gets
//! its own arc between. Where an arc shrinks to nothing, the circle through its site and those of its neighbours
//! touches the sweep line. Everything is computed in plain floating point, and decides nothing: see [`super::fortune`].
//!
//! Cost: a look into a table of O(sqrt(n)) intervals of x, and a walk, of O(1) arcs where points are evenly spread.

use crate::bucket::bucket;
use crate::ids::{BorderId, VertexId, narrow};
use alloc::vec;
use alloc::vec::Vec;

/// The number of no arc, in place of a neighbour.
const NONE: u32 = u32::MAX;

#[derive(Clone, Copy, Debug)]
struct Arc {
    site: VertexId,
    /// The border half-edge from this site to that of the next arc, free above.
    border: BorderId,
    prev: u32,
    next: u32,
    /// How often the arc's neighbours have changed.
    changes: u32,
    is_gone: bool,
}

/// All arcs, by number; an arc that is gone keeps its number.
#[derive(Debug)]
pub(super) struct BeachLine {
    arcs: Vec<Arc>,
    /// For each interval of x an arc found there.
    found: Vec<u32>,
    least: f64,
    per_x: f64,
}

impl BeachLine {
    /// A beach line of one arc, that of the first site.
    pub(super) fn new(sites: &[[f64; 2]]) -> BeachLine {
        let finite = sites.iter().map(|site| site[0]).filter(|x| x.is_finite());
        let (least, most) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), x| {
            (least.min(x), most.max(x))
        });
        let intervals = 1 + 2 * sites.len().isqrt();
        let mut arcs = Vec::with_capacity(2 * sites.len());
        arcs.push(Arc {
            site: VertexId::new(0),
            border: BorderId::new(0),
            prev: NONE,
            next: NONE,
            changes: 0,
            is_gone: false,
        });
        BeachLine {
            arcs,
            found: vec![0; intervals],
            least,
            per_x: intervals as f64 / (most - least),
        }
    }

    /// The arc below a new site `p`, and the number of steps walked to it.
    pub(super) fn below(&mut self, p: [f64; 2], sites: &[[f64; 2]]) -> (u32, u64) {
        let place = bucket((p[0] - self.least) * self.per_x, self.found.len());
        let mut at = self.found[place];
        let mut steps = 0;
        // The first and the last arc are never gone.
        while self.arc(at).is_gone {
            (at, steps) = (self.arc(at).next, steps + 1);
        }
        let site = |arc: &Arc| sites[arc.site.index()];
        loop {
            let Arc { prev, .. } = *self.arc(at);
            if prev == NONE || is_right(site(self.arc(prev)), site(self.arc(at)), p) {
                break;
            }
            (at, steps) = (prev, steps + 1);
        }
        loop {
            let Arc { next, .. } = *self.arc(at);
            if next == NONE || !is_right(site(self.arc(at)), site(self.arc(next)), p) {
                break;
            }
            (at, steps) = (next, steps + 1);
        }
        self.found[place] = at;
        (at, steps)
    }

    /// Cuts an arc in two around one of `p`; `border` stands for both halves of the side to `p`. Returns the right arc.
    pub(super) fn cut(&mut self, arc: u32, p: VertexId, border: BorderId) -> u32 {
        let whole = *self.arc(arc);
        let [middle, right] = [0, 1].map(|i| narrow(self.arcs.len() + i));
        self.arcs.push(Arc {
            site: p,
            border,
            prev: arc,
            next: right,
            changes: 0,
            is_gone: false,
        });
        self.arcs.push(Arc {
            prev: middle,
            ..whole
        });
        let left = &mut self.arcs[arc as usize];
        (left.border, left.next) = (border, middle);
        if whole.next != NONE {
            self.arcs[whole.next as usize].prev = right;
        }
        right
    }

    /// Removes an inner arc; `border` is the side between its neighbours, which are returned.
    pub(super) fn remove(&mut self, arc: u32, border: BorderId) -> [u32; 2] {
        let Arc { prev, next, .. } = *self.arc(arc);
        self.arcs[arc as usize].is_gone = true;
        let left = &mut self.arcs[prev as usize];
        (left.border, left.next) = (border, next);
        self.arcs[next as usize].prev = prev;
        [prev, next]
    }

    /// Notes that the neighbours of an arc have changed; returns how often they have.
    pub(super) fn change(&mut self, arc: u32) -> u32 {
        let arc = &mut self.arcs[arc as usize];
        arc.changes += 1;
        arc.changes
    }

    /// Whether an arc is there, with the neighbours that it had after `changes` changes.
    pub(super) fn is_as_after(&self, arc: u32, changes: u32) -> bool {
        !self.arc(arc).is_gone && self.arc(arc).changes == changes
    }

    /// The sites of an arc and its neighbours, each with the side to the next site; `None` for the first and last arc.
    pub(super) fn corner(&self, arc: u32) -> Option<[(VertexId, BorderId); 3]> {
        let Arc { prev, next, .. } = *self.arc(arc);
        let is_inner = prev != NONE && next != NONE;
        is_inner.then(|| [prev, arc, next].map(|i| (self.arc(i).site, self.arc(i).border)))
    }

    /// All sites from left to right, each with the side to the next site.
    pub(super) fn sites(&self) -> impl Iterator<Item = (VertexId, BorderId)> {
        let next = |&at: &u32| Some(self.arc(at).next).filter(|&next| next != NONE);
        core::iter::successors(Some(0), next).map(|at| (self.arc(at).site, self.arc(at).border))
    }

    fn arc(&self, number: u32) -> &Arc {
        &self.arcs[number as usize]
    }
}

/// Whether the new site `p`, on the sweep line, lies right of the point where the arc of `a` gives way to that of `b`.
fn is_right(a: [f64; 2], b: [f64; 2], p: [f64; 2]) -> bool {
    let [[ax, ay], [bx, by]] = [a, b].map(|site| [p[0] - site[0], p[1] - site[1]]);
    // The circle through b that touches the sweep line at p is smaller.
    let is_nearer = || (bx * bx + by * by) * ay < (ax * ax + ay * ay) * by;
    // The arc of the higher site lies between two arcs of the lower one.
    if ay < by {
        ax > 0.0 && is_nearer()
    } else if ay > by {
        bx >= 0.0 || is_nearer()
    } else {
        a[0] < b[0] && ax + bx > 0.0
    }
}

/// The height at which an arc of `b` between arcs of `a` and `c` is gone: the top of their circle.
pub(super) fn top([a, b, c]: [[f64; 2]; 3]) -> f64 {
    let [[ax, ay], [cx, cy]] = [a, c].map(|site| [site[0] - b[0], site[1] - b[1]]);
    let [a2, c2] = [ax * ax + ay * ay, cx * cx + cy * cy];
    let area = 2.0 * (ax * cy - ay * cx);
    let [x, y] = [(cy * a2 - ay * c2) / area, (ax * c2 - cx * a2) / area];
    let top = b[1] + y + (x * x + y * y).sqrt();
    if top.is_nan() { f64::INFINITY } else { top }
}
