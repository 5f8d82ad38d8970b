//! A triangulation as data, and back (feature `serde`).
//!
//! The triangles, hull, duplicates and chains are written; all else follows from them. Geometry is not written, and is
//! not looked at when data is read: [`WithPoints::verify`](crate::WithPoints::verify) does that.
//!
//! Why data read is as good as a result made: the triangles must be joined side to side into one disk whose border is
//! the hull. That is so if no two lie to the left of one side, each can be reached from the first, the sides with
//! nothing across are those of the hull, which passes no vertex twice, and the numbers of vertices, sides and triangles
//! obey Euler's formula. (A surface of triangles with one border has v - e + f at most 1, and 1 only if it is a disk; a
//! vertex at which two fans meet costs one more.) Duplicates must be in order, each chain a row of sides. Every point is
//! a corner or a duplicate, so the numbers of both must be all numbers from 0 on. This also keeps data small that is made
//! to do harm: no table by vertex is longer than the data. Cost: a sort of the sides.

use alloc::vec;
use alloc::vec::Vec;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::ids::{TriangleId, VertexId};
use crate::mesh::{HalfEdge, Mesh, Triangle};
use crate::triangulation::Triangulation;
use crate::triangulation::edge_chains::EdgeChains;

#[derive(Serialize, Deserialize)]
#[serde(rename = "Triangulation", deny_unknown_fields)]
struct Parts {
    triangles: Vec<[usize; 3]>,
    hull: Vec<usize>,
    /// Each duplicate with its representative.
    duplicates: Vec<[usize; 2]>,
    /// The vertices along each edge.
    edges: Vec<Vec<usize>>,
}

impl Serialize for Triangulation {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let chain = |e| self.edge_chain(e).collect();
        let parts = Parts {
            triangles: self.triangles().collect(),
            hull: self.hull().collect(),
            duplicates: self.duplicates().collect(),
            edges: (0..self.chains.len()).map(chain).collect(),
        };
        parts.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Triangulation {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let parts = Parts::deserialize(deserializer)?;
        parts.into_triangulation().map_err(D::Error::custom)
    }
}

type Fault = &'static str;

fn require(holds: bool, otherwise: Fault) -> Result<(), Fault> {
    if holds { Ok(()) } else { Err(otherwise) }
}

impl Parts {
    fn into_triangulation(self) -> Result<Triangulation, Fault> {
        let corners: Vec<[u32; 3]> = all(&self.triangles, |&list| numbers(list))?;
        let hull: Vec<u32> = all(&self.hull, |&v| number(v))?;
        let duplicates: Vec<[u32; 2]> = all(&self.duplicates, |&list| numbers(list))?;
        let sides = Sides::of(&corners)?;
        let vertices = sides.starts();
        let mut triangles = sides.linked(&corners, &vertices);
        sides.expect_disk(&triangles, &hull)?;
        for pair in duplicates.windows(2) {
            require(pair[0][0] < pair[1][0], "the duplicates are not in order")?;
        }
        let is_duplicate = |v: u32| duplicates.binary_search_by_key(&v, |pair| pair[0]).is_ok();
        for &[v, of] in &duplicates {
            require(
                of < v && !is_duplicate(of),
                "a duplicate is of none before it",
            )?;
            require(!sides.start_at(v), "a duplicate is a corner")?;
        }
        let last = vertices.last().max(duplicates.last().map(|[v, _]| v));
        let points = last.map_or(0, |&v| v as usize + 1);
        require(
            triangles.is_empty() || points == vertices.len() + duplicates.len(),
            "a point is no corner and no duplicate",
        )?;
        let mut lists = Vec::with_capacity(self.edges.len());
        for list in &self.edges {
            let list = all(list, |&v| number(v))?;
            require(!list.is_empty(), "an edge passes no vertex")?;
            require(
                !list.iter().any(|&v| is_duplicate(v)),
                "an edge passes a duplicate",
            )?;
            require(
                triangles.is_empty() || list.iter().all(|&v| (v as usize) < points),
                "an edge passes no corner",
            )?;
            require(
                list.len() == 1 || list.first() != list.last(),
                "an edge ends where it begins",
            )?;
            for pair in list.windows(2) {
                sides.constrain([pair[0], pair[1]], &mut triangles)?;
            }
            lists.push(list);
        }
        Ok(Triangulation {
            triangles,
            vertices,
            hull,
            duplicates: duplicates.into_iter().map(|[v, of]| (v, of)).collect(),
            chains: EdgeChains::of(&lists)
                .ok_or("there are too many edges, or vertices on them")?,
        })
    }
}

fn all<T, U>(list: &[T], of: impl Fn(&T) -> Result<U, Fault>) -> Result<Vec<U>, Fault> {
    list.iter().map(of).collect()
}

/// The number of a vertex in 32 bits, if there may be so many points.
fn number(v: usize) -> Result<u32, Fault> {
    let number = u32::try_from(v).ok();
    let number = number.filter(|_| v < HalfEdge::LIMIT / 2);
    number.ok_or("a vertex has too large a number")
}

fn numbers<const N: usize>(list: [usize; N]) -> Result<[u32; N], Fault> {
    let mut result = [0; N];
    for (to, v) in result.iter_mut().zip(list) {
        *to = number(v)?;
    }
    Ok(result)
}

/// All sides by their ends, counter-clockwise, in order.
struct Sides(Vec<([u32; 2], HalfEdge)>);

impl Sides {
    fn of(corners: &[[u32; 3]]) -> Result<Sides, Fault> {
        require(
            corners.len() < HalfEdge::LIMIT,
            "there are too many triangles",
        )?;
        let mut sides = Vec::with_capacity(3 * corners.len());
        for (t, &[a, b, c]) in corners.iter().enumerate() {
            require(a != b && b != c && c != a, "a triangle has a corner twice")?;
            let ends = [(0, [b, c]), (1, [c, a]), (2, [a, b])];
            sides.extend(ends.map(|(i, ends)| (ends, HalfEdge::new(TriangleId::at(t), i))));
        }
        sides.sort_unstable();
        let is_once = sides.windows(2).all(|pair| pair[0].0 != pair[1].0);
        require(is_once, "two triangles lie to the left of one side")?;
        Ok(Sides(sides))
    }

    fn find(&self, ends: [u32; 2]) -> Option<HalfEdge> {
        let place = self.0.binary_search_by_key(&ends, |&(ends, _)| ends);
        place.ok().map(|place| self.0[place].1)
    }

    fn start_at(&self, v: u32) -> bool {
        let place = self.0.partition_point(|&([a, _], _)| a < v);
        self.0.get(place).is_some_and(|&([a, _], _)| a == v)
    }

    /// The vertices at which sides start, ascending.
    fn starts(&self) -> Vec<u32> {
        let mut starts: Vec<u32> = self.0.iter().map(|&([a, _], _)| a).collect();
        starts.dedup();
        starts
    }

    /// The triangles, with the positions of their corners in `vertices`, and their twins.
    fn linked(&self, corners: &[[u32; 3]], vertices: &[u32]) -> Vec<Triangle> {
        let place = |v: u32| VertexId::at(vertices.partition_point(|&other| other < v));
        let mut mesh = Mesh::default();
        for &corners in corners {
            mesh.add(corners.map(place), [HalfEdge::NOTHING; 3]);
        }
        let mut triangles = mesh.take_triangles();
        for &([a, b], side) in &self.0 {
            let twin = self.find([b, a]).unwrap_or(HalfEdge::HULL);
            triangles[side.triangle().index()].set_twin(side.corner(), twin);
        }
        triangles
    }

    /// Refuses triangles that are no disk with this border.
    fn expect_disk(&self, triangles: &[Triangle], hull: &[u32]) -> Result<(), Fault> {
        let is_border =
            |ends: [u32; 2]| self.find(ends).is_some() && self.find([ends[1], ends[0]]).is_none();
        let after = hull.iter().cycle().skip(1);
        let mut is_hull = hull.iter().zip(after).all(|(&a, &b)| is_border([a, b]));
        let border = self.0.iter().filter(|&&(ends, _)| is_border(ends)).count();
        is_hull &= border == hull.len();
        require(is_hull, "the hull is not the border of the triangles")?;
        if triangles.is_empty() {
            return Ok(());
        }
        let mut is_reached = vec![false; triangles.len()];
        is_reached[0] = true;
        let (mut reached, mut next) = (vec![0], 0);
        while let Some(&t) = reached.get(next) {
            next += 1;
            for twin in [0, 1, 2].map(|i| triangles[t].twin(i)) {
                if !twin.is_border() && !is_reached[twin.triangle().index()] {
                    is_reached[twin.triangle().index()] = true;
                    reached.push(twin.triangle().index());
                }
            }
        }
        let vertices = self.0.chunk_by(|a, b| a.0[0] == b.0[0]).count();
        let sides = (self.0.len() + border) / 2;
        // Without a border, a sphere with two of its points made one would have as many of each.
        let is_disk = border > 0
            && reached.len() == triangles.len()
            && vertices + triangles.len() == sides + 1;
        require(is_disk, "the triangles are no disk")
    }

    /// Marks a side as a piece of an edge. Without triangles there are no sides.
    fn constrain(&self, [a, b]: [u32; 2], triangles: &mut [Triangle]) -> Result<(), Fault> {
        let found = [self.find([a, b]), self.find([b, a])];
        let is_side = found.iter().any(Option::is_some) || triangles.is_empty();
        require(is_side && a != b, "an edge passes where no side is")?;
        for side in found.into_iter().flatten() {
            let triangle = &mut triangles[side.triangle().index()];
            triangle.set_twin(side.corner(), triangle.twin(side.corner()).constrain());
        }
        Ok(())
    }
}
