//! Edges that cross nothing, and that some order of insertion makes quadratic: hatches, zigzags, chevrons, rungs, nested
//! rings, bundles of curves and stars, at several slants. In each family most edges are long, and each has many others
//! beside it.

use std::f64::consts::TAU;

use sweep_cdt_generate::Random;

use super::points::{Family, path, points, ring};
use crate::Input;

/// Segments side by side: number `i` of `m` leads from one point to the other.
pub(super) fn hatch(n: usize, segment: impl Fn(f64, f64) -> [[f64; 2]; 2]) -> Input {
    let m = n / 2;
    let mut input = Input {
        points: Vec::new(),
        edges: Vec::new(),
    };
    for i in 0..m {
        input.edges.push([2 * i, 2 * i + 1]);
        input.points.extend(segment(i as f64, m as f64));
    }
    input
}

/// Chains of `len` points each: point `j` of chain `i` of `m`.
fn chains(n: usize, len: usize, point: impl Fn([f64; 2], f64) -> [f64; 2]) -> Input {
    several(n / len, |i, m| path(points(len, |j, _| point([i, j], m))))
}

/// Rings of `len` points each: the point at this angle of ring `i` of `m`.
fn rings(n: usize, len: usize, point: impl Fn(f64, f64, f64) -> [f64; 2]) -> Input {
    several(n / len, |i, m| {
        ring(points(len, |j, len| point(i, j / len * TAU, m)))
    })
}

/// `m` inputs as one.
pub(super) fn several(m: usize, part: impl Fn(f64, f64) -> Input) -> Input {
    let mut all = Input {
        points: Vec::new(),
        edges: Vec::new(),
    };
    for i in 0..m {
        let first = all.points.len();
        let part = part(i as f64, m as f64);
        let moved = part.edges.iter().map(|edge| edge.map(|v| v + first));
        all.edges.extend(moved);
        all.points.extend(part.points);
    }
    all
}

/// The whole turned by half a radian.
fn tilted(mut input: Input) -> Input {
    let (sin, cos) = 0.5_f64.sin_cos();
    for [x, y] in &mut input.points {
        [*x, *y] = [*x * cos - *y * sin, *x * sin + *y * cos];
    }
    input
}

/// Half of the points as they are, the other half as their mirror image beside them.
fn mirrored(n: usize, half: impl Fn(usize) -> Input) -> Input {
    let mut input = half(n / 2);
    let first = input.points.len();
    let xs = input.points.iter().map(|&[x, _]| x);
    let right = 1.0 + 2.0 * xs.fold(f64::NEG_INFINITY, f64::max);
    let mirror: Vec<_> = input.points.iter().map(|&[x, y]| [right - x, y]).collect();
    let moved: Vec<_> = input
        .edges
        .iter()
        .map(|edge| edge.map(|v| v + first))
        .collect();
    input.points.extend(mirror);
    input.edges.extend(moved);
    input
}

/// 1 for every other number, otherwise 0.
fn odd(i: f64) -> f64 {
    i % 2.0
}

fn at([x, y]: [f64; 2], angle: f64, radius: f64) -> [f64; 2] {
    [x + radius * angle.cos(), y + radius * angle.sin()]
}

/// A number from 0 to 1 that looks random.
pub(super) fn noise(i: f64) -> f64 {
    (i * 0.618_033_988_749_895).fract()
}

/// A list of families.
macro_rules! families {
    ($($name:literal: $member:expr;)*) => {
        &[$(Family { name: $name, member: $member }),*]
    };
}

/// Segments.
pub(super) const HATCHES: &[Family] = families! {
    "hatch": |n| hatch(n, |i, m| [[i, 0.0], [i + m, m]]);
    "hatch, to the left": |n| hatch(n, |i, m| [[i, 0.0], [i - m, m]]);
    "hatch, steep": |n| hatch(n, |i, m| [[i, 0.0], [i + m / 8.0, m]]);
    "hatch, flat": |n| hatch(n, |i, m| [[0.0, i], [m, i + m / 8.0]]);
    "hatch, flat and falling": |n| hatch(n, |i, m| [[0.0, i], [m, i - m / 8.0]]);
    "hatch, vertical": |n| hatch(n, |i, m| [[i, 0.0], [i, m]]);
    "hatch, horizontal": |n| hatch(n, |i, m| [[0.0, i], [m, i]]);
    "hatch, upper ends at random": |n| hatch(n, |i, m| {
        let length = 1.0 + noise(i) * m;
        [[i, 0.0], [i + length, length]]
    });
    "hatch, lower ends at random": |n| hatch(n, |i, m| {
        let length = 1.0 + noise(i) * m;
        [[i + m - length, m - length], [i + m, m]]
    });
    "hatch on a slope": |n| hatch(n, |i, m| [[i, i], [i + 2.0 * m, i + m]]);
    "hatch across a slope": |n| hatch(n, |i, m| [[i, -i], [i + m, m - i]]);
    "hatch of two directions": |n| mirrored(n, |n| hatch(n, |i, m| [[i, 0.0], [i + m, m]]));
    "hatch of two directions, flat": |n| mirrored(n, |n| hatch(n, |i, m| [[0.0, i], [m, i + m / 8.0]]));
    "fan, wider above": |n| hatch(n, |i, m| [[i, 0.0], [2.0 * i + m, m]]);
    "fan, wider below": |n| hatch(n, |i, m| [[2.0 * i, 0.0], [i + m, m]]);
    "rungs": |n| hatch(n, |i, m| [[0.0, i], [m, i + m]]);
    "rungs, falling": |n| hatch(n, |i, m| [[0.0, i], [m, i - m]]);
    "rungs of a leaning ladder": |n| hatch(n, |i, m| [[i, i], [i + m, i + 3.0]]);
    "rungs, narrowing": |n| hatch(n, |i, m| [[0.0, 2.0 * i], [m, i + m / 2.0]]);
    "rungs, uneven": |n| hatch(n, |i, m| [[noise(i), 2.0 * i], [m + noise(i * 7.0), 2.0 * i + m]]);
    "lens": |n| tilted(hatch(n, |i, m| {
        let y = i + 0.5 - m / 2.0;
        let x = (m * m / 4.0 - y * y).sqrt();
        [[-x, y], [x, y]]
    }));
    "windmill": |n| hatch(n, |i, m| [m, 2.0 * m].map(|r| at([0.0; 2], i / m * TAU, r)));
    "windmill, swirling": |n| hatch(n, |i, m| {
        let angle = i / m * TAU;
        [at([0.0; 2], angle, m), at([0.0; 2], angle + 1.0, 4.0 * m)]
    });
    "short slanted segments": |n| hatch(n, |i, _| [[i, 0.0], [i + 1.5, 1.0]]);
    "slanted segments on a lattice": |n| hatch(n, |i, m| {
        let width = m.sqrt().ceil();
        let [x, y] = [i % width, (i / width).floor()];
        [[x, y], [x + 0.75, y + 0.5]]
    });
};

/// Chains.
pub(super) const ZIGZAGS: &[Family] = families! {
    "zigzag": |n| path(points(n, |i, n| [i, odd(i) * n]));
    "zigzag, leaning": |n| path(points(n, |i, n| [i + odd(i) * n, odd(i) * n]));
    "zigzag, lying": |n| path(points(n, |i, n| [odd(i) * n, i]));
    "zigzag, lying and leaning": |n| path(points(n, |i, n| [odd(i) * n, i + odd(i) * n / 4.0]));
    "zigzag, growing": |n| path(points(n, |i, _| [i, odd(i) * i]));
    "zigzag, growing and leaning": |n| path(points(n, |i, _| [i + odd(i) * i, odd(i) * i]));
    "tilted comb": |n| path(points(n, |i, n| [i + odd(i) * n / 4.0, i / 2.0 + odd(i) * n]));
    "chevrons": |n| chains(n, 3, |[i, j], m| [(j - 1.0) * m, i + (j - 1.0).abs() * m]);
    "chevrons, upside down": |n| chains(n, 3, |[i, j], m| [(j - 1.0) * m, i - (j - 1.0).abs() * m]);
    "chevrons, lying": |n| chains(n, 3, |[i, j], m| [i + (j - 1.0).abs() * m, j * m]);
    "chevrons, leaning": |n| chains(n, 3, |[i, j], m| {
        [(j - 1.0) * m, i + (j - 1.0).abs() * m + (j - 1.0) * m / 3.0]
    });
    "chevrons, widening": |n| chains(n, 3, |[i, j], _| [(j - 1.0) * (i + 1.0), i + (j - 1.0).abs() * i]);
    "strokes of three parts": |n| chains(n, 4, |[i, j], m| [i + odd(j) * m, j * m]);
    "bundle of curves": |n| chains(n, 50, |[i, j], m| [j * m / 8.0, i + m * (j / 8.0).sin()]);
    "bundle of curves, upright": |n| chains(n, 50, |[i, j], m| [i + m * (j / 8.0).sin(), j * m / 8.0]);
    "bundle of curves, tilted": |n| tilted(chains(n, 50, |[i, j], m| [j * m / 8.0, i + m * (j / 8.0).sin()]));
    "stairs": |n| path(points(n, |i, _| [(i / 2.0).floor(), (i / 2.0).ceil()]));
    "stairs, leaning": |n| path(points(n, |i, n| [(i / 2.0).floor() + odd(i) * n / 9.0, (i / 2.0).ceil()]));
    "spiral chain": |n| path(points(n, |i, _| at([0.0; 2], (4.0 * i).sqrt(), 1.0 + i.sqrt())));
    "spiral chain, flat and tilted": |n| tilted(path(points(n, |i, _| {
        let [x, y] = at([0.0; 2], (4.0 * i).sqrt(), 1.0 + i.sqrt());
        [8.0 * x, y]
    })));
};

/// Rings.
pub(super) const RINGS: &[Family] = families! {
    "nested rhombi, flat": |n| rings(n, 4, |i, angle, _| {
        let [x, y] = at([0.0; 2], angle, i + 1.0);
        [8.0 * x, y]
    });
    "nested rhombi, flat and tilted": |n| tilted(rings(n, 4, |i, angle, _| {
        let [x, y] = at([0.0; 2], angle, i + 1.0);
        [8.0 * x, y]
    }));
    "nested squares, upright": |n| rings(n, 4, |i, angle, _| at([0.0; 2], angle + TAU / 8.0, i + 1.0));
    "nested squares, tilted": |n| tilted(rings(n, 4, |i, angle, _| at([0.0; 2], angle, i + 1.0)));
    "nested triangles": |n| tilted(rings(n, 3, |i, angle, _| at([0.0; 2], angle, i + 1.0)));
    "nested contours": |n| rings(n, 64, |i, angle, _| at([0.0; 2], angle, i + 1.0));
    "nested contours, flat": |n| rings(n, 64, |i, angle, _| {
        let [x, y] = at([0.0; 2], angle, i + 1.0);
        [8.0 * x, y]
    });
    "nested contours, flat and tilted": |n| tilted(rings(n, 64, |i, angle, _| {
        let [x, y] = at([0.0; 2], angle, i + 1.0);
        [8.0 * x, y]
    }));
    "nested contours, coarse and tilted": |n| tilted(rings(n, 12, |i, angle, _| {
        let [x, y] = at([0.0; 2], angle, i + 1.0);
        [8.0 * x, y]
    }));
    "nested contours, wavy and tilted": |n| tilted(rings(n, 100, |i, angle, _| {
        let [x, y] = at([0.0; 2], angle, (i + 1.0) * (1.0 + 0.2 * (5.0 * angle).sin()));
        [4.0 * x, y]
    }));
    "islands, tilted": |n| tilted(several(n / 64, |i, m| {
        let width = m.sqrt().ceil();
        let center = [i % width, (i / width).floor()];
        let mut island = rings(64, 16, |i, angle, _| at([0.0; 2], angle, (i + 1.0) / 10.0));
        for [x, y] in &mut island.points {
            [*x, *y] = [center[0] * 9.0 + 8.0 * *x, center[1] + *y];
        }
        island
    }));
};

/// Edges with a common end, and one edge through everything.
pub(super) const STARS: &[Family] = families! {
    "fan from one point": |n| fan(n, &[[0.0, -1.0]]);
    "fan from two points": |n| fan(n, &[[0.0, -1.0], [1.0, 1.0]]);
    "fan from far to the side": |n| fan(n, &[[-3.0, 0.5]]);
    "fan from one point through a hatch": |n| {
        let mut input = fan(n / 2, &[[0.0, -1.0]]);
        // Segments above the row, each as long as the row.
        let first = input.points.len();
        let width = input.points.len() as f64;
        let other = hatch(n / 2, |i, m| [[i / m * width, 1.0 + i], [i / m * width + width, 2.0 + i + m]]);
        input.edges.extend(other.edges.iter().map(|edge| edge.map(|v| v + first)));
        input.points.extend(other.points);
        input
    };
    "edge between two rows, one far point": |n| {
        let m = n / 2;
        let height = |i: usize| i as f64 * 1e-3 / m as f64;
        let mut input = Input { points: Vec::new(), edges: vec![[m - 1, 2 * m - 1]] };
        input.points.extend((0..m).map(|i| [height(i), 10.0 + height(i)]));
        input.points.extend((0..m).map(|i| [height(i), -height(i)]));
        input.points.push([5.0, 5.0]);
        input
    };
    "edge through slanted teeth": |n| {
        let mut input = path(points(n, |i, n| [i + odd(i) * n, odd(i) * n]));
        input.edges.clear();
        let n = n as f64;
        input.edges.push([input.points.len(), input.points.len() + 1]);
        input.points.extend([[-1.0, n / 2.0 + 0.25], [3.0 * n, n / 2.0 + 0.5]]);
        input
    };
    "edge through a cloud": |n| {
        let mut input = Input { points: Random::new(5).points(n), edges: vec![[n, n + 1]] };
        input.points.extend([[-1.0, 0.3], [2.0, 0.6]]);
        input
    };
};

/// A row of points, and edges from each of these centers, given in lengths of the row, to all of them.
fn fan(n: usize, centers: &[[f64; 2]]) -> Input {
    let mut input = points(n, |i, _| [i, 0.0]);
    let length = n as f64;
    for &[x, y] in centers {
        let center = input.points.len();
        input.edges.extend((0..n).map(|v| [center, v]));
        input.points.push([x * length, y * length]);
    }
    input
}
