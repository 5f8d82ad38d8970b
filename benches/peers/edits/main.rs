//! Edits of `sweep-cdt-edit` beside those of `spade` and CGAL, on the same points, in one run.
//!
//! ```sh
//! cargo bench --manifest-path benches/peers/Cargo.toml --bench edits [-- MOST]
//! ```
//!
//! For 10,000 points and ten times as many up to `MOST` (a million unless named): microseconds an edit, the median of
//! seven rounds, in which the programs take turns. Points are even, new ones are at random places or near the last one.
//! `spade` searches from the vertex used last, or with its hierarchy, CGAL (where it can be compiled) from the triangle
//! used last. Batches are for `spade` single insertions. After each round all have as many triangles.

#[path = "../src/cgal.rs"]
mod cgal;

use std::hint::black_box;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

use spade::{
    ConstrainedDelaunayTriangulation, DelaunayTriangulation, HierarchyHintGenerator, Point2,
    Triangulation as _,
};
use sweep_cdt_edit::{DynamicTriangulation, Edits};
use sweep_cdt_testing::{Input, Random, binary};

const ROUNDS: usize = 7;
const EDITS: usize = 2_000;

type Ours = DynamicTriangulation<f64>;
type Spade = ConstrainedDelaunayTriangulation<Point2<f64>>;
type Hierarchy = DelaunayTriangulation<Point2<f64>, (), (), (), HierarchyHintGenerator<f64>>;

/// Microseconds for each edit, of the four programs.
type Row = [Option<f64>; 4];

fn main() {
    let argument = std::env::args().skip(1).find(|text| !text.starts_with('-'));
    let most = argument.map_or(1_000_000, |text| text.parse().expect("a number of points"));
    let folder = tempfile::tempdir().expect("a folder");
    let cgal = cgal::compile(folder.path());
    println!(
        "{:9} {:28} {:>9} {:>9} {:>9} {:>9} {:>7}",
        "points", "us an edit", "sweep-cdt", "spade", "hierarchy", "CGAL", "ratio"
    );
    for n in (4..)
        .map(|digits| 10_usize.pow(digits))
        .take_while(|&n| n <= most)
    {
        let rounds: Vec<Vec<(String, Row)>> = (0..ROUNDS)
            .map(|round| measured(n, round, cgal.as_deref()))
            .collect();
        for (i, (name, _)) in rounds[0].iter().enumerate() {
            let median = |program: usize| {
                let times = rounds.iter().map(|rows| rows[i].1[program]);
                let mut times: Vec<f64> = times.collect::<Option<_>>()?;
                times.sort_by(f64::total_cmp);
                Some(times[ROUNDS / 2])
            };
            let [ours, others @ ..] = [0, 1, 2, 3].map(median);
            let cell =
                |time: Option<f64>| time.map_or(String::from("-"), |time| format!("{time:.2}"));
            let best = others.into_iter().flatten().min_by(f64::total_cmp);
            let best = best.expect("another program");
            let ratio = ours.expect("a time") / best;
            println!(
                "{n:9} {name:28} {:>9} {:>9} {:>9} {:>9} {ratio:7.2}",
                cell(ours),
                cell(others[0]),
                cell(others[1]),
                cell(others[2])
            );
        }
    }
}

fn timed<T>(edits: usize, work: impl FnOnce() -> T) -> (Option<f64>, T) {
    let start = Instant::now();
    let made = black_box(work());
    (
        Some(start.elapsed().as_secs_f64() * 1e6 / edits as f64),
        made,
    )
}

fn even(random: &mut Random) -> [f64; 2] {
    [0, 1].map(|_| random.below(1 << 40) as f64 / (1_u64 << 40) as f64)
}

fn place([x, y]: [f64; 2]) -> Point2<f64> {
    Point2::new(x, y)
}

/// The triangulations that each kind of edit begins with.
struct Start {
    ours: Ours,
    spade: Spade,
    hierarchy: Hierarchy,
    points: Vec<[f64; 2]>,
}

/// One round of all kinds of edits.
fn measured(n: usize, round: usize, cgal: Option<&Path>) -> Vec<(String, Row)> {
    let mut random = Random::new((n + round) as u64);
    let points: Vec<[f64; 2]> = (0..n).map(|_| even(&mut random)).collect();
    let mut ours = Ours::new();
    let batch = Edits {
        points: points.clone(),
        ..Edits::default()
    };
    ours.apply(batch).expect("points");
    let places: Vec<Point2<f64>> = points.iter().copied().map(place).collect();
    let start = Start {
        ours,
        spade: Spade::bulk_load(places.clone()).expect("points"),
        hierarchy: Hierarchy::bulk_load(places).expect("points"),
        points,
    };
    let mut rows = Vec::new();
    let places: Vec<[f64; 2]> = (0..EDITS).map(|_| even(&mut random)).collect();
    rows.extend(single(&start, &places, "at random places", round));
    let step = 1.0 / (n as f64).sqrt();
    let mut at = [0.5, 0.5];
    let mut walk = || {
        let mut moved = |x: f64| x + step * (random.below(2001) as f64 / 1000.0 - 1.0);
        at = at.map(|x| moved(x).clamp(0.01, 0.99));
        at
    };
    let near: Vec<[f64; 2]> = (0..EDITS).map(|_| walk()).collect();
    rows.extend(single(&start, &near, "near the last one", round));
    let (row, ends) = edges(&start, &mut random);
    rows.push(row);
    let batches = [100, 10].map(|parts| {
        let count = start.points.len() / parts;
        (0..count)
            .map(|_| even(&mut random))
            .collect::<Vec<[f64; 2]>>()
    });
    let names = ["a batch of 1/100", "a batch of 1/10"];
    let timed = batches.iter().zip(names);
    rows.extend(timed.map(|(points, name)| batch_of(&start, points, name)));
    if let Some(program) = cgal {
        let alone = |points: Vec<[f64; 2]>| Input {
            points,
            edges: Vec::new(),
        };
        let edges = Input {
            points: Vec::new(),
            edges: ends,
        };
        let [one, ten] = batches;
        let counts = [EDITS, EDITS, EDITS, EDITS, EDITS, one.len(), ten.len()];
        let inputs = [start.points.clone(), places, near].map(alone);
        let inputs = [&inputs[..], &[edges], &[one, ten].map(alone)].concat();
        for ((_, row), (time, edits)) in rows
            .iter_mut()
            .zip(timed_cgal(program, &inputs).zip(counts))
        {
            row[3] = Some(time / edits as f64);
        }
    }
    rows
}

/// Microseconds of all edits of each kind by CGAL.
fn timed_cgal(program: &Path, inputs: &[Input]) -> impl Iterator<Item = f64> {
    let path = program.with_extension("input");
    binary::write_inputs(&path, inputs).expect("a file for the inputs");
    let output = Command::new(program).arg(path).arg("edits").output();
    let output = output.expect("CGAL runs");
    assert!(output.status.success(), "{output:?}");
    // A line with nanoseconds and bytes, and one with the number of triangles.
    let text = String::from_utf8(output.stdout).expect("text");
    let numbers = text.lines().step_by(2).map(|line| {
        let nanoseconds = line.split_whitespace().next().expect("a number");
        nanoseconds.parse::<f64>().expect("a number") / 1e3
    });
    numbers.collect::<Vec<f64>>().into_iter()
}

fn insert_theirs(into: &mut impl spade::Triangulation<Vertex = Point2<f64>>, new: &[[f64; 2]]) {
    for &point in new {
        into.insert(place(point)).expect("a point");
    }
}

/// Points come one by one, and go again, the last one first.
fn single(start: &Start, new: &[[f64; 2]], name: &str, round: usize) -> [(String, Row); 2] {
    let [mut a, mut b, mut c] = [None; 3];
    let (mut edited, mut other, mut layered) = (
        start.ours.clone(),
        start.spade.clone(),
        start.hierarchy.clone(),
    );
    let mut numbers: Vec<usize> = Vec::new();
    for turn in 0..3 {
        match (turn + round) % 3 {
            0 => {
                let insert = |&point: &[f64; 2]| edited.insert(point).expect("a point");
                (a, numbers) = timed(EDITS, || new.iter().map(insert).collect());
            }
            1 => (b, ()) = timed(EDITS, || insert_theirs(&mut other, new)),
            _ => (c, ()) = timed(EDITS, || insert_theirs(&mut layered, new)),
        }
    }
    assert_eq!(edited.len(), other.num_inner_faces());
    assert_eq!(edited.len(), layered.num_inner_faces());
    let vertex = |&point: &[f64; 2]| other.locate_vertex(place(point)).expect("a vertex").fix();
    let vertices: Vec<_> = new.iter().map(vertex).collect();
    let (gone, ()) = timed(EDITS, || {
        for &point in numbers.iter().rev() {
            edited.remove(point).expect("a point");
        }
    });
    let (gone_theirs, ()) = timed(EDITS, || {
        for &v in vertices.iter().rev() {
            other.remove(v);
        }
    });
    assert_eq!(edited.len(), other.num_inner_faces());
    [
        (format!("insert {name}"), [a, b, c, None]),
        (format!("remove {name}"), [gone, gone_theirs, None, None]),
    ]
}

/// Edges between a vertex and a neighbour of its neighbour, but for those that would cross others; and their ends.
fn edges(start: &Start, random: &mut Random) -> ((String, Row), Vec<[usize; 2]>) {
    let mut edited = start.ours.clone();
    let mut ends = Vec::new();
    while ends.len() < EDITS {
        let v = random.below(start.points.len());
        let around = edited.neighbors(edited.neighbors(v)[0]);
        let w = random.pick(&around);
        if v != w && edited.insert_edge([v, w]).is_ok() {
            ends.push([v, w]);
        }
    }
    let (mut edited, mut other) = (start.ours.clone(), start.spade.clone());
    let vertex = |point: usize| {
        let vertex = other.locate_vertex(place(start.points[point]));
        vertex.expect("a vertex").fix()
    };
    let vertices: Vec<_> = ends.iter().map(|ends| ends.map(vertex)).collect();
    let (ours, ()) = timed(EDITS, || {
        for &ends in &ends {
            edited.insert_edge(ends).expect("an edge");
        }
    });
    let (spade, ()) = timed(EDITS, || {
        for &[v, w] in &vertices {
            other.add_constraint(v, w);
        }
    });
    assert_eq!(edited.constrained_sides().len(), other.num_constraints());
    let row = [ours, spade, None, None];
    ((String::from("insert edges"), row), ends)
}

fn batch_of(start: &Start, points: &[[f64; 2]], name: &str) -> (String, Row) {
    let count = points.len();
    let (mut edited, mut other, mut layered) = (
        start.ours.clone(),
        start.spade.clone(),
        start.hierarchy.clone(),
    );
    let batch = Edits {
        points: points.to_vec(),
        ..Edits::default()
    };
    let (ours, _) = timed(count, || edited.apply(batch).expect("points"));
    let (spade, ()) = timed(count, || insert_theirs(&mut other, points));
    let (hierarchy, ()) = timed(count, || insert_theirs(&mut layered, points));
    assert_eq!(edited.len(), other.num_inner_faces());
    (name.to_owned(), [ours, spade, hierarchy, None])
}
