//! Holes and regions by seeds, against geometry in whole numbers.

use sweep_cdt::interior::{InteriorError, Seed};
use sweep_cdt::triangulate;
use sweep_cdt_testing::Random;

use super::oracle::{Point, Rings, faces, holds, is_on_edge, rings};

/// Rings with room between the points, some of their edges left out, and the points that no edge ends at.
fn dangling(random: &mut Random) -> Rings {
    let Rings { points, mut edges } = rings(random);
    for _ in 0..random.below(3).min(edges.len()) {
        edges.swap_remove(random.below(edges.len()));
    }
    let points = points.iter().map(|p| p.map(|x| 4 * x)).collect();
    Rings { points, edges }
}

/// What is wrong with a seed, if anything.
fn fault(rings: &Rings, triangles: &[[usize; 3]], seed: Seed, p: Point) -> Option<InteriorError> {
    let Rings { points, edges } = rings;
    let around: Vec<&[usize; 3]> = triangles.iter().filter(|t| holds(points, **t, p)).collect();
    if around.is_empty() {
        return Some(InteriorError::SeedOutside { seed });
    }
    if let Some(&vertex) = around.iter().copied().flatten().find(|&&v| points[v] == p) {
        return Some(InteriorError::SeedOnVertex { seed, vertex });
    }
    // Of an edge it says which part.
    is_on_edge(points, edges, p).then_some(InteriorError::SeedOnEdge { seed, ends: [0, 0] })
}

#[test]
fn every_triangle_is_where_seeds_say() {
    let (mut right, mut wrong, mut carved, mut labelled) = (0, 0, 0, 0);
    for seed in 0..1500 {
        let mut random = Random::new(seed);
        let rings = dangling(&mut random);
        let Rings { points, edges } = &rings;
        let what = || format!("seed {seed}: {points:?} {edges:?}");
        let result = triangulate(points, edges).expect("edges cross at vertices only");
        let triangles: Vec<[usize; 3]> = result.triangles().collect();
        let faces = faces(points, edges, &triangles);
        let face = |p: Point| {
            let t = triangles.iter().position(|&t| holds(points, t, p));
            faces[t.expect("it is in the hull")]
        };
        // Mostly seeds that are right, as far as they go.
        let mut seeds = |name: fn(usize) -> Seed| -> Vec<Point> {
            let is_strict = !random.one_in(4);
            let is_right = |&p: &Point| {
                let is_right = fault(&rings, &triangles, name(0), p).is_none();
                is_right && (name(0) == Seed::Hole(0) || !face(p).1)
            };
            let mut coordinate = || random.below(38) as i64 - 1;
            let points = (0..6).map(|_| [coordinate(), coordinate()]);
            let points = points.filter(|p| !is_strict || is_right(p));
            points.take(3).collect()
        };
        let (holes, regions) = (seeds(Seed::Hole), seeds(Seed::Region));
        let found = result
            .with_points(points)
            .interior_of_seeds(&holes, &regions);

        let names = (0..holes.len()).map(Seed::Hole);
        let names = names.chain((0..regions.len()).map(Seed::Region));
        let all: Vec<(Seed, Point)> = names.zip(holes.iter().chain(&regions).copied()).collect();
        let mut closed = Vec::new();
        let mut expected = Ok(());
        for &(name, p) in &all {
            if let Some(fault) = fault(&rings, &triangles, name, p) {
                expected = Err(fault);
                break;
            }
            match name {
                Seed::Hole(_) => closed.push(face(p).0),
                Seed::Region(region) => {
                    let (face, is_open) = face(p);
                    if is_open || closed.contains(&face) {
                        expected = Err(InteriorError::RegionOutside { region });
                        break;
                    }
                }
            }
        }
        let domain = match (found, expected) {
            (Ok(domain), Ok(())) => domain,
            (Err(InteriorError::SeedOnEdge { seed, ends }), Err(expected)) => {
                assert_eq!(
                    InteriorError::SeedOnEdge { seed, ends: [0, 0] },
                    expected,
                    "{}",
                    what()
                );
                let p = all
                    .iter()
                    .find(|(name, _)| *name == seed)
                    .expect("it is there")
                    .1;
                assert!(is_on_edge(points, &[ends], p));
                wrong += 1;
                continue;
            }
            (found, expected) => {
                assert_eq!(found.err(), expected.err(), "{}", what());
                wrong += 1;
                continue;
            }
        };
        right += 1;
        for (t, &(one, is_open)) in faces.iter().enumerate() {
            let is_inside = !is_open && !closed.contains(&one);
            assert_eq!(domain.is_inside(t), is_inside, "{t}, {}", what());
            assert_eq!(domain.depth(t), i32::from(is_inside));
            let region = (0..regions.len())
                .rev()
                .find(|&i| face(regions[i]).0 == one);
            assert_eq!(domain.region(t), region, "{t}, {}", what());
            carved += usize::from(!is_inside && !is_open);
            labelled += usize::from(region.is_some());
        }
    }
    println!("{right} right, {wrong} wrong, {carved} carved, {labelled} labelled");
    assert!(right > 300 && wrong > 300 && carved > 500 && labelled > 500);
}

/// Gaps of the edges open nothing where the hull is kept: all faces without the seed of a hole stay.
#[test]
fn a_hull_without_holes_has_all_other_faces() {
    let (mut open, mut carved) = (0, 0);
    for seed in 0..500 {
        let mut random = Random::new(seed);
        let Rings { points, edges } = dangling(&mut random);
        let result = triangulate(&points, &edges).expect("edges cross at vertices only");
        let triangles: Vec<[usize; 3]> = result.triangles().collect();
        let faces = faces(&points, &edges, &triangles);
        let mut holes: Vec<Point> = Vec::new();
        for _ in 0..4 {
            let p = [0; 2].map(|_| random.below(36) as i64);
            let is_seed = |t: &&[usize; 3]| holds(&points, **t, p);
            let is_on = is_on_edge(&points, &edges, p) || points.contains(&p);
            if !is_on && triangles.iter().any(|t| is_seed(&t)) {
                holes.push(p);
            }
        }
        let hole_faces: Vec<usize> = (holes.iter())
            .map(|&p| triangles.iter().position(|&t| holds(&points, t, p)))
            .map(|t| faces[t.expect("it is in the hull")].0)
            .collect();
        let located = result.with_points(&points);
        let interior = located
            .hull_without_holes(&holes, &[])
            .expect("right seeds");
        for (t, (face, is_open)) in faces.iter().enumerate() {
            let is_hole = hole_faces.contains(face);
            assert_eq!(interior.is_inside(t), !is_hole, "seed {seed}, {t}");
            open += usize::from(*is_open && !is_hole);
            carved += usize::from(is_hole);
        }
    }
    assert!(open > 500 && carved > 500, "{open}, {carved}");
}

#[test]
fn what_is_wrong_with_a_seed_is_said() {
    let points = [[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]];
    let edges = [[0, 1], [1, 2], [2, 3], [3, 0], [1, 3]];
    let result = triangulate(&points, &edges).unwrap();
    let message = |holes: &[[f64; 2]], regions: &[[f64; 2]]| {
        let error = result
            .with_points(&points)
            .interior_of_seeds(holes, regions)
            .unwrap_err();
        error.to_string()
    };
    for ([hole, region], expected) in [
        (
            [[4.0, 4.0], [1.0, 1.0]],
            "the seed of hole 0 lies on the edge between vertices 1 and 3",
        ),
        (
            [[8.0, 8.0], [1.0, 1.0]],
            "the seed of hole 0 lies on vertex 2",
        ),
        (
            [[1.0, 1.0], [9.0, 8.0]],
            "the seed of region 0 lies outside of the hull",
        ),
        (
            [[1.0, 1.0], [2.0, 2.0]],
            "the seed of region 0 lies in a hole, or outside of the outline",
        ),
        (
            [[1.0, 1.0], [2.0, f64::NAN]],
            "the seed of region 0 has a coordinate that is not finite",
        ),
    ] {
        assert_eq!(message(&[hole], &[region]), expected);
    }
}

#[test]
#[should_panic(expected = "these are not the points of the triangulation")]
fn points_of_another_triangulation_are_refused() {
    let points = [[0, 0], [4, 0], [4, 4], [0, 4], [4, 4]];
    let result = triangulate(&points, &[]).unwrap();
    assert!(result.with_points(&points).verify(&[]).is_ok());
    result.with_points(&points[..4]);
}

#[test]
fn a_seed_is_located_by_exact_signs() {
    // The seed lies off the edge by less than a rounded sign can tell.
    let near = f64::EPSILON;
    let points = [[0.0, 0.0], [12.0, 0.0], [12.0, 12.0], [0.0, 12.0]];
    let edges = [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]];
    let result = triangulate(&points, &edges).unwrap();
    for (seed, corner) in [([1.0, 1.0 + near], 3), ([1.0, 1.0 - near / 2.0], 1)] {
        let domain = result
            .with_points(&points)
            .interior_of_seeds(&[seed], &[])
            .unwrap();
        let kept: Vec<usize> = domain.inside().flat_map(|t| result.triangle(t)).collect();
        assert!(!kept.contains(&corner), "{seed:?}");
        assert_eq!(kept.len(), 3);
    }
}
