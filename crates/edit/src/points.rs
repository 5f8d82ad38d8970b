//! The caller's points by number, and the vertices that stand for them: equal points share one.

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

use sweep_cdt::scalar::Scalar;

use crate::mesh::{NONE, number};

#[derive(Clone, Debug)]
pub(crate) struct Points<S> {
    /// For each vertex its place, which outlives the vertex.
    places: Vec<[S; 2]>,
    /// Vertices that stand for no point.
    free: Vec<u32>,
    /// For each vertex the lowest number of its points.
    name: Vec<u32>,
    /// All numbers of the vertices that stand for several points.
    names: BTreeMap<u32, BTreeSet<u32>>,
    /// For each number its vertex; [`NONE`], if the point was removed.
    vertex: Vec<u32>,
    /// How many edges end at each number.
    uses: Vec<u32>,
}

impl<S> Default for Points<S> {
    fn default() -> Points<S> {
        Points {
            places: Vec::new(),
            free: Vec::new(),
            name: Vec::new(),
            names: BTreeMap::new(),
            vertex: Vec::new(),
            uses: Vec::new(),
        }
    }
}

impl<S: Scalar> Points<S> {
    /// The next number.
    pub(crate) fn next(&self) -> usize {
        self.vertex.len()
    }

    /// The number below which all vertices lie.
    pub(crate) fn bound(&self) -> usize {
        self.places.len()
    }

    /// The vertex of a point that is there.
    pub(crate) fn vertex(&self, point: usize) -> Option<u32> {
        let vertex = self.vertex.get(point).copied();
        vertex.filter(|&v| v != NONE)
    }

    pub(crate) fn place(&self, v: u32) -> &[S; 2] {
        &self.places[v as usize]
    }

    pub(crate) fn name(&self, v: u32) -> usize {
        self.name[v as usize] as usize
    }

    /// How many points a vertex stands for.
    pub(crate) fn multiplicity(&self, v: u32) -> usize {
        self.names.get(&v).map_or(1, BTreeSet::len)
    }

    /// How many edges end at a point.
    pub(crate) fn uses(&self, point: usize) -> u32 {
        self.uses[point]
    }

    pub(crate) fn uses_mut(&mut self, point: usize) -> &mut u32 {
        &mut self.uses[point]
    }

    /// All numbers of points that are there.
    pub(crate) fn numbers(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.vertex.len()).filter(|&point| self.vertex[point] != NONE)
    }

    /// All vertices, in the order of their names.
    pub(crate) fn vertices(&self) -> impl Iterator<Item = u32> + '_ {
        let vertices = self.numbers().map(|point| (point, self.vertex[point]));
        vertices.filter_map(|(point, v)| (self.name(v) == point).then_some(v))
    }

    /// The order by x, then from above.
    pub(crate) fn order(&self, a: u32, b: u32) -> Ordering {
        let ([ax, ay], [bx, by]) = (self.place(a), self.place(b));
        ax.compare(bx).then_with(|| by.compare(ay))
    }

    /// A new vertex, which stands for no point yet.
    pub(crate) fn reserve(&mut self, place: [S; 2]) -> u32 {
        if let Some(v) = self.free.pop() {
            self.places[v as usize] = place;
            return v;
        }
        self.places.push(place);
        self.name.push(NONE);
        number(self.places.len() - 1)
    }

    /// Takes a vertex back that was reserved last.
    pub(crate) fn release(&mut self, v: u32) {
        self.name[v as usize] = NONE;
        self.free.push(v);
    }

    /// Takes a vertex back that was reserved, if it stands for no point.
    pub(crate) fn release_unused(&mut self, v: u32) {
        if self.name[v as usize] == NONE {
            self.free.push(v);
        }
    }

    /// A point with the next number, at a vertex.
    pub(crate) fn add(&mut self, v: u32) -> usize {
        let point = self.vertex.len();
        self.vertex.push(v);
        self.uses.push(0);
        let name = &mut self.name[v as usize];
        if *name == NONE {
            *name = number(point);
        } else {
            let names = self
                .names
                .entry(v)
                .or_insert_with(|| BTreeSet::from([*name]));
            names.insert(number(point));
        }
        point
    }

    pub(crate) fn remove(&mut self, point: usize) {
        let v = std::mem::replace(&mut self.vertex[point], NONE);
        let Some(names) = self.names.get_mut(&v) else {
            self.release(v);
            return;
        };
        names.remove(&number(point));
        self.name[v as usize] = *names.first().expect("another point");
        if names.len() == 1 {
            self.names.remove(&v);
        }
    }
}
