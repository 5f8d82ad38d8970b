//! The certificates that `sweep-cdt stream` writes: they say what those of `sweep-cdt triangulate` say, and name few points at
//! a time.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use sweep_cdt_testing::{Input, Random};
use tempfile::TempDir;

use crate::stream::{ran, write_both};
use crate::{folder, printed};

/// What a certificate says, by the coordinates of points as it writes them.
#[derive(Debug, Default, PartialEq)]
struct Said {
    head: Vec<String>,
    points: BTreeSet<String>,
    /// Each edge with the points that it passes, in that direction which comes first, and how often it is there.
    edges: BTreeMap<Vec<String>, usize>,
    lower: BTreeSet<Vec<String>>,
    /// Three corners, and the marks.
    triangles: BTreeMap<Vec<String>, String>,
}

/// Reads a certificate, and returns how many points may be named at most, too.
fn read(folder: &TempDir, name: &str) -> (Said, usize) {
    let text = fs::read_to_string(folder.path().join(name)).expect("a certificate");
    let mut lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.pop(), Some("end"));
    let records = lines.split_off(3);
    let head = lines.into_iter().map(str::to_owned).collect();
    let mut said = Said {
        head,
        ..Said::default()
    };
    let (mut places, mut given, mut most) = (BTreeMap::new(), 0, 0);
    for line in records {
        let (kind, rest) = line.split_once(' ').unwrap_or((line, ""));
        let words: Vec<&str> = rest.split(' ').filter(|word| !word.is_empty()).collect();
        let place = |word: &&str| {
            let number: usize = word.parse().expect("a number");
            places
                .get(&number)
                .cloned()
                .expect("a point that may be named")
        };
        match kind {
            "p" => {
                places.insert(given, rest.to_owned());
                said.points.insert(rest.to_owned());
                given += 1;
                most = most.max(places.len());
            }
            "e" => {
                let mut chain: Vec<String> = words.iter().map(place).collect();
                if chain.first() != chain.last() {
                    let back = chain.iter().rev().cloned().collect();
                    chain = chain.min(back);
                    *said.edges.entry(chain).or_default() += 1;
                }
            }
            "l" => assert!(said.lower.insert(words.iter().map(place).collect())),
            "t" => {
                let corners = words[..3].iter().map(place).collect();
                let marks = words[3].to_owned();
                assert_eq!(
                    said.triangles.insert(corners, marks),
                    None,
                    "a triangle is there twice"
                );
            }
            "f" => {
                for word in words {
                    let number = word.parse().expect("a number");
                    assert!(
                        places.remove(&number).is_some(),
                        "{number} is forgotten twice"
                    );
                }
            }
            _ => panic!("no record: {line}"),
        }
    }
    (said, most)
}

/// Compares the certificate of a stream with that of all in memory. Returns how many points may be named at most.
fn compared(input: &Input, window: usize) -> usize {
    let folder = folder(&[]);
    write_both(&folder, input);
    // Where there are no triangles, a note says so.
    let memory = ran(&folder, "triangulate p.json --inside hull -o memory.cert");
    assert_eq!(memory.status.code(), Some(0));
    let stream = format!("stream p.f64 --edges e.u64 --window {window} -o stream.cert");
    printed(&ran(&folder, &stream));
    let (stream, most) = read(&folder, "stream.cert");
    let (memory, _) = read(&folder, "memory.cert");
    assert_eq!(stream, memory, "{:?}, window {window}", input.points);
    most
}

#[test]
fn they_say_what_those_in_memory_say() {
    let cases = [
        ("", ""),
        ("3 4", ""),
        ("0 0, 2 2, 1 1, 0.5 0.5", "0 1, 2 3"),
        (
            "0 0, 9 1, 2 0, 4 8, 2 0, 7 7, 0 0, 1 5, 5 3, -3 2",
            "0 3, 3 5, 6 1, 2 4",
        ),
        // Edges that lie over each other: the same, longer ones, and one that begins in another.
        (
            "0 0, 1 1, 2 2, 3 3, 4 4, 0 3, 3 0, 5 1, 1 5, 6 6",
            "0 2, 2 0, 1 3, 0 4, 3 4, 4 9",
        ),
        // Upright sides at both ends.
        ("0 0, 0 1, 0 2, 3 0, 3 1, 3 2, 1 1", "0 2, 3 5"),
    ];
    for (points, edges) in cases {
        for window in [1, 2, 100] {
            compared(&Input::parse(points, edges), window);
        }
    }
}

/// A lattice whose rows and columns are edges from point to point, but for one of each, which are one edge.
fn grid(size: usize) -> Input {
    let at = |x: usize, y: usize| y * size + x;
    let numbers = (0..size).flat_map(|y| (0..size).map(move |x| [x, y]));
    #[expect(clippy::cast_precision_loss, reason = "small numbers")]
    let points = numbers
        .map(|place| place.map(|number| number as f64))
        .collect();
    let mut edges = Vec::new();
    for line in 0..size {
        if line == size / 2 {
            edges.extend([
                [at(0, line), at(size - 1, line)],
                [at(line, 0), at(line, size - 1)],
            ]);
        }
        for next in 1..size {
            edges.push([at(next - 1, line), at(next, line)]);
            edges.push([at(line, next - 1), at(line, next)]);
        }
    }
    Input { points, edges }
}

#[test]
fn they_forget_points_and_edges() {
    let most = compared(&grid(40), 40);
    assert!(most < 400, "{most} of 1,600 points may be named");
    let mut random = Random::new(1);
    let points = (0..3000).map(|_| [random.unit(), random.unit()]).collect();
    let most = compared(
        &Input {
            points,
            edges: Vec::new(),
        },
        100,
    );
    assert!(most < 800, "{most} of 3,000 points may be named");
}
