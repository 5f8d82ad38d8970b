//! A room with 100 obstacles that move: in each frame all of them leave their old places and come to new ones.
//!
//! `cargo run --release -p sweep-cdt-edit --example obstacles [-- PICTURE]` prints what 60 frames cost beside a fresh
//! run, which has the same triangles in every frame, and writes the last one as SVG.

use std::fmt::Write;
use std::time::{Duration, Instant};

use sweep_cdt::interior::FillRule;
use sweep_cdt_edit::{DynamicTriangulation, Edits};

const OBSTACLES: usize = 100;
const CORNERS: usize = 6;
const FRAMES: usize = 60;
/// The obstacles stand in rows of ten, this far apart, and circle about their places.
const APART: f64 = 8.0;
const WIDTH: f64 = 10.0 * APART;

/// The corners of an obstacle in a frame.
fn corners(obstacle: usize, frame: usize) -> Vec<[f64; 2]> {
    let turn = |part: f64| (std::f64::consts::TAU * part).sin_cos();
    let phase = frame as f64 / FRAMES as f64 + obstacle as f64 * 0.618;
    let (sin, cos) = turn(phase);
    let middle = [obstacle % 10, obstacle / 10].map(|i| APART * (i as f64 + 0.5));
    let [x, y] = [middle[0] + 1.5 * cos, middle[1] + 1.5 * sin];
    let corner = |k: usize| {
        let (sin, cos) = turn(k as f64 / CORNERS as f64 + 0.5 * phase);
        [x + 2.0 * cos, y + 2.0 * sin]
    };
    (0..CORNERS).map(corner).collect()
}

/// All obstacles come; `next` is the number of their first point.
fn obstacles(frame: usize, next: usize) -> Edits<f64> {
    let first = |obstacle: usize| next + CORNERS * obstacle;
    let side = |obstacle: usize, k: usize| [k, (k + 1) % CORNERS].map(|k| first(obstacle) + k);
    let of = |obstacle: usize| (0..CORNERS).map(move |k| side(obstacle, k));
    Edits {
        points: (0..OBSTACLES)
            .flat_map(|obstacle| corners(obstacle, frame))
            .collect(),
        edges: (0..OBSTACLES).flat_map(of).collect(),
        ..Edits::default()
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut room = DynamicTriangulation::new();
    // The floor has posts, which stay, and walls around.
    let mut points: Vec<[f64; 2]> = vec![[0.0, 0.0], [WIDTH, 0.0], [WIDTH, WIDTH], [0.0, WIDTH]];
    points
        .extend((1..100).map(|i| [0.618, 0.755].map(|part| WIDTH * (f64::from(i) * part).fract())));
    let edges = vec![[0, 1], [1, 2], [2, 3], [3, 0]];
    let posts = Edits {
        points,
        edges,
        ..Edits::default()
    };
    // Posts that an obstacle passes over are in its inside for a while; nothing is wrong with that.
    let mut last = room.apply(posts)?;
    (last.points, last.edges) = (0..0, 0..0);
    let (mut edited, mut fresh_runs) = (Duration::ZERO, Duration::ZERO);
    let (mut changed, mut free) = (0, 0);
    for frame in 0..FRAMES {
        let start = Instant::now();
        let [next, _] = room.next_numbers();
        let mut edits = obstacles(frame, next);
        (edits.remove_points, edits.remove_edges) = (last.points.collect(), last.edges.collect());
        last = room.apply(edits)?;
        edited += start.elapsed();
        changed += last.new.len();

        let numbers: Vec<usize> = room.points().collect();
        let place = |&p: &usize| *room.point(p).expect("it is there");
        let places: Vec<[f64; 2]> = numbers.iter().map(place).collect();
        let index = |p: usize| numbers.binary_search(&p).expect("it is there");
        let ends: Vec<[usize; 2]> = room.edges().map(|(_, ends)| ends.map(index)).collect();
        let start = Instant::now();
        let fresh = sweep_cdt::triangulate(&places, &ends)?;
        fresh_runs += start.elapsed();
        let triangles = fresh.canonical_triangles().into_iter();
        let triangles: Vec<_> = triangles.map(|t| t.map(|v| numbers[v])).collect();
        assert_eq!(room.canonical_triangles(), triangles, "frame {frame}");
        // Between the walls and the obstacles, whose sides are all of the edges.
        free = fresh.interior(FillRule::EvenOdd)?.inside().len();
    }
    let a_frame = |time: Duration| time.as_secs_f64() * 1e6 / FRAMES as f64;
    println!(
        "{FRAMES} frames of {OBSTACLES} obstacles, each equal to a fresh run: {:.0} us a frame by edits ({} of {} triangles \
         new), {:.0} us by fresh runs; at the end {free} are free",
        a_frame(edited),
        changed / FRAMES,
        room.len(),
        a_frame(fresh_runs)
    );
    if let Some(path) = std::env::args().nth(1) {
        std::fs::write(path, picture(&room)?)?;
    }
    Ok(())
}

fn picture(room: &DynamicTriangulation<f64>) -> Result<String, std::fmt::Error> {
    let mut svg = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='-1 -1 {0} {0}' width='800' fill='none' stroke='#999' \
         stroke-width='0.1'>\n",
        WIDTH + 2.0
    );
    let line = |[a, b]: [usize; 2]| {
        let [[ax, ay], [bx, by]] = [a, b].map(|p| *room.point(p).expect("it is there"));
        format!("M{ax:.2} {ay:.2}L{bx:.2} {by:.2}")
    };
    let sides = room
        .triangles()
        .flat_map(|[a, b, c]| [[a, b], [b, c], [c, a]]);
    let thin: String = sides.map(line).collect();
    let thick: String = room.edges().map(|(_, ends)| line(ends)).collect();
    writeln!(
        svg,
        "<path d='{thin}'/>\n<path stroke='#06c' stroke-width='0.3' d='{thick}'/>\n</svg>"
    )?;
    Ok(svg)
}
