//! The triangles, their neighbours, and how many edges cover each side; a journal takes every change back.
//!
//! Side `k` of a triangle is opposite its corner `k`, as in the library. A number `3 * t + k` names the side `k` of
//! triangle `t`, directed with the triangle on its left, and the corner opposite. Turning around a vertex goes from
//! corner to corner. A side of the hull has [`NONE`] across. Cost: 40 bytes a triangle; constant time for each change.

/// No triangle, side, corner or vertex.
pub(crate) const NONE: u32 = u32::MAX;

#[derive(Clone, Copy, Debug)]
struct Triangle {
    vertices: [u32; 3],
    /// The side across each side.
    twins: [u32; 3],
    /// How many edges cover each side: none, if it is free.
    covers: [u32; 3],
}

/// A change, as it was before.
#[derive(Clone, Copy, Debug)]
enum Before {
    Born(u32),
    Died(u32, Triangle),
    Twin(u32, u32),
    Covers(u32, u32),
    At(u32, u32),
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Mesh {
    triangles: Vec<Triangle>,
    free: Vec<u32>,
    /// For each vertex a corner at it, or [`NONE`].
    at: Vec<u32>,
    journal: Vec<Before>,
    /// For each triangle whether the journal, as it is read, has named it.
    is_read: Vec<bool>,
}

/// As many points, vertices and edges have numbers; triangles then have, too.
pub(crate) const MOST: usize = 1 << 29;

/// A number below [`MOST`], or three times that of triangles.
pub(crate) fn number(n: usize) -> u32 {
    u32::try_from(n).expect("numbers are bounded")
}

/// Side `k` of a triangle.
pub(crate) fn side_of(t: u32, k: usize) -> u32 {
    3 * t + number(k)
}

pub(crate) fn next(side: u32) -> u32 {
    if side % 3 == 2 { side - 2 } else { side + 1 }
}

pub(crate) fn prev(side: u32) -> u32 {
    if side.is_multiple_of(3) {
        side + 2
    } else {
        side - 1
    }
}

impl Mesh {
    /// How many triangles there are.
    pub(crate) fn len(&self) -> usize {
        self.triangles.len() - self.free.len()
    }

    /// The vertices of a triangle, if it is alive.
    pub(crate) fn triangle(&self, t: u32) -> Option<[u32; 3]> {
        let vertices = self.triangles.get(t as usize)?.vertices;
        (vertices[0] != NONE).then_some(vertices)
    }

    pub(crate) fn all(&self) -> impl Iterator<Item = u32> + '_ {
        (0..number(self.triangles.len())).filter(|&t| self.triangle(t).is_some())
    }

    /// The corner opposite a side.
    pub(crate) fn apex(&self, side: u32) -> u32 {
        self.triangles[side as usize / 3].vertices[side as usize % 3]
    }

    /// The ends of a side, with the triangle on the left.
    pub(crate) fn ends(&self, side: u32) -> [u32; 2] {
        [self.apex(next(side)), self.apex(prev(side))]
    }

    pub(crate) fn twin(&self, side: u32) -> u32 {
        self.triangles[side as usize / 3].twins[side as usize % 3]
    }

    pub(crate) fn covers(&self, side: u32) -> u32 {
        self.triangles[side as usize / 3].covers[side as usize % 3]
    }

    /// A corner at a vertex; [`NONE`], if no triangle has it.
    pub(crate) fn at(&self, v: u32) -> u32 {
        self.at.get(v as usize).copied().unwrap_or(NONE)
    }

    /// The corner of the next triangle around the vertex, counter-clockwise, or [`NONE`].
    pub(crate) fn turned_left(&self, corner: u32) -> u32 {
        match self.twin(next(corner)) {
            NONE => NONE,
            across => next(across),
        }
    }

    fn turned_right(&self, corner: u32) -> u32 {
        match self.twin(prev(corner)) {
            NONE => NONE,
            across => prev(across),
        }
    }

    /// The corners at a vertex, counter-clockwise; on the hull from its clockwise end.
    pub(crate) fn star(&self, v: u32) -> impl Iterator<Item = u32> + '_ {
        let mut first = self.at(v);
        if first != NONE {
            let begin = first;
            loop {
                match self.turned_right(first) {
                    NONE => break,
                    right if right == begin => {
                        first = begin;
                        break;
                    }
                    right => first = right,
                }
            }
        }
        let some = move |corner: u32| (corner != NONE).then_some(corner);
        std::iter::successors(some(first), move |&corner| {
            some(self.turned_left(corner)).filter(|&left| left != first)
        })
    }

    /// The sides of the hull beside a side of the hull.
    pub(crate) fn hull_beside(&self, side: u32) -> [u32; 2] {
        let mut corner = next(side);
        while self.twin(next(corner)) != NONE {
            corner = self.turned_left(corner);
        }
        let before = next(corner);
        let mut corner = prev(side);
        while self.twin(prev(corner)) != NONE {
            corner = self.turned_right(corner);
        }
        [before, prev(corner)]
    }

    pub(crate) fn add(&mut self, vertices: [u32; 3]) -> u32 {
        let triangle = Triangle {
            vertices,
            twins: [NONE; 3],
            covers: [0; 3],
        };
        let t = if let Some(t) = self.free.pop() {
            self.triangles[t as usize] = triangle;
            t
        } else {
            self.triangles.push(triangle);
            number(self.triangles.len() - 1)
        };
        self.journal.push(Before::Born(t));
        t
    }

    pub(crate) fn kill(&mut self, t: u32) {
        let before = self.triangles[t as usize];
        self.journal.push(Before::Died(t, before));
        self.triangles[t as usize].vertices = [NONE; 3];
        self.free.push(t);
    }

    /// Sets what is across a side of a triangle that has just been added, which no journal need remember.
    pub(crate) fn begin(&mut self, side: u32, twin: u32, covers: u32) {
        let triangle = &mut self.triangles[side as usize / 3];
        triangle.twins[side as usize % 3] = twin;
        triangle.covers[side as usize % 3] = covers;
    }

    pub(crate) fn set_twin(&mut self, side: u32, twin: u32) {
        self.journal.push(Before::Twin(side, self.twin(side)));
        self.triangles[side as usize / 3].twins[side as usize % 3] = twin;
    }

    pub(crate) fn set_covers(&mut self, side: u32, covers: u32) {
        self.journal.push(Before::Covers(side, self.covers(side)));
        self.triangles[side as usize / 3].covers[side as usize % 3] = covers;
    }

    pub(crate) fn set_at(&mut self, v: u32, corner: u32) {
        if self.at.len() <= v as usize {
            self.at.resize(v as usize + 1, NONE);
        }
        self.journal.push(Before::At(v, self.at(v)));
        self.at[v as usize] = corner;
    }

    /// Takes everything back since the journal was read.
    pub(crate) fn undo(&mut self) {
        while let Some(before) = self.journal.pop() {
            match before {
                Before::Born(t) => {
                    self.triangles[t as usize].vertices = [NONE; 3];
                    self.free.push(t);
                }
                Before::Died(t, triangle) => {
                    self.triangles[t as usize] = triangle;
                    self.free.pop();
                }
                Before::Twin(side, twin) => {
                    self.triangles[side as usize / 3].twins[side as usize % 3] = twin;
                }
                Before::Covers(side, covers) => {
                    self.triangles[side as usize / 3].covers[side as usize % 3] = covers;
                }
                Before::At(v, corner) => self.at[v as usize] = corner,
            }
        }
    }

    /// Ends the journal.
    pub(crate) fn forget(&mut self) {
        self.journal.clear();
    }

    /// Ends the journal: the triangles that are gone since it was read last, and those that are new, each as one number.
    /// One that came and went is neither.
    pub(crate) fn read(&mut self) -> [Vec<u128>; 2] {
        let (mut gone, mut new) = (Vec::new(), Vec::new());
        let mut journal = std::mem::take(&mut self.journal);
        self.is_read.resize(self.triangles.len(), false);
        for before in &journal {
            let (t, vertices) = match *before {
                Before::Born(t) => (t, None),
                Before::Died(t, triangle) => (t, Some(triangle.vertices)),
                _ => continue,
            };
            // The first change of a triangle tells what was there.
            if !std::mem::replace(&mut self.is_read[t as usize], true) {
                gone.extend(vertices.map(packed));
                new.extend(self.triangle(t).map(packed));
            }
        }
        for before in journal.drain(..) {
            if let Before::Born(t) | Before::Died(t, _) = before {
                self.is_read[t as usize] = false;
            }
        }
        // The next edit uses the memory again.
        self.journal = journal;
        // Some of a region come back as they were.
        gone.sort_unstable();
        new.sort_unstable();
        let mut others = new.iter().peekable();
        let mut stayed = Vec::new();
        gone.retain(|t| {
            while others.next_if(|&other| other < t).is_some() {}
            let is_new = others.peek() == Some(&t);
            stayed.extend(is_new.then_some(*t));
            !is_new
        });
        let mut stayed = stayed.into_iter().peekable();
        new.retain(|t| stayed.next_if_eq(t).is_none());
        [gone, new]
    }
}

/// A triangle as one number: from its lowest corner, in the order of the corners' numbers.
pub(crate) fn packed(triangle: [u32; 3]) -> u128 {
    let corners = turned(triangle).into_iter();
    corners.fold(0, |all, corner| all << 32 | u128::from(corner))
}

/// The corners of a triangle as one number.
#[expect(clippy::cast_possible_truncation, reason = "a corner has 32 bits")]
pub(crate) fn unpacked(triangle: u128) -> [u32; 3] {
    [64, 32, 0].map(|bits| (triangle >> bits) as u32)
}

/// A triangle, from its lowest vertex.
pub(crate) fn turned<T: Copy + Ord>(triangle: [T; 3]) -> [T; 3] {
    let [a, b, c] = triangle;
    match a.min(b).min(c) {
        lowest if lowest == a => triangle,
        lowest if lowest == b => [b, c, a],
        _ => [c, a, b],
    }
}
