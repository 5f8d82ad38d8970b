//! Certificates of streams: written as triangles become final, in the memory of what is alive.
//!
//! A point is written before the first line that names it, so that the checker holds no more than what is laid.
//!
//! Triangles are *laid* as `certificate.rs` says, each after its neighbours across its lower sides; until these have come,
//! it waits. The lower hull grows to both ends, as sides of the hull become final. Where all around a vertex is laid, its
//! number is forgotten, unless an edge whose line is still to be written needs it (`certificate_edges.rs`).
//!
//! Cost: some twenty look-ups a triangle.

use std::cmp::Ordering;
use std::io::{self, Write};

use foldhash::{HashMap, HashSet};

use super::certificate::wrong;
use super::certificate_edges::{Edges, Place};
use super::certificate_numbers::{push_integer, push_line};

/// A certificate that is written from final parts of a triangulation, in the order of a sweep.
///
/// Vertices are numbered from 0 as they come, by y and then by x, each place once. An edge comes with its lower end. Sides
/// of the hull and triangles come when they are final, in any order, each once. The file numbers vertices as it names them.
///
/// ```
/// use sweep_cdt_formats::StreamCertificate;
///
/// let mut text = Vec::new();
/// let mut certificate = StreamCertificate::new(-1);
/// for point in [[0.0, 0.0], [0.5, 0.0], [0.0, 2.0]] {
///     certificate.vertex(point, &mut text)?;
/// }
/// for ends in [[0, 1], [1, 2], [2, 0]] {
///     certificate.hull_side(ends);
/// }
/// certificate.triangle([0, 1, 2], [false; 3]);
/// certificate.finish(&mut text)?;
/// let text = String::from_utf8(text)?;
/// assert!(text.starts_with("sweep-cdt-certificate 3\nexponent -1\ndomain hull\np 0 0\np 1 0\nl 0 1\n"));
/// assert!(text.ends_with("p 0 4\nt 0 1 2 0\nend\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct StreamCertificate {
    exponent: i64,
    /// The text on its way out.
    text: Vec<u8>,
    /// How many vertices have come, how many are written, and how many of these are forgotten.
    vertices: u64,
    named: u64,
    forgotten: u64,
    /// The vertices that may still be named.
    places: HashMap<u64, Place>,
    /// Triangles that are not laid, and how many have come.
    waiting: HashMap<u64, Waiting>,
    triangles: u64,
    /// The triangle that waits above a side.
    above: HashMap<Side, u64>,
    /// The sides on which triangles may be laid, and whether each is constrained.
    front: HashMap<Side, bool>,
    /// Triangles whose lower sides are all on the front.
    ready: Vec<u64>,
    /// The left and the right end of the lower hull.
    lower: Option<[u64; 2]>,
    /// Sides of the lower hull that do not join it yet: the right end by the left one, and the left by the right one.
    rightward: HashMap<u64, u64>,
    leftward: HashMap<u64, u64>,
    /// Sides of the upper hull under which no triangle is laid.
    upper: HashSet<Side>,
    edges: Edges,
    /// Whether something has come since triangles were laid.
    is_new: bool,
    /// How many triangles were laid since numbers were forgotten.
    laid: u64,
    /// Numbers that nothing names any more.
    gone: Vec<u64>,
}

/// The left and the right end of a side.
type Side = [u64; 2];

/// A triangle from its leftmost corner on, counterclockwise.
#[derive(Debug)]
struct Waiting {
    corners: [u64; 3],
    /// Whether the sides from each corner to the next one are constrained.
    constrained: [bool; 3],
    /// How many lower sides are not on the front.
    needs: usize,
}

impl StreamCertificate {
    /// So many bytes are written at once.
    const ROOM: usize = 1 << 16;

    /// A certificate with coordinates in units of two to this power, of which all must be multiples.
    pub fn new(exponent: i64) -> Self {
        StreamCertificate {
            exponent,
            text: format!("sweep-cdt-certificate 3\nexponent {exponent}\ndomain hull\n")
                .into_bytes(),
            vertices: 0,
            named: 0,
            forgotten: 0,
            places: HashMap::default(),
            waiting: HashMap::default(),
            triangles: 0,
            above: HashMap::default(),
            front: HashMap::default(),
            ready: Vec::new(),
            lower: None,
            rightward: HashMap::default(),
            leftward: HashMap::default(),
            upper: HashSet::default(),
            edges: Edges::default(),
            is_new: false,
            laid: 0,
            gone: Vec::new(),
        }
    }

    /// The next vertex: after the last one by y, then by x. What has come before is laid first.
    ///
    /// # Errors
    /// Errors of `out`.
    pub fn vertex(&mut self, point: [f64; 2], out: &mut impl Write) -> io::Result<()> {
        if self.is_new {
            self.lay()?;
        }
        let place = Place {
            point,
            star: 0,
            name: None,
        };
        self.places.insert(self.vertices, place);
        self.vertices += 1;
        if self.text.len() >= Self::ROOM {
            out.write_all(&self.text)?;
            self.text.clear();
        }
        Ok(())
    }

    /// An edge from the last vertex to a higher one.
    pub fn edge(&mut self, upper: [f64; 2]) {
        self.edges.begin(self.vertices.saturating_sub(1), upper);
    }

    /// A side of the hull, which is on its left.
    pub fn hull_side(&mut self, ends: [u64; 2]) {
        self.is_new = true;
        let [from, to] = ends;
        if self.is_before(from, to) {
            self.rightward.insert(from, to);
            self.leftward.insert(to, from);
            return;
        }
        match self.front.remove(&[to, from]) {
            Some(true) => self.edges.side([to, from], &self.places),
            Some(false) => {}
            None => {
                self.upper.insert([to, from]);
            }
        }
        self.border(ends);
    }

    /// A triangle, counterclockwise, and whether the side opposite each corner is constrained.
    pub fn triangle(&mut self, corners: [u64; 3], constrained: [bool; 3]) {
        self.is_new = true;
        let [p, q, r] = [0, 1, 2].map(|i| corners[i]);
        let first = match (
            self.is_before(p, q),
            self.is_before(q, r),
            self.is_before(p, r),
        ) {
            (true, _, true) => 0,
            (false, true, _) => 1,
            _ => 2,
        };
        let from = |i: usize| (first + i) % 3;
        let mut waiting = Waiting {
            corners: [0, 1, 2].map(|i| corners[from(i)]),
            constrained: [2, 0, 1].map(|i| constrained[from(i)]),
            needs: 0,
        };
        let number = self.triangles;
        self.triangles += 1;
        let [lower, _] = self.sides(&waiting);
        for (side, _) in lower.into_iter().flatten() {
            waiting.needs += usize::from(!self.front.contains_key(&side));
            self.above.insert(side, number);
        }
        if waiting.needs == 0 {
            self.ready.push(number);
        }
        self.waiting.insert(number, waiting);
    }

    /// Writes what is left.
    ///
    /// # Errors
    /// Errors of `out`; [`io::ErrorKind::InvalidInput`] where the triangles do not tile the hull, or lack an edge.
    pub fn finish(mut self, out: &mut impl Write) -> io::Result<()> {
        self.lay()?;
        let unnamed = self.places.iter().filter(|(_, place)| place.name.is_none());
        let mut unnamed: Vec<u64> = unnamed.map(|(&vertex, _)| vertex).collect();
        unnamed.sort_unstable();
        for vertex in unnamed {
            self.name(vertex)?;
        }
        let chains = match self.triangles {
            0 => self.edges.without_triangles(&self.places),
            _ => self.edges.rest(&self.places),
        };
        let chains = chains.filter(|_| self.waiting.is_empty());
        for chain in chains.ok_or_else(wrong)? {
            self.edge_line(&chain)?;
        }
        self.text.extend_from_slice(b"end\n");
        out.write_all(&self.text)
    }

    /// The number of a vertex in the file, which is written before.
    fn name(&mut self, vertex: u64) -> io::Result<u64> {
        let place = self.places.get_mut(&vertex).ok_or_else(wrong)?;
        if let Some(name) = place.name {
            return Ok(name);
        }
        let name = self.named;
        self.named += 1;
        place.name = Some(name);
        self.text.extend_from_slice(b"p ");
        push_integer(&place.point[0], self.exponent, &mut self.text)?;
        self.text.push(b' ');
        push_integer(&place.point[1], self.exponent, &mut self.text)?;
        self.text.push(b'\n');
        Ok(name)
    }

    fn edge_line(&mut self, chain: &[u64]) -> io::Result<()> {
        let names = chain.iter().map(|&vertex| self.name(vertex));
        let names = names.collect::<io::Result<Vec<u64>>>()?;
        push_line(b'e', &names, &mut self.text);
        Ok(())
    }

    /// Lays all triangles that can be, from left to right, and writes the edges that are whole.
    fn lay(&mut self) -> io::Result<()> {
        self.is_new = false;
        self.lengthen()?;
        // Walks to and fro are short if the leftmost comes first, and then what lies on it.
        let point = |number: &u64| {
            let corner = self.waiting.get(number).map(|waiting| waiting.corners[0]);
            corner
                .and_then(|corner| self.places.get(&corner))
                .map(|place| place.point)
        };
        self.ready
            .sort_by(|s, t| point(t).partial_cmp(&point(s)).unwrap_or(Ordering::Equal));
        while let Some(number) = self.ready.pop() {
            if let Some(triangle) = self.waiting.remove(&number) {
                self.lay_triangle(&triangle)?;
                self.forget_all();
            }
        }
        let (chains, free) = self.edges.whole(&self.places);
        for chain in chains {
            self.edge_line(&chain)?;
        }
        for vertex in free {
            self.forget(vertex);
        }
        Ok(())
    }

    /// Has the checker forget, where sorting what it holds costs no more than what was laid.
    fn forget_all(&mut self) {
        if self.laid >= self.named - self.forgotten {
            push_line(b'f', &self.gone, &mut self.text);
            self.forgotten += self.gone.len() as u64;
            self.gone.clear();
            self.laid = 0;
        }
    }

    fn lay_triangle(&mut self, triangle: &Waiting) -> io::Result<()> {
        let [a, b, c] = triangle.corners;
        let names = [self.name(a)?, self.name(b)?, self.name(c)?];
        let marks = (0..)
            .zip(triangle.constrained)
            .map(|(bit, is)| u64::from(is) << bit);
        push_line(
            b't',
            &[names[0], names[1], names[2], marks.sum()],
            &mut self.text,
        );
        self.laid += 1;
        let [lower, upper] = self.sides(triangle);
        for (side, is_constrained) in lower.into_iter().flatten() {
            self.front.remove(&side);
            self.above.remove(&side);
            if is_constrained {
                self.edges.side(side, &self.places);
            }
        }
        for (side, is_constrained) in upper.into_iter().flatten() {
            if !self.upper.remove(&side) {
                self.open(side, is_constrained);
            } else if is_constrained {
                self.edges.side(side, &self.places);
            }
        }
        self.turn(a, b, c);
        self.turn(b, c, a);
        self.turn(c, a, b);
        Ok(())
    }

    /// A side comes to the front, and the triangle above it may be ready.
    fn open(&mut self, side: Side, is_constrained: bool) {
        self.front.insert(side, is_constrained);
        if let Some(&number) = self.above.get(&side)
            && let Some(waiting) = self.waiting.get_mut(&number)
        {
            waiting.needs -= 1;
            if waiting.needs == 0 {
                self.ready.push(number);
            }
        }
    }

    /// The lower sides, and the upper ones from right to left, and whether each is constrained.
    fn sides(&self, triangle: &Waiting) -> [[Option<(Side, bool)>; 2]; 2] {
        let ([a, b, c], [ab, bc, ca]) = (triangle.corners, triangle.constrained);
        let [ab, ac] = [([a, b], ab), ([a, c], ca)];
        match self.is_before(b, c) {
            true => [[Some(ab), Some(([b, c], bc))], [None, Some(ac)]],
            false => [[Some(ab), None], [Some(([c, b], bc)), Some(ac)]],
        }
    }

    /// The lower hull grows: first to the left, then to the right.
    fn lengthen(&mut self) -> io::Result<()> {
        if self.lower.is_none()
            && let Some((&left, &right)) = self.rightward.iter().min()
        {
            self.rightward.remove(&left);
            self.leftward.remove(&right);
            self.lower = Some([left, right]);
            self.lower_side([left, right])?;
        }
        let Some([mut left, mut right]) = self.lower else {
            return Ok(());
        };
        while let Some(next) = self.leftward.remove(&left) {
            self.rightward.remove(&next);
            self.lower_side([next, left])?;
            left = next;
        }
        while let Some(next) = self.rightward.remove(&right) {
            self.leftward.remove(&next);
            self.lower_side([right, next])?;
            right = next;
        }
        self.lower = Some([left, right]);
        Ok(())
    }

    fn lower_side(&mut self, side: Side) -> io::Result<()> {
        let names = [self.name(side[0])?, self.name(side[1])?];
        push_line(b'l', &names, &mut self.text);
        self.open(side, false);
        self.border(side);
        Ok(())
    }

    /// A triangle has the corners `vertex`, `from` and `to`, counterclockwise. What a vertex gets from its triangles and
    /// sides of the hull adds up to 0 when they go all the way round, and but for bad luck not before. A number that is
    /// forgotten too early makes the certificate unreadable, and no more.
    fn turn(&mut self, vertex: u64, from: u64, to: u64) {
        self.add(vertex, hash(from).wrapping_sub(hash(to)));
    }

    fn border(&mut self, [from, to]: [u64; 2]) {
        self.add(from, hash(to).wrapping_neg());
        self.add(to, hash(from));
    }

    fn add(&mut self, vertex: u64, part: u64) {
        if let Some(place) = self.places.get_mut(&vertex) {
            place.star = place.star.wrapping_add(part);
        }
        self.forget(vertex);
    }

    /// Forgets the vertex, if nothing will name it.
    fn forget(&mut self, vertex: u64) {
        let is_whole = self.places.get(&vertex).is_some_and(Place::is_whole);
        if is_whole && !self.edges.needs(vertex) {
            let place = self.places.remove(&vertex);
            self.gone.extend(place.and_then(|place| place.name));
        }
    }

    /// Whether a vertex is left of another, or below it.
    fn is_before(&self, a: u64, b: u64) -> bool {
        let point = |vertex| self.places.get(&vertex).map(|place| place.point);
        point(a) < point(b)
    }
}

/// A number that looks like chance (Steele, Lea and Flood 2014).
fn hash(number: u64) -> u64 {
    let mut bits = number.wrapping_add(0x9e37_79b9_7f4a_7c15);
    bits = (bits ^ bits >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ bits >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ bits >> 31
}
