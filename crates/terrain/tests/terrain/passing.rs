//! Triangles that pass one by one give the lines and heights of the surface in memory, bit for bit.

use std::collections::BTreeMap;
use std::io::Cursor;

use sweep_cdt::Triangulation;
use sweep_cdt::interior::Interior;
use sweep_cdt_generate::Random;
use sweep_cdt_terrain::{Contour, Corner, Grid, PassingContours, Raster, Surface};

use crate::{Lattice, below, triangulated};

/// What passes: a triangle, or a side of the hull.
#[derive(Clone, Copy)]
enum Passing {
    Triangle([Corner; 3]),
    Hull([Corner; 2]),
}

/// The triangles and the hull in some order, each triangle from any corner on.
fn passing(
    points: &[[f64; 2]],
    heights: &[f64],
    result: &Triangulation,
    random: &mut Random,
) -> Vec<Passing> {
    let corner = |v: usize| Corner {
        number: v as u64,
        point: points[v],
        height: heights[v],
    };
    let mut passing = Vec::new();
    for t in 0..result.len() {
        let mut corners = result.triangle(t).map(corner);
        for side in 0..3 {
            if result.neighbor(t, side).is_none() {
                passing.push(Passing::Hull(result.side(t, side).map(corner)));
            }
        }
        corners.rotate_left(random.below(3));
        passing.push(Passing::Triangle(corners));
    }
    random.shuffle(&mut passing);
    passing
}

/// The lines of what passes, and how many of them are parts.
fn lines(passing: &[Passing], levels: &[f64], most: usize) -> (Vec<Contour>, u64) {
    let mut lines = Vec::new();
    let mut contours = PassingContours::new(levels.to_vec(), most);
    for some in passing {
        match *some {
            Passing::Triangle(corners) => contours.triangle(corners, |line| lines.push(line)),
            Passing::Hull(ends) => contours.border(ends, |line| lines.push(line)),
        }
    }
    (lines, contours.parts())
}

/// The lines as bits, sorted.
fn bits(lines: &[Contour]) -> Vec<(u64, Vec<[u64; 2]>)> {
    let bits = |line: &Contour| {
        let points = line.points.iter().map(|point| point.map(f64::to_bits));
        (line.level.to_bits(), points.collect())
    };
    let mut all: Vec<_> = lines.iter().map(bits).collect();
    all.sort_unstable();
    all
}

/// The pieces of lines, and how often each is there.
fn pieces(lines: &[Contour]) -> BTreeMap<[u64; 5], usize> {
    let mut pieces = BTreeMap::new();
    for line in lines {
        for step in line.points.windows(2) {
            let [a, b] = [step[0], step[1]].map(|point| point.map(f64::to_bits));
            let piece = [line.level.to_bits(), a[0], a[1], b[0], b[1]];
            *pieces.entry(piece).or_default() += 1;
        }
    }
    pieces
}

/// A wavy terrain, without a lattice.
fn waves(count: usize, random: &mut Random) -> (Vec<[f64; 2]>, Vec<f64>) {
    let coordinate = |random: &mut Random| below(random, 1 << 30) as f64 / 1e8;
    let points = (0..count).map(|_| [coordinate(random), coordinate(random)]);
    let points: Vec<[f64; 2]> = points.collect();
    let heights = points.iter().map(|[x, y]| 2.0 * x.sin() * y.cos());
    let heights = heights.collect();
    (points, heights)
}

/// Lattices with equal heights and missing ones, and waves: points and heights.
fn terrains() -> impl Iterator<Item = (Vec<[f64; 2]>, Vec<f64>)> {
    let mut random = Random::new(8);
    (0..1500).map(move |round| match round % 50 {
        0 => waves(400, &mut random),
        _ => {
            let lattice = Lattice::new(&mut random, round % 3 == 0);
            (lattice.doubles(), lattice.known())
        }
    })
}

#[test]
fn lines_of_passing_triangles_are_those_of_the_surface() {
    let mut random = Random::new(9);
    let levels: Vec<f64> = (-4..=12).map(|twice| f64::from(twice) / 2.0).collect();
    let (mut open, mut closed) = (0, 0);
    for (points, heights) in terrains() {
        let result = triangulated(&points);
        let whole = Interior::whole(&result);
        let surface = Surface::new(&points, &whole, &heights);
        let expected = surface.contours(&levels).expect("few pieces");
        let passing = passing(&points, &heights, &result, &mut random);
        let (found, parts) = lines(&passing, &levels, usize::MAX);
        assert_eq!((bits(&found), parts), (bits(&expected), 0));
        closed += expected.iter().filter(|line| line.is_closed()).count();
        open += expected.iter().filter(|line| !line.is_closed()).count();
    }
    assert!(open > 9000 && closed > 3000, "{open}, {closed}");
}

#[test]
fn lines_in_parts_have_the_pieces_of_the_lines() {
    let mut random = Random::new(11);
    let (points, heights) = waves(6000, &mut random);
    let result = triangulated(&points);
    let whole = Interior::whole(&result);
    let levels = [-1.0, -0.5, 0.0, 0.5];
    let surface = Surface::new(&points, &whole, &heights);
    let expected = surface.contours(&levels).expect("few pieces");
    let mut passing = passing(&points, &heights, &result, &mut random);
    let top = |some: &Passing| {
        let of_all = |corners: &[Corner]| {
            corners
                .iter()
                .map(|corner| corner.point[1])
                .fold(0.0, f64::max)
        };
        match some {
            Passing::Triangle(corners) => of_all(corners),
            Passing::Hull(ends) => of_all(ends),
        }
    };
    passing.sort_by(|a, b| top(a).total_cmp(&top(b)));
    for (most, least_parts) in [(usize::MAX, 0), (600, 3), (0, 30)] {
        let (found, parts) = lines(&passing, &levels, most);
        assert_eq!(pieces(&found), pieces(&expected), "{most}");
        assert!(parts >= least_parts, "{most}: {parts}");
        assert_eq!(parts == 0, bits(&found) == bits(&expected), "{most}");
    }
}

#[test]
fn cells_have_the_heights_at_their_centres() {
    let mut random = Random::new(10);
    let [mut known, mut unknown, mut at_sides] = [0; 3];
    for (points, heights) in terrains() {
        let result = triangulated(&points);
        let whole = Interior::whole(&result);
        let surface = Surface::new(&points, &whole, &heights);
        let cell = [0.25, 1.0, 2.0, 0.3][random.below(4)];
        let intervals = [0, 1].map(|axis| {
            let of_points = points.iter().map(|point| point[axis]);
            let range = [f64::INFINITY, f64::NEG_INFINITY];
            of_points.fold(range, |[low, high], x| [low.min(x), high.max(x)])
        });
        let grid = Grid::covering(cell, intervals).expect("few cells");
        let centers = (0..grid.rows()).rev().flat_map(|row| {
            let row = (0..grid.columns()).map(move |column| (row, column));
            row.map(|(row, column)| grid.center(row, column))
        });
        let centers: Vec<[f64; 2]> = centers.collect();
        let expected = surface.heights_at(&centers);
        let expected: Vec<Option<u64>> = expected.iter().map(|z| z.map(f64::to_bits)).collect();
        let passing = passing(&points, &heights, &result, &mut random);
        // Some rows in memory, or one.
        for bytes in [1 << 20, 0] {
            let mut raster = Raster::new(grid.clone(), Cursor::new(Vec::new()), bytes);
            for some in &passing {
                if let Passing::Triangle(corners) = some {
                    raster.add(*corners).expect("memory takes all");
                }
            }
            let mut found = Vec::new();
            let row = |row: &[f64]| {
                let height = |height: &f64| (!height.is_nan()).then_some(height.to_bits());
                found.extend(row.iter().map(height));
                Ok(())
            };
            raster.each_row(row).expect("memory has all");
            assert_eq!(found, expected, "{points:?} {heights:?} {cell}");
        }
        known += expected.iter().flatten().count();
        unknown += expected.iter().filter(|height| height.is_none()).count();
        let halves = centers
            .iter()
            .filter(|center| center.iter().all(|x| (2.0 * x).fract() == 0.0));
        at_sides += halves.count();
    }
    assert!(
        known > 50_000 && unknown > 10_000 && at_sides > 9000,
        "{known}, {unknown}, {at_sides}"
    );
}

#[test]
fn grids_lie_at_whole_multiples_of_their_cells() {
    let covering = |cell, x| Grid::covering(cell, [x, [0.0, 0.0]]);
    let across = |cell, x| covering(cell, x).map(|grid| (grid.corners()[0][0], grid.columns()));
    assert_eq!(across(1.0, [0.0, 3.0]), Some((0.0, 3)));
    assert_eq!(across(1.0, [-0.5, 3.5]), Some((-1.0, 5)));
    assert_eq!(across(0.1, [0.25, 0.35]), Some((0.2, 2)));
    // A point alone has a cell.
    assert_eq!(across(1.0, [2.0, 2.0]), Some((2.0, 1)));
    // Too many, too small for the doubles there, no size, no points.
    assert_eq!(across(1e-9, [0.0, 100.0]), None);
    assert_eq!(across(1e-3, [1e15, 1e15 + 1.0]), None);
    for cell in [0.0, -1.0, f64::NAN] {
        assert_eq!(across(cell, [0.0, 1.0]), None);
    }
    assert_eq!(across(1.0, [f64::INFINITY, f64::NEG_INFINITY]), None);
}
