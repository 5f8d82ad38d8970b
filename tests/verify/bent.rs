//! Vertices that were added on edges, and rounded: each input edge by its chain, with its distance as depth.

use num_rational::BigRational;
use num_traits::{Signed, Zero};
use sweep_cdt::triangulate;
use sweep_cdt::verify::{Verifier, Violation, Violations};
use sweep_cdt_testing::oracle::arrangement::fractions;
use sweep_cdt_testing::oracle::refined::{height, is_near};

use super::*;

/// A mesh of an input whose edges were split, with the chain of each edge.
struct Mesh {
    /// The first `own` are the input's.
    points: Vec<[f64; 2]>,
    own: usize,
    edges: Vec<[usize; 2]>,
    chains: Vec<Vec<usize>>,
    /// The closed chains that bound it, of the input's points; none where that is the hull.
    declared: Vec<Vec<usize>>,
}

impl Mesh {
    /// Splits all edges at so many places, rounded.
    fn of(points: Vec<[f64; 2]>, edges: &[[usize; 2]], parts: usize) -> Mesh {
        let own = points.len();
        let mut mesh = Mesh {
            points,
            own,
            edges: edges.to_vec(),
            chains: Vec::new(),
            declared: Vec::new(),
        };
        for &[a, b] in edges {
            let mut chain = vec![a];
            for i in 1..parts {
                let share = i as f64 / parts as f64;
                let [p, q] = [mesh.points[a], mesh.points[b]];
                chain.push(mesh.points.len());
                let at = |i: usize| p[i] + share * (q[i] - p[i]);
                mesh.points.push([at(0), at(1)]);
            }
            chain.push(b);
            mesh.chains.push(chain);
        }
        mesh
    }

    /// The triangles with the chains for edges: those in the declared domain, or else those inside of the edges.
    fn triangles(&self) -> Vec<[usize; 3]> {
        let pairs = |chain: &Vec<usize>| chain.windows(2).map(|w| [w[0], w[1]]).collect::<Vec<_>>();
        let parts: Vec<[usize; 2]> = self.chains.iter().flat_map(pairs).collect();
        let result = triangulate(&self.points, &parts).unwrap();
        let with = result.with_points(&self.points);
        let interior = with.interior_of_seeds(&[], &[]).unwrap();
        interior.inside().map(|t| result.triangle(t)).collect()
    }

    fn verify(&self, triangles: &[[usize; 3]]) -> Result<Report, Violations> {
        Verifier::new()
            .added_from(self.own)
            .boundary(&self.declared)
            .all_depths(true)
            .verify(&self.points, &self.edges, triangles)
    }

    /// The greatest distance of a vertex from the edge that it splits, in units of the length of the edge.
    fn depth(&self) -> BigRational {
        let exact = fractions(&self.points);
        let of_chain = |chain: &Vec<usize>| {
            let [a, b] = [chain[0], chain[chain.len() - 1]];
            let of_one = |&v: &usize| height([&exact[a], &exact[v], &exact[b]]).abs();
            let inner = chain[1..chain.len() - 1].iter().map(of_one);
            inner.max().unwrap_or_else(BigRational::zero)
        };
        self.chains.iter().map(of_chain).max().unwrap()
    }
}

/// A star of `n` corners, with an edge inside from the first one to the middle.
fn star(random: &mut Random, n: usize) -> (Vec<[f64; 2]>, Vec<[usize; 2]>) {
    let mut points: Vec<[f64; 2]> = (0..n)
        .map(|i| {
            let angle = std::f64::consts::TAU * i as f64 / n as f64;
            let radius = 1.0 + random.below(1000) as f64 / 300.0;
            [0.1 + radius * angle.cos(), 0.7 + radius * angle.sin()]
        })
        .collect();
    points.push([0.1, 0.7]);
    let mut edges: Vec<[usize; 2]> = (0..n).map(|i| [i, (i + 1) % n]).collect();
    edges.push([n, 0]);
    (points, edges)
}

#[test]
fn rounded_vertices_on_edges_are_right_but_for_their_distance() {
    let mut random = Random::new(52);
    let mut bent = 0;
    for round in 0..150 {
        let n = 4 + round % 9;
        let (points, edges) = star(&mut random, n);
        let mut mesh = Mesh::of(points, &edges, 2 + round % 5);
        mesh.declared = vec![(0..n).collect()];
        let triangles = mesh.triangles();
        let depth = mesh.depth();
        match mesh.verify(&triangles) {
            Ok(report) => {
                assert!(depth.is_zero(), "{depth}");
                assert_eq!(report.split_edges, edges.len());
            }
            Err(violations) => {
                let names = violations.list.iter().map(Violation::name);
                assert!(
                    names.clone().all(|name| name.starts_with("bent-")),
                    "{violations:?}"
                );
                let found = violations.depth().expect("all have depths").get();
                assert!(is_near(found, &depth) && found < 1e-15, "{found:e} {depth}");
                assert_eq!(violations.report.split_edges, edges.len());
                bent += 1;
            }
        }
        // The triangles run clockwise, or one is missing, or doubled.
        let mut others = triangles.clone();
        others.remove(round % others.len());
        let less = mesh.verify(&others).unwrap_err().depth();
        assert!(less.is_none_or(|depth| depth.get() > 1e-6), "{less:?}");
        let mut others = triangles.clone();
        others.push(triangles[round % triangles.len()]);
        assert_eq!(mesh.verify(&others).unwrap_err().depth(), None);
    }
    assert!(bent > 100, "{bent}");
}

#[test]
fn a_vertex_far_from_its_edge_is_as_deep_as_it_is_far() {
    let mut random = Random::new(53);
    for round in 0..100 {
        let (points, edges) = star(&mut random, 8);
        let mut mesh = Mesh::of(points, &edges, 4);
        mesh.declared = vec![(0..8).collect()];
        let v = mesh.own + round % (mesh.points.len() - mesh.own);
        mesh.points[v][round % 2] += if round % 3 == 0 { 1e-3 } else { -1e-3 };
        let triangles = mesh.triangles();
        let violations = mesh.verify(&triangles).unwrap_err();
        if let Some(found) = violations.depth() {
            assert!(is_near(found.get(), &mesh.depth()), "{violations:?}");
        }
    }
}

#[test]
fn of_the_hull_too() {
    let corners = [[0.1, 0.2], [0.7, 0.1], [1.3, 0.9], [0.4, 1.7]];
    let edges = [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]];
    let mut deep = 0;
    for parts in 2..9 {
        let mesh = Mesh::of(corners.to_vec(), &edges, parts);
        let triangles = mesh.triangles();
        let verifier = Verifier::new().added_from(mesh.own);
        let verdict = verifier.verify(&mesh.points, &mesh.edges, &triangles);
        let depth = mesh.depth();
        match verdict {
            Ok(_) => assert!(depth.is_zero()),
            Err(violations) => {
                let found = violations.depth().expect("all have depths");
                assert!(is_near(found.get(), &depth), "{violations:?}");
                deep += 1;
            }
        }
    }
    assert!(deep > 4, "{deep}");
}

/// A square with an edge along the middle, split at a vertex beside it.
fn square_with(others: &[[f64; 2]], own: usize) -> (Vec<[f64; 2]>, usize) {
    let mut points = vec![
        [0.0, 0.0],
        [8.0, 0.0],
        [8.0, 8.0],
        [0.0, 8.0],
        [1.0, 4.0],
        [7.0, 4.0],
    ];
    points.extend(others);
    (points, 6 + own)
}

fn judge_edge(
    (points, own): &(Vec<[f64; 2]>, usize),
    parts: &[[usize; 2]],
    edges: &[[usize; 2]],
) -> Result<Report, Violations> {
    let result = triangulate(points, parts).unwrap();
    let triangles: Vec<[usize; 3]> = result.triangles().collect();
    let verifier = Verifier::new().added_from(*own);
    verifier.verify(points, edges, &triangles)
}

#[test]
fn a_chain_goes_round_no_vertex_of_the_input() {
    let depth = 2.0_f64.powi(-50);
    // Vertex 6 of the input is just above the edge 4-5, or on it; the chain passes above it, or below.
    for (height, above, is_right) in [
        (depth, 2.0 * depth, false),
        (0.0, depth, false),
        (-depth, depth, true),
        (2.0 * depth, depth, true),
    ] {
        let case = square_with(&[[4.0, 4.0 + height], [4.25, 4.0 + above]], 1);
        let verdict = judge_edge(&case, &[[4, 7], [7, 5]], &[[4, 5]]).unwrap_err();
        let is_shallow = verdict.depth().is_some_and(|depth| depth.get() < 1e-12);
        assert_eq!(is_shallow, is_right, "{height} {above} {verdict:?}");
    }
    // A chain through a vertex of the input.
    let case = square_with(&[[4.0, 4.0 + depth]], 1);
    let verdict = judge_edge(&case, &[[4, 6], [6, 5]], &[[4, 5]]).unwrap_err();
    assert_eq!(verdict.list[0].name(), "missing-edge");
}

#[test]
fn a_chain_goes_forward() {
    let depth = 2.0_f64.powi(-50);
    // From 6 the chain goes back to 7, and on to 8.
    let case = square_with(
        &[
            [4.0, 4.0 + depth],
            [3.0, 4.0 + 2.0 * depth],
            [5.0, 4.0 + 3.0 * depth],
        ],
        0,
    );
    let parts = [[4, 6], [6, 7], [7, 8], [8, 5]];
    let violations = judge_edge(&case, &parts, &[[4, 5]]);
    // The nearest chain need not be the one that was made; but none goes back.
    let list = violations.map_or_else(|violations| violations.list, |_| Vec::new());
    let is_sound = |v: &Violation| v.name() != "bent-edge" || v.depth().is_some();
    assert!(list.iter().all(is_sound), "{list:?}");
    assert!(!list.is_empty());
}

#[test]
fn two_edges_share_a_vertex_beside_them_only_where_they_cross() {
    let depth = 2.0_f64.powi(-50);
    // Edges 4-5 and 6-7 are as near as that; both chains pass vertex 8.
    let near = [
        [1.0, 4.0 + 4.0 * depth],
        [7.0, 4.0 + 4.0 * depth],
        [4.0, 4.0 + depth],
    ];
    let case = square_with(&near, 2);
    let parts = [[4, 8], [8, 5], [6, 8], [8, 7]];
    let verdict = judge_edge(&case, &parts, &[[4, 5], [6, 7]]).unwrap_err();
    assert_eq!(verdict.depth(), None, "{verdict:?}");
    assert_eq!(verdict.list[0].name(), "missing-edge");
    // Edges that cross at a vertex beside both.
    let across = [[3.0, 1.0], [5.0, 7.0], [4.0 + depth, 4.0 + depth]];
    let case = square_with(&across, 2);
    let verdict = judge_edge(&case, &parts, &[[4, 5], [6, 7]]).unwrap_err();
    let depth = verdict.depth().expect("both are bent").get();
    assert!(verdict.found == 2 && depth < 1e-14, "{verdict:?}");
}

#[test]
fn one_turned_triangle_is_one_violation() {
    let case = random();
    let clockwise: Vec<[usize; 3]> = case.triangles.iter().map(|&[a, b, c]| [b, a, c]).collect();
    let verifier = Verifier::new().accept_clockwise(true);
    for triangles in [&case.triangles, &clockwise] {
        for turned in [0, 1, triangles.len() - 1] {
            let mut triangles = triangles.clone();
            triangles[turned].swap(0, 1);
            let violations = verifier.verify(&case.points, &[], &triangles).unwrap_err();
            let is_reversed = |v: &&Violation| v.name() == "reversed-triangle";
            let reversed: Vec<_> = violations.list.iter().filter(is_reversed).collect();
            assert_eq!(
                reversed,
                [&Violation::ReversedTriangle { triangle: turned }]
            );
        }
    }
}
