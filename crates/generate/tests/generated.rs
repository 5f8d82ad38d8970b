//! The generated data: valid, as large as asked for, the same bytes everywhere. What is written reads as the same.

use num_rational::BigRational;
use sweep_cdt::{Pslg, Region, triangulate};
use sweep_cdt_formats::{Format, GraphFile, Input, Numbering, Source, read, write_graph};
use sweep_cdt_generate::{KINDS, Kind};

fn kind(name: &str) -> Kind {
    Kind::named(name).expect("a kind")
}

#[test]
fn every_kind_can_be_triangulated_at_every_size() {
    for kind in KINDS {
        for n in (0..=20).chain([100, 1000, 20_000]) {
            let Pslg { points, edges, .. } = kind.graph(n, 3);
            let name = kind.name;
            assert_eq!(points.is_empty(), n == 0, "{name} {n}");
            if n >= 1000 {
                let ratio = points.len() as f64 / n as f64;
                assert!((0.75..1.3).contains(&ratio), "{name}: {}", points.len());
            }
            if let Err(error) = triangulate(&points, &edges) {
                panic!("{name} {n}: {error}");
            }
        }
    }
}

/// A hash of all bits (Fowler, Noll and Vo).
fn hash(Pslg { points, edges, .. }: &Pslg<f64>) -> u64 {
    let coordinates = points.iter().flatten().map(|x| x.to_bits());
    let ends = edges.iter().flatten().map(|&end| end as u64);
    let step = |hash: u64, bits: u64| (hash ^ bits).wrapping_mul(0x0100_0000_01b3).rotate_left(29);
    coordinates.chain(ends).fold(0xcbf2_9ce4_8422_2325, step)
}

/// Each kind with the hash of its bits.
const HASHES: [&str; KINDS.len()] = [
    "uniform 2ebbd2208cd31d48",
    "integers f3386cf0d2b32a65",
    "clusters 53dc9a38f8edd594",
    "power-law 0ef26f7c1e352d59",
    "lattice 18cf5dbd3cd40703",
    "lattice-in-order 5f9d1ffc3f515f2b",
    "rows 0465f45ee23bf22e",
    "columns 237fe95e81e98fda",
    "circle 47bcd2dcfd9884d8",
    "parabola-up 6bb495326272ed30",
    "parabola-right c59cbc2662028e2e",
    "comb b45769134bcad7e5",
    "fans 4945065e7809b6d6",
    "asterisk 37f41222b06bf082",
    "segments 3f72a80b52a58fe1",
    "outlines cd85d4c6955d6c1f",
    "parcels 50d7f6517baa1b06",
    "contours 3d0d3b1f24c8b5d1",
    "alternating e0ecccc039edbc74",
    "above-a-row 7fcc90cbf4cc9f83",
    "outliers 48638d78fb6b99c8",
    "towers 7b3a98a206e38b19",
    "leftwards 2a80293574b88b7d",
];

#[test]
fn the_bits_are_the_same_on_every_platform() {
    let found: Vec<String> = KINDS
        .iter()
        .map(|kind| format!("{} {:016x}", kind.name, hash(&kind.graph(2000, 1))))
        .collect();
    assert_eq!(found, HASHES);
}

#[test]
fn another_seed_gives_another_input() {
    for name in ["uniform", "parcels", "contours", "outlines", "segments"] {
        let [one, two] = [1, 2].map(|seed| hash(&kind(name).graph(1000, seed)));
        assert_ne!(one, two, "{name}");
    }
}

/// The paper's set a has 23,262 points and 28,155 edges, its set c 162,244 and 162,312.
#[test]
fn parcels_and_contours_have_the_papers_ratio_of_edges_to_points() {
    let ratio = |name| {
        let graph = kind(name).graph(100_000, 1);
        graph.edges.len() as f64 / graph.points.len() as f64
    };
    assert!((ratio("parcels") - 28_155.0 / 23_262.0).abs() < 1e-3);
    assert!((ratio("contours") - 162_312.0 / 162_244.0).abs() < 0.02);
}

/// The graph that is read from a written one.
fn again(format: Format, file: &GraphFile<f64>) -> Input {
    let mut bytes = Vec::new();
    write_graph(format, file, &mut bytes).expect("memory takes all that is written");
    let name = "written".to_owned();
    read(format, &Source::new(name, bytes), None).expect("what is written can be read")
}

#[test]
fn a_written_graph_reads_as_the_same_one() {
    let file = GraphFile::from(kind("parcels").graph(500, 4));
    for format in [Format::Poly, Format::Json] {
        assert_eq!(again(format, &file), Input::Doubles(file.clone()));
    }
    let vertices = Pslg {
        points: file.graph.points.clone(),
        ..Pslg::default()
    };
    assert_eq!(again(Format::Node, &file), Input::Doubles(vertices.into()));
}

/// With seeds, all things numbered from 1, and the lowest and highest doubles.
#[test]
fn a_written_poly_holds_seeds_and_the_numbers_of_all_things() {
    let region = |x, attribute| Region {
        seed: [x, 0.1],
        attribute,
    };
    let graph = Pslg {
        points: vec![[f64::MIN, -0.5], [5e-324, 1e300], [f64::MAX, 0.1]],
        edges: vec![[2, 0], [0, 1]],
        holes: vec![[0.25, 7.0]],
        regions: vec![region(1.0, -3.5), region(2.0, 0.0)],
    };
    let file = GraphFile {
        numbering: Numbering::FROM_ONE,
        ..graph.into()
    };
    assert_eq!(again(Format::Poly, &file), Input::Doubles(file));
}

#[test]
fn a_written_poly_holds_fractions() {
    let third = |by: i32| BigRational::new(by.into(), 3.into());
    let points = vec![[third(1), third(-2)], [third(6), third(5)]];
    let graph = Pslg {
        points,
        edges: vec![[0, 1]],
        ..Pslg::default()
    };
    let file = graph.into();
    for (format, expected) in [
        (
            Format::Poly,
            "2 2 0 0\n0 1/3 -2/3\n1 2 5/3\n1 0\n0 0 1\n0\n",
        ),
        (
            Format::Json,
            "{\n\"points\": [\n[\"1/3\",\"-2/3\"],\n[2,\"5/3\"]],\n\"edges\": [\n[0,1]]\n}\n",
        ),
    ] {
        let mut text = Vec::new();
        write_graph(format, &file, &mut text).expect("memory takes all that is written");
        assert_eq!(String::from_utf8(text).expect("text"), expected);
    }
}
