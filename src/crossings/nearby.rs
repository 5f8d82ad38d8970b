//! Which cells a piece comes near: cells of vertices, and pieces of edges, all at once.
//!
//! The cells are halved repeatedly, and with each half go the pieces that come near it. Every half is taken in the
//! direction that parts the pieces best: along x, along y, or across one of the pieces. For long edges that cross little
//! lie beside each other, so that a direction across some of them parts nearly all of them.
//!
//! ```text
//!      . '/ . /'  /.         Halved by the dashed line, few pieces go with both halves. Halved along x or y, most
//!     ' / .'/ : /' .         would.
//!      /'. /\ /. :/
//! ```
//!
//! Why it is right: a piece that passes a cell has a point in it. So it meets the box around the cells of a half, is on
//! no side of that box ([`Bounds::is_beside`]), and is not apart from these cells in the direction in which they were
//! halved ([`Extent::is_apart`]). All three are certain. The direction itself is a matter of cost: it is chosen by a
//! sample.
//!
//! Cost: O(n log n) for n cells and as many pieces where a direction parts them; where each piece crosses others, at
//! most some O(sqrt n) cells for each, as in a tree of boxes. O(n) memory for the cells, and a list of pieces for each
//! half that waits.

use alloc::vec::Vec;

use super::bounds::{Bounds, Extent, Near, along};
use super::effort::Effort;
use crate::tuning::{CELLS_NOT_HALVED, DIRECTIONS_TRIED, SAMPLE_OF_CELLS};

/// A range of the cells, with the pieces that come near it.
#[derive(Debug)]
struct Part {
    from: usize,
    to: usize,
    pieces: Vec<usize>,
}

/// Passes each piece and each cell that it passes to `report`, by their positions, and some that it does not.
pub(super) fn near(
    pieces: &[[Near; 2]],
    cells: &[Bounds],
    effort: &mut Effort,
    mut report: impl FnMut(usize, usize),
) {
    let mut order: Vec<usize> = (0..cells.len()).collect();
    let all = (0..pieces.len()).collect();
    let mut waiting = Vec::new();
    let whole = around(cells, &order);
    let pieces_left = left(pieces, all, effort, |piece| is_near(&whole, piece));
    waiting.extend(part([0, cells.len()], pieces_left));
    while let Some(Part {
        from,
        to,
        pieces: here,
    }) = waiting.pop()
    {
        let range = &mut order[from..to];
        if range.len() <= CELLS_NOT_HALVED {
            for &piece in &here {
                effort.visit(range.len());
                let near = range
                    .iter()
                    .filter(|&&cell| is_near(&cells[cell], &pieces[piece]));
                near.for_each(|&cell| report(piece, cell));
            }
            continue;
        }
        let direction = direction(pieces, &here, cells, range);
        let place = |cell: &usize| along(cells[*cell].middles(), direction);
        let half = range.len() / 2;
        range.select_nth_unstable_by(half, |a, b| place(a).total_cmp(&place(b)));
        for [from, to] in [[from, from + half], [from + half, to]] {
            let range = &order[from..to];
            let whole = around(cells, range);
            let extents = range
                .iter()
                .map(|&cell| Extent::of(&cells[cell].corners(), direction));
            let extent = extents.fold(Extent::NOTHING, Extent::and);
            let near = left(pieces, here.clone(), effort, |piece| {
                !extent.is_apart(&Extent::of(piece, direction)) && is_near(&whole, piece)
            });
            waiting.extend(part([from, to], near));
        }
    }
}

/// The box around these cells.
fn around(cells: &[Bounds], range: &[usize]) -> Bounds {
    let boxes = range.iter().map(|&cell| cells[cell]);
    boxes.fold(Bounds::NOTHING, Bounds::and)
}

fn is_near(whole: &Bounds, piece: &[Near; 2]) -> bool {
    whole.meets(&Bounds::around(*piece)) && !whole.is_beside(*piece)
}

/// The pieces of a list that stay.
fn left(
    pieces: &[[Near; 2]],
    mut list: Vec<usize>,
    effort: &mut Effort,
    stays: impl Fn(&[Near; 2]) -> bool,
) -> Vec<usize> {
    effort.visit(list.len());
    list.retain(|&piece| stays(&pieces[piece]));
    list.shrink_to_fit();
    list
}

/// A part, if there is something to do.
fn part([from, to]: [usize; 2], pieces: Vec<usize>) -> Option<Part> {
    (from < to && !pieces.is_empty()).then_some(Part { from, to, pieces })
}

/// The direction that leaves the fewest pieces of a sample on both sides of the middle of the cells. Of x and y the
/// longer one comes first, which decides among equals.
fn direction(pieces: &[[Near; 2]], here: &[usize], cells: &[Bounds], range: &[usize]) -> Near {
    let sampled = |list: &[usize]| -> Vec<usize> {
        let step = list.len().div_ceil(SAMPLE_OF_CELLS);
        list.iter().step_by(step).copied().collect()
    };
    let middles: Vec<Near> = sampled(range)
        .iter()
        .map(|&cell| cells[cell].middles())
        .collect();
    let sample: Vec<[Near; 2]> = sampled(here).iter().map(|&piece| pieces[piece]).collect();
    let both = |direction: Near| {
        let mut places: Vec<f64> = middles
            .iter()
            .map(|&point| along(point, direction))
            .collect();
        let half = places.len() / 2;
        let (_, middle, _) = places.select_nth_unstable_by(half, f64::total_cmp);
        let middle = *middle;
        let extents = sample.iter().map(|piece| Extent::of(piece, direction));
        extents.filter(|extent| extent.holds(middle)).count()
    };
    let spread = |axis: Near| Extent::of(&middles, axis).length();
    let mut axes = [[1.0, 0.0], [0.0, 1.0]];
    if spread(axes[1]) > spread(axes[0]) {
        axes.swap(0, 1);
    }
    let across = sample
        .chunks(sample.len().div_ceil(DIRECTIONS_TRIED))
        .filter_map(|some| {
            let length = |piece: &&[Near; 2]| {
                let [dx, dy] = way(piece);
                dx.abs().max(dy.abs())
            };
            let [dx, dy] = way(some.iter().max_by(|a, b| length(a).total_cmp(&length(b)))?);
            let size = dx.abs().max(dy.abs());
            (size > 0.0 && size.is_finite()).then(|| [-dy / size, dx / size])
        });
    let directions = axes.into_iter().chain(across);
    directions
        .min_by_key(|&direction| both(direction))
        .unwrap_or(axes[0])
}

/// Half of the way from the first end of a piece to the second.
fn way([a, b]: &[Near; 2]) -> Near {
    [0, 1].map(|i| b[i] / 2.0 - a[i] / 2.0)
}
