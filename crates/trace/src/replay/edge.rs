//! An edge event in a replay: its part comes first, from the upper end to the first vertex on the edge. Then the part
//! is inserted: as the side that is there already, or in place of the triangles that it pierces.

use std::collections::BTreeSet;

use super::mesh::{self, Mesh, Side, across};
use sweep_cdt::trace::{EdgePosition, PseudoPolygon, Vertex};

#[derive(Debug)]
pub(super) struct Edge {
    pub(super) number: usize,
    pub(super) upper: Vertex,
    pub(super) lower: Vertex,
    /// The switches so far: whether to the front, and whether at a vertex.
    switches: Vec<(bool, bool)>,
    part: Option<[Vertex; 2]>,
    is_complete: bool,
    hole: Hole,
}

/// The hole that the triangles pierced by a part leave.
#[derive(Debug, Default)]
struct Hole {
    /// The triangle removed last.
    last: Option<[Vertex; 3]>,
    /// The sides of the removed triangles that were not yet named as borders.
    sides: BTreeSet<Side>,
    border: Vec<Side>,
    /// The pseudo-polygon of the last border vertex, and that vertex.
    polygon: Option<(PseudoPolygon, Vertex)>,
    /// How many borders are complete.
    complete: usize,
}

impl Edge {
    pub(super) fn new(number: usize, upper: Vertex, lower: Vertex) -> Edge {
        Edge {
            number,
            upper,
            lower,
            switches: Vec::new(),
            part: None,
            is_complete: false,
            hole: Hole::default(),
        }
    }

    /// Whether pockets may be filled: after the part has come, before it is inserted.
    pub(super) fn may_fill_pockets(&self) -> bool {
        self.part.is_some() && !self.is_complete && self.hole.last.is_none()
    }

    pub(super) fn may_fill_polygon(&self) -> bool {
        self.hole.complete > 0 && self.hole.polygon.is_none()
    }

    pub(super) fn is_complete(&self) -> bool {
        self.is_complete
    }

    pub(super) fn switch(&mut self, to_front: bool, segment: [Vertex; 2]) -> Result<(), String> {
        let is_on_front = self.switches.last().is_some_and(|&(to_front, _)| to_front);
        if self.part.is_some() || is_on_front == to_front {
            return Err("no switch can be here".to_owned());
        }
        let [left, right] = segment;
        let is_at_vertex = left == right;
        // Only the first switch is at a vertex, where the part begins; no crossed segment ends there.
        let is_right = if is_at_vertex {
            left == self.upper && self.switches.is_empty()
        } else {
            !segment.contains(&self.upper)
        };
        if !is_right {
            return Err(format!("the edge cannot be at {left} {right} now"));
        }
        self.switches.push((to_front, is_at_vertex));
        Ok(())
    }

    pub(super) fn part(
        &mut self,
        [from, to]: [Vertex; 2],
        position: EdgePosition,
        mesh: &Mesh,
    ) -> Result<(), String> {
        if self.part.is_some() || from != self.upper {
            return Err(format!("no part of the edge begins at {from} now"));
        }
        let is_there = mesh.has([from, to]) || mesh.has([to, from]);
        let met = match self.switches[..] {
            [] if is_there => EdgePosition::Present,
            [] => EdgePosition::BelowFront,
            [(_, true)] => EdgePosition::FrontOnly,
            _ => EdgePosition::Mixed,
        };
        if position != met {
            return Err("the steps before make it another position".to_owned());
        }
        self.part = Some([from, to]);
        Ok(())
    }

    fn current(&self) -> Result<[Vertex; 2], String> {
        let part = self.part.filter(|_| !self.is_complete);
        part.ok_or_else(|| "no part of an edge is inserted now".to_owned())
    }

    pub(super) fn pierce(&mut self, vertices: [Vertex; 3], mesh: &Mesh) -> Result<(), String> {
        let [from, _] = self.current()?;
        let follows = match self.hole.last {
            None => vertices.contains(&from),
            Some(last) => {
                let is_shared = |&side: &Side| {
                    mesh::sides(last).contains(&across(side)) && !mesh.is_fixed(side)
                };
                mesh::sides(vertices).iter().any(is_shared)
            }
        };
        if !follows || self.hole.complete > 0 || self.hole.polygon.is_some() {
            return Err("the edge does not come to this triangle now".to_owned());
        }
        self.hole.sides.extend(mesh::sides(vertices));
        self.hole.last = Some(vertices);
        Ok(())
    }

    /// Takes a border vertex: first those left of the part, from its lower end, then those right, from its upper end.
    pub(super) fn border(&mut self, polygon: PseudoPolygon, v: Vertex) -> Result<(), String> {
        let [from, to] = self.current()?;
        let hole = &mut self.hole;
        let (start, end) = if hole.complete == 0 {
            (to, from)
        } else {
            (from, to)
        };
        let reaches_end = hole.last.is_some_and(|last| last.contains(&to));
        let Some((begun, last)) = hole.polygon else {
            if v != start || !reaches_end || hole.complete > 1 {
                return Err(format!("no border begins at {v} now"));
            }
            hole.polygon = Some((polygon, v));
            return Ok(());
        };
        if polygon != begun || !hole.sides.remove(&[last, v]) {
            return Err(format!("the border does not lead to {v}"));
        }
        hole.border.push([last, v]);
        hole.polygon = Some((polygon, v));
        if v == end {
            hole.polygon = None;
            hole.complete += 1;
        }
        Ok(())
    }

    pub(super) fn fix(&mut self, part: [Vertex; 2], mesh: &Mesh) -> Result<(), String> {
        let sides = [part, across(part)].map(|side| mesh.has(side));
        let hole = std::mem::take(&mut self.hole);
        let is_there = if hole.last.is_none() {
            sides.contains(&true)
        } else {
            let is_inner = |&side: &Side| hole.sides.contains(&across(side));
            hole.complete == 2
                && hole.sides.iter().all(is_inner)
                && hole.border.iter().all(|&side| mesh.has(side))
                && sides == [true; 2]
        };
        if self.current()? != part || !is_there {
            return Err("this part of the edge cannot be fixed now".to_owned());
        }
        self.is_complete = true;
        Ok(())
    }
}
