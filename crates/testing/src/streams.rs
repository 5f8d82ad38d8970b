//! Inputs as streams: sorted, pushed vertex by vertex, and what comes out, put together again.

use std::cmp::Ordering;
use std::collections::BTreeSet;

use sweep_cdt::front::AnyFront;
use sweep_cdt::stream::{Final, StreamError};
use sweep_cdt::verify::{Level, StreamVerifier, StreamViolation, Verifier};
use sweep_cdt::{Error, Triangulation, Triangulator};
use sweep_cdt_generate::Random;

use crate::Input;
use crate::oracle::Answer;
use crate::samples::{Sample, convert};

/// How an input is streamed.
#[derive(Clone, Debug)]
pub struct Streaming {
    /// New vertices of a window.
    pub window: usize,
    /// Whether the range of x is told beforehand.
    pub is_range_known: bool,
    /// The front.
    pub front: AnyFront,
}

/// The outcome of a stream; `None` if the scalar cannot hold a coordinate, or the input is none for a stream.
///
/// # Panics
/// If the stream passes on something twice, or ends with an error that no sorted stream should have.
pub fn streamed<S: Sample + Clone>(
    input: &Input,
    way: &Streaming,
) -> Option<Result<Answer, Error>> {
    let points = convert::<S>(&input.points)?;
    let is_fed = points.iter().flatten().all(S::is_finite)
        && input.edges.iter().flatten().all(|&v| v < points.len());
    is_fed.then(|| collected(&points, &input.edges, way))
}

fn collected<S: Sample + Clone>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    way: &Streaming,
) -> Result<Answer, Error> {
    let order = |&u: &usize, &v: &usize| sweep_order(&points[u], &points[v]);
    let mut sorted: Vec<usize> = (0..points.len()).collect();
    sorted.sort_by(order);
    let mut answer = Answer {
        triangles: Vec::new(),
        constrained: Vec::new(),
        hull: Vec::new(),
        representatives: (0..points.len()).collect(),
        chains: Vec::new(),
    };
    let mut hull = Vec::new();
    let small = |number: u64| usize::try_from(number).expect("a position");
    let mut stream = Triangulator::new()
        .front(way.front.clone())
        .stream(|found| match found {
            Final::Triangle {
                corners,
                constrained,
            } => {
                let corners = corners.map(small);
                let first = (0..3).min_by_key(|&i| corners[i]).unwrap_or(0);
                let mut lowest_first = corners;
                lowest_first.rotate_left(first);
                answer.triangles.push(lowest_first);
                for side in (0..3).filter(|&side| constrained[side]) {
                    let [u, v] = [1, 2].map(|i| corners[(side + i) % 3]);
                    answer.constrained.push([u.min(v), u.max(v)]);
                }
            }
            Final::HullSide { ends } => hull.push(ends.map(small)),
            Final::Duplicate { number, of } => {
                answer.representatives[small(number)] = small(of);
            }
            other => panic!("{other:?} is unknown"),
        })
        .window(way.window);
    let by_x = |u: &&[S; 2], v: &&[S; 2]| u[0].compare(&v[0]);
    if way.is_range_known
        && let (Some([least, _]), Some([most, _])) =
            (points.iter().min_by(by_x), points.iter().max_by(by_x))
    {
        stream = stream.between(least.clone(), most.clone());
    }
    let fed = feed(&mut stream, points, edges, &sorted);
    let ended = fed.and_then(|()| stream.finish());
    match ended {
        Ok(stats) => assert_eq!(stats.triangles, answer.triangles.len() as u64),
        Err(StreamError::CrossingEdges { edges }) => {
            let edges = edges.map(small);
            return Err(Error::CrossingEdges { edges });
        }
        Err(error) => panic!("{error}"),
    }
    answer.triangles.sort_unstable();
    answer.constrained.sort_unstable();
    let twice = answer.triangles.windows(2).find(|two| two[0] == two[1]);
    assert_eq!(twice, None, "passed on twice");
    answer.constrained.dedup();
    answer.hull = around(points, &hull);
    let of = &answer.representatives;
    let chain = |&[u, v]: &[usize; 2]| chain(points, of, [of[u], of[v]]);
    answer.chains = edges.iter().map(chain).collect();
    if !answer.triangles.is_empty() {
        for (u, v) in answer
            .chains
            .iter()
            .flat_map(|chain| chain.iter().zip(&chain[1..]))
        {
            let side = [*u.min(v), *u.max(v)];
            assert!(answer.constrained.contains(&side), "{side:?} is no side");
        }
    }
    Ok(answer)
}

/// Pushes each vertex, and the edges that begin there.
fn feed<S: Sample + Clone, O: FnMut(Final)>(
    stream: &mut sweep_cdt::stream::Stream<'_, S, O, AnyFront>,
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    sorted: &[usize],
) -> Result<(), StreamError> {
    for &v in sorted {
        stream.push(v as u64, points[v].clone())?;
        for (e, &[a, b]) in edges.iter().enumerate() {
            let other = if a == v { b } else { a };
            if (a == v || b == v) && sweep_order(&points[v], &points[other]).is_lt() {
                stream.edge(e as u64, points[other].clone())?;
            }
        }
    }
    Ok(())
}

fn sweep_order<S: Sample>(u: &[S; 2], v: &[S; 2]) -> Ordering {
    u[1].compare(&v[1]).then_with(|| u[0].compare(&v[0]))
}

/// The sides of the hull as one chain, from the leftmost, upper vertex.
fn around<S: Sample>(points: &[[S; 2]], sides: &[[usize; 2]]) -> Vec<usize> {
    let order = |u: usize, v: usize| {
        let [u, v] = [u, v].map(|v| &points[v]);
        u[0].compare(&v[0]).then_with(|| v[1].compare(&u[1]))
    };
    let Some(first) = sides
        .iter()
        .map(|side| side[0])
        .min_by(|&u, &v| order(u, v))
    else {
        return Vec::new();
    };
    let mut chain = vec![first];
    while chain.len() < sides.len() {
        let last = *chain.last().expect("a first one");
        let mut next = sides.iter().filter(|side| side[0] == last);
        let (Some(side), None) = (next.next(), next.next()) else {
            panic!("the hull is no chain at {last}: {sides:?}");
        };
        chain.push(side[1]);
    }
    assert!(
        sides.contains(&[chain[sides.len() - 1], first]),
        "the hull is not closed: {sides:?}"
    );
    chain
}

/// The vertices on an edge, by definition, from its upper end.
fn chain<S: Sample>(points: &[[S; 2]], of: &[usize], [u, v]: [usize; 2]) -> Vec<usize> {
    let (low, high) = match sweep_order(&points[u], &points[v]) {
        Ordering::Less => (u, v),
        _ => (v, u),
    };
    let is_on = |w: usize| {
        let [low, high, w] = [low, high, w].map(|v| &points[v]);
        sweep_order(low, w).is_le()
            && sweep_order(w, high).is_le()
            && (sweep_order(low, high).is_eq() || S::orient2d(low, high, w).0.is_eq())
    };
    let mut chain: Vec<usize> = (0..points.len())
        .filter(|&w| of[w] == w && is_on(w))
        .collect();
    chain.sort_by(|&a, &b| sweep_order(&points[b], &points[a]));
    chain
}

/// The triangles of a result as a stream, right or with a change.
#[derive(Clone, Debug)]
pub struct Altered<'a> {
    points: &'a [[f64; 2]],
    edges: &'a [[usize; 2]],
    result: &'a Triangulation,
    /// Corners, and whether the side opposite each is constrained.
    triangles: Vec<([usize; 3], [bool; 3])>,
}

impl<'a> Altered<'a> {
    /// The result itself.
    pub fn right(
        points: &'a [[f64; 2]],
        edges: &'a [[usize; 2]],
        result: &'a Triangulation,
    ) -> Self {
        let sides = |t| [0, 1, 2].map(|side| result.is_constrained(t, side));
        Altered {
            points,
            edges,
            result,
            triangles: (0..result.len())
                .map(|t| (result.triangle(t), sides(t)))
                .collect(),
        }
    }

    /// The result with some change, after which it may still be right.
    pub fn wrong(
        points: &'a [[f64; 2]],
        edges: &'a [[usize; 2]],
        result: &'a Triangulation,
        random: &mut Random,
    ) -> Self {
        let mut altered = Altered::right(points, edges, result);
        if !result.is_empty() {
            altered.change(random);
        }
        altered
    }

    fn change(&mut self, random: &mut Random) {
        let list = &mut self.triangles;
        let (t, side) = (random.below(list.len()), random.below(3));
        let twin = self.result.neighbor(t, side).map(|next| {
            let back = (0..3).find(|&side| self.result.neighbor(next, side) == Some(t));
            (next, back.expect("neighbors of each other"))
        });
        match (random.below(8), twin) {
            (0, _) => drop(list.swap_remove(t)),
            (1, _) => list.push(list[t]),
            (2, _) => list[t].0.swap(0, 1),
            (3, _) => list[t].1[side] ^= true,
            (4, _) => {
                let other = random.below(self.points.len());
                list[t].0[side] = self.result.representative(other);
            }
            (5, _) => list[t].0 = list[random.below(list.len())].0,
            (6, Some((next, back))) => {
                list[t].1[side] ^= true;
                list[next].1[back] ^= true;
            }
            (6, None) => list[t].1[side] ^= true,
            // The side is flipped, whether that leaves two triangles or not.
            (_, Some((next, back))) => {
                let [(a, of_a), (b, of_b)] = [list[t], list[next]];
                let turned = |i: usize, k: usize| (i + k) % 3;
                let (u, v) = (a[turned(side, 1)], a[turned(side, 2)]);
                let (apex, other) = (a[side], b[back]);
                list[t] = (
                    [apex, u, other],
                    [of_b[turned(back, 1)], false, of_a[turned(side, 2)]],
                );
                list[next] = (
                    [apex, other, v],
                    [of_b[turned(back, 2)], of_a[turned(side, 1)], false],
                );
            }
            (_, None) => drop(list.swap_remove(t)),
        }
    }

    /// Panics unless the verifier of streams accepts the triangles exactly if the verifier in memory finds the canonical
    /// triangulation, and all constrained sides are marked and no others.
    ///
    /// # Panics
    /// If the verdicts differ.
    pub fn assert_verdict(&self) {
        let list: Vec<[usize; 3]> = self.triangles.iter().map(|(corners, _)| *corners).collect();
        let report = Verifier::new().verify(self.points, self.edges, &list);
        let is_canonical = report.is_ok_and(|report| report.level == Some(Level::Canonical));
        let constrained: BTreeSet<[usize; 2]> = self
            .result
            .constrained_sides()
            .map(|[u, v]| [u.min(v), u.max(v)])
            .collect();
        let is_marked = |(corners, marks): &([usize; 3], [bool; 3])| {
            (0..3).all(|side| {
                let [u, v] = [1, 2].map(|i| corners[(side + i) % 3]);
                marks[side] == constrained.contains(&[u.min(v), u.max(v)])
            })
        };
        let is_right = is_canonical && self.triangles.iter().all(is_marked);
        let verdict = self.verdict(true);
        assert_eq!(verdict.is_ok(), is_right, "{verdict:?}: {self:?}");
        let verdict = self.verdict(false);
        assert_eq!(
            verdict.is_ok(),
            is_canonical,
            "unmarked: {verdict:?}: {self:?}"
        );
    }

    /// The verdict on the triangles, with their marks or without.
    fn verdict(&self, has_marks: bool) -> Result<(), StreamViolation> {
        let of = |v| self.result.representative(v);
        let mut verifier = StreamVerifier::new();
        for (v, point) in self.points.iter().enumerate() {
            match of(v) {
                first if first == v => verifier.vertex(v as u64, *point)?,
                first => verifier.duplicate(v as u64, point, first as u64)?,
            }
        }
        for (e, ends) in self.edges.iter().enumerate() {
            let [u, v] = ends.map(of);
            let (low, high) = match sweep_order(&self.points[u], &self.points[v]) {
                Ordering::Equal => continue,
                Ordering::Less => (u, v),
                Ordering::Greater => (v, u),
            };
            verifier.edge(e as u64, low as u64, self.points[high])?;
        }
        for (corners, constrained) in &self.triangles {
            let marks = has_marks.then_some(*constrained);
            verifier.triangle(corners.map(|v| v as u64), marks)?;
        }
        verifier.finish().map(drop)
    }
}
