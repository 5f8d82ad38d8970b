//! Inputs as streams: sorted, pushed vertex by vertex, and what comes out, put together again.

use std::cell::Cell;
use std::cmp::Ordering;
use std::collections::BTreeSet;

use sweep_cdt::verify::{Level, Verifier};
use sweep_cdt::{Error, Triangulation};
use sweep_cdt_generate::Random;
pub use sweep_cdt_stream::Rest;
use sweep_cdt_stream::{
    Cut, Final, Stream, StreamError, StreamVerifier, StreamViolation, settle_all,
};

use crate::Input;
use crate::any_front::AnyFront;
use crate::oracle::Answer;
use crate::samples::{Sample, convert};
use crate::tuned::triangulator;

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
    let points = fed::<S>(input)?;
    Some(collected(&points, &input.edges, |sorted, out| {
        let mut front = way.front.clone();
        let stream = Stream::new(triangulator(&points, &input.edges), out);
        let mut stream = stream.window(way.window);
        if !matches!(front, AnyFront::HashTable(_)) {
            stream = stream.front(&mut front);
        }
        if way.is_range_known
            && let Some([least, most]) = range(&points)
        {
            stream = stream.between(least, most);
        }
        feed(&mut stream, &points, &input.edges, sorted)?;
        stream.finish().map(|stats| stats.triangles)
    }))
}

/// The outcome of bands of up to so many vertices, joined in an order by chance; otherwise like [`streamed`]. What is
/// done next gets each rest through `carried`.
///
/// # Panics
/// As [`streamed`].
pub fn banded<S: Sample + Clone>(
    input: &Input,
    most: usize,
    random: &mut Random,
    carried: impl Fn(Rest<S>) -> Rest<S>,
) -> Option<Result<Answer, Error>> {
    let points = fed::<S>(input)?;
    Some(collected(&points, &input.edges, |sorted, out| {
        let count = Cell::new(0);
        let mut out = |found| {
            count.set(count.get() + u64::from(matches!(found, Final::Triangle { .. })));
            out(found);
        };
        let mut session = triangulator(&points, &input.edges).session();
        let mut rests = cut(&points, &input.edges, sorted, most, random, &mut out)?;
        // A rest may be joined to others before it has been settled, and be settled twice.
        while !rests.is_empty() {
            let at = random.below(rests.len());
            let mut rest = carried(rests.remove(at));
            if random.below(3) > 0 {
                rest = rest.settle(&mut session, &mut out)?;
            } else if at < rests.len() {
                rest = rest.followed_by(rests.remove(at))?;
            }
            rests.insert(at, rest);
            if rests[0].is_complete() {
                let left = rests.remove(0).settle(&mut session, &mut out)?;
                assert!(
                    count.get() == 0 || left.vertices() == 0,
                    "vertices are left"
                );
            }
        }
        Ok(count.get())
    }))
}

/// The outcome of bands of up to so many vertices that are settled by [`settle_all`]; otherwise like [`streamed`].
///
/// # Panics
/// As [`streamed`]; or if the counts are wrong.
pub fn settled<S: Sample + Clone + Send>(
    input: &Input,
    most: usize,
    random: &mut Random,
) -> Option<Result<Answer, Error>> {
    let points = fed::<S>(input)?;
    Some(collected(&points, &input.edges, |sorted, out| {
        let bands = cut(&points, &input.edges, sorted, most, random, &mut *out)?;
        let mut bands = bands.into_iter();
        let stats = settle_all(|_| Ok::<_, StreamError>(bands.next()), Ok, usize::MAX, out)?;
        assert_eq!(stats.vertices + stats.duplicates, points.len() as u64);
        let order = |&[u, v]: &[usize; 2]| sweep_order(&points[u], &points[v]);
        let edges = input.edges.iter().filter(|edge| order(edge).is_ne());
        assert_eq!(stats.edges, edges.count() as u64);
        Ok(stats.triangles)
    }))
}

/// Bands of up to so many vertices.
fn cut<S: Sample + Clone>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    sorted: &[usize],
    most: usize,
    random: &mut Random,
    mut out: impl FnMut(Final),
) -> Result<Vec<Rest<S>>, StreamError> {
    let mut bands = Vec::new();
    let Some(between) = range(points) else {
        return Ok(bands);
    };
    let vertices = points.len() as u64;
    let cut = Cut { vertices, between };
    let mut first = 0;
    while first < sorted.len() {
        let mut end = (first + 1 + random.below(most)).min(sorted.len());
        // Equal points belong to one band.
        let order = |u: usize, v: usize| sweep_order(&points[sorted[u]], &points[sorted[v]]);
        while end < sorted.len() && order(end - 1, end).is_eq() {
            end += 1;
        }
        let band = sorted[first..end].iter();
        let band = band.map(|&v| (v as u64, points[v].clone()));
        let ends = |&edge: &[usize; 2]| edge.map(|v| points[v].clone());
        let edges = (0..).zip(edges.iter().map(ends));
        bands.push(cut.band(first as u64, band, edges, &mut out)?);
        first = end;
    }
    Ok(bands)
}

/// A rest that was written and read.
///
/// # Panics
/// If it cannot be read, or is written otherwise then.
pub fn written_and_read(rest: Rest<f64>) -> Rest<f64> {
    let bytes = rest.to_bytes();
    let read = Rest::from_bytes(&bytes).expect("what was written");
    assert_eq!(read.to_bytes(), bytes);
    read
}

/// The points in a scalar; `None` if it cannot hold them, or a stream refuses them.
fn fed<S: Sample>(input: &Input) -> Option<Vec<[S; 2]>> {
    let points = convert::<S>(&input.points)?;
    let is_fed = points.iter().flatten().all(S::is_finite)
        && input.edges.iter().flatten().all(|&v| v < points.len());
    is_fed.then_some(points)
}

/// The least and the greatest x.
fn range<S: Sample + Clone>(points: &[[S; 2]]) -> Option<[S; 2]> {
    let by_x = |u: &&[S; 2], v: &&[S; 2]| u[0].compare(&v[0]);
    let [least, most] = [points.iter().min_by(by_x)?, points.iter().max_by(by_x)?];
    Some([least[0].clone(), most[0].clone()])
}

/// What `run` passes on, which gets the vertices in the order of the sweep and returns how many triangles there are.
fn collected<S: Sample + Clone>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    run: impl FnOnce(&[usize], &mut dyn FnMut(Final)) -> Result<u64, StreamError>,
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
    let ended = run(&sorted, &mut |found| match found {
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
    });
    match ended {
        Ok(triangles) => assert_eq!(triangles, answer.triangles.len() as u64),
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
    stream: &mut Stream<'_, S, O>,
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
            && (sweep_order(low, high).is_eq() || S::orient2d(low, high, w).is_eq())
    };
    let mut chain: Vec<usize> = (0..points.len())
        .filter(|&w| of[w] == w && is_on(w))
        .collect();
    chain.sort_by(|&a, &b| sweep_order(&points[b], &points[a]));
    if chain.first() != Some(&u) {
        chain.reverse();
    }
    chain
}

/// The triangles of a result as a stream, right or with a change.
#[derive(Clone, Debug)]
pub struct Altered<'a> {
    points: &'a [[f64; 2]],
    /// The edges that the triangles are judged with.
    edges: Vec<[usize; 2]>,
    result: &'a Triangulation,
    /// Corners, and whether the side opposite each is constrained.
    triangles: Vec<([usize; 3], [bool; 3])>,
}

/// When the verifier of streams is given vertices and edges.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Feeding {
    /// Before the triangles, in the order of the input.
    Before,
    /// In the order of the sweep, as far as a triangle names them.
    AsNamed,
}

impl Feeding {
    /// Both ways.
    pub const ALL: [Feeding; 2] = [Feeding::Before, Feeding::AsNamed];
}

impl<'a> Altered<'a> {
    /// The result itself.
    pub fn right(points: &'a [[f64; 2]], edges: &[[usize; 2]], result: &'a Triangulation) -> Self {
        let sides = |t| [0, 1, 2].map(|side| result.is_constrained(t, side));
        Altered {
            points,
            edges: edges.to_vec(),
            result,
            triangles: (0..result.len())
                .map(|t| (result.triangle(t), sides(t)))
                .collect(),
        }
    }

    /// The result with some change, after which it may still be right.
    pub fn wrong(
        points: &'a [[f64; 2]],
        edges: &[[usize; 2]],
        result: &'a Triangulation,
        random: &mut Random,
    ) -> Self {
        let mut altered = Altered::right(points, edges, result);
        if !result.is_empty() {
            altered.change(random);
        }
        altered
    }

    /// The triangles in another order, each from another corner, with any of equal points.
    #[must_use]
    pub fn shuffled(mut self, random: &mut Random) -> Self {
        let mut equal = vec![Vec::new(); self.points.len()];
        for v in 0..self.points.len() {
            equal[self.result.representative(v)].push(v);
        }
        random.shuffle(&mut self.triangles);
        for (corners, marks) in &mut self.triangles {
            let by = random.below(3);
            corners.rotate_left(by);
            marks.rotate_left(by);
            *corners = corners.map(|v| random.pick(&equal[self.result.representative(v)]));
        }
        self
    }

    fn change(&mut self, random: &mut Random) {
        let any = |random: &mut Random| random.below(self.points.len());
        let list = &mut self.triangles;
        let (t, side) = (random.below(list.len()), random.below(3));
        let twin = self.result.neighbor(t, side).map(|next| {
            let back = (0..3).find(|&side| self.result.neighbor(next, side) == Some(t));
            (next, back.expect("neighbors of each other"))
        });
        match (random.below(11), twin) {
            (0, _) => drop(list.swap_remove(t)),
            (1, _) => list.push(list[t]),
            (2, _) => list[t].0.swap(0, 1),
            (3, _) => list[t].1[side] ^= true,
            (4, _) => list[t].0[side] = self.result.representative(any(random)),
            (5, _) => list[t].0 = list[random.below(list.len())].0,
            (6, Some((next, back))) => {
                list[t].1[side] ^= true;
                list[next].1[back] ^= true;
            }
            (6, None) => list[t].1[side] ^= true,
            (7, _) => self.edges.push([any(random), any(random)]),
            (8, _) if !self.edges.is_empty() => {
                let edge = random.below(self.edges.len());
                self.edges.swap_remove(edge);
            }
            // The side is flipped, whether that leaves two triangles or not. One time in three the new one is an edge.
            (change, Some((next, back))) => {
                let [(a, of_a), (b, of_b)] = [list[t], list[next]];
                let turned = |i: usize, k: usize| (i + k) % 3;
                let (u, v) = (a[turned(side, 1)], a[turned(side, 2)]);
                let (apex, other) = (a[side], b[back]);
                let is_edge = change == 9;
                list[t] = (
                    [apex, u, other],
                    [of_b[turned(back, 1)], is_edge, of_a[turned(side, 2)]],
                );
                list[next] = (
                    [apex, other, v],
                    [of_b[turned(back, 2)], of_a[turned(side, 1)], is_edge],
                );
                if is_edge {
                    self.edges.push([apex, other]);
                }
            }
            (_, None) => drop(list.swap_remove(t)),
        }
    }

    /// Panics unless the verifier of streams accepts the triangles at a level exactly if the verifier in memory does; and
    /// with their marks, if besides all constrained sides are marked and no others, or the level asks for no edges.
    ///
    /// # Panics
    /// If the verdicts differ.
    pub fn assert_verdict(&self, level: Level, feeding: Feeding) {
        let list: Vec<[usize; 3]> = self.triangles.iter().map(|(corners, _)| *corners).collect();
        let verifier = Verifier::new().level(level);
        let is_right = verifier.verify(self.points, &self.edges, &list).is_ok();
        let of = |v| self.result.representative(v);
        let ends = |[u, v]: [usize; 2]| [of(u).min(of(v)), of(u).max(of(v))];
        let of_all: Vec<usize> = (0..self.points.len()).map(of).collect();
        let chains = self.edges.iter().map(|&edge| ends(edge));
        let chains = chains.map(|edge| chain(self.points, &of_all, edge));
        let constrained: BTreeSet<[usize; 2]> = chains
            .flat_map(|chain| -> Vec<_> {
                chain.windows(2).map(|two| ends([two[0], two[1]])).collect()
            })
            .collect();
        let is_marked = |(corners, marks): &([usize; 3], [bool; 3])| {
            (0..3).all(|side| {
                let side_ends = ends([1, 2].map(|i| corners[(side + i) % 3]));
                marks[side] == constrained.contains(&side_ends)
            })
        };
        let are_marked = level == Level::Tiling || self.triangles.iter().all(is_marked);
        for (has_marks, is_right) in [(false, is_right), (true, is_right && are_marked)] {
            let verdict = self.verdict(level, feeding, has_marks);
            let how = (level, feeding, has_marks);
            assert_eq!(verdict.is_ok(), is_right, "{how:?}: {verdict:?}: {self:?}");
        }
    }

    /// The verdict on the triangles, with their marks or without.
    fn verdict(
        &self,
        level: Level,
        feeding: Feeding,
        has_marks: bool,
    ) -> Result<(), StreamViolation> {
        let mut order: Vec<usize> = (0..self.points.len()).collect();
        if feeding == Feeding::AsNamed {
            order.sort_by(|&u, &v| sweep_order(&self.points[u], &self.points[v]));
        }
        let mut upper = vec![Vec::new(); self.points.len()];
        for (e, &[u, v]) in self.edges.iter().enumerate() {
            let (low, high) = match sweep_order(&self.points[u], &self.points[v]) {
                Ordering::Equal => continue,
                Ordering::Less => (u, v),
                Ordering::Greater => (v, u),
            };
            // Triangles may have come between equal points.
            let from = match feeding {
                Feeding::Before => low,
                Feeding::AsNamed => self.result.representative(low),
            };
            upper[from].push((e, high));
        }
        let mut verifier = StreamVerifier::new().level(level);
        let mut order = order.into_iter();
        let mut next_vertex = |verifier: &mut StreamVerifier<f64>| {
            let Some(v) = order.next() else {
                return Ok(false);
            };
            match self.result.representative(v) {
                first if first == v => verifier.vertex(v as u64, self.points[v])?,
                first => verifier.duplicate(v as u64, &self.points[v], first as u64)?,
            }
            for &(e, high) in &upper[v] {
                verifier.edge(e as u64, v as u64, self.points[high])?;
            }
            Ok(true)
        };
        while feeding == Feeding::Before && next_vertex(&mut verifier)? {}
        for (corners, constrained) in &self.triangles {
            let corners = corners.map(|v| v as u64);
            for corner in corners {
                while !verifier.has_vertex(corner) && next_vertex(&mut verifier)? {}
            }
            verifier.triangle(corners, has_marks.then_some(*constrained))?;
        }
        while next_vertex(&mut verifier)? {}
        verifier.finish().map(drop)
    }
}
