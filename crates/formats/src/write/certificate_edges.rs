//! The lines of edges in the certificate of a stream: each is written as soon as nothing else will lie along its sides.
//!
//! The checker forgets a piece of an edge with the side that is it. So edges that lie over each other must be written together:
//! they are a *group*. Two edges of a group have a side in common, or are so connected by others. An edge that covers
//! sides of a group, and began lower, would come by the side below the group's lowest vertex, on the same line. So a group
//! waits until all around that vertex is laid, and until such a side is written, if there is one.
//!
//! Cost: all open edges are looked at each time that triangles were laid.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use foldhash::HashMap;
use sweep_cdt::scalar::orient2d;

/// Edges that are not written, by vertices, whose numbers are in the order of the sweep.
#[derive(Debug, Default)]
pub(super) struct Edges {
    edges: BTreeMap<u64, Edge>,
    begun: u64,
    /// Edges that are not at their upper ends.
    open: Vec<u64>,
    /// By the first edge of each.
    groups: BTreeMap<u64, Vec<u64>>,
    /// Constrained sides that are not written, by the lower end and the upper one, and an edge along each.
    sides: HashMap<[u64; 2], Option<u64>>,
    /// The vertices below and above on these sides.
    beside: HashMap<u64, [Vec<u64>; 2]>,
}

#[derive(Debug)]
struct Edge {
    /// The vertices that were found on it, from the lower end on.
    chain: Vec<u64>,
    upper: [f64; 2],
    is_whole: bool,
    group: u64,
}

/// A vertex that may still be named.
#[derive(Debug)]
pub(super) struct Place {
    pub(super) point: [f64; 2],
    /// A sum of hashes, see `StreamCertificate::turn`.
    pub(super) star: u64,
    /// The number in the file, if the vertex is written.
    pub(super) name: Option<u64>,
}

impl Place {
    /// Whether all around is laid, if something is.
    pub(super) fn is_whole(&self) -> bool {
        self.star == 0
    }
}

type Places = HashMap<u64, Place>;

/// Of the vertices beside one.
const BELOW: usize = 0;
const ABOVE: usize = 1;

/// Where the vertex is, or would be, that is seen from another in the direction of a point. All are above or all below, in
/// their order round the vertex.
fn towards(
    beside: &[u64],
    vertex: u64,
    point: Option<[f64; 2]>,
    places: &Places,
) -> Result<usize, usize> {
    let place = |vertex: &u64| places.get(vertex).map(|place| place.point);
    beside.binary_search_by(|next| match (place(&vertex), place(next), point) {
        (Some(vertex), Some(next), Some(point)) => orient2d(&vertex, &next, &point).reverse(),
        _ => Ordering::Less,
    })
}

impl Edges {
    /// An edge begins at its lower end.
    pub(super) fn begin(&mut self, vertex: u64, upper: [f64; 2]) {
        let number = self.begun;
        self.begun += 1;
        let edge = Edge {
            chain: vec![vertex],
            upper,
            is_whole: false,
            group: number,
        };
        self.edges.insert(number, edge);
        self.open.push(number);
        self.groups.insert(number, vec![number]);
    }

    /// A side that is an edge or a piece of one, when the triangles of it are laid.
    pub(super) fn side(&mut self, ends: [u64; 2], places: &Places) {
        let [low, high] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        self.sides.insert([low, high], None);
        for (vertex, other, way) in [(high, low, BELOW), (low, high, ABOVE)] {
            let beside = &mut self.beside.entry(vertex).or_default()[way];
            let place = places.get(&other).map(|place| place.point);
            if let Err(at) = towards(beside, vertex, place, places) {
                beside.insert(at, other);
            }
        }
    }

    /// Whether a line to come names this vertex.
    pub(super) fn needs(&self, vertex: u64) -> bool {
        self.beside.contains_key(&vertex)
    }

    /// The vertices of the edges that can be written, and the vertices that they do not need any more.
    pub(super) fn whole(&mut self, places: &Places) -> (Vec<Vec<u64>>, Vec<u64>) {
        for number in std::mem::take(&mut self.open) {
            self.follow(number, places);
        }
        let (mut chains, mut free) = (Vec::new(), Vec::new());
        loop {
            let written = chains.len();
            let leaders: Vec<u64> = self.groups.keys().copied().collect();
            for leader in leaders {
                if self.is_ready(leader, places) {
                    self.take(leader, places, &mut chains, &mut free);
                }
            }
            if chains.len() == written {
                return (chains, free);
            }
        }
    }

    /// All edges that are left, unless sides of one are missing.
    pub(super) fn rest(&mut self, places: &Places) -> Option<Vec<Vec<u64>>> {
        self.whole(places);
        let mut edges = self.edges.values();
        edges.all(|edge| edge.is_whole).then(|| {
            let edges = self.edges.values();
            edges.map(|edge| edge.chain.clone()).collect()
        })
    }

    /// Both ends of each edge, where there is no triangle, so that all places are known.
    pub(super) fn without_triangles(&mut self, places: &Places) -> Option<Vec<Vec<u64>>> {
        // -0.0 + 0.0 is 0.0, and all else stays as it is.
        let bits = |point: [f64; 2]| point.map(|coordinate| (coordinate + 0.0).to_bits());
        let numbers = places.iter();
        let numbers = numbers.map(|(&number, place)| (bits(place.point), number));
        let numbers: HashMap<[u64; 2], u64> = numbers.collect();
        let both = |edge: &Edge| {
            let upper = numbers.get(&bits(edge.upper))?;
            Some(vec![edge.chain[0], *upper])
        };
        self.edges.values().map(both).collect()
    }

    /// Goes on along the sides of an edge.
    fn follow(&mut self, number: u64, places: &Places) {
        while let Some(edge) = self.edges.get_mut(&number) {
            let Some(&last) = edge.chain.last() else {
                return;
            };
            if places
                .get(&last)
                .is_some_and(|place| place.point.partial_cmp(&edge.upper) == Some(Ordering::Equal))
            {
                edge.is_whole = true;
                return;
            }
            let above = self
                .beside
                .get(&last)
                .map_or(&[][..], |beside| &beside[ABOVE]);
            let Ok(at) = towards(above, last, Some(edge.upper), places) else {
                self.open.push(number);
                return;
            };
            let next = above[at];
            edge.chain.push(next);
            let group = edge.group;
            let first = self
                .sides
                .get_mut(&[last, next])
                .map(|side| *side.get_or_insert(number));
            if let Some(other) = first
                .and_then(|first| self.edges.get(&first))
                .map(|edge| edge.group)
            {
                self.unite(group, other);
            }
        }
    }

    fn unite(&mut self, one: u64, other: u64) {
        let size = |group| self.groups.get(&group).map_or(0, Vec::len);
        let [kept, moved] = match size(one) < size(other) {
            true => [other, one],
            false => [one, other],
        };
        if kept == moved {
            return;
        }
        let moved = self.groups.remove(&moved).unwrap_or_default();
        for number in &moved {
            if let Some(edge) = self.edges.get_mut(number) {
                edge.group = kept;
            }
        }
        self.groups.entry(kept).or_default().extend(moved);
    }

    /// Whether all edges of a group are known to the end, and no other edge can lie along their sides.
    fn is_ready(&self, leader: u64, places: &Places) -> bool {
        let numbers = self.groups.get(&leader).into_iter().flatten();
        let edges = numbers.filter_map(|number| self.edges.get(number));
        if edges.clone().any(|edge| !edge.is_whole) {
            return false;
        }
        let Some(lowest) = edges.min_by_key(|edge| edge.chain[0]) else {
            return false;
        };
        let vertex = lowest.chain[0];
        let Some(place) = places.get(&vertex).filter(|place| place.is_whole()) else {
            return false;
        };
        // Below on the same line, that is, where the upper end is seen in the opposite direction.
        let below = self
            .beside
            .get(&vertex)
            .map_or(&[][..], |beside| &beside[BELOW]);
        let is_on_line = below.binary_search_by(|next| match places.get(next) {
            Some(next) => orient2d(&place.point, &next.point, &lowest.upper),
            None => Ordering::Less,
        });
        is_on_line.is_err()
    }

    /// Writes the edges of a group, and forgets their sides.
    fn take(
        &mut self,
        leader: u64,
        places: &Places,
        chains: &mut Vec<Vec<u64>>,
        free: &mut Vec<u64>,
    ) {
        for number in self.groups.remove(&leader).unwrap_or_default() {
            let Some(edge) = self.edges.remove(&number) else {
                continue;
            };
            for ends in edge.chain.windows(2) {
                let [low, high] = [ends[0], ends[1]];
                if self.sides.remove(&[low, high]).is_some() {
                    self.part(high, BELOW, low, places, free);
                    self.part(low, ABOVE, high, places, free);
                }
            }
            chains.push(edge.chain);
        }
    }

    /// A vertex has a side less.
    fn part(&mut self, vertex: u64, way: usize, other: u64, places: &Places, free: &mut Vec<u64>) {
        if let Some(beside) = self.beside.get_mut(&vertex) {
            let place = places.get(&other).map(|place| place.point);
            if let Ok(at) = towards(&beside[way], vertex, place, places) {
                beside[way].remove(at);
            }
            if beside.iter().all(Vec::is_empty) {
                self.beside.remove(&vertex);
                free.push(vertex);
            }
        }
    }
}
