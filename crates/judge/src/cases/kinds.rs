//! The kinds of cases that are made, each with what must be special about it and what must not.

use sweep_cdt_testing::generators::{Pattern, Rings, Shape};
use sweep_cdt_testing::judge::{Question, Special};

use super::inputs::{
    deep, holes, islands, no_edges, pairs, pierced, plain, ringed, scaled, shaped, some_pattern,
    spokes,
};
use super::kind::Kind;

const NONE: &[Special] = &[];
use Special::{
    CrossingEdges, EdgesWithoutLength, EqualPoints, FlatRings, OverlappingEdges, OverlappingRings,
    PointsOnEdges, RingsEitherWay, TouchingRings,
};

/// A row of the table.
macro_rules! kind {
    ($name:literal, $count:literal, $about:literal, $must:expr, $must_not:expr, $make:expr) => {
        Kind {
            name: $name,
            about: $about,
            count: $count,
            make: $make,
            must: $must,
            must_not: $must_not,
        }
    };
}

pub(super) const KINDS: &[Kind] = &[
    kind!(
        "few-points",
        32,
        "none, one or two points, some equal, and edges among them",
        NONE,
        NONE,
        |r| {
            let n = r.below(3);
            let points: Vec<[f64; 2]> = (0..n).map(|_| [r.integer(1), r.integer(1)]).collect();
            let count = r.below(3);
            let edges: Vec<[usize; 2]> = if n == 0 {
                Vec::new()
            } else {
                (0..count).map(|_| [r.below(n), r.below(n)]).collect()
            };
            Question::new(&points, &edges)
        }
    ),
    kind!(
        "collinear",
        60,
        "all points on one line, with edges along it",
        &[Special::Flat],
        NONE,
        |r| {
            let [from, by] = [0; 2].map(|_| [r.integer(9), r.integer(5)]);
            let n = 3 + r.below(7);
            let points: Vec<[f64; 2]> = (0..n)
                .map(|_| r.integer(9))
                .map(|k| [from[0] + k * by[0], from[1] + k * by[1]])
                .collect();
            let edges: Vec<[usize; 2]> =
                (0..r.below(5)).map(|_| [r.below(n), r.below(n)]).collect();
            Question::new(&points, &edges)
        }
    ),
    kind!(
        "nearly-collinear",
        80,
        "points of one line, rounded",
        NONE,
        &[Special::Flat, CrossingEdges],
        |r| { plain(r, Shape::Nudged, some_pattern, &[0x21]) }
    ),
    kind!(
        "cocircular",
        80,
        "points of circles with whole coordinates",
        NONE,
        NONE,
        |r| plain(r, Shape::Circle, no_edges, &[])
    ),
    kind!(
        "cocircular-edges",
        60,
        "the same with edges",
        NONE,
        &[CrossingEdges],
        |r| plain(r, Shape::Circle, pairs, &[])
    ),
    kind!(
        "nearly-cocircular",
        80,
        "points of one circle, rounded",
        NONE,
        NONE,
        |r| plain(r, Shape::Nudged, no_edges, &[0x20])
    ),
    kind!(
        "equal-points",
        50,
        "points that are equal",
        &[EqualPoints],
        NONE,
        |r| plain(r, Shape::Lattice, no_edges, &[1])
    ),
    kind!(
        "equal-points-edges",
        60,
        "the same with edges that end at any of them",
        &[EqualPoints],
        &[CrossingEdges],
        |r| { plain(r, Shape::Lattice, pairs, &[2]) }
    ),
    kind!(
        "tiny-lattice",
        70,
        "points of a lattice with two to five places each way",
        NONE,
        NONE,
        |r| plain(r, Shape::Lattice, no_edges, &[3])
    ),
    kind!(
        "tiny-lattice-edges",
        80,
        "the same with edges",
        NONE,
        &[CrossingEdges],
        |r| plain(r, Shape::Lattice, pairs, &[3])
    ),
    kind!(
        "hanging-vertices",
        70,
        "teeth that hang below long edges",
        NONE,
        &[CrossingEdges],
        |r| {
            plain(
                r,
                Shape::Comb,
                |r| {
                    if r.one_in(2) {
                        Pattern::Chords
                    } else {
                        Pattern::Mixed
                    }
                },
                &[],
            )
        }
    ),
    kind!(
        "points-on-edges",
        90,
        "edges through points",
        &[PointsOnEdges],
        &[CrossingEdges, OverlappingEdges],
        |r| { plain(r, Shape::OnSegments, pairs, &[]) }
    ),
    kind!(
        "overlapping-edges",
        90,
        "edges that share more than a point",
        &[OverlappingEdges],
        &[CrossingEdges],
        |r| { plain(r, Shape::Line, pairs, &[]) }
    ),
    kind!(
        "edges-without-length",
        30,
        "edges from a point to itself or an equal one",
        &[EdgesWithoutLength],
        &[CrossingEdges],
        |r| { plain(r, Shape::Lattice, pairs, &[2]) }
    ),
    kind!(
        "crossing-edges",
        110,
        "edges that cross outside of the points: refused",
        &[CrossingEdges],
        NONE,
        |r| {
            let shape = r.pick(&[Shape::General, Shape::Lattice, Shape::Circle, Shape::Nudged]);
            shaped(r, shape, pairs, &[], true)
        }
    ),
    kind!(
        "edges-through-a-vertex",
        50,
        "edges that meet in a point between their ends",
        &[PointsOnEdges],
        &[CrossingEdges],
        |r| { plain(r, Shape::Star, pairs, &[]) }
    ),
    kind!(
        "fan",
        40,
        "edges from one point",
        NONE,
        &[CrossingEdges],
        |r| plain(r, Shape::General, |_| Pattern::Fan, &[])
    ),
    kind!(
        "nested-edges",
        50,
        "long edges above one another",
        NONE,
        &[CrossingEdges],
        |r| plain(r, Shape::Parabola, |_| Pattern::Nested, &[])
    ),
    kind!("path", 30, "a path of edges", NONE, &[CrossingEdges], |r| {
        plain(r, Shape::Alternating, |_| Pattern::Path, &[])
    }),
    kind!(
        "general",
        50,
        "any points and edges",
        NONE,
        &[CrossingEdges],
        |r| plain(r, Shape::General, some_pattern, &[])
    ),
    kind!(
        "huge",
        50,
        "coordinates near the largest double",
        NONE,
        &[CrossingEdges],
        |r| scaled(r, 2f64.powi(1007))
    ),
    kind!(
        "tiny",
        50,
        "coordinates whose products underflow",
        NONE,
        &[CrossingEdges],
        |r| scaled(r, 2f64.powi(-1000))
    ),
    kind!(
        "subnormal",
        60,
        "multiples of the smallest double",
        NONE,
        &[CrossingEdges],
        |r| scaled(r, 5e-324)
    ),
    kind!(
        "mixed-exponents",
        90,
        "large and small numbers together",
        NONE,
        &[CrossingEdges],
        |r| { plain(r, Shape::Magnitudes, some_pattern, &[]) }
    ),
    kind!("any-doubles", 50, "any bits", NONE, &[CrossingEdges], |r| {
        plain(r, Shape::Raw, some_pattern, &[])
    }),
    kind!(
        "slivers",
        70,
        "triangles a million times as long as high",
        NONE,
        &[Special::Flat],
        |r| {
            let high = r.pick(&[1e-6, 1e-9, 1e-15, 3e-12]);
            let n = 4 + r.below(7);
            let mut points: Vec<[f64; 2]> = (0..n)
                .map(|_| [r.integer(20), r.integer(3) * high])
                .collect();
            points.extend(r.one_in(2).then_some([0.5, 1e6]));
            Question::new(&points, &[])
        }
    ),
    kind!(
        "one-ulp",
        90,
        "lattices and lines, of which some coordinates are the next double",
        NONE,
        &[CrossingEdges],
        |r| {
            let kind = [r.byte() & 0x1f];
            plain(r, Shape::Nudged, some_pattern, &kind)
        }
    ),
    kind!(
        "columns",
        40,
        "few different x",
        NONE,
        &[CrossingEdges],
        |r| plain(r, Shape::Columns, some_pattern, &[])
    ),
    kind!("rows", 40, "few different y", NONE, &[CrossingEdges], |r| {
        plain(r, Shape::Rows, some_pattern, &[])
    }),
    kind!(
        "cluster",
        40,
        "ever closer to one place",
        NONE,
        &[CrossingEdges],
        |r| plain(r, Shape::Cluster, some_pattern, &[])
    ),
    kind!(
        "polygons",
        80,
        "polygons with holes, whose vertices lie on straight lines",
        NONE,
        &[TouchingRings],
        |r| ringed(r, Rings::Cells, false)
    ),
    kind!(
        "touching-rings",
        90,
        "polygons and holes that touch in a point",
        &[TouchingRings],
        &[OverlappingRings],
        |r| {
            let shape = r.pick(&[Rings::Cells, Rings::Stars]);
            ringed(r, shape, true)
        }
    ),
    kind!(
        "nested-rings",
        80,
        "polygons in the holes of others",
        NONE,
        &[TouchingRings],
        |r| ringed(r, Rings::Stars, false)
    ),
    kind!(
        "strips",
        50,
        "polygons between two chains",
        NONE,
        &[TouchingRings],
        |r| ringed(r, Rings::Strips, false)
    ),
    kind!(
        "rings-either-way",
        40,
        "outlines that run clockwise, and holes that do not",
        &[RingsEitherWay],
        &[OverlappingRings],
        |r| {
            let mut question = ringed(r, Rings::Stars, false);
            let rings = question.polygons.iter_mut().flatten();
            rings.for_each(|ring| {
                if r.one_in(2) {
                    ring.reverse();
                }
            });
            question
        }
    ),
    kind!(
        "overlapping-rings",
        80,
        "rings that cover each other or go through themselves",
        &[OverlappingRings],
        &[CrossingEdges],
        |r| { ringed(r, Rings::Walks, true) }
    ),
    kind!(
        "pinholes",
        50,
        "holes of one point or two",
        &[FlatRings],
        &[CrossingEdges, OverlappingRings],
        |r| {
            let mut question = ringed(r, Rings::Stars, false);
            for _ in 0..1 + r.below(2) {
                let hole: Vec<usize> = (0..1 + r.below(2))
                    .map(|k| question.points.len() + k)
                    .collect();
                question
                    .points
                    .extend(hole.iter().map(|_| [r.integer(4), r.integer(4)]));
                let at = r.below(question.polygons.len());
                question.polygons[at].push(hole);
            }
            question
        }
    ),
    kind!(
        "lines-in-polygons",
        80,
        "polygons with edges and points in them",
        NONE,
        &[CrossingEdges, OverlappingRings],
        |r| {
            let shape = r.pick(&[Rings::Cells, Rings::Stars, Rings::Strips]);
            let mut question = ringed(r, shape, false);
            question.points.push([r.integer(6), r.integer(6)]);
            let n = question.points.len();
            question.edges = (0..1 + r.below(3))
                .map(|_| [r.below(n), r.below(n)])
                .collect();
            question
        }
    ),
    kind!(
        "rings-as-edges",
        50,
        "rings without a word about polygons",
        NONE,
        &[CrossingEdges],
        |r| {
            let shape = r.pick(&[Rings::Cells, Rings::Stars, Rings::Strips]);
            let mut question = ringed(r, shape, true);
            question.edges = question.all_edges();
            question.polygons.clear();
            question
        }
    ),
    kind!(
        "several-holes",
        60,
        "polygons with two or three holes",
        &[Special::Holes],
        &[TouchingRings, OverlappingRings],
        |r| pierced(r, false, 2..=3)
    ),
    kind!(
        "touching-holes",
        80,
        "polygons with two or three holes, which touch each other, the outline, or what is in them",
        &[Special::Holes, TouchingRings],
        &[OverlappingRings],
        |r| pierced(r, true, 2..=3)
    ),
    kind!(
        "islands",
        60,
        "polygons in holes, and holes in them",
        &[Special::Holes],
        &[OverlappingRings],
        islands
    ),
    kind!(
        "many-holes",
        36,
        "polygons with 4 to 20 holes, of up to 64 points",
        &[Special::Holes],
        &[OverlappingRings],
        |r| {
            let may_touch = r.one_in(2);
            let least = 4 + r.below(14);
            pierced(r, may_touch, least..=20)
        }
    ),
    kind!(
        "one-circle",
        40,
        "points of one circle with nothing in it",
        NONE,
        NONE,
        |r| plain(r, Shape::Round, no_edges, &[])
    ),
    kind!(
        "spokes",
        36,
        "nine edges or more at a vertex",
        NONE,
        &[CrossingEdges],
        spokes
    ),
    kind!(
        "four-holes",
        32,
        "polygons with four holes",
        &[Special::Holes],
        &[OverlappingRings],
        |r| holes(r, 4..=4)
    ),
    kind!(
        "five-holes",
        32,
        "polygons with five holes",
        &[Special::Holes],
        &[OverlappingRings],
        |r| holes(r, 5..=5)
    ),
    kind!(
        "six-to-nine-holes",
        32,
        "polygons with six to nine holes",
        &[Special::Holes],
        &[OverlappingRings],
        |r| holes(r, 6..=9)
    ),
    kind!(
        "deep-nests",
        66,
        "four or five rings, each within the one before",
        &[Special::Holes],
        &[OverlappingRings],
        deep
    ),
];
