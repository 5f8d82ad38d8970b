//! The vertices that a piece passes: those to which a point of it is rounded.
//!
//! The *cell* of a vertex is all that is rounded to it: an upright box, half of the way to the next numbers in x and y.
//! A side belongs to it where a number halfway is rounded to the vertex. The cell of a fraction is the point alone.
//!
//! Why it is right: a piece passes if the part of it in the cell along x and the part along y have something in common.
//! Both are ranges of fractions, which are enclosed first ([`super::enclosure`]). Before that, boxes that the piece
//! keeps clear of are left out ([`super::nearby`]), and four exact signs exclude most of the rest: if all corners of a
//! box around the cell lie on one side of the piece, it does not pass.
//!
//! Cost: that of finding what comes near ([`super::nearby`]); four signs for each cell near a piece, an enclosure for each
//! that it passes or nearly does, and fractions where the enclosure does not tell.

use alloc::vec::Vec;
use core::cmp::Ordering;

use num_rational::BigRational;
use num_traits::{One, Zero};

use super::bounds::{self, Bounds};
use super::effort::Effort;
use super::enclosure::Enclosure;
use super::exact::{Exact, enclosure};
use super::nearby;
use crate::scalar::{Scalar, orient2d};

/// Pairs of a piece, by its position, and a vertex, none of its ends, that it passes.
pub(super) fn passed<S: Exact>(
    points: &[[S; 2]],
    pieces: &[[usize; 2]],
    vertices: &[usize],
    effort: &mut Effort,
) -> Vec<(usize, usize)> {
    let around = |v: usize| corners(&points[v]);
    let cell = |&v: &usize| {
        let [low, _, high, _] = around(v);
        Bounds::of([&low, &high])
    };
    let cells: Vec<Bounds> = vertices.iter().map(cell).collect();
    let ends = |piece: &[usize; 2]| piece.map(|v| bounds::near(&points[v]));
    let near: Vec<_> = pieces.iter().map(ends).collect();
    let mut passed = Vec::new();
    nearby::near(&near, &cells, effort, |piece, cell| {
        let (ends, v) = (pieces[piece], vertices[cell]);
        let [a, b] = ends.map(|v| &points[v]);
        if !ends.contains(&v) && passes([a, b], &points[v], &around(v)) {
            passed.push((piece, v));
        }
    });
    passed
}

/// The corners of a box that holds the cell of a point.
fn corners<S: Exact>(point: &[S; 2]) -> [[S; 2]; 4] {
    let [[left, right], [low, high]] = point.each_ref().map(S::around);
    [
        [left.clone(), low.clone()],
        [right.clone(), low],
        [right, high.clone()],
        [left, high],
    ]
}

/// Whether the corners do not all lie on one side of a piece.
fn may_pass<S: Scalar>([a, b]: [&[S; 2]; 2], corners: &[[S; 2]; 4]) -> bool {
    let turns = corners.each_ref().map(|corner| orient2d(a, b, corner));
    [Ordering::Greater, Ordering::Less]
        .iter()
        .all(|side| turns.iter().any(|turn| turn != side))
}

/// Whether a piece passes through the cell of a point, whose box has these corners.
fn passes<S: Exact>([a, b]: [&[S; 2]; 2], point: &[S; 2], corners: &[[S; 2]; 4]) -> bool {
    let is = |corner: &[S; 2]| (0..2).all(|i| corner[i].compare(&point[i]).is_eq());
    if is(&corners[0]) && is(&corners[2]) {
        // The cell is the point alone.
        let is_within = |i: usize| {
            let [one, other] = [a, b].map(|end| end[i].compare(&point[i]));
            one != other || one.is_eq()
        };
        return orient2d(a, b, point).is_eq() && (0..2).all(is_within);
    }
    if !may_pass([a, b], corners) {
        return false;
    }
    passes_enclosed([a, b], point).unwrap_or_else(|| passes_in_fractions([a, b], point))
}

/// As [`passes`], if doubles can tell: whether the parts along x and y, and the piece itself, have a common range.
fn passes_enclosed<S: Exact>([a, b]: [&[S; 2]; 2], point: &[S; 2]) -> Option<bool> {
    let half = Enclosure::exactly(0.5);
    let mut parts = [[0.0, 1.0].map(Enclosure::exactly); 3];
    for i in 0..2 {
        if a[i].compare(&b[i]).is_eq() {
            // Another number than that of the vertex is in no cell of it.
            if a[i].compare(&point[i]).is_ne() {
                return Some(false);
            }
            continue;
        }
        let (from, middle) = (enclosure(&a[i])?, enclosure(&point[i])?);
        let along = enclosure(&b[i])?.minus(from);
        let mut part = parts[i];
        for (end, other) in part.iter_mut().zip(point[i].around()) {
            let border = enclosure(&other)?.plus(middle).times(half);
            *end = border.minus(from).over(along)?;
        }
        if a[i].compare(&b[i]).is_gt() {
            part.reverse();
        }
        parts[i] = part;
    }
    let (firsts, lasts) = (parts.map(|[first, _]| first), parts.map(|[_, last]| last));
    let pairs = || {
        firsts
            .iter()
            .flat_map(|first| lasts.iter().map(move |last| (*first, *last)))
    };
    if pairs().any(|(first, last)| last.is_less_than(first)) {
        return Some(false);
    }
    let has_common = pairs().all(|(first, last)| first.is_less_than(last));
    has_common.then_some(true)
}

/// A part of a piece: from where to where, each with whether that end belongs to the part.
type Part = [(BigRational, bool); 2];

fn passes_in_fractions<S: Exact>([a, b]: [&[S; 2]; 2], point: &[S; 2]) -> bool {
    let [mut from, mut to]: Part = [(BigRational::zero(), true), (BigRational::one(), true)];
    for i in 0..2 {
        let Some([first, last]) = part([&a[i], &b[i]], &point[i]) else {
            return false;
        };
        // Of two ranges that begin at one place, the one without it begins later.
        from = match from.0.cmp(&first.0) {
            Ordering::Less => first,
            Ordering::Equal => (first.0, from.1 && first.1),
            Ordering::Greater => from,
        };
        to = match to.0.cmp(&last.0) {
            Ordering::Less => to,
            Ordering::Equal => (last.0, to.1 && last.1),
            Ordering::Greater => last,
        };
    }
    from.0 < to.0 || from.0 == to.0 && from.1 && to.1
}

/// The part of the way from `a` to `b`, 0 to 1 or beyond, where a coordinate is rounded to `value`; `None` if nowhere.
fn part<S: Exact>([a, b]: [&S; 2], value: &S) -> Option<Part> {
    let middle = value.to_fraction();
    let cell = value.around().map(|other| {
        let border = (other.to_fraction() + &middle) / BigRational::from_integer(2.into());
        let belongs = S::nearest(&border).compare(value).is_eq();
        (border, belongs)
    });
    let [a, b] = [a, b].map(S::to_fraction);
    let along = b - &a;
    if along.is_zero() {
        let [low, high] = cell;
        let inside = low.0 < a && a < high.0 || low.0 == a && low.1 || high.0 == a && high.1;
        return inside.then(|| [(BigRational::zero(), true), (BigRational::one(), true)]);
    }
    let [first, last] = cell.map(|(border, belongs)| ((border - &a) / &along, belongs));
    Some(if first.0 <= last.0 {
        [first, last]
    } else {
        [last, first]
    })
}
