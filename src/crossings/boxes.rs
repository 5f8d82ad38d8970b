//! Which boxes meet: pairs of edges that may cross.
//!
//! The boxes are in the order of their lower sides. Those that begin within the height of a box follow it there, in one
//! range. The order is cut into parts of 1, 2, 4 and so on. A range consists of at most two parts of each size (a
//! segment tree, as of Zomorodian and Edelsbrunner 2002), and each box *spans* the parts of its range. Of the boxes that
//! span a part and those in it, each pair meets if it does so along x: where both are sorted from left to right, all that
//! begins within the width of a box follows it.
//!
//! ```text
//!    [       8       ]      The range of a box, here from 3 to 9, and the parts that it consists of: one of 1, one of
//!    [   4   ][  4   ]      4, one of 2.
//!    [2 ][2 ][2 ][2 ][2
//!     0 1 2 3 4 5 6 7 8 9
//!          |=|=======|===|
//! ```
//!
//! Why it is right: of two boxes that meet one begins first from below, and its range has the other one; from the left
//! one of them begins first as well. Nothing is compared but coordinates. So each pair that meets is passed on once, and
//! no other.
//!
//! Cost: O(n log n) for n boxes, and each pair that meets, wherever they lie and however long they are. (A tree of boxes
//! looks at all of them in vain, one by one, where they are long and beside each other.) O(n) memory.

use alloc::vec;
use alloc::vec::Vec;

use super::bounds::Bounds;
use super::effort::Effort;

/// A box along x, with its position in the list given.
#[derive(Clone, Copy, Debug)]
struct Item {
    low: f64,
    high: f64,
    position: usize,
}

/// A box that spans parts: those from one to before another one.
#[derive(Clone, Copy, Debug)]
struct Span {
    item: Item,
    from: usize,
    to: usize,
}

/// Passes each pair of boxes that meet, once, to `report`, until that returns an error.
pub(super) fn pairs<E>(
    boxes: &[Bounds],
    effort: &mut Effort,
    mut report: impl FnMut([usize; 2]) -> Result<(), E>,
) -> Result<(), E> {
    let (mut items, mut spans) = arranged(boxes);
    let mut width = 1;
    while !spans.is_empty() {
        // The spans of each part, from left to right as all are.
        let ends = |span: &Span| [(span.from, span.from % 2), (span.to - 1, span.to % 2)];
        let taken = |span: &Span| ends(span).into_iter().filter(|&(_, odd)| odd == 1);
        let mut places = vec![0; items.len().div_ceil(width) + 1];
        for (part, _) in spans.iter().flat_map(taken) {
            places[part + 1] += 1;
        }
        for part in 1..places.len() {
            places[part] += places[part - 1];
        }
        let first = spans[0].item;
        let mut by_part = vec![first; places[places.len() - 1]];
        let mut next = places.clone();
        for span in &spans {
            for (part, _) in taken(span) {
                by_part[next[part]] = span.item;
                next[part] += 1;
            }
        }
        for (part, inside) in items.chunks(width).enumerate() {
            let spanning = &by_part[places[part]..places[part + 1]];
            if !spanning.is_empty() {
                effort.visit(spanning.len() + inside.len());
                meeting(spanning, inside, |pair| {
                    effort.visit(1);
                    report(pair)
                })?;
            }
        }
        for span in &mut spans {
            (span.from, span.to) = (span.from.div_ceil(2), span.to / 2);
        }
        spans.retain(|span| span.from < span.to);
        width *= 2;
        items.chunks_mut(width).for_each(sort);
    }
    Ok(())
}

/// The boxes in the order of their lower sides, and those that span others, from left to right.
fn arranged(boxes: &[Bounds]) -> (Vec<Item>, Vec<Span>) {
    let mut order: Vec<(f64, usize)> = boxes
        .iter()
        .enumerate()
        .map(|(position, one)| (number(one.low[1]), position))
        .collect();
    order.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let item = |&(_, position): &(f64, usize)| Item {
        low: number(boxes[position].low[0]),
        high: boxes[position].high[0],
        position,
    };
    let items: Vec<Item> = order.iter().map(item).collect();
    let span = |(place, item): (usize, &Item)| {
        let high = boxes[item.position].high[1];
        let from = place + 1;
        let others = order[from..].partition_point(|&(low, _)| low <= high);
        (others > 0).then_some(Span {
            item: *item,
            from,
            to: from + others,
        })
    };
    let mut spans: Vec<Span> = items.iter().enumerate().filter_map(span).collect();
    spans.sort_by(|a, b| a.item.low.total_cmp(&b.item.low));
    (items, spans)
}

/// The number with one zero, so that all orders agree on it.
fn number(x: f64) -> f64 {
    x + 0.0
}

/// From left to right; two sorted halves are merged.
fn sort(part: &mut [Item]) {
    part.sort_by(|a, b| a.low.total_cmp(&b.low));
}

/// Passes each pair of one list and the other that meets along x, once, to `report`. Both go from left to right.
fn meeting<E>(
    mut some: &[Item],
    mut others: &[Item],
    mut report: impl FnMut([usize; 2]) -> Result<(), E>,
) -> Result<(), E> {
    while let ([one, some_left @ ..], [other, others_left @ ..]) = (some, others) {
        let (first, rest);
        if one.low <= other.low {
            (first, rest) = (one, others);
            some = some_left;
        } else {
            (first, rest) = (other, some);
            others = others_left;
        }
        for beside in rest.iter().take_while(|beside| beside.low <= first.high) {
            report([first.position, beside.position])?;
        }
    }
    Ok(())
}
