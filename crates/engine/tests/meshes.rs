//! Refined files and Voronoi cells, beside what fractions say of them.

use std::cmp::Ordering;

use num_rational::BigRational;
use sweep_cdt::crossings::Exact;
use sweep_cdt::interior::{FillRule, Interior};
use sweep_cdt::{Pslg, Region, triangulate};
use sweep_cdt_edit::{Bounds, Broken, Refinement, Voronoi};
use sweep_cdt_engine::{
    Clip, Inside, RefinedFile, bounds_or_default, cells, region_areas, size, violators,
};
use sweep_cdt_formats::{Cell, Column, GraphFile, Numbering, Remark};
use sweep_cdt_generate::Random;

type Place = [BigRational; 2];

fn whole(x: i64) -> BigRational {
    BigRational::from_integer(x.into())
}

fn squared_distance(p: &Place, q: &Place) -> BigRational {
    let [x, y] = [0, 1].map(|i| &p[i] - &q[i]);
    &x * &x + &y * &y
}

/// Twice the signed area.
fn area(ring: &[Place]) -> BigRational {
    let sides = (0..ring.len()).map(|i| (&ring[i], &ring[(i + 1) % ring.len()]));
    sides.map(|(p, q)| &p[0] * &q[1] - &p[1] * &q[0]).sum()
}

/// Points on small lattices, with equal ones among them; every fourth time all on one line.
fn points(case: usize, random: &mut Random) -> Vec<[i64; 2]> {
    let size = [5, 9, 1 << 20, 7][case % 4];
    let count = 1 + random.below(14);
    let mut coordinate = || i64::try_from(random.below(size)).expect("small");
    let points = (0..count).map(|_| [coordinate(), coordinate()]);
    let is_line = case % 4 == 3;
    points
        .map(|[x, y]| if is_line { [2 * x, 3 * x] } else { [x, y] })
        .collect()
}

fn corners<S>(cells: &[Cell<S>]) -> impl Iterator<Item = (usize, &[S; 2])> {
    cells.iter().flat_map(|cell| {
        let places = cell.polygons.iter().flatten().flatten();
        places.map(|place| (cell.point, place))
    })
}

#[test]
fn cells_are_nearest_to_their_points_and_tile_what_they_are_cut_to() {
    let mut random = Random::new(29);
    // An L with a square hole.
    let l = [
        [-9, -9],
        [9, -9],
        [9, 1],
        [1, 1],
        [1, 9],
        [-9, 9],
        [-6, -6],
        [-3, -6],
        [-3, -3],
        [-6, -3],
    ];
    let ring = |from: usize, to: usize| {
        (from..to).map(move |v| [v, if v + 1 == to { from } else { v + 1 }])
    };
    let edges: Vec<[usize; 2]> = ring(0, 6).chain(ring(6, 10)).collect();
    let l: Vec<Place> = l.iter().map(|point| point.map(whole)).collect();
    let of_l = triangulate(&l, &edges).expect("an L");
    let inside = of_l.interior(FillRule::EvenOdd).expect("closed rings");
    for case in 0..120 {
        let given = points(case, &mut random);
        let exact: Vec<Place> = given.iter().map(|point| point.map(whole)).collect();
        let result = triangulate(&exact, &[]).expect("points");
        let voronoi = Voronoi::new(&result, &exact).expect("no edges");
        let hull: Vec<Place> = result.hull().map(|v| exact[v].clone()).collect();
        let around = Clip::around(&exact).expect("points");
        let Clip::Box([low, high]) = &around else {
            panic!("it is a box")
        };
        let of_box = whole(2) * (&high[0] - &low[0]) * (&high[1] - &low[1]);
        let narrow = [[whole(1), whole(1)], [whole(3), whole(4)]];
        for (clip, expected) in [
            (around, of_box),
            (Clip::Box(narrow), whole(12)),
            (Clip::Convex(hull.clone()), area(&hull)),
            (Clip::Inside(&inside, &l), whole(2 * (18 * 18 - 8 * 8 - 9))),
        ] {
            let (found, shared) = cells(&voronoi, &result, &clip).expect("finite corners");
            for (point, place) in corners(&found) {
                let own = squared_distance(place, &exact[point]);
                assert!(
                    exact
                        .iter()
                        .all(|other| own <= squared_distance(place, other)),
                    "{given:?}"
                );
            }
            let rings = found.iter().flat_map(|cell| cell.polygons.iter().flatten());
            assert_eq!(
                rings.map(|ring| area(ring)).sum::<BigRational>(),
                expected,
                "{given:?}"
            );
            for polygon in found.iter().flat_map(|cell| &cell.polygons) {
                let signs = polygon.iter().map(|ring| area(ring).cmp(&whole(0)));
                let is_right = |(at, sign)| (at == 0) == (sign == Ordering::Greater);
                assert!(signs.enumerate().all(is_right), "{given:?}");
            }
            let copies = result.duplicates().len();
            assert_eq!(
                shared,
                (copies > 0).then_some(Remark::SharedCells { points: copies })
            );
        }
    }
}

/// Cells of doubles that need not be cut are those that fractions cut.
#[test]
fn corners_of_doubles_are_rounded_once() {
    let mut random = Random::new(31);
    for case in 0..60 {
        let given = points(case, &mut random);
        let exact: Vec<Place> = given.iter().map(|point| point.map(whole)).collect();
        let doubles: Vec<[f64; 2]> = given.iter().map(|point| point.map(|x| x as f64)).collect();
        let result = triangulate(&doubles, &[]).expect("points");
        let of_doubles = Voronoi::new(&result, &doubles).expect("no edges");
        let of_fractions = Voronoi::new(&result, &exact).expect("no edges");
        let narrow = [[0.0, 0.0], [5.0, 4.5]];
        let exactly = narrow.map(|corner| corner.map(|x: f64| x.to_fraction()));
        let (found, _) = cells(&of_doubles, &result, &Clip::Box(narrow)).expect("a box");
        let (expected, _) = cells(&of_fractions, &result, &Clip::Box(exactly)).expect("a box");
        let expected = corners(&expected).map(|(v, place)| (v, place.each_ref().map(f64::nearest)));
        let sorted = |list: Vec<(usize, [f64; 2])>| {
            let mut bits: Vec<_> = list
                .into_iter()
                .map(|(v, p)| (v, p.map(f64::to_bits)))
                .collect();
            bits.sort_unstable();
            bits
        };
        let found = corners(&found).map(|(v, place)| (v, *place)).collect();
        assert_eq!(sorted(found), sorted(expected.collect()), "{given:?}");
    }
}

/// A square with a hole, an edge across, one without a length, one that is there twice, and one equal vertex.
fn frame() -> GraphFile<BigRational> {
    let square = |low: i64, high: i64| [[low, low], [high, low], [high, high], [low, high]];
    let mut points = [square(0, 9), square(3, 6)].concat();
    points.push([0, 0]);
    let ring = |v: usize| [[v, v + 1], [v + 1, v + 2], [v + 2, v + 3], [v + 3, v]];
    let edges = [&ring(0)[..], &ring(4), &[[0, 4], [0, 8], [4, 8]]].concat();
    let heights = points.iter().map(|[x, y]| (2 * x - 3 * y) as f64).collect();
    let points = points.iter().map(|point| point.map(whole)).collect();
    let seed = |x: i64| [whole(x), whole(5)];
    let graph = Pslg {
        points,
        edges,
        holes: vec![seed(4)],
        regions: vec![Region {
            seed: seed(1),
            attribute: 7.0,
        }],
    };
    let marker = Column {
        name: Column::MARKER.to_owned(),
        values: vec![5.0; 9],
    };
    GraphFile {
        columns: vec![Column::heights(heights), marker],
        edge_markers: (1..=11).collect(),
        region_areas: vec![0.75],
        numbering: Numbering::FROM_ONE,
        ..graph.into()
    }
}

#[test]
fn parts_and_new_vertices_have_what_the_file_says() {
    let file = frame();
    let graph = &file.graph;
    let result = triangulate(&graph.points, &graph.edges).expect("a frame");
    let inside = Inside::Holes
        .interior(&(&file).into(), &result)
        .expect("seeds");
    let asked = |given: &[(usize, f64)]| region_areas(&file, Inside::Holes, &inside, given);
    let (areas, none) = asked(&[]).expect("regions");
    assert_eq!((&areas[..], none), (&[0.75][..], None));
    assert_eq!(asked(&[(1, 2.0)]), Ok((vec![2.0], None)));
    let unknown = asked(&[(2, 2.0)]).expect_err("one region");
    assert_eq!(unknown.to_string(), r#"region "2" is not one of 1"#);
    let hull = Interior::whole(&result);
    let unused = Remark::UnusedAreas {
        areas: 1,
        rule: "hull".to_owned(),
    };
    assert_eq!(
        region_areas(&file, Inside::HULL, &hull, &[]),
        Ok((vec![], Some(unused)))
    );
    let bounds = Bounds {
        least_angle: Some(25.0),
        ..Bounds::default()
    };
    let none = Bounds::default();
    assert_eq!(bounds_or_default(none, true), none);
    assert_eq!(bounds_or_default(none, false).least_angle, Some(20.0));
    assert_eq!(bounds_or_default(bounds, false), bounds);
    let how = Refinement::new(bounds).region_areas(&areas);
    let refined = RefinedFile::new(&file, &inside, &how).expect("a mesh");
    let mesh = &refined.file;
    assert!(refined.left.is_empty());
    assert_eq!(mesh.graph.points[..9], graph.points[..]);
    assert!(mesh.graph.points.len() > 60);

    // Each part is a part of its edge, with its marker, and the parts of an edge are one way.
    assert_eq!(mesh.graph.edges.len(), mesh.pieces_of.len());
    for (edge, &[from, to]) in graph.edges.iter().enumerate() {
        let parts = (0..mesh.pieces_of.len()).filter(|&part| mesh.pieces_of[part] == edge);
        let parts: Vec<usize> = parts.collect();
        let place = |v: usize| &mesh.graph.points[v];
        let ends: Vec<[usize; 2]> = parts.iter().map(|&part| mesh.graph.edges[part]).collect();
        assert_eq!(place(ends[0][0]), place(from));
        assert_eq!(place(ends[ends.len() - 1][1]), place(to));
        assert!(ends.windows(2).all(|pair| pair[0][1] == pair[1][0]));
        for (&part, &[_, end]) in parts.iter().zip(&ends) {
            assert_eq!(mesh.edge_markers[part], file.edge_markers[edge]);
            let turn = [from, end, to].map(|v| place(v).clone());
            assert_eq!(area(&turn), whole(0));
        }
    }

    // The mesh is inside what was refined, with its regions, and heights are those of the plane.
    let interior = refined.interior(&inside);
    assert_eq!(interior.canonical_triangles(), refined.triangles);
    assert!(interior.inside().all(|t| interior.region(t) == Some(0)));
    let places = |corners: [usize; 3]| corners.map(|v| mesh.graph.points[v].clone());
    let sum: BigRational = interior
        .triangles()
        .map(|corners| area(&places(corners)))
        .sum();
    assert_eq!(sum, whole(2 * (81 - 9)));
    let bounds = Bounds {
        greatest_area: Some(0.75),
        ..bounds
    };
    assert_eq!(
        violators(&bounds, &mesh.graph.points, &refined.triangles),
        Ok(Vec::new())
    );
    let heights = mesh.heights().expect("heights");
    for (point, height) in mesh.graph.points.iter().zip(&heights.values) {
        let [x, y] = point.each_ref().map(sweep_cdt::scalar::Scalar::approx);
        assert!(
            (height - (2.0 * x - 3.0 * y)).abs() < 1e-9,
            "{x} {y} {height}"
        );
    }
    let new = mesh.graph.points.len() - 9;
    assert_eq!(mesh.columns[1].missing(), new);
    let interpolated = Remark::Interpolated {
        heights: new,
        outside: 0,
    };
    assert_eq!(refined.remarks(), [interpolated]);
}

/// Doubles that no double halves: the mesh is what was refined even so, though its hull is another one.
#[test]
fn a_hull_that_rounding_bends_is_refined() {
    let points = vec![[0.1, 0.2], [7.3, 1.9], [5.7, 6.1], [0.3, 4.9]];
    let heights = Column::heights(points.iter().map(|[x, y]| x - y).collect());
    let graph = Pslg {
        points,
        ..Pslg::default()
    };
    let file = GraphFile {
        columns: vec![heights],
        ..graph.into()
    };
    let result = triangulate(&file.graph.points, &[]).expect("points");
    let whole = Interior::whole(&result);
    let bounds = Bounds {
        least_angle: Some(30.0),
        greatest_area: Some(0.05),
        ..Bounds::default()
    };
    let refined = RefinedFile::new(&file, &whole, &Refinement::new(bounds)).expect("a mesh");
    let interior = refined.interior(&whole);
    assert!(refined.left.is_empty() && refined.file.pieces_of.is_empty());
    assert_eq!(interior.canonical_triangles(), refined.triangles);
    assert!(
        interior.inside().len() < refined.result.len(),
        "no side of the hull is bent"
    );
    assert_eq!(
        violators(&bounds, &refined.file.graph.points, &refined.triangles),
        Ok(Vec::new())
    );
    // New vertices beside the hull have heights, too.
    let heights = refined.file.heights().expect("heights");
    for ([x, y], height) in refined.file.graph.points.iter().zip(&heights.values) {
        assert!((height - (x - y)).abs() < 1e-12, "{x} {y} {height}");
    }
}

/// A right angle of two equal sides, at every scale that doubles have.
#[test]
fn angles_are_said_at_every_scale() {
    for scale in [1e-310, 1e-200, 1.0, 1e200, 1.7e308] {
        let corners = [[-scale, 0.0], [scale, 0.0], [0.0, scale]];
        let angle = size(Broken::Angle, corners.each_ref());
        assert!((angle - 45.0).abs() < 1e-9, "{scale}: {angle}");
    }
    let flat = [[0.0, 0.0], [1.0, 1.0], [1.0, 1.0]];
    assert!(size(Broken::Angle, flat.each_ref()) <= 0.0);
}

/// A box a tenth larger would not be one of doubles: on that side it ends with the points.
#[test]
fn the_box_around_ends_with_the_greatest_doubles() {
    let far = 1.7e308;
    let points = [[far, 0.0], [-far, 1.0], [0.0, far], [5.0, 5.0]];
    let result = triangulate(&points, &[]).expect("points");
    let voronoi = Voronoi::new(&result, &points).expect("no edges");
    let around = Clip::around(&points).expect("points");
    let (found, _) = cells(&voronoi, &result, &around).expect("finite corners");
    assert_eq!(found.len(), 4);
    assert!(
        corners(&found)
            .flat_map(|(_, place)| place)
            .all(|x| x.is_finite())
    );
    let Clip::Box([low, high]) = around else {
        panic!("it is a box")
    };
    // Below there is room for a tenth of 3.4e308, which is no double.
    let bits = |numbers: [f64; 4]| numbers.map(f64::to_bits);
    let ends = [low[0], low[1], high[0], high[1]];
    assert_eq!(bits(ends), bits([-far, -(far / 5.0), far, far]));
}

/// Where corners round to one place, the cell is there all the same: two points in a box around them, first.
#[test]
fn cells_of_doubles_tile_what_they_are_cut_to() {
    let mut random = Random::new(37);
    let mut few = |case| match case {
        0 => vec![[0, 0], [1, 1]],
        _ => points(case, &mut random),
    };
    for given in (0..200).map(&mut few) {
        let doubles: Vec<[f64; 2]> = given.iter().map(|point| point.map(|x| x as f64)).collect();
        let result = triangulate(&doubles, &[]).expect("points");
        let voronoi = Voronoi::new(&result, &doubles).expect("no edges");
        let frame = [[-0.1, -0.1], [0.7, -0.1], [0.7, 0.3], [-0.1, 0.3]];
        let inside = triangulate(&frame, &[[0, 1], [1, 2], [2, 3], [3, 0]]).expect("a frame");
        let inside = inside.interior(FillRule::EvenOdd).expect("a ring");
        for clip in [
            Clip::around(&doubles).expect("points"),
            Clip::Box([frame[0], frame[2]]),
            Clip::Convex(frame.to_vec()),
            Clip::Inside(&inside, &frame),
        ] {
            let [low, high] = match clip {
                Clip::Box(ends) => ends,
                _ => [frame[0], frame[2]],
            };
            let expected = 2.0 * (high[0] - low[0]) * (high[1] - low[1]);
            let (found, _) = cells(&voronoi, &result, &clip).expect("finite corners");
            let mut sum = 0.0;
            for ring in found.iter().flat_map(|cell| cell.polygons.iter().flatten()) {
                let ends = ring.iter().zip(ring.iter().cycle().skip(1));
                assert!(
                    ring.len() > 2
                        && ends
                            .clone()
                            .all(|(p, q)| p.map(f64::to_bits) != q.map(f64::to_bits)),
                    "{given:?}: {ring:?}"
                );
                sum += ends.map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum::<f64>();
            }
            assert!(
                (sum / expected - 1.0).abs() < 1e-12,
                "{given:?}: {sum} for {expected}"
            );
        }
    }
}
