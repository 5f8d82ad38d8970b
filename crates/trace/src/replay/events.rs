//! The requirements of each event of a replay, and the changes that it makes.

use super::edge::Edge;
use super::mesh::sides;
use super::{Phase, Replay, ensure};
use sweep_cdt::trace::{Event, Outcome, PointCase, Vertex, Why};

impl Replay {
    /// Takes a step; `is_due` says whether the steps before required it.
    pub(super) fn apply(&mut self, event: Event, is_due: bool) -> Result<(), String> {
        match event {
            Event::Sorted { vertex } => self.sorted(vertex),
            Event::Point {
                vertex,
                case,
                segment,
            } => self.point(vertex, case, segment),
            Event::Triangle { vertices, why } => self.triangle(vertices, why, is_due),
            Event::Test {
                side,
                opposite,
                outcome,
            } => self.test(side, opposite, outcome),
            Event::Flip { side, new_side } => self.flip(side, new_side, is_due),
            Event::FrontInsert { vertex, after } => {
                ensure(is_due, || {
                    format!("vertex {vertex} does not join the front now")
                })?;
                self.front.insert(vertex, after)
            }
            Event::FrontRemove { vertex } => self.front.remove(vertex),
            Event::Edge { edge, upper, lower } => self.begin_edge(edge, upper, lower),
            Event::Switch { to_front, segment } => {
                let [left, right] = segment;
                ensure(left == right || self.front.is_segment(segment), || {
                    format!("there is no front segment {left} {right}")
                })?;
                inserted(&mut self.edge)?.switch(to_front, segment)
            }
            Event::Part { from, to, position } => {
                ensure(self.is_below(to, from), || {
                    format!("vertex {to} is not below vertex {from}")
                })?;
                inserted(&mut self.edge)?.part([from, to], position, &self.mesh)?;
                self.note_rest(to)
            }
            Event::Pierced { vertices } => {
                inserted(&mut self.edge)?.pierce(vertices, &self.mesh)?;
                self.mesh.remove(vertices)
            }
            Event::Border { polygon, vertex } => inserted(&mut self.edge)?.border(polygon, vertex),
            Event::Fixed { side } => {
                inserted(&mut self.edge)?.fix(side, &self.mesh)?;
                self.mesh.fix(side);
                Ok(())
            }
            Event::Finalization => self.finalize(),
            Event::Removed { vertices } => self.remove(vertices),
            Event::Finished { triangles } => self.finish(triangles),
        }
    }

    fn current(&self) -> Option<Vertex> {
        self.order[..self.swept].last().copied()
    }

    /// Whether `low` comes before `high` in sweep order.
    fn is_below(&self, low: Vertex, high: Vertex) -> bool {
        let rank = |v| self.ranks.get(&v);
        rank(low).is_some_and(|low| rank(high).is_some_and(|high| low < high))
    }

    /// Checks that the last point or edge event is complete.
    fn complete(&self) -> Result<(), String> {
        ensure(self.below.is_none(), || {
            "the left case lacks a triangle".to_owned()
        })?;
        ensure(self.edge.as_ref().is_none_or(Edge::is_complete), || {
            "the edge before is not inserted".to_owned()
        })
    }

    fn sorted(&mut self, vertex: Vertex) -> Result<(), String> {
        ensure(
            self.phase == Phase::Sorting && !is_artificial(vertex),
            || format!("vertex {vertex} cannot be sorted here"),
        )?;
        ensure(
            self.ranks.insert(vertex, self.order.len()).is_none(),
            || format!("vertex {vertex} is sorted twice"),
        )?;
        self.order.push(vertex);
        Ok(())
    }

    fn point(&mut self, p: Vertex, case: PointCase, segment: [Vertex; 2]) -> Result<(), String> {
        self.complete()?;
        let is_next = self.phase == Phase::Sweeping && self.order.get(self.swept) == Some(&p);
        ensure(is_next, || format!("vertex {p} is not the next one"))?;
        let [left, right] = segment;
        ensure(self.front.is_segment(segment), || {
            format!("there is no front segment {left} {right}")
        })?;
        self.swept += 1;
        self.edge = None;
        self.below = (case == PointCase::Left).then_some(left);
        self.due.extend([
            Event::Triangle {
                vertices: [p, left, right],
                why: Why::Point,
            },
            Event::FrontInsert {
                vertex: p,
                after: left,
            },
        ]);
        Ok(())
    }

    fn triangle(&mut self, vertices: [Vertex; 3], why: Why, is_due: bool) -> Result<(), String> {
        let is_sweeping = self.phase == Phase::Sweeping;
        let may_be_here = match why {
            Why::First => self.first(vertices),
            Why::Point => is_due || self.is_second(vertices),
            Why::NarrowCorner => is_sweeping && self.edge.is_none() && self.filled(vertices),
            Why::Basin => is_sweeping && self.edge.is_none() && self.below.is_none(),
            Why::Pocket => self.edge.as_ref().is_some_and(Edge::may_fill_pockets),
            Why::PseudoPolygon => self.edge.as_ref().is_some_and(Edge::may_fill_polygon),
            Why::Hull => self.phase == Phase::Finalizing && self.edge.is_none(),
        };
        let [a, b, c] = vertices;
        ensure(may_be_here, || {
            format!("triangle {a} {b} {c} cannot be made here for that reason")
        })?;
        for side in sides(vertices) {
            self.front.cover(side);
            ensure(
                side.into_iter()
                    .all(|v| is_artificial(v) || self.is_swept(v)),
                || "not all vertices are swept".to_owned(),
            )?;
        }
        self.mesh.add(vertices)
    }

    fn is_swept(&self, v: Vertex) -> bool {
        self.ranks.get(&v).is_some_and(|&rank| rank < self.swept)
    }

    /// Whether this is the first triangle; ends the sorting.
    fn first(&mut self, vertices: [Vertex; 3]) -> bool {
        let Some(&vertex) = self.order.first().filter(|_| self.phase == Phase::Sorting) else {
            return false;
        };
        (self.phase, self.swept) = (Phase::Sweeping, 1);
        let after = Vertex::Left;
        self.due.push_back(Event::FrontInsert { vertex, after });
        vertices == [vertex, Vertex::Left, Vertex::Right]
    }

    /// Whether this is the second triangle of a left case.
    fn is_second(&mut self, vertices: [Vertex; 3]) -> bool {
        let Some((corner, p)) = self.below.take().zip(self.current()) else {
            return false;
        };
        self.due.push_back(Event::FrontRemove { vertex: corner });
        self.front
            .prev(corner)
            .is_some_and(|far| vertices == [p, far, corner])
    }

    /// Whether the triangle closes the corner of the front right or left of the new vertex.
    fn filled(&mut self, [p, b, c]: [Vertex; 3]) -> bool {
        let is_right = self.front.is_segment([p, b]) && self.front.is_segment([b, c]);
        let is_left = self.front.is_segment([b, c]) && self.front.is_segment([c, p]);
        let vertex = if is_right { b } else { c };
        self.due.push_back(Event::FrontRemove { vertex });
        self.below.is_none() && self.current() == Some(p) && (is_right || is_left)
    }

    fn test(
        &mut self,
        side: [Vertex; 2],
        opposite: [Vertex; 2],
        outcome: Outcome,
    ) -> Result<(), String> {
        let ([a, b], [p, q]) = (side, opposite);
        ensure(self.mesh.is_between(side, opposite), || {
            format!("side {a} {b} is not between {p} and {q}")
        })?;
        let is_fixed = self.mesh.is_fixed(side);
        ensure(is_fixed == (outcome == Outcome::Fixed), || {
            let not = if is_fixed { "" } else { "not " };
            format!("side {a} {b} is {not}fixed")
        })?;
        if outcome == Outcome::Illegal {
            self.due.push_back(Event::Flip {
                side,
                new_side: opposite,
            });
        }
        Ok(())
    }

    fn flip(
        &mut self,
        [a, b]: [Vertex; 2],
        [p, q]: [Vertex; 2],
        is_due: bool,
    ) -> Result<(), String> {
        ensure(is_due, || "no test asks for this flip".to_owned())?;
        self.mesh.remove([a, b, p])?;
        self.mesh.remove([b, a, q])?;
        self.mesh.add([p, a, q])?;
        self.mesh.add([q, b, p])
    }

    fn begin_edge(&mut self, edge: usize, upper: Vertex, lower: Vertex) -> Result<(), String> {
        self.complete()?;
        if self.phase == Phase::Finalizing {
            ensure(self.rests.remove(&(upper, lower, edge)), || {
                format!("edge {edge} has no rest from {upper} to {lower}")
            })?;
        } else {
            self.begin_whole_edge(edge, upper, lower)?;
        }
        self.edge = Some(Edge::new(edge, upper, lower));
        Ok(())
    }

    fn begin_whole_edge(
        &mut self,
        edge: usize,
        upper: Vertex,
        lower: Vertex,
    ) -> Result<(), String> {
        let is_sweeping = self.phase == Phase::Sweeping;
        ensure(is_sweeping && self.current() == Some(upper), || {
            format!("vertex {upper} is not the one swept last")
        })?;
        ensure(self.is_below(lower, upper), || {
            format!("vertex {lower} is not below vertex {upper}")
        })?;
        ensure(self.edges.insert(edge), || {
            format!("edge {edge} comes twice")
        })?;
        Ok(())
    }

    /// Notes what is left of the edge below its part, which ends at `end`.
    fn note_rest(&mut self, end: Vertex) -> Result<(), String> {
        let &mut Edge {
            number,
            upper,
            lower,
            ..
        } = inserted(&mut self.edge)?;
        if self.phase == Phase::Sweeping {
            // An edge that equals an earlier one has the same parts, and only one of them goes on below.
            if let Some(first) = self.first_parts.insert([upper, lower], end) {
                return ensure(first == end, || {
                    format!("an equal edge met vertex {first} first")
                });
            }
        }
        ensure(end == lower || self.is_below(lower, end), || {
            format!("vertex {lower} is not below vertex {end}")
        })?;
        if end != lower {
            self.rests.insert((end, lower, number));
        }
        Ok(())
    }

    fn finalize(&mut self) -> Result<(), String> {
        self.complete()?;
        ensure(
            self.phase < Phase::Finalizing && self.swept == self.order.len(),
            || "not all vertices are swept".to_owned(),
        )?;
        (self.phase, self.edge) = (Phase::Finalizing, None);
        Ok(())
    }

    fn remove(&mut self, vertices: [Vertex; 3]) -> Result<(), String> {
        self.complete()?;
        ensure(self.rests.is_empty(), || {
            "the rest of an edge is not inserted".to_owned()
        })?;
        let is_time = matches!(self.phase, Phase::Finalizing | Phase::Removing);
        ensure(is_time && vertices.into_iter().any(is_artificial), || {
            "this triangle is not removed now".to_owned()
        })?;
        self.phase = Phase::Removing;
        self.mesh.remove(vertices)
    }

    fn finish(&mut self, expected: usize) -> Result<(), String> {
        ensure(self.phase >= Phase::Finalizing, || {
            "the finalization is missing".to_owned()
        })?;
        self.phase = Phase::Finished;
        let triangles = self.mesh.triangles();
        ensure(
            !triangles.iter().flatten().any(|&v| is_artificial(v)),
            || "an artificial triangle is left".to_owned(),
        )?;
        ensure(triangles.len() == expected, || {
            format!("there are {} triangles", triangles.len())
        })?;
        self.mesh.check_disc(&self.order)
    }
}

fn is_artificial(v: Vertex) -> bool {
    matches!(v, Vertex::Left | Vertex::Right)
}

fn inserted(edge: &mut Option<Edge>) -> Result<&mut Edge, String> {
    edge.as_mut()
        .ok_or_else(|| "no edge is inserted now".to_owned())
}
