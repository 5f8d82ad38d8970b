//! The picture of the documentation's first page shows what the crate makes.

use std::fmt::Write;
use std::fs;

use sweep_cdt::triangulate;
use sweep_cdt_testing::data::path;

const POINTS: [[i32; 2]; 15] = [
    [0, 0],
    [60, -6],
    [110, 10],
    [120, 60],
    [80, 84],
    [20, 80],
    [-10, 40],
    [30, 30],
    [50, 55],
    [70, 25],
    [90, 45],
    [15, 20],
    [45, 12],
    [60, 70],
    [100, 70],
];
const EDGES: [[usize; 2]; 2] = [[11, 10], [6, 13]];

/// All triangles, the edges, and the points with their numbers.
fn picture() -> String {
    let result = triangulate(&POINTS, &EDGES).expect("edges that do not cross");
    let place = |v: usize| format!("{} {}", POINTS[v][0], -POINTS[v][1]);
    let triangles = result.canonical_triangles();
    let triangles = triangles.into_iter().map(|t| t.map(place).join("L"));
    let triangles: String = triangles.map(|t| format!("M{t}Z")).collect();
    let edges: String = EDGES
        .map(|edge| edge.map(place).join("L"))
        .map(|e| format!("M{e}"))
        .concat();
    let points: String = (0..POINTS.len())
        .map(|v| format!("M{}h0", place(v)))
        .collect();
    let mut svg = String::new();
    let mut line = |text: String| writeln!(svg, "{text}").expect("a text");
    line(r#"<svg width="420" viewBox="-16 -92 146 104" role="img" aria-label="A constrained Delaunay triangulation">"#.into());
    line(format!(
        r##"<path fill="#F6F5F1" stroke="#848E98" stroke-linejoin="round" d="{triangles}"/>"##
    ));
    line(format!(
        r##"<path stroke="#0072B2" stroke-width="2.2" stroke-linecap="round" d="{edges}"/>"##
    ));
    line(format!(
        r##"<path stroke="#1B1F23" stroke-width="4" stroke-linecap="round" d="{points}"/>"##
    ));
    line(r##"<g font-size="7" font-family="sans-serif" fill="#1B1F23" stroke="#F6F5F1" stroke-width="1.6" paint-order="stroke">"##.into());
    for (v, [x, y]) in POINTS.into_iter().enumerate() {
        line(format!(r#"<text x="{}" y="{}">{v}</text>"#, x + 3, -y - 2));
    }
    line("</g>".into());
    line("</svg>".into());
    svg
}

#[test]
fn the_first_page_shows_a_triangulation() {
    let page = fs::read_to_string(path("src/crate.md")).expect("a readable file");
    let picture = picture();
    assert!(
        page.contains(&picture),
        "src/crate.md needs this picture:\n{picture}"
    );
}
