//! Roles of rings: random polygons with holes, in every format that has polygons, against a count of unit squares.
//!
//! All rings run along the lines of a lattice, so that what a ring goes round is known square by square: a ray from the
//! middle of the square crosses its sides an odd number of times. No code of the crate takes part in the count.

use std::fmt::Write;

use sweep_cdt_formats::{Format, GraphFile, Input, Source, read};
use sweep_cdt_testing::Random;

/// The side of the lattice.
const SIDE: i64 = 7;

/// All numbers of lines of the lattice.
const LINES: [i64; 8] = [0, 1, 2, 3, 4, 5, 6, SIDE];

/// A closed chain of corners; the first one is not repeated.
type Corners = Vec<[i64; 2]>;

/// A polygon: its outline, and its holes.
type Polygon = Vec<Corners>;

/// A rectangle, or a walk along the lattice that comes back to where it began and may cross itself.
fn ring(random: &mut Random) -> Corners {
    let mut coordinate = || random.pick(&LINES);
    let mut corners = match random_kind(coordinate()) {
        true => {
            let [x, y, u, v] = [coordinate(), coordinate(), coordinate(), coordinate()];
            vec![[x, y], [u, y], [u, v], [x, v]]
        }
        false => {
            let first = [coordinate(), coordinate()];
            let mut corners = vec![first];
            for _ in 0..3 {
                let [x, _] = corners[corners.len() - 1];
                let to = [coordinate(), coordinate()];
                corners.extend([[x, to[1]], to]);
            }
            let [x, _] = corners[corners.len() - 1];
            corners.push([x, first[1]]);
            corners
        }
    };
    if random.one_in(2) {
        corners.reverse();
    }
    corners
}

fn random_kind(number: i64) -> bool {
    number % 2 == 0
}

/// Polygons that overlap, and repeat rings of others.
fn polygons(random: &mut Random) -> Vec<Polygon> {
    let mut polygons: Vec<Polygon> = Vec::new();
    for _ in 0..1 + random.below(3) {
        let mut polygon = Vec::new();
        for _ in 0..1 + random.below(3) {
            let again = polygons
                .last()
                .filter(|_| random.one_in(5))
                .map(|other| other[0].clone());
            polygon.push(again.unwrap_or_else(|| ring(random)));
        }
        polygons.push(polygon);
    }
    polygons
}

/// Whether a ring goes round the square above and to the right of a point: a ray to the right.
fn goes_round(ring: &Corners, [x, y]: [i64; 2]) -> bool {
    let sides = (0..ring.len()).map(|at| [ring[at], ring[(at + 1) % ring.len()]]);
    let is_crossed = |[[ax, ay], [bx, by]]: &[[i64; 2]; 2]| {
        ax == bx && *ax > x && *ay.min(by) <= y && y < *ay.max(by)
    };
    sides.filter(is_crossed).count() % 2 == 1
}

/// How many unit squares the polygons cover together.
fn covered(polygons: &[Polygon]) -> u32 {
    let covers = |polygon: &Polygon, square| {
        let holes = &mut polygon[1..].iter();
        goes_round(&polygon[0], square) && !holes.any(|hole| goes_round(hole, square))
    };
    let squares = (0..SIDE * SIDE).map(|at| [at % SIDE, at / SIDE]);
    squares
        .filter(|&square| polygons.iter().any(|polygon| covers(polygon, square)))
        .map(|_| 1)
        .sum()
}

/// Twice the area inside, by the rule of polygons, after crossings are split exactly: a whole number, as text.
fn twice_the_area(file: &GraphFile<f64>) -> String {
    let (file, _) = file.split_crossings().expect("crossings on the lattice");
    let (points, edges) = (&file.graph.points, &file.graph.edges);
    let result = sweep_cdt::triangulate(points, edges).expect("no edges cross");
    let interior = file.polygons.interior(&result).expect("closed rings");
    // Whole numbers of this size are exact.
    let twice = |triangle: [usize; 3]| {
        let [a, b, c] = triangle.map(|v| points[v]);
        assert!(
            triangle
                .iter()
                .all(|&v| points[v].iter().all(|x| x.fract() == 0.0))
        );
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    };
    // From 0.0 on, for the sum of nothing is -0.0.
    let sum = interior
        .triangles()
        .map(twice)
        .fold(0.0, |sum, area| sum + area);
    sum.to_string()
}

fn doubles(format: Format, text: &str) -> GraphFile<f64> {
    match read(format, &Source::new("map", text), None) {
        Ok(Input::Doubles(file)) => file,
        other => panic!("{text}: {other:?}"),
    }
}

/// Lists of lists of positions, with these marks around and in a position.
fn lists(
    polygon: &Polygon,
    [begin, end]: [&str; 2],
    [before, between, after]: [&str; 3],
) -> String {
    let ring = |corners: &Corners| {
        let closed = corners.iter().chain(corners.first());
        let positions = closed.map(|[x, y]| format!("{before}{x}{between}{y}{after}"));
        let positions: Vec<String> = positions.collect();
        format!("{begin}{}{end}", positions.join(","))
    };
    let rings: Vec<String> = polygon.iter().map(ring).collect();
    format!("{begin}{}{end}", rings.join(","))
}

#[test]
fn polygons_cover_what_their_rings_say() {
    let (mut empty, mut full) = (0, 0);
    for seed in 0..600 {
        let mut random = Random::new(seed);
        let polygons = polygons(&mut random);
        let expected = covered(&polygons);
        empty += usize::from(expected == 0);
        full += usize::from(expected > 10);
        let json: Vec<String> = polygons
            .iter()
            .map(|p| lists(p, ["[", "]"], ["[", ",", "]"]))
            .collect();
        let wkt: Vec<String> = polygons
            .iter()
            .map(|p| lists(p, ["(", ")"], ["", " ", ""]))
            .collect();
        let line = r#"{"type": "LineString", "coordinates": [[0, 0], [7, 7]]}"#;
        let feature = |polygon: &String| {
            format!(
                r#"{{"type": "Feature", "properties": null, "geometry": {{"type": "Polygon", "coordinates": {polygon}}}}}"#
            )
        };
        let features: Vec<String> = json.iter().map(feature).collect();
        let texts = [
            (
                Format::Geojson,
                format!(
                    r#"{{"type": "GeometryCollection", "geometries": [{line}, {{"type": "MultiPolygon", "coordinates": [{}]}}]}}"#,
                    json.join(",")
                ),
            ),
            (
                Format::Geojson,
                format!(
                    r#"{{"type": "FeatureCollection", "features": [{}]}}"#,
                    features.join(",")
                ),
            ),
            (
                Format::Wkt,
                format!("LINESTRING (0 7, 7 0) MULTIPOLYGON ({})", wkt.join(",")),
            ),
            (
                Format::Wkt,
                wkt.iter()
                    .map(|polygon| format!("POLYGON {polygon}\n"))
                    .collect(),
            ),
        ];
        for (format, text) in texts {
            let file = doubles(format, &text);
            assert_eq!(file.polygons.features.len(), polygons.len());
            assert_eq!(
                twice_the_area(&file),
                (2 * expected).to_string(),
                "seed {seed}: {text}"
            );
        }
    }
    assert!(empty > 10 && full > 200, "{empty} {full}");
}

/// The polygons of a file that is written and read again are the same.
#[test]
fn polygons_that_are_written_cover_the_same() {
    for seed in 0..200 {
        let mut random = Random::new(seed);
        let polygons = polygons(&mut random);
        let wkt: Vec<String> = polygons
            .iter()
            .map(|p| lists(p, ["(", ")"], ["", " ", ""]))
            .collect();
        let file = doubles(
            Format::Wkt,
            &format!("LINESTRING (0 7, 7 0) MULTIPOLYGON ({})", wkt.join(",")),
        );
        for format in [Format::Wkt, Format::Geojson] {
            let mut text = Vec::new();
            sweep_cdt_formats::write_graph(format, &file, &mut text).expect("memory takes it");
            let again = doubles(format, std::str::from_utf8(&text).expect("text"));
            assert_eq!(
                twice_the_area(&again),
                (2 * covered(&polygons)).to_string(),
                "seed {seed}"
            );
        }
    }
}

/// Faces of meshes are polygons without holes.
#[test]
fn faces_cover_what_they_go_round() {
    for seed in 0..200 {
        let mut random = Random::new(seed);
        let faces: Vec<Corners> = (0..1 + random.below(3))
            .map(|_| ring(&mut random))
            .collect();
        let polygons: Vec<Polygon> = faces.iter().map(|face| vec![face.clone()]).collect();
        let corners: Vec<[i64; 2]> = faces.concat();
        let (mut obj, mut off) = (
            String::new(),
            format!("OFF\n{} {} 0\n", corners.len(), faces.len()),
        );
        for [x, y] in &corners {
            writeln!(obj, "v {x} {y} 0").expect("strings grow");
            writeln!(off, "{x} {y} 0").expect("strings grow");
        }
        let mut first = 0;
        for face in &faces {
            let numbers = |from: usize| {
                let numbers = (0..face.len()).map(|at| (first + at + from).to_string());
                numbers.collect::<Vec<_>>().join(" ")
            };
            writeln!(obj, "f {}", numbers(1)).expect("strings grow");
            writeln!(off, "{} {}", face.len(), numbers(0)).expect("strings grow");
            first += face.len();
        }
        for (format, text) in [(Format::Obj, obj), (Format::Off, off)] {
            let file = doubles(format, &text);
            assert_eq!(file.faces.len(), faces.len());
            let file = file.with_faces().expect("all corners are vertices");
            assert_eq!(
                twice_the_area(&file),
                (2 * covered(&polygons)).to_string(),
                "seed {seed}: {text}"
            );
        }
    }
}
