//! Right results, broken in every way, read as files are: the verdict is that of fractions, and nothing is correct for
//! another input than its own.
//!
//! A square frame with a hole, whose corners are moved a little, is filled with triangles that may have vertices of
//! their own. These are broken, or what they are verified against is.

use sweep_cdt::interior::FillRule;
use sweep_cdt::verify::{Report, Verifier};
use sweep_cdt::{Pslg, triangulate};
use sweep_cdt_formats::{Coordinate, GraphFile, Matching, added_points, locate_seeds};
use sweep_cdt_testing::oracle::arrangement::fractions;
use sweep_cdt_testing::oracle::refined::Wanted;

use super::matching::{FORMATS, files};
use super::*;

const RINGS: [[usize; 2]; 8] = [
    [0, 1],
    [1, 2],
    [2, 3],
    [3, 0],
    [4, 5],
    [5, 6],
    [6, 7],
    [7, 4],
];

/// An input, what of it is to be filled, and a result.
struct Made {
    points: Vec<[f64; 2]>,
    edges: Vec<[usize; 2]>,
    chains: Vec<Vec<usize>>,
    /// The vertices of the result: those of the input, then others.
    vertices: Vec<[f64; 2]>,
    triangles: Vec<[usize; 3]>,
    /// What fills the hole.
    hole: Vec<[usize; 3]>,
    /// Points of regions, and the attributes of their triangles.
    seeds: Vec<([f64; 2], f64)>,
    attributes: Vec<f64>,
}

fn made(random: &mut Random, is_hull: bool) -> Made {
    let mut points: Vec<[f64; 2]> = super::domains::POINTS
        .iter()
        .map(|p| p.map(|x| 8.0 * x + 2.0 * random.below(3) as f64))
        .collect();
    let place = |random: &mut Random| [1, 2].map(|_| (6 + random.below(64)) as f64);
    for _ in 0..random.below(3) {
        points.push(place(random));
    }
    let mut vertices = points.clone();
    for _ in 0..random.below(4) {
        // In the middle of an edge, or anywhere.
        let [a, b] = random.pick(&RINGS).map(|v| points[v]);
        vertices.push(if random.one_in(3) {
            place(random)
        } else {
            [0, 1].map(|i| f64::midpoint(a[i], b[i]))
        });
    }
    let rule = if is_hull {
        FillRule::Hull
    } else {
        FillRule::EvenOdd
    };
    let whole = triangulate(&vertices, &RINGS).expect("rings do not cross");
    let inside = whole.interior(rule).expect("rings are closed");
    let (filled, hole) = (0..whole.len()).partition::<Vec<usize>, _>(|&t| inside.is_inside(t));
    let own = triangulate(&points, &RINGS).expect("rings do not cross");
    let chains = own.interior(rule).expect("rings are closed").boundary();
    Made {
        points,
        edges: RINGS.to_vec(),
        chains: if is_hull { Vec::new() } else { chains },
        vertices,
        triangles: filled.into_iter().map(|t| whole.triangle(t)).collect(),
        hole: hole.into_iter().map(|t| whole.triangle(t)).collect(),
        // None is on an edge: their slopes are no match for such a height.
        seeds: (0..random.below(4))
            .map(|_| {
                let [x, y] = place(random);
                ([x + 0.5, y + 1.0 / 1024.0], random.below(3) as f64)
            })
            .collect(),
        attributes: Vec::new(),
    }
}

/// What may be done to a result or to what is asked of it. The first two change nothing that matters.
const KINDS: [&str; 17] = [
    "nothing",
    "vertices in another order",
    "a ring reversed",
    "numbers exchanged",
    "one unit in the last place",
    "mirrored",
    "shifted",
    "scaled",
    "hole filled",
    "hole forgotten",
    "vertex added outside",
    "a triangle dropped",
    "a side flipped",
    "a vertex moved",
    "an edge added",
    "point of the input moved",
    "an attribute changed",
];

fn break_it(made: &mut Made, kind: &str, random: &mut Random) {
    let v = random.below(made.vertices.len());
    let t = random.below(made.triangles.len());
    let axis = random.below(2);
    match kind {
        "nothing" | "an attribute changed" => {}
        "vertices in another order" => {
            made.vertices.reverse();
            let last = made.vertices.len() - 1;
            made.triangles
                .iter_mut()
                .flatten()
                .for_each(|w| *w = last - *w);
        }
        "a ring reversed" => {
            if let Some(chain) = made.chains.last_mut() {
                chain.reverse();
            }
        }
        "numbers exchanged" => made.vertices.swap(v, 0),
        "one unit in the last place" => {
            let x = &mut made.vertices[v][axis];
            *x = if random.one_in(2) {
                x.next_up()
            } else {
                x.next_down()
            };
        }
        "mirrored" => {
            made.vertices
                .iter_mut()
                .for_each(|p| p[axis] = 80.0 - p[axis]);
            made.triangles.iter_mut().for_each(|t| t.swap(0, 1));
        }
        "shifted" => made.vertices.iter_mut().for_each(|p| p[axis] += 2.0),
        "scaled" => made.vertices.iter_mut().flatten().for_each(|x| *x *= 2.0),
        "hole filled" => made.triangles.append(&mut made.hole),
        "hole forgotten" => {
            let count = made.chains.len();
            made.chains
                .truncate((count - usize::from(count > 0)).max(1));
        }
        "vertex added outside" => {
            let [a, b] = [0, 1].map(|i| made.points[i]);
            made.vertices.push([f64::midpoint(a[0], b[0]), -1.0]);
            let added = made.vertices.len() - 1;
            made.triangles.push([1, 0, added]);
        }
        "a triangle dropped" => drop(made.triangles.swap_remove(t)),
        "a side flipped" => {
            let [a, b, c] = made.triangles[t];
            let across = |u: &[usize; 3]| (0..3).find(|&k| [u[k], u[(k + 1) % 3]] == [b, a]);
            if let Some(u) = made.triangles.iter().position(|u| across(u).is_some()) {
                let d = made.triangles[u]
                    .into_iter()
                    .find(|w| ![a, b].contains(w))
                    .unwrap();
                (made.triangles[t], made.triangles[u]) = ([c, a, d], [d, b, c]);
            }
        }
        "a vertex moved" => made.vertices[v][axis] += 1.0 - 2.0 * random.below(2) as f64,
        "an edge added" => made.edges.push([random.below(8), random.below(8)]),
        _ => {
            let v = v.min(made.points.len() - 1);
            made.points[v][axis] += 1.0;
        }
    }
}

/// The verifier's answer to a result in a file, as the command asks it; `None` if the file is refused.
fn judged(made: &Made, random: &mut Random) -> Option<Result<Report, Violations>> {
    let format = random.pick(&FORMATS);
    let (source, node) = files(format, &made.vertices, &made.triangles, |x| x.text());
    let mut file = GraphFile::from(Pslg {
        points: made.points.clone(),
        edges: made.edges.clone(),
        ..Pslg::default()
    });
    let own = file.graph.points.len();
    let added = added_points(format, &source, node.as_ref(), &file).ok()?;
    file.graph.points.extend(added);
    let graph = &file.graph;
    let read = Matching::new()
        .read(format, &source, node.as_ref(), &file)
        .ok()?;
    let verifier = Verifier::new().added_from(own);
    let verifier = if made.chains.is_empty() {
        verifier
    } else {
        verifier.boundary(&made.chains)
    };
    let (places, attributes): (Vec<_>, Vec<_>) = made.seeds.iter().copied().unzip();
    let seeds = locate_seeds(&graph.points, &read.list, &places).into_iter();
    let seeds: Vec<_> = seeds
        .zip(attributes)
        .filter_map(|(t, attribute)| Some((t?, attribute)))
        .collect();
    let verifier = verifier.regions(&made.attributes, &seeds);
    Some(verifier.verify(&graph.points, &graph.edges, &read.list))
}

#[test]
fn the_verdict_is_that_of_fractions() {
    let mut random = Random::new(3);
    let (mut right, mut split) = ([0; KINDS.len()], 0);
    const ROUNDS: usize = 20;
    for round in 0..ROUNDS * KINDS.len() {
        let kind = round % KINDS.len();
        let is_hull = random.one_in(3);
        let mut made = made(&mut random, is_hull);
        break_it(&mut made, KINDS[kind], &mut random);
        let points = fractions(&made.points);
        let vertices = fractions(&made.vertices);
        let triangles: Vec<_> = made
            .triangles
            .iter()
            .map(|t| t.map(|v| vertices[v].clone()))
            .collect();
        let wanted = Wanted {
            points: &points,
            edges: &made.edges,
            chains: &made.chains,
        };
        let seeds = made.seeds.iter();
        let seeds: Vec<_> = seeds
            .map(|&(seed, attribute)| (fractions(&[seed]).remove(0), attribute))
            .collect();
        made.attributes = wanted.attributes(&triangles, &seeds);
        let mut is_labelled = true;
        if KINDS[kind] == "an attribute changed" {
            let t = random.below(made.attributes.len());
            let attribute = &mut made.attributes[t];
            let other = random.below(3) as f64;
            is_labelled = attribute.total_cmp(&other).is_eq();
            *attribute = other;
        }
        let is_right = wanted.is_met_by(&triangles) && is_labelled;
        let verdict = judged(&made, &mut random).expect("vertices may be added");
        let what = (
            KINDS[kind],
            &made.points,
            &made.vertices,
            &made.triangles,
            &made.chains,
        );
        assert_eq!(verdict.is_ok(), is_right, "{verdict:?} of {what:?}");
        right[kind] += usize::from(is_right);
        if let Ok(report) = verdict {
            assert_eq!(
                report.split_edges,
                wanted.split_edges(&triangles),
                "{what:?}"
            );
            let mut corners: Vec<[f64; 2]> = made
                .triangles
                .as_flattened()
                .iter()
                .map(|&v| made.vertices[v])
                .collect();
            corners.sort_by(|p, q| p.partial_cmp(q).unwrap());
            corners.dedup();
            let added = corners.iter().filter(|v| !made.points.contains(v)).count();
            assert_eq!(report.added_points, added, "{what:?}");
            split += report.split_edges;
        }
    }
    assert_eq!(right[..3], [ROUNDS; 3], "{right:?}");
    assert!(right[5..8].iter().all(|&count| count == 0), "{right:?}");
    assert_eq!([right[10], right[11]], [0; 2], "{right:?}");
    assert!(split > 20, "{split}");
    assert!((1..ROUNDS).contains(&right[16]), "{right:?}");
}
