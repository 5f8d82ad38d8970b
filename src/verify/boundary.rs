//! Checks 4 to 6, as the table of the parent module has them: the triangles cover the hull, or the domain that the
//! caller [declared](super::declared), once. Points outside a declared domain need not be corners.
//!
//! Points added to those of the input must lie in the hull of these. Check 4 makes the boundary the hull of all
//! corners. It is the hull of the input's points if it turns at these points only. A bent [run](super::runs) counts as the
//! line between its ends.
//!
//! How rounds are counted: a side *ascends* if its end comes after its start in the order (x, y). A chain that never
//! turns right nor back turns by less than half a turn at each vertex. The directions that ascend are half of all, so
//! the chain cannot skip them, and each round enters them once.
//!
//! ```text
//!           .-- d <--.
//!          v          \        a-b and b-c ascend, c-d and d-a do not.
//!          a           c       The chain enters the ascending directions at a,
//!           \         ^        its leftmost vertex, once a round.
//!            '--> b -'
//! ```

use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Ordering;

use super::declared::DeclaredBoundary;
use super::depth::Depth;
use super::report::{Level, Record};
use super::runs::{self, Run};
use super::scanline;
use super::sides::Sides;
use super::soup::Soup;
use super::violation::Violation;
use crate::scalar::Scalar;

/// Checks the boundary against the declared domain, or else the hull. Returns its runs through added points.
pub(super) fn check<S: Scalar>(
    soup: &Soup<'_, S>,
    sides: &Sides,
    domain: Option<&DeclaredBoundary>,
    record: &mut Record,
) -> Vec<Run> {
    // A missing or rejected triangle leaves a hole, which is not another fault.
    let is_sound = record.findings.is_empty();
    match domain {
        Some(domain) if is_sound => return domain.check_boundary(soup, sides, record),
        None if soup.triangles.is_empty() => check_collinear(soup, record),
        None if is_sound => return check_hull(soup, sides, record),
        _ => {}
    }
    Vec::new()
}

/// Checks that without triangles all vertices lie on one line.
fn check_collinear<S: Scalar>(soup: &Soup<'_, S>, record: &mut Record) {
    // The vertices of the input come first.
    let is_off =
        |&v: &u32| !soup.is_added(v) && soup.orient2d([0, 1, v], &mut record.tally).is_ne();
    if let Some(v) = (2..soup.vertices()).find(is_off) {
        let vertices = soup.names([0, 1, v]);
        record.findings.add(Violation::NoTriangles { vertices });
    }
}

/// Checks that the boundary is one convex chain that goes round once. It is not empty: otherwise every side had two
/// triangles, crossing one would never change how many triangles cover a point, and that number is 0 far away.
fn check_hull<S: Scalar>(soup: &Soup<'_, S>, sides: &Sides, record: &mut Record) -> Vec<Run> {
    // If each vertex starts at most one side, the sides are closed chains.
    let boundary = sides.boundary.iter();
    let mut boundary: Vec<[u32; 2]> = boundary.map(|&side| soup.side(side)).collect();
    boundary.sort_unstable();
    let mut pinched = false;
    for same_start in boundary.chunk_by(|a, b| a[0] == b[0]) {
        if same_start.len() > 1 {
            pinched = true;
            let vertex = soup.name(same_start[0][0]);
            record.findings.add(Violation::PinchedBoundary { vertex });
        }
    }
    if pinched {
        return Vec::new();
    }

    // The chain with the first vertex in the order (x, y) goes round all others, if there are others.
    let mut chains = chains(&boundary);
    let vertices = chains.iter().enumerate();
    let vertices = vertices.flat_map(|(i, chain)| chain.iter().map(move |&v| (i, v)));
    let first = vertices.min_by(|&(_, v), &(_, w)| soup.order(v, w));
    let (outer, _) = first.expect("triangles that turn left have a boundary");
    let outer = chains.swap_remove(outer);
    for chain in &chains {
        record.findings.add(Violation::ExtraBoundary {
            side: soup.names([chain[0], chain[1 % chain.len()]]),
            sides: chain.len(),
        });
    }
    check_convex(soup, sides, &outer, record)
}

/// The closed chains that sides form, which are sorted by start; no two have the same. As many sides end at a vertex as
/// start there, because that holds for each triangle. So each chain goes on until it is closed.
fn chains(sides: &[[u32; 2]]) -> Vec<Vec<u32>> {
    let mut visited = vec![false; sides.len()];
    let mut result = Vec::new();
    for first in 0..sides.len() {
        let (mut at, mut chain) = (first, Vec::new());
        while !visited[at] {
            visited[at] = true;
            chain.push(sides[at][0]);
            let end = sides[at][1];
            at = sides.partition_point(|side| side[0] < end);
        }
        if !chain.is_empty() {
            result.push(chain);
        }
    }
    result
}

/// Checks that a closed chain never turns right nor back, and that it goes round once; of a run that is bent its line.
fn check_convex<S: Scalar>(
    soup: &Soup<'_, S>,
    sides: &Sides,
    chain: &[u32],
    record: &mut Record,
) -> Vec<Run> {
    let (runs, frame) = runs::of_chain(soup, sides, chain);
    let at = |i: usize| frame[i % frame.len()];
    let (mut times, mut wrong) = (0, Vec::new());
    for i in 0..frame.len() {
        let vertices @ [a, b, c] = [at(i), at(i + 1), at(i + 2)];
        let ascends = [soup.order(a, b), soup.order(b, c)].map(Ordering::is_lt);
        let turn = soup.orient2d(vertices, &mut record.tally);
        let goes_on = match turn {
            Ordering::Greater => true,
            // Straight on, or back.
            Ordering::Equal => ascends[0] == ascends[1],
            Ordering::Less => false,
        };
        if !goes_on {
            wrong.push(vertices);
        } else if turn.is_gt() && soup.is_added(b) {
            let vertex = soup.name(b);
            record.findings.add(Violation::AddedOutside { vertex });
        }
        times += usize::from(ascends == [false, true]);
    }
    if wrong.is_empty() && times != 1 {
        record.findings.add(Violation::WindingBoundary { times });
    }
    report_turns(soup, chain, &wrong, &runs, record);
    runs
}

/// Reports the wrong turns of a closed chain, and its runs that are bent, with depths if all turns go on and the chain
/// neither crosses nor covers itself.
fn report_turns<S: Scalar>(
    soup: &Soup<'_, S>,
    chain: &[u32],
    wrong: &[[u32; 3]],
    runs: &[Run],
    record: &mut Record,
) {
    let measure = |turn: [u32; 3], record: &Record| {
        let height = || soup.height(turn).map(|height| -height);
        record.findings.measure(Level::Tiling, height)
    };
    let few = wrong.len() <= record.findings.measured;
    let depth = |&turn: &[u32; 3]| few.then(|| measure(turn, record)).flatten();
    let mut depths: Vec<Option<Depth>> = wrong.iter().map(depth).collect();
    let is_simple = || {
        let ends = chain.iter().zip(chain.iter().cycle().skip(1));
        let sides: Vec<[u32; 2]> = ends.map(|(&a, &b)| [a, b]).collect();
        scanline::inside(soup, &sides, core::iter::empty()).is_ok()
    };
    let is_straight = wrong.is_empty() && !runs.iter().any(Run::is_bent);
    let is_simple = is_straight || !depths.contains(&None) && is_simple();
    if !is_simple {
        depths.fill(None);
    }
    for (&turn, depth) in wrong.iter().zip(depths) {
        let vertices = soup.names(turn);
        record
            .findings
            .add(Violation::ConcaveBoundary { vertices, depth });
    }
    let bent = runs.iter().filter_map(|run| run.violation(soup, is_simple));
    bent.for_each(|violation| record.findings.add(violation));
}

/// Checks the vertices of rank `used` and above, which no triangle names. Without any triangles check 4 judges them. If
/// runs of the boundary are `bent`, its sides as they are must bound a domain too, in which no vertex is unused.
pub(super) fn check_points<S: Scalar>(
    soup: &Soup<'_, S>,
    used: u32,
    domain: Option<&DeclaredBoundary>,
    bent: Option<&[u32]>,
    record: &mut Record,
) {
    let unused = || (used..soup.vertices()).filter(|&point| !soup.is_added(point));
    let needed = match domain {
        Some(domain) => {
            let as_it_is = |bent: &[u32]| bent.iter().map(|&side| soup.side(side)).collect();
            let bent: Option<Vec<[u32; 2]>> = bent.map(as_it_is);
            let boundaries = [Some(&domain.sides), bent.as_ref()].into_iter().flatten();
            let mut needed = Vec::new();
            for sides in boundaries {
                match scanline::inside(soup, sides, unused()) {
                    Ok(inside) => needed.extend(inside),
                    Err(side) => {
                        // Where something is wrong already, the domain is not known.
                        if record.findings.is_sound() {
                            let side = soup.names(side);
                            record.findings.add(Violation::TangledBoundary { side });
                        }
                        return;
                    }
                }
            }
            needed.sort_unstable();
            needed.dedup();
            needed
        }
        None if soup.triangles.is_empty() => return,
        None => unused().collect(),
    };
    for v in needed {
        let vertex = soup.name(v);
        record.findings.add(Violation::UnusedPoint { vertex });
    }
}

/// Checks Euler's count of triangles, if they fill the hull and rounding explains all that is wrong: a second opinion.
pub(super) fn check_count(used: u32, domain: Option<&DeclaredBoundary>, record: &mut Record) {
    let report = &record.report;
    if domain.is_some() || report.triangles == 0 || !record.findings.is_sound() {
        return;
    }
    let expected = 2 * used as usize - 2 - report.boundary_sides;
    if report.triangles != expected {
        record.findings.add(Violation::WrongCount {
            triangles: report.triangles,
            expected,
        });
    }
}
