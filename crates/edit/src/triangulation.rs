//! The triangulation that changes, and what can be asked of it.

use std::collections::BTreeMap;

use sweep_cdt::scalar::Scalar;
use sweep_cdt::{Pslg, Session, Triangulator};

use crate::hints::Hints;
use crate::mesh::{Mesh, NONE, prev, side_of, turned};
use crate::points::Points;
use crate::region::Region;

/// A constrained Delaunay triangulation whose points and edges come and go.
///
/// Points and edges have numbers from 0, in the order in which they came; a number is never used again. Triangles have
/// numbers too, which edits give to others. The [crate] has an example.
#[derive(Debug)]
pub struct DynamicTriangulation<S> {
    pub(crate) points: Points<S>,
    /// The ends of each edge, as numbers of points; `None`, if it was removed.
    pub(crate) edges: Vec<Option<[u32; 2]>>,
    pub(crate) mesh: Mesh,
    pub(crate) hints: Hints,
    /// A triangle near the last edit.
    pub(crate) last: u32,
    pub(crate) session: Session,
    pub(crate) region: Region,
    /// For each vertex its place in a call of the session.
    pub(crate) local: Vec<u32>,
    /// The triangles that the last edit made, and some of which it may have removed again.
    pub(crate) swept: Vec<u32>,
    /// The vertices and edges of each sweep of the last edit.
    pub(crate) sweeps: Vec<(Vec<u32>, Vec<[usize; 2]>)>,
    /// New vertices that equal others.
    pub(crate) same: BTreeMap<u32, u32>,
}

impl<S> Default for DynamicTriangulation<S> {
    fn default() -> DynamicTriangulation<S> {
        DynamicTriangulation {
            points: Points::default(),
            edges: Vec::new(),
            mesh: Mesh::default(),
            hints: Hints::default(),
            last: 0,
            session: Triangulator::new().session(),
            region: Region::default(),
            local: Vec::new(),
            swept: Vec::new(),
            sweeps: Vec::new(),
            same: BTreeMap::new(),
        }
    }
}

impl<S: Clone> Clone for DynamicTriangulation<S> {
    fn clone(&self) -> DynamicTriangulation<S> {
        DynamicTriangulation {
            points: self.points.clone(),
            edges: self.edges.clone(),
            mesh: self.mesh.clone(),
            hints: self.hints.clone(),
            last: self.last,
            ..DynamicTriangulation::default()
        }
    }
}

impl<S: Scalar + Clone> DynamicTriangulation<S> {
    /// A triangulation of nothing.
    pub fn new() -> DynamicTriangulation<S> {
        DynamicTriangulation::default()
    }

    /// How many triangles there are.
    pub fn len(&self) -> usize {
        self.mesh.len()
    }

    /// Whether there are no triangles: there are fewer than three points, or all lie on one line.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The vertices of a triangle, counter-clockwise, each the lowest number of its points.
    pub fn triangle(&self, t: usize) -> Option<[usize; 3]> {
        let vertices = self.mesh.triangle(u32::try_from(t).ok()?)?;
        Some(vertices.map(|v| self.points.name(v)))
    }

    /// The triangle across a side, which is opposite this corner of a triangle; `None` beyond the hull.
    pub fn neighbor(&self, t: usize, side: usize) -> Option<usize> {
        let t = u32::try_from(t)
            .ok()
            .filter(|&t| self.mesh.triangle(t).is_some())?;
        let across = self.mesh.twin(side_of(t, side));
        (across != NONE).then_some(across as usize / 3)
    }

    /// All triangles.
    pub fn triangles(&self) -> impl Iterator<Item = [usize; 3]> + '_ {
        let vertices = self.mesh.all().filter_map(|t| self.mesh.triangle(t));
        vertices.map(|vertices| vertices.map(|v| self.points.name(v)))
    }

    /// The triangles as [`sweep_cdt::Triangulation::canonical_triangles`] lists them: each from its lowest vertex, sorted.
    pub fn canonical_triangles(&self) -> Vec<[usize; 3]> {
        let mut list: Vec<_> = self.triangles().map(turned).collect();
        list.sort_unstable();
        list
    }

    /// What the last edit changed, region by region: the vertices of a region, with its border and the parts of edges in
    /// it as edges, and the numbers of these vertices. The steps of an edit are the steps of these sweeps
    /// (`sweep_cdt::trace`); of a vertex that comes into a closed region the sweep is left out, as it would make the star
    /// of the vertex, and of an edge that comes alone and pierces one side, as it leaves no choice. Empty after an edit that was refused.
    ///
    /// ```
    /// let mut square = sweep_cdt_edit::DynamicTriangulation::new();
    /// for corner in [[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 8.0]] {
    ///     square.insert(corner)?;
    /// }
    /// square.insert([7.0, 4.0])?;
    /// let sweeps = square.last_sweeps();
    /// assert_eq!(sweeps.len(), 1);
    /// let (graph, numbers) = &sweeps[0];
    /// assert_eq!((graph.points.len(), graph.edges.len()), (5, 4));
    /// assert_eq!(numbers.iter().max(), Some(&4));
    /// # Ok::<(), sweep_cdt_edit::EditError>(())
    /// ```
    pub fn last_sweeps(&self) -> Vec<(Pslg<S>, Vec<usize>)> {
        let sweep = |(vertices, edges): &(Vec<u32>, Vec<[usize; 2]>)| {
            let points = vertices.iter().map(|&v| self.points.place(v).clone());
            let graph = Pslg {
                points: points.collect(),
                edges: edges.clone(),
                ..Pslg::default()
            };
            (
                graph,
                vertices.iter().map(|&v| self.points.name(v)).collect(),
            )
        };
        self.sweeps.iter().map(sweep).collect()
    }

    /// The numbers of all points that are there, in ascending order.
    pub fn points(&self) -> impl Iterator<Item = usize> + '_ {
        self.points.numbers()
    }

    /// The numbers that the next point and the next edge have.
    pub fn next_numbers(&self) -> [usize; 2] {
        [self.points.next(), self.edges.len()]
    }

    /// The place of a point that is there. Of equal points this is the place of the first.
    pub fn point(&self, point: usize) -> Option<&[S; 2]> {
        Some(self.points.place(self.points.vertex(point)?))
    }

    /// The lowest number of a point that equals this one.
    pub fn representative(&self, point: usize) -> Option<usize> {
        Some(self.points.name(self.points.vertex(point)?))
    }

    /// The numbers of all edges that are there, with their ends.
    pub fn edges(&self) -> impl Iterator<Item = (usize, [usize; 2])> + '_ {
        let numbered = self.edges.iter().enumerate();
        numbered.filter_map(|(e, ends)| Some((e, (*ends)?.map(|point| point as usize))))
    }

    /// The vertices along an edge, from its first end to its second; `None`, if there is no such edge. A single vertex, if
    /// the ends are equal.
    pub fn edge_chain(&self, edge: usize) -> Option<Vec<usize>> {
        let ends = (*self.edges.get(edge)?)?;
        let [a, b] = ends.map(|point| self.points.vertex(point as usize).expect("an end"));
        let mut chain = vec![a];
        if self.mesh.len() > 0 {
            chain.extend(self.sides_along([a, b]).into_iter().map(|(_, v)| v));
        } else if a != b {
            let is_between = |v: u32| {
                let order = self.points.order(a, b);
                self.points.order(a, v) == order && self.points.order(v, b) == order
            };
            chain.extend(self.points.vertices().filter(|&v| is_between(v)));
            chain.push(b);
            chain.sort_unstable_by(|&v, &w| self.points.order(v, w));
            if self.points.order(a, b).is_gt() {
                chain.reverse();
            }
        }
        Some(chain.into_iter().map(|v| self.points.name(v)).collect())
    }

    /// The sides that edges cover, each once, as vertices in ascending order; sorted.
    pub fn constrained_sides(&self) -> Vec<[usize; 2]> {
        let sides = self.mesh.all().flat_map(|t| 3 * t..3 * t + 3);
        let covered = sides.filter(|&side| self.mesh.covers(side) > 0);
        let mut ends: Vec<_> = covered.map(|side| self.named(side)).collect();
        ends.sort_unstable();
        ends.dedup();
        ends
    }

    fn named(&self, side: u32) -> [usize; 2] {
        let [a, b] = self.mesh.ends(side).map(|v| self.points.name(v));
        [a.min(b), a.max(b)]
    }

    /// The vertices that sides join to a point, counter-clockwise; on the hull from one of its sides to the other.
    pub fn neighbors(&self, point: usize) -> Vec<usize> {
        let Some(v) = self.points.vertex(point) else {
            return Vec::new();
        };
        let mut around = Vec::new();
        for corner in self.mesh.star(v) {
            let [p, q] = self.mesh.ends(corner);
            if self.mesh.twin(prev(corner)) == NONE {
                around.push(p);
            }
            around.push(q);
        }
        around.into_iter().map(|v| self.points.name(v)).collect()
    }

    /// The vertices on the border of the hull, counter-clockwise, from the leftmost one (the upper one of several), with
    /// those inside a straight part. Empty if there is no triangle.
    pub fn hull(&self) -> Vec<usize> {
        let mut sides = self.mesh.all().flat_map(|t| 3 * t..3 * t + 3);
        let Some(first) = sides.find(|&side| self.mesh.twin(side) == NONE) else {
            return Vec::new();
        };
        let mut hull = vec![];
        let mut side = first;
        loop {
            hull.push(self.mesh.ends(side)[0]);
            side = self.mesh.hull_beside(side)[1];
            if side == first {
                break;
            }
        }
        let numbered = hull.iter().enumerate();
        let leftmost = numbered.min_by(|(_, v), (_, w)| self.points.order(**v, **w));
        let leftmost = leftmost.expect("a hull has vertices").0;
        hull.rotate_left(leftmost);
        hull.into_iter().map(|v| self.points.name(v)).collect()
    }
}
