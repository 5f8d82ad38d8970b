//! No bytes make the readers or the verifier panic.

use std::fs;
use std::path::Path;

use sweep_cdt::draw::ViolationsPicture;
use sweep_cdt::formats::{Graph, Input, InputFormat, ResultFormat, Source, read, read_result};
use sweep_cdt::verify::Verifier;
use sweep_cdt_testing::Random;

use crate::FORMATS;

/// Results of `ten.poly`, to be damaged.
const SEEDS: [(ResultFormat, &str); 4] = [
    (ResultFormat::Ele, "3 3 0\n1 1 2 8\n2 2 3 8\n3 3 4 9\n"),
    (
        ResultFormat::Json,
        r#"{"triangles": [[0,1,7],[1,2,7],[2,3,8]]}"#,
    ),
    (ResultFormat::Json, r#"{"triangles": [0,1,7,1,2,7,2,3,8]}"#),
    (
        ResultFormat::Obj,
        "v 0 0 0\nv 6 0 0\nv 7.5 3.5 0\nf 1 2 3\nf 3/1 -1 2//4\n",
    ),
];

#[test]
fn damaged_results_are_errors_or_violations() {
    let Input::Doubles(graph) = load("ten.poly") else {
        unreachable!("no fractions in it")
    };
    let mut random = Random::new(7);
    for _ in 0..5000 {
        for (format, seed) in SEEDS {
            let bytes = damaged(seed.as_bytes(), &mut random);
            let node = damaged(&bytes_of("split.node"), &mut random);
            let node = (random.below(3) == 0).then(|| source(node));
            try_all(format, &source(bytes), node.as_ref(), &graph);
        }
    }
}

fn try_all(format: ResultFormat, source: &Source, node: Option<&Source>, graph: &Graph<f64>) {
    let Ok(triangles) = read_result(format, source, node, graph) else {
        return;
    };
    let verdict = Verifier::new().verify(&graph.points, &graph.edges, &triangles.list);
    let Err(violations) = verdict else { return };
    for &violation in &violations.list {
        triangles.as_numbered(graph, violation).to_string();
        triangles.vertices_of(graph, violation);
    }
    let mut picture = Vec::new();
    ViolationsPicture::new(graph, &triangles, &violations.list)
        .found(violations.found)
        .write(&mut picture)
        .expect("memory takes all that is written");
    assert!(!String::from_utf8(picture).expect("text").contains("NaN"));
}

fn bytes_of(name: &str) -> Vec<u8> {
    fs::read(Path::new(FORMATS).join(name)).expect("a file")
}

fn source(bytes: Vec<u8>) -> Source {
    Source {
        name: "damaged".to_owned(),
        bytes,
    }
}

fn load(name: &str) -> Input {
    read(InputFormat::Poly, &source(bytes_of(name)), None).expect("a good file")
}

/// The same bytes with a few replaced, removed, repeated or put in.
fn damaged(bytes: &[u8], random: &mut Random) -> Vec<u8> {
    const TOKENS: [&str; 12] = [
        "0",
        "-1",
        "99999999999999999999",
        "18446744073709551615",
        "1e999",
        "nan",
        " ",
        "\n",
        "[",
        "]",
        "\u{fffd}",
        "f 1 2 3\n",
    ];
    let mut bytes = bytes.to_vec();
    for _ in 0..=random.below(4) {
        let at = random.below(bytes.len() + 1);
        let end = (at + random.below(4)).min(bytes.len());
        let token = match random.below(4) {
            0 => String::new(),
            1 => char::from(u8::try_from(random.below(128)).expect("small")).to_string(),
            _ => TOKENS[random.below(TOKENS.len())].to_owned(),
        };
        bytes.splice(at..end, token.into_bytes());
    }
    bytes
}
