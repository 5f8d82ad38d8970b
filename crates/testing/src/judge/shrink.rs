//! A small question with the same fault: what is in it is left out, then its coordinates become shorter.
//!
//! Each step asks the program again, and keeps what has a fault of the same name and may still be asked. A budget
//! bounds the steps; a hang costs as much of it as many other answers, since each takes as long as the program is
//! given.

use std::ops::Range;

use super::claims::Claims;
use super::outcome::{Fault, Outcome};
use super::question::{Operation, Question};
use crate::minimize::drop_runs;

/// So many answers are asked for at most while a question is made small.
const ATTEMPTS: u32 = 4000;
/// A hang counts as so many answers.
const HANG: u32 = 200;

/// A question, the answer of a program, and what is wrong with it.
#[derive(Clone, Debug)]
pub struct Wrong {
    /// The question.
    pub question: Question,
    /// The answer.
    pub outcome: Outcome,
    /// What is wrong.
    pub fault: Fault,
}

/// A small question whose answer has a fault of the same name.
pub fn least(claims: &Claims, wrong: Wrong, ask: &mut dyn FnMut(&Question) -> Outcome) -> Wrong {
    let mut search = Search {
        claims,
        ask,
        left: ATTEMPTS,
        best: wrong,
    };
    loop {
        let before = search.best.question.clone();
        search.leave_out();
        search.shorten();
        if search.best.question == before || search.left == 0 {
            return search.best;
        }
    }
}

struct Search<'a> {
    claims: &'a Claims,
    ask: &'a mut dyn FnMut(&Question) -> Outcome,
    left: u32,
    best: Wrong,
}

/// Leaves out things of one kind, by their numbers.
type Without = fn(&mut Question, Range<usize>);
/// How many things of that kind there are.
type Count = fn(&Question) -> usize;

const KINDS: [(Count, Without); 6] = [
    (
        |q| q.operations.len(),
        |q, range| drop(q.operations.drain(range)),
    ),
    (
        |q| q.polygons.len(),
        |q, range| drop(q.polygons.drain(range)),
    ),
    (|q| q.rings().count(), without_holes),
    (|q| q.edges.len(), |q, range| drop(q.edges.drain(range))),
    (|q| q.points.len(), without_points),
    (|q| q.points.len(), without_equal_points),
];

impl Search<'_> {
    /// Whether the question has the fault too; then it is the best one.
    fn has_fault(&mut self, question: Question) -> bool {
        if self.left == 0 || question == self.best.question || !self.claims.allows(&question) {
            return false;
        }
        let outcome = (self.ask)(&question);
        let is_hang = matches!(&outcome, Outcome::Failed(fault) if fault.name == "hang");
        self.left = self.left.saturating_sub(if is_hang { HANG } else { 1 });
        match self.claims.fault(&question, &outcome) {
            Some(fault) if fault.name == self.best.fault.name => {
                self.best = Wrong {
                    question,
                    outcome,
                    fault,
                };
                true
            }
            _ => false,
        }
    }

    /// Leaves out runs of things: long ones first, then shorter ones.
    fn leave_out(&mut self) {
        for (count, without) in KINDS {
            let mut many = count(&self.best.question);
            while many > 0 {
                let mut least = self.best.question.clone();
                let has_fault = &mut |question: &Question| self.has_fault(question.clone());
                drop_runs(&mut least, many, count, without, has_fault);
                many /= 2;
            }
        }
    }

    /// Makes coordinates shorter: all of them at once, then one after the other.
    fn shorten(&mut self) {
        let least = |axis: usize, points: &[[f64; 2]]| {
            points.iter().map(|p| p[axis]).fold(f64::INFINITY, f64::min)
        };
        self.with_points(&|points| {
            // The places of the coordinates in their order.
            for axis in 0..2 {
                let mut all: Vec<f64> = points.iter().map(|p| p[axis]).collect();
                all.sort_unstable_by(f64::total_cmp);
                all.dedup();
                for p in &mut *points {
                    p[axis] = all.partition_point(|x| *x < p[axis]) as f64;
                }
            }
        });
        self.with_points(&|points| {
            let low = [0, 1].map(|axis| least(axis, points));
            points
                .iter_mut()
                .for_each(|p| *p = [p[0] - low[0], p[1] - low[1]]);
        });
        for scale in [0.5, 2.0] {
            for axes in [[scale, scale], [scale, 1.0], [1.0, scale]] {
                let scaled = move |points: &mut [[f64; 2]]| {
                    points
                        .iter_mut()
                        .for_each(|p| *p = [p[0] * axes[0], p[1] * axes[1]]);
                };
                while self.with_points(&scaled) {}
            }
        }
        self.with_points(&|points| {
            points
                .as_flattened_mut()
                .iter_mut()
                .for_each(|x| *x = x.round());
        });
        for v in 0..self.best.question.points.len() {
            for axis in 0..2 {
                self.shorten_one(v, axis);
            }
        }
    }

    fn shorten_one(&mut self, v: usize, axis: usize) {
        let set = |x: f64| move |points: &mut [[f64; 2]]| points[v][axis] = x;
        for x in [0.0, 1.0] {
            if self.with_points(&set(x)) {
                return;
            }
        }
        let x = self.best.question.points[v][axis];
        for digits in 0..16 {
            // As many digits as are asked for, then one more.
            let rounded = format!("{x:.digits$e}").parse().unwrap_or(x);
            if self.with_points(&set(rounded)) {
                break;
            }
        }
        for shorter in [|x: f64| (x / 2.0).trunc(), |x: f64| x - x.signum()] {
            for _ in 0..16 {
                let x = self.best.question.points[v][axis];
                if !self.with_points(&set(shorter(x))) {
                    break;
                }
            }
        }
    }

    /// Tries other points, in numbers that the program takes, if they are shorter.
    fn with_points(&mut self, change: &dyn Fn(&mut [[f64; 2]])) -> bool {
        let mut question = self.best.question.clone();
        change(&mut question.points);
        for x in question.points.as_flattened_mut() {
            *x = self.claims.numbers.nearest(*x);
        }
        length(&question) < length(&self.best.question) && self.has_fault(question)
    }
}

/// How many characters the coordinates have, and how large they are together.
fn length(question: &Question) -> (usize, f64) {
    let all = question.points.as_flattened();
    let text = all.iter().map(|x| format!("{x:?}").len());
    (text.sum(), all.iter().map(|x| x.abs()).sum())
}

/// Leaves out holes, of all rings by their numbers.
fn without_holes(question: &mut Question, range: Range<usize>) {
    let mut number = 0..;
    for polygon in &mut question.polygons {
        let mut is_hole = false;
        polygon.retain(|_| {
            let is_in = range.contains(&number.next().unwrap_or(0));
            !(std::mem::replace(&mut is_hole, true) && is_in)
        });
    }
}

/// Leaves out points, with their edges and what happens to them. A ring goes on without them; one of less than three
/// vertices is left out, and a polygon without an outline.
fn without_points(question: &mut Question, range: Range<usize>) {
    question.points.drain(range.clone());
    let is_out = |v: &usize| range.contains(v);
    let renamed = |v: usize| if v < range.start { v } else { v - range.len() };
    question.edges.retain(|edge| !edge.iter().any(is_out));
    for edge in &mut question.edges {
        *edge = edge.map(renamed);
    }
    for polygon in &mut question.polygons {
        let mut is_first = true;
        let mut has_outline = true;
        polygon.retain_mut(|ring| {
            let before = ring.len();
            ring.retain(|v| !is_out(v));
            ring.iter_mut().for_each(|v| *v = renamed(*v));
            let is_kept = ring.len() == before || ring.len() > 2;
            if std::mem::take(&mut is_first) {
                has_outline = is_kept;
            }
            is_kept && has_outline
        });
    }
    question.polygons.retain(|polygon| !polygon.is_empty());
    question.operations.retain_mut(|operation| match operation {
        Operation::Insert(v) | Operation::Remove(v) => {
            let is_kept = !is_out(v);
            *v = if is_kept { renamed(*v) } else { 0 };
            is_kept
        }
    });
}

/// Leaves out points that are equal to earlier ones, at which edges and rings end then.
fn without_equal_points(question: &mut Question, range: Range<usize>) {
    for v in range.rev() {
        let [others @ .., point] = &question.points[..=v] else {
            continue;
        };
        let Some(first) = others.iter().position(|other| other == point) else {
            continue;
        };
        let ends = question.edges.as_flattened_mut().iter_mut();
        let corners = question.polygons.iter_mut().flatten().flatten();
        ends.chain(corners)
            .filter(|end| **end == v)
            .for_each(|end| *end = first);
        without_points(question, v..v + 1);
    }
}
