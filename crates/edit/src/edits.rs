//! Edits, one by one and in batches: what is removed goes first, then points come, then edges.

use std::cmp::Reverse;
use std::collections::{BTreeMap, VecDeque};
use std::ops::Range;

use sweep_cdt::Error;
use sweep_cdt::scalar::Scalar;

use crate::error::EditError;
use crate::hints::Hints;
use crate::locate::Place;
use crate::mesh::{MOST, NONE, next, number, packed, prev, unpacked};
use crate::points::Points;
use crate::region::Piece;
use crate::triangulation::DynamicTriangulation;

/// So many edits, if there are not four times as many triangles, are made by one sweep of all: removals, points and edges
/// would each sweep nearly all of them.
const MANY: usize = 64;

/// Edits made at once. What is removed goes first.
#[derive(Clone, Debug, PartialEq)]
pub struct Edits<S> {
    /// Points that come; they have the next numbers.
    pub points: Vec<[S; 2]>,
    /// Edges that come, as numbers of points, the new ones among them. They have the next numbers of edges.
    pub edges: Vec<[usize; 2]>,
    /// Numbers of points that go. No edge that stays or comes may end there. An edge that passes through closes over.
    pub remove_points: Vec<usize>,
    /// Numbers of edges that go.
    pub remove_edges: Vec<usize>,
}

impl<S> Default for Edits<S> {
    fn default() -> Edits<S> {
        Edits {
            points: Vec::new(),
            edges: Vec::new(),
            remove_points: Vec::new(),
            remove_edges: Vec::new(),
        }
    }
}

/// What edits changed.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Change {
    /// The numbers of the new points.
    pub points: Range<usize>,
    /// The numbers of the new edges.
    pub edges: Range<usize>,
    /// The triangles that are gone, each from its lowest vertex, sorted, with the names that their vertices had.
    pub gone: Vec<[usize; 3]>,
    /// The triangles that are new. A triangle whose vertex has another name only, since an equal point came or went, is
    /// neither.
    pub new: Vec<[usize; 3]>,
}

impl<S: Scalar + Clone> DynamicTriangulation<S> {
    /// Inserts a point, and returns its number.
    ///
    /// # Errors
    /// [`EditError::NonFiniteCoordinate`], [`EditError::Refused`].
    pub fn insert(&mut self, point: [S; 2]) -> Result<usize, EditError> {
        let points = vec![point];
        let edits = Edits {
            points,
            ..Edits::default()
        };
        let change = self.edit(edits, false)?;
        Ok(change.points.start)
    }

    /// Removes a point.
    ///
    /// # Errors
    /// [`EditError::NoPoint`]; [`EditError::PointInUse`], if an edge ends there; [`EditError::CrossingEdges`], if two
    /// edges crossed at the point.
    pub fn remove(&mut self, point: usize) -> Result<(), EditError> {
        let remove_points = vec![point];
        let edits = Edits {
            remove_points,
            ..Edits::default()
        };
        self.edit(edits, false)?;
        Ok(())
    }

    /// Inserts an edge between two points, and returns its number.
    ///
    /// # Errors
    /// [`EditError::NoPoint`]; [`EditError::CrossingEdges`], if it crosses another edge at a point that is no vertex.
    pub fn insert_edge(&mut self, ends: [usize; 2]) -> Result<usize, EditError> {
        let edges = vec![ends];
        let edits = Edits {
            edges,
            ..Edits::default()
        };
        let change = self.edit(edits, false)?;
        Ok(change.edges.start)
    }

    /// Removes an edge.
    ///
    /// # Errors
    /// [`EditError::NoEdge`].
    pub fn remove_edge(&mut self, edge: usize) -> Result<(), EditError> {
        let remove_edges = vec![edge];
        let edits = Edits {
            remove_edges,
            ..Edits::default()
        };
        self.edit(edits, false)?;
        Ok(())
    }

    /// Makes all edits of a batch, or none.
    ///
    /// # Errors
    /// See [`EditError`]. Then nothing has changed.
    pub fn apply(&mut self, edits: Edits<S>) -> Result<Change, EditError> {
        self.edit(edits, true)
    }

    /// Makes all edits, or none. Whoever does not ask is not told of triangles.
    pub(crate) fn edit(&mut self, mut edits: Edits<S>, is_told: bool) -> Result<Change, EditError> {
        for list in [&mut edits.remove_points, &mut edits.remove_edges] {
            list.sort_unstable();
            list.dedup();
        }
        self.sweeps.clear();
        self.check(&edits)?;
        self.swept.clear();
        let take = |&e: &usize| (e, self.edges[e].take().expect("an edge that is there"));
        let taken: Vec<(usize, [u32; 2])> = edits.remove_edges.iter().map(take).collect();
        let mut vertices = Vertices::default();
        let made = self.make(&edits, &taken, &mut vertices);
        if let Err(error) = made {
            self.region.clear();
            self.sweeps.clear();
            self.mesh.undo();
            for (e, ends) in taken {
                self.edges[e] = Some(ends);
            }
            for &v in vertices.reserved.iter().rev() {
                self.points.release(v);
            }
            return Err(error);
        }
        Ok(self.commit(edits, &taken, &vertices, is_told))
    }

    /// Refuses what names points and edges that are not there.
    fn check(&self, edits: &Edits<S>) -> Result<(), EditError> {
        let next = self.points.next();
        let limit = MOST;
        if let given = next + edits.points.len()
            && given > limit
        {
            let error = Error::TooManyPoints { given, limit };
            return Err(EditError::Refused { error });
        }
        if let given = self.edges.len() + edits.edges.len()
            && given > limit
        {
            let error = Error::TooManyEdges { given, limit };
            return Err(EditError::Refused { error });
        }
        let is_finite = |point: &[S; 2]| point.iter().all(Scalar::is_finite);
        if let Some(i) = edits.points.iter().position(|point| !is_finite(point)) {
            return Err(EditError::NonFiniteCoordinate { point: next + i });
        }
        let is_edge = |e: usize| self.edges.get(e).is_some_and(Option::is_some);
        if let Some(&edge) = edits.remove_edges.iter().find(|&&e| !is_edge(e)) {
            return Err(EditError::NoEdge { edge });
        }
        let is_point = |&point: &usize| self.points.vertex(point).is_some();
        let is_new = |point: &usize| (next..next + edits.points.len()).contains(point);
        let mut no_points = edits.remove_points.iter().filter(|point| !is_point(point));
        let ends = edits.edges.iter().flatten();
        let mut no_ends = ends.filter(|point| !is_point(point) && !is_new(point));
        if let Some(&point) = no_points.next().or_else(|| no_ends.next()) {
            return Err(EditError::NoPoint { point });
        }
        // What ends at a point that goes must go too.
        let mut uses = BTreeMap::new();
        let taken = edits.remove_edges.iter().filter_map(|&e| self.edges[e]);
        for end in taken.flatten() {
            *uses.entry(end as usize).or_insert(0) += 1;
        }
        let is_used =
            |point: &usize| self.points.uses(*point) > uses.get(point).copied().unwrap_or(0);
        let goes = |list: &[usize], number| list.binary_search(&number).is_ok();
        let comes = edits.edges.iter().enumerate();
        let mut comes = comes.map(|(i, &ends)| (self.edges.len() + i, ends));
        let used = |(edge, ends): (usize, [usize; 2])| {
            let point = ends
                .into_iter()
                .find(|&point| goes(&edits.remove_points, point))?;
            Some(EditError::PointInUse { point, edge })
        };
        let in_use = if edits.remove_points.iter().any(is_used) {
            let mut stays = self.edges().filter(|&(e, _)| !goes(&edits.remove_edges, e));
            stays.find_map(used)
        } else {
            None
        };
        in_use.or_else(|| comes.find_map(used)).map_or(Ok(()), Err)
    }

    /// Changes the mesh.
    fn make(
        &mut self,
        edits: &Edits<S>,
        taken: &[(usize, [u32; 2])],
        vertices: &mut Vertices,
    ) -> Result<(), EditError> {
        let gone = self.gone(&edits.remove_points);
        let [comes, goes] = [
            edits.points.len() + edits.edges.len(),
            edits.remove_points.len() + taken.len(),
        ];
        if comes + goes >= MANY && 4 * (comes + goes) >= self.mesh.len() {
            self.clear();
        } else {
            self.open(taken)?;
            self.remove_vertices(&gone)?;
        }
        if self.mesh.len() == 0 {
            return self.begin_anew(edits, &gone, vertices);
        }
        self.insert_points(&edits.points, vertices)?;
        self.insert_edges(&edits.edges, vertices)
    }

    /// Removes all triangles.
    fn clear(&mut self) {
        let all: Vec<u32> = self.mesh.all().collect();
        for v in all
            .iter()
            .filter_map(|&t| self.mesh.triangle(t))
            .flatten()
            .collect::<Vec<_>>()
        {
            self.mesh.set_at(v, NONE);
        }
        for t in all {
            self.mesh.kill(t);
        }
    }

    /// Takes edges away from the sides that they cover, and sweeps what is not Delaunay then.
    fn open(&mut self, taken: &[(usize, [u32; 2])]) -> Result<(), EditError> {
        let mut opened = Vec::new();
        let taken = if self.mesh.len() > 0 { taken } else { &[] };
        for &(_, ends) in taken {
            let ends = ends.map(|point| self.points.vertex(point as usize).expect("an end"));
            for (side, _) in self.sides_along(ends) {
                for side in [side, self.mesh.twin(side)]
                    .into_iter()
                    .filter(|&side| side != NONE)
                {
                    self.mesh.set_covers(side, self.mesh.covers(side) - 1);
                }
                opened.push(side);
            }
        }
        opened.retain(|&side| self.is_wrong(side));
        while !opened.is_empty() {
            for side in opened {
                self.region.add(side / 3);
                self.region.add(self.mesh.twin(side) / 3);
            }
            let [found, mut across] = self.sweep(&[], &[], &[])?;
            self.last = found[0];
            across.retain(|&side| self.is_wrong(side));
            if across.is_empty() {
                break;
            }
            // The region doubles, so that all rounds together cost as much as the last one.
            for &t in &found {
                self.region.add(t);
            }
            self.widen(&across, found.len());
            opened = across;
        }
        Ok(())
    }

    /// Adds triangles to the region, beginning across these sides, until there are this many more or no more.
    fn widen(&mut self, sides: &[u32], count: usize) {
        let mut waiting: VecDeque<u32> = sides.iter().map(|&side| side / 3).collect();
        let most = self.region.triangles.len() + count.max(sides.len());
        while let Some(t) = waiting.pop_front() {
            if self.region.has(t) || self.region.triangles.len() >= most {
                continue;
            }
            self.region.add(t);
            for side in (3 * t..3 * t + 3).filter(|&side| self.mesh.covers(side) == 0) {
                let across = self.mesh.twin(side);
                waiting.extend((across != NONE).then_some(across / 3));
            }
        }
    }

    /// The vertices all of whose points go, sorted.
    fn gone(&self, points: &[usize]) -> Vec<u32> {
        let vertices = points.iter().filter_map(|&point| self.points.vertex(point));
        let mut vertices: Vec<u32> = vertices.collect();
        vertices.sort_unstable();
        let alike = vertices.chunk_by(|v, w| v == w);
        let gone = alike.filter(|alike| alike.len() == self.points.multiplicity(alike[0]));
        gone.map(|alike| alike[0]).collect()
    }

    /// Removes vertices at which no edge ends.
    fn remove_vertices(&mut self, gone: &[u32]) -> Result<(), EditError> {
        for &v in gone {
            let corners: Vec<u32> = self.mesh.star(v).collect();
            for corner in corners {
                self.region.add(corner / 3);
                for side in [next(corner), prev(corner)] {
                    if self.mesh.twin(side) == NONE {
                        self.region.add_beyond(side);
                    }
                }
            }
        }
        self.sweep_region(gone, &[], &[])?;
        for &v in gone {
            self.mesh.set_at(v, NONE);
        }
        Ok(())
    }

    /// Where there are no triangles to keep, all points and edges are swept.
    fn begin_anew(
        &mut self,
        edits: &Edits<S>,
        gone: &[u32],
        vertices: &mut Vertices,
    ) -> Result<(), EditError> {
        let old = self
            .points
            .vertices()
            .filter(|v| gone.binary_search(v).is_err());
        let mut all: Vec<u32> = old.collect();
        for point in &edits.points {
            all.push(self.reserve(point, vertices));
        }
        let new = edits.edges.iter().enumerate();
        let new = new.map(|(i, &ends)| (self.edges.len() + i, ends));
        let pieces = self.edges().chain(new).map(|(e, ends)| Piece {
            ends: ends.map(|point| self.end(point, vertices)),
            covers: 1,
            edge: Some(e),
        });
        let pieces: Vec<Piece> = pieces.collect();
        self.sweep_region(&[], &all, &pieces)?;
        self.merge(vertices);
        Ok(())
    }

    fn insert_points(
        &mut self,
        points: &[[S; 2]],
        vertices: &mut Vertices,
    ) -> Result<(), EditError> {
        vertices.of_new.resize(points.len(), NONE);
        for i in self.insertion_order(points) {
            let place = self.find(&points[i]);
            if let Place::Vertex(v) = place {
                vertices.of_new[i] = v;
                continue;
            }
            let v = self.points.reserve(points[i].clone());
            vertices.reserved.push(v);
            vertices.of_new[i] = v;
            self.add_conflicts(v, place);
            if !self.has_star(v) {
                self.sweep_region(&[], &[v], &[])?;
            }
        }
        Ok(())
    }

    /// An order in which points come: half of them, by chance, last, of the others half before those, and so on; each
    /// round cell by cell of the grid. So a point changes few triangles, and the way from one to the next is short
    /// (Amenta, Choi and Rote 2003).
    fn insertion_order(&self, points: &[[S; 2]]) -> Vec<usize> {
        let chance = |i: usize| (i as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        let key = |(i, point)| {
            (
                Reverse(chance(i).leading_zeros()),
                self.hints.cell(point),
                i,
            )
        };
        let mut order: Vec<_> = points.iter().enumerate().map(key).collect();
        order.sort_unstable_by(|(round, cell, i), (other, other_cell, j)| {
            let ([ax, ay], [bx, by]) = (&points[*i], &points[*j]);
            let places = || ax.compare(bx).then_with(|| ay.compare(by));
            (round, cell).cmp(&(other, other_cell)).then_with(places)
        });
        order.into_iter().map(|(.., i)| i).collect()
    }

    fn insert_edges(&mut self, edges: &[[usize; 2]], vertices: &Vertices) -> Result<(), EditError> {
        let mut pieces = Vec::new();
        for (i, ends) in edges.iter().enumerate() {
            let ends = ends.map(|point| self.end(point, vertices));
            pieces.extend(self.pierce(ends, self.edges.len() + i, edges.len() == 1));
        }
        // A part that is a side and stays one is covered once more.
        let mut swept = Vec::new();
        for (piece, side) in pieces {
            let stays = side.filter(|&side| {
                let across = self.mesh.twin(side);
                !self.region.has(side / 3) || across == NONE || !self.region.has(across / 3)
            });
            let Some(side) = stays else {
                swept.push(piece);
                continue;
            };
            for side in [side, self.mesh.twin(side)]
                .into_iter()
                .filter(|&side| side != NONE)
            {
                self.mesh.set_covers(side, self.mesh.covers(side) + 1);
            }
        }
        self.sweep_region(&[], &[], &swept)
    }

    /// Sweeps the region, if there is anything to sweep.
    fn sweep_region(
        &mut self,
        gone: &[u32],
        new: &[u32],
        pieces: &[Piece],
    ) -> Result<(), EditError> {
        if self.region.is_empty() && new.is_empty() {
            return Ok(());
        }
        let [found, across] = self.sweep(gone, new, pieces)?;
        let near = found.first().copied().or_else(|| Some(across.first()? / 3));
        self.last = near.unwrap_or(self.last);
        Ok(())
    }

    fn reserve(&mut self, point: &[S; 2], vertices: &mut Vertices) -> u32 {
        let v = self.points.reserve(point.clone());
        vertices.reserved.push(v);
        vertices.of_new.push(v);
        v
    }

    /// New points that equal others share their vertex.
    fn merge(&mut self, vertices: &mut Vertices) {
        let same = std::mem::take(&mut self.same);
        for v in &mut vertices.of_new {
            *v = same.get(v).copied().unwrap_or(*v);
        }
    }

    /// The vertex of a point, old or new.
    fn end(&self, point: usize, vertices: &Vertices) -> u32 {
        let old = self.points.vertex(point);
        old.unwrap_or_else(|| vertices.of_new[point - self.points.next()])
    }

    /// Keeps what was made, and says what it changed.
    pub(crate) fn commit(
        &mut self,
        edits: Edits<S>,
        taken: &[(usize, [u32; 2])],
        vertices: &Vertices,
        is_told: bool,
    ) -> Change {
        let [gone, new] = if is_told {
            self.mesh.read()
        } else {
            self.mesh.forget();
            Default::default()
        };
        let named = |points: &Points<S>, mut list: Vec<u128>| {
            for t in &mut list {
                *t = packed(unpacked(*t).map(|v| number(points.name(v))));
            }
            list.sort_unstable();
            let numbers = list.into_iter().map(unpacked);
            numbers.map(|t| t.map(|point| point as usize)).collect()
        };
        let gone = named(&self.points, gone);
        let (first_point, first_edge) = (self.points.next(), self.edges.len());
        for &v in &vertices.of_new {
            self.points.add(v);
        }
        for end in taken.iter().flat_map(|(_, ends)| ends) {
            *self.points.uses_mut(*end as usize) -= 1;
        }
        for ends in edits.edges {
            for end in ends {
                *self.points.uses_mut(end) += 1;
            }
            self.edges.push(Some(ends.map(number)));
        }
        for point in edits.remove_points {
            self.points.remove(point);
        }
        for &v in &vertices.reserved {
            self.points.release_unused(v);
        }
        if self.hints.is_full(vertices.reserved.len()) {
            let vertices: Vec<u32> = self.points.vertices().collect();
            self.hints = Hints::new(vertices.iter().map(|&v| (v, self.points.place(v))));
        }
        for &v in &vertices.reserved {
            self.hints.keep(v, self.points.place(v));
        }
        Change {
            points: first_point..self.points.next(),
            edges: first_edge..self.edges.len(),
            gone,
            new: named(&self.points, new),
        }
    }
}

/// The vertices of the points that come.
#[derive(Debug, Default)]
pub(crate) struct Vertices {
    /// For each of these points its vertex.
    pub(crate) of_new: Vec<u32>,
    /// The vertices that are new.
    pub(crate) reserved: Vec<u32>,
}
