//! Parts of edges: where they are split, and what becomes of their halves.
//!
//! A part is split in its middle. At a sharp corner of the input, one where edges meet at less than a right angle, it is
//! split at a distance from the corner that is a power of two, the one between a third and two thirds of its length: so
//! parts at one corner have equal lengths, and stop to encroach each other (Ruppert's concentric shells).

use sweep_cdt::crossings::Exact;

use crate::locate::Place;
use crate::measure::{doubles, scalar_product};
use crate::mesh::{next, prev};
use crate::refine::Reason;
use crate::refine::work::{Kind, OUTSIDE, Shell, Work};

/// Where a part is to be split.
pub(super) struct Split<S> {
    pub(super) part: u32,
    pub(super) place: [S; 2],
    pub(super) kind: Kind,
}

impl<S: Exact> Work<'_, '_, S> {
    /// The side of a part that has its second end on the way from its first, with its left triangle on its left; of a
    /// part of the hull that may be no side, so then its other direction.
    pub(super) fn sides_of(&self, part: u32) -> Vec<u32> {
        let [a, b] = self.parts[part as usize]
            .ends
            .map(|point| self.vertex(point));
        let mesh = &self.mesh.mesh;
        let corners = mesh.star(a);
        let found = corners.flat_map(|corner| {
            let [p, q] = mesh.ends(corner);
            [
                (p == b).then(|| prev(corner)),
                (q == b).then(|| next(corner)),
            ]
        });
        found.flatten().collect()
    }

    /// Marks the ends of parts at which edges meet at less than a right angle.
    pub(super) fn find_sharp_corners(&mut self) {
        let mut ends: Vec<u32> = self.parts.iter().flat_map(|part| part.ends).collect();
        ends.sort_unstable();
        ends.dedup();
        for point in ends {
            let v = self.vertex(point);
            let mesh = &self.mesh.mesh;
            // The vertices at the other ends of parts, counter-clockwise.
            let mut around = Vec::new();
            for corner in mesh.star(v) {
                let [p, q] = mesh.ends(corner);
                around.extend((mesh.covers(prev(corner)) > 0).then_some(p));
                around.extend((mesh.covers(next(corner)) > 0).then_some(q));
            }
            around.dedup();
            for i in 0..around.len() {
                let [p, q] = [around[i], around[(i + 1) % around.len()]];
                let corners = [p, q, v].map(|v| self.mesh.points.place(v));
                if p != q && scalar_product(corners).is_gt() {
                    for other in [p, q] {
                        let part = self.part_between(point, self.name(other)) as usize;
                        let part = &mut self.parts[part];
                        part.is_sharp[usize::from(part.ends[0] != point)] = true;
                    }
                }
            }
        }
    }

    /// Where a part is to be split, or why it cannot be; no vertex lies between the place and the part.
    pub(super) fn split(&self, part: u32) -> Result<Split<S>, Reason> {
        let split = self.halfway(part)?;
        let is_at = self.is_at(part, &split.place);
        is_at.then_some(split).ok_or(Reason::Rounding)
    }

    /// Where a part would be split, or why it is not.
    pub(super) fn halfway(&self, number: u32) -> Result<Split<S>, Reason> {
        if let Some(reason) = self.why_whole(number) {
            return Err(reason);
        }
        let part = &self.parts[number as usize];
        let [a, b] = part.ends.map(|point| self.vertex(point));
        let [p, q] = [a, b].map(|v| self.mesh.points.place(v));
        let (place, kind) = match part.is_sharp {
            [false, false] => (middle(p, q), Kind::OnPart(self.shell_between(part.ends))),
            [true, _] => shell(part.ends[0], p, q),
            [false, true] => shell(part.ends[1], q, p),
        };
        if !place.iter().all(S::is_finite) {
            return Err(Reason::Rounding);
        }
        let part = number;
        Ok(Split { part, place, kind })
    }

    /// Whether a place lies in a triangle at a part or on the part; or outside, if the part bounds the inside: then no
    /// vertex lies between.
    fn is_at(&self, part: u32, place: &[S; 2]) -> bool {
        let bounds_inside = self.parts[part as usize].labels.contains(&OUTSIDE);
        let is_outside = |t: u32| bounds_inside && self.labels[t as usize] == OUTSIDE;
        let sides = self.sides_of(part);
        match self.mesh.find(place) {
            Place::Vertex(_) => false,
            Place::Triangle(t) => is_outside(t) || sides.iter().any(|side| side / 3 == t),
            Place::Side(side) => {
                let across = self.mesh.mesh.twin(side);
                let is_free = self.mesh.mesh.covers(side) == 0;
                is_free && is_outside(side / 3)
                    || sides.iter().any(|&at| at == side || at == across)
            }
            Place::Beyond(_) => bounds_inside,
        }
    }

    /// The shell in the middle between two, if they are around one corner.
    fn shell_between(&self, ends: [u32; 2]) -> Option<Shell> {
        let shells = ends.map(|point| match self.kinds[point as usize] {
            Kind::OnPart(shell) => shell,
            _ => None,
        });
        let [Some(a), Some(b)] = shells else {
            return None;
        };
        let radius = f64::midpoint(a.radius, b.radius);
        (a.corner == b.corner).then_some(Shell { radius, ..a })
    }

    /// Continues a chain of points along a part, in its direction or against it.
    pub(super) fn follow(&self, part: u32, is_forward: bool, chain: &mut Vec<usize>) {
        if chain.is_empty() {
            chain.push(self.parts[part as usize].ends[usize::from(!is_forward)] as usize);
        }
        let mut waiting = vec![part];
        while let Some(part) = waiting.pop() {
            let part = &self.parts[part as usize];
            match part.halves {
                // The half that comes first is taken first.
                Some((_, [first, second])) if is_forward => waiting.extend([second, first]),
                Some((_, halves)) => waiting.extend(halves),
                None => chain.push(part.ends[usize::from(is_forward)] as usize),
            }
        }
    }
}

/// The point nearest to the middle between two.
fn middle<S: Exact>(a: &[S; 2], b: &[S; 2]) -> [S; 2] {
    if let (Some([ax, ay]), Some([bx, by])) = (doubles(a), doubles(b))
        && let [Some(x), Some(y)] =
            [f64::midpoint(ax, bx), f64::midpoint(ay, by)].map(S::nearest_of_double)
    {
        return [x, y];
    }
    let two = num_bigint::BigInt::from(2);
    [0, 1].map(|i| S::nearest(&((a[i].to_fraction() + b[i].to_fraction()) / &two)))
}

/// The point at a power of two from a corner, between a third and two thirds of the way to the other end.
fn shell<S: Exact>(corner: u32, from: &[S; 2], to: &[S; 2]) -> ([S; 2], Kind) {
    let [x, y] = [0, 1].map(|i| to[i].approx() - from[i].approx());
    let length = x.hypot(y);
    let exponent = (length * (2.0 / 3.0)).log2().floor();
    let part = exponent.exp2() / length;
    let Some(fraction) =
        num_rational::BigRational::from_float(part).filter(|_| part > 0.25 && part < 0.75)
    else {
        return (middle(from, to), Kind::OnPart(None));
    };
    let near = |i: usize| part.mul_add(to[i].approx() - from[i].approx(), from[i].approx());
    let exactly = |i: usize| {
        let (a, b) = (from[i].to_fraction(), to[i].to_fraction());
        S::nearest(&(&a + (&b - &a) * &fraction))
    };
    let are_doubles = [from, to].map(doubles).iter().all(Option::is_some);
    let place = [0, 1].map(|i| {
        let near = S::nearest_of_double(near(i)).filter(|_| are_doubles);
        near.unwrap_or_else(|| exactly(i))
    });
    let radius = exponent.exp2();
    (place, Kind::OnPart(Some(Shell { corner, radius })))
}
