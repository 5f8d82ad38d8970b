//! Polygons with holes and lines, against rays: each ring alone, in whole numbers.

use sweep_cdt::interior::{InteriorError, Ring};
use sweep_cdt::triangulate;
use sweep_cdt_testing::Random;
use sweep_cdt_testing::oracle::windings;

use super::oracle::{Point, lattice, ring};

/// Random polygons, whose rings touch, overlap, cross at vertices and repeat, and lines.
struct Map {
    points: Vec<Point>,
    edges: Vec<[usize; 2]>,
    ring_of: Vec<Option<usize>>,
    rings: Vec<Ring>,
}

fn map(random: &mut Random) -> Map {
    let size = 3 + random.below(3);
    let points = lattice(random, size);
    let (mut pieces, mut rings) = (Vec::new(), Vec::new());
    let polygons = [0, 10, 20, 30];
    for &polygon in &polygons[..1 + random.below(4)] {
        let outlines = 1 + usize::from(random.one_in(4));
        for at in 0..outlines + random.below(3) {
            let again = |e: &([usize; 2], Option<usize>)| (e.1? + 1 == rings.len()).then_some(e.0);
            let edges = match random.below(8) {
                // The one before once more, or reversed.
                0 => pieces.iter().filter_map(again).collect(),
                1 => (pieces.iter().filter_map(again))
                    .map(|[a, b]| [b, a])
                    .collect(),
                _ => ring(random, &points, size),
            };
            pieces.extend(edges.into_iter().map(|edge| (edge, Some(rings.len()))));
            rings.push(Ring {
                polygon,
                is_hole: at >= outlines,
            });
        }
    }
    let lines = ring(random, &points, size);
    pieces.extend(lines.into_iter().skip(random.below(3)).map(|e| (e, None)));
    random.shuffle(&mut pieces);
    let (edges, ring_of) = pieces.into_iter().unzip();
    Map {
        points,
        edges,
        ring_of,
        rings,
    }
}

/// The polygons that cover a triangle, in ascending order.
fn covering(map: &Map, triangle: [usize; 3]) -> Vec<usize> {
    let is_around = |ring: usize| {
        let of_ring = map.edges.iter().zip(&map.ring_of);
        let edges: Vec<[usize; 2]> = of_ring
            .filter(|(_, of)| **of == Some(ring))
            .map(|(edge, _)| *edge)
            .collect();
        windings(&map.points, &edges, triangle).0 % 2 == 1
    };
    let has = |polygon: usize, is_hole: bool| {
        let rings = map.rings.iter().enumerate();
        let mut rings = rings.filter(|(_, ring)| **ring == Ring { polygon, is_hole });
        rings.any(|(at, _)| is_around(at))
    };
    let all = (0..4).map(|polygon| 10 * polygon);
    all.filter(|&polygon| has(polygon, false) && !has(polygon, true))
        .collect()
}

#[test]
fn every_triangle_knows_the_polygons_that_cover_it() {
    let (mut covered, mut carved, mut twice) = (0, 0, 0);
    for seed in 0..1000 {
        let mut random = Random::new(seed);
        let map = map(&mut random);
        let result = triangulate(&map.points, &map.edges).expect("edges cross at vertices only");
        let interior = result.interior_of_polygons(&map.rings, &map.ring_of);
        let interior = interior.expect("the rings are closed");
        for t in 0..result.len() {
            let expected = covering(&map, result.triangle(t));
            assert_eq!(
                interior.is_inside(t),
                !expected.is_empty(),
                "seed {seed}, {t}"
            );
            let depth = usize::try_from(interior.depth(t));
            assert_eq!(depth, Ok(expected.len()), "seed {seed}, {t}");
            let lowest = expected.first().copied();
            assert_eq!(interior.region(t), lowest, "seed {seed}, {t}");
            covered += usize::from(!expected.is_empty());
            twice += usize::from(expected.len() > 1);
            carved += usize::from(expected.is_empty());
        }
    }
    assert!(
        covered.min(carved).min(twice) > 1000,
        "{covered}, {carved}, {twice}"
    );
}

#[test]
fn rings_that_are_not_closed_are_refused() {
    for seed in 0..300 {
        let mut random = Random::new(seed);
        let mut map = map(&mut random);
        let of_ring: Vec<usize> = (0..map.edges.len())
            .filter(|&e| map.ring_of[e].is_some())
            .collect();
        if of_ring.is_empty() {
            continue;
        }
        let result = triangulate(&map.points, &map.edges).expect("edges cross at vertices only");
        let edge = random.pick(&of_ring);
        let [a, b] = map.edges[edge].map(|v| map.points[v]);
        let ring = map.ring_of[edge].take();
        let interior = result.interior_of_polygons(&map.rings, &map.ring_of);
        // Without an edge that has a length, two vertices are open.
        match interior.err() {
            None => assert_eq!(a, b, "seed {seed}"),
            Some(InteriorError::OpenAtVertex { vertex }) => {
                assert!(
                    a != b && [a, b].contains(&map.points[vertex]),
                    "seed {seed}"
                );
            }
            Some(error) => panic!("seed {seed}: {error}"),
        }
        map.ring_of[edge] = ring;
        let refused = |ring_of: &[Option<usize>]| {
            let interior = result.interior_of_polygons(&map.rings, ring_of);
            interior.err()
        };
        let (all, other) = (map.edges.len(), InteriorError::UnknownRing { edge });
        let too_few = InteriorError::UnknownRing { edge: all - 1 };
        assert_eq!(refused(&map.ring_of[..all - 1]), Some(too_few));
        let too_many = InteriorError::UnknownRing { edge: all };
        let more = [&map.ring_of[..], &[None]].concat();
        assert_eq!(refused(&more), Some(too_many));
        let mut unknown = map.ring_of.clone();
        unknown[edge] = Some(map.rings.len());
        assert_eq!(refused(&unknown), Some(other));
    }
}

/// Nothing is quadratic where many equal rings go round many faces: each face behind them is entered once.
#[test]
fn equal_rings_are_crossed_together() {
    let (columns, copies) = (20_000_usize, 5_000_u16);
    let points: Vec<Point> = (0..=20_000).flat_map(|x| [[x, 0], [x, 1]]).collect();
    let last = points.len() - 1;
    let outline = [[0, last - 1], [last - 1, last], [last, 1], [1, 0]];
    let bars = (1..columns).map(|x| [2 * x, 2 * x + 1]);
    let mut edges: Vec<[usize; 2]> = bars.collect();
    let mut ring_of = vec![None; edges.len()];
    for ring in 0..copies {
        edges.extend(outline);
        ring_of.extend([Some(usize::from(ring)); 4]);
    }
    let polygons = (0..copies).map(usize::from);
    let rings: Vec<Ring> = polygons
        .map(|polygon| Ring {
            polygon,
            is_hole: false,
        })
        .collect();
    let result = triangulate(&points, &edges).expect("no edges cross");
    let interior = result.interior_of_polygons(&rings, &ring_of);
    let interior = interior.expect("the rings are closed");
    assert!((0..result.len()).all(|t| interior.depth(t) == i32::from(copies)));
}
